// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "seen_room.h"

#include "spherewalk/base/text.h"
#include "spherewalk/place/occupancy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace spherewalk::place {
namespace {

/// Upright walls about a square from -1 to 1 m, a shelf at a height, and its floor where it was seen.
class Mapped : public testing::Test {
  protected:
    void addQuad(const Eigen::Vector3d& corner, const Eigen::Vector3d& along, const Eigen::Vector3d& up) {
        constexpr int kParts = 100;
        for (int i = 0; i < kParts; ++i) {
            for (int k = 0; k < kParts; ++k) {
                const auto first = static_cast<std::uint32_t>(surface.vertices.size());
                for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
                    SurfaceVertex vertex;
                    vertex.pInRoom = corner + (i + a) * along / kParts + (k + b) * up / kParts;
                    surface.vertices.push_back(vertex);
                }
                surface.triangles.push_back({first, first + 1, first + 2});
                surface.triangles.push_back({first, first + 2, first + 3});
            }
        }
    }

    OccupancyGrid grid(const OccupancyOptions& options = {}) const {
        return occupancyOf(surface, {}, options, {});
    }

    /// The value at a place of the room.
    static std::uint8_t at(const OccupancyGrid& grid, double x, double y) {
        const Eigen::Vector2d cell = (Eigen::Vector2d(x, y) - grid.originM) / grid.cellM;
        return *grid.cells.at(static_cast<int>(cell.x()),
                              grid.cells.height() - 1 - static_cast<int>(cell.y()));
    }

    void addRoom() {
        addQuad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
        addQuad({-1, -1.01, 0}, {2, 0, 0}, {0, 0, 2.5});
        addQuad({1.01, -1, 0}, {0, 2, 0}, {0, 0, 2.5});
    }

    Surface surface;
};

} // namespace

TEST_F(Mapped, HasWallsFloorAndWhatNobodySaw) {
    addRoom();
    const OccupancyGrid map = grid();
    EXPECT_EQ(map.cellM, 0.05);
    EXPECT_EQ(at(map, 0.01, -1.01), kOccupied);
    EXPECT_EQ(at(map, 1.01, 0.51), kOccupied);
    EXPECT_EQ(at(map, 0.01, 0.01), kFree);
    EXPECT_EQ(at(map, -0.98, 0.98), kFree);
    EXPECT_EQ(at(map, 1.05, -1.05), kUnknown) << "beyond both walls";
}

TEST_F(Mapped, AsksHowHighAThingIs) {
    addRoom();
    addQuad({-0.5, -0.5, 1}, {0.5, 0, 0}, {0, 0.5, 0});
    addQuad({0.2, 0.2, 0.03}, {0.5, 0, 0}, {0, 0.5, 0});
    EXPECT_EQ(at(grid(), -0.27, -0.27), kOccupied);
    EXPECT_EQ(at(grid(), 0.41, 0.41), kFree) << "a robot drives over a doormat";
    OccupancyOptions low;
    low.mostHeightM = 0.9;
    EXPECT_EQ(at(grid(low), -0.27, -0.27), kFree) << "and below a shelf";
    OccupancyOptions onAPlatform;
    onAPlatform.floorM = -0.1;
    EXPECT_EQ(at(grid(onAPlatform), 0.41, 0.41), kOccupied);
}

TEST_F(Mapped, TakesAFewTrianglesForAMistake) {
    addRoom();
    addQuad({0.51, 0.51, 0.5}, {0.02, 0, 0}, {0, 0, 0.02});
    EXPECT_EQ(at(grid(), 0.52, 0.51), kFree);
    addQuad({0.51, 0.51, 0.5}, {0.03, 0, 0}, {0, 0, 0.04});
    EXPECT_EQ(at(grid(), 0.52, 0.51), kOccupied);
}

TEST(Occupancy, IsFreeWherePhotosLookThroughThoughTheFloorIsNotSeen) {
    const auto hideFloor = [](std::size_t, Image<float, 1>&, MaskImage& sure) {
        for (int y = 110; y < sure.height(); ++y) {
            std::fill(sure.row(y).begin(), sure.row(y).end(), 0);
        }
    };
    const test::SeenRoom room(Eigen::Vector3d::Zero(), hideFloor);
    const OccupancyGrid map = occupancyOf(room.surface(), room.depths, {}, {});
    const auto cells = map.cells.values();
    const auto freeM2 = static_cast<double>(std::count(cells.begin(), cells.end(), kFree)) * 0.0025;
    EXPECT_NEAR(freeM2, 6, 0.8);
    const auto occupiedM2 = static_cast<double>(std::count(cells.begin(), cells.end(), kOccupied)) * 0.0025;
    EXPECT_NEAR(occupiedM2, 10 * 0.1, 0.25) << "walls on the border of two cells";
}

TEST_F(Mapped, IsWrittenAsMapServerReadsIt) {
    addRoom();
    OccupancyGrid map;
    map.originM = {-1.25, 3};
    map.cellM = 0.05;
    map.cells = MaskImage(3, 2);
    map.cells.at(2, 0)[0] = kFree;
    map.cells.at(0, 1)[0] = kUnknown;
    const Bytes pgm = pgmFile(map);
    EXPECT_EQ(textOf(pgm), std::string("P5\n3 2\n255\n") + std::string("\0\0\xFE\xCD\0\0", 6));
    const std::string yaml = mapYaml(map, "map.pgm");
    for (const char* line : {"image: map.pgm\n", "resolution: 0.05\n", "origin: [-1.25, 3, 0]\n",
                             "negate: 0\n", "occupied_thresh: 0.65\n", "free_thresh: 0.196\n"}) {
        EXPECT_THAT(yaml, testing::HasSubstr(line));
    }
    // What map_server computes: unknown lies between both thresholds.
    const double unknown = (255 - kUnknown) / 255.0;
    EXPECT_GT(unknown, 0.196);
    EXPECT_LT(unknown, 0.65);
}

TEST_F(Mapped, TakesTrianglesOfAnySize) {
    for (const Eigen::Vector3d& corner :
         {Eigen::Vector3d(-8, -8, 1), Eigen::Vector3d(8, -8, 1), Eigen::Vector3d(0, 8, 3)}) {
        SurfaceVertex vertex;
        vertex.pInRoom = corner;
        surface.vertices.push_back(vertex);
    }
    surface.triangles.push_back({0, 1, 2});
    EXPECT_EQ(at(grid(), 0, -8 / 3.0), kOccupied) << "where its middle is";
}

TEST_F(Mapped, RefusesWhatCannotBeMapped) {
    test::expectError(ErrorKind::InvalidInput, "no surface", [&] { grid(); });
    addRoom();
    OccupancyOptions options;
    options.cellM = 0;
    test::expectError(ErrorKind::InvalidInput, "a cell must be", [&] { grid(options); });
    options.cellM = 0.05;
    options.mostHeightM = 0.01;
    test::expectError(ErrorKind::InvalidInput, "heights", [&] { grid(options); });
    options.mostHeightM = NAN;
    test::expectError(ErrorKind::InvalidInput, "heights", [&] { grid(options); });
    surface.vertices[0].pInRoom.x() = 1e10;
    test::expectError(ErrorKind::InvalidInput, "larger cells", [&] { grid(); });
}

} // namespace spherewalk::place
