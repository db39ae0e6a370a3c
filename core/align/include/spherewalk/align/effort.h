// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/features.h"
#include "spherewalk/align/match.h"
#include "spherewalk/align/neighbours.h"

#include <string_view>

namespace spherewalk::align {

/// How much work goes into the pictures: 0.1, 0.5, 1.5 and 3.5 s of one core a photo, matching included.
enum class Effort {
    Draft,  ///< a look at what there is: headings to a few tenths of a degree
    Normal, ///< for every day
    Fine,   ///< more of the picture
    Exact,  ///< all that the pictures give
};

/// As options and reports spell it: "draft", "normal", "fine", "exact".
std::string_view name(Effort effort);

/// Errors: InvalidInput, listing the names.
Effort effortNamed(std::string_view name);

struct EffortOptions {
    FeatureOptions features;
    MatchOptions match;
    NeighbourOptions neighbours;
};

EffortOptions optionsFor(Effort effort);

} // namespace spherewalk::align
