// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/progress.h"

#include <string>
#include <vector>

namespace spherewalk {

namespace {

class Recorder : public ProgressSink {
  public:
    void progress(double fraction, std::string_view /*activity*/) override { fractions.push_back(fraction); }

    void warning(std::string_view sentence) override { warnings.emplace_back(sentence); }

    std::vector<double> fractions;
    std::vector<std::string> warnings;
};

} // namespace

TEST(ProgressStep, MapsItsStepIntoTheWholeAndNeverGoesBack) {
    Recorder whole;
    ProgressStep step(whole, 0.5, 0.7);
    for (const double fraction : {0.0, 0.5, 0.25, 2.0}) {
        step.progress(fraction, "x");
    }
    step.warning("look");
    ASSERT_EQ(whole.fractions.size(), 4U);
    EXPECT_DOUBLE_EQ(whole.fractions[0], 0.5);
    EXPECT_DOUBLE_EQ(whole.fractions[1], 0.6);
    EXPECT_DOUBLE_EQ(whole.fractions[2], 0.6);
    EXPECT_DOUBLE_EQ(whole.fractions[3], 0.7);
    EXPECT_EQ(whole.warnings, std::vector<std::string>{"look"});
}

TEST(TimeLeft, IsTheRestAtThePaceOfBefore) {
    const TimeLeft::TimePoint start{};
    TimeLeft left(start);
    EXPECT_FALSE(left.at(start, 0));
    EXPECT_FALSE(left.at(start + std::chrono::milliseconds(500), 0.25 / 60));
    EXPECT_NEAR(left.at(start + std::chrono::seconds(30), 0.25)->count(), 90, 1e-9);
    EXPECT_EQ(left.at(start + std::chrono::seconds(30), 1.5)->count(), 0);
}

TEST(TimeLeft, IsNotFooledByWhatAResumedJobFindsDone) {
    const TimeLeft::TimePoint start{};
    TimeLeft left(start);
    for (int i = 1; i <= 4000; ++i) { // 60 percent at once, then one percent in ten seconds
        const double seconds = i / 10.0;
        const auto rest = left.at(start + std::chrono::milliseconds(100 * i), 0.6 + seconds / 1000);
        if (seconds >= 10) { // half a percent was gained
            ASSERT_TRUE(rest);
            EXPECT_NEAR(rest->count(), 400 - seconds, 1e-6) << seconds;
        }
    }
}

TEST(TimeLeft, SaysNothingWhileNothingMoves) {
    const TimeLeft::TimePoint start{};
    TimeLeft left(start);
    EXPECT_TRUE(left.at(start + std::chrono::seconds(10), 0.5));
    EXPECT_FALSE(left.at(start + std::chrono::seconds(30), 0.5));
}

TEST(TimeLeft, SaysNothingWhileAStepHardlyBegins) {
    const TimeLeft::TimePoint start{};
    TimeLeft left(start);
    EXPECT_FALSE(left.at(start + std::chrono::milliseconds(200), 0.09)) << "an easy step was done at once";
    EXPECT_FALSE(left.at(start + std::chrono::seconds(2), 0.091)) << "not half an hour";
    EXPECT_NEAR(left.at(start + std::chrono::seconds(6), 0.291)->count(), 4 * 0.709 / 0.2, 1e-9);
}

TEST(Stop, EndsASleepAndThrowsStopped) {
    std::stop_source source;
    EXPECT_NO_THROW(throwIfStopped(source.get_token()));
    EXPECT_TRUE(systemClock().sleep(std::chrono::milliseconds(1), source.get_token()));
    source.request_stop();
    EXPECT_FALSE(systemClock().sleep(std::chrono::hours(1), source.get_token()));
    test::expectError(ErrorKind::Stopped, "Stopped", [&] { throwIfStopped(source.get_token()); });
}

} // namespace spherewalk
