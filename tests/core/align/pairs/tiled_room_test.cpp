// SPDX-License-Identifier: GPL-3.0-or-later
#include "made/noise_photo.h"

#include "spherewalk/align/features.h"
#include "spherewalk/align/match_pairs.h"
#include "spherewalk/align/photo_pair.h"
#include "spherewalk/align/solve.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/geometry/rotation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace spherewalk::align {

namespace {

const Eigen::Vector3d kHalfRoomM(2, 1.5, 1.25);
constexpr double kTileM = 0.25;

/// What a tile shows, at its own coordinates: not symmetric in any way.
double tileValue(double u, double v) {
    const auto cell = [](double value) { return value / kTileM - std::floor(value / kTileM); };
    return 0.6 * test::spaceNoise({cell(u) * 5, cell(v) * 5, 0.5}) +
           0.4 * test::spaceNoise({cell(u) * 11, cell(v) * 11, 7.5});
}

/// A photo from inside of a box whose walls, floor and ceiling repeat one tile.
RgbImage tiledRoomPhoto(const Rigid3& roomFromPhoto, int width) {
    RgbImage photo(width, width / 2);
    parallelFor(photo.height(), 8, 2, [&](int first, int end) {
        for (int y = first; y < end; ++y) {
            for (int x = 0; x < width; ++x) {
                const Eigen::Vector3d ray =
                    roomFromPhoto.rotation * direction(EquirectSize{width, width / 2}, Eigen::Vector2d(x, y));
                std::array<double, 3> reach{};
                for (int axis = 0; axis < 3; ++axis) {
                    const double wall = ray[axis] < 0 ? -kHalfRoomM[axis] : kHalfRoomM[axis];
                    reach[static_cast<std::size_t>(axis)] =
                        ray[axis] == 0 ? 1e9 : (wall - roomFromPhoto.translation[axis]) / ray[axis];
                }
                const auto nearest = std::min_element(reach.begin(), reach.end()) - reach.begin();
                const Eigen::Vector3d hit =
                    roomFromPhoto.translation + reach[static_cast<std::size_t>(nearest)] * ray;
                const double value = tileValue(hit[(nearest + 1) % 3], hit[(nearest + 2) % 3]);
                std::fill_n(photo.at(x, y), 3, static_cast<std::uint8_t>(std::lround(255 * value)));
            }
        }
    });
    return photo;
}

} // namespace

/// Each feature is there dozens of times. By 20 cm of way and tiles of 25 cm all seems to have moved 5 cm the
/// other way: the common heading cannot be told, and is not asked for here.
TEST(TiledRoom, TurnsNoPhotoWronglyAgainstAnother) {
    constexpr double kStepM = 0.2;
    std::vector<PhotoPrior> priors;
    std::vector<Rigid3> truth;
    std::vector<Features> features;
    FeatureOptions options;
    options.width = 1024;
    for (int i = 0; i < 4; ++i) {
        PhotoPrior prior;
        prior.name = "R" + std::to_string(i);
        prior.positionM = {kStepM * (i % 2) - 0.3, kStepM * (i / 2) + 0.1, 0};
        prior.placement = i / 2;
        prior.stop = i % 2;
        priors.push_back(prior);
        truth.push_back({yawRotation(Radians(1.3 * i - 2)), prior.positionM});
        features.push_back(detectFeatures(tiledRoomPhoto(truth.back(), 1024), options));
    }
    std::vector<PhotoPair> pairs;
    for (int a = 0; a < 4; ++a) {
        for (int b = a + 1; b < 4; ++b) {
            pairs.push_back({a, b,
                             matchFeatures(features[static_cast<std::size_t>(a)],
                                           features[static_cast<std::size_t>(b)], {})});
        }
    }
    const std::vector<PairEstimate> estimates = estimatePairs(pairs);
    const Alignment alignment = solve(priors, pairs, estimates, {}, noProgress(), {});
    for (const SolvedPose& pose : alignment.photos) {
        EXPECT_TRUE(pose.isSolved || !pose.why.empty());
    }
    for (const PairEstimate& pair : estimates) {
        const auto a = static_cast<std::size_t>(pair.a);
        const auto b = static_cast<std::size_t>(pair.b);
        if (alignment.photos[a].isSolved && alignment.photos[b].isSolved) {
            const Rigid3 aFromB =
                alignment.photos[a].roomFromPhoto.inverse() * alignment.photos[b].roomFromPhoto;
            EXPECT_LT(angleBetween(aFromB.rotation, (truth[a].inverse() * truth[b]).rotation).value(), 0.01)
                << priors[a].name << " and " << priors[b].name;
        }
    }
}

} // namespace spherewalk::align
