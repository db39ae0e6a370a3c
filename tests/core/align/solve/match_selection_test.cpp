// SPDX-License-Identifier: GPL-3.0-or-later
#include "pairs/pair_geometry.h"
#include "random.h"
#include "solve/match_selection.h"

#include "spherewalk/geometry/rotation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace spherewalk::align {

using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace {

/// Two photos a metre apart along x that are not turned, and things that both see.
struct TwoPhotos {
    explicit TwoPhotos(double apartM = 1) : priors(2), pairs(1), estimates(1) {
        priors[1].positionM = Vector3d(apartM, 0, 0);
        pairs[0].b = 1;
        estimates[0].b = 1;
        estimates[0].verdict = PairVerdict::Constraint;
        estimates[0].baselineInA = Vector3d::UnitX();
        positions =
            unknowns(std::vector<int>{0, 1}, priors, std::vector<Quaterniond>(2, turn(Vector3d::Zero())));
    }

    void see(const Vector3d& pM) {
        const int feature = static_cast<int>(pairs[0].matches.size());
        pairs[0].matches.push_back(
            {pM.normalized(), (pM - priors[1].positionM).normalized(), 0.001, feature, feature});
        estimates[0].isInlier.push_back(true);
    }

    void seeMany(int count, test::Random& random) {
        while (static_cast<int>(pairs[0].matches.size()) < count) {
            const Vector3d direction = random.direction();
            if (direction.cross(Vector3d::UnitX()).norm() > 0.5) {
                see(random.uniform(2, 4) * direction);
            }
        }
    }

    Candidates candidates() {
        trackOf = tracks(pairs, std::vector<std::vector<bool>>{estimates[0].isInlier});
        return {pairs, estimates, trackOf, {0}, {0, 1}, noise};
    }

    std::vector<UsedMatch> estimated(const Selection& selection = {}) {
        return matchesOf(estimatedMatches(candidates(), positions, priors, selection));
    }

    std::vector<UsedMatch> agreeing(const Selection& selection = {}) {
        return matchesOf(agreeingMatches(candidates(), positions, priors, 1, selection));
    }

    static std::vector<UsedMatch> matchesOf(const std::vector<UsedPair>& used) {
        return used.empty() ? std::vector<UsedMatch>() : used[0].matches;
    }

    std::vector<PhotoPrior> priors;
    std::vector<PhotoPair> pairs;
    std::vector<PairEstimate> estimates;
    std::vector<std::vector<int>> trackOf;
    std::vector<double> noise{1, 1};
    Unknowns positions;
};

Correspondence matchOf(int featureA, int featureB) {
    Correspondence match;
    match.featureA = featureA;
    match.featureB = featureB;
    return match;
}

std::set<int> indices(const std::vector<UsedMatch>& matches) {
    std::set<int> result;
    for (const UsedMatch& match : matches) {
        result.insert(match.match);
    }
    return result;
}

/// Three rails and a photo on none, all moved by random unknowns.
Unknowns movedUnknowns(std::vector<PhotoPrior>& priors, test::Random& random) {
    priors.assign(10, {});
    std::vector<Quaterniond> rotations;
    std::vector<int> photos;
    for (int i = 0; i < 10; ++i) {
        PhotoPrior& prior = priors[static_cast<std::size_t>(i)];
        prior.positionM = Vector3d(1e6, -1e6, 1) + random.vector(2);
        prior.placement = i == 9 ? -1 : 5 * (i % 3);
        rotations.push_back(random.rotation());
        photos.push_back(i);
    }
    Unknowns made = unknowns(photos, priors, rotations);
    for (auto* blocks : {&made.turn, &made.offset, &made.placement}) {
        for (Unknowns::Block& block : *blocks) {
            block = {random.normal(0.1), random.normal(0.1), random.normal(0.1)};
        }
    }
    return made;
}

} // namespace

TEST(Tracks, JoinFeaturesThatMatchesLeadTo) {
    // 0:5 - 1:6 - 2:7 is one thing; 0:8 - 2:9 is another.
    const std::vector<PhotoPair> pairs = {
        {0, 1, {matchOf(5, 6)}}, {1, 2, {matchOf(6, 7)}}, {0, 2, {matchOf(8, 9), matchOf(5, 7)}}};
    const auto found = tracks(pairs, std::vector<std::vector<bool>>{{true}, {true}, {true, true}});
    EXPECT_EQ(found[0][0], found[1][0]);
    EXPECT_EQ(found[0][0], found[2][1]);
    EXPECT_NE(found[0][0], found[2][0]);
}

TEST(Tracks, OfMatchesThatAreNotUsedOrHaveNoFeaturesAreTheirOwn) {
    const std::vector<PhotoPair> pairs = {
        {0, 1, {matchOf(5, 6), matchOf(5, 6), matchOf(-1, 6), matchOf(5, -1)}}};
    const auto found = tracks(pairs, std::vector<std::vector<bool>>{{true, false, true, true}});
    EXPECT_EQ(std::set<int>(found[0].begin(), found[0].end()).size(), 4U);
}

TEST(HeldOut, IsTheShareAskedForAndGrowsWithIt) {
    int heldOut = 0;
    for (int track = 0; track < 20000; ++track) {
        heldOut += isHeldOut(track, 0.15) ? 1 : 0;
        EXPECT_TRUE(!isHeldOut(track, 0.15) || isHeldOut(track, 0.3)) << track;
        EXPECT_FALSE(isHeldOut(track, 0)) << track;
        EXPECT_TRUE(isHeldOut(track, 1)) << track;
    }
    EXPECT_NEAR(heldOut, 0.15 * 20000, 250);
}

TEST(MatchSelection, IsWantedOrHeldOutAndNeverBoth) {
    test::Random random(800);
    SCOPED_TRACE(random.seed());
    TwoPhotos photos;
    photos.seeMany(200, random);
    const std::set<int> kept = indices(photos.estimated({.heldOutShare = 0.3}));
    const std::set<int> out = indices(photos.estimated({.heldOutShare = 0.3, .wantsHeldOut = true}));
    std::set<int> both = kept;
    both.insert(out.begin(), out.end());
    EXPECT_EQ(both.size(), 200U);
    EXPECT_EQ(kept.size() + out.size(), 200U);
    EXPECT_NEAR(static_cast<double>(out.size()), 60, 25);
}

TEST(MatchSelection, KeepsRareDirectionsWhereThereAreTooMany) {
    test::Random random(801);
    SCOPED_TRACE(random.seed());
    TwoPhotos photos;
    for (int i = 0; i < 500; ++i) {
        photos.see(Vector3d(0.5, 3, 0.5) + random.vector(0.1));
    }
    photos.see({0.1, 0.2, -3}); // the one thing below comes last
    const std::set<int> kept = indices(photos.estimated({.mostAPair = 20}));
    EXPECT_EQ(kept.size(), 20U);
    EXPECT_TRUE(kept.contains(500));
}

TEST(MatchSelection, LeavesOutWhatLiesBehindOrIsNoDirectionOrNoInlier) {
    test::Random random(802);
    SCOPED_TRACE(random.seed());
    TwoPhotos photos;
    photos.seeMany(30, random);
    std::vector<Correspondence>& matches = photos.pairs[0].matches;
    std::swap(matches[3].inA, matches[3].inB);
    matches[5].inA.x() = std::numeric_limits<double>::quiet_NaN();
    matches[7].inB.setZero();
    photos.estimates[0].isInlier[9] = false;
    const std::set<int> kept = indices(photos.estimated());
    EXPECT_EQ(kept.size(), 26U);
    for (const int bad : {3, 5, 7, 9}) {
        EXPECT_FALSE(kept.contains(bad)) << bad;
    }
}

TEST(MatchSelection, ByThePosesTakesWhatAgreesWhateverTheEstimateSaid) {
    test::Random random(803);
    SCOPED_TRACE(random.seed());
    TwoPhotos photos;
    photos.seeMany(40, random);
    photos.estimates[0].isInlier.assign(40, false);
    Correspondence& wrong = photos.pairs[0].matches[11];
    wrong.inB = turn(0.1 * wrong.inB.cross(Vector3d::UnitX()).cross(wrong.inB).normalized()) * wrong.inB;
    EXPECT_TRUE(photos.estimated().empty());
    const std::set<int> kept = indices(photos.agreeing());
    EXPECT_EQ(kept.size(), 39U);
    EXPECT_FALSE(kept.contains(11));
}

TEST(MatchSelection, TakesPhotosOfOnePlaceForATurn) {
    for (const double apartM : {0.0, 0.005, 0.5}) {
        TwoPhotos photos(apartM);
        const UsedPair pair = emptyPair(photos.candidates(), photos.positions, photos.priors, 0);
        EXPECT_EQ(pair.isTurn, apartM < 0.01) << apartM;
        EXPECT_TRUE(pair.matches.empty());
    }
}

TEST(Judge, TellsAgreementFromWhatLiesBehindOffThePlaneAndAlongTheBaseline) {
    const PhotoState a;
    const PhotoState b{Quaterniond::Identity(), Vector3d(1, 0, 0)};
    const UsedPair pair{0, 0, 1, false, 0, {}};
    const Vector3d inA = Vector3d(0.5, 2, 1).normalized();
    const Vector3d inB = Vector3d(-0.5, 2, 1).normalized();
    EXPECT_EQ(judge(pair, {inA, inB, 0.001}, a, b, 1), Judgement::Agrees);
    EXPECT_EQ(judge(pair, {inB, inA, 0.001}, a, b, 1), Judgement::Behind);
    EXPECT_EQ(judge(pair, {inA, -inB, 0.001}, a, b, 1), Judgement::Behind);
    const Vector3d off = turn(0.02 * Vector3d::UnitX()) * inB;
    EXPECT_EQ(judge(pair, {inA, off, 0.001}, a, b, 1), Judgement::OutOfPlane);
    EXPECT_EQ(judge(pair, {inA, off, 0.001}, a, b, 30), Judgement::Agrees);
    const Vector3d along = Vector3d(1, 0.01, 0).normalized();
    EXPECT_EQ(judge(pair, {along, along, 0.001}, a, b, 1), Judgement::AlongBaseline);
}

TEST(ResidualScale, IsHowMuchTooSmallTheSigmasAre) {
    test::Random random(804);
    SCOPED_TRACE(random.seed());
    TwoPhotos photos;
    photos.seeMany(2000, random);
    for (Correspondence& match : photos.pairs[0].matches) {
        match.inA = (match.inA + random.vector(0.003)).normalized();
        match.inB = (match.inB + random.vector(0.003)).normalized();
    }
    const auto used =
        estimatedMatches(photos.candidates(), photos.positions, photos.priors, {.mostAPair = 2000});
    EXPECT_NEAR(residualScale(used, photos.positions.states()), 3, 0.25);
}

TEST(Unknowns, KeepAStopsOfARailRigidlyTogether) {
    test::Random random(805);
    SCOPED_TRACE(random.seed());
    std::vector<PhotoPrior> priors;
    Unknowns made = movedUnknowns(priors, random);
    made.offset.assign(made.offset.size(), {});
    const std::vector<PhotoState> states = made.states();
    ASSERT_EQ(made.placement.size(), 3U);
    for (std::size_t i = 0; i < 9; ++i) {
        for (std::size_t k = i % 3; k < 9; k += 3) {
            const double planned = (priors[i].positionM - priors[k].positionM).norm();
            EXPECT_NEAR((states[i].positionM - states[k].positionM).norm(), planned, 1e-8);
        }
    }
    EXPECT_EQ(states[9].positionM, made.plannedM[9]);
}

TEST(Unknowns, KnowHowARailMovesItsPhotos) {
    test::Random random(806);
    SCOPED_TRACE(random.seed());
    std::vector<PhotoPrior> priors;
    Unknowns made = movedUnknowns(priors, random);
    for (std::size_t i = 0; i < made.photo.size(); ++i) {
        const Eigen::Matrix3d by = made.positionByPlacement(i);
        for (std::size_t k = 0; k < 3; ++k) {
            Unknowns sides[2] = {made, made};
            const std::size_t rail = i < 9 ? static_cast<std::size_t>(made.rail[i]) : 0;
            sides[0].placement[rail][k] -= 1e-6;
            sides[1].placement[rail][k] += 1e-6;
            const Vector3d slope = (sides[1].state(i).positionM - sides[0].state(i).positionM) / 2e-6;
            EXPECT_LT((slope - by.col(static_cast<int>(k))).norm(), 1e-8) << i << ", " << k;
        }
    }
}

TEST(Unknowns, StayTheSamePosesWhenRebased) {
    test::Random random(807);
    SCOPED_TRACE(random.seed());
    std::vector<PhotoPrior> priors;
    Unknowns made = movedUnknowns(priors, random);
    const std::vector<PhotoState> before = made.states();
    made.rebase();
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_EQ(made.turn[i], Unknowns::Block{});
        EXPECT_LT(angleBetween(made.state(i).roomFromPhoto, before[i].roomFromPhoto).value(), 1e-12);
        EXPECT_EQ(made.state(i).positionM, before[i].positionM);
    }
}

TEST(Unknowns, AreLevelAsThePhotosSayAndKeepTheirHeadings) {
    test::Random random(808);
    SCOPED_TRACE(random.seed());
    std::vector<PhotoPrior> priors;
    Unknowns made = movedUnknowns(priors, random);
    std::vector<double> headings;
    for (std::size_t i = 0; i < priors.size(); ++i) {
        headings.push_back(random.uniform(-3.1, 3.1));
        if (i % 2 == 0) {
            priors[i].levelFromPhoto = turn(random.vector(0.1));
        }
        made.turn[i] = {};
        made.reference[i] =
            yawRotation(Radians(headings[i])) * priors[i].levelFromPhoto.value_or(Quaterniond::Identity());
    }
    const std::vector<Quaterniond> upright = made.reference;
    for (Unknowns::Block& block : made.turn) {
        block = {random.normal(1e-3), random.normal(1e-3), 0};
    }
    level(made, priors);
    for (std::size_t i = 0; i < priors.size(); ++i) {
        const Vertical said = knownUp(priors[i]);
        EXPECT_LT((made.reference[i] * said.upInPhoto - Vector3d::UnitZ()).norm(), 1e-12);
        EXPECT_LT(angleBetween(made.reference[i], upright[i]).value(), 1e-3);
        EXPECT_EQ(said.sigmaRad, priors[i].levelFromPhoto ? priors[i].tiltSigma.value() : 0.17);
    }
}

TEST(Unknowns, LeaveRoomForRoundingEvenIfAPriorIsSure) {
    PhotoPrior sure;
    sure.positionSigmaM = 0;
    sure.heightSigmaM = 0;
    sure.levelFromPhoto = Quaterniond::Identity();
    sure.tiltSigma = Radians(0);
    EXPECT_GT(offsetSigmasM(sure).minCoeff(), 0);
    EXPECT_GT(knownUp(sure).sigmaRad, 0);
}

} // namespace spherewalk::align
