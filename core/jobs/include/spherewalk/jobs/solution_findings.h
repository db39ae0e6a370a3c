// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/jobs/align_survey.h"
#include "spherewalk/jobs/retag_photos.h"
#include "spherewalk/store/survey_store.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace spherewalk::jobs {

/// What a recorded solution says of one photo.
struct PhotoFinding {
    std::int64_t photo = 0;
    std::int64_t station = 0; ///< that it belongs to now
    std::string file;         ///< as it is called now
    std::string stationName;
    std::string status; ///< "good", "doubtful", "failed"
    std::optional<Rigid3> roomFromPhoto;
    std::optional<Radians> sigmaYaw;
    std::optional<Radians> sigmaTilt; ///< the larger of pitch and roll
    std::optional<Radians> residual;  ///< root mean square over the matches that hold it
    int neighbours = 0;               ///< pairs that hold it
    std::vector<std::string> flags;   ///< sentences
    std::optional<std::int64_t> fits; ///< the station that it should belong to, where it belongs to another
    Cure cure = Cure::None;
};

struct SolutionFindings {
    store::SolutionRecord solution;
    std::string reason;                ///< why this model, in a sentence; "" if not known
    std::vector<std::string> warnings; ///< of the solution as a whole
    std::vector<PhotoFinding> photos;  ///< that the survey still has, in walking order

    /// The moves that would put every photo that fits another station there.
    std::vector<PhotoPlace> retags() const;
};

/// Of the active solution; nothing without one. Errors: Corrupt for a report that is none.
std::optional<SolutionFindings> activeFindings(const store::SurveyStore& store);

} // namespace spherewalk::jobs
