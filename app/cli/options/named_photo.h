// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/store/records.h"

#include <string>

namespace spherewalk::store {
class SurveyStore;
}

namespace spherewalk::cli {

/// The photo that a person names: by its file, its number, or its station, whose chosen photo it is. Errors:
/// NotFound.
store::PhotoRecord photoNamed(const store::SurveyStore& store, const std::string& name);

} // namespace spherewalk::cli
