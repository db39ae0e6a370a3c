// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/words.h"

#include "spherewalk/jobs/solution_findings.h"
#include "spherewalk/store/survey_store.h"

#include <cstdint>
#include <map>
#include <optional>

namespace spherewalk::ui {

/// Returns the standing of each station's chosen photo, by station; Missing without a photo. All pages show
/// these. findings: those of the active solution. Errors: those of the store.
std::map<std::int64_t, Standing> standings(const store::SurveyStore& store,
                                           const std::optional<jobs::SolutionFindings>& findings);

} // namespace spherewalk::ui
