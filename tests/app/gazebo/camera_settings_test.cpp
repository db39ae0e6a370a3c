// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera_settings.h"
#include "expect_error.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#ifdef SPHEREWALK_SDFORMAT
#include <sdf/Element.hh>
#include <sdf/Root.hh>
#include <sdf/parser.hh>
#endif

namespace spherewalk::gazebo {
namespace {

using testing::ElementsAre;
using testing::Pair;

TEST(PluginElements, SayWhatTheCommandLineSays) {
    EXPECT_THAT(wordsOf({{"dataset", " ../room \n"},
                         {"camera", "camera.yaml"},
                         {"overlay_wait", "1.5"},
                         {"room_labels", "0,1"},
                         {"mount", "0 0 1 0 0 0 1"},
                         {"no_verify", ""},
                         {"depth", "false"},
                         {"sensor", "/etc/sensor.yaml"}},
                        "/worlds/lab"),
                ElementsAre("/worlds/room", "--camera=/worlds/lab/camera.yaml", "--overlay-wait=1.5",
                            "--room-labels=0,1", "--mount=0 0 1 0 0 0 1", "--no-verify", "--depth=false",
                            "--sensor=/etc/sensor.yaml"));
}

TEST(PluginElements, AreNamedBySentencesAboutOptions) {
    EXPECT_EQ(aboutElements("--rate: Value -1 not in range"), "<rate>: Value -1 not in range");
    EXPECT_EQ(aboutElements("give --overlay-labels, or --objects-by depth."),
              "give <overlay_labels>, or <objects_by> depth.");
    EXPECT_EQ(aboutElements("from -- to, at the end --"), "from -- to, at the end --");
}

/// A camera.yaml, and what becomes of elements beside it.
class Settings : public testing::Test {
  protected:
    Settings() {
        writeFile(folder / "camera.yaml",
                  bytesOf("image_width: 160\nimage_height: 120\ncamera_matrix: {data: [120, 0, 79.5, 0, 120, "
                          "59.5, 0, 0, 1]}\ndistortion_model: none\ndistortion_coefficients: {data: []}\n"));
    }

    CameraSetup setup(Elements more, simulator::Pace pace = simulator::Pace::Every) const {
        Elements elements = {{"dataset", "room"}, {"camera", "camera.yaml"}, {"image", "/robot/image"}};
        elements.insert(elements.end(), more.begin(), more.end());
        CameraSettings settings(pace);
        program::CommandLine line("", "plugin", "");
        settings.declare(line.program());
        line.parse(wordsOf(elements, folder.path()));
        EXPECT_EQ(settings.render().folder(), folder / "room");
        return settings.setup("robot::camera");
    }

    test::TemporaryFolder folder;
};

TEST_F(Settings, OfAPluginAreThoseOfTheProgramButForThePace) {
    const CameraSetup usual = setup({});
    EXPECT_EQ(usual.options.pace, simulator::Pace::Every);
    EXPECT_EQ(usual.options.rateHz, 30);
    EXPECT_FALSE(usual.options.wantsDepth);
    EXPECT_FALSE(usual.options.overlay);
    ASSERT_EQ(usual.cameras.size(), 1U);
    EXPECT_EQ(usual.cameras.front().frameId, "robot::camera_optical");
    EXPECT_EQ(usual.cameras.front().camera.width, 160);

    const CameraSetup other = setup({{"rate", "15"},
                                     {"pace", "newest"},
                                     {"depth", "true"},
                                     {"frame_id", "eye"},
                                     {"mount", "0 0 1 0 0 0 1"},
                                     {"overlay_colour", "/o/colour"},
                                     {"overlay_depth", "/o/depth"},
                                     {"objects_by", "alone"},
                                     {"overlay_wait", "1.5"}});
    EXPECT_EQ(other.options.rateHz, 15);
    EXPECT_EQ(other.options.pace, simulator::Pace::Newest);
    EXPECT_TRUE(other.options.wantsDepth);
    EXPECT_EQ(other.cameras.front().frameId, "eye");
    EXPECT_EQ(other.options.mounting.linkFromCamera.translation.z(), 1);
    ASSERT_TRUE(other.options.overlay);
    EXPECT_EQ(other.options.overlay->by, simulator::ObjectsBy::Alone);
    EXPECT_EQ(other.options.overlay->wait, std::chrono::milliseconds(1500));
}

TEST_F(Settings, ThatAreWrongAreToldInOneSentence) {
    const auto refuses = [this](const Elements& elements, const std::string& what) {
        test::expectError(ErrorKind::InvalidInput, what, [&] { setup(elements); });
    };
    refuses({{"rate", "-1"}}, "--rate");
    refuses({{"rate", "fast"}}, "--rate");
    refuses({{"raet", "30"}}, "--raet");
    refuses({{"help", ""}}, "--help");
    refuses({{"pace", "slow"}}, "--pace");
    refuses({{"overlay_colour", "/o/colour"}}, "--overlay-depth");
    refuses({{"overlay_colour", "/o/colour"}, {"overlay_depth", "/o/depth"}}, "--overlay-labels");
    refuses({{"image", "/other/image"}}, "--image");
}

#ifdef SPHEREWALK_SDFORMAT
TEST(PluginElements, ComeFromSdfInTheirOrder) {
    sdf::Root root;
    const sdf::Errors errors = root.LoadSdfString(
        "<sdf version='1.9'><world name='w'><model name='robot'><static>1</static>"
        "<plugin filename='spherewalk-gz-system' name='spherewalk::gazebo::CameraSystem'>\n"
        "<dataset>../room</dataset><rate> 15 </rate>\n<depth/><room_labels>0,1</room_labels><!-- no -->"
        "<mount>0 0 1 0 0 0 1</mount></plugin><link name='base'/></model></world></sdf>");
    ASSERT_TRUE(errors.empty()) << errors.front().Message();
    const sdf::ElementPtr plugin =
        root.Element()->GetElement("world")->GetElement("model")->GetElement("plugin");
    const std::shared_ptr<const sdf::Element> given = plugin; // as systems get it
    EXPECT_THAT(elementsOf(given),
                ElementsAre(Pair("dataset", "../room"), Pair("rate", testing::_), Pair("depth", ""),
                            Pair("room_labels", "0,1"), Pair("mount", "0 0 1 0 0 0 1")));
    EXPECT_THAT(wordsOf(elementsOf(given), "/w"), testing::Contains("--rate=15"));
}
#endif

} // namespace
} // namespace spherewalk::gazebo
