// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/jobs/align_survey.h"
#include "spherewalk/store/survey_store.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace spherewalk::jobs {

/// True poses of photos, by the number of the photo in the store.
using TruePoses = std::map<std::int64_t, Rigid3>;

/// From the truth of a practice camera (JSON lines, a name that ends in .jsonl) or from a positions file with
/// rotations, see positions_csv.h. Photos that the survey does not have are left out, and photos of the
/// survey may be missing. Errors: those of reading either; NotFound if it knows none of the survey's photos.
TruePoses readTruePoses(const store::SurveyStore& store, const std::filesystem::path& file);

/// How far solved rotations are from the true ones. The yaw that all have in common is taken off the yaws.
struct AlignmentError {
    int photos = 0;
    double yawRmsDeg = 0;
    double yawWorstDeg = 0;
    double commonYawDeg = 0;
    double tiltRmsDeg = 0;    ///< of pitch and roll
    double commonLeanDeg = 0; ///< by which the whole leans, a part of the tilts
    double ownTiltRmsDeg = 0; ///< the common lean taken off
    double tiltWorstDeg = 0;
    double positionRmsM = 0; ///< along each axis, the common offset taken off
    /// Root mean square of error / sigma: 1 if the stated deviations are right.
    double yawOverSigma = 0;
    double tiltOverSigma = 0;
    double within3Sigma = 0; ///< share of all yaws, pitches and rolls
};

/// Photos that are unsolved or have no truth do not count; all zero if none is left.
AlignmentError alignmentError(const AlignReport& report, const TruePoses& truth);

Json toJson(const AlignmentError& error);

} // namespace spherewalk::jobs
