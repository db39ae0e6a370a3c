// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "random.h"
#include "temporary_folder.h"
#include "test_dataset.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/view_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace spherewalk::render {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kWall = 4; ///< Where the west side of the wall between the rooms lies.

/// Two rooms of 4 x 4 m without a door, a wall of 10 cm between them, photos every 50 cm. The western room's
/// photos are red and the eastern one's green.
class TwoRooms : public testing::Test {
  protected:
    enum class Knows { Plan, RoughPlan, Depth };

    void write(Knows knows) {
        std::vector<Rigid3> poses;
        for (const double left : {0.0, kWall + 0.1}) {
            for (int i = 0; i < 49; ++i) {
                poses.push_back(
                    {yawRotation(Radians(i)), {left + 0.5 + 0.5 * (i % 7), 0.5 + 0.5 * (i / 7), 1.2}});
            }
        }
        info = test::writeTestDataset(
            folder.path(), poses, [](const Vector3d&) { return Vector3d(200, 0, 0); }, 64, 2.0);
        info.ceilingM = 2.6;
        const double rough = knows == Knows::RoughPlan ? 0.1 : 0;
        if (knows != Knows::Depth) {
            // A wall that is drawn as the gap of the outline, and the rest of it as an obstacle.
            info.outline = {{rough, 0},       {kWall, rough},        {kWall, 2},
                            {kWall + 0.1, 2}, {kWall + 0.1, -rough}, {8.1 - rough, 0},
                            {8.1, 4 - rough}, {5 + rough, 4},        {5, 4 - rough},
                            {3, 4 + rough},   {2, 4 - rough},        {rough, 4}};
            info.obstacles = {{{kWall, 2}, {kWall + 0.1, 2}, {kWall + 0.1, 4.2}, {kWall, 4.2}}};
        }
        for (std::size_t i = 0; i < info.photos.size(); ++i) {
            DatasetPhoto& photo = info.photos[i];
            if (knows == Knows::Depth) {
                writeDepth(photo);
            }
            if (!isWest(photo.roomFromPhoto.translation)) {
                paint(photo, {0, 200, 0});
            }
        }
        test::rewriteInfo(folder.path(), info);
    }

    void paint(DatasetPhoto& photo, const Vector3d& colour) const {
        const Bytes picture = jpeg::encode(test::panorama([&](const Vector3d& /*ray*/) { return colour; },
                                                          Eigen::Quaterniond::Identity(), 64),
                                           95);
        photo.sha256 = sha256Hex(picture);
        photo.sizeBytes = picture.size();
        writeFile(folder.path() / photo.file, picture);
    }

    static bool isWest(const Vector3d& place) { return place.x() < kWall + 0.05; }

    /// The true depth with an error of 3 %, of which a tenth is not sure.
    void writeDepth(DatasetPhoto& photo) {
        const double left = isWest(photo.roomFromPhoto.translation) ? 0 : kWall + 0.1;
        const RoomShape room{{{left, 0}, {left + 4, 0}, {left + 4, 4}, {left, 4}}, 0, 2.6};
        const DepthMap exact = roomDepth(room, photo.roomFromPhoto, 256);
        Image<float, 1> inverse = exact.inverseM();
        MaskImage sure(inverse.width(), inverse.height());
        for (std::size_t i = 0; i < inverse.values().size(); ++i) {
            const bool isSure = random.uniform(0, 1) < 0.9;
            sure.values()[i] = isSure ? 255 : 0;
            inverse.values()[i] *= static_cast<float>(isSure ? 1 + random.uniform(-0.03, 0.03) : 5);
        }
        std::filesystem::create_directories(folder.path() / "depth");
        photo.depth = "depth/" + std::filesystem::path(photo.file).stem().string() + ".pgm";
        writeFile(folder.path() / photo.depth, DepthMap(std::move(inverse), std::move(sure)).serialised());
    }

    Renderer renderer() const {
        return Renderer(std::make_shared<const Dataset>(Dataset::open(folder.path())));
    }

    Rigid3 somewhere() {
        return {random.rotation(),
                {random.uniform(0.02, 8.08), random.uniform(0.02, 3.98), random.uniform(0.3, 2.2)}};
    }

    test::TemporaryFolder folder;
    DatasetInfo info;
    test::Random random{91};
    CameraModel camera{CameraIntrinsics::pinhole(32, 24, 1.2)};
};

/// How red and how green a picture is.
bool isRed(const RgbImage& picture) {
    const std::uint8_t* middle = picture.at(picture.width() / 2, picture.height() / 2);
    return middle[0] > middle[1];
}

TEST_F(TwoRooms, AViewShowsTheRoomOfItsCamera) {
    for (const Knows knows : {Knows::Plan, Knows::Depth}) {
        write(knows);
        const Renderer renderer = this->renderer();
        for (int i = 0; i < 200; ++i) {
            Rigid3 pose = somewhere();
            if (i % 2 == 0) { // 5 cm in front of the wall
                pose.translation.x() = i % 4 == 0 ? kWall - 0.05 : kWall + 0.15;
            } else if (pose.translation.x() > kWall - 0.02 && pose.translation.x() < kWall + 0.12) {
                continue; // in the wall
            }
            for (const SceneKind scene :
                 {SceneKind::None, SceneKind::Sphere, SceneKind::Depth, SceneKind::Blend}) {
                if (knows != Knows::Depth && hasSurfaces(scene)) {
                    continue;
                }
                const View view = renderer.render(camera, pose, {.scene = scene});
                SCOPED_TRACE(testing::Message() << pose.translation.transpose() << " " << name(scene));
                ASSERT_EQ(isRed(view.picture), isWest(pose.translation));
                EXPECT_TRUE(view.report.seesPlace);
            }
        }
    }
}

TEST_F(TwoRooms, AStreamNeverShowsTheOtherRoomWhateverIsLate) {
    write(Knows::Depth);
    for (const LatePolicy late : {LatePolicy::Wait, LatePolicy::Coarse, LatePolicy::Previous}) {
        ViewStream stream(renderer(), camera, {late, 0.2});
        for (int i = 0; i < 60; ++i) {
            const Vector3d place(3.7 + 0.01 * i, 2 + 0.003 * i, 1.2); // through the wall
            if (place.x() > kWall - 0.02 && place.x() < kWall + 0.12) {
                continue;
            }
            const View view = stream.next({bodyFromOptical(), place}, i / 30.0, {.scene = SceneKind::Sphere});
            EXPECT_EQ(isRed(view.picture), isWest(place)) << i;
        }
    }
}

TEST_F(TwoRooms, AnOutlineThatIsRoughByTenCentimetresHidesNothingOfTheSameRoom) {
    write(Knows::RoughPlan);
    const Dataset dataset = Dataset::open(folder.path());
    for (int i = 0; i < 300; ++i) {
        const Vector3d place = somewhere().translation;
        if (place.x() > kWall - 0.02 && place.x() < kWall + 0.12) {
            continue;
        }
        for (std::size_t photo = 0; photo < info.photos.size(); ++photo) {
            const Vector3d& from = info.photos[photo].roomFromPhoto.translation;
            ASSERT_EQ(dataset.sees(photo, place), isWest(from) == isWest(place))
                << from.transpose() << " to " << place.transpose();
        }
    }
}

TEST_F(TwoRooms, WhereNoPhotoSeesTheReportSaysSo) {
    write(Knows::Plan);
    const View view = renderer().render(camera, {bodyFromOptical(), {4.3, 6, 1.2}});
    EXPECT_FALSE(view.report.seesPlace);
}

TEST_F(TwoRooms, AMillimetreOfJitterNeverChangesThePhotos) {
    write(Knows::Depth);
    const Renderer renderer = this->renderer();
    for (const SceneKind scene : {SceneKind::Sphere, SceneKind::Depth, SceneKind::Blend}) {
        for (int place = 0; place < 20; ++place) {
            // On the border between two photos, and on the edge of what some see.
            const Vector3d border(1.25 + 0.5 * (place % 4), random.uniform(0.5, 3.5),
                                  random.uniform(0.5, 1.8));
            ViewStream stream(renderer, camera, {LatePolicy::Wait, 0});
            std::set<std::size_t> photos;
            for (int i = 0; i < 20; ++i) {
                const Vector3d jitter = 0.001 * random.direction();
                const View view = stream.next({bodyFromOptical(), border + jitter}, i, {.scene = scene});
                photos.insert(view.report.photo);
            }
            EXPECT_EQ(photos.size(), 1U) << name(scene) << " " << border.transpose();
        }
    }
}

/// Two photos are 50 cm apart, and the eastern one of them is darker.
class Passage : public TwoRooms {
  protected:
    Passage() {
        write(Knows::Depth);
        paint(info.photos[photoAt(1.5)], {100, 0, 0});
        test::rewriteInfo(folder.path(), info);
    }

    static Rigid3 at(double x) { return {bodyFromOptical(), {x, 1, 1.2}}; }

    std::size_t photoAt(double x) const {
        const auto found =
            std::find_if(info.photos.begin(), info.photos.end(), [x](const DatasetPhoto& photo) {
                return (photo.roomFromPhoto.translation - Vector3d(x, 1, 1.2)).norm() < 1e-6;
            });
        return static_cast<std::size_t>(found - info.photos.begin());
    }

    static int redOf(const View& view) { return view.picture.at(16, 12)[0]; }

    /// The reds of a camera that goes from one to the other, 4 mm a view.
    std::vector<int> redsAlong(SceneKind scene, double passageM) {
        const Renderer renderer = this->renderer();
        ViewStream stream(renderer, camera, {LatePolicy::Wait, 0, passageM});
        std::vector<int> reds;
        for (int i = 0; i < 40; ++i) {
            reds.push_back(redOf(stream.next(at(1.2 + 0.004 * i), i, {.scene = scene})));
        }
        return reds;
    }

    static int largestStep(const std::vector<int>& values) {
        int largest = 0;
        for (std::size_t i = 1; i < values.size(); ++i) {
            largest = std::max(largest, std::abs(values[i] - values[i - 1]));
        }
        return largest;
    }
};

TEST_F(Passage, IsSoftWithDepthAlone) {
    const std::vector<int> reds = redsAlong(SceneKind::Depth, 0.04);
    EXPECT_NEAR(reds.front(), 200, 2);
    EXPECT_NEAR(reds.back(), 100, 2);
    EXPECT_TRUE(std::is_sorted(reds.rbegin(), reds.rend()));
    EXPECT_NEAR(largestStep(reds), 10, 3); // 4 mm of 40
    EXPECT_NEAR(largestStep(redsAlong(SceneKind::Depth, 0)), 100, 3);
    EXPECT_NEAR(largestStep(redsAlong(SceneKind::Sphere, 0.04)), 100, 3);
}

TEST_F(Passage, StandsStillWithTheCameraAndDoesNotDependOnWhatIsSkipped) {
    const Renderer renderer = this->renderer();
    const ViewOptions options{.scene = SceneKind::Depth};
    ViewStream stream(renderer, camera, {LatePolicy::Wait, 0, 0.04});
    ViewStream skipping(renderer, camera, {LatePolicy::Wait, 0, 0.04});
    double x = 1.2;
    for (int i = 0; i < 22; ++i, x += 0.004) {
        stream.next(at(x), i, options);
        skipping.pass(at(x), options);
    }
    const View view = stream.next(at(x), 22, options);
    EXPECT_NEAR(redOf(view), 150, 25); // on the way
    EXPECT_EQ(stream.next(at(x), 23, options).picture, view.picture);
    EXPECT_EQ(skipping.next(at(x), 22, options).picture, view.picture);
}

TEST_F(Passage, ComesFromNoPhotoThatHasNoDepthOrIsLeftOut) {
    const std::size_t bare = photoAt(1.0);
    info.photos[bare].depth.clear();
    test::rewriteInfo(folder.path(), info);
    const Renderer renderer = this->renderer();
    ViewStream stream(renderer, camera, {LatePolicy::Wait, 0, 0.04});
    ASSERT_EQ(stream.next(at(1.0), 0, {.scene = SceneKind::Sphere}).report.photo, bare);
    const ViewOptions depth{.scene = SceneKind::Depth};
    EXPECT_EQ(stream.next(at(1.001), 1, depth).picture, renderer.render(camera, at(1.001), depth).picture);

    ASSERT_EQ(stream.next(at(1.49), 2, depth).report.photo, photoAt(1.5));
    const ViewOptions without{.scene = SceneKind::Depth, .without = photoAt(1.5)};
    EXPECT_EQ(stream.next(at(1.491), 3, without).picture,
              renderer.render(camera, at(1.491), without).picture);
}

TEST_F(Passage, RefusesAWayThatIsNone) {
    const Renderer renderer = this->renderer();
    for (const double passageM : {-0.01, 1.01, std::nan("")}) {
        test::expectError(ErrorKind::InvalidInput, "from 0 to 1 m", [&] {
            ViewStream(renderer, camera, {LatePolicy::Wait, 0, passageM});
        });
    }
}

TEST_F(TwoRooms, AStreamTakesThePhotoThatIsNearerByTwoCentimetres) {
    write(Knows::Plan);
    ViewStream stream(renderer(), camera, {LatePolicy::Wait, 0});
    const auto photoAt = [&](double x) {
        return info.photos[stream.next({bodyFromOptical(), {x, 1, 1.2}}, x).report.photo]
            .roomFromPhoto.translation.x();
    };
    EXPECT_EQ(photoAt(1.0), 1.0);
    EXPECT_EQ(photoAt(1.265), 1.0);
    EXPECT_EQ(photoAt(1.275), 1.5);
    EXPECT_EQ(photoAt(1.235), 1.5);
    EXPECT_EQ(photoAt(1.225), 1.0);
    EXPECT_EQ(photoAt(3.0), 3.0);
}

TEST_F(TwoRooms, OutsideOfWhatWasScannedNothingIsTrusted) {
    write(Knows::Plan);
    const Renderer renderer = this->renderer();
    for (const Vector3d& outside : {Vector3d(-0.5, 1, 1.2), Vector3d(1, 1, 2.7), Vector3d(1, 1, -0.1),
                                    Vector3d(kWall + 0.05, 3, 1.2)}) {
        SCOPED_TRACE(testing::Message() << outside.transpose());
        EXPECT_TRUE(renderer.dataset().isOutside(outside));
        const View view =
            renderer.render(camera, {bodyFromOptical(), outside}, {.scene = {}, .wantsTrust = true});
        EXPECT_TRUE(view.report.isOutside);
        EXPECT_EQ(view.report.trust, 0);
        EXPECT_EQ(view.report.seenShare, 0);
        for (const std::uint8_t flags : view.trust.flags.values()) {
            ASSERT_TRUE(has(flags, PixelFlag::Unsure));
        }
        for (const float error : view.trust.errorPx.values()) {
            ASSERT_EQ(error, HUGE_VALF);
        }
    }
    EXPECT_FALSE(renderer.render(camera, {bodyFromOptical(), {1.1, 1, 1.2}}).report.isOutside);
}

// A camera over a table whose outline is an obstacle is not outside where the photos see free space.
TEST_F(TwoRooms, WhereADepthShowsFreeSpaceAnObstacleIsNotSolid) {
    write(Knows::Depth);
    info.obstacles = {{{1.1, 1.1}, {1.4, 1.1}, {1.4, 1.4}, {1.1, 1.4}}};
    test::rewriteInfo(folder.path(), info);
    EXPECT_FALSE(Dataset::open(folder.path()).isOutside({1.25, 1.25, 1.2}));
    info.photos.erase(info.photos.begin() + 1, info.photos.end());
    info.photos.front().depth.clear();
    test::rewriteInfo(folder.path(), info);
    EXPECT_TRUE(Dataset::open(folder.path()).isOutside({1.25, 1.25, 1.2}));
}

// An outline that leaves out a photo leaves out what was scanned: of one room of two, or wrong.
TEST_F(TwoRooms, WhereAPhotoStandsBeyondTheOutlineItsSightIsNotOutside) {
    write(Knows::Depth);
    info.outline = {{0, 0}, {kWall, 0}, {kWall, 4}, {0, 4}};
    test::rewriteInfo(folder.path(), info);
    const Renderer renderer = this->renderer();
    const Vector3d beyond = info.photos.back().roomFromPhoto.translation;
    EXPECT_FALSE(renderer.dataset().isOutside(beyond));
    EXPECT_FALSE(renderer.dataset().isOutside(beyond - Vector3d(0.3, 0.2, 0.1)));
    EXPECT_EQ(renderer.render(camera, {bodyFromOptical(), beyond}, {.scene = SceneKind::Depth}).report.trust,
              1);
    for (const Vector3d& outside :
         {Vector3d(-0.5, 1, 1.2), Vector3d(kWall + 4.7, 1, 1.2), Vector3d(6, 1, 2.9)}) {
        EXPECT_TRUE(renderer.dataset().isOutside(outside)) << outside.transpose();
    }
    info.photos.back().depth.clear(); // At its own place it knows what it sees.
    test::rewriteInfo(folder.path(), info);
    EXPECT_FALSE(Dataset::open(folder.path()).isOutside(beyond + Vector3d(0.05, 0, 0)));
}

TEST_F(TwoRooms, APhotosUncertaintyLowersTrustByAsMuch) {
    write(Knows::Depth);
    const Rigid3 pose{bodyFromOptical(), info.photos[8].roomFromPhoto.translation};
    const auto report = [&] {
        test::rewriteInfo(folder.path(), info);
        return renderer().render(camera, pose, {.scene = SceneKind::Depth}).report;
    };
    EXPECT_EQ(report().photo, 8U);
    EXPECT_EQ(report().trust, 1);
    const double focal = camera.intrinsics().fx;
    info.photos[8].rotationSigma = RotationSigma{Radians(0.02), Radians(0.02), Radians(0.02)};
    const double turned = report().parallaxPx;
    const double across = std::sqrt(2 * std::numbers::ln2); // the median length of an error in two directions
    EXPECT_NEAR(turned, across * 0.02 * focal, 0.3 * turned); // the lens magnifies off the axis
    info.photos[8].rotationSigma.reset();
    info.photos[8].positionSigmaM = Vector3d::Constant(0.1);
    EXPECT_GT(report().parallaxPx, across * 0.1 / 5 * focal);
    info.photos[8].positionSigmaM.reset();
    for (const char* source : {"metadata", "unknown", "aligned"}) { // the last without a standard deviation
        info.photos[8].rotationSource = source;
        EXPECT_EQ(report().trust, 0) << source;
    }
    info.photos[8].rotationSigma = RotationSigma{Radians(1e-4), Radians(1e-4), Radians(1e-4)};
    EXPECT_GT(report().trust, 0.9);
}

} // namespace
} // namespace spherewalk::render
