// SPDX-License-Identifier: GPL-3.0-or-later
// A robot's camera as a node of ROS 1; resources/docs/guide/ros.md says how it is used.
#include "ros1_node.h"

#include "spherewalk/base/error.h"

int main(int argc, char** argv) {
    ros::init(argc, argv, "spherewalk");
    const ros::NodeHandle handle;
    try {
        spherewalk::ros::Ros1Node node(handle, spherewalk::ros::readParameters(ros::NodeHandle("~")));
        ROS_INFO("Ready; frames are rendered while somebody listens to %s.",
                 handle.resolveName("camera/image_raw").c_str());
        ros::AsyncSpinner spinner(2); // pictures of overlays do not hold up transforms
        spinner.start();
        ros::waitForShutdown();
    } catch (const spherewalk::Error& error) {
        ROS_FATAL("%s", error.sentence().c_str());
        return 1;
    }
    return 0;
}
