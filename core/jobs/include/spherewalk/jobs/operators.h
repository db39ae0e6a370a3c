// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/camera/http.h"
#include "spherewalk/jobs/capture_survey.h"

namespace spherewalk::jobs {

/// Moves a practice camera, over HTTP, to each station. Tries a shot that was not taken up to three times.
class PracticeOperator : public Operator {
  public:
    /// moveTime: of the cart, from a station to the next.
    explicit PracticeOperator(camera::Endpoint endpoint, Clock::Duration moveTime = {},
                              Clock& clock = systemClock())
        : m_http(std::move(endpoint)), m_moveTime(moveTime), m_clock(clock) {}

    /// Errors: also Unsupported, if the camera is none that can be moved so.
    void moveTo(const store::StationRecord& station, const std::stop_token& stop) override;
    bool tryAgain(const store::StationRecord& station, const camera::ShotOutcome& outcome, int tries,
                  const std::stop_token& stop) override;

  private:
    camera::HttpClient m_http;
    Clock::Duration m_moveTime;
    Clock& m_clock;
};

/// The options for a practice camera whose time runs `timeScale` as fast as a real one's, which still needs
/// its own time to draw a picture.
CaptureSurveyOptions practiceCaptureOptions(double timeScale);

} // namespace spherewalk::jobs
