// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/position_hypotheses.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace spherewalk::align {

namespace {

constexpr double kOneHeightM = 0.05;
constexpr double kAtTagM = 0.02;

} // namespace

PlannedLines::PlannedLines(std::span<const PlannedPosition> planned)
    : m_planned(planned.begin(), planned.end()), m_places(planned.size()) {
    std::map<std::pair<int, double>, std::vector<int>> byRail;
    for (int i = 0; const PlannedPosition& position : m_planned) {
        if (position.placement >= 0 && position.positionM.allFinite()) {
            byRail[{position.placement, std::round(position.positionM.z() / kOneHeightM)}].push_back(i);
        }
        ++i;
    }
    for (auto& [key, line] : byRail) {
        std::ranges::stable_sort(line, std::less(),
                                 [this](int i) { return m_planned[static_cast<std::size_t>(i)].stop; });
        for (int index = 0; const int i : line) {
            m_places[static_cast<std::size_t>(i)] = {static_cast<int>(m_lines.size()), index++};
        }
        m_lines.push_back(std::move(line));
    }
}

PlannedLines::Place PlannedLines::place(int planned) const {
    return planned < 0 ? Place{} : m_places[static_cast<std::size_t>(planned)];
}

int PlannedLines::tag(const PhotoPrior& photo) const {
    int best = -1;
    std::tuple<bool, double> bestKey;
    for (int i = 0; const PlannedPosition& position : m_planned) {
        const double distanceM = (position.positionM - photo.positionM).norm();
        const std::tuple<bool, double> key = {
            position.placement != photo.placement || position.stop != photo.stop, distanceM};
        if (distanceM < kAtTagM && (best < 0 || key < bestKey)) {
            best = i;
            bestKey = key;
        }
        ++i;
    }
    return best;
}

Eigen::Vector3d PlannedLines::positionM(int line, int index) const {
    const std::vector<int>& positions = m_lines[static_cast<std::size_t>(line)];
    const auto at = [&](int i) -> const Eigen::Vector3d& {
        return m_planned[static_cast<std::size_t>(positions[static_cast<std::size_t>(i)])].positionM;
    };
    const int last = static_cast<int>(positions.size()) - 1;
    if (index < 0) {
        return 2 * at(0) - at(1);
    }
    return index > last ? Eigen::Vector3d(2 * at(last) - at(last - 1)) : at(index);
}

namespace {

constexpr std::size_t kMostKept = 100;
constexpr std::size_t kMostSuspects = 150;
constexpr int kLeastDirections = 4; ///< A photo with fewer is not judged by itself.
constexpr int kLeastContradicted = 2;
constexpr int kLeastPartnersDirections = 2; ///< Of a photo that may have been swapped with a judged one.
constexpr double kAtPlannedM = 0.04;
constexpr double kLeastFreeMoveM = 0.1; ///< Less is a cart laid badly, which the alignment solves.

/// The least gain of a blunder that is believed, in nats. It grows with the number of ways to make the
/// blunder.
double price(Blunder blunder, int moved) {
    switch (blunder) {
    case Blunder::Reversed:
        return 10;
    case Blunder::Shifted:
        return moved == 1 ? 16 : 14;
    case Blunder::Swapped:
        return 17;
    case Blunder::Elsewhere:
        return 18;
    }
    return 0;
}

constexpr double kPriceUnplanned = 8; ///< Extra price of a position where nobody meant to stand.

class BlunderSearch {
  public:
    BlunderSearch(PositionEvidence& evidence, const PlannedLines& lines, const Places& places)
        : m_evidence(evidence), m_lines(lines), m_places(places) {
        findSuspects();
        m_photosAt.resize(static_cast<std::size_t>(lines.size()));
        for (int photo = 0; const int place : places) {
            if (place >= 0) {
                m_photosAt[static_cast<std::size_t>(place)].push_back(photo);
            }
            ++photo;
        }
    }

    std::vector<Hypothesis> run() {
        std::set<int> suspectLines;
        for (const int photo : m_suspects) {
            suspectLines.insert(m_lines.place(m_places[static_cast<std::size_t>(photo)]).line);
        }
        suspectLines.erase(-1);
        for (const int line : suspectLines) {
            reverse(line);
            shift(line);
        }
        for (std::size_t i = 0; i < m_suspects.size(); ++i) {
            for (std::size_t j = i + 1; j < m_suspects.size(); ++j) {
                swap(m_suspects[i], m_suspects[j]);
            }
            for (const int partner : m_partners) {
                swap(m_suspects[i], partner);
            }
            lay(m_suspects[i]);
        }
        std::ranges::stable_sort(m_found, std::greater(), &Hypothesis::gain);
        m_found.resize(std::min(m_found.size(), kMostKept));
        return std::move(m_found);
    }

  private:
    void findSuspects() {
        std::vector<std::pair<int, int>> byContradicted;
        for (std::size_t i = 0; i < m_places.size(); ++i) {
            const PositionEvidence::Count count = m_evidence.count(static_cast<int>(i));
            if (count.contradicted < kLeastContradicted) {
                continue;
            }
            if (count.directions >= kLeastDirections) {
                byContradicted.emplace_back(-count.contradicted, static_cast<int>(i));
            } else if (count.directions >= kLeastPartnersDirections && m_partners.size() < kMostSuspects) {
                m_partners.push_back(static_cast<int>(i));
            }
        }
        std::ranges::sort(byContradicted);
        for (const auto& [contradicted, photo] : byContradicted) {
            if (m_suspects.size() < kMostSuspects) {
                m_suspects.push_back(photo);
            }
        }
    }

    const Eigen::Vector3d& positionM(int photo) const {
        return m_evidence.positionsM()[static_cast<std::size_t>(photo)];
    }

    void consider(Blunder blunder, std::vector<Move> moves, int stopsFarther = 0) {
        std::erase_if(
            moves, [&](const Move& move) { return (move.positionM - positionM(move.photo)).norm() < 1e-6; });
        if (moves.empty()) {
            return;
        }
        double gain = m_evidence.gain(moves) - price(blunder, static_cast<int>(moves.size()));
        gain -= std::ranges::any_of(moves, [](const Move& move) { return move.planned < 0; })
                    ? kPriceUnplanned
                    : 0;
        if (gain > 0) {
            m_found.push_back({blunder, std::move(moves), gain, stopsFarther});
        }
    }

    const std::vector<int>& photosAt(int line, int index) const {
        const int planned = m_lines.lines()[static_cast<std::size_t>(line)][static_cast<std::size_t>(index)];
        return m_photosAt[static_cast<std::size_t>(planned)];
    }

    /// Adds moves of the photos at one index of a line to another index.
    void addMoves(int line, int from, int to, std::vector<Move>& moves) const {
        const std::vector<int>& positions = m_lines.lines()[static_cast<std::size_t>(line)];
        const bool isPlanned = to >= 0 && to < static_cast<int>(positions.size());
        for (const int photo : photosAt(line, from)) {
            moves.push_back({photo, isPlanned ? positions[static_cast<std::size_t>(to)] : -1,
                             m_lines.positionM(line, to)});
        }
    }

    void reverse(int line) {
        const int size = static_cast<int>(m_lines.lines()[static_cast<std::size_t>(line)].size());
        std::vector<Move> moves;
        for (int i = 0; i < size; ++i) {
            addMoves(line, i, size - 1 - i, moves);
        }
        consider(Blunder::Reversed, std::move(moves));
    }

    void shift(int line) {
        const int size = static_cast<int>(m_lines.lines()[static_cast<std::size_t>(line)].size());
        for (int first = 0; first < size && size > 1; ++first) {
            std::vector<Move> farther;
            std::vector<Move> nearer;
            for (int last = first; last < size; ++last) {
                addMoves(line, last, last + 1, farther);
                addMoves(line, last, last - 1, nearer);
                consider(Blunder::Shifted, farther, 1);
                consider(Blunder::Shifted, nearer, -1);
            }
        }
    }

    void swap(int a, int b) {
        consider(Blunder::Swapped, {{a, m_places[static_cast<std::size_t>(b)], positionM(b)},
                                    {b, m_places[static_cast<std::size_t>(a)], positionM(a)}});
    }

    void lay(int photo) {
        for (int planned = 0; planned < m_lines.size(); ++planned) {
            consider(Blunder::Elsewhere, {{photo, planned, m_lines[planned].positionM}});
        }
        const std::optional<Eigen::Vector3d> free = meeting(photo);
        if (free && (*free - positionM(photo)).norm() > kLeastFreeMoveM && !isAtPlanned(*free)) {
            consider(Blunder::Elsewhere, {{photo, -1, *free}});
        }
    }

    /// Whether a planned position lies so near that it is meant.
    bool isAtPlanned(const Eigen::Vector3d& pM) const {
        for (int planned = 0; planned < m_lines.size(); ++planned) {
            if ((m_lines[planned].positionM - pM).norm() < kAtPlannedM) {
                return true;
            }
        }
        return false;
    }

    /// The point where the photo's baselines from its neighbours meet. Empty if they lie on one line.
    std::optional<Eigen::Vector3d> meeting(int photo) const {
        Eigen::Vector3d meetingM = positionM(photo);
        for (int round = 0; round < 8; ++round) {
            Eigen::Matrix3d left = Eigen::Matrix3d::Zero();
            Eigen::Vector3d right =
                Eigen::Vector3d::Zero(); // Relative to the photo, since a room may lie far off.
            for (const int i : m_evidence.of(photo)) {
                const Baseline& baseline = m_evidence.baselines()[static_cast<std::size_t>(i)];
                if (!baseline.hasDirection) {
                    continue;
                }
                const Eigen::Vector3d otherM =
                    positionM(baseline.a == photo ? baseline.b : baseline.a) - positionM(photo);
                const Eigen::Vector3d direction = m_evidence.roomFromComponent() * baseline.inComponent;
                const Eigen::Matrix3d across =
                    Eigen::Matrix3d::Identity() - direction * direction.transpose();
                const double offM = (across * (meetingM - positionM(photo) - otherM)).norm();
                const double weight = round == 0 ? 1 : 1 / (0.01 + offM);
                left += weight * across;
                right += weight * across * otherM;
            }
            const Eigen::LDLT<Eigen::Matrix3d> solver(left);
            if (solver.info() != Eigen::Success || solver.rcond() < 1e-3) {
                return std::nullopt; // All baselines lie on one line.
            }
            meetingM = positionM(photo) + solver.solve(right);
        }
        return meetingM.allFinite() ? std::optional(meetingM) : std::nullopt;
    }

    PositionEvidence& m_evidence;
    const PlannedLines& m_lines;
    const Places& m_places;
    std::vector<int> m_suspects;
    std::vector<int> m_partners; ///< Contradicted, but held by too little to be judged: a grid's corners.
    std::vector<std::vector<int>> m_photosAt;
    std::vector<Hypothesis> m_found;
};

} // namespace

std::vector<Hypothesis> hypotheses(PositionEvidence& evidence, const PlannedLines& lines,
                                   const Places& places) {
    return BlunderSearch(evidence, lines, places).run();
}

} // namespace spherewalk::align
