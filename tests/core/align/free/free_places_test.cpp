// SPDX-License-Identifier: GPL-3.0-or-later
#include "free/placing.h"
#include "made/hung_tags.h"
#include "made/synthetic_survey.h"
#include "pairs/pair_geometry.h"

#include "spherewalk/align/free_places.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/fixed_random.h"
#include "spherewalk/geometry/rotation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace spherewalk::align {

using testing::HasSubstr;

namespace {

/// Photos half a metre apart, each turned and leaning by hand. Nothing says where they were taken.
SyntheticSurveyOptions byHand(std::uint64_t seed) {
    SyntheticSurveyOptions options;
    options.seed = seed;
    options.columns = 4;
    options.rows = 3;
    options.stepM = 0.5;
    options.reachM = 1.2;
    options.tiltSigma = Degrees(5);
    options.positionSigmaM = 0.1;
    options.heightSigmaM = 0.03;
    options.points = 2000;
    return options;
}

SyntheticSurvey withoutPlaces(SyntheticSurvey survey) {
    for (PhotoPrior& photo : survey.photos) {
        photo.positionM = Eigen::Vector3d::Zero();
        photo.placement = -1;
        photo.levelFromPhoto.reset();
    }
    return survey;
}

FreePlaces solved(const SyntheticSurvey& survey, const FreeOptions& options = {}) {
    return freePlaces(survey.photos, survey.pairs, estimatePairs(survey.pairs), options, noProgress(), {});
}

/// The truth against the solution, the best common motion and scale taken off.
struct Errors {
    double placeRmsM = 0;
    double turnWorstRad = 0;
    double scale = 1; ///< True lengths over solved ones.
    double leanRad = 0;
};

Errors errorsOf(const FreePlaces& places, const SyntheticSurvey& survey) {
    std::vector<std::size_t> placed;
    for (std::size_t i = 0; i < places.photos.size(); ++i) {
        if (places.photos[i].roomFromPhoto) {
            placed.push_back(i);
        }
    }
    const auto count = static_cast<Eigen::Index>(placed.size());
    Eigen::Matrix3Xd made(3, count);
    Eigen::Matrix3Xd truth(3, count);
    for (Eigen::Index i = 0; i < count; ++i) {
        made.col(i) = places.photos[placed[static_cast<std::size_t>(i)]].roomFromPhoto->translation;
        truth.col(i) = survey.roomFromPhoto[placed[static_cast<std::size_t>(i)]].translation;
    }
    const Eigen::Matrix4d motion = Eigen::umeyama(made, truth, true);
    Errors errors;
    errors.scale = motion.block<3, 1>(0, 0).norm();
    const Eigen::Matrix3d turned = motion.block<3, 3>(0, 0) / errors.scale;
    errors.leanRad = std::acos(std::min(1.0, turned(2, 2)));
    for (Eigen::Index i = 0; i < count; ++i) {
        const std::size_t photo = placed[static_cast<std::size_t>(i)];
        const Eigen::Vector3d off =
            motion.block<3, 3>(0, 0) * made.col(i) + motion.block<3, 1>(0, 3) - truth.col(i);
        errors.placeRmsM += off.squaredNorm() / static_cast<double>(count);
        const Eigen::Quaterniond turn = Eigen::Quaterniond(turned) *
                                        places.photos[photo].roomFromPhoto->rotation *
                                        survey.roomFromPhoto[photo].rotation.conjugate();
        errors.turnWorstRad = std::max(errors.turnWorstRad, turnVector(turn).norm());
    }
    errors.placeRmsM = std::sqrt(errors.placeRmsM);
    return errors;
}

} // namespace

// No metadata, no positions: the pictures and the height of the lens say it all.
TEST(FreePlaces, AreSolvedFromMatchesAloneAndMeasuredByTheFloor) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        SCOPED_TRACE(seed);
        const SyntheticSurvey survey = withoutPlaces(syntheticSurvey(byHand(seed)));
        const FreePlaces places = solved(survey);
        for (const FreePlace& place : places.photos) {
            ASSERT_TRUE(place.roomFromPhoto.has_value()) << place.why;
            EXPECT_EQ(place.doubt, "");
            EXPECT_LT(place.sigmaM, 0.01);
        }
        const Errors errors = errorsOf(places, survey);
        EXPECT_LT(errors.placeRmsM, 0.01);
        EXPECT_LT(errors.turnWorstRad, 0.004);
        EXPECT_EQ(places.scaleBy, ScaleBy::Floor);
        EXPECT_NEAR(errors.scale, 1, 0.03);
        EXPECT_LT(errors.leanRad, 0.01);
        EXPECT_TRUE(places.isLevelByFloor);
    }
}

namespace {

/// Six photos on either side of a door, 1.5 m above one floor. All that both sides see are points in the
/// door, which hardly tell how long one side is against the other; the second one begins 2 % too long.
struct TwoRooms {
    Bundle bundle;
    std::vector<PhotoPrior> priors;

    explicit TwoRooms(std::uint64_t seed) : m_random(seed) {
        const Eigen::Vector3d door(0, 0, 1.5);
        for (int i = 0; i < 12; ++i) {
            const double side = i < 6 ? -1 : 1;
            const Eigen::Vector3d at(side * (1 + i % 3), i / 3 % 2 - 0.5, 1.5 + 0.02 * m_random.sumNormal());
            m_truth.push_back(at);
            bundle.photos.push_back({yawRotation(Radians(i)), i < 6 ? at : door + 1.02 * (at - door), {}});
            priors.emplace_back();
            priors.back().seenVertical = Vertical{Eigen::Vector3d::UnitZ(), 0.001};
        }
        for (int i = 0; i < 600; ++i) {
            const int room = i % 2;
            Eigen::Vector3d at(0.5 + 3.5 * m_random.uniform(), 4 * m_random.uniform() - 2, 0);
            if (i % 4 >= 2) { // on a wall instead of the floor
                at.tail<2>() = Eigen::Vector2d(2, 2.5 * m_random.uniform());
            }
            at.x() *= room == 0 ? -1 : 1;
            see(at, 6 * room, 6 * room + 6);
        }
        for (int i = 0; i < 8; ++i) {
            see(door + 0.03 * normal(), 0, 12);
        }
    }

    /// Length of the second room over that of the first, where 1 is right.
    double lengths() const { return lengthOf(6) / lengthOf(0); }

  private:
    Eigen::Vector3d normal() { return {m_random.sumNormal(), m_random.sumNormal(), m_random.sumNormal()}; }

    void see(const Eigen::Vector3d& at, int begin, int end) {
        SeenPoint point;
        for (int i = begin; i < end; ++i) {
            const Eigen::Vector3d to = (at - m_truth[static_cast<std::size_t>(i)]).normalized();
            const Eigen::Quaterniond turned = bundle.photos[static_cast<std::size_t>(i)].roomFromPhoto;
            point.rays.push_back({i, turned.conjugate() * (to + 0.001 * normal()).normalized(), 0.001});
        }
        bundle.points.push_back(std::move(point));
    }

    double lengthOf(std::size_t begin) const {
        double made = 0;
        double right = 0;
        for (std::size_t i = begin + 1; i < begin + 6; ++i) {
            made += (bundle.photos[i].positionM - bundle.photos[begin].positionM).norm();
            right += (m_truth[i] - m_truth[begin]).norm();
        }
        return made / right;
    }

    FixedRandom m_random;
    std::vector<Eigen::Vector3d> m_truth;
};

} // namespace

TEST(Adjustment, MeasuresRoomsByTheOneFloorBelowThem) {
    double withFloor = 0;
    double withoutFloor = 0;
    for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
        TwoRooms rooms(seed);
        adjust(rooms.bundle, rooms.priors, noProgress(), {});
        TwoRooms nobodySaysUp(seed);
        adjust(nobodySaysUp.bundle, std::vector<PhotoPrior>(12), noProgress(), {});
        withFloor += std::abs(rooms.lengths() - 1);
        withoutFloor += std::abs(nobodySaysUp.lengths() - 1);
    }
    EXPECT_LT(withFloor, 0.5 * withoutFloor);
}

// Both lenses taken for one bend the places: things a metre away are seen from a centimetre aside.
TEST(FreePlaces, KnowThatACameraHasTwoLenses) {
    for (const std::uint64_t seed : {21, 22}) {
        SCOPED_TRACE(seed);
        SyntheticSurveyOptions options = byHand(seed);
        const Errors oneLens = errorsOf(solved(withoutPlaces(syntheticSurvey(options))),
                                        withoutPlaces(syntheticSurvey(options)));
        options.lensAheadM = 0.01;
        const SyntheticSurvey survey = withoutPlaces(syntheticSurvey(options));
        const FreePlaces places = solved(survey);
        const Errors errors = errorsOf(places, survey);
        EXPECT_LT(errors.placeRmsM, 1.5 * oneLens.placeRmsM + 0.0005);
        for (const FreePlace& place : places.photos) {
            ASSERT_TRUE(place.roomFromPhoto.has_value()) << place.why;
            EXPECT_NEAR(errors.scale * place.lenses.aheadM, 0.01, 0.001);
        }
    }
}

TEST(FreePlaces, TakeTheLensesForOneWhereNothingTellsThemApart) {
    for (const std::uint64_t seed : {24, 25}) {
        const SyntheticSurvey survey = withoutPlaces(syntheticSurvey(byHand(seed)));
        for (const FreePlace& place : solved(survey).photos) {
            EXPECT_EQ(place.lenses.aheadM, 0) << seed;
        }
    }
}

TEST(FreePlaces, TakeTheirScaleFromAMeasuredDistance) {
    const SyntheticSurvey survey = withoutPlaces(syntheticSurvey(byHand(4)));
    FreeOptions options;
    options.lensHeightM = 2.4; // wrong by half, and not asked
    options.distance = {0, 11,
                        (survey.roomFromPhoto[0].translation - survey.roomFromPhoto[11].translation).norm()};
    const FreePlaces places = solved(survey, options);
    EXPECT_EQ(places.scaleBy, ScaleBy::Distance);
    EXPECT_NEAR(errorsOf(places, survey).scale, 1, 0.005);
}

namespace {

/// Tags on two walls, two metres from the photos' middle, in the true room.
std::vector<RoomTag> tagsAround(const SyntheticSurvey& survey) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Rigid3& pose : survey.roomFromPhoto) {
        middle += pose.translation / static_cast<double>(survey.roomFromPhoto.size());
    }
    std::vector<RoomTag> tags(2);
    tags[0].corners = hung(middle + Eigen::Vector3d(2, 0.2, 0.2), Degrees(180));
    tags[1].number = 1;
    tags[1].corners = hung(middle + Eigen::Vector3d(-0.3, 2, 0.1), Degrees(-90));
    for (RoomTag& tag : tags) {
        tag.size = kHungM;
        tag.sizeSigma = 0.0001;
        tag.sigma = 0.0005;
    }
    return tags;
}

FreeOptions seeing(std::span<const RoomTag> tags, const SyntheticSurvey& survey) {
    FreeOptions options;
    options.tagSizeM = kHungM;
    for (std::size_t i = 0; i < survey.roomFromPhoto.size(); ++i) {
        for (const RoomTag& tag : tags) {
            photo::SeenTag seen;
            seen.number = tag.number;
            seen.sigmaRad = 5e-5;
            for (std::size_t corner = 0; corner < tag.corners.size(); ++corner) {
                seen.directions[corner] =
                    (survey.roomFromPhoto[i].inverse() * tag.corners[corner]).normalized();
            }
            options.tags.push_back({static_cast<int>(i), seen});
        }
    }
    return options;
}

} // namespace

TEST(FreePlaces, TakeTheirScaleFromPrintedTags) {
    const SyntheticSurvey survey = withoutPlaces(syntheticSurvey(byHand(11)));
    const FreePlaces places = solved(survey, seeing(tagsAround(survey), survey));
    EXPECT_EQ(places.scaleBy, ScaleBy::Tags);
    EXPECT_NEAR(errorsOf(places, survey).scale, 1, 0.005);
    EXPECT_THAT(places.warnings, testing::Not(testing::Contains(HasSubstr("printed size"))));
}

TEST(FreePlaces, SayThatTheTagsAndTheHeightOfTheLensDiffer) {
    const SyntheticSurvey survey = withoutPlaces(syntheticSurvey(byHand(12)));
    FreeOptions options = seeing(tagsAround(survey), survey);
    options.tagSizeM = 0.2; // As if somebody had measured the white rim, too.
    EXPECT_THAT(solved(survey, options).warnings,
                testing::Contains(HasSubstr("By the printed size of the tags, the height of the lens is")));
}

TEST(FreePlaces, TakeOverTheFrameOfKnownTags) {
    const SyntheticSurvey survey = withoutPlaces(syntheticSurvey(byHand(13)));
    FreeOptions options = seeing(tagsAround(survey), survey);
    options.knownTags = tagsAround(survey);
    const FreePlaces places = solved(survey, options);
    ASSERT_TRUE(places.join.has_value());
    EXPECT_EQ(places.join->numbers, (std::vector<int>{0, 1}));
    EXPECT_THAT(places.warnings, testing::Not(testing::Contains(HasSubstr("printed size"))));
    for (std::size_t i = 0; i < places.photos.size(); ++i) {
        const Rigid3& truth = survey.roomFromPhoto[i];
        EXPECT_LT((places.photos[i].roomFromPhoto->translation - truth.translation).norm(), 0.03) << i;
    }
}

// Two tags, one of which was moved, fit well in another scale: only their printed size tells.
TEST(FreePlaces, SayThatKnownTagsContradictTheirSize) {
    const SyntheticSurvey survey = withoutPlaces(syntheticSurvey(byHand(14)));
    FreeOptions options = seeing(tagsAround(survey), survey);
    options.knownTags = tagsAround(survey);
    for (Eigen::Vector3d& corner : options.knownTags[1].corners) {
        corner += Eigen::Vector3d(-0.1, 0.1, 0);
    }
    EXPECT_THAT(solved(survey, options).warnings,
                testing::Contains(HasSubstr("lengths in the other survey's frame are")));
    options.knownTags[0].number = 7;
    options.knownTags[1].number = 8;
    EXPECT_THROW(solved(survey, options), Error);
}

// A photo of elsewhere matches only by chance.
TEST(FreePlaces, NameAnUnrelatedPhotoAndLeaveItOut) {
    SyntheticSurvey survey = withoutPlaces(syntheticSurvey(byHand(5)));
    FixedRandom random(5);
    for (PhotoPair& pair : survey.pairs) {
        for (Correspondence& match : pair.matches) {
            if (pair.a == 6 || pair.b == 6) {
                match.inB =
                    Eigen::Vector3d(random.sumNormal(), random.sumNormal(), random.sumNormal()).normalized();
            }
        }
    }
    const FreePlaces places = solved(survey);
    EXPECT_FALSE(places.photos[6].roomFromPhoto.has_value());
    EXPECT_THAT(places.photos[6].why, HasSubstr("another place"));
    EXPECT_TRUE(places.photos[5].roomFromPhoto.has_value());
}

TEST(FreePlaces, SayThatPhotosOfOnePlaceTellNoDistance) {
    SyntheticSurveyOptions options = byHand(4);
    options.stepM = 1e-4;
    options.positionSigmaM = 1e-3;
    options.heightSigmaM = 1e-3;
    const FreePlaces places = solved(withoutPlaces(syntheticSurvey(options)));
    for (const FreePlace& place : places.photos) {
        EXPECT_FALSE(place.roomFromPhoto);
        EXPECT_THAT(place.why, HasSubstr("at one place"));
    }
    EXPECT_TRUE(places.outline.empty());
}

TEST(FreePlaces, SayWhatIsWrongWithOnePhotoAndWithTwo) {
    SyntheticSurvey survey = withoutPlaces(syntheticSurvey(byHand(5)));
    survey.pairs.clear();
    survey.photos.resize(2);
    EXPECT_THAT(solved(survey).photos.at(0).why, HasSubstr("The other photo shares too little"));
    survey.photos.resize(1);
    EXPECT_THAT(solved(survey).photos.at(0).why, HasSubstr("the only photo"));
}

TEST(FreePlaces, TellPartsThatNothingConnects) {
    const SyntheticSurvey survey =
        withPairs(withoutPlaces(syntheticSurvey(byHand(6))),
                  [](const PhotoPair& pair) { return (pair.a < 8) == (pair.b < 8); });
    const FreePlaces places = solved(survey);
    EXPECT_EQ(places.parts, 2);
    EXPECT_THAT(places.photos[9].why, HasSubstr("part 2 of 2"));
    ASSERT_EQ(places.warnings.size(), 1U);
    EXPECT_THAT(places.warnings[0], HasSubstr("take photos between the parts"));
}

// Photos on one line: directions alone would leave open how far apart they are.
TEST(FreePlaces, DoubtAFewPhotosThatAloneOfManyHangTogether) {
    const SyntheticSurvey survey = withoutPlaces(syntheticSurvey(byHand(21)));
    const auto doubted = [&](int together) {
        std::vector<PairEstimate> estimates = estimatePairs(survey.pairs);
        for (PairEstimate& estimate : estimates) {
            if (estimate.b >= together) {
                estimate.verdict = PairVerdict::NoAgreement;
            }
        }
        const FreePlaces places = freePlaces(survey.photos, survey.pairs, estimates, {}, noProgress(), {});
        return std::ranges::count_if(places.photos, [](const FreePlace& place) {
            return place.roomFromPhoto && place.doubt.find("hang together") != std::string::npos;
        });
    };
    EXPECT_EQ(doubted(5), 5); // of 12
    EXPECT_EQ(doubted(6), 0);
    EXPECT_EQ(doubted(12), 0);
}

TEST(FreePlaces, KnowHowFarPhotosOnALineAreApart) {
    SyntheticSurveyOptions options = byHand(7);
    options.columns = 6;
    options.rows = 1;
    options.positionSigmaM = 0.0005;
    options.heightSigmaM = 0.0005;
    const SyntheticSurvey survey = withoutPlaces(syntheticSurvey(options));
    const FreePlaces places = solved(survey);
    EXPECT_LT(errorsOf(places, survey).placeRmsM, 0.01);
}

TEST(FreePlaces, RefuseADistanceToAPhotoThatIsNotThere) {
    const SyntheticSurvey survey = withoutPlaces(syntheticSurvey(byHand(8)));
    FreeOptions options;
    options.distance = {0, 99, 1.0};
    EXPECT_THROW(solved(survey, options), Error);
}

// Votes as of photos along a corridor, the last of which looks like none.
TEST(Retrieval, PairsPhotosThatLookAlikeAndJoinsWhatItCan) {
    Likeness alike(30);
    for (int a = 0; a < 29; ++a) {
        for (int b = a + 1; b < 29; ++b) {
            alike.set(a, b, std::max(0, 100 - 10 * (b - a)));
        }
    }
    RetrievalOptions options;
    options.partners = 4;
    const auto pairs = likelyPairs(alike, options);
    EXPECT_THAT(pairs, testing::Contains(std::pair(0, 1)));
    EXPECT_THAT(pairs, testing::Not(testing::Contains(std::pair(0, 9))));
    EXPECT_THAT(pairs, testing::Each(testing::Field(&std::pair<int, int>::second, testing::Lt(29))));
    EXPECT_LE(pairs.size(), 29U * 4U);
}

namespace {

/// Two rooms with four photos each, which are taken for one place that nothing joins. The second floor lies
/// `stepM` above the first.
FreePlaces twoRooms(double stepM) {
    FreePlaces places;
    FixedRandom random(5);
    for (int i = 0; i < 8; ++i) {
        const Eigen::Vector3d middle(i < 4 ? 0 : 5, 0, i < 4 ? 0 : stepM);
        FreePlace& place = places.photos.emplace_back();
        place.roomFromPhoto =
            Rigid3{Eigen::Quaterniond::Identity(), middle + Eigen::Vector3d(0.4 * (i % 4), 0, 1.5)};
        for (int point = 0; point < 40; ++point) {
            places.pointsM.emplace_back(
                middle + Eigen::Vector3d(3 * random.uniform() - 1, 3 * random.uniform() - 1.5, 0));
        }
    }
    return places;
}

std::vector<PhotoPair> alongEachRoom() {
    return {{0, 1, {}}, {1, 2, {}}, {2, 3, {}}, {4, 5, {}}, {5, 6, {}}, {6, 7, {}}};
}

} // namespace

TEST(LooseParts, NameARoomWhoseFloorLiesElsewhere) {
    FreePlaces places = twoRooms(0.045);
    doubtLooseParts(places, PlaceAgreement(places, alongEachRoom()), 1.5);
    EXPECT_EQ(places.photos[0].doubt, "");
    EXPECT_THAT(places.photos[7].doubt, HasSubstr("4.5 cm above that of the largest part"));
    EXPECT_THAT(places.photos[7].doubt, HasSubstr("lengths around it are 3.0 % too short"));
}

// The lowest floor of all gave the lengths: here that of the smaller room, 3 % too low.
TEST(LooseParts, AreNoMeasureForTheLargestRoom) {
    FreePlaces places = twoRooms(-0.045);
    places.photos.emplace_back().roomFromPhoto = // The first room is the larger one.
        Rigid3{Eigen::Quaterniond::Identity(), Eigen::Vector3d(0.2, 0.4, 1.5)};
    std::vector<PhotoPair> pairs = alongEachRoom();
    pairs.push_back({0, 8, {}});
    for (FreePlace& place : places.photos) { // As the lowest floor has it.
        place.roomFromPhoto->translation *= 1.5 / 1.545;
    }
    for (Eigen::Vector3d& point : places.pointsM) {
        point *= 1.5 / 1.545;
    }
    places.scaleBy = ScaleBy::Floor;
    doubtLooseParts(places, PlaceAgreement(places, pairs), 1.5);
    EXPECT_THAT(places.photos[5].doubt, HasSubstr("below that of the largest part"));
    EXPECT_NEAR(places.photos[0].roomFromPhoto->translation.z(), 1.5, 1e-9);
    EXPECT_NEAR(places.photos[3].roomFromPhoto->translation.x(), 1.2, 1e-9);
}

TEST(LooseParts, SayOfALevelFloorOnlyThatLittleJoinsTheRooms) {
    FreePlaces places = twoRooms(0);
    doubtLooseParts(places, PlaceAgreement(places, alongEachRoom()), 1.5);
    EXPECT_EQ(places.photos[3].doubt, "");
    EXPECT_THAT(places.photos[4].doubt, HasSubstr("Little of what the largest part lets expect"));
}

TEST(LooseParts, SayNothingWithoutPhotos) {
    FreePlaces none;
    none.photos.resize(3);
    doubtLooseParts(none, PlaceAgreement(none, {}), 1.5);
    EXPECT_EQ(none.photos[0].doubt, "");
}

} // namespace spherewalk::align
