// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "photographed_survey.h"

#include "spherewalk/jobs/judge_survey.h"

#include <gtest/gtest.h>

namespace spherewalk::jobs {
namespace {

/// Asks for the stop when it hears of the second photo.
class StopAtSecond : public ProgressSink {
  public:
    void progress(double fraction, std::string_view /*activity*/) override {
        if (fraction > 0) {
            m_stop.request_stop();
        }
    }

    void warning(std::string_view /*sentence*/) override {}

    std::stop_token token() const { return m_stop.get_token(); }

  private:
    std::stop_source m_stop;
};

} // namespace

TEST(SearchFaces, GoesOnWhereItWasStopped) {
    const test::PhotographedSurvey survey(3);
    auto store = survey.open(store::Access::Write);
    StopAtSecond stopping;
    test::expectError(ErrorKind::Stopped, "", [&] { searchFaces(store, {}, stopping, stopping.token()); });
    const FaceReport rest = searchFaces(store, {}, noProgress(), {});
    EXPECT_EQ(rest.before, 1U);
    EXPECT_EQ(rest.photos, 2U);
    EXPECT_EQ(rest.regions, 0U) << "there is nobody";
    EXPECT_EQ(searchFaces(store, {}, noProgress(), {}).photos, 0U);
    FaceOptions again;
    again.again = true;
    EXPECT_EQ(searchFaces(store, again, noProgress(), {}).photos, 3U);
}

TEST(SearchFaces, ChangesNothingWithoutCascades) {
    const test::PhotographedSurvey survey(1);
    auto store = survey.open(store::Access::Write);
    FaceOptions options;
    options.cascades = survey / "nowhere";
    test::expectError(ErrorKind::NotFound, "opencv-data",
                      [&] { searchFaces(store, options, noProgress(), {}); });
    EXPECT_EQ(searchFaces(store, {}, noProgress(), {}).photos, 1U);
}

} // namespace spherewalk::jobs
