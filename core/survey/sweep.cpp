// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep.h"

#include <algorithm>
#include <array>
#include <limits>

namespace spherewalk::survey {

namespace {

constexpr double kEqualDistanceM = 1e-6;

/// Consecutive points of one line, and the rails [firstRail, lastRail] over them.
struct Run {
    int line = 0;
    int begin = 0;
    int end = 0;
    int firstRail = 0;
    int lastRail = 0;
};

std::vector<Run> runs(const std::vector<RailEnds>& rails) {
    std::vector<Run> result;
    for (std::size_t i = 0; i < rails.size(); ++i) {
        const RailEnds& rail = rails[i];
        const int index = static_cast<int>(i);
        if (!result.empty() && result.back().line == rail.line && result.back().end == rail.begin) {
            result.back().end = rail.end;
            result.back().lastRail = index;
        } else {
            result.push_back({rail.line, rail.begin, rail.end, index, index});
        }
    }
    return result;
}

/// Per run the only run of the next line beside it, if that one has no other before it; else -1.
std::vector<int> onlySuccessors(const std::vector<Run>& runs) {
    std::vector<int> successors(runs.size(), 0);
    std::vector<int> predecessors(runs.size(), 0);
    std::vector<int> successor(runs.size(), -1);
    std::size_t next = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        while (next < runs.size() &&
               (runs[next].line <= runs[i].line ||
                (runs[next].line == runs[i].line + 1 && runs[next].end <= runs[i].begin))) {
            ++next;
        }
        for (std::size_t j = next;
             j < runs.size() && runs[j].line == runs[i].line + 1 && runs[j].begin < runs[i].end; ++j) {
            ++successors[i];
            ++predecessors[j];
            successor[i] = static_cast<int>(j);
        }
    }
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (successors[i] != 1 || predecessors[static_cast<std::size_t>(successor[i])] != 1) {
            successor[i] = -1;
        }
    }
    return successor;
}

std::vector<Leg> serpentine(const std::vector<Run>& runs, const std::vector<int>& successor, int first,
                            bool backwards) {
    std::vector<Leg> legs;
    for (int i = first; i >= 0; i = successor[static_cast<std::size_t>(i)]) {
        const Run& run = runs[static_cast<std::size_t>(i)];
        const auto from = static_cast<std::ptrdiff_t>(legs.size());
        for (int rail = run.firstRail; rail <= run.lastRail; ++rail) {
            legs.push_back({rail, false});
        }
        if (backwards) {
            turnAround(legs.begin() + from, legs.end());
        }
        backwards = !backwards;
    }
    return legs;
}

/// The four ways to sweep each part of the floor: from either corner, forwards or backwards.
using Ways = std::array<std::vector<Leg>, 4>;

std::vector<Ways> partsOf(const std::vector<RailEnds>& rails) {
    const std::vector<Run> allRuns = runs(rails);
    const std::vector<int> successor = onlySuccessors(allRuns);
    std::vector<bool> isFirst(allRuns.size(), true);
    for (const int next : successor) {
        if (next >= 0) {
            isFirst[static_cast<std::size_t>(next)] = false;
        }
    }
    std::vector<Ways> parts;
    for (std::size_t i = 0; i < allRuns.size(); ++i) {
        if (isFirst[i]) {
            const int first = static_cast<int>(i);
            Ways ways{serpentine(allRuns, successor, first, false),
                      serpentine(allRuns, successor, first, true),
                      {},
                      {}};
            for (std::size_t way = 0; way < 2; ++way) {
                ways[way + 2] = ways[way];
                turnAround(ways[way + 2].begin(), ways[way + 2].end());
            }
            parts.push_back(std::move(ways));
        }
    }
    return parts;
}

} // namespace

int beginOf(const Leg& leg) {
    return 2 * leg.rail + (leg.backwards ? 1 : 0);
}

int endOf(const Leg& leg) {
    return 2 * leg.rail + (leg.backwards ? 0 : 1);
}

void turnAround(std::vector<Leg>::iterator begin, std::vector<Leg>::iterator end) {
    std::reverse(begin, end);
    std::for_each(begin, end, [](Leg& leg) { leg.backwards = !leg.backwards; });
}

std::vector<Leg> sweep(const std::vector<RailEnds>& rails, const EndDistance& distance) {
    std::vector<Ways> parts = partsOf(rails);
    std::vector<Leg> route;
    while (!parts.empty()) {
        std::size_t nearest = 0;
        std::size_t way = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t part = 0; part < parts.size() && !route.empty(); ++part) {
            for (std::size_t w = 0; w < parts[part].size(); ++w) {
                const double metres = distance(endOf(route.back()), beginOf(parts[part][w].front()));
                if (metres < least - kEqualDistanceM) {
                    least = metres;
                    nearest = part;
                    way = w;
                }
            }
        }
        const std::vector<Leg>& legs = parts[nearest][way];
        route.insert(route.end(), legs.begin(), legs.end());
        parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(nearest));
    }
    return route;
}

} // namespace spherewalk::survey
