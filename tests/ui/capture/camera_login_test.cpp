// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera_login_fixture.h"

namespace spherewalk::ui {

using State = CaptureDesk::State;

using CameraLoginTest = CameraLoginFixture;

TEST_F(CameraLoginTest, APersonIsAskedAndTheSurveyIsCaptured) {
    desk().connectTo(address());
    LoginForm* asked = waitForForm();
    ASSERT_NE(asked, nullptr);
    EXPECT_TRUE(asked->findChild<QLabel*>("loginWords")->text().contains(address()));
    answer(*asked, kPassword, false);
    waitFor(State::Ready);
    EXPECT_EQ(desk().camera()->model, "RICOH THETA V");
    // The run and its background connection use what was said.
    desk().trigger();
    waitFor(State::AtStation);
    desk().trigger();
    waitUntil([&] { return !played.empty(); });
    EXPECT_EQ(played.front(), survey::Quality::Good) << desk().sentence().toStdString();
    EXPECT_EQ(form(), nullptr);
}

TEST_F(CameraLoginTest, AWrongPasswordIsAskedForAgain) {
    desk().connectTo(address());
    LoginForm* asked = waitForForm();
    ASSERT_NE(asked, nullptr);
    answer(*asked, "wrong", false);
    asked = waitForForm();
    ASSERT_NE(asked, nullptr);
    EXPECT_TRUE(asked->findChild<QLabel*>("loginWords")->text().contains("did not accept"));
    answer(*asked, kPassword, false);
    waitFor(State::Ready);
}

TEST_F(CameraLoginTest, WhoDoesNotSayIsToldWhatToDo) {
    desk().connectTo(address());
    LoginForm* asked = waitForForm();
    ASSERT_NE(asked, nullptr);
    asked->reject();
    waitFor(State::NoCamera);
    EXPECT_TRUE(desk().sentence().contains("password")) << desk().sentence().toStdString();
    desk().connectTo(address());
    EXPECT_NE(waitForForm(), nullptr); // and can think better of it
}

TEST_F(CameraLoginTest, WithoutAKeychainThePasswordIsGoodUntilTheProgramEnds) {
    QSignalSpy troubles(&desk().login(), &CameraLogin::trouble);
    desk().connectTo(address());
    LoginForm* asked = waitForForm();
    ASSERT_NE(asked, nullptr);
    answer(*asked, kPassword, true);
    waitFor(State::Ready);
    ASSERT_TRUE(!troubles.empty() || troubles.wait(100'000));
    EXPECT_TRUE(troubles.front().front().toString().contains("asked for again"));
    desk().connectTo(address());
    waitFor(State::Ready);
    EXPECT_EQ(form(), nullptr);
}

} // namespace spherewalk::ui
