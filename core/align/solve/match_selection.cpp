// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/match_selection.h"

#include "pairs/disjoint_sets.h"
#include "pairs/pair_geometry.h"
#include "solve/pair_normal.h"

#include "spherewalk/base/fixed_random.h"
#include "spherewalk/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <unordered_map>

namespace spherewalk::align {

namespace {

/// Features of all photos, in sets that show one thing.
class JoinedFeatures {
  public:
    int node(int photo, int feature) {
        const std::uint64_t key = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(photo)) << 32) |
                                  static_cast<std::uint32_t>(feature);
        const auto [entry, isNew] = m_nodes.try_emplace(key, m_sets.count());
        if (isNew) {
            m_sets.add();
        }
        return entry->second;
    }

    int track(int node) { return m_sets.of(node); }

    void join(int one, int other) {
        const auto [first, second] = std::minmax({track(one), track(other)});
        m_sets.join(second, first);
    }

    int count() const { return m_sets.count(); }

  private:
    std::unordered_map<std::uint64_t, int> m_nodes;
    DisjointSets m_sets;
};

} // namespace

std::vector<std::vector<int>> tracks(std::span<const PhotoPair> pairs,
                                     std::span<const std::vector<bool>> isUsed) {
    JoinedFeatures joined;
    std::vector<std::vector<int>> nodes(pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const PhotoPair& pair = pairs[i];
        nodes[i].assign(pair.matches.size(), -1);
        for (std::size_t j = 0; j < pair.matches.size(); ++j) {
            const Correspondence& match = pair.matches[j];
            if (isUsed[i][j] && match.featureA >= 0 && match.featureB >= 0) {
                nodes[i][j] = joined.node(pair.a, match.featureA);
                joined.join(nodes[i][j], joined.node(pair.b, match.featureB));
            }
        }
    }
    int alone = joined.count();
    for (std::vector<int>& ofPair : nodes) {
        for (int& node : ofPair) {
            node = node < 0 ? alone++ : joined.track(node);
        }
    }
    return nodes;
}

bool isHeldOut(int track, double share) {
    return FixedRandom(0x48454C44ULL + static_cast<std::uint64_t>(track) * 2654435761ULL).uniform() < share;
}

namespace {

constexpr double kTurnApartM = 0.01;
constexpr double kUsualRangeM = 2;      // of what a photo shows in a room
constexpr double kAgreeingSigmas = 3.2; // of the scaled residual
constexpr double kBehindSigmas = 4.2;   // both bearings err, three sigmas of the difference
constexpr double kLargestResidualScale = 8;
constexpr double kMarginSine = 0.16;
constexpr int kSelectionBands = 6;
constexpr int kSelectionSectors = 10;

// The cell of a grid with cells of equal area on the sphere.
std::size_t cellOf(const Eigen::Vector3d& bearing) {
    const double around = std::atan2(bearing.y(), bearing.x()) / (2 * std::numbers::pi) + 0.5;
    const int band =
        std::clamp(static_cast<int>((bearing.z() + 1) / 2 * kSelectionBands), 0, kSelectionBands - 1);
    const int sector = std::clamp(static_cast<int>(around * kSelectionSectors), 0, kSelectionSectors - 1);
    return static_cast<std::size_t>(band * kSelectionSectors + sector);
}

// Keeps matches from every direction in turn until there are enough.
void thin(std::vector<UsedMatch>& matches, int most) {
    if (static_cast<int>(matches.size()) <= most) {
        return;
    }
    std::array<std::vector<UsedMatch>, kSelectionBands * kSelectionSectors> cells;
    for (const UsedMatch& match : matches) {
        cells[cellOf(match.inA)].push_back(match);
    }
    matches.clear();
    for (std::size_t depth = 0; static_cast<int>(matches.size()) < most; ++depth) {
        for (const std::vector<UsedMatch>& cell : cells) {
            if (depth < cell.size() && static_cast<int>(matches.size()) < most) {
                matches.push_back(cell[depth]);
            }
        }
    }
}

using Wanted = std::function<bool(const UsedPair&, const UsedMatch&)>;

std::vector<UsedPair> select(const Candidates& candidates, const Unknowns& unknowns,
                             std::span<const PhotoPrior> priors, const Selection& selection,
                             const Wanted& isWanted) {
    std::vector<UsedPair> used(candidates.chosen.size());
    parallelFor(static_cast<int>(used.size()), 16, selection.threads, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            const int at = candidates.chosen[static_cast<std::size_t>(i)];
            UsedPair pair = emptyPair(candidates, unknowns, priors, at);
            const auto& tracks = candidates.tracks[static_cast<std::size_t>(at)];
            UsedMatch match;
            for (std::size_t j = 0; j < tracks.size(); ++j) {
                const bool isOut = selection.heldOutShare > 0 && isHeldOut(tracks[j], selection.heldOutShare);
                if (isOut == selection.wantsHeldOut &&
                    usedMatch(candidates, at, static_cast<int>(j), match) && isWanted(pair, match)) {
                    pair.matches.push_back(match);
                }
            }
            thin(pair.matches, selection.mostAPair);
            used[static_cast<std::size_t>(i)] = std::move(pair);
        }
    });
    std::erase_if(used, [](const UsedPair& pair) { return pair.matches.empty(); });
    return used;
}

} // namespace

UsedPair emptyPair(const Candidates& candidates, const Unknowns& unknowns, std::span<const PhotoPrior> priors,
                   int at) {
    const PhotoPair& given = candidates.pairs[static_cast<std::size_t>(at)];
    UsedPair pair;
    pair.pair = at;
    pair.a = candidates.indexOf[static_cast<std::size_t>(given.a)];
    pair.b = candidates.indexOf[static_cast<std::size_t>(given.b)];
    const double sigma =
        waySigmaM(priors[static_cast<std::size_t>(given.a)], priors[static_cast<std::size_t>(given.b)]);
    const PairEstimate& estimate = candidates.estimates[static_cast<std::size_t>(at)];
    const auto placeOf = [&](int photo) {
        const auto i = static_cast<std::size_t>(photo);
        return candidates.solvesPlaces ? unknowns.state(i).positionM : unknowns.plannedM[i];
    };
    const double apart = (placeOf(pair.a) - placeOf(pair.b)).norm();
    const bool isApart = candidates.solvesPlaces && estimate.baselineInA;
    pair.isTurn = apart < (isApart ? kTurnApartM : std::max(kTurnApartM, 2 * sigma));
    pair.toleranceRad = std::hypot(apart, std::min(sigma, kTurnApartM)) / kUsualRangeM;
    // With photos at one place the matches tell best how far apart they are.
    if (pair.isTurn && !estimate.baselineInA) {
        pair.toleranceRad = std::min(pair.toleranceRad, estimate.parallaxRad);
    }
    return pair;
}

bool usedMatch(const Candidates& candidates, int pair, int at, UsedMatch& into) {
    const Correspondence& match =
        candidates.pairs[static_cast<std::size_t>(pair)].matches[static_cast<std::size_t>(at)];
    const std::optional<UnitMatch> unit = unitMatch(match);
    if (!unit) {
        return false;
    }
    const PhotoPair& given = candidates.pairs[static_cast<std::size_t>(pair)];
    const double noise = std::hypot(candidates.noise[static_cast<std::size_t>(given.a)],
                                    candidates.noise[static_cast<std::size_t>(given.b)]) *
                         std::numbers::sqrt2 / 2;
    into = {unit->inA, unit->inB, noise * unit->sigmaRad, at,
            candidates.tracks[static_cast<std::size_t>(pair)][static_cast<std::size_t>(at)]};
    return true;
}

Judgement judge(const UsedPair& pair, const UsedMatch& match, const PhotoState& a, const PhotoState& b,
                double scale) {
    MatchRow rows[2];
    const int count = matchRows(pair, match, a, b, rows);
    if (count == 2) {
        const double distance = std::hypot(rows[0].residual, rows[1].residual);
        const bool isTurned = (a.roomFromPhoto * match.inA).dot(b.roomFromPhoto * match.inB) > 0;
        return isTurned && distance < 1.2 * kAgreeingSigmas * scale ? Judgement::Agrees
                                                                    : Judgement::OutOfPlane;
    }
    const Eigen::Vector3d inA = a.roomFromPhoto * match.inA;
    const Eigen::Vector3d inB = b.roomFromPhoto * match.inB;
    const Eigen::Vector3d direction = (b.positionM - a.positionM).normalized();
    if (count == 0 || std::min(inA.cross(direction).norm(), inB.cross(direction).norm()) < kMarginSine) {
        return Judgement::AlongBaseline;
    }
    if (std::abs(rows[0].residual) > kAgreeingSigmas * scale) {
        return Judgement::OutOfPlane;
    }
    const bool isBehind =
        parallaxOf(inA, inB, direction) < -kBehindSigmas * scale * match.sigmaRad || inA.dot(inB) < 0;
    return isBehind ? Judgement::Behind : Judgement::Agrees;
}

std::vector<UsedPair> estimatedMatches(const Candidates& candidates, const Unknowns& unknowns,
                                       std::span<const PhotoPrior> priors, const Selection& selection) {
    return select(candidates, unknowns, priors, selection, [&](const UsedPair& pair, const UsedMatch& match) {
        const PairEstimate& estimate = candidates.estimates[static_cast<std::size_t>(pair.pair)];
        if (!estimate.isInlier[static_cast<std::size_t>(match.match)]) {
            return false;
        }
        const Eigen::Vector3d turnedB = estimate.aFromB * match.inB;
        return !estimate.baselineInA ||
               parallaxOf(match.inA, turnedB, *estimate.baselineInA) > -kBehindSigmas * match.sigmaRad;
    });
}

std::vector<UsedPair> agreeingMatches(const Candidates& candidates, const Unknowns& unknowns,
                                      std::span<const PhotoPrior> priors, double scale,
                                      const Selection& selection) {
    const std::vector<PhotoState> states = unknowns.states();
    return select(candidates, unknowns, priors, selection, [&](const UsedPair& pair, const UsedMatch& match) {
        return judge(pair, match, states[static_cast<std::size_t>(pair.a)],
                     states[static_cast<std::size_t>(pair.b)], scale) == Judgement::Agrees;
    });
}

double residualScale(std::span<const UsedPair> pairs, std::span<const PhotoState> states) {
    std::vector<double> residuals;
    for (const UsedPair& pair : pairs) {
        forEachRow(pair, states,
                   [&](const UsedMatch&, const MatchRow& row) { residuals.push_back(row.residual); });
    }
    return agreeingScale(std::move(residuals), kLargestResidualScale);
}

} // namespace spherewalk::align
