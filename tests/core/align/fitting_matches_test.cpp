// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"

#include "spherewalk/align/fitting_matches.h"
#include "spherewalk/geometry/rotation.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace spherewalk::align {

using Eigen::Vector3d;

namespace {

Correspondence seen(const Rigid3& a, const Rigid3& b, const Vector3d& pInRoom) {
    Correspondence match;
    match.inA = (a.inverse() * pInRoom).normalized();
    match.inB = (b.inverse() * pInRoom).normalized();
    match.sigmaRad = 0.0005;
    return match;
}

} // namespace

TEST(FittingMatches, FitWhereBothPhotosSeeOneThingInFrontOfThem) {
    test::Random random(41);
    SCOPED_TRACE(random.seed());
    const Vector3d origin(1e6, -1e6, 0);
    const std::vector<std::optional<Rigid3>> photos{
        Rigid3{random.rotation(), origin}, Rigid3{random.rotation(), origin + Vector3d(0.2, 0.1, 0)},
        Rigid3{random.rotation(), origin + Vector3d(0, 0, 1e-4)}, std::nullopt};
    PhotoPair apart{0, 1, {}};
    PhotoPair together{0, 2, {}};
    for (int i = 0; i < 200; ++i) {
        const Vector3d thing = origin + random.uniform(1, 5) * random.direction();
        apart.matches.push_back(seen(*photos[0], *photos[1], thing));
        together.matches.push_back(seen(*photos[0], *photos[2], thing));
    }
    PhotoPair unknown{0, 3, apart.matches};
    // Behind: what b sees, from the other side.
    PhotoPair behind{0, 1, {}};
    PhotoPair aside{0, 1, {}};
    const Vector3d way = photos[1]->translation - photos[0]->translation;
    for (int i = 0; i < 200; ++i) {
        const Vector3d across = way.cross(random.direction()).normalized();
        Correspondence match = seen(*photos[0], *photos[1], origin + 2 * across);
        aside.matches.push_back(match);
        aside.matches.back().inB =
            Eigen::AngleAxisd(0.01, photos[1]->rotation.conjugate() * way.normalized()) * match.inB;
        match.inB = photos[1]->rotation.conjugate() * (across + 0.1 * way.normalized()).normalized();
        behind.matches.push_back(match);
    }
    const auto fits = fittingMatches(photos, std::vector<PhotoPair>{apart, together, unknown, behind, aside});
    const auto count = [&](std::size_t pair) {
        return std::count(fits[pair].begin(), fits[pair].end(), true);
    };
    EXPECT_EQ(count(0), 200);
    EXPECT_EQ(count(1), 200);
    EXPECT_EQ(count(2), 0);
    EXPECT_EQ(count(3), 0);
    EXPECT_EQ(count(4), 0);
}

} // namespace spherewalk::align
