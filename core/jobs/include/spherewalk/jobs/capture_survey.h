// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/clock.h"
#include "spherewalk/base/json_fwd.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/camera/capture_options.h"
#include "spherewalk/camera/http.h"
#include "spherewalk/photo/verdict.h"

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::camera {
class OscClient;
struct CameraInfo;
struct CameraReadiness;
struct ShotOutcome;
} // namespace spherewalk::camera

namespace spherewalk::store {
class SurveyStore;
struct StationRecord;
} // namespace spherewalk::store

namespace spherewalk::jobs {

/// Where the photos of a survey by hand seem to have been taken, as far as they tell by now.
struct PlacesFound {
    int photos = 0;                    ///< All that were looked at.
    std::vector<std::int64_t> placed;  ///< Stations whose photos are placed against each other.
    std::vector<std::string> unplaced; ///< Names of the others' stations.
    /// Sentences that say why nothing is placed, or why the look has failed; the rest is then of the one
    /// before.
    std::string trouble = {};

    /// A sentence for the operator.
    std::string sentence() const;
};

/// Who brings the camera from station to station: a person at a terminal, a window, a robot, a practice cart.
/// Threads: calls come from the capturing thread, except for shotEnded() and placesFound().
class Operator {
  public:
    virtual ~Operator() = default;

    /// Called once, when the camera can take pictures.
    virtual void cameraReady(const camera::CameraInfo& /*camera*/,
                             const camera::CameraReadiness& /*readiness*/) {}

    /// Returns when the camera stands at the station. Errors: Stopped.
    virtual void moveTo(const store::StationRecord& station, const std::stop_token& stop) = 0;

    /// In a survey by hand: returns true when the camera stands where the next photo is to be taken, and
    /// false when no more are wanted. photo: its number in this run, counted from 1. Errors: Stopped.
    virtual bool walkOn(int /*photo*/, const std::stop_token& /*stop*/) { return false; }

    /// In a survey by hand, called each time when places were looked for. Threads: any, one at a time.
    virtual void placesFound(const PlacesFound& /*found*/) {}

    /// Called after a shot that certainly took no picture. Returns true to trigger once more. tries: shots at
    /// this station so far, counted from 1.
    virtual bool tryAgain(const store::StationRecord& station, const camera::ShotOutcome& outcome, int tries,
                          const std::stop_token& stop) = 0;

    /// The exposure is over and the camera holds the picture: the cart may move.
    virtual void exposed(const store::StationRecord& /*station*/) {}

    /// Called after each shot, and for each shot that an earlier run left open. With a verdict, the photo is
    /// in the survey. If `verdict` is null, the outcome says why the photo is not.
    /// Threads: any, one at a time, also while moveTo() waits.
    virtual void shotEnded(const store::StationRecord& /*station*/, const camera::ShotOutcome& /*outcome*/,
                           const photo::Verdict* /*verdict*/) {}
};

struct CaptureSurveyOptions {
    camera::CaptureOptions camera;        ///< The job itself sets the download check and the profile.
    int most = 0;                         ///< Largest number of photos to take; 0 means all that are missing.
    std::vector<std::int64_t> again = {}; ///< Stations to photograph although they have a photo.
    /// Whether photos are taken wherever the operator stands, and not at stations: see isByHand().
    bool byHand = false;
};

/// A station whose photo is not in the survey after all.
struct MissedStation {
    std::string station;
    std::string sentence; ///< Says why.
};

/// A photo that the checks do not find good.
struct FlawedPhoto {
    std::string station;
    photo::Verdict verdict;
};

struct CaptureSurveyReport {
    int taken = 0;     ///< Photos that came into the survey in this run.
    int resumed = 0;   ///< Photos among `taken` whose shots an earlier run left open.
    int exposed = 0;   ///< Pictures that the camera took in this run.
    int stations = 0;  ///< Stations of the survey.
    int remaining = 0; ///< Stations that still have no photo.
    std::vector<MissedStation> missed;
    std::vector<FlawedPhoto> flawed;
    int notCompared = 0;        ///< Photos among `taken` that no neighbour could be compared with.
    int contentNotCompared = 0; ///< Photos among `taken` in which persons were not looked for.
    std::vector<std::string> warnings;
    double seconds = 0;
    double secondsAtStations = 0; ///< From the start towards the first station to the last exposure's end.
    double secondsMoving = 0;     ///< Part of secondsAtStations in which the operator moved the camera.
    double secondsExposing = 0;   ///< Part of secondsAtStations from the triggers to the known files.
    double secondsFetching = 0;   ///< Downloads with their checks; they run beside the exposures.
    double secondsJudging = 0;    ///< Verdicts; they run beside the exposures.
    std::optional<PlacesFound> places; ///< Of a survey by hand.
};

/// Whether capturing goes on by hand by itself: the survey has no rails, and no photo of a known place is
/// missing.
bool isByHand(const store::SurveyStore& store);

/// Takes the missing photos of the survey, and those of `options.again`, in walking order. By hand, it takes
/// photos wherever the operator stands instead; each gets a station of unknown place. While more are taken,
/// it looks where they were taken, and a survey without rails shows these places, and the room as far as it
/// was seen. The survey's capture profile sets the camera. Downloads and verdicts run in the background while
/// the cart moves on. The survey queues photos that could not be downloaded, and a later run fetches them.
/// The program may be killed at any instant; the next call goes on.
///
/// Errors: NotFound for an unknown station in `options.again`; those of camera::Capture and of the store.
/// Stop: Stopped, with all complete photos kept.
CaptureSurveyReport captureSurvey(store::SurveyStore& store, camera::OscClient& client, Operator& people,
                                  Clock& clock, CaptureSurveyOptions options, ProgressSink& progress,
                                  const std::stop_token& stop);

/// The check that downloads need: it decodes the whole picture.
camera::PhotoCheck photoCheck();

Json toJson(const CaptureSurveyReport& report);

/// Moves a practice camera to each station, or on through its room, over HTTP. Triggers a shot that took no
/// picture up to three times.
class PracticeOperator : public Operator {
  public:
    /// moveTime: how long the cart takes from one station to the next.
    explicit PracticeOperator(camera::Endpoint endpoint, Clock::Duration moveTime = {},
                              Clock& clock = systemClock())
        : m_http(std::move(endpoint)), m_moveTime(moveTime), m_clock(clock) {}

    /// Errors: Stopped; Unsupported if the camera is no practice camera.
    void moveTo(const store::StationRecord& station, const std::stop_token& stop) override;
    bool walkOn(int photo, const std::stop_token& stop) override;
    bool tryAgain(const store::StationRecord& station, const camera::ShotOutcome& outcome, int tries,
                  const std::stop_token& stop) override;

  private:
    Json ask(const std::string& path, const Json& body, const std::stop_token& stop);

    camera::HttpClient m_http;
    Clock::Duration m_moveTime;
    Clock& m_clock;
};

/// Options for a practice camera whose waiting times are `timeScale` times those of a real camera. Time
/// limits stay long enough for the practice camera to draw its pictures. Range: 0 < timeScale <= 100.
CaptureSurveyOptions practiceCaptureOptions(double timeScale);

} // namespace spherewalk::jobs
