// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/jobs/capture_survey.h"

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace spherewalk::jobs {

/// Where a robot says that the camera stands.
struct ReachedPosition {
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero(); ///< of the lens, room frame
    bool again = false;                                  ///< take the photo although the station has one

    bool operator==(const ReachedPosition&) const = default;
};

/// Reads "x y z" in metres, with "again" behind it if wanted, or {"x": .., "y": .., "z": .., "again": true}.
/// Errors: InvalidInput, with what was expected.
ReachedPosition parseReachedPosition(std::string_view line);

/// What a robot is told, an event at a time.
struct FollowEvent {
    enum class Kind {
        Refused, ///< the line led to no photo: it cannot be read, or no station is there
        Exposed, ///< the exposure is over: the robot may move
        Verdict, ///< the photo is in the survey
        Missed,  ///< it is not, and the sentence says why
    };

    Kind kind = Kind::Refused;
    std::string station;  ///< "" if the line named none
    std::string verdict;  ///< "good", "doubtful" or "failed", of Verdict
    std::string sentence; ///< "" if there is nothing to say
};

/// "exposed rail 1, stop 2"; "doubtful rail 1, stop 2: It is blurred: ...".
std::string line(const FollowEvent& event);
Json toJson(const FollowEvent& event);

struct FollowOptions {
    camera::CaptureOptions camera; ///< its download check and profile are set by the job
    double toleranceM = 0.03;      ///< from the position to its station

    /// Errors: InvalidInput, with the option and its range.
    void validate() const;
};

/// How a robot and the job speak with each other.
struct FollowLink {
    /// The next line that the robot sends; nothing at the end. Errors: Stopped.
    std::function<std::optional<std::string>(const std::stop_token&)> nextLine;
    /// Before the photo is taken: for a practice camera, which must be told where it stands. May be empty.
    std::function<void(const store::StationRecord&, const std::stop_token&)> reached;
    /// Threads: any, one at a time.
    std::function<void(const FollowEvent&)> tell;
};

/// Takes a photo at each position that a robot reaches, of the station that stands there. A line that cannot
/// be followed is answered and does not end the run. A station that has a photo is not taken twice, unless
/// the line says "again": its verdict is told. Errors: as captureSurvey().
CaptureSurveyReport followPositions(store::SurveyStore& store, camera::OscClient& client,
                                    const FollowLink& link, Clock& clock, FollowOptions options,
                                    ProgressSink& progress, const std::stop_token& stop);

} // namespace spherewalk::jobs
