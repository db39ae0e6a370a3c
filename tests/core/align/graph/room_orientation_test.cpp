// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph/pose_graph.h"
#include "pairs/pair_geometry.h"
#include "random.h"

#include "spherewalk/geometry/rotation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <vector>

namespace spherewalk::align {

using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace {

constexpr double kPiRad = std::numbers::pi;

/// A component whose place in the room is known, with an exact baseline between any two of its photos.
struct PlantedComponent {
    Component component;
    std::vector<PhotoPrior> photos;
    std::vector<PairEstimate> estimates;
    Quaterniond roomFromComponent;

    std::vector<RoomOrientation> found() const { return orientations(component, photos, estimates); }

    double offRad(const RoomOrientation& orientation) const {
        return angleBetween(orientation.roomFromComponent, roomFromComponent).value();
    }
};

PlantedComponent planted(const std::vector<Vector3d>& positionsM, const Quaterniond& roomFromComponent,
                         test::Random& random) {
    PlantedComponent made;
    made.roomFromComponent = roomFromComponent;
    std::vector<Quaterniond> roomFromPhoto;
    for (int i = 0; const Vector3d& positionM : positionsM) {
        const Quaterniond tilt = turn(random.vector(0.05));
        roomFromPhoto.push_back(yawRotation(Radians(random.uniform(-kPiRad, kPiRad))) * tilt);
        PhotoPrior photo;
        photo.positionM = positionM;
        photo.levelFromPhoto = tilt;
        made.photos.push_back(photo);
        made.component.photos.push_back(i++);
        made.component.componentFromPhoto.push_back(roomFromComponent.conjugate() * roomFromPhoto.back());
    }
    const int count = static_cast<int>(positionsM.size());
    for (int a = 0; a < count; ++a) {
        for (int b = a + 1; b < count; ++b) {
            const auto inA = static_cast<std::size_t>(a);
            const auto inB = static_cast<std::size_t>(b);
            PairEstimate estimate;
            estimate.a = a;
            estimate.b = b;
            estimate.verdict = PairVerdict::Constraint;
            estimate.aFromB = roomFromPhoto[inA].conjugate() * roomFromPhoto[inB];
            estimate.baselineInA =
                roomFromPhoto[inA].conjugate() * (positionsM[inB] - positionsM[inA]).normalized();
            estimate.baselineSigmaRad = 0.02;
            made.component.edges.push_back({static_cast<int>(made.estimates.size()), a, b, estimate.aFromB});
            made.estimates.push_back(estimate);
        }
    }
    return made;
}

std::vector<Vector3d> scattered(int count, test::Random& random) {
    std::vector<Vector3d> positionsM;
    for (int i = 0; i < count; ++i) {
        positionsM.emplace_back(random.uniform(-2, 2), random.uniform(-2, 2), 1.2);
    }
    return positionsM;
}

} // namespace

TEST(Orientations, RankThePlantedHeadingFirstThoughAThirdOfTheBaselinesIsWrong) {
    for (unsigned seed = 500; seed < 520; ++seed) {
        test::Random random(seed);
        PlantedComponent made = planted(scattered(9, random), random.rotation(), random);
        for (PairEstimate& estimate : made.estimates) {
            if (random.uniform(0, 1) < 0.33) {
                estimate.baselineInA = random.direction();
            }
        }
        const std::vector<RoomOrientation> found = made.found();
        ASSERT_FALSE(found.empty());
        EXPECT_TRUE(found[0].hasHeading);
        EXPECT_LT(made.offRad(found[0]), 0.05) << "seed " << seed;
    }
}

TEST(Orientations, AreExactAtHeadingsWhereTheCircleCloses) {
    for (const double headingRad : {kPiRad, -kPiRad, kPiRad - 1e-3, -kPiRad + 1e-3, 0.0}) {
        test::Random random(521);
        const PlantedComponent made = planted(scattered(6, random), yawRotation(Radians(headingRad)), random);
        EXPECT_LT(made.offRad(made.found().at(0)), 1e-3) << headingRad;
    }
}

TEST(Orientations, DoNotDependOnTheComponentsOwnFrame) {
    test::Random random(522);
    SCOPED_TRACE(random.seed());
    PlantedComponent made = planted(scattered(7, random), random.rotation(), random);
    const RoomOrientation before = made.found().at(0);
    for (int i = 0; i < 20; ++i) {
        const Quaterniond turned = random.rotation();
        PlantedComponent other = made;
        for (Quaterniond& componentFromPhoto : other.component.componentFromPhoto) {
            componentFromPhoto = turned * componentFromPhoto;
        }
        const RoomOrientation after = other.found().at(0);
        EXPECT_LT(angleBetween(after.roomFromComponent * turned, before.roomFromComponent).value(), 1e-3);
        EXPECT_NEAR(after.agreeingShare, before.agreeingShare, 1e-9);
    }
}

TEST(Orientations, FollowARoomThatIsTurnedByAnyAngleAndMovedFar) {
    test::Random random(523);
    SCOPED_TRACE(random.seed());
    PlantedComponent made = planted(scattered(7, random), random.rotation(), random);
    for (double angleRad = -kPiRad; angleRad < kPiRad; angleRad += 0.37) {
        PlantedComponent turned = made;
        for (PhotoPrior& photo : turned.photos) {
            photo.positionM = yawRotation(Radians(angleRad)) * photo.positionM + Vector3d(1e6, -3e5, 0);
        }
        turned.roomFromComponent = yawRotation(Radians(angleRad)) * made.roomFromComponent;
        EXPECT_LT(turned.offRad(turned.found().at(0)), 1e-3) << angleRad;
    }
}

TEST(Orientations, GiveBothHeadingsWhereHalfOfTheBaselinesPointBackwards) {
    test::Random random(524);
    SCOPED_TRACE(random.seed());
    PlantedComponent made = planted(scattered(9, random), random.rotation(), random);
    for (std::size_t i = 0; i < made.estimates.size(); i += 2) {
        made.estimates[i].baselineInA = -*made.estimates[i].baselineInA;
    }
    const std::vector<RoomOrientation> found = made.found();
    ASSERT_GE(found.size(), 2U);
    EXPECT_NEAR(made.offRad(found[0]) + made.offRad(found[1]), kPiRad, 0.01);
    EXPECT_NEAR(found[0].agreeingShare, 0.5, 0.1);
    EXPECT_NEAR(found[1].agreeingShare, 0.5, 0.1);
}

TEST(Orientations, AreFixedByPhotosOnOneLine) {
    test::Random random(525);
    SCOPED_TRACE(random.seed());
    std::vector<Vector3d> line;
    for (int i = 0; i < 5; ++i) {
        line.emplace_back(0.3 * i, 0.1 * i, 1);
    }
    const PlantedComponent made = planted(line, random.rotation(), random);
    const RoomOrientation best = made.found().at(0);
    EXPECT_LT(made.offRad(best), 1e-3);
    EXPECT_NEAR(best.agreeingShare, 1, 1e-12);
}

TEST(Orientations, AreThreeAtMostAndTheirSharesAreShares) {
    for (unsigned seed = 530; seed < 540; ++seed) {
        test::Random random(seed);
        PlantedComponent made = planted(scattered(8, random), random.rotation(), random);
        for (PairEstimate& estimate : made.estimates) {
            estimate.baselineInA = random.direction();
        }
        const std::vector<RoomOrientation> found = made.found();
        EXPECT_LE(found.size(), 3U);
        for (const RoomOrientation& one : found) {
            EXPECT_GE(one.agreeingShare, 0);
            EXPECT_LE(one.agreeingShare, 1);
            EXPECT_NEAR(one.roomFromComponent.norm(), 1, 1e-9);
        }
    }
}

TEST(Orientations, TakeTheWordOfTheSurerBaselines) {
    test::Random random(541);
    SCOPED_TRACE(random.seed());
    PlantedComponent made = planted(scattered(8, random), random.rotation(), random);
    for (std::size_t i = 0; i < made.estimates.size(); ++i) {
        if (i % 3 != 0) { // two of three say the other way, and are hardly sure
            made.estimates[i].baselineInA = -*made.estimates[i].baselineInA;
            made.estimates[i].baselineSigmaRad = 0.5;
        }
    }
    EXPECT_LT(made.offRad(made.found().at(0)), 0.01);
}

TEST(Orientations, AreUprightWithoutHeadingWhereNoBaselineIsLevel) {
    for (const char* why : {"without baselines", "one above the other", "at one place"}) {
        test::Random random(542);
        PlantedComponent made = planted(scattered(4, random), random.rotation(), random);
        for (std::size_t i = 0; i < made.photos.size(); ++i) {
            if (why == std::string_view("at one place")) {
                made.photos[i].positionM = Vector3d(5, 5, 1);
            } else if (why == std::string_view("one above the other")) {
                made.photos[i].positionM = Vector3d(5, 5, 1 + 0.3 * static_cast<double>(i));
            }
        }
        for (PairEstimate& estimate : made.estimates) {
            if (why == std::string_view("without baselines")) {
                estimate.baselineInA.reset();
            }
        }
        const std::vector<RoomOrientation> found = made.found();
        ASSERT_EQ(found.size(), 1U) << why;
        EXPECT_FALSE(found[0].hasHeading) << why;
        EXPECT_EQ(found[0].agreeingShare, 0) << why;
        const Quaterniond left = found[0].roomFromComponent * made.roomFromComponent.conjugate();
        EXPECT_LT((left * Vector3d::UnitZ() - Vector3d::UnitZ()).norm(), 1e-6) << why;
    }
}

TEST(Orientations, StayUprightThoughTwoOfNinePhotosSayAWrongTilt) {
    test::Random random(543);
    SCOPED_TRACE(random.seed());
    PlantedComponent made = planted(scattered(9, random), random.rotation(), random);
    made.photos[2].levelFromPhoto = random.rotation();
    made.photos[7].levelFromPhoto = random.rotation();
    EXPECT_LT(made.offRad(made.found().at(0)), 0.01);
}

TEST(Orientations, PassOverWhatIsNoNumber) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    test::Random random(544);
    SCOPED_TRACE(random.seed());
    PlantedComponent made = planted(scattered(9, random), random.rotation(), random);
    made.photos[0].positionM.x() = kNan;
    made.photos[1].positionM.y() = std::numeric_limits<double>::infinity();
    made.photos[2].positionSigmaM = kNan;
    made.photos[3].levelFromPhoto = Quaterniond(kNan, 0, 0, 0);
    made.estimates[20].baselineInA = Vector3d(kNan, kNan, kNan);
    made.estimates[30].baselineSigmaRad = kNan;
    const RoomOrientation best = made.found().at(0);
    EXPECT_LT(made.offRad(best), 0.01);
    EXPECT_NEAR(best.agreeingShare, 1, 1e-12); // an infinite position votes for no heading
}

TEST(Orientations, OfNoPhotosAreOneThatChangesNothing) {
    const std::vector<RoomOrientation> found = orientations({}, {}, {});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_FALSE(found[0].hasHeading);
    EXPECT_LT(angleBetween(found[0].roomFromComponent, Quaterniond::Identity()).value(), 1e-12);
}

} // namespace spherewalk::align
