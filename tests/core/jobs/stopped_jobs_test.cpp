// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "photographed_survey.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/jobs/align_trade.h"
#include "spherewalk/jobs/export_foreign.h"
#include "spherewalk/jobs/judge_survey.h"
#include "spherewalk/jobs/measured_dataset.h"
#include "spherewalk/jobs/solution_findings.h"
#include "spherewalk/jobs/walk.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <thread>

namespace spherewalk::jobs {

namespace {

/// Asks to stop at a call of progress(), and counts the calls that follow.
class StopAt : public ProgressSink {
  public:
    /// call: counted from 1; 0 means before the job begins.
    explicit StopAt(int call) : m_call(call) {
        if (call == 0) {
            m_stop.request_stop();
        }
    }

    void progress(double fraction, std::string_view activity) override {
        EXPECT_GE(fraction, m_last - 1e-9) << activity;
        EXPECT_LE(fraction, 1 + 1e-9) << activity;
        EXPECT_FALSE(activity.empty());
        m_last = fraction;
        m_callsAfter += m_stop.stop_requested() ? 1 : 0;
        if (++m_calls == m_call) {
            m_stop.request_stop();
        }
    }

    void warning(std::string_view /*sentence*/) override {}

    std::stop_token token() const { return m_stop.get_token(); }

    int calls() const { return m_calls; }

    int callsAfterTheStop() const { return m_callsAfter; }

  private:
    int m_call;
    int m_calls = 0;
    int m_callsAfter = 0;
    double m_last = 0;
    std::stop_source m_stop;
};

/// Each thread of a job may end the step that it is in.
const int kThreads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));

using Job = std::function<void(ProgressSink&, const std::stop_token&)>;

/// The kind of the error that ends a job, or nothing if the job ends well.
std::optional<ErrorKind> endOf(const Job& job, StopAt& progress) {
    try {
        job(progress, progress.token());
        return std::nullopt;
    } catch (const Error& error) {
        return error.kind();
    }
}

/// Runs a job that is asked to stop before it begins, then at its first step, at its second and so on. Each
/// run must end within one step. expectClean: checks what such a run leaves.
void expectToStopAnywhere(const Job& job, int most, const std::function<void()>& expectClean) {
    for (int call = 0; call <= most; ++call) {
        SCOPED_TRACE(call);
        StopAt progress(call);
        const auto end = endOf(job, progress);
        if (!end) {
            EXPECT_GT(call, 0) << "a job must not begin after a stop";
            return; // it was in its last step
        }
        EXPECT_EQ(name(*end), name(ErrorKind::Stopped));
        EXPECT_LE(progress.callsAfterTheStop(), kThreads)
            << "more than one step of each thread after the stop";
        expectClean();
    }
}

/// What a survey's tables tell, but for what the job itself is meant to add.
std::string surveyContent(const store::SurveyStore& store) {
    std::string content;
    for (const store::StationRecord& station : store.stations()) {
        content += text(station.id, " ", station.name, "\n");
    }
    for (const store::PhotoRecord& photo : store.photos()) {
        content += text(photo.id, " ", photo.station, " ", photo.fileName, " ", photo.fileSha256, "\n");
    }
    const auto solution = store.activeSolution();
    content += solution ? text("solution ", solution->id, "\n") : "";
    return content;
}

class StoppedJobs : public testing::Test {
  protected:
    std::string content() const { return surveyContent(m_survey.open()); }

    test::PhotographedSurvey m_survey{4};
    std::filesystem::path m_out = m_survey / "out";
};

} // namespace

TEST_F(StoppedJobs, AnExportLeavesNoFolder) {
    const std::string before = content();
    expectToStopAnywhere(
        [&](ProgressSink& progress, const std::stop_token& stop) {
            exportDataset(m_survey.open(), m_out, {}, progress, stop);
        },
        30,
        [&] {
            EXPECT_FALSE(std::filesystem::exists(m_out));
            EXPECT_EQ(content(), before);
        });
}

TEST_F(StoppedJobs, AnExportForOtherProgramsLeavesNoFolder) {
    expectToStopAnywhere(
        [&](ProgressSink& progress, const std::stop_token& stop) {
            exportForeign(m_survey.open(), m_out, {}, progress, stop);
        },
        30, [&] { EXPECT_FALSE(std::filesystem::exists(m_out)); });
}

TEST_F(StoppedJobs, ALookBeforeAnExportLeavesNothing) {
    const std::string before = content();
    expectToStopAnywhere(
        [&](ProgressSink& progress, const std::stop_token& stop) {
            checkExport(m_survey.open(), m_out, {}, progress, stop);
        },
        10,
        [&] {
            EXPECT_FALSE(std::filesystem::exists(m_out));
            EXPECT_EQ(content(), before);
        });
}

TEST_F(StoppedJobs, AnAlignmentRecordsNothing) {
    const std::string before = content();
    expectToStopAnywhere(
        [&](ProgressSink& progress, const std::stop_token& stop) {
            auto store = m_survey.open(store::Access::Write);
            AlignOptions options;
            options.effort = align::Effort::Draft;
            alignSurvey(store, options, progress, stop);
        },
        4, [&] { EXPECT_EQ(content(), before); });
}

TEST_F(StoppedJobs, AnImportKeepsThePhotosSoFarAndThenTheRest) {
    const test::TemporaryFolder folder;
    survey::Room room;
    room.outline = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
    room.ceilingM = 2.5;
    survey::PlanOptions plan;
    plan.stepM = 1;
    auto store =
        store::SurveyStore::create(folder / "s.spherewalk", "s", room, plan, survey::plan(room, plan));
    const ImportOptions options{m_survey / "in", m_survey / "p.csv"};
    for (int photos = 0; photos < 4; ++photos) {
        StopAt progress(photos == 0 ? 0 : 2); // the photo that is there, and one more
        const auto end = endOf([&](ProgressSink& sink,
                                   const std::stop_token& stop) { importPhotos(store, options, sink, stop); },
                               progress);
        EXPECT_TRUE(end);
        EXPECT_EQ(store.photos().size(), photos == 0 ? 0U : 2U);
        EXPECT_FALSE(store.activeSolution()) << "rotations come last";
        EXPECT_TRUE(store.check(noProgress(), {}).isSound());
    }
    const ImportReport rest = importPhotos(store, options, noProgress(), {});
    EXPECT_EQ(rest.alreadyThere, 2);
    EXPECT_EQ(rest.imported, 2);
    EXPECT_EQ(store.photos().size(), 4U);
    ASSERT_TRUE(store.activeSolution());
    EXPECT_EQ(store.solvedPhotos(store.activeSolution()->id).size(), 4U) << "of both runs";
}

TEST_F(StoppedJobs, JudgingKeepsTheVerdictsSoFar) {
    auto store = m_survey.open(store::Access::Write);
    for (std::size_t judged = 0; judged < 4; ++judged) {
        StopAt progress(judged == 0 ? 0 : 2); // then one photo more each time
        const auto end = endOf(
            [&](ProgressSink& sink, const std::stop_token& stop) { judgeSurvey(store, false, sink, stop); },
            progress);
        EXPECT_EQ(end, ErrorKind::Stopped);
        EXPECT_EQ(store.verdicts().size(), judged);
    }
    EXPECT_EQ(judgeSurvey(store, false, noProgress(), {}).judged, 1);
    EXPECT_EQ(store.verdicts().size(), 4U);
    EXPECT_EQ(judgeSurvey(store, false, noProgress(), {}).judged, 0) << "nothing is left";
    EXPECT_EQ(judgeSurvey(store, true, noProgress(), {}).judged, 4) << "all are asked for";
}

TEST_F(StoppedJobs, AWalkKeepsItsFramesAndGoesOn) {
    exportDataset(m_survey.open(), m_survey / "d", {}, noProgress(), {});
    const render::Renderer renderer(
        std::make_shared<const render::Dataset>(render::Dataset::open(m_survey / "d")));
    const CameraModel camera(CameraIntrinsics::pinhole(16, 12, 1));
    const Eigen::Vector3d at = renderer.dataset().info().photos.front().roomFromPhoto.translation;
    std::vector<TimedPose> path;
    for (int i = 0; i < 5; ++i) {
        path.push_back({0.1 * i, {Eigen::Quaterniond::Identity(), at + Eigen::Vector3d(0.01 * i, 0, 0)}});
    }
    const auto run = [&](ProgressSink& sink, const std::stop_token& stop) {
        return walk(renderer, camera, path, {}, m_out, sink, stop);
    };
    for (int frames = 1; frames <= 4; ++frames) {
        StopAt progress(1); // a frame that is there tells of no progress
        EXPECT_EQ(endOf(run, progress), ErrorKind::Stopped);
        EXPECT_EQ(progress.calls(), 1);
        EXPECT_FALSE(std::filesystem::exists(m_out / "index.csv"));
    }
    const WalkReport last = run(noProgress(), {});
    EXPECT_EQ(last.reused, 4U);
    EXPECT_TRUE(last.isComplete);
    EXPECT_TRUE(std::filesystem::exists(m_out / "index.csv"));
}

TEST_F(StoppedJobs, MeasuringKeepsTheViewsThatItCompared) {
    exportDataset(m_survey.open(), m_survey / "d", {}, noProgress(), {});
    const render::Renderer renderer(
        std::make_shared<const render::Dataset>(render::Dataset::open(m_survey / "d")));
    const CameraModel camera(CameraIntrinsics::pinhole(64, 48, 1));
    MeasureOptions options;
    options.mostViews = 4;
    options.directions = 1;
    options.samplingViews = 1;
    options.threads = 1;
    options.scene = render::SceneKind::None;
    options.cacheFolder = m_survey / "results";
    StopAt progress(2);
    EXPECT_EQ(
        endOf([&](ProgressSink& sink,
                  const std::stop_token& stop) { measureDataset(renderer, camera, options, sink, stop); },
              progress),
        ErrorKind::Stopped);
    EXPECT_EQ(progress.callsAfterTheStop(), 0);
    const MeasureReport whole = measureDataset(renderer, camera, options, noProgress(), {});
    EXPECT_EQ(whole.reusedViews, 2U);
    EXPECT_EQ(whole.scenes.front().views.size(), 4U);
}

TEST_F(StoppedJobs, MovingPhotosChangesNothing) {
    const std::string before = content();
    auto store = m_survey.open(store::Access::Write);
    const auto photos = store.photos();
    const std::vector<PhotoPlace> swap{{photos[0].id, photos[1].station}, {photos[1].id, photos[0].station}};
    expectToStopAnywhere([&](ProgressSink& progress,
                             const std::stop_token& stop) { retagPhotos(store, swap, progress, stop); },
                         4, [&] { EXPECT_EQ(content(), before); });
}

} // namespace spherewalk::jobs
