// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/store/survey_store.h"

#include <string>
#include <vector>

namespace spherewalk::jobs {

/// A station whose photo should be taken again.
struct Retake {
    store::StationRecord station;
    bool isFailed = true;      ///< the checks failed the photo, or a person rejected it; else it is doubtful
    bool isSurrounded = false; ///< good photos stand around it and can stand in for it; else it leaves a hole
    std::string sentence;      ///< why
};

/// Stations whose chosen photo was rejected by a person, or is not good by its verdict and was not accepted
/// by a person, in walking order. Stations that never had a photo are not among them. A photo counts as
/// surrounded if the good photos within one and a half steps at its height leave no half of the directions
/// around it empty. Errors: those of the store.
std::vector<Retake> retakes(const store::SurveyStore& store);

Json toJson(const std::vector<Retake>& retakes);

} // namespace spherewalk::jobs
