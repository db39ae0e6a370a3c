// SPDX-License-Identifier: GPL-3.0-or-later
// With a real keychain on a message bus of its own: see with_keychain.
#include "camera_login_fixture.h"

namespace spherewalk::ui {

using State = CaptureDesk::State;

using CameraKeychain = CameraLoginFixture;

TEST_F(CameraKeychain, APasswordIsKeptForTheNextProgram) {
    QSignalSpy troubles(&desk().login(), &CameraLogin::trouble);
    desk().connectTo(address());
    LoginForm* asks = waitForForm();
    ASSERT_NE(asks, nullptr);
    answer(*asks, kPassword, true);
    waitFor(State::Ready);
    const auto connects = [&] {
        CaptureDesk next(tasks); // knows nothing but what the keychain knows
        QSignalSpy asked(&next.login(), &CameraLogin::wanted);
        QSignalSpy changes(&next, &CaptureDesk::changed);
        next.connectTo(address());
        while (next.state() != State::Ready && asked.empty() && changes.wait(100'000)) {
        }
        return next.state() == State::Ready;
    };
    // The keychain takes its time, and says nothing when it has it.
    QElapsedTimer time;
    time.start();
    constexpr int kMostMs = 100'000;
    while (!connects() && time.elapsed() < kMostMs) {
    }
    EXPECT_TRUE(connects());
    EXPECT_TRUE(troubles.empty());
}

TEST_F(CameraKeychain, AKeptPasswordThatIsWrongIsAskedForAnew) {
    CameraLogin keeper;
    keeper.give(camera::parseEndpoint(address().toStdString()), {kUser, "of long ago"}, true);
    LoginForm* asks = nullptr;
    QElapsedTimer time;
    time.start();
    constexpr int kMostMs = 100'000;
    do { // until the keychain has it
        desk().connectTo(address());
        asks = waitForForm();
        ASSERT_NE(asks, nullptr);
        if (asks->findChild<QLabel*>("loginWords")->text().contains("did not accept")) {
            break;
        }
        asks->reject();
        waitFor(State::NoCamera);
    } while (time.elapsed() < kMostMs);
    answer(*asks, kPassword, false);
    waitFor(State::Ready);
}

} // namespace spherewalk::ui
