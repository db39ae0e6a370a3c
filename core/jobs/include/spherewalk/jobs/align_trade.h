// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/jobs/align_survey.h"

#include <map>
#include <optional>

namespace spherewalk::jobs {

/// True poses of photos, by the number of the photo in the store.
using TruePoses = std::map<std::int64_t, Rigid3>;

/// Reads true poses from the truth of a practice camera (JSON lines, a name that ends in .jsonl), or from a
/// positions file with rotations (positions_csv.h). Photos that the survey does not have are left out, and
/// photos of the survey may be missing.
///
/// Errors: those of reading either file; NotFound if the file knows none of the survey's photos.
TruePoses readTruePoses(const store::SurveyStore& store, const std::filesystem::path& file);

/// How far solved rotations are from the true ones, after the yaw that all photos share is taken off.
struct AlignmentError {
    int photos = 0; ///< Number of photos that were compared.
    double yawRmsDeg = 0;
    double yawWorstDeg = 0;
    double commonYawDeg = 0;  ///< Yaw that was taken off.
    double tiltRmsDeg = 0;    ///< Root mean square of all pitches and rolls.
    double commonLeanDeg = 0; ///< Angle by which the whole leans. The tilts contain it.
    double ownTiltRmsDeg = 0; ///< Tilt without the common lean.
    double tiltWorstDeg = 0;
    double positionRmsM = 0; ///< Along each axis, without the common offset.
    double yawOverSigma = 0; ///< Root mean square of error / sigma; 1 if the stated sigmas are right.
    double tiltOverSigma = 0;
    double within3Sigma = 0; ///< Share of all yaws, pitches and rolls. Range: 0 to 1.
};

/// Photos that are unsolved or have no truth do not count. All values are zero if no photo is left.
AlignmentError alignmentError(const AlignReport& report, const TruePoses& truth);

Json toJson(const AlignmentError& error);

/// Which efforts and models to try.
struct AlignTradeOptions {
    std::vector<align::Effort> efforts = {align::Effort::Draft, align::Effort::Normal, align::Effort::Fine,
                                          align::Effort::Exact};
    std::vector<align::Model> models = {align::Model::Yaw, align::Model::Tilt, align::Model::Placement,
                                        align::Model::Position};
    std::filesystem::path mask; ///< As AlignOptions::mask.
    TruePoses truth;            ///< May be empty; then the rows state no error.
    int threads = 0;            ///< Range: 0 or above; 0 means all that the machine has.
};

/// What one effort with one model costs and gains.
struct AlignTradeRow {
    align::Effort effort = align::Effort::Normal;
    std::string detector;
    int width = 0; ///< Working pixels per turn.
    int most = 0;  ///< Largest number of features in a photo.
    align::Model model = align::Model::Yaw;
    double featureSeconds = 0; ///< Time without help from an earlier run.
    double matchSeconds = 0;
    double solveSeconds = 0;
    int solved = 0;                      ///< Number of photos.
    std::optional<AlignmentError> error; ///< Nothing where no truth is known.
    std::optional<double> heldOutDeg;    ///< Misfit of matches that the solver did not see.
    double cycleErrorDeg = 0;            ///< Rotation that remains around triangles of pairs.
    double sigmaYawDeg = 0;              ///< Median of the deviations that the solution states.

    double seconds() const { return featureSeconds + matchSeconds + solveSeconds; }
};

struct AlignTrade {
    std::size_t photos = 0;
    bool hasTruth = false;
    std::vector<AlignTradeRow> rows; ///< By effort, then by model.
};

/// Aligns the survey with each effort and model, and reports what each costs and gains. The store records
/// nothing. Errors: those of alignSurvey().
AlignTrade alignTrade(store::SurveyStore& store, const AlignTradeOptions& options, ProgressSink& progress,
                      const std::stop_token& stop);

Json toJson(const AlignTrade& trade);

/// A table for people, with a line of explanation above it.
std::string tradeTable(const AlignTrade& trade);

/// An SVG drawing of error against time.
std::string tradePlot(const AlignTrade& trade, const std::string& title);

} // namespace spherewalk::jobs
