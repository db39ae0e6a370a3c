// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/operators.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>

namespace spherewalk::jobs {

void PracticeOperator::moveTo(const store::StationRecord& station, const std::stop_token& stop) {
    m_clock.sleep(m_moveTime, stop);
    throwIfStopped(stop);
    const Eigen::Vector3d& p = station.station.positionM;
    const Json pose = {{"x", p.x()}, {"y", p.y()}, {"z", p.z()}};
    const camera::HttpResponse response = m_http.post("/practice/pose", pose.dump(), stop);
    if (response.status != 200) {
        throw Error(ErrorKind::Unsupported,
                    text("The camera at ", m_http.endpoint().name(),
                         " is no practice camera: it cannot be moved by itself. Leave --practice out "
                         "and bring it to each station."));
    }
}

bool PracticeOperator::tryAgain(const store::StationRecord& /*station*/,
                                const camera::ShotOutcome& /*outcome*/, int tries,
                                const std::stop_token& /*stop*/) {
    constexpr int kMostTries = 3;
    return tries < kMostTries;
}

CaptureSurveyOptions practiceCaptureOptions(double timeScale) {
    using namespace std::chrono_literals;
    CaptureSurveyOptions options{camera::CaptureOptions{}.scaled(timeScale)};
    options.camera.allowance.base = std::max<std::chrono::milliseconds>(options.camera.allowance.base, 10s);
    options.camera.idleTime = std::max<std::chrono::milliseconds>(options.camera.idleTime, 60s);
    return options;
}

} // namespace spherewalk::jobs
