// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json_fwd.h"
#include "spherewalk/compare/line_shape.h"
#include "spherewalk/jobs/looks.h"

#include <vector>

namespace spherewalk::jobs {

/// How the view looks beside the truth. lines: what compare::straightLines() finds in the truth. Errors:
/// InvalidInput if the sizes differ.
Looks looksOf(const RgbImage& truth, const std::vector<compare::PictureLine>& lines, const RgbImage& view);

/// The looks that toJson() wrote. Errors: Corrupt, with the member's path.
Looks looksOf(const JsonReader& reader);

} // namespace spherewalk::jobs
