// SPDX-License-Identifier: GPL-3.0-or-later
#include "pairs/disjoint_sets.h"
#include "pairs/pair_geometry.h"
#include "solve/component_solver.h"
#include "solve/match_selection.h"

#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

// Half a turn of one photo about the baseline leaves every match in its plane. So does half a turn of both
// photos that exchanges the two ends of the baseline. Both are true minima of the residuals, which know
// planes alone. What tells them apart is where the rays meet: in front of both photos, behind them, or
// nowhere.

namespace spherewalk::align {

namespace {

constexpr double kLeastSideSine = 0.16; // Nearer to the baseline a bearing's side is not sure.
constexpr double kParallaxSigmas = 4.2; // Both bearings err, three sigmas of the difference.
constexpr int kLeastSides = 8;          // So many matches tell which side a pair lies on.
constexpr int kLeastMeetings = 12;      // So many matches with parallax tell the way of travel.
constexpr double kLeastMeetingShare = 0.75;

void countSides(const PhotoState& a, const PhotoState& b, const UsedMatch& match, double scale,
                PairSides& sides) {
    const Eigen::Vector3d inA = a.roomFromPhoto * match.inA;
    const Eigen::Vector3d inB = b.roomFromPhoto * match.inB;
    if (sides.isTurn) {
        ++(inA.dot(inB) > 0 ? sides.same : sides.opposite);
        return;
    }
    const Eigen::Vector3d baseline = (b.positionM - a.positionM).normalized();
    const Eigen::Vector3d acrossA = inA - baseline * baseline.dot(inA);
    const Eigen::Vector3d acrossB = inB - baseline * baseline.dot(inB);
    if (std::min(acrossA.norm(), acrossB.norm()) < kLeastSideSine) {
        return;
    }
    if (acrossA.dot(acrossB) < 0) {
        ++sides.opposite;
        return;
    }
    ++sides.same;
    const double parallax = parallaxOf(inA, inB, baseline);
    if (std::abs(parallax) > kParallaxSigmas * scale * match.sigmaRad) {
        ++(parallax > 0 ? sides.front : sides.behind);
    }
}

} // namespace

std::vector<PairSides> pairSides(const ComponentInput& input, const ComponentState& state) {
    const std::vector<PhotoState> states = state.unknowns.states();
    std::vector<PairSides> all;
    for (const int at : input.candidates.chosen) {
        const UsedPair pair = emptyPair(input.candidates, state.unknowns, input.priors, at);
        PairSides sides{pair.pair, pair.a, pair.b, pair.isTurn};
        const std::vector<bool>& isInlier = input.candidates.estimates[static_cast<std::size_t>(at)].isInlier;
        UsedMatch match;
        for (std::size_t i = 0; i < isInlier.size(); ++i) {
            if (isInlier[i] && usedMatch(input.candidates, at, static_cast<int>(i), match)) {
                countSides(states[static_cast<std::size_t>(pair.a)], states[static_cast<std::size_t>(pair.b)],
                           match, state.scale, sides);
            }
        }
        all.push_back(sides);
    }
    return all;
}

TravelSign travelSign(std::span<const PairSides> pairs) {
    int front = 0;
    int behind = 0;
    for (const PairSides& pair : pairs) {
        front += pair.front;
        behind += pair.behind;
    }
    if (front + behind < kLeastMeetings || std::max(front, behind) < kLeastMeetingShare * (front + behind)) {
        return TravelSign::Unclear;
    }
    return front > behind ? TravelSign::Right : TravelSign::Reversed;
}

namespace {

bool isHalfTurned(const PairSides& pair) {
    return pair.opposite >= kLeastSides && pair.opposite > pair.same;
}

// Photos whose pairs lie on the right side, in sets that may be turned against each other.
class TurnedSets {
  public:
    TurnedSets(const ComponentInput& input, const ComponentState& state, std::span<const PairSides> pairs)
        : m_sets(state.unknowns.photo.size()) {
        for (const PairSides& pair : pairs) {
            if (!isHalfTurned(pair)) {
                m_sets.join(pair.a, pair.b);
            }
        }
        keepUprightSet(input, state);
    }

    bool isRight(int photo) { return m_sets.of(photo) == m_sets.of(m_right); }

    std::vector<std::size_t> photosWith(int photo) {
        std::vector<std::size_t> photos;
        for (int i = 0; i < m_sets.count(); ++i) {
            if (m_sets.of(i) == m_sets.of(photo)) {
                photos.push_back(static_cast<std::size_t>(i));
            }
        }
        return photos;
    }

    void makeRight(int photo) { m_sets.join(photo, m_right); }

  private:
    // The set with the most photos is right; of two as large the one that leans less.
    void keepUprightSet(const ComponentInput& input, const ComponentState& state) {
        std::vector<double> worth(state.unknowns.photo.size(), 0);
        for (std::size_t i = 0; i < worth.size(); ++i) {
            const Vertical up = knownUp(input.priors[static_cast<std::size_t>(state.unknowns.photo[i])]);
            const double lean = leanOf(state.unknowns.state(i).roomFromPhoto * up.upInPhoto).vectorRad.norm();
            worth[static_cast<std::size_t>(m_sets.of(static_cast<int>(i)))] += 1 - 0.01 * lean;
        }
        m_right = static_cast<int>(std::ranges::max_element(worth) - worth.begin());
    }

    DisjointSets m_sets;
    int m_right = 0;
};

} // namespace

int turnHalves(const ComponentInput& input, ComponentState& state) {
    std::vector<PairSides> pairs = pairSides(input, state);
    std::erase_if(pairs, [](const PairSides& pair) { return pair.same + pair.opposite < kLeastSides; });
    std::ranges::stable_sort(pairs, std::greater<>(), &PairSides::opposite);
    TurnedSets sets(input, state, pairs);
    int turned = 0;
    const auto next = [&] {
        return std::ranges::find_if(pairs, [&](const PairSides& pair) {
            return isHalfTurned(pair) && sets.isRight(pair.a) != sets.isRight(pair.b);
        });
    };
    for (auto pair = next(); pair != pairs.end(); pair = next()) {
        const Eigen::Quaterniond aFromB =
            input.candidates.estimates[static_cast<std::size_t>(pair->pair)].aFromB;
        const bool isRightA = sets.isRight(pair->a);
        const int wrong = isRightA ? pair->b : pair->a;
        const Eigen::Quaterniond right =
            state.unknowns.state(static_cast<std::size_t>(isRightA ? pair->a : pair->b)).roomFromPhoto;
        const Eigen::Quaterniond said = right * (isRightA ? aFromB : aFromB.conjugate());
        const Eigen::Quaterniond turn =
            said * state.unknowns.state(static_cast<std::size_t>(wrong)).roomFromPhoto.conjugate();
        for (const std::size_t photo : sets.photosWith(wrong)) {
            state.unknowns.reference[photo] = (turn * state.unknowns.state(photo).roomFromPhoto).normalized();
            state.unknowns.turn[photo] = {};
            ++turned;
        }
        sets.makeRight(wrong);
    }
    return turned;
}

std::vector<bool> unclearSides(const ComponentState& state, std::span<const PairSides> pairs) {
    std::vector<int> same(state.unknowns.photo.size(), 0);
    std::vector<int> opposite(same.size(), 0);
    for (const PairSides& pair : pairs) {
        for (const int photo : {pair.a, pair.b}) {
            same[static_cast<std::size_t>(photo)] += pair.same;
            opposite[static_cast<std::size_t>(photo)] += pair.opposite;
        }
    }
    std::vector<bool> unclear;
    for (std::size_t i = 0; i < same.size(); ++i) {
        unclear.push_back(same[i] < kLeastMeetingShare * (same[i] + opposite[i]));
    }
    return unclear;
}

std::vector<bool> bentPhotos(const ComponentInput& input, const ComponentState& state) {
    constexpr double kLeastBendRad = 0.0175;
    constexpr double kBendSigmas = 4;
    DisjointSets sets(state.unknowns.photo.size());
    for (const int at : input.candidates.chosen) {
        const PairEstimate& estimate = input.candidates.estimates[static_cast<std::size_t>(at)];
        const int a = input.candidates.indexOf[static_cast<std::size_t>(estimate.a)];
        const int b = input.candidates.indexOf[static_cast<std::size_t>(estimate.b)];
        const Eigen::Quaterniond said =
            state.unknowns.state(static_cast<std::size_t>(a)).roomFromPhoto * estimate.aFromB;
        const double bend =
            angleBetween(said, state.unknowns.state(static_cast<std::size_t>(b)).roomFromPhoto).value();
        const double sigma = std::sqrt(std::max(0.0, estimate.rotationCovariance.trace()));
        if (bend < std::max(kLeastBendRad, kBendSigmas * sigma)) {
            sets.join(a, b);
        }
    }
    std::vector<int> sizes(state.unknowns.photo.size(), 0);
    for (int i = 0; i < sets.count(); ++i) {
        ++sizes[static_cast<std::size_t>(sets.of(i))];
    }
    const int largest = static_cast<int>(std::ranges::max_element(sizes) - sizes.begin());
    const bool isAnyJoined = sizes[static_cast<std::size_t>(largest)] > 1;
    std::vector<bool> isBent;
    for (int i = 0; i < sets.count(); ++i) {
        isBent.push_back(sets.of(i) != largest || !isAnyJoined);
    }
    return isBent;
}

} // namespace spherewalk::align
