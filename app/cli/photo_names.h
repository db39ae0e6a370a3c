// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/store/survey_store.h"

#include <string>

namespace spherewalk::cli {

/// The photo by its file's name, by its station's name (the chosen one), or by its number. Errors: NotFound.
store::PhotoRecord photoNamed(const store::SurveyStore& store, const std::string& name);

/// The station by its name or number. Errors: NotFound.
store::StationRecord stationNamed(const store::SurveyStore& store, const std::string& name);

} // namespace spherewalk::cli
