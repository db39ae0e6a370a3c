// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"
#include "temporary_folder.h"
#include "test_dataset.h"

#include "spherewalk/practice/practice_room.h"
#include "spherewalk/render/dataset.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace spherewalk {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kLens = 1.2;

practice::PracticeRoom flat() {
    practice::PracticeRoomOptions options;
    options.sizeM = {8, 6, 2.6};
    options.style = practice::RoomStyle::Flat;
    return practice::PracticeRoom(options);
}

/// Photos every 60 cm of two rooms and a corridor, but not closer than 25 cm to walls and furniture.
class PracticeFlat : public testing::Test {
  protected:
    PracticeFlat() {
        std::vector<Rigid3> poses;
        for (double y = 0.4; y < 6; y += 0.6) {
            for (double x = 0.4; x < 8; x += 0.6) {
                if (isFree({x, y}, 0.25)) {
                    poses.push_back({Eigen::Quaterniond::Identity(), {x, y, kLens}});
                }
            }
        }
        info = test::writeTestDataset(
            folder.path(), poses, [](const Vector3d&) { return Vector3d(9, 9, 9); }, 32, 2.0);
        info.ceilingM = plan.ceilingM;
    }

    bool isFree(const Vector2d& place, double marginM) const {
        return contains(plan.outline, place) && distanceToEdge(plan.outline, place) > marginM &&
               std::none_of(plan.obstacles.begin(), plan.obstacles.end(), [&](const Polygon& obstacle) {
                   return contains(obstacle, place) || distanceToEdge(obstacle, place) < marginM;
               });
    }

    void writePlan() {
        info.outline = plan.outline;
        info.obstacles = plan.obstacles;
        test::rewriteInfo(folder.path(), info);
    }

    void writeDepths() {
        std::filesystem::create_directories(folder.path() / "depth");
        for (render::DatasetPhoto& photo : info.photos) {
            const DepthImage range = room.sphericalRange(photo.roomFromPhoto, {256, 128});
            Image<float, 1> inverse(range.width(), range.height());
            std::transform(range.values().begin(), range.values().end(), inverse.values().begin(),
                           [](float distance) { return 1 / distance; });
            photo.depth = "depth/" + std::filesystem::path(photo.file).stem().string() + ".pgm";
            writeFile(folder.path() / photo.depth, render::DepthMap(std::move(inverse)).serialised());
        }
        test::rewriteInfo(folder.path(), info);
    }

    /// Whether the true room hides a photo from a place, also where the line passes up to 10 cm beside.
    bool isHidden(const Vector3d& photo, const Vector3d& place) const {
        const Vector3d way = photo - place;
        const Vector3d across = 0.1 * Vector3d(-way.y(), way.x(), 0).normalized();
        const auto isBlocked = [&](const Vector3d& knee) {
            const auto meets = [&](const Vector3d& from, const Vector3d& to) {
                return room.cast(from, to - from, 0.001).rangeM < (to - from).norm() - 0.01;
            };
            return meets(place, knee) || meets(knee, photo);
        };
        for (const double share : {0.5, 0.25, 0.75}) {
            for (const double side : {0.0, 1.0, -1.0}) {
                if (!isBlocked(place + share * way + side * across)) {
                    return false;
                }
            }
        }
        return true;
    }

    /// Places on both sides of the inner walls, in the doorways and anywhere.
    std::vector<Vector3d> places() {
        std::vector<Vector3d> result;
        test::Random random(92);
        const auto add = [&](double x, double y) {
            if (isFree({x, y}, 0.04)) {
                result.emplace_back(x, y, random.uniform(0.4, 1.8));
            }
        };
        while (result.size() < 50) {
            add(random.uniform(0, 8),
                random.uniform(0, 1) < 0.5 ? 1.35 : 1.55); // 5 cm to the corridor's wall
        }
        while (result.size() < 100) {
            add(random.uniform(0, 1) < 0.5 ? 3.9 : 4.1, random.uniform(1.6, 6)); // 5 cm to that between rooms
        }
        while (result.size() < 140) {
            add((random.uniform(0, 1) < 0.5 ? 2 : 6) + random.uniform(-0.4, 0.4), random.uniform(1.3, 1.6));
        }
        while (result.size() < 200) {
            add(random.uniform(0, 8), random.uniform(0, 6));
        }
        return result;
    }

    void expectNoViewFromBehindAWall() {
        const render::Dataset dataset = render::Dataset::open(folder.path());
        int seen = 0;
        for (const Vector3d& place : places()) {
            const render::NearPhotos near = dataset.photosNear(place, {.most = 4});
            seen += near.seesPlace ? 1 : 0;
            for (const std::size_t photo : near.photos) {
                const Vector3d& from = info.photos[photo].roomFromPhoto.translation;
                EXPECT_FALSE(near.seesPlace && isHidden(from, place))
                    << from.transpose() << " to " << place.transpose();
            }
            const bool isAnyInSight =
                std::any_of(info.photos.begin(), info.photos.end(), [&](const render::DatasetPhoto& photo) {
                    return (photo.roomFromPhoto.translation - place).norm() < 2 &&
                           !isHidden(photo.roomFromPhoto.translation, place);
                });
            EXPECT_TRUE(near.seesPlace || !isAnyInSight || !info.obstacles.empty()) << place.transpose();
        }
        EXPECT_GT(seen, 190);
    }

    practice::PracticeRoom room = flat();
    practice::RoomPlan plan = room.plan();
    test::TemporaryFolder folder;
    render::DatasetInfo info;
};

TEST_F(PracticeFlat, ThePlanKeepsViewsFromBehindWallsAway) {
    writePlan();
    expectNoViewFromBehindAWall();
}

TEST_F(PracticeFlat, TheDepthsKeepViewsFromBehindWallsAway) {
    writeDepths();
    expectNoViewFromBehindAWall();
}

} // namespace
} // namespace spherewalk
