// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "simulated_survey.h"

#include "spherewalk/align/position_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>
#include <string>

namespace spherewalk::align {

namespace {

using spherewalk::test::Random;
using test::SimulatedSurvey;
using test::SimulationOptions;

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

} // namespace spherewalk::align
