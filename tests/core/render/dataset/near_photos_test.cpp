// SPDX-License-Identifier: Apache-2.0
#include "random.h"
#include "temporary_folder.h"
#include "test_dataset.h"

#include "spherewalk/render/dataset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace spherewalk::render {
namespace {

using Eigen::Vector3d;

/// Photos in a room without an outline or depths: nothing hides a photo.
class OpenRoom : public testing::Test {
  protected:
    Dataset write(const std::vector<Vector3d>& places) {
        std::vector<Rigid3> poses;
        for (const Vector3d& place : places) {
            poses.push_back({Eigen::Quaterniond::Identity(), place});
        }
        test::writeTestDataset(folder.path(), poses, test::smoothWorld, 64);
        return Dataset::open(folder.path());
    }

    std::vector<Vector3d> scattered(int count, const Vector3d& middle) {
        std::vector<Vector3d> places;
        for (int i = 0; i < count; ++i) {
            places.push_back(middle + Vector3d(random.uniform(-3, 3), random.uniform(-3, 3), 1.2));
        }
        return places;
    }

    /// The order of the photos by long double distances.
    static std::vector<std::size_t> byDistance(const std::vector<Vector3d>& places, const Vector3d& from) {
        std::vector<std::size_t> order(places.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        const auto squared = [&](std::size_t i) {
            return (places[i].cast<long double>() - from.cast<long double>()).squaredNorm();
        };
        std::ranges::stable_sort(order, [&](auto a, auto b) { return squared(a) < squared(b); });
        return order;
    }

    test::TemporaryFolder folder;
    test::Random random{41};
};

TEST_F(OpenRoom, GivesTheNearestPhotosInOrder) {
    const std::vector<Vector3d> places = scattered(40, Vector3d::Zero());
    const Dataset dataset = write(places);
    for (int i = 0; i < 200; ++i) {
        const Vector3d from(random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(0, 3));
        std::vector<std::size_t> expected = byDistance(places, from);
        expected.resize(6);
        const NearPhotos near = dataset.photosNear(from, {.most = 6});
        EXPECT_EQ(near.photos, expected);
        EXPECT_TRUE(near.seesPlace);
        EXPECT_EQ(dataset.nearestPhoto(from), expected.front());
    }
}

TEST_F(OpenRoom, IsAsRightAThousandKilometresFromTheOrigin) {
    const Vector3d middle(1e6, -1e6, 0);
    const std::vector<Vector3d> places = scattered(20, middle);
    const Dataset dataset = write(places);
    for (int i = 0; i < 100; ++i) {
        const Vector3d from = middle + Vector3d(random.uniform(-3, 3), random.uniform(-3, 3), 1.2);
        EXPECT_EQ(dataset.nearestPhoto(from), byDistance(places, from).front());
    }
}

TEST_F(OpenRoom, TakesTheFirstOfPhotosThatAreAsNear) {
    const Dataset dataset = write({{1, 0, 1}, {-1, 0, 1}, {0, 1, 1}, {0, 0, 2}});
    EXPECT_EQ(dataset.photosNear({0, 0, 1}, {.most = 4}).photos, (std::vector<std::size_t>{0, 1, 2, 3}));
}

TEST_F(OpenRoom, LeavesPhotosOutThatMayNotBeTaken) {
    const Dataset dataset = write({{0, 0, 1}, {1, 0, 1}, {2, 0, 1}});
    EXPECT_EQ(dataset.nearestPhoto({0.1, 0, 1}, 0), 1);
    const auto isLast = [](std::size_t photo) { return photo == 2; };
    EXPECT_EQ(dataset.photosNear({0.1, 0, 1}, {.most = 3, .isUsable = isLast}).photos,
              std::vector<std::size_t>{2});
    EXPECT_TRUE(
        dataset.photosNear({0, 0, 1}, {.isUsable = [](std::size_t) { return false; }}).photos.empty());
}

TEST_F(OpenRoom, TakesTheOnlyPhotoEvenIfItIsToBeLeftOut) {
    EXPECT_EQ(write({{0, 0, 1}}).nearestPhoto({3, 0, 1}, 0), 0);
}

TEST_F(OpenRoom, HoldsAPhotoUntilTwoCentimetresBeyondTheBorder) {
    const Dataset dataset = write({{0, 0, 1}, {1, 0, 1}});
    const std::vector<std::size_t> held{0};
    const auto first = [&](double x) {
        return dataset.photosNear({x, 0, 1}, {.most = 2, .held = held}).photos.front();
    };
    EXPECT_EQ(dataset.nearestPhoto({0.501, 0, 1}), 1);
    EXPECT_EQ(first(0.519), 0);
    EXPECT_EQ(first(0.521), 1);
}

} // namespace
} // namespace spherewalk::render
