// SPDX-License-Identifier: GPL-3.0-or-later
#include "seen_room.h"

#include "spherewalk/geometry/equirect.h"

#include <gtest/gtest.h>

namespace spherewalk::place {
namespace {

/// Two squares in the plane z = 1, of 4 and of 1 square metre, far from each other.
Surface squares() {
    Surface surface;
    for (const auto& [left, side] : {std::pair{0.0, 2.0}, {10.0, 1.0}}) {
        const auto first = static_cast<std::uint32_t>(surface.vertices.size());
        for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
            surface.vertices.push_back({{left + side * x, side * y, 1}});
        }
        surface.triangles.push_back({first, first + 1, first + 2});
        surface.triangles.push_back({first, first + 2, first + 3});
    }
    return surface;
}

} // namespace

TEST(Surface, KnowsItsArea) {
    EXPECT_NEAR(squares().areaM2(), 5, 1e-12);
}

TEST(Surface, HasNormalsOnTheSideFromWhichItsTrianglesTurnLeft) {
    Surface surface = squares();
    surface.estimateNormals();
    for (const SurfaceVertex& vertex : surface.vertices) {
        EXPECT_NEAR((vertex.normal - Eigen::Vector3f::UnitZ()).norm(), 0, 1e-6);
    }
}

TEST(Surface, DropsSmallPartsAndTheirVertices) {
    Surface surface = squares();
    surface.dropSmallParts(1.5);
    EXPECT_EQ(surface.vertices.size(), 4U);
    ASSERT_EQ(surface.triangles.size(), 2U);
    EXPECT_NEAR(surface.areaM2(), 4, 1e-12);
    surface.dropSmallParts(5);
    EXPECT_TRUE(surface.vertices.empty());
}

TEST(Surface, KeepsTheTrianglesThatAreWanted) {
    Surface surface = squares();
    surface.keepTriangles([](std::size_t i) { return i == 3; });
    ASSERT_EQ(surface.vertices.size(), 3U);
    EXPECT_EQ(surface.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}}));
    EXPECT_EQ(surface.vertices[0].pInRoom.x(), 10);
}

TEST(SurfaceNets, FaceThePhotos) {
    const test::SeenRoom room;
    const Surface surface = room.surface();
    const Eigen::Vector3d middle(1.5, 1, 1.25);
    for (const SurfaceVertex& vertex : surface.vertices) {
        const Eigen::Vector3f inwards = (middle - vertex.pInRoom).cast<float>();
        EXPECT_GT(vertex.normal.dot(inwards), 0) << vertex.pInRoom.transpose();
        EXPECT_NEAR(vertex.normal.norm(), 1, 1e-5);
    }
}

/// A board of 20 cm, a metre away, before a wall at 3 m.
TEST(SurfaceNets, AreAsWideAsAThingBeforeAWall) {
    constexpr EquirectSize kSize{4096, 2048};
    constexpr double kWidthM = 0.2;
    constexpr double kVoxelM = 0.02;
    double sum = 0;
    constexpr int kPlaces = 4;
    for (int i = 0; i < kPlaces; ++i) {
        const double asideM = kVoxelM * (i + 0.5) / kPlaces;
        Image<float, 1> inverse(kSize.width, kSize.height);
        MaskImage sure(kSize.width, kSize.height);
        for (int y = kSize.height * 3 / 8; y < kSize.height * 5 / 8; ++y) {
            for (int x = kSize.width * 3 / 8; x < kSize.width * 5 / 8; ++x) {
                const Eigen::Vector3d ray = direction(kSize, Eigen::Vector2d(x, y));
                const Eigen::Vector2d at = ray.tail<2>() / ray.x();
                const bool isThing = std::abs(at.x() - asideM) < kWidthM / 2 && std::abs(at.y()) < 0.1;
                *inverse.at(x, y) = static_cast<float>(ray.x() / (isThing ? 1 : 3));
                *sure.at(x, y) = 1;
            }
        }
        const std::vector<SeenDepth> photos = {
            {render::DepthMap(inverse, sure), Rigid3{}, LensPair{}, std::numeric_limits<double>::infinity()}};
        Eigen::AlignedBox3d around;
        for (const SurfaceVertex& vertex : surfaceOf(fused(photos, {kVoxelM}, noProgress(), {})).vertices) {
            if (std::abs(vertex.pInRoom.x() - 1) < 2 * kVoxelM && std::abs(vertex.pInRoom.z()) < 0.05) {
                around.extend(vertex.pInRoom);
            }
        }
        sum += around.sizes().y();
    }
    EXPECT_NEAR(sum / kPlaces, 1.03 * kWidthM, 0.006) << "the photo hides what is wider behind it";
}

TEST(SurfaceNets, HaveNoCracksInsideOfARoom) {
    const Surface surface = test::SeenRoom().surface();
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& triangle : surface.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [a, b] = std::minmax(triangle[i], triangle[(i + 1) % 3]);
            ++edges[{a, b}];
        }
    }
    std::size_t open = 0;
    for (const auto& [edge, count] : edges) {
        open += count == 1 ? 1 : 0;
    }
    EXPECT_LT(open, edges.size() / 200) << "a room seen from inside is closed";
}

namespace {

/// Red grows along the room's x axis, green along y, blue upwards.
RgbImage directionsFrom(const Rigid3& roomFromPhoto) {
    const EquirectSize size{512, 256};
    RgbImage picture(size.width, size.height);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const Eigen::Vector3d d = roomFromPhoto.rotation * direction(size, Eigen::Vector2d(x, y));
            for (int c = 0; c < 3; ++c) {
                picture.at(x, y)[c] = static_cast<std::uint8_t>(std::lround(100 + 80 * d[c]));
            }
        }
    }
    return picture;
}

} // namespace

TEST(SurfacePainter, GivesAPlaceTheColourThatThePhotoShowsThere) {
    const test::SeenRoom room(Eigen::Vector3d::Zero(), {}, 1);
    Surface surface = room.surface();
    SurfacePainter painter(surface, test::SeenRoom::kVoxelM);
    const Rigid3& pose = room.depths[0].roomFromPhoto();
    painter.add(room.depths[0], directionsFrom(pose));
    painter.finish();
    std::size_t shown = 0;
    for (const SurfaceVertex& vertex : surface.vertices) {
        if (vertex.photos == 0) {
            continue;
        }
        ++shown;
        const Eigen::Vector3d d = (vertex.pInRoom - pose.translation).normalized();
        EXPECT_NEAR(vertex.colour[0], 100 + 80 * d.x(), 8);
        EXPECT_NEAR(vertex.colour[1], 100 + 80 * d.y(), 8);
        EXPECT_NEAR(vertex.colour[2], 100 + 80 * d.z(), 8);
    }
    EXPECT_GT(shown, surface.vertices.size() - 20) << "all but corners";
}

TEST(SurfacePainter, LeavesGreyWhatNoPhotoShows) {
    const test::SeenRoom all;
    Surface surface = all.surface();
    const auto hideLowerHalf = [](std::size_t, Image<float, 1>&, MaskImage& sure) {
        for (int y = sure.height() / 2; y < sure.height(); ++y) {
            std::fill(sure.row(y).begin(), sure.row(y).end(), 0);
        }
    };
    const test::SeenRoom upper(Eigen::Vector3d::Zero(), hideLowerHalf, 1);
    RgbImage red(64, 32);
    for (std::size_t i = 0; i < red.values().size(); i += 3) {
        red.values()[i] = 200;
    }
    SurfacePainter painter(surface, test::SeenRoom::kVoxelM);
    painter.add(upper.depths[0], red);
    painter.finish();
    for (const SurfaceVertex& vertex : surface.vertices) {
        const bool isAbove = vertex.pInRoom.z() > 1.5;
        if (isAbove || vertex.pInRoom.z() < 0.9) {
            EXPECT_EQ(vertex.colour, (isAbove ? std::array<std::uint8_t, 3>{200, 0, 0}
                                              : std::array<std::uint8_t, 3>{128, 128, 128}));
        }
    }
}

} // namespace spherewalk::place
