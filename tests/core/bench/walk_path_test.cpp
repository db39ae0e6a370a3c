// SPDX-License-Identifier: GPL-3.0-or-later
#include "made_dataset.h"
#include "random.h"
#include "temporary_folder.h"
#include "walk_path.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace spherewalk::bench {

using Eigen::Vector3d;

namespace {

render::DatasetInfo takenAt(const std::vector<Vector3d>& places) {
    render::DatasetInfo info;
    for (const Vector3d& place : places) {
        info.photos.emplace_back().roomFromPhoto.translation = place;
    }
    return info;
}

std::vector<Vector3d> madePlaces(test::Random& random, int most) {
    std::vector<Vector3d> places(static_cast<std::size_t>(random.integer(2, most)));
    std::generate(places.begin(), places.end(), [&] { return random.vector(3); });
    return places;
}

} // namespace

TEST(StationPath, SerpentineVisitsEachPlaceOfAGridOnceWithoutJumps) {
    test::Random random(11);
    SCOPED_TRACE(random.seed());
    std::vector<Vector3d> places;
    for (int x = 0; x < 7; ++x) {
        for (int y = 0; y < 5; ++y) {
            // A centimetre of error does not break a row.
            places.emplace_back(0.2 * x + random.uniform(-0.01, 0.01), 0.2 * y + random.uniform(-0.01, 0.01),
                                1.2 + random.uniform(-0.01, 0.01));
            places.push_back(places.back()); // two photos of one place
        }
    }
    std::shuffle(places.begin(), places.end(), std::mt19937(3));
    const std::vector<Vector3d> path = serpentine(takenAt(places));
    ASSERT_EQ(path.size(), 35U);
    for (std::size_t i = 1; i < path.size(); ++i) {
        EXPECT_LT((path[i] - path[i - 1]).norm(), 0.25) << i;
    }
    for (const Vector3d& place : places) {
        EXPECT_EQ(std::count(path.begin(), path.end(), place), 1);
    }
}

TEST(StationPath, IsWalkedToAndFro) {
    const StationPath path({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}});
    EXPECT_EQ(path.lengthM(), 3);
    EXPECT_EQ(path.at(0), Vector3d(0, 0, 0));
    EXPECT_EQ(path.at(1.5), Vector3d(1.5, 0, 0));
    EXPECT_EQ(path.at(2.5), Vector3d(2, 0.5, 0));
    EXPECT_EQ(path.at(3), Vector3d(2, 1, 0));
    EXPECT_EQ(path.at(4), Vector3d(2, 0, 0));
    EXPECT_EQ(path.at(5.5), Vector3d(0.5, 0, 0));
    EXPECT_EQ(path.at(6), Vector3d(0, 0, 0));
    EXPECT_EQ(path.at(601.5), Vector3d(1.5, 0, 0));
}

TEST(StationPath, MovesAsFarAsWasWalkedAndNoFarther) {
    test::Random random(12);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 50; ++i) {
        const StationPath path(madePlaces(random, 12));
        for (int k = 0; k < 50; ++k) {
            const double from = random.uniform(0, 4 * path.lengthM());
            const double stepM = random.uniform(0, 0.5);
            EXPECT_LE((path.at(from + stepM) - path.at(from)).norm(), stepM + 1e-9);
        }
    }
}

TEST(StationPath, PassesEachPlaceWhenItIsReached) {
    test::Random random(13);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 50; ++i) {
        const std::vector<Vector3d> places = madePlaces(random, 12);
        const StationPath path(places);
        double walkedM = 0;
        for (std::size_t k = 0; k < places.size(); ++k) {
            walkedM += k == 0 ? 0 : (places[k] - places[k - 1]).norm();
            EXPECT_LT((path.at(walkedM) - places[k]).norm(), 1e-9) << k;
        }
        EXPECT_NEAR(path.lengthM(), walkedM, 1e-9);
    }
}

TEST(StationPath, ComesBackTheSameWayAndBeginsAnew) {
    test::Random random(14);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 50; ++i) {
        const StationPath path(madePlaces(random, 12));
        const double walkedM = random.uniform(0, path.lengthM());
        EXPECT_LT((path.at(2 * path.lengthM() - walkedM) - path.at(walkedM)).norm(), 1e-6);
        EXPECT_LT((path.at(2 * path.lengthM() + walkedM) - path.at(walkedM)).norm(), 1e-6);
    }
}

TEST(StationPath, WaitsNowhereThoughAPlaceComesTwice) {
    const StationPath path({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}});
    EXPECT_EQ(path.lengthM(), 1);
    EXPECT_EQ(path.at(0.5), Vector3d(0.5, 0, 0));
    EXPECT_EQ(path.at(1), Vector3d(1, 0, 0));
    EXPECT_EQ(path.at(1.25), Vector3d(0.75, 0, 0));
}

TEST(Serpentine, DoesNotDependOnTheOrderOfPhotos) {
    test::Random random(15);
    SCOPED_TRACE(random.seed());
    std::mt19937 shuffling(15);
    for (int i = 0; i < 30; ++i) {
        std::vector<Vector3d> places = madePlaces(random, 40);
        const std::vector<Vector3d> path = serpentine(takenAt(places));
        std::shuffle(places.begin(), places.end(), shuffling);
        EXPECT_EQ(serpentine(takenAt(places)), path);
        EXPECT_EQ(path.size(), places.size());
        EXPECT_TRUE(std::is_permutation(path.begin(), path.end(), places.begin()));
    }
}

TEST(Serpentine, ClimbsFromLayerToLayer) {
    std::vector<Vector3d> places;
    for (int i = 0; i < 3 * 4 * 4; ++i) {
        places.emplace_back(0.2 * (i % 4), 0.2 * (i / 4 % 4), 0.8 + 0.4 * (i / 16));
    }
    const std::vector<Vector3d> path = serpentine(takenAt(places));
    ASSERT_EQ(path.size(), places.size());
    EXPECT_TRUE(std::is_sorted(path.begin(), path.end(),
                               [](const Vector3d& a, const Vector3d& b) { return a.z() < b.z() - 0.1; }));
    for (std::size_t i = 1; i < path.size(); ++i) {
        const bool isClimb = path[i].z() > path[i - 1].z() + 0.1;
        EXPECT_LE((path[i] - path[i - 1]).norm(), isClimb ? 0.8 : 0.2 + 1e-9) << i;
    }
}

TEST(PhotoRow, KeepsThePhotosShapeAndForgetsTheRoom) {
    const test::TemporaryFolder folder;
    test::MadeDataset made;
    made.hasRoom = true;
    const auto dataset = test::openMadeDataset(folder.path(), made);
    const PhotoRow row(*dataset, 3, noProgress(), {});
    EXPECT_FALSE(row.dataset()->info().roomShape);
    EXPECT_EQ(row.dataset()->info().sphereRadiusM, dataset->info().sphereRadiusM);
    std::vector<std::string> files;
    for (const render::DatasetPhoto& photo : row.dataset()->info().photos) {
        EXPECT_EQ(photo.width, dataset->info().photos.front().width);
        EXPECT_EQ(photo.sha256, dataset->info().photos.front().sha256);
        for (const std::string& name : {photo.file, photo.restartIndex, photo.thumbnail}) {
            EXPECT_TRUE(std::filesystem::is_regular_file(row.dataset()->folder() / name)) << name;
            files.push_back(name);
        }
    }
    std::sort(files.begin(), files.end());
    EXPECT_EQ(std::unique(files.begin(), files.end()), files.end()); // each copy has files of its own
    EXPECT_EQ(files.size(), 9U);
}

TEST(PhotoRow, CopiesAPhotoWithoutMarkers) {
    const test::TemporaryFolder folder;
    const auto dataset = test::withoutMarkers(*test::openMadeDataset(folder.path()));
    const PhotoRow row(*dataset, 2, noProgress(), {});
    ASSERT_EQ(row.dataset()->info().photos.size(), 2U);
    EXPECT_EQ(row.dataset()->info().photos[1].restartIndex, "");
    EXPECT_EQ(row.dataset()->readPhoto(1), dataset->readPhoto(0));
}

TEST(StationPath, OfOnePlaceStaysThere) {
    const StationPath path(serpentine(takenAt({{1, 2, 3}})));
    EXPECT_EQ(path.lengthM(), 0);
    EXPECT_EQ(path.at(0), Vector3d(1, 2, 3));
    EXPECT_EQ(path.at(17), Vector3d(1, 2, 3));
}

} // namespace spherewalk::bench
