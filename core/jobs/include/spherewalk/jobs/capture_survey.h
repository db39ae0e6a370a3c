// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/clock.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/camera/capture.h"
#include "spherewalk/photo/verdict.h"
#include "spherewalk/store/survey_store.h"

#include <chrono>
#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::jobs {

/// Who brings the camera from station to station: a person at a terminal, a window, a robot, a practice cart.
/// Threads: the capturing one, but for shotEnded().
class Operator {
  public:
    virtual ~Operator() = default;

    /// Once, when the camera can take pictures.
    virtual void cameraReady(const camera::CameraInfo& /*camera*/,
                             const camera::CameraReadiness& /*readiness*/) {}

    /// Returns when the camera stands at the station. Errors: Stopped.
    virtual void moveTo(const store::StationRecord& station, const std::stop_token& stop) = 0;

    /// After a shot of which it is certain that no picture was taken: true to trigger again, once.
    virtual bool tryAgain(const store::StationRecord& station, const camera::ShotOutcome& outcome, int tries,
                          const std::stop_token& stop) = 0;

    /// The exposure is over and the picture is on the camera: the cart may move.
    virtual void exposed(const store::StationRecord& /*station*/) {}

    /// After each shot, and each that an earlier run had left open: its photo is in the survey, with what the
    /// checks say of it, or the outcome says why not (then `verdict` is null). Threads: any, one at a time,
    /// also while moveTo() waits.
    virtual void shotEnded(const store::StationRecord& /*station*/, const camera::ShotOutcome& /*outcome*/,
                           const photo::Verdict* /*verdict*/) {}
};

struct CaptureSurveyOptions {
    camera::CaptureOptions camera;        ///< its download check and profile are set by the job
    int most = 0;                         ///< photos to take at most; 0: all that are missing
    std::vector<std::int64_t> again = {}; ///< stations to take besides, although they have a photo
};

/// A station whose photo is not in the survey after all, and why.
struct MissedStation {
    std::string station;
    std::string sentence;
};

/// A photo that the checks do not find good.
struct FlawedPhoto {
    std::string station;
    photo::Verdict verdict;
};

struct CaptureSurveyReport {
    int taken = 0;     ///< photos that came into the survey in this run
    int resumed = 0;   ///< of them, from shots that an earlier run had left open
    int exposed = 0;   ///< pictures that the camera took in this run
    int stations = 0;  ///< of the survey
    int remaining = 0; ///< still without a photo
    std::vector<MissedStation> missed;
    std::vector<FlawedPhoto> flawed;
    std::vector<std::string> warnings;
    double seconds = 0;           ///< of all
    double secondsAtStations = 0; ///< from the way to the first station to the end of the last exposure
    double secondsMoving = 0;     ///< of these, waiting for the operator
    double secondsExposing = 0;   ///< of these, from the triggers to the known files
    double secondsFetching = 0;   ///< downloads with their checks, beside all this
    double secondsJudging = 0;    ///< verdicts, likewise
};

/// Takes the missing photos of the survey, with the camera set by the survey's capture profile, and those
/// asked for again, in walking order. Each photo is downloaded and judged in the background while the cart
/// moves on; what could not be downloaded stays queued in the survey, and a later run fetches it. It can be
/// killed at any instant and called again. Errors: NotFound for an unknown station to take again; those of
/// camera::Capture and of the store; Stopped, with all that is complete kept.
CaptureSurveyReport captureSurvey(store::SurveyStore& store, camera::OscClient& client, Operator& people,
                                  Clock& clock, CaptureSurveyOptions options, ProgressSink& progress,
                                  const std::stop_token& stop);

/// The check that downloads need: decodes the whole picture.
camera::PhotoCheck photoCheck();

Json toJson(const CaptureSurveyReport& report);

} // namespace spherewalk::jobs
