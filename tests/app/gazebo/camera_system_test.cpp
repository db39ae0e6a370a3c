// SPDX-License-Identifier: GPL-3.0-or-later
// Gazebo itself with the system. These tests are built where Gazebo is.
#include "gazebo_fixture.h"

#include <gmock/gmock.h>

#ifdef SPHEREWALK_IGNITION
#include <ignition/gazebo/Server.hh>
#include <ignition/gazebo/ServerConfig.hh>
namespace sim = ignition::gazebo;
#else
#include <gz/sim/Server.hh>
#include <gz/sim/ServerConfig.hh>
namespace sim = gz::sim;
#endif

namespace spherewalk::test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

class GazeboServer : public Gazebo {
  protected:
    /// A world with a robot whose camera is at x = 0.3, y = 0.5, z = 1, and these plugins. The world names a
    /// plugin of its own, so that Gazebo does not load the usual ones.
    void start(const std::vector<std::string>& plugins) {
        for (const char* variable : {"GZ_SIM_SYSTEM_PLUGIN_PATH", "IGN_GAZEBO_SYSTEM_PLUGIN_PATH"}) {
            ::setenv(variable, SPHEREWALK_GZ_SYSTEM, 1);
        }
        std::string all;
        for (const std::string& plugin : plugins) {
            all += text("<plugin filename='spherewalk-gz-system' name='spherewalk::gazebo::CameraSystem'>",
                        plugin, "</plugin>");
        }
        sim::ServerConfig config;
        config.SetSdfString(
            text("<sdf version='1.9'><world name='w'><physics name='p' "
                 "type='ignored'><max_step_size>0.001</max_step_size><real_time_factor>0</real_time_factor>"
                 "</physics><plugin filename='none' name='none'/><model "
                 "name='robot'><static>1</static><pose>0.3 0.5 "
                 "0 0 0 0</pose>",
                 all, "<link name='camera'><pose>0 0 1 0 0 0</pose></link></model></world></sdf>"));
        server.emplace(config);
    }

    std::string plugin(const std::string& topic, const std::string& more = "") const {
        return text("<dataset>", dataset().string(), "</dataset><camera>", cameraFile().string(),
                    "</camera><frame>camera</frame><image>", topic, "/image</image>", more);
    }

    void run(int steps) { ASSERT_TRUE(server->Run(true, static_cast<std::uint64_t>(steps), false)); }

    std::optional<sim::Server> server;
};

TEST_F(GazeboServer, EachCameraGivesThePictureOfEachDueTime) {
    Listener front("/robot/front");
    Listener rear("/robot/rear");
    start({plugin("/robot/front"), plugin("/robot/rear", "<mount>0 0 0 0 0 1 0</mount><rate>10</rate>")});
    run(1000);
    server.reset(); // the pictures that are being rendered come, too
    ASSERT_TRUE(front.waitFor(31) && rear.waitFor(11));
    ASSERT_EQ(front.images().size(), 31U);
    ASSERT_EQ(rear.images().size(), 11U);
    for (int k = 1; k <= 30; ++k) {
        EXPECT_EQ(stampOf(front.images()[static_cast<std::size_t>(k)].header()), (1000 * k + 29) / 30 * 1ms);
    }
    EXPECT_EQ(stampOf(rear.images()[10].header()), 1s);
    EXPECT_EQ(entryOf(front.images()[0].header(), "frame_id"), "robot::camera_optical");
    expectPicture(front.images()[0], expected(0.3, 0));
    expectPicture(rear.images()[0], expected(0.3, 3.14159265358979));
}

TEST_F(GazeboServer, AWrongCameraIsToldOfAndTheOthersGoOn) {
    Listener listener("/robot/front");
    testing::internal::CaptureStderr();
    start({plugin("/robot/other", "<raet>30</raet>"), plugin("/robot/front"),
           plugin("/robot/third", "<rate>-1</rate>")});
    run(100);
    server.reset();
    const std::string errors = testing::internal::GetCapturedStderr();
    EXPECT_TRUE(listener.waitFor(4));
    EXPECT_THAT(errors, HasSubstr("The camera of Spherewalk at robot was not made."));
    EXPECT_THAT(errors, HasSubstr("<raet>"));
    EXPECT_THAT(errors, HasSubstr("<rate>"));
}

TEST_F(GazeboServer, ALinkThatIsNotThereIsWaitedFor) {
    Listener listener("/robot/front");
    testing::internal::CaptureStderr();
    start({text("<dataset>", dataset().string(), "</dataset><camera>", cameraFile().string(),
                "</camera><frame>eye</frame><image>/robot/front/image</image>")});
    run(100);
    server.reset();
    EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("nothing is called eye below robot"));
    EXPECT_EQ(listener.images().size(), 0U);
}

} // namespace
} // namespace spherewalk::test
