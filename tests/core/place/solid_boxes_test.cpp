// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "seen_room.h"

#include "spherewalk/geometry/equirect.h"
#include "spherewalk/place/solid_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace spherewalk::place {
namespace {

using Boxes = std::vector<Eigen::AlignedBox3d>;
using test::expectError;
using test::SeenRoom;

/// A rectangle of small triangles from a corner along two edges, seen from where they turn left.
void addSheet(Surface& surface, const Eigen::Vector3d& corner, const Eigen::Vector3d& a,
              const Eigen::Vector3d& b) {
    constexpr std::uint32_t kSteps = 30;
    const auto first = static_cast<std::uint32_t>(surface.vertices.size());
    for (std::uint32_t i = 0; i <= kSteps; ++i) {
        for (std::uint32_t k = 0; k <= kSteps; ++k) {
            SurfaceVertex vertex;
            vertex.pInRoom = corner + a * i / kSteps + b * k / kSteps;
            surface.vertices.push_back(vertex);
        }
    }
    for (std::uint32_t i = 0; i < kSteps; ++i) {
        for (std::uint32_t k = 0; k < kSteps; ++k) {
            const std::uint32_t at = first + i * (kSteps + 1) + k;
            surface.triangles.push_back({at, at + kSteps + 1, at + 1});
            surface.triangles.push_back({at + 1, at + kSteps + 1, at + kSteps + 2});
        }
    }
}

/// Top and sides of a box.
void addBox(Surface& surface, const Eigen::Vector3d& least, const Eigen::Vector3d& size) {
    const Eigen::Vector3d x(size.x(), 0, 0);
    const Eigen::Vector3d y(0, size.y(), 0);
    const Eigen::Vector3d z(0, 0, size.z());
    addSheet(surface, least + z, x, y);
    addSheet(surface, least, x, z);
    addSheet(surface, least + y, z, x);
    addSheet(surface, least, z, y);
    addSheet(surface, least + x, y, z);
}

bool isIn(const Boxes& boxes, const Eigen::Vector3d& point) {
    return std::any_of(boxes.begin(), boxes.end(),
                       [&](const Eigen::AlignedBox3d& box) { return box.contains(point); });
}

/// Photos of a room, in which the front of a cabinet at x = 0.5 m mirrors all that is before it.
std::vector<SeenDepth> withAMirror(const SeenRoom& room, bool knowTheRoom) {
    const render::RoomShape& shape = room.shape;
    render::RoomShape mirrored = shape;
    mirrored.outline = {{-2, 0}, {3, 0}, {3, 2}, {-2, 2}};
    const Eigen::AlignedBox3d cabinet(Eigen::Vector3d(0, 0.5, 0), Eigen::Vector3d(0.5, 1.5, 0.6));
    std::vector<SeenDepth> depths;
    for (const SeenDepth& photo : room.depths) {
        const Rigid3& pose = photo.roomFromPhoto();
        const EquirectSize size{1024, 512};
        Image<float, 1> inverse(size.width, size.height);
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                const Eigen::Vector3d ray = pose.rotation * direction(size, Eigen::Vector2d(x, y));
                const double frontM = (0.5 - pose.translation.x()) / ray.x();
                const bool isFront = frontM > 0 && cabinet.contains(pose.translation + frontM * ray);
                *inverse.at(x, y) = static_cast<float>(
                    render::inverseDistance(isFront ? mirrored : shape, pose.translation, ray));
            }
        }
        depths.emplace_back(render::DepthMap(inverse), pose, LensPair{},
                            std::numeric_limits<double>::infinity(), knowTheRoom ? &shape : nullptr);
    }
    return depths;
}

Surface tableAndBox() {
    Surface things;
    addBox(things, {1, 0.6, 0.7}, {1.2, 0.8, 0.06});
    addBox(things, {1.51, 0.93, 0}, {0.1, 0.1, 0.7});
    addBox(things, {0.3, 1.2, 0}, {0.5, 0.33, 0.6});
    return things;
}

} // namespace

TEST(SolidBoxes, OfABoxAreTheBox) {
    for (const Eigen::Vector3d& origin : {Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(1e6, -2e6, 0.5)}) {
        Surface box;
        addBox(box, origin, {0.8, 0.4, 0.6});
        const Boxes boxes = solidBoxes(box, {}, {0.04, origin.z()});
        ASSERT_EQ(boxes.size(), 1U);
        EXPECT_LT((boxes[0].min() - origin).norm(), 1e-6);
        EXPECT_LT((boxes[0].sizes() - Eigen::Vector3d(0.8, 0.4, 0.6)).norm(), 1e-6);
    }
}

TEST(SolidBoxes, HaveTheirFacesWithinThreeQuartersOfACellOfTheSurface) {
    for (const double aside : {0.0, 0.011, 0.02, 0.03}) {
        Surface box;
        addBox(box, {1 + aside, 1, 0}, {0.8, 0.4, 0.6});
        double least = HUGE_VAL;
        for (const Eigen::AlignedBox3d& one : solidBoxes(box, {}, {0.04, 0})) {
            least = std::min(least, one.min().x());
        }
        EXPECT_NEAR(least, 1 + aside, 0.0301);
    }
}

TEST(SolidBoxes, CloseSidesThatNobodySaw) {
    Surface top;
    addSheet(top, {1, 1, 0.6}, {0.8, 0, 0}, {0, 0.4, 0});
    const Boxes boxes = solidBoxes(top, {}, {});
    EXPECT_TRUE(isIn(boxes, {1.4, 1.2, 0.3}));
    EXPECT_TRUE(isIn(boxes, {1.02, 1.02, 0.01})) << "down to the floor";
    EXPECT_FALSE(isIn(boxes, {1.4, 1.2, 0.7}));
}

TEST(SolidBoxes, LeaveFreeWhatPhotosLookThrough) {
    const SeenRoom empty;
    Surface board;
    addSheet(board, {1, 0.7, 0.91}, {0.8, 0, 0}, {0, 0.6, 0});
    const Boxes boxes = solidBoxes(board, empty.depths, {});
    EXPECT_TRUE(isIn(boxes, {1.4, 1, 0.9})) << "the board itself";
    EXPECT_FALSE(isIn(boxes, {1.4, 1, 0.8}));
    EXPECT_FALSE(isIn(boxes, {1.4, 1, 0.02})) << "nor what is hidden below";
}

TEST(SolidBoxes, CloseWhatMirrorsTheRoomDownToTheFloor) {
    const SeenRoom room({0, 0, 0}, {}, 5);
    Surface top;
    addSheet(top, {0.1, 0.6, 0.6}, {0.4, 0, 0}, {0, 0.8, 0});
    EXPECT_FALSE(isIn(solidBoxes(top, withAMirror(room, false), {}), {0.46, 1, 0.3}));
    const Boxes boxes = solidBoxes(top, withAMirror(room, true), {});
    EXPECT_TRUE(isIn(boxes, {0.46, 1, 0.5})) << "photos show something behind the wall there";
    EXPECT_TRUE(isIn(boxes, {0.46, 1, 0.06})) << "photos show the floor there, before the wall";
    EXPECT_FALSE(isIn(boxes, {0.6, 1, 0.3}));
}

TEST(ClosingBoxes, StandBehindTheSurfaceAndOnTheFloor) {
    for (const double aside : {0.0, 0.011, 0.02, 0.03}) {
        Surface box;
        addBox(box, {1 + aside, 1, 0}, {0.8, 0.4, 0.6});
        Eigen::AlignedBox3d around;
        for (const Eigen::AlignedBox3d& one : closingBoxes(box, {}, {0.04, 0})) {
            around.extend(one);
        }
        EXPECT_GT(around.min().x(), 1 + aside - 0.0101);
        EXPECT_LT(around.max().x(), 1.8 + aside + 0.0101);
        EXPECT_EQ(around.min().z(), 0);
        EXPECT_GT(around.volume(), 0.8 * 0.8 * 0.4 * 0.6);
    }
}

TEST(ClosingBoxes, KeepThinThingsWhole) {
    for (const double edgeM : {0.04, 0.08}) {
        Surface post;
        addBox(post, {1, 1, 0}, {edgeM, 0.04, 0.6});
        const Boxes boxes = closingBoxes(post, {}, {0.04, 0});
        ASSERT_EQ(boxes.size(), 1U);
        EXPECT_LT((boxes[0].min() - Eigen::Vector3d(1, 1, 0)).norm(), 1e-6);
        EXPECT_LT((boxes[0].sizes() - Eigen::Vector3d(edgeM, 0.04, 0.6)).norm(), 1e-6);
    }
}

TEST(ClosingBoxes, LeaveOutWhatPhotosLookThrough) {
    const SeenRoom empty;
    Surface post;
    addBox(post, {1.4, 0.9, 0}, {0.04, 0.04, 1});
    EXPECT_TRUE(isIn(closingBoxes(post, {}, {0.02, 0}), {1.42, 0.92, 0.5}));
    EXPECT_TRUE(closingBoxes(post, empty.depths, {0.02, 0}).empty());
    const SeenRoom room({0, 0, 0}, {}, 5);
    Surface top;
    addSheet(top, {0.1, 0.6, 0.6}, {0.4, 0, 0}, {0, 0.8, 0});
    EXPECT_TRUE(isIn(closingBoxes(top, withAMirror(room, true), {}), {0.46, 1, 0.3})) << "but not mirrors";
}

TEST(SolidBoxes, CloseASurfaceFromOutside) {
    Surface surface;
    addBoxes(surface, std::vector{Eigen::AlignedBox3d(Eigen::Vector3d(1, 2, 0), Eigen::Vector3d(2, 4, 3))});
    double volumeM3 = 0;
    for (const auto& triangle : surface.triangles) {
        const Eigen::Vector3d area = surface.areaVector(triangle);
        volumeM3 += surface.middle(triangle).dot(area) / 3;
        for (const std::uint32_t corner : triangle) {
            EXPECT_GT(surface.vertices[corner].normal.cast<double>().dot(area), 0);
        }
    }
    EXPECT_NEAR(volumeM3, 6, 1e-9);
    EXPECT_NEAR(surface.areaM2(), 22, 1e-9);
}

TEST(SolidBoxes, DoNotOverlap) {
    const Boxes boxes = solidBoxes(tableAndBox(), {}, {});
    EXPECT_GT(boxes.size(), 2U);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const Eigen::Vector3d both =
                boxes[i].max().cwiseMin(boxes[k].max()) - boxes[i].min().cwiseMax(boxes[k].min());
            EXPECT_LT(both.minCoeff(), 1e-9) << i << " " << k;
        }
    }
}

TEST(SolidBoxes, AreTheSameForAnyNumberOfThreads) {
    const SeenRoom empty;
    const Boxes one = solidBoxes(tableAndBox(), empty.depths, {0.04, 0, 1});
    const Boxes three = solidBoxes(tableAndBox(), empty.depths, {0.04, 0, 3});
    ASSERT_EQ(one.size(), three.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one[i].min(), three[i].min());
        EXPECT_EQ(one[i].max(), three[i].max());
    }
}

TEST(SolidBoxes, OfNothingAreNoneAndOptionsAreChecked) {
    EXPECT_TRUE(solidBoxes({}, {}, {}).empty());
    for (const double wrong : {0.0, -1.0, 5.0, std::numeric_limits<double>::quiet_NaN()}) {
        expectError(ErrorKind::InvalidInput, "cell", [&] { solidBoxes({}, {}, {wrong}); });
    }
    Surface wide;
    addSheet(wide, {0, 0, 0}, {1000, 0, 0}, {0, 1000, 0});
    expectError(ErrorKind::InvalidInput, "larger", [&] { solidBoxes(wide, {}, {0.01}); });
}

} // namespace spherewalk::place
