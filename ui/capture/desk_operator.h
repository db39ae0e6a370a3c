// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/capture/cameras.h"

#include "spherewalk/jobs/capture_survey.h"
#include "spherewalk/store/records.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>

namespace spherewalk::ui {

class CaptureDesk;

/// Returns the result of a shot for the operator. Good: the survey has the photo and nobody must read
/// anything. Doubtful: there is something to read, or the photo is still on the camera. found: findings of
/// the checks; null without a photo.
survey::Quality qualityOf(const camera::ShotOutcome& outcome, const photo::Verdict* found);

/// The key in the operator's hand, between the window and the capturing thread. Threads: any.
class ShutterKey {
  public:
    void press();
    /// Forgets a press that nobody has waited for, so that the key of one station never takes the next.
    void forget();
    /// Tells that the operator takes no more photos. Whoever waits for the key goes on.
    void leave();
    /// Begins a run: forgets the press and the leaving of the one before.
    void begin();
    bool hasLeft();
    /// Returns true once the key is pressed, or the operator has left, and false after `atMost`. Errors:
    /// Stopped.
    bool wait(std::chrono::milliseconds atMost, const std::stop_token& stop);

  private:
    std::mutex m_mutex;
    std::condition_variable_any m_pressed;
    bool m_isPressed = false;
    bool m_hasLeft = false;
};

/// How one run is operated.
struct DeskOptions {
    int run = 0;                              ///< The desk drops what other runs post.
    std::optional<camera::Endpoint> practice; ///< Address of the practice camera, where it takes the photos.
    bool isAutomatic = false;                 ///< Takes each photo without the key.
};

/// A person at the window, as jobs::captureSurvey() sees that person: each station waits for the key. All
/// that a run tells is posted to the desk. A practice camera's cart is moved over HTTP.
/// Threads: made and called on the capturing thread; shotEnded() also comes from the downloading thread.
class DeskOperator : public jobs::Operator {
  public:
    /// Range: a practice camera if the desk's options leave the key out.
    /// Owner: the desk outlives this operator.
    DeskOperator(CaptureDesk& desk, camera::OscClient& client, const DeskOptions& options);

    void cameraReady(const camera::CameraInfo& camera, const camera::CameraReadiness& readiness) override;
    void moveTo(const store::StationRecord& station, const std::stop_token& stop) override;
    bool walkOn(int photo, const std::stop_token& stop) override;
    void placesFound(const jobs::PlacesFound& found) override;
    bool tryAgain(const store::StationRecord& station, const camera::ShotOutcome& outcome, int tries,
                  const std::stop_token& stop) override;
    void shotEnded(const store::StationRecord& station, const camera::ShotOutcome& outcome,
                   const photo::Verdict* verdict) override;

    /// While the operator waits for the key, the camera is asked this often how it is.
    static constexpr std::chrono::milliseconds kStatePause{2000};

  private:
    void waitForKey(const std::stop_token& stop);
    void exposed(const store::StationRecord& station) override;
    void post(std::function<void(CaptureDesk&)> apply) const;
    void postStatus() const;

    CaptureDesk& m_desk;
    camera::OscClient& m_client;
    DeskOptions m_options;
    std::optional<jobs::PracticeOperator> m_practice;
    CameraStatus m_status;
};

} // namespace spherewalk::ui
