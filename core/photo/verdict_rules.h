// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sketch_match.h"

#include "spherewalk/photo/verdict.h"

#include <span>
#include <vector>

/// The rules of a verdict, by subject. Each adds what it finds.
namespace spherewalk::photo {

using Findings = std::vector<Finding>;

/// Size, kind and settings, by the photo's own words.
void addWhatItSays(Findings& findings, const Sketch& photo, const PhotoMetadata& metadata,
                   const ExpectedSettings& expected);
/// Brightness, colour, black and burnt areas.
void addLight(Findings& findings, const Sketch& photo, std::span<const MatchedSketch> neighbours);
void addBlur(Findings& findings, const Sketch& photo, std::span<const MatchedSketch> neighbours);
/// Whether it shows what its neighbours show, the same way up and turned like them.
void addPlace(Findings& findings, const Sketch& photo, std::span<const MatchedSketch> neighbours);

} // namespace spherewalk::photo
