// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture_fixture.h"
#include "event_loop_gap.h"
#include "ui/capture/live_preview.h"

#include "spherewalk/practice/fault.h"

#include <QPushButton>

namespace spherewalk::ui {

using State = CaptureDesk::State;

namespace {

class PreviewFeedTest : public testing::Test {
  protected:
    void waitFor(PreviewFeed::State state) {
        QElapsedTimer time;
        time.start();
        QSignalSpy changes(&feed, &PreviewFeed::changed);
        while (feed.state() != state) {
            constexpr int kMostMs = 60'000;
            ASSERT_LT(time.elapsed(), kMostMs) << "state " << static_cast<int>(feed.state());
            changes.wait(50);
        }
    }

    /// Small, and with the patience that a busy machine's drawing needs.
    void start() {
        camera::PreviewOptions options;
        options.frameTimeout = std::chrono::minutes(1);
        options.mostWidth = 640;
        feed.start(host.endpoint(), 0.001, options);
    }

    PracticeHost host{{.width = 512, .timeScale = 0.001, .keepsPhotos = false}};
    PreviewFeed feed;
};

} // namespace

TEST_F(PreviewFeedTest, ShowsWhatTheCameraSees) {
    start();
    EXPECT_EQ(feed.state(), PreviewFeed::State::Starting);
    waitFor(PreviewFeed::State::Showing);
    EXPECT_EQ(feed.picture().width(), 2 * feed.picture().height());
    feed.stop();
    EXPECT_EQ(feed.state(), PreviewFeed::State::Off);
    feed.endAndWait();
    EXPECT_FALSE(feed.endAndWait());
}

TEST_F(PreviewFeedTest, ADamagedPartOnTheWayDoesNotEndIt) {
    host.camera().arm({practice::FaultKind::PreviewWithoutBoundary, "camera.getLivePreview", 0, 1, 0});
    host.camera().arm({practice::FaultKind::PreviewWrongLength, "camera.getLivePreview", 0, 1, 5});
    start();
    waitFor(PreviewFeed::State::Showing);
}

TEST_F(PreviewFeedTest, SaysWhyThereIsNone) {
    feed.start({"127.0.0.1", 1}, 0.001);
    waitFor(PreviewFeed::State::Ended);
    EXPECT_TRUE(feed.sentence().contains("127.0.0.1:1")) << feed.sentence().toStdString();
}

TEST_F(PreviewFeedTest, EndsWithTheCameras) {
    start();
    waitFor(PreviewFeed::State::Showing);
    camera::OscClient client(host.endpoint(), {}, systemClock());
    client.takePicture({});
    waitFor(PreviewFeed::State::Ended);
    EXPECT_EQ(feed.sentence(), "");
}

using LivePreviewTest = CaptureFixture;

TEST_F(LivePreviewTest, RestsDuringAShotAndGoesOnAtTheNextStation) {
    auto* view = mode.findChild<PreviewView*>("livePreview");
    EXPECT_FALSE(view->isVisibleTo(&mode));
    mode.findChild<QPushButton*>("showPreview")->click();
    EXPECT_TRUE(view->isVisibleTo(&mode));
    connectPractice();
    QSignalSpy pictures(&desk().preview(), &PreviewFeed::changed);
    const auto waitForPicture = [&] {
        while (desk().preview().state() != PreviewFeed::State::Showing && pictures.wait(60'000)) {
        }
        EXPECT_EQ(desk().preview().state(), PreviewFeed::State::Showing);
    };
    const auto shoot = [&] {
        const std::size_t shots = played.size() + 1;
        desk().trigger();
        EXPECT_EQ(desk().preview().state(), PreviewFeed::State::Off);
        waitUntil([&] { return desk().state() == State::AtStation && played.size() == shots; });
        waitForPicture();
    };
    waitForPicture();
    desk().trigger();
    EXPECT_EQ(desk().preview().state(), PreviewFeed::State::Off);
    waitFor(State::AtStation);
    waitForPicture();
    shoot();
    const test::EventLoopGap gap;
    shoot();
    EXPECT_EQ(played, (std::vector{survey::Quality::Good, survey::Quality::Good}));
    EXPECT_EQ(desk().practice()->camera().stats().exposures, 2);
    EXPECT_LT(gap.longestMs(), test::kMostHeldMs);
    RecordProperty("longest_gap_ms", std::to_string(gap.longestMs()));
}

TEST_F(LivePreviewTest, SwitchedOffItStaysOff) {
    connectPractice();
    desk().setShowsPreview(true);
    EXPECT_EQ(desk().preview().state(), PreviewFeed::State::Starting);
    desk().setShowsPreview(false);
    EXPECT_EQ(desk().preview().state(), PreviewFeed::State::Off);
    desk().trigger();
    waitFor(State::AtStation);
    EXPECT_EQ(desk().preview().state(), PreviewFeed::State::Off);
}

} // namespace spherewalk::ui
