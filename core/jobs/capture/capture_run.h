// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "capture/photo_judge.h"
#include "capture/store_journal.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/camera/capture.h"
#include "spherewalk/jobs/align_survey.h"
#include "spherewalk/jobs/capture_survey.h"

#include <condition_variable>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <stop_token>
#include <thread>

namespace spherewalk::jobs {

/// Downloads the camera's photos on a thread of its own, while the cart moves on. The queue is the list of
/// open shots in the survey, which survives any end of the program. A download that fails is tried again
/// later, and once more at the end.
class PhotoFetcher {
  public:
    struct Events {
        /// A photo is in the survey, or the outcome says why not. Called on the fetcher's thread.
        std::function<void(const camera::ShotOutcome&)> ended;
        /// The survey cannot take photos any more. Called on the fetcher's thread; finish() throws why.
        std::function<void()> failed;
    };

    /// Owner: store, client and clock must outlive the object. Nobody else uses the client.
    PhotoFetcher(SharedStore& store, camera::OscClient& client, Clock& clock, camera::CaptureOptions options,
                 Events events);
    /// Stops at once. Photos that are not fetched stay in the queue.
    ~PhotoFetcher();
    PhotoFetcher(const PhotoFetcher&) = delete;
    PhotoFetcher& operator=(const PhotoFetcher&) = delete;

    /// Tells the thread that there may be something to fetch.
    void wake();

    /// Returns when each photo is fetched, or was tried in vain. Errors: the error that ended the thread;
    /// Stopped.
    void finish(const std::stop_token& stop);

    /// Asks the thread to stop, without waiting for it.
    void stopSoon() { m_thread.request_stop(); }

    /// Errors: the error that ended the thread, if one did.
    void throwIfFailed();

  private:
    void run(const std::stop_token& stop);
    bool isRoundDue(const std::stop_token& stop);
    void round(bool isLast, const std::stop_token& stop);
    camera::ShotOutcome fetch(const survey::Shot& shot, const std::stop_token& stop);
    void tell(const camera::ShotOutcome& outcome);

    Events m_events;
    StoreJournal m_journal;
    camera::Capture m_capture;
    std::chrono::milliseconds m_retryPause;
    mutable std::mutex m_mutex;
    std::condition_variable_any m_changed;
    bool m_isWoken = false;
    bool m_isFinishing = false;
    bool m_hasEnded = false;
    std::exception_ptr m_failure;
    std::set<std::int64_t> m_failed; ///< Shots that were tried in vain. Only the thread uses it.
    std::jthread m_thread;
};

/// Looks where photos were taken, on a thread of its own, while more are taken. Its places show people what
/// is covered by now, and have no other use: alignSurvey() finds them in earnest.
class PlaceFinder {
  public:
    /// Owner: all references must outlive the object.
    PlaceFinder(SharedStore& store, Operator& people);
    /// Stops at once.
    ~PlaceFinder() = default;
    PlaceFinder(const PlaceFinder&) = delete;
    PlaceFinder& operator=(const PlaceFinder&) = delete;

    /// Tells the thread that a photo has come in.
    void wake();

    /// Returns once all photos were looked at, what was found last. Errors: Stopped.
    PlacesFound finish(const std::stop_token& stop);

  private:
    void run(const std::stop_token& stop);
    void look(const std::stop_token& stop);
    PlacesFound show(store::SurveyStore& store, const PlacesSoFar& found);
    void tell(const PlacesFound& found);

    SharedStore& m_store;
    Operator& m_people;
    std::set<std::int64_t> m_shown; ///< Stations that show a place. Only the thread uses it.
    std::mutex m_mutex;             ///< Guards all members below.
    std::condition_variable_any m_changed;
    bool m_isWoken = false;
    bool m_isBusy = false;
    PlacesFound m_found;
    std::jthread m_thread;
};

/// The stations of a run, one after the other.
class Route {
  public:
    virtual ~Route() = default;

    /// Returns the next station once the camera stands there; nothing at the end. Errors: Stopped.
    virtual std::optional<store::StationRecord> next(const std::stop_token& stop) = 0;
};

/// One run of the capture workflow: exposes along a route, while a PhotoFetcher follows.
class CaptureRun {
  public:
    /// Owner: all references must outlive the run. finder: is told of the photos that come in; null without
    /// one.
    CaptureRun(SharedStore& store, camera::OscClient& client, Operator& people, Clock& clock,
               const camera::CaptureOptions& options, ProgressSink& progress, const std::stop_token& stop,
               PlaceFinder* finder = nullptr);

    /// Ends the shots that an earlier run left open. Afterwards the store knows which stations lack a photo.
    void begin();
    /// Whether a picture of this station was taken and is not downloaded yet.
    bool isOnItsWay(std::int64_t station) const;
    /// The verdict on a photo of the survey. A photo without one is judged now. Errors: those of
    /// PhotoJudge::judge().
    photo::Verdict verdictOn(std::int64_t photo);
    /// Exposes along the route, then waits for the downloads. Errors: those of captureSurvey().
    void take(Route& route);
    /// Ends the downloads and returns the report of the run.
    CaptureSurveyReport finish();

  private:
    void prepareAndTake(Route& route);
    void takeAndFetch(Route& route);
    void takeAlong(Route& route);
    camera::ShotOutcome expose(const store::StationRecord& station);
    void fetchNow(const camera::ShotOutcome& exposed);
    std::vector<std::string> sentences(const camera::CaptureNotes& notes) const;
    void warn(const std::vector<std::string>& sentences);
    std::optional<photo::Verdict> judged(const camera::ShotOutcome& outcome);
    void account(const camera::ShotOutcome& outcome, bool isTold = false);
    void judgeFetched();
    void correctEarly();
    void tellIfFlawed(const std::string& station, const photo::Verdict& verdict);

    SharedStore& m_store;
    Operator& m_people;
    Clock& m_clock;
    ProgressSink& m_progress;
    std::stop_source m_end; ///< The caller asks for it, or the survey takes no more photos.
    std::stop_callback<std::function<void()>> m_callersStop;
    std::stop_token m_stop = m_end.get_token();
    StoreJournal m_journal;
    camera::Capture m_capture;
    Clock::TimePoint m_begin;
    camera::CameraInfo m_camera;
    std::int64_t m_lastEarlierShot = 0;
    mutable std::mutex m_mutex; ///< Guards all members below.
    CaptureSurveyReport m_report;
    std::map<std::int64_t, std::vector<std::string>> m_warningsOf; ///< By the number of the shot.
    std::set<std::int64_t> m_unfetched;                            ///< Shots that were tried in vain.
    std::set<std::int64_t> m_judged;                               ///< Photos that came in with this run.
    PhotoJudge m_judge;
    PlaceFinder* m_finder;
    std::unique_ptr<camera::OscClient> m_fetchersClient;
    std::unique_ptr<PhotoFetcher> m_fetcher;
};

} // namespace spherewalk::jobs
