// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "made/simulated_survey.h"

#include "spherewalk/align/position_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <limits>
#include <map>
#include <string>

namespace spherewalk::align {

namespace {

using test::Random;

std::vector<WrongPosition> check(const SimulatedSurvey& survey) {
    return wrongPositions(survey.photos, survey.estimates, survey.plannedPositions);
}

std::string listed(const SimulatedSurvey& survey, const std::vector<WrongPosition>& wrong) {
    std::string all;
    for (const WrongPosition& one : wrong) {
        all += survey.photos[static_cast<std::size_t>(one.photo)].name + " (" +
               std::to_string(one.confidence) + "): " + one.reason + "\n";
    }
    for (std::size_t i = 0; i < survey.photos.size(); ++i) {
        if (survey.takenAt[i] != static_cast<int>(i)) {
            all += "truth: " + survey.photos[i].name + " at " + std::to_string(survey.takenAt[i]) + "\n";
        }
    }
    return all;
}

/// How a check of one blunder went.
struct Outcome {
    bool areNamed = true; ///< all photos taken elsewhere, and no other
    bool areRight = true; ///< and all with the right station
};

Outcome outcome(const SimulatedSurvey& survey, const std::vector<WrongPosition>& wrong) {
    Outcome outcome;
    std::size_t expected = 0;
    for (std::size_t i = 0; i < survey.photos.size(); ++i) {
        const bool isWrong = survey.takenAt[i] != static_cast<int>(i);
        expected += isWrong ? 1 : 0;
        const auto found = std::ranges::find(wrong, static_cast<int>(i), &WrongPosition::photo);
        outcome.areNamed = outcome.areNamed && isWrong == (found != wrong.end());
        outcome.areRight =
            outcome.areRight && (!isWrong || (found != wrong.end() && found->fits == survey.takenAt[i]));
    }
    outcome.areRight = outcome.areRight && outcome.areNamed;
    return outcome;
}

void reverse(SimulatedSurvey& survey, int rail, int stops) {
    for (int stop = 0; stop < stops; ++stop) {
        survey.takeAt(survey.planned(rail, stop), survey.planned(rail, stops - 1 - stop));
    }
}

/// The photos tagged with these stops were taken one stop farther, or before.
void shift(SimulatedSurvey& survey, int rail, int first, int last, int by, int stops) {
    for (int stop = first; stop <= last; ++stop) {
        const int taken = stop + by;
        survey.takeAt(survey.planned(rail, stop),
                      taken < stops && taken >= 0 ? survey.planned(rail, taken) : -1);
    }
}

void swap(SimulatedSurvey& survey, int a, int b) {
    survey.takeAt(a, b);
    survey.takeAt(b, a);
}

const std::vector<std::string> kBlunders = {"swap along a rail", "swap across rails", "one photo off by one",
                                            "tail off by one",   "rail off by one",   "rail reversed"};

void commit(SimulatedSurvey& survey, const std::string& blunder, const SimulationOptions& options,
            Random& random) {
    const int rail = random.integer(0, options.rails - 1);
    const int stop = random.integer(0, options.stops - 2);
    if (blunder == "swap along a rail") {
        swap(survey, survey.planned(rail, stop), survey.planned(rail, stop + 1));
    } else if (blunder == "swap across rails") {
        const int lower = std::min(rail, options.rails - 2);
        swap(survey, survey.planned(lower, stop), survey.planned(lower + 1, stop));
    } else if (blunder == "one photo off by one") {
        shift(survey, rail, stop, stop, 1, options.stops);
    } else if (blunder == "tail off by one") {
        shift(survey, rail, std::max(1, stop), options.stops - 1, -1, options.stops);
    } else if (blunder == "rail off by one") {
        shift(survey, rail, 0, options.stops - 1, 1, options.stops);
    } else {
        reverse(survey, rail, options.stops);
    }
}

SimulationOptions gridOf(int rails, int stops) {
    SimulationOptions options;
    options.rails = rails;
    options.stops = stops;
    return options;
}

} // namespace

TEST(PositionCheck, NamesSeededBlundersWithTheirStations) {
    int campaigns = 0;
    int named = 0;
    int right = 0;
    std::map<std::string, std::array<int, 3>> byKind;
    for (unsigned seed = 1; seed <= 48; ++seed) {
        Random random(seed);
        const SimulationOptions options = gridOf(random.integer(5, 8), random.integer(5, 8));
        SimulatedSurvey survey(options, random);
        const std::string& blunder = kBlunders[seed % kBlunders.size()];
        commit(survey, blunder, options, random);
        survey.expose(random);
        const std::vector<WrongPosition> wrong = check(survey);
        const Outcome result = outcome(survey, wrong);
        named += result.areNamed ? 1 : 0;
        right += result.areRight ? 1 : 0;
        ++campaigns;
        ++byKind[blunder][0];
        byKind[blunder][1] += result.areNamed ? 1 : 0;
        byKind[blunder][2] += result.areRight ? 1 : 0;
        EXPECT_TRUE(result.areRight) << "seed " << seed << ", " << blunder << "\n" << listed(survey, wrong);
    }
    for (const auto& [kind, counts] : byKind) {
        std::printf("%-22s %2d seeded, %2d named, %2d with the right station\n", kind.c_str(), counts[0],
                    counts[1], counts[2]);
    }
    EXPECT_EQ(named, campaigns);
    EXPECT_EQ(right, campaigns);
}

TEST(PositionCheck, RaisesNoAlarmInCleanSurveys) {
    int alarms = 0;
    for (unsigned seed = 100; seed < 120; ++seed) {
        Random random(seed);
        SimulatedSurvey survey(gridOf(random.integer(5, 8), random.integer(5, 8)), random);
        survey.expose(random);
        const std::vector<WrongPosition> wrong = check(survey);
        alarms += wrong.empty() ? 0 : 1;
        EXPECT_TRUE(wrong.empty()) << "seed " << seed << "\n" << listed(survey, wrong);
    }
    std::printf("20 clean surveys, %d with an alarm\n", alarms);
}

TEST(PositionCheck, NamesSeveralBlundersOfOneSurvey) {
    Random random(201);
    SimulatedSurvey survey(gridOf(8, 8), random);
    reverse(survey, 6, 8);
    swap(survey, survey.planned(1, 2), survey.planned(1, 3));
    shift(survey, 3, 4, 7, -1, 8);
    survey.expose(random);
    const std::vector<WrongPosition> wrong = check(survey);
    EXPECT_TRUE(outcome(survey, wrong).areRight) << listed(survey, wrong);
}

TEST(PositionCheck, NamesEverySecondRailWalkedBackwards) {
    Random random(202);
    SimulatedSurvey survey(gridOf(7, 6), random);
    for (const int rail : {1, 3, 5}) {
        reverse(survey, rail, 6);
    }
    survey.expose(random);
    const std::vector<WrongPosition> wrong = check(survey);
    EXPECT_TRUE(outcome(survey, wrong).areRight) << listed(survey, wrong);
}

TEST(PositionCheck, SaysInSentencesWhatIsSwapped) {
    Random random(203);
    SimulatedSurvey survey(gridOf(5, 5), random);
    swap(survey, survey.planned(2, 3), survey.planned(2, 4));
    survey.expose(random);
    const std::vector<WrongPosition> wrong = check(survey);
    ASSERT_EQ(wrong.size(), 2U) << listed(survey, wrong);
    EXPECT_EQ(wrong[0].reason, "It shows what is seen from rail 2, stop 4; the photo tagged so shows rail 2, "
                               "stop 3: they are swapped.");
    EXPECT_GT(wrong[0].confidence, 0.9);
}

TEST(PositionCheck, CannotTellWhichWayASingleRailWasWalked) {
    for (unsigned seed = 210; seed < 214; ++seed) {
        Random random(seed);
        SimulatedSurvey survey(gridOf(1, 12), random);
        if (seed % 2 == 0) {
            reverse(survey, 0, 12);
        }
        survey.expose(random);
        const std::vector<WrongPosition> wrong = check(survey);
        EXPECT_TRUE(wrong.empty()) << "seed " << seed << "\n" << listed(survey, wrong);
    }
}

TEST(PositionCheck, RaisesNoAlarmWherePhotosShareStations) {
    for (unsigned seed = 220; seed < 224; ++seed) {
        Random random(seed);
        SimulatedSurvey survey(gridOf(5, 5), random);
        for (std::size_t i = 0; i < 10; ++i) { // photographed twice
            survey.photos.push_back(survey.photos[i]);
            survey.takenAt.push_back(survey.takenAt[i]);
        }
        survey.expose(random);
        EXPECT_TRUE(check(survey).empty()) << "seed " << seed << "\n" << listed(survey, check(survey));
    }
}

TEST(PositionCheck, JudgesPartsThatNothingConnectsEachByItself) {
    Random random(230);
    SimulatedSurvey survey(gridOf(10, 5), random);
    swap(survey, survey.planned(8, 1), survey.planned(8, 2));
    survey.expose(random);
    std::erase_if(survey.estimates, [](const PairEstimate& pair) { return (pair.a < 25) != (pair.b < 25); });
    const std::vector<WrongPosition> wrong = check(survey);
    EXPECT_TRUE(outcome(survey, wrong).areRight) << listed(survey, wrong);
}

TEST(PositionCheck, WorksFarFromTheOrigin) {
    Random random(240);
    SimulationOptions options = gridOf(5, 6);
    options.originM = {1e6, -1e6, 101.2};
    SimulatedSurvey survey(options, random);
    reverse(survey, 1, 6);
    survey.expose(random);
    const std::vector<WrongPosition> wrong = check(survey);
    EXPECT_TRUE(outcome(survey, wrong).areRight) << listed(survey, wrong);
}

TEST(PositionCheck, PassesOverWhatIsNoNumber) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    Random random(250);
    SimulatedSurvey survey(gridOf(5, 5), random);
    survey.expose(random);
    survey.photos[3].positionM.x() = kNone;
    survey.photos[4].positionSigmaM = kNone;
    survey.photos[5].levelFromPhoto = Eigen::Quaterniond(kNone, 0, 0, 0);
    survey.estimates[1].aFromB.x() = kNone;
    survey.estimates[2].baselineInA = Eigen::Vector3d(kNone, 0, 0);
    survey.estimates[3].baselineSigmaRad = kNone;
    survey.estimates[4].parallaxRad = kNone;
    survey.plannedPositions[7].positionM.y() = kNone;
    const std::vector<WrongPosition> wrong = check(survey);
    EXPECT_TRUE(wrong.empty()) << listed(survey, wrong);
}

TEST(PositionCheck, SaysNothingOfSurveysThatHoldNothing) {
    EXPECT_TRUE(wrongPositions({}, {}, {}).empty());
    Random random(260);
    SimulatedSurvey survey(gridOf(1, 2), random);
    survey.expose(random);
    EXPECT_TRUE(check(survey).empty());
    for (PhotoPrior& photo : survey.photos) {
        photo.positionM.setZero(); // nobody knows where any was taken
    }
    EXPECT_TRUE(check(survey).empty());
}

TEST(PositionCheck, RefusesPairsOfPhotosThatDoNotExist) {
    Random random(270);
    SimulatedSurvey survey(gridOf(2, 2), random);
    survey.expose(random);
    survey.estimates[0].b = 4;
    spherewalk::test::expectError(ErrorKind::InvalidInput, "there are 4 photos", [&] { check(survey); });
}

TEST(PositionCheck, JudgesALargeSurveyAndPrintsItsTime) {
    Random random(280);
    SimulatedSurvey survey(gridOf(20, 20), random);
    survey.expose(random);
    const auto start = std::chrono::steady_clock::now();
    std::vector<WrongPosition> wrong = check(survey);
    const std::chrono::duration<double> clean = std::chrono::steady_clock::now() - start;
    EXPECT_TRUE(wrong.empty()) << listed(survey, wrong);

    reverse(survey, 7, 20);
    shift(survey, 12, 5, 19, -1, 20);
    survey.expose(random);
    wrong = check(survey);
    const std::chrono::duration<double> both = std::chrono::steady_clock::now() - start;
    EXPECT_TRUE(outcome(survey, wrong).areRight) << listed(survey, wrong);
    std::printf("%zu photos, %zu pairs: %.2f s clean, %.2f s with two rails wrong and simulation\n",
                survey.photos.size(), survey.estimates.size(), clean.count(), (both - clean).count());
}

} // namespace spherewalk::align
