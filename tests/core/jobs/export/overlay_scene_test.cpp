// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/view_geometry.h"

#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/practice/practice_room.h"
#include "spherewalk/render/overlay.h"
#include "spherewalk/scene/room_fit.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <random>

namespace spherewalk {

using practice::Content;
using practice::PracticeObject;
using practice::PracticeRoom;
using practice::PracticeRoomOptions;
using render::Overlay;

namespace {

/// The camera at (2.1, 1.9, 1.25) m looks down on the practice room's table, whose top is at 0.75 m.
const Rigid3 kPose{rotation({Radians(-0.38), Radians(0.27), Radians(0)}) * bodyFromOptical(),
                   {2.1, 1.9, 1.25}};

PracticeRoom roomWith(std::vector<PracticeObject> objects) {
    PracticeRoomOptions options;
    options.objects = std::move(objects);
    return PracticeRoom(options);
}

/// Beyond the table and behind what stands on it: half of it is hidden.
PracticeObject boxBehindTheTable() {
    return {PracticeObject::Shape::Box, {4.55, 0.95, 0.7}, {0.16, 0.12, 0.45}, Radians(0.4), {40, 90, 200}};
}

CameraIntrinsics pinhole(int width, int height) {
    return CameraIntrinsics::pinhole(width, height, 1.0);
}

CameraIntrinsics plumbBob() {
    CameraIntrinsics camera = pinhole(640, 480);
    camera.lens = LensModel::PlumbBob;
    camera.distortion = {-0.28, 0.07, 0.0012, -0.0008, 0.01};
    return camera;
}

CameraIntrinsics equidistant() {
    CameraIntrinsics camera = pinhole(640, 480);
    camera.lens = LensModel::Equidistant;
    camera.distortion = {-0.02, 0.004, -0.001, 0.0002};
    camera.fx = camera.fy = 420;
    return camera;
}

/// The same camera with n x n pixels in the place of each.
CameraIntrinsics refined(CameraIntrinsics camera, int n) {
    camera.width *= n;
    camera.height *= n;
    camera.fx *= n;
    camera.fy *= n;
    camera.cx = n * camera.cx + 0.5 * (n - 1);
    camera.cy = n * camera.cy + 0.5 * (n - 1);
    return camera;
}

/// What a simulator gives: colours with antialiased borders, 4 x 4 samples a pixel of 640, and depths at the
/// pixels' centres.
Overlay simulated(const PracticeRoom& room, const CameraIntrinsics& intrinsics) {
    const int samples = 4 * 640 / intrinsics.width;
    const CameraModel camera(intrinsics);
    const CameraModel fine(refined(intrinsics, samples));
    const RgbImage colours = room.view(fine, kPose, {Content::Objects, 0});
    const DepthImage depths = room.viewDepth(fine, kPose, {Content::Objects, 0});
    Overlay overlay{RgbaImage(camera.width(), camera.height()), render::Alpha::Premultiplied,
                    room.viewDepth(camera, kPose, {Content::Objects, 0}), intrinsics,
                    room.viewDepth(camera, kPose, {Content::Room, 0})};
    for (int y = 0; y < camera.height(); ++y) {
        for (int x = 0; x < camera.width(); ++x) {
            std::array<int, 4> sum{};
            for (int k = 0; k < samples * samples; ++k) {
                const int i = x * samples + k % samples;
                const int j = y * samples + k / samples;
                if (std::isfinite(*depths.at(i, j))) {
                    for (std::size_t c = 0; c < 3; ++c) {
                        sum[c] += colours.at(i, j)[c];
                    }
                    sum[3] += 255;
                }
            }
            for (std::size_t c = 0; c < 4; ++c) {
                overlay.picture.at(x, y)[c] =
                    static_cast<std::uint8_t>((sum[c] + samples * samples / 2) / (samples * samples));
            }
        }
    }
    return overlay;
}

/// A view of the room with the overlay laid in, and the truth about it.
class Scene {
  public:
    Scene(const PracticeRoom& room, const CameraIntrinsics& intrinsics)
        : m_camera(intrinsics),
          m_room(room.view(m_camera, kPose, {Content::Room, 0})),
          truth(room.view(m_camera, kPose)),
          m_objectDepth(room.viewDepth(m_camera, kPose, {Content::Objects, 0})),
          m_roomDepth(room.viewDepth(m_camera, kPose, {Content::Room, 0})) {}

    void compose(const Overlay& overlay, const render::ComposeOptions& options = {},
                 const DepthImage& viewDepth = {}) {
        picture = m_room;
        m_composer.compose({&overlay, 1}, m_camera, viewDepth, options, m_pool, picture, &shown);
    }

    bool isObject(int x, int y) const { return std::isfinite(*m_objectDepth.at(x, y)); }

    bool isVisible(int x, int y) const { return *m_objectDepth.at(x, y) < *m_roomDepth.at(x, y); }

    /// The share of the object's pixels for which this holds.
    template <class Law>
    double share(Law&& law) const {
        int objects = 0;
        int holding = 0;
        for (int y = 0; y < shown.height(); ++y) {
            for (int x = 0; x < shown.width(); ++x) {
                objects += isObject(x, y) ? 1 : 0;
                holding += isObject(x, y) && law(x, y) ? 1 : 0;
            }
        }
        EXPECT_GT(objects, 1000);
        return static_cast<double>(holding) / objects;
    }

    double rightShare() const {
        return share([&](int x, int y) { return isVisible(x, y) == (*shown.at(x, y) >= 128); });
    }

    /// Between the composed and the true picture, at most two pixels from the object, in dB.
    double likeness() const {
        double sum = 0;
        int count = 0;
        for (int y = 2; y + 2 < shown.height(); ++y) {
            for (int x = 2; x + 2 < shown.width(); ++x) {
                bool isNear = false;
                for (int k = 0; k < 25 && !isNear; ++k) {
                    isNear = isObject(x + k % 5 - 2, y + k / 5 - 2);
                }
                for (int c = 0; c < 3 && isNear; ++c) {
                    const double difference = picture.at(x, y)[c] - truth.at(x, y)[c];
                    sum += difference * difference;
                    ++count;
                }
            }
        }
        return 10 * std::log10(255.0 * 255.0 * count / sum);
    }

    /// Below the folder in which the test was built.
    void save(const std::string& file) const {
        const std::filesystem::path folder = SPHEREWALK_TEST_PICTURES;
        std::filesystem::create_directories(folder);
        photo::writePng(folder / (file + ".png"), picture);
        photo::writePng(folder / (file + "_truth.png"), truth);
    }

    const CameraModel& camera() const { return m_camera; }

    WorkerPool& pool() { return m_pool; }

  private:
    CameraModel m_camera;
    RgbImage m_room;

  public:
    RgbImage truth;
    RgbImage picture;
    MaskImage shown;

  private:
    DepthImage m_objectDepth;
    DepthImage m_roomDepth;
    render::Composer m_composer;
    WorkerPool m_pool;
};

} // namespace

TEST(OverlayScene, AnObjectHalfBehindATableIsRightlyShownThroughAnyLens) {
    struct Case {
        std::string name;
        CameraIntrinsics view;
        CameraIntrinsics simulator;
        double leastLikenessDb; // what was measured, and 1 dB less
    };

    const std::array<Case, 5> cases{{
        {"pinhole", pinhole(640, 480), pinhole(640, 480), 40},
        {"plumb_bob", plumbBob(), CameraIntrinsics::pinhole(640, 480, 1.25), 30},
        {"plumb_bob_2x", plumbBob(), CameraIntrinsics::pinhole(1280, 960, 1.25), 38},
        {"equidistant", equidistant(), CameraIntrinsics::pinhole(640, 480, 1.6), 30},
        {"equidistant_2x", equidistant(), CameraIntrinsics::pinhole(1280, 960, 1.6), 38},
    }};
    const PracticeRoom room = roomWith({boxBehindTheTable()});
    for (const Case& one : cases) {
        Scene scene(room, one.view);
        scene.compose(simulated(room, one.simulator));
        scene.save("half_behind_table_" + one.name);
        const double visible = scene.share([&](int x, int y) { return scene.isVisible(x, y); });
        EXPECT_TRUE(visible > 0.4 && visible < 0.6) << visible << " is not half";
        RecordProperty(one.name + "_right", text(scene.rightShare()));
        RecordProperty(one.name + "_db", text(scene.likeness()));
        EXPECT_GE(scene.rightShare(), 0.99) << one.name;
        EXPECT_GE(scene.likeness(), one.leastLikenessDb) << one.name;
    }
}

TEST(OverlayScene, SoftEdgesAreNearerToTheTruth) {
    const PracticeRoom room = roomWith({boxBehindTheTable()});
    Scene scene(room, pinhole(640, 480));
    const Overlay overlay = simulated(room, pinhole(640, 480));
    scene.compose(overlay, {0.005, 0.002, render::Edges::Hard, 0});
    const double hard = scene.likeness();
    scene.compose(overlay);
    RecordProperty("hard_db", text(hard));
    RecordProperty("soft_db", text(scene.likeness()));
    EXPECT_GT(scene.likeness(), hard);
}

TEST(OverlayScene, WhatStandsOnATableOrAgainstAWallDoesNotFade) {
    const PracticeRoom room = roomWith(
        {{PracticeObject::Shape::Box, {3.55, 1.2, 0.85}, {0.08, 0.08, 0.1}, Radians(0.2), {200, 60, 40}},
         {PracticeObject::Shape::Box, {4.9, 1.9, 1.2}, {0.1, 0.2, 0.3}, Radians(0), {60, 160, 60}}});
    Scene scene(room, pinhole(640, 480));
    scene.compose(simulated(room, pinhole(640, 480)));
    scene.save("standing");
    RecordProperty("right", text(scene.rightShare()));
    EXPECT_GE(scene.rightShare(), 0.999);
    // What is seen and has only seen neighbours of its own is all there.
    EXPECT_EQ(scene.share([&](int x, int y) {
        bool isInside = x > 0 && y > 0 && x + 1 < 640 && y + 1 < 480;
        for (int k = 0; k < 9 && isInside; ++k) {
            isInside =
                scene.isObject(x + k % 3 - 1, y + k / 3 - 1) && scene.isVisible(x + k % 3 - 1, y + k / 3 - 1);
        }
        return isInside && *scene.shown.at(x, y) != 255;
    }),
              0);
}

// Depths that are off by millimetres, as 16-bit pictures and simple models of a room are, and a sheet of half
// a millimetre on the table: without a tolerance it is full of holes.
TEST(OverlayScene, TheToleranceCoversWhatDepthsAreOffBy) {
    const PracticeRoom room = roomWith({{PracticeObject::Shape::Box,
                                         {3.61, 1.3, 0.75025},
                                         {0.1, 0.1, 0.00025},
                                         Radians(0.2),
                                         {200, 60, 40}}});
    Scene scene(room, pinhole(640, 480));
    Overlay overlay = simulated(room, pinhole(640, 480));
    std::mt19937 random(7);
    std::normal_distribution<float> off(0, 0.002F);
    for (float& depth : overlay.roomDepth.values()) {
        depth += off(random);
    }
    scene.compose(overlay, {0, 0, render::Edges::Soft, 0});
    const double without = scene.rightShare();
    scene.compose(overlay);
    RecordProperty("without", text(without));
    RecordProperty("with", text(scene.rightShare()));
    EXPECT_LT(without, 0.95);
    EXPECT_GE(scene.rightShare(), 0.99);
}

TEST(OverlayScene, AWideToleranceShowsWhatIsHidden) {
    const PracticeRoom room = roomWith({boxBehindTheTable()});
    Scene scene(room, pinhole(640, 480));
    const Overlay overlay = simulated(room, pinhole(640, 480));
    double last = 1;
    for (const double toleranceM : {0.0, 0.005, 0.02, 0.05, 0.1, 0.2}) {
        scene.compose(overlay, {toleranceM, 0, render::Edges::Soft, 0});
        RecordProperty(text("right_", toleranceM), text(scene.rightShare()));
        EXPECT_LE(scene.rightShare(), last + 0.001) << toleranceM;
        last = scene.rightShare();
    }
    EXPECT_LT(last, 0.97);
}

// The sphere knows nothing of tables: it hides what is outside of it, wherever that is, and nothing else.
TEST(OverlayScene, TheSpheresOwnDepthHidesWhatIsOutsideOfIt) {
    const Rigid3 photo{Eigen::Quaterniond::Identity(), {2.05, 1.95, 1.25}};
    survey::Room empty;
    empty.outline = {{0, 0}, {5, 0}, {5, 4}, {0, 4}};
    empty.ceilingM = 2.6;
    const double radius = scene::sphereRadius(empty, {photo.translation}).value();
    const PracticeRoom room =
        roomWith({boxBehindTheTable(),
                  {PracticeObject::Shape::Sphere, {2.9, 1.4, 0.95}, {0.15, 0.15, 0.15}, {}, {220, 120, 30}}});
    Scene scene(room, equidistant());
    Overlay overlay = simulated(room, CameraIntrinsics::pinhole(1280, 960, 1.6));
    overlay.roomDepth = {};
    const render::PixelRays rays(scene.camera(), scene.pool());
    const DepthImage depth = render::viewDepth(
        {rays, kPose, photo, {5376, 2688}, render::SceneKind::Sphere, radius}, scene.pool());
    scene.compose(overlay, {}, depth);
    scene.save("sphere");
    RecordProperty("radius_m", text(radius));
    RecordProperty("right", text(scene.rightShare()));
    const DepthImage objects = room.viewDepth(scene.camera(), kPose, {Content::Objects, 0});
    const double asTheSphereSays = scene.share([&](int x, int y) {
        const Eigen::Vector3d ray = *scene.camera().ray(Eigen::Vector2d(x, y));
        const Eigen::Vector3d pInRoom = kPose * Eigen::Vector3d(ray * (*objects.at(x, y) / ray.z()));
        return ((pInRoom - photo.translation).norm() < radius) == (*scene.shown.at(x, y) >= 128);
    });
    RecordProperty("as_the_sphere_says", text(asTheSphereSays));
    EXPECT_GE(asTheSphereSays, 0.99);
}

} // namespace spherewalk
