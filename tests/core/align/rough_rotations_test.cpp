// SPDX-License-Identifier: GPL-3.0-or-later
#include "rough_rotations.h"
#include "simulated_survey.h"

#include "spherewalk/geometry/rotation.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace spherewalk::align {

using spherewalk::test::Random;
using test::SimulatedSurvey;
using test::SimulationOptions;

TEST(RoughRotations, AreGoodToAFractionOfADegreeThoughManyPairsAreWrong) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        Random random(seed);
        SimulationOptions options;
        options.rails = 8;
        options.stops = 8;
        options.wrongShare = 0.5; // a quarter with wrong rotations
        SimulatedSurvey survey(options, random);
        survey.expose(random);
        const RoughRotations rotations = roughRotations(64, survey.estimates);
        ASSERT_EQ(rotations.parts, 1);
        const Eigen::Quaterniond roomFromPart =
            survey.roomFromPhoto[0].rotation * rotations.partFromPhoto[0].conjugate();
        for (std::size_t i = 0; i < 64; ++i) {
            const Radians off =
                angleBetween(roomFromPart * rotations.partFromPhoto[i], survey.roomFromPhoto[i].rotation);
            EXPECT_LT(Degrees(off).value(), 0.4) << "seed " << seed << ", photo " << i;
        }
    }
}

TEST(RoughRotations, LeaveOutWhatNoTriangleConfirms) {
    Random random(9);
    SimulationOptions options;
    options.rails = 1;
    options.stops = 4;
    SimulatedSurvey survey(options, random);
    survey.expose(random);
    std::erase_if(survey.estimates, [](const PairEstimate& pair) { return pair.b != pair.a + 1; });
    const RoughRotations rotations = roughRotations(4, survey.estimates);
    EXPECT_EQ(rotations.parts, 0);
    EXPECT_EQ(std::ranges::count(rotations.part, -1), 4);
}

} // namespace spherewalk::align
