// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/effort.h"
#include "spherewalk/align/position_check.h"
#include "spherewalk/align/solve.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/store/survey_store.h"

#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::jobs {

struct AlignOptions {
    align::Effort effort = align::Effort::Normal;
    align::Model model = align::Model::Auto;
    /// Grey picture of any size, 2:1, black where photos are not to be looked at; empty: none.
    std::filesystem::path mask;
    /// How far photos stand from where their tags say, one standard deviation along x and along y; above 0.
    double positionSigmaM = 0.005;
    bool checksPositions = true; ///< look for wrong position tags; the positions that fit are solved with
    /// Where what was found in the pictures is kept; empty: in the survey's `align-cache`.
    std::filesystem::path cacheFolder;
    bool isRecorded = true;  ///< as a solution of the store
    bool isActivated = true; ///< the solution takes the place of the active one
    int threads = 0;         ///< 0: all that the machine has
};

/// What helps a photo that is doubtful or failed.
enum class Cure {
    None,
    Retag,  ///< it belongs to another station, AlignedPhoto::fits
    Retake, ///< another photo at its station
    Mask,   ///< leave out what misleads: mirrors, screens, what moves
};

/// As reports spell it: "none", "retag", "retake", "mask".
std::string_view name(Cure cure);

/// Errors: InvalidInput, listing the names.
Cure cureNamed(std::string_view name);

/// What people read of a photo.
struct AlignedPhoto {
    std::int64_t photo = 0;
    std::string file;
    std::string station;
    std::string status; ///< "good", "doubtful", "failed"
    align::SolvedPose pose;
    std::vector<std::string> flags; ///< sentences
    std::string fits;               ///< the station that its position tag should name; "" for its own
    Cure cure = Cure::None;
};

struct AlignReport {
    std::int64_t solution = 0; ///< in the store; 0: not recorded
    align::Effort effort = align::Effort::Normal;
    align::Alignment alignment; ///< of `photos`, in the same order
    std::vector<AlignedPhoto> photos;
    std::size_t features = 0; ///< of all photos
    int fromCache = 0;        ///< photos whose features were found by an earlier run
    std::size_t pairs = 0;    ///< of photos that were compared
    std::size_t holdingPairs = 0;
    double featureSeconds = 0;
    double matchSeconds = 0; ///< and estimating each pair
    double solveSeconds = 0; ///< and checking
    double seconds = 0;
};

/// Solves the rotations of all chosen photos, and records them. What was found in
/// the pictures is kept, so that a run that was stopped, or another
/// model, does not begin anew. Errors: InvalidInput for a survey without photos; those of reading photos,
/// named; Stopped, with the survey unchanged but for that folder.
AlignReport alignSurvey(store::SurveyStore& store, const AlignOptions& options, ProgressSink& progress,
                        const std::stop_token& stop);

/// model, effort, seconds, reason, photos: as resources/docs/formats.md says.
Json toJson(const AlignReport& report);

/// For people: what was solved, what is doubtful and what to do about it.
std::string alignText(const AlignReport& report);

} // namespace spherewalk::jobs
