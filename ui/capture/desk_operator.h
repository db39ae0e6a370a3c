// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/capture/camera_status.h"
#include "ui/capture/verdict.h"

#include "spherewalk/jobs/operators.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>

namespace spherewalk::ui {

/// The key in the operator's hand, between the window and the capturing thread. Threads: any.
class ShutterKey {
  public:
    void press();
    /// A press before it counts for nothing: the key of an earlier station must not take this one.
    void forget();
    /// Returns true once pressed, false after `atMost`. Errors: Stopped.
    bool wait(std::chrono::milliseconds atMost, const std::stop_token& stop);

  private:
    std::mutex m_mutex;
    std::condition_variable_any m_pressed;
    bool m_isPressed = false;
};

/// What a run tells the window. All are called on the capturing thread, but for `ended`, which may come from
/// the one that downloads.
struct DeskEvents {
    std::function<void(CameraStatus)> status;
    std::function<bool()>
        quiet; ///< ends the preview, returns when it has ended, and says whether there was one
    std::function<void(QString)> noAnswer; ///< the camera does not say how it is; why
    std::function<void(store::StationRecord)> atStation;
    std::function<void(store::StationRecord, QString)> askAgain; ///< no picture was taken; why
    std::function<void()> shooting;
    /// isThere: a photo came into the survey.
    std::function<void(store::StationRecord, Verdict, bool isThere, QString)> ended;
};

/// A person at the window: each station waits for the key. With a practice camera the cart is moved over
/// HTTP, and the key may be left out. Threads: the capturing one.
class DeskOperator : public jobs::Operator {
  public:
    /// practice: the practice camera's address, where it is one. isAutomatic: shoots without the key.
    DeskOperator(camera::OscClient& client, ShutterKey& key, DeskEvents events,
                 const std::optional<camera::Endpoint>& practice, bool isAutomatic);

    void cameraReady(const camera::CameraInfo& camera, const camera::CameraReadiness& readiness) override;
    void moveTo(const store::StationRecord& station, const std::stop_token& stop) override;
    bool tryAgain(const store::StationRecord& station, const camera::ShotOutcome& outcome, int tries,
                  const std::stop_token& stop) override;
    void shotEnded(const store::StationRecord& station, const camera::ShotOutcome& outcome,
                   const photo::Verdict* verdict) override;

    /// How often the camera is asked how it is, while nothing else is.
    static constexpr std::chrono::milliseconds kStatePause{5000};

  private:
    void waitForKey(const std::stop_token& stop);
    void exposed(const store::StationRecord& station) override;

    camera::OscClient& m_client;
    ShutterKey& m_key;
    DeskEvents m_events;
    std::optional<jobs::PracticeOperator> m_practice;
    bool m_isAutomatic;
    CameraStatus m_status;
};

} // namespace spherewalk::ui
