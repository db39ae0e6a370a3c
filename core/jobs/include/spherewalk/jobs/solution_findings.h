// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/jobs/align_survey.h"
#include "spherewalk/store/records.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::jobs {

/// Where a photo was really taken.
struct PhotoPlace {
    std::int64_t photo = 0;
    std::int64_t station = 0;
    std::optional<Eigen::Vector3d> positionM = {}; ///< Place of the lens; nothing means the station's.
    bool choose = true; ///< Whether the photo replaces the one that the station has chosen.

    bool operator==(const PhotoPlace&) const = default;
};

/// Moves photos to other stations, all at once: in the survey, and in the position tags of the files, which
/// are written anew. Returns the earlier places of all photos of these stations; moving the photos there
/// undoes the call. Killed at any instant, it leaves the survey as it was or as it shall be, and at worst
/// files that belong to no photo. A photo whose position changes leaves the active solution, with a warning.
///
/// Errors: NotFound; InvalidInput for a photo that is named twice; those of reading, tagging and writing.
/// Stop: Stopped, with nothing changed.
std::vector<PhotoPlace> retagPhotos(store::SurveyStore& store, const std::vector<PhotoPlace>& places,
                                    ProgressSink& progress, const std::stop_token& stop);

/// What a recorded solution says of one photo.
struct PhotoFinding {
    std::int64_t photo = 0;
    std::int64_t station = 0; ///< Station that the photo belongs to now.
    std::string file;         ///< Present name of the file.
    std::string stationName;
    std::optional<survey::Quality> quality; ///< Nothing for a photo that the solution lacks.
    bool isImported = false;                ///< The pose was given with the photo, and nothing graded it.
    std::optional<Rigid3> roomFromPhoto;
    std::optional<Radians> sigmaYaw;
    std::optional<Radians> sigmaTilt; ///< The larger one of pitch and roll.
    std::optional<Radians> residual;  ///< Root mean square over the matches that hold the photo.
    int neighbours = 0;               ///< Number of pairs that hold the photo.
    std::vector<std::string> flags;   ///< Sentences.
    std::optional<std::int64_t> fits; ///< Station that the photo should belong to, if it is another one.
    Cure cure = Cure::None;
};

struct SolutionFindings {
    store::SolutionRecord solution;
    std::string reason;                   ///< Sentence that says why this model; empty if not known.
    bool isFree = false;                  ///< Places were solved from the pictures alone.
    double positionSigmaM = 0;            ///< What the tags were said to err by; 0 if not known.
    double scaleSigma = 0;                ///< Of all lengths, as a share of them; 0 if not known.
    std::vector<std::string> warnings;    ///< Sentences about the solution as a whole.
    std::vector<std::string> tagWarnings; ///< Those warnings that say that all tags are wrong.
    std::vector<PhotoFinding> photos;     ///< In walking order; photos that the survey lost are left out.

    /// The moves that put every photo that fits another station there.
    std::vector<PhotoPlace> retags() const;
};

/// What the active solution says; nothing if there is none. Errors: Corrupt if the solution's report is none.
std::optional<SolutionFindings> activeFindings(const store::SurveyStore& store);

/// The kept photos that a dataset gets: all but those that the active solution found no pose for, and those
/// that nobody knows the place of.
struct PhotosToExport {
    std::vector<store::PhotoRecord> photos;
    std::vector<store::PhotoRecord> failed;
    double scaleSigma = 0;           ///< As SolutionFindings::scaleSigma.
    std::vector<std::string> doubts; ///< Sentences: what is wrong with all places, and which photos failed.

    /// All doubts one after the other. Where photos failed, they say why.
    std::string allDoubts() const;
};

/// Errors: those of activeFindings().
PhotosToExport photosToExport(const store::SurveyStore& store);

/// A sentence on the kept photos that the active solution puts nearer to another station than to their own,
/// and farther from it than tags were said to err; "" without any. Errors: those of activeFindings().
std::string placesInDoubt(const store::SurveyStore& store);

} // namespace spherewalk::jobs
