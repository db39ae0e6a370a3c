// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/jobs/capture_survey.h"

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::jobs {

/// Where a robot says that the camera stands.
struct ReachedPosition {
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero(); ///< Place of the lens, room frame.
    bool again = false; ///< Whether to take the photo although the station has one.

    bool operator==(const ReachedPosition&) const = default;
};

/// Reads "x y z" in metres, optionally followed by "again", or the object
/// {"x": .., "y": .., "z": .., "again": true}. Errors: InvalidInput, whose sentence says what was expected.
ReachedPosition parseReachedPosition(std::string_view line);

/// One event that the robot is told.
struct FollowEvent {
    enum class Kind {
        Refused, ///< The line led to no photo: it cannot be read, or no station is there.
        Exposed, ///< The exposure is over, and the robot may move.
        Verdict, ///< The photo is in the survey.
        Missed,  ///< The photo is not in the survey; the sentence says why.
    };

    Kind kind = Kind::Refused;
    std::string station;  ///< Empty if the line led to no station.
    std::string verdict;  ///< "good", "doubtful" or "failed" for Kind::Verdict, else empty.
    std::string sentence; ///< Empty if there is nothing to say.
};

/// The event as a line: "exposed rail 1, stop 2", or "doubtful rail 1, stop 2: It is blurred: ...".
std::string line(const FollowEvent& event);
Json toJson(const FollowEvent& event);

struct FollowOptions {
    camera::CaptureOptions camera; ///< The job itself sets the download check and the profile.
    double toleranceM = 0.03;      ///< Largest distance from the position to its station.

    /// Errors: InvalidInput, whose sentence names the option and its range.
    void validate() const;
};

/// The connection between the robot and the job.
struct FollowLink {
    /// Returns the next line that the robot sends, or nothing at the end. Errors: Stopped.
    std::function<std::optional<std::string>(const std::stop_token&)> nextLine;
    /// Takes the lines that have arrived and were not read, without waiting. May be empty. It is called when
    /// an exposure is over: what the robot sent before is where the camera stood before, and is refused.
    std::function<std::vector<std::string>()> waitingLines;
    /// Called before the photo is taken; a practice camera must be told where it stands. May be empty.
    std::function<void(const store::StationRecord&, const std::stop_token&)> reached;
    /// Tells the robot an event. Threads: any, one at a time.
    std::function<void(const FollowEvent&)> tell;
};

/// Takes a photo of the station that stands at each position that the robot reaches. A line that cannot be
/// followed is answered, and the run goes on. So is a line that arrived before the exposure at the last
/// position was over, because the camera may have moved since. A station that has a photo is taken again only
/// if the line says "again"; otherwise the robot is told its verdict. Errors: as captureSurvey().
CaptureSurveyReport followPositions(store::SurveyStore& store, camera::OscClient& client,
                                    const FollowLink& link, Clock& clock, FollowOptions options,
                                    ProgressSink& progress, const std::stop_token& stop);

} // namespace spherewalk::jobs
