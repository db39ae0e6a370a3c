// SPDX-License-Identifier: GPL-3.0-or-later
#include "qt_application.h"
#include "ui/capture/cameras.h"

#include <QSignalSpy>
#include <gtest/gtest.h>

namespace spherewalk::ui {
namespace {

class CameraFinderTest : public testing::Test {
  protected:
    void find(const camera::Endpoint& endpoint) {
        camera::FindOptions options;
        options.browseTime = std::chrono::milliseconds(0);
        options.places = {{endpoint, "here"}};
        finder.setOptions(options);
        finder.find();
        QSignalSpy changes(&finder, &CameraFinder::changed);
        while (finder.isLooking()) {
            ASSERT_TRUE(changes.wait(100'000));
        }
    }

    TaskList tasks;
    CameraFinder finder{tasks};
};

TEST_F(CameraFinderTest, TellsWhoAnswers) {
    const PracticeHost host({.width = 512, .timeScale = 0, .keepsPhotos = false});
    find(host.endpoint());
    ASSERT_EQ(finder.cameras().size(), 1U);
    EXPECT_EQ(finder.sentence(), "1 camera(s) found");
    EXPECT_TRUE(CameraFinder::words(finder.cameras()[0]).startsWith("RICOH THETA V 00"));
    EXPECT_TRUE(CameraFinder::words(finder.cameras()[0]).endsWith("(here)"));
}

TEST_F(CameraFinderTest, SaysWhatToDoWhenNobodyAnswers) {
    find({"127.0.0.1", 1});
    EXPECT_TRUE(finder.cameras().empty());
    EXPECT_TRUE(finder.sentence().startsWith("No camera answers."));
}

} // namespace
} // namespace spherewalk::ui
