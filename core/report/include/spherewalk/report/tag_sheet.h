// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"

#include <span>
#include <string>

namespace spherewalk::report {

/// A PDF of AprilTags (36h11) at true size, a page each, for hanging on walls: the tag with its white rim,
/// its number, which side is up, and a bar that checks the printer's scale. The paper is the smallest of A4
/// to A0 that holds the tag. title: the survey's name. sizeM: side of the black square. The same input gives
/// the same bytes. Errors: InvalidInput for no numbers, for an unknown number, and for a size outside 2 to 60
/// cm; Internal if the PDF cannot be made.
Bytes tagSheet(const std::string& title, std::span<const int> numbers, double sizeM);

} // namespace spherewalk::report
