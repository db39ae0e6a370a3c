// SPDX-License-Identifier: GPL-3.0-or-later
#include "rails.h"

#include <algorithm>
#include <array>
#include <limits>

namespace spherewalk::survey {

namespace {

constexpr double kGainM = 1e-6;      ///< smaller differences are equal, so that rounding decides nothing
constexpr int kTabulatedRails = 500; ///< up to here all distances are kept
constexpr int kThoroughRails = 250;  ///< up to here several starts are tried
constexpr int kNarrowWindow = 40;    ///< farthest rails, in the order, that are exchanged in long routes
constexpr int kMostPasses = 60;
constexpr int kMostPassesNarrow = 3;
constexpr int kLongestMove = 3;

/// Distances between rail ends; end 2r is the first of rail r, 2r + 1 its last.
class EndDistances {
  public:
    EndDistances(const std::vector<RailEnds>& rails, const WalkingDistance& walking) : m_walking(walking) {
        for (const RailEnds& rail : rails) {
            m_places.push_back(walking.place(rail.first));
            m_places.push_back(walking.place(rail.last));
        }
        if (rails.size() > kTabulatedRails) {
            return;
        }
        m_table.assign(m_places.size() * m_places.size(), 0.0F);
        for (std::size_t i = 0; i < m_places.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                m_table[i * m_places.size() + j] = m_table[j * m_places.size() + i] =
                    walking.between(m_places[i], m_places[j]);
            }
        }
    }

    double operator()(int a, int b) const {
        const auto i = static_cast<std::size_t>(a);
        const auto j = static_cast<std::size_t>(b);
        return m_table.empty() ? m_walking.between(m_places[i], m_places[j])
                               : m_table[i * m_places.size() + j];
    }

  private:
    const WalkingDistance& m_walking;
    std::vector<WalkingDistance::Place> m_places;
    std::vector<double> m_table;
};

using Route = std::vector<Leg>;

int beginOf(const Leg& leg) {
    return 2 * leg.rail + (leg.backwards ? 1 : 0);
}

int endOf(const Leg& leg) {
    return 2 * leg.rail + (leg.backwards ? 0 : 1);
}

/// The same legs walked the other way.
void turnAround(Route::iterator begin, Route::iterator end) {
    std::reverse(begin, end);
    std::for_each(begin, end, [](Leg& leg) { leg.backwards = !leg.backwards; });
}

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

/// The rails line by line, every second line backwards, one part of the floor after the other. Where a wall
/// or an obstacle splits the lines, each side is swept on its own. Range: rails sorted by line, then begin.
std::vector<Leg> sweep(const std::vector<RailEnds>& rails, const EndDistances& distance) {
    std::vector<Ways> parts = partsOf(rails);
    std::vector<Leg> route;
    while (!parts.empty()) {
        std::size_t nearest = 0;
        std::size_t way = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t part = 0; part < parts.size() && !route.empty(); ++part) {
            for (std::size_t w = 0; w < parts[part].size(); ++w) {
                const double metres = distance(endOf(route.back()), beginOf(parts[part][w].front()));
                if (metres < least - kGainM) {
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

const Leg& legAt(const Route& route, int position) {
    return route[static_cast<std::size_t>(position)];
}

double length(const Route& route, const EndDistances& distance) {
    double sum = 0;
    for (std::size_t i = 1; i < route.size(); ++i) {
        sum += distance(endOf(route[i - 1]), beginOf(route[i]));
    }
    return sum;
}

/// The way across the gap between two positions; nothing before the first and after the last.
double gap(const Route& route, const EndDistances& distance, int before, int after) {
    const bool open = before < 0 || after >= static_cast<int>(route.size());
    return open ? 0 : distance(endOf(legAt(route, before)), beginOf(legAt(route, after)));
}

/// What is gained by turning the piece [i, j] around; the piece may be one leg.
double gainOfTurning(const Route& route, const EndDistances& distance, int i, int j) {
    const int n = static_cast<int>(route.size());
    const Leg& first = legAt(route, i);
    const Leg& last = legAt(route, j);
    double gain = gap(route, distance, i - 1, i) + gap(route, distance, j, j + 1);
    gain -= i > 0 ? distance(endOf(legAt(route, i - 1)), endOf(last)) : 0;
    gain -= j + 1 < n ? distance(beginOf(first), beginOf(legAt(route, j + 1))) : 0;
    return gain;
}

bool turnPieces(Route& route, const EndDistances& distance, int window) {
    bool improved = false;
    const int n = static_cast<int>(route.size());
    for (int i = 0; i < n; ++i) {
        for (int j = i; j < std::min(n, i + window); ++j) {
            if (gainOfTurning(route, distance, i, j) > kGainM) {
                turnAround(route.begin() + i, route.begin() + j + 1);
                improved = true;
            }
        }
    }
    return improved;
}

/// What is gained by putting the piece [i, j] between k and k + 1 (k = -1: in front), turned or not.
double gainOfMoving(const Route& route, const EndDistances& distance, int i, int j, int k, bool turned) {
    const int n = static_cast<int>(route.size());
    const Leg& first = legAt(route, i);
    const Leg& last = legAt(route, j);
    const int entry = turned ? endOf(last) : beginOf(first);
    const int exit = turned ? beginOf(first) : endOf(last);
    double gain =
        gap(route, distance, i - 1, i) + gap(route, distance, j, j + 1) + gap(route, distance, k, k + 1);
    gain -= gap(route, distance, i - 1, j + 1);
    gain -= k >= 0 ? distance(endOf(legAt(route, k)), entry) : 0;
    gain -= k + 1 < n ? distance(exit, beginOf(legAt(route, k + 1))) : 0;
    return gain;
}

void movePiece(Route& route, int i, int j, int k, bool turned) {
    const auto begin = route.begin() + i;
    const auto end = route.begin() + j + 1;
    if (turned) {
        turnAround(begin, end);
    }
    if (k < i) {
        std::rotate(route.begin() + k + 1, begin, end);
    } else {
        std::rotate(begin, end, route.begin() + k + 1);
    }
}

bool moveFrom(Route& route, const EndDistances& distance, int i, int window) {
    const int n = static_cast<int>(route.size());
    for (int j = i; j < std::min(n, i + kLongestMove); ++j) {
        for (int k = std::max(-1, i - window); k < std::min(n, j + window); ++k) {
            if (k >= i - 1 && k <= j) {
                continue;
            }
            for (const bool turned : {false, true}) {
                if (gainOfMoving(route, distance, i, j, k, turned) > kGainM) {
                    movePiece(route, i, j, k, turned);
                    return true;
                }
            }
        }
    }
    return false;
}

bool movePieces(Route& route, const EndDistances& distance, int window) {
    bool improved = false;
    for (int i = 0; i < static_cast<int>(route.size()); ++i) {
        improved |= moveFrom(route, distance, i, window);
    }
    return improved;
}

void improve(Route& route, const EndDistances& distance) {
    const bool narrow = route.size() > kTabulatedRails;
    const int window = narrow ? kNarrowWindow : static_cast<int>(route.size());
    for (int pass = 0; pass < (narrow ? kMostPassesNarrow : kMostPasses); ++pass) {
        const bool turned = turnPieces(route, distance, window);
        const bool moved = movePieces(route, distance, window);
        if (!turned && !moved) {
            return;
        }
    }
}

Route nearestNeighbours(int count, Leg start, const EndDistances& distance) {
    std::vector<bool> walked(static_cast<std::size_t>(count), false);
    Route route{start};
    walked[static_cast<std::size_t>(start.rail)] = true;
    while (static_cast<int>(route.size()) < count) {
        Leg next;
        double least = std::numeric_limits<double>::infinity();
        for (int rail = 0; rail < count; ++rail) {
            for (const bool backwards : {false, true}) {
                const Leg leg{rail, backwards};
                if (!walked[static_cast<std::size_t>(rail)] &&
                    distance(endOf(route.back()), beginOf(leg)) < least - kGainM) {
                    least = distance(endOf(route.back()), beginOf(leg));
                    next = leg;
                }
            }
        }
        walked[static_cast<std::size_t>(next.rail)] = true;
        route.push_back(next);
    }
    return route;
}

std::vector<Route> starts(const std::vector<RailEnds>& rails, const EndDistances& distance) {
    std::vector<Route> result{sweep(rails, distance)};
    const int count = static_cast<int>(rails.size());
    if (count > kTabulatedRails) {
        return result;
    }
    const int tries = count <= kThoroughRails ? std::min(count, 6) : 1;
    for (int i = 0; i < tries; ++i) {
        const int rail = tries == 1 ? 0 : i * (count - 1) / (tries - 1);
        result.push_back(nearestNeighbours(count, {rail, false}, distance));
        result.push_back(nearestNeighbours(count, {rail, true}, distance));
    }
    return result;
}

} // namespace

std::vector<Leg> shortRoute(const std::vector<RailEnds>& rails, const WalkingDistance& walking) {
    if (rails.empty()) {
        return {};
    }
    const EndDistances distance(rails, walking);
    Route best;
    double least = std::numeric_limits<double>::infinity();
    for (Route& route : starts(rails, distance)) {
        improve(route, distance);
        const double metres = length(route, distance);
        if (metres < least - kGainM) {
            least = metres;
            best = std::move(route);
        }
    }
    return best;
}

double carryingDistance(const std::vector<RailEnds>& rails, const std::vector<Leg>& route,
                        const WalkingDistance& walking) {
    double sum = 0;
    for (std::size_t i = 1; i < route.size(); ++i) {
        const RailEnds& from = rails[static_cast<std::size_t>(route[i - 1].rail)];
        const RailEnds& to = rails[static_cast<std::size_t>(route[i].rail)];
        sum += walking.between(route[i - 1].backwards ? from.first : from.last,
                               route[i].backwards ? to.last : to.first);
    }
    return sum;
}

} // namespace spherewalk::survey
