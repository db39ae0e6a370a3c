// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "route.h"

#include <functional>
#include <vector>

namespace spherewalk::survey {

/// The distance between two rail ends; end 2r is the first of rail r, 2r + 1 its last.
using EndDistance = std::function<double(int, int)>;

int beginOf(const Leg& leg);
int endOf(const Leg& leg);

/// The same legs walked the other way.
void turnAround(std::vector<Leg>::iterator begin, std::vector<Leg>::iterator end);

/// The rails line by line, every second line backwards, one part of the floor after the other: where a wall
/// or obstacle splits the lines, each side is swept on its own. Range: rails sorted by line, then begin.
std::vector<Leg> sweep(const std::vector<RailEnds>& rails, const EndDistance& distance);

} // namespace spherewalk::survey
