// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "temporary_folder.h"
#include "test_dataset.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/view_stream.h"
#include "spherewalk/simulator/simulated_camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

namespace spherewalk::simulator {
namespace {

using namespace std::chrono_literals;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::uint64_t refused(const CameraCounters& counters, Refusal kind) {
    return counters.refused[static_cast<std::size_t>(kind)];
}

/// A room of 2 x 1 m with photos along its middle.
class InTheSimulator : public testing::Test {
  protected:
    InTheSimulator() {
        std::vector<Rigid3> poses;
        for (int i = 0; i < 4; ++i) {
            poses.push_back({yawRotation(Radians(i)), Vector3d(0.2 + 0.4 * i, 0.5, 1)});
        }
        render::DatasetInfo info = test::writeTestDataset(folder.path(), poses, test::smoothWorld, 512, 2.0);
        info.outline = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
        info.ceilingM = 2.5;
        for (render::DatasetPhoto& photo : info.photos) {
            test::mark(folder.path(), photo);
        }
        test::rewriteInfo(folder.path(), info);
        renderer.emplace(std::make_shared<const render::Dataset>(render::Dataset::open(folder.path())));
        options.rateHz = 0;
        options.pace = Pace::Every;
    }

    std::unique_ptr<SimulatedCamera> make() {
        auto made = std::make_unique<SimulatedCamera>(
            *renderer, CameraModel(camera), options,
            [this](const Frame& frame) {
                const std::scoped_lock lock(mutex);
                frames.push_back(frame);
            },
            [this](const std::string& sentence) {
                const std::scoped_lock lock(mutex);
                told.push_back(sentence);
            });
        made->setListening(true);
        return made;
    }

    /// Of a link whose x axis points into the room.
    static Rigid3 at(double x, double yaw = 0) { return {yawRotation(Radians(yaw)), Vector3d(x, 0.5, 1)}; }

    static Rigid3 optical(const Rigid3& body) { return body * Rigid3{bodyFromOptical(), Vector3d::Zero()}; }

    std::vector<std::int64_t> stamps() {
        std::vector<std::int64_t> result;
        for (const Frame& frame : frames) {
            result.push_back(frame.stamp.count());
        }
        return result;
    }

    test::TemporaryFolder folder;
    std::optional<render::Renderer> renderer;
    CameraIntrinsics camera = CameraIntrinsics::pinhole(64, 48, 1.2);
    CameraOptions options;
    std::mutex mutex;
    std::vector<Frame> frames;
    std::vector<std::string> told;
};

TEST_F(InTheSimulator, InLockStepEachPoseGivesItsFrameWithItsStampAndTheViewsBytes) {
    const auto simulated = make();
    render::ViewStream stream(*renderer, CameraModel(camera));
    for (int i = 0; i < 20; ++i) {
        const Rigid3 pose = at(0.1 + 0.09 * i, 0.3 * i);
        const Stamp stamp(1'000'000'007LL * i);
        simulated->takePose(stamp, pose);
        simulated->waitUntilIdle();
        ASSERT_EQ(frames.size(), static_cast<std::size_t>(i + 1));
        const Frame& frame = frames.back();
        EXPECT_EQ(frame.stamp, stamp);
        EXPECT_EQ(frame.camera, camera);
        const render::View expected = stream.next(optical(pose), i);
        EXPECT_EQ(frame.view.picture, expected.picture) << i;
        EXPECT_NEAR(frame.view.report.trust, expected.report.trust, 1e-6);
        EXPECT_FALSE(frame.view.report.isOutside);
    }
    EXPECT_EQ(simulated->counters().frames, 20U);
    EXPECT_EQ(simulated->counters().stream.views, 20U);
}

TEST_F(InTheSimulator, TheMountingTakesThePoseOfALinkToTheCamerasInTheRoom) {
    options.mounting.roomFromWorld = {yawRotation(Radians(2)), Vector3d(1, -3, 0)};
    options.mounting.linkFromCamera = {yawRotation(Radians(-0.4)), Vector3d(0.1, 0.02, 0.3)};
    const auto simulated = make();
    const Rigid3 wanted = at(0.7, 0.5);
    simulated->takePose(0s, options.mounting.roomFromWorld.inverse() * wanted *
                                options.mounting.linkFromCamera.inverse());
    simulated->waitUntilIdle();
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_TRUE(frames[0].roomFromCamera.translation.isApprox(wanted.translation, 1e-12));
    EXPECT_LT(angleBetween(frames[0].roomFromCamera.rotation, optical(wanted).rotation).value(), 1e-9);
}

TEST_F(InTheSimulator, NothingIsRenderedWhileNobodyListens) {
    const auto simulated = make();
    simulated->setListening(false);
    simulated->takePose(0s, at(0.3));
    simulated->waitUntilIdle();
    EXPECT_THAT(stamps(), IsEmpty());
    simulated->setListening(true);
    simulated->takePose(1s, at(0.3));
    simulated->waitUntilIdle();
    EXPECT_THAT(stamps(), ElementsAre(1'000'000'000));
    EXPECT_EQ(simulated->counters().poses, 2U);
}

TEST_F(InTheSimulator, RefusesPosesThatAreNoneAndGoesOn) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto simulated = make();
    for (int i = 0; i < 25; ++i) {
        simulated->takePose(1s, {Quaterniond::Identity(), Vector3d(0, nan, 0)});
    }
    simulated->takePose(1s, {Quaterniond::Identity(), Vector3d(1e300, 0, 0)});
    simulated->takePose(1s, {Quaterniond(0, 0, 0, 0), Vector3d(0.5, 0.5, 1)});
    simulated->takePose(1s, {Quaterniond(nan, 0, 0, 0), Vector3d(0.5, 0.5, 1)});
    simulated->takePose(-1s, at(0.5));
    simulated->takePose(2s, {Quaterniond(0.995, 0, 0, 0), Vector3d(0.5, 0.5, 1)});
    simulated->waitUntilIdle();
    EXPECT_THAT(stamps(), ElementsAre(2'000'000'000));
    EXPECT_EQ(frames[0].view.picture, renderer->render(CameraModel(camera), optical(at(0.5))).picture);
    const CameraCounters counters = simulated->counters();
    EXPECT_EQ(refused(counters, Refusal::Place), 26U);
    EXPECT_EQ(refused(counters, Refusal::Rotation), 2U);
    EXPECT_EQ(refused(counters, Refusal::Time), 1U);
    EXPECT_THAT(told, ElementsAre(HasSubstr("y nan"), HasSubstr("10 of this kind"),
                                  HasSubstr("not a unit quaternion"), HasSubstr("before")));
}

TEST_F(InTheSimulator, OutsideOfTheRoomNothingIsTrusted) {
    const auto simulated = make();
    simulated->takePose(1s, at(1.4));
    simulated->takePose(2s, at(30));
    simulated->takePose(3s, {Quaterniond::Identity(), Vector3d(0.5, 0.5, 3)});
    simulated->waitUntilIdle();
    ASSERT_EQ(frames.size(), 3U);
    EXPECT_GT(frames[0].view.report.trust, 0);
    for (const int i : {1, 2}) {
        EXPECT_TRUE(frames[static_cast<std::size_t>(i)].view.report.isOutside);
        EXPECT_EQ(frames[static_cast<std::size_t>(i)].view.report.trust, 0);
    }
    EXPECT_EQ(simulated->counters().outside, 2U);
}

TEST_F(InTheSimulator, AMissingPhotoIsToldOfAndTheOthersAreRendered) {
    std::filesystem::remove(folder / "photos/3.jpg");
    const auto simulated = make();
    simulated->takePose(1s, at(1.4));
    simulated->takePose(2s, at(0.2));
    simulated->waitUntilIdle();
    EXPECT_THAT(stamps(), ElementsAre(2'000'000'000));
    EXPECT_EQ(refused(simulated->counters(), Refusal::Rendering), 1U);
    EXPECT_THAT(told, ElementsAre(HasSubstr("photos/3.jpg")));
}

TEST_F(InTheSimulator, ACameraThatIsChangedIsUsedFromThenOn) {
    const auto simulated = make();
    simulated->takePose(1s, at(0.5));
    simulated->waitUntilIdle();
    const CameraIntrinsics other = CameraIntrinsics::pinhole(32, 20, 0.8);
    simulated->setCamera(CameraModel(other));
    simulated->takePose(2s, at(0.5));
    simulated->waitUntilIdle();
    ASSERT_EQ(frames.size(), 2U);
    EXPECT_EQ(frames[1].camera, other);
    EXPECT_EQ(frames[1].view.picture, renderer->render(CameraModel(other), optical(at(0.5))).picture);
}

/// With an object's pictures as messages carry them: a square in the middle, 0.2 m before the camera.
class WithObjects : public InTheSimulator {
  protected:
    static constexpr std::uint8_t kLabel = 20;

    WithObjects() : colour(64 * 48 * 3), labels(64 * 48), depths(64 * 48) {
        options.overlay.emplace();
        for (int y = 0; y < 48; ++y) {
            for (int x = 0; x < 64; ++x) {
                const std::size_t i = static_cast<std::size_t>(64 * y + x);
                labels[i] = isObject(x, y) ? kLabel : 1;
                depths[i] = isObject(x, y) ? 0.2F : 5;
                colour[3 * i + 1] = isObject(x, y) ? 250 : 0;
            }
        }
    }

    static bool isObject(int x, int y) { return std::abs(x - 32) < 8 && std::abs(y - 24) < 8; }

    void giveOverlay(SimulatedCamera& simulated, Stamp stamp) const {
        const auto* bytes = reinterpret_cast<const std::uint8_t*>(depths.data());
        simulated.takeOverlay(OverlayPart::Depth, stamp, {64, 48, 0, "32FC1", false, {bytes, 64 * 48 * 4}});
        simulated.takeOverlay(OverlayPart::Labels, stamp, {64, 48, 0, "mono8", false, labels});
        simulated.takeOverlay(OverlayPart::Colour, stamp, {64, 48, 0, "rgb8", false, colour});
    }

    std::vector<std::uint8_t> colour;
    std::vector<std::uint8_t> labels;
    std::vector<float> depths;
};

TEST_F(WithObjects, TheObjectIsLaidIntoTheFrameOfItsStampAndTheRestIsThePhoto) {
    const auto simulated = make();
    simulated->takePose(1s, at(0.5));
    giveOverlay(*simulated, 1s);
    simulated->takePose(2s, at(0.5));
    simulated->waitUntilIdle();
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames[0].stamp, 1s);
    EXPECT_EQ(frames[0].overlay, OverlayUse::Laid);
    const RgbImage photo = renderer->render(CameraModel(camera), optical(at(0.5))).picture;
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 64; ++x) {
            const std::uint8_t* seen = frames[0].view.picture.at(x, y);
            if (isObject(x, y)) {
                ASSERT_THAT(std::vector<int>(seen, seen + 3), ElementsAre(0, 250, 0)) << x << " " << y;
            } else {
                ASSERT_TRUE(std::equal(seen, seen + 3, photo.at(x, y))) << x << " " << y;
            }
        }
    }
}

TEST_F(WithObjects, WithoutThemTheFrameIsThePhotoAndIsCounted) {
    const auto simulated = make();
    simulated->takePose(1s, at(0.5));
    simulated->takePose(2s, at(0.9));
    simulated->waitUntilIdle();
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames[0].overlay, OverlayUse::Missing);
    EXPECT_EQ(frames[0].view.picture, renderer->render(CameraModel(camera), optical(at(0.5))).picture);
    EXPECT_EQ(simulated->counters().overlaysMissing, 1U);
    EXPECT_EQ(simulated->counters().overlaysLaid, 0U);
}

TEST_F(WithObjects, PicturesThatDoNotFitAreRefused) {
    const auto simulated = make();
    simulated->takeOverlay(OverlayPart::Colour, 1s, {63, 48, 0, "rgb8", false, colour});
    simulated->takeOverlay(OverlayPart::Colour, 1s, {64, 48, 0, "jpeg", false, colour});
    simulated->takeOverlay(OverlayPart::Depth, 1s, {64, 48, 0, "32FC1", false, colour});
    simulated->takeOverlay(OverlayPart::Labels, -1s, {64, 48, 0, "mono8", false, labels});
    simulated->takePose(1s, at(0.5));
    giveOverlay(*simulated, 1s);
    simulated->waitUntilIdle();
    EXPECT_EQ(simulated->counters().overlaysLaid, 1U);
    EXPECT_EQ(refused(simulated->counters(), Refusal::Size), 2U);
    EXPECT_EQ(refused(simulated->counters(), Refusal::Encoding), 1U);
    EXPECT_EQ(refused(simulated->counters(), Refusal::Time), 1U);
    EXPECT_THAT(told[0], HasSubstr("63 x 48"));
}

TEST_F(InTheSimulator, FramesAreTakenByTheSensor) {
    options.sensor.emplace();
    options.sensor->noise = {3000, 4};
    options.sensor->exposure.timeS = 0.01;
    options.sensor->shutter.lineDelayS = 2e-4;
    const auto simulated = make();
    render::Sensor sensor(*options.sensor, CameraModel(camera));
    for (int i = 0; i < 3; ++i) { // a tenth of a second between poses
        simulated->takePose(i * 100ms, at(0.2 + 0.02 * i, 0.2 * i));
    }
    simulated->waitUntilIdle();
    ASSERT_EQ(frames.size(), 3U);
    render::View expected;
    const auto makeView = [&](const Rigid3& pose, double, bool, render::View& view) {
        view = renderer->render(CameraModel(camera), optical(pose));
    };
    const auto moving = [](double afterS) { return at(0.24 + 0.2 * afterS, 0.4 + 2 * afterS); };
    const render::SensorReport report = sensor.take(makeView, moving, 0, 200'000'000, expected);
    EXPECT_GT(report.views, 1); // rows were exposed one after the other
    ASSERT_TRUE(frames[2].sensor);
    EXPECT_EQ(frames[2].sensor->views, report.views);
    EXPECT_EQ(frames[2].stamp, 200ms);
    // Poses that were interpolated otherwise differ in their last bits, which may change a grey level.
    int most = 0;
    for (std::size_t i = 0; i < expected.picture.values().size(); ++i) {
        most = std::max(most, std::abs(expected.picture.values()[i] - frames[2].view.picture.values()[i]));
    }
    EXPECT_LE(most, 1);
    EXPECT_LT(frames[0].sensor->views, 5) << "the first pose tells no motion";
}

TEST_F(WithObjects, DepthShowsRoomAndObjectsAtTheFramesStamp) {
    options.wantsDepth = true;
    options.view.scene = render::SceneKind::Sphere;
    const auto simulated = make();
    simulated->takePose(1s, at(0.5));
    giveOverlay(*simulated, 1s);
    simulated->takePose(2s, at(0.5));
    simulated->waitUntilIdle();
    ASSERT_EQ(frames.size(), 1U);
    render::ViewOptions room;
    room.scene = render::SceneKind::Sphere;
    room.wantsDepth = true;
    const DepthImage alone = renderer->render(CameraModel(camera), optical(at(0.5)), room).depth;
    ASSERT_EQ(frames[0].view.depth.width(), 64);
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 64; ++x) {
            ASSERT_EQ(*frames[0].view.depth.at(x, y), isObject(x, y) ? 0.2F : *alone.at(x, y))
                << x << " " << y;
        }
    }
}

TEST_F(InTheSimulator, DepthHasTheErrorsOfTheSensorAndIsEmptyWithoutADepth) {
    options.wantsDepth = true;
    options.sensor.emplace().depth = {0.1, 1, 0, 0};
    options.view.scene = render::SceneKind::Sphere;
    const auto simulated = make();
    simulated->takePose(1s, at(0.5));
    simulated->waitUntilIdle();
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(*frames[0].view.depth.at(32, 24), std::numeric_limits<float>::infinity()) << "2 m is too far";
    options.view.scene = render::SceneKind::None;
    frames.clear();
    const auto without = make();
    without->takePose(1s, at(0.5));
    without->waitUntilIdle();
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_TRUE(frames[0].view.depth.empty());
}

TEST_F(InTheSimulator, ARigGivesAFrameOfEachCameraWithOneStamp) {
    options.mounting.axes = CameraAxes::Optical;
    options.pace = Pace::Newest; // whatever is left out, is left out of both
    const Rigid3 left{bodyFromOptical(), {0, 0.06, 0}};
    const Rigid3 right{bodyFromOptical(), {0, -0.06, 0}};
    SimulatedCamera made(*renderer, {{CameraModel(camera), left}, {CameraModel(camera), right}}, options,
                         [this](const Frame& frame) { frames.push_back(frame); }, {});
    made.setListening(true);
    for (int i = 0; i < 40; ++i) {
        made.takePose(i * 33ms, at(0.2 + 0.03 * i));
    }
    made.waitUntilIdle();
    ASSERT_GE(frames.size(), 2U);
    ASSERT_EQ(frames.size() % 2, 0U);
    EXPECT_EQ(made.counters().frames, frames.size() / 2);
    EXPECT_EQ(made.counters().frames + made.counters().dropped, 40U);
    for (std::size_t i = 0; i < frames.size(); i += 2) {
        EXPECT_EQ(frames[i].index, 0U);
        EXPECT_EQ(frames[i + 1].index, 1U);
        EXPECT_EQ(frames[i].stamp, frames[i + 1].stamp);
        EXPECT_EQ(frames[i].baselineM, 0);
        EXPECT_EQ(frames[i + 1].baselineM, 0.12);
        const Rigid3 leftFromRight = frames[i].roomFromCamera.inverse() * frames[i + 1].roomFromCamera;
        EXPECT_LT((leftFromRight.translation - Vector3d(0.12, 0, 0)).norm(), 1e-12);
    }
    EXPECT_EQ(frames.back().view.picture,
              renderer->render(CameraModel(camera), at(0.2 + 0.03 * 39) * right, options.view).picture);
}

TEST_F(InTheSimulator, ARigWhoseCamerasMoveTakesAPoseOfEach) {
    options.mounting.axes = CameraAxes::Optical;
    SimulatedCamera made(
        *renderer, {{CameraModel(camera), {}}, {CameraModel(camera), {}}}, options,
        [this](const Frame& frame) { frames.push_back(frame); },
        [this](const std::string& sentence) { told.push_back(sentence); });
    made.setListening(true);
    made.takePoses(1s, {optical(at(0.5)), optical(at(0.7, 0.3))});
    made.waitUntilIdle();
    ASSERT_EQ(frames.size(), 2U);
    EXPECT_LT((frames[1].roomFromCamera.translation - Vector3d(0.7, 0.5, 1)).norm(), 1e-12);
    EXPECT_EQ(frames[1].baselineM, 0) << "turned otherwise";
    made.takePoses(2s, {optical(at(0.5)), {Quaterniond(0, 0, 0, 0), Vector3d::Zero()}});
    made.waitUntilIdle();
    EXPECT_EQ(frames.size(), 2U) << "one wrong pose is no pose of the rig";
    EXPECT_EQ(refused(made.counters(), Refusal::Rotation), 1U);
    test::expectError(ErrorKind::InvalidInput, "2 cameras", [&] { made.takePoses(3s, {optical(at(0.5))}); });
    const auto giveNothing = [](const Frame&) {};
    test::expectError(ErrorKind::InvalidInput, "one camera or more", [&] {
        SimulatedCamera(*renderer, std::vector<MountedCamera>(), options, giveNothing, {});
    });
}

TEST_F(InTheSimulator, RefusesOptionsOutOfRange) {
    options.rateHz = 1001;
    test::expectError(ErrorKind::InvalidInput, "0 to 1000", [this] { make(); });
    options.rateHz = 30;
    options.overlay.emplace().wait = 11s;
    test::expectError(ErrorKind::InvalidInput, "0 to 10 s", [this] { make(); });
    options.overlay.reset();
    options.sensor.emplace().jpegQuality = 101;
    test::expectError(ErrorKind::InvalidInput, "jpeg/quality", [this] { make(); });
    options.sensor.reset();
    options.mounting.roomFromWorld.rotation = Quaterniond(0, 0, 0, 0);
    test::expectError(ErrorKind::InvalidInput, "unit quaternions", [this] { make(); });
}

} // namespace
} // namespace spherewalk::simulator
