// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench_photo.h"
#include "contest.h"
#include "expect_error.h"
#include "kept_progress.h"
#include "made_dataset.h"
#include "opencv_views.h"
#include "random.h"
#include "temporary_folder.h"

#include <algorithm>

namespace spherewalk::bench {

using test::expectError;

namespace {

/// Works until this time has passed.
void workFor(double ms) {
    const auto begin = std::chrono::steady_clock::now();
    while (millisecondsSince(begin) < ms) {
    }
}

std::vector<double> madeTimes(test::Random& random) {
    std::vector<double> times(static_cast<std::size_t>(random.integer(1, 30)));
    std::generate(times.begin(), times.end(), [&] { return random.uniform(1, 100); });
    return times;
}

} // namespace

TEST(Measured, DoesNotDependOnTheOrderOfTimes) {
    test::Random random(21);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 50; ++i) {
        std::vector<double> times = madeTimes(random);
        const Measured before = measured(times);
        std::reverse(times.begin(), times.end());
        std::rotate(times.begin(), times.begin() + random.integer(0, static_cast<int>(times.size()) - 1),
                    times.end());
        EXPECT_EQ(measured(times).medianMs, before.medianMs);
        EXPECT_EQ(measured(times).madMs, before.madMs);
    }
}

TEST(Measured, ScalesWithTheTimes) {
    test::Random random(22);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 50; ++i) {
        std::vector<double> times = madeTimes(random);
        const Measured before = measured(times);
        for (double& time : times) {
            time *= 4; // exact
        }
        EXPECT_EQ(measured(times).medianMs, 4 * before.medianMs);
        EXPECT_EQ(measured(times).madMs, 4 * before.madMs);
    }
}

TEST(Measured, IsNotMovedByAFewSlowRuns) {
    test::Random random(23);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 50; ++i) {
        std::vector<double> times(21);
        std::generate(times.begin(), times.end(), [&] { return random.uniform(10, 11); });
        std::fill_n(times.begin(), random.integer(1, 10), 1e6);
        EXPECT_LE(measured(times).medianMs, 11);
        EXPECT_LE(measured(times).madMs, 1);
    }
}

TEST(Measured, OfOneTimeIsThatTime) {
    EXPECT_EQ(measured({7}).medianMs, 7);
    EXPECT_EQ(measured({7}).madMs, 0);
}

TEST(PartsOfViews, AreTheMediansOfTheirReports) {
    PartsOfViews parts;
    for (const double ms : {5.0, 1.0, 3.0}) {
        render::ViewReport report;
        report.renderMs = ms;
        report.decodeMs = 10 * (6 - ms);
        parts.add(report);
    }
    EXPECT_EQ(parts.median().drawMs, 3);
    EXPECT_EQ(parts.median().decodeMs, 30);
}

TEST(Contest, RunsEachActionEquallyOftenAndInRisingOrder) {
    test::Random random(24);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 30; ++i) {
        const int rounds = random.integer(1, 20);
        const int block = random.integer(1, 12);
        std::vector<std::vector<int>> runs(static_cast<std::size_t>(random.integer(1, 4)));
        Contest contest;
        for (std::vector<int>& own : runs) {
            contest.add("action", [&own](int run) { own.push_back(run); });
        }
        contest.run(rounds, block, noProgress(), "", {});
        for (const std::vector<int>& own : runs) {
            ASSERT_EQ(own.size(), static_cast<std::size_t>(rounds + block));
            EXPECT_EQ(own.front(), 0);
            EXPECT_EQ(own.back(), rounds + block - 1);
            EXPECT_TRUE(std::is_sorted(own.begin(), own.end()));
        }
    }
}

TEST(Contest, LetsNoActionRunLongerThanItsTurn) {
    test::Random random(25);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 30; ++i) {
        const int block = random.integer(1, 12);
        char last = 0;
        int inARow = 0;
        Contest contest;
        for (const char name : {'a', 'b', 'c'}) {
            contest.add(std::string(1, name), [&, name](int) {
                inARow = name == last ? inARow + 1 : 1;
                last = name;
                EXPECT_LE(inARow, block);
            });
        }
        contest.run(random.integer(1, 20), block, noProgress(), "", {});
    }
}

TEST(Contest, LeavesOutTheTimesOfTheFirstBlock) {
    Contest contest;
    contest.add("warms up", [](int run) { workFor(run < 3 ? 20 : 0); });
    contest.run(2, 3, noProgress(), "", {});
    EXPECT_LT(contest.of("warms up").medianMs, 20);
}

TEST(Contest, TellsAtLeastTheTimeThatTheWorkTakes) {
    Contest contest;
    contest.add("short", [](int) { workFor(1); });
    contest.add("long", [](int run) { workFor(run % 2 == 0 ? 4 : 6); });
    contest.run(6, 2, noProgress(), "", {});
    EXPECT_GE(contest.of("short").medianMs, 1);
    EXPECT_GE(contest.of("long").medianMs, 4);
}

TEST(Contest, ForgetsTheTimesOfAnEarlierRun) {
    double ms = 20;
    Contest contest;
    contest.add("a", [&](int) { workFor(ms); });
    contest.run(9, 1, noProgress(), "", {});
    EXPECT_GE(contest.of("a").medianMs, 20);
    ms = 0;
    contest.run(5, 1, noProgress(), "", {});
    EXPECT_LT(contest.of("a").medianMs, 20);
}

TEST(Contest, ReportsProgressThatRisesToTheWhole) {
    test::KeptProgress progress;
    Contest contest;
    contest.add("a", [](int) {});
    contest.run(10, 4, progress, "Timing", {});
    EXPECT_EQ(progress.fractions.size(), 4U); // 4, 8, 12, 14 runs
    EXPECT_TRUE(std::is_sorted(progress.fractions.begin(), progress.fractions.end()));
    EXPECT_EQ(progress.fractions.back(), 1);
    EXPECT_EQ(progress.lastActivity, "Timing");
}

TEST(Contest, PassesErrorsOfItsActionsOn) {
    Contest contest;
    contest.add("a", [](int run) {
        if (run == 2) {
            throw Error(ErrorKind::Corrupt, "The photo is damaged.");
        }
    });
    expectError(ErrorKind::Corrupt, "The photo is damaged.",
                [&] { contest.run(5, 1, noProgress(), "", {}); });
}

TEST(Contest, TellsMedianAndSpreadOfTimes) {
    const Measured result = measured({10, 11, 12, 13, 100});
    EXPECT_EQ(result.medianMs, 12);
    EXPECT_EQ(result.madMs, 1);
}

TEST(Contest, TakesTurnsInBlocksAndTheFirstBlockDoesNotCount) {
    std::string turns;
    Contest contest;
    contest.add("a", [&](int run) { turns += "a" + std::to_string(run); });
    contest.add("b", [&](int run) { turns += "b" + std::to_string(run); });
    contest.run(3, 2, noProgress(), "", {});
    EXPECT_EQ(turns, "a0a1b0b1a2a3b2b3a4b4");
    EXPECT_GE(contest.of("a").medianMs, 0);
    expectError(ErrorKind::Internal, "the name c", [&] { contest.of("c"); });
}

TEST(Contest, StopsBetweenTwoRuns) {
    std::stop_source stop;
    int runs = 0;
    Contest contest;
    contest.add("a", [&](int) {
        if (++runs == 5) {
            stop.request_stop();
        }
    });
    expectError(ErrorKind::Stopped, "Stopped",
                [&] { contest.run(100, 10, noProgress(), "", stop.get_token()); });
    EXPECT_EQ(runs, 5);
}

TEST(Verified, MeanDifferenceCountsEveryValue) {
    RgbImage a(4, 2);
    RgbImage b = a;
    EXPECT_EQ(meanDifference(a, b), 0);
    b.at(3, 1)[2] = 24;
    EXPECT_EQ(meanDifference(a, b), 1);
    EXPECT_EQ(meanDifference(b, a), 1);
    EXPECT_GT(meanDifference(a, RgbImage(2, 4)), 1e9);
}

TEST(Verified, RefusesAPartWithOneWrongByte) {
    const RgbImage whole = test::madePanorama(64, 1);
    const jpeg::PixelRect region{8, 4, 20, 10};
    RgbImage part(region.width, region.height);
    for (int y = 0; y < region.height; ++y) {
        std::copy_n(whole.at(region.x, region.y + y), 3 * region.width, part.at(0, y));
    }
    requirePart(part, region, whole, "the part");
    expectError(ErrorKind::Internal, "the part is not what it should be", [&] {
        requirePart(part, {9, 4, 20, 10}, whole, "the part");
    });
    part.at(19, 9)[2] ^= 1;
    expectError(ErrorKind::Internal, "the part is not what it should be",
                [&] { requirePart(part, region, whole, "the part"); });
    expectError(ErrorKind::Internal, "the whole", [&] { requireSame(part, whole, "the whole"); });
}

TEST(Verified, RefusesPlanesWithOneWrongSample) {
    const Bytes bytes = jpeg::withRestartMarkers(jpeg::encode(test::madePanorama(256, 1), 90), 4, "made");
    const jpeg::RegionDecoder decoder(std::make_shared<MemorySource>(bytes, "made"),
                                      jpeg::indexRestarts(bytes, "made"));
    const jpeg::PixelRect region{32, 16, 64, 48};
    const jpeg::Planes whole = decoder.decodePlanes({0, 0, 256, 128});
    jpeg::Planes part = decoder.decodePlanes(region);
    requirePart(part, region, whole, "the part");
    part.red.at(31, 23)[0] ^= 1;
    expectError(ErrorKind::Internal, "its samples", [&] { requirePart(part, region, whole, "the part"); });
}

// What the benchmark rests on: the check tells a right view from one that is turned by a third of a degree.
TEST(Verified, TellsAViewFromOneThatIsALittleTurned) {
    const test::TemporaryFolder folder;
    const BenchPhoto photo(test::openMadeDataset(folder.path()));
    const CameraModel camera = standardCamera(90);
    OpenCvViews openCv(photo.picture(), camera, photo.radiusM());
    const Rigid3 pose = lookingTo(40, 10, {0.1, 0.05, 0});
    render::ViewOptions bilinear;
    bilinear.sampling = render::Sampling::Bilinear;
    render::ViewOptions exact;
    exact.exact = true;
    const auto view = [&](const Rigid3& from, const render::ViewOptions& options) {
        return photo.renderer().render(camera, photo.roomFromCamera(from), options).picture;
    };
    requireAlike(view(pose, bilinear), view(pose, exact), 0.5, "the view");
    requireAlike(view(pose, bilinear), openCv.mapsAndRemap(pose), 1.5, "the view");
    openCv.keepMaps(pose);
    requireAlike(openCv.remap(0), view(pose, exact), 1.5, "the view");
    const Rigid3 turned = lookingTo(40.3, 10, {0.1, 0.05, 0});
    expectError(ErrorKind::Internal, "the view is not what it should be",
                [&] { requireAlike(view(pose, bilinear), view(turned, exact), 0.5, "the view"); });
    expectError(ErrorKind::Internal, "the view is not what it should be",
                [&] { requireAlike(view(pose, bilinear), openCv.mapsAndRemap(turned), 1.5, "the view"); });
}

} // namespace spherewalk::bench
