// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "lenses.h"
#include "random.h"

#include "spherewalk/base/json.h"
#include "spherewalk/render/ladder.h"
#include "spherewalk/render/view_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace spherewalk::render {

namespace {

constexpr Sampling kFixedSamplings[] = {Sampling::Nearest, Sampling::Bilinear, Sampling::Reduced,
                                        Sampling::Footprint, Sampling::Bicubic};

ViewChoice madeChoice() {
    return {SceneKind::Room, Sampling::Bilinear, 2.5, 1.25, 800, "It is near enough."};
}

ViewChoice choiceWith(const std::string& member, const Json& value) {
    Json json = toJson(madeChoice());
    json[member] = value;
    return parseViewChoice(JsonReader(json, "x.json", "/choice"));
}

} // namespace

TEST(Ladder, MinificationIsPhotoPixelsPerViewPixelAtTheMiddle) {
    test::Random random(921);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 50; ++i) {
        const CameraIntrinsics camera = CameraIntrinsics::pinhole(640, 480, random.uniform(0.1, 2.5));
        const double perRadian = 5376 / (2 * std::numbers::pi);
        EXPECT_NEAR(minification(CameraModel(camera), 5376), perRadian / camera.fx,
                    1e-3 * perRadian / camera.fx);
    }
}

TEST(Ladder, MinificationGrowsWithThePhotoAndIsThatOfTheCoarserAxis) {
    for (const CameraIntrinsics& lens : test::everyLens(64, 48)) {
        const double once = minification(CameraModel(lens), 1000);
        EXPECT_NEAR(minification(CameraModel(lens), 3000), 3 * once, 1e-9) << name(lens.lens);
        CameraIntrinsics narrow = lens;
        narrow.fy *= 4;
        EXPECT_NEAR(minification(CameraModel(narrow), 1000), once, 0.02 * once) << name(lens.lens);
    }
}

TEST(Ladder, FootprintHasSamplesCloserThanOneAndAHalfPixels) {
    for (double ratio = 0.01; ratio < 12; ratio += 0.01) {
        EXPECT_LE(ratio, 1.5 * samplesPerAxis(Sampling::Footprint, ratio) + 1e-9);
    }
    EXPECT_EQ(samplesPerAxis(Sampling::Footprint, 0), 2);
    EXPECT_EQ(samplesPerAxis(Sampling::Footprint, 1e9), 8);
    EXPECT_EQ(samplesPerAxis(Sampling::Bicubic, 4), 1);
}

TEST(Ladder, ExpectationsAreContinuousAndHoldBeyondTheirEnds) {
    for (const Sampling each : kFixedSamplings) {
        for (double ratio = 0.3; ratio < 4.2; ratio += 0.001) {
            EXPECT_NEAR(expectedDb(each, ratio), expectedDb(each, ratio + 0.001), 0.1) << ratio;
        }
        EXPECT_EQ(expectedDb(each, 0), expectedDb(each, 0.47)) << name(each);
        EXPECT_EQ(expectedDb(each, 100), expectedDb(each, 3.82)) << name(each);
    }
}

TEST(Ladder, ASamplingThatIsNamedIsNeverReplaced) {
    for (const Sampling each : kFixedSamplings) {
        for (const double ratio : {0.1, 1.0, 10.0}) {
            EXPECT_EQ(chosenSampling(each, ratio, 99), each);
        }
    }
}

TEST(Ladder, BestMagnifiesBySixteenPixelsAndMinifiesByTheMeanOfMore) {
    EXPECT_EQ(chosenSampling(Sampling::Best, 0.99, 40), Sampling::Bicubic);
    EXPECT_EQ(chosenSampling(Sampling::Best, 1, 40), Sampling::Footprint);
    EXPECT_EQ(sampling(name(Sampling::Best)), Sampling::Best);
    EXPECT_EQ(ViewOptions{}.sampling, Sampling::Best);
}

TEST(Ladder, AutoIsNeverCheaperForASmallerError) {
    const auto rank = [](Sampling each) {
        return each == Sampling::Reduced ? 0 : each == Sampling::Bilinear ? 1 : 2;
    };
    for (double ratio = 0.1; ratio < 6; ratio += 0.05) {
        for (double db = 25; db < 60; db += 0.5) {
            EXPECT_LE(rank(chosenSampling(Sampling::Auto, ratio, db)),
                      rank(chosenSampling(Sampling::Auto, ratio, db + 0.5)))
                << ratio << " " << db;
        }
    }
}

TEST(ViewChoice, IsReadAsItWasWritten) {
    for (const SceneKind scene :
         {SceneKind::None, SceneKind::Sphere, SceneKind::Room, SceneKind::Depth, SceneKind::Blend}) {
        for (const Sampling each : kFixedSamplings) {
            ViewChoice choice = madeChoice();
            choice.scene = scene;
            choice.sampling = each;
            EXPECT_EQ(parseViewChoice(JsonReader(toJson(choice), "x.json", "/choice")), choice);
        }
    }
}

TEST(ViewChoice, RefusesWordsAndNumbersThatMeanNothing) {
    for (const auto& [member, value] : std::vector<std::pair<std::string, Json>>{{"scene", "cube"},
                                                                                 {"scene", 3},
                                                                                 {"sampling", "auto"},
                                                                                 {"sampling", "lanczos"},
                                                                                 {"tolerance_px", 0},
                                                                                 {"tolerance_px", -1},
                                                                                 {"error_px", -0.1},
                                                                                 {"error_px", 1e7},
                                                                                 {"error_px", nullptr},
                                                                                 {"camera_focal_px", 0},
                                                                                 {"reason", 1}}) {
        test::expectError(ErrorKind::Corrupt, member, [&, m = member, v = value] { choiceWith(m, v); });
    }
    EXPECT_EQ(choiceWith("error_px", 0).errorPx, 0);
}

TEST(ViewChoice, HoldsForFocalLengthsUpToATwentiethLonger) {
    const ViewChoice choice = madeChoice();
    CameraIntrinsics camera = CameraIntrinsics::pinhole(640, 480, 1);
    for (const double focalPx : {1.0, 800.0, 839.0, 841.0, 5000.0}) {
        camera.fx = 100;
        camera.fy = focalPx;
        EXPECT_EQ(choice.isFor(camera), focalPx < 840) << focalPx;
        std::swap(camera.fx, camera.fy);
        EXPECT_EQ(choice.isFor(camera), focalPx < 840) << focalPx;
    }
}

TEST(LatePolicy, HasNamesThatAreReadAsTheyAreWritten) {
    for (const LatePolicy policy : {LatePolicy::Wait, LatePolicy::Coarse, LatePolicy::Previous}) {
        EXPECT_EQ(latePolicy(name(policy)), policy);
    }
    test::expectError(ErrorKind::InvalidInput, "wait, coarse and previous", [] { latePolicy("Wait"); });
}

} // namespace spherewalk::render
