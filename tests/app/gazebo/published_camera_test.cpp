// SPDX-License-Identifier: GPL-3.0-or-later
#include "gazebo_fixture.h"
#include "published_camera.h"

#include <gmock/gmock.h>

namespace spherewalk::test {
namespace {

using namespace std::chrono_literals;
using gazebo::PublishedCamera;

/// A simulation and its camera in one process, as with Gazebo's system.
class GazeboWithin : public Gazebo {
  protected:
    void make(double rateHz, simulator::Pace pace) {
        setup.topics.image = "/robot/front/image";
        setup.cameras = {{"", "eye", camera.intrinsics(), Rigid3()}};
        setup.options.rateHz = rateHz;
        setup.options.pace = pace;
        made.emplace(*renderer, setup, [](const std::string& sentence) { ADD_FAILURE() << sentence; });
    }

    void stepTo(Stamp stamp) {
        made->followListeners();
        if (made->camera().isDue(stamp)) {
            made->camera().waitUntilIdle();
            ++due;
            EXPECT_EQ(made->counters().frames + 1, due) << "all pictures before are there";
        }
        made->camera().takePose(stamp, Simulation::cameraAt(0.3 + 1e-4 * (stamp / 1ms), 0));
    }

    gazebo::CameraSetup setup;
    std::uint64_t due = 0;
    std::optional<PublishedCamera> made;
};

TEST_F(GazeboWithin, ASimulationThatWaitsGetsThePictureOfEachDueTime) {
    make(30, simulator::Pace::Every);
    stepTo(0ms); // for nobody
    EXPECT_EQ(due, 0U);
    Listener listener("/robot/front");
    for (int ms = 1; ms <= 2000; ++ms) {
        stepTo(ms * 1ms);
    }
    for (int ms = 0; ms <= 500; ++ms) { // a reset
        stepTo(ms * 1ms);
    }
    made->camera().waitUntilIdle();
    ASSERT_EQ(due, 61U + 16U);
    ASSERT_TRUE(listener.waitFor(due));
    const std::vector<gz::Image> images = listener.images();
    ASSERT_EQ(images.size(), due);
    EXPECT_EQ(stampOf(images[0].header()), 1ms) << "of the first pose for somebody";
    for (int k = 1; k < 61 + 16; ++k) {
        const int slot = k < 61 ? k : k - 61;
        EXPECT_EQ(stampOf(images[static_cast<std::size_t>(k)].header()), (1000 * slot + 29) / 30 * 1ms) << k;
    }
    EXPECT_EQ(entryOf(images.back().header(), "frame_id"), "eye");
    EXPECT_EQ(made->counters().dropped, 0U);
    EXPECT_EQ(made->counters().restarts, 1U);
}

TEST_F(GazeboWithin, APictureShowsThePoseOfItsStamp) {
    make(0, simulator::Pace::Every);
    Listener listener("/robot/front");
    for (const Stamp stamp : {0ms, 40ms, 80ms}) {
        stepTo(stamp);
    }
    made->camera().waitUntilIdle();
    ASSERT_TRUE(listener.waitFor(3));
    expectPicture(listener.images()[2], expected(0.3 + 80e-4, 0));
}

} // namespace
} // namespace spherewalk::test
