// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "photo_fetcher.h"
#include "photo_judge.h"

#include "spherewalk/jobs/capture_survey.h"

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <stop_token>

namespace spherewalk::jobs {

/// Where the next photo is to be taken.
class Route {
  public:
    virtual ~Route() = default;

    /// Returns when the camera stands there; nothing at the end. Errors: Stopped.
    virtual std::optional<store::StationRecord> next(const std::stop_token& stop) = 0;
};

/// One run of the capture workflow: exposes along a route, while a PhotoFetcher follows.
class CaptureRun {
  public:
    /// Owner: all must outlive the run.
    CaptureRun(SharedStore& store, camera::OscClient& client, Operator& people, Clock& clock,
               const camera::CaptureOptions& options, ProgressSink& progress, const std::stop_token& stop);

    /// Settles what an earlier run left open. Then it is known which stations are still to be taken.
    void begin();
    /// True if a picture of this station is on its way already.
    bool isOnItsWay(std::int64_t station) const;
    /// On a photo of the survey; given now if there is none yet. Errors: those of PhotoJudge::judge().
    photo::Verdict verdictOn(std::int64_t photo);
    /// Exposes along the route, then waits for the downloads.
    void take(Route& route);
    CaptureSurveyReport finish();

  private:
    void prepareAndTake(Route& route);
    void takeAndFetch(Route& route);
    void takeAlong(Route& route);
    camera::ShotOutcome expose(const store::StationRecord& station);
    void fetchNow(const camera::ShotOutcome& exposed);
    void warn(const std::vector<std::string>& sentences);
    std::optional<photo::Verdict> judged(const camera::ShotOutcome& outcome);
    void account(const camera::ShotOutcome& outcome, bool isTold = false);

    SharedStore& m_store;
    Operator& m_people;
    Clock& m_clock;
    ProgressSink& m_progress;
    std::stop_source m_end; ///< asked for by the caller, or because the survey takes no more photos
    std::stop_callback<std::function<void()>> m_callersStop;
    std::stop_token m_stop = m_end.get_token();
    StoreJournal m_journal;
    camera::Capture m_capture;
    Clock::TimePoint m_begin;
    camera::CameraInfo m_camera;
    std::int64_t m_lastEarlierShot = 0;
    mutable std::mutex m_mutex; ///< of what follows
    CaptureSurveyReport m_report;
    std::map<std::int64_t, std::vector<std::string>> m_warningsOf; ///< by shot
    std::set<std::int64_t> m_unfetched;                            ///< shots that were tried in vain
    PhotoJudge m_judge;
    std::unique_ptr<camera::OscClient> m_fetchersClient;
    std::unique_ptr<PhotoFetcher> m_fetcher;
};

} // namespace spherewalk::jobs
