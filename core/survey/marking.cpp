// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/survey/marking.h"

#include "floor.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::survey {

using Eigen::Vector2d;

namespace {

constexpr double kTapeReadingM = 0.002;
constexpr double kTapeStretch = 0.0005;
constexpr double kLeastSine = 0.2; ///< Sine of the angle at which two tapes meet; below it they slide.

double tapeSigma(double metres) {
    return kTapeReadingM + kTapeStretch * metres;
}

/// The floor with what tapes need to know of it, in the floor's own coordinates.
class TapeFinder {
  public:
    explicit TapeFinder(const Room& room) : m_floor(room) {}

    MarkedPoint mark(const Vector2d& pInRoom) const {
        const Vector2d point = pInRoom - m_floor.anchor();
        MarkedPoint result{pInRoom, {}, {}, {}};
        const std::vector<int> corners = seenCorners(point);
        double least = INFINITY;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            for (std::size_t j = i + 1; j < corners.size(); ++j) {
                const std::optional<double> sigma = sigmaOf(point, corners[i], corners[j]);
                if (!sigma) {
                    continue;
                }
                const double cost = *sigma * (isAmbiguous(point, corners[i], corners[j]) ? kAmbiguous : 1);
                if (cost < least - kEqualM) {
                    least = cost;
                    result.sigmaM = sigma;
                    result.tapes = {tape(point, corners[i]), tape(point, corners[j])};
                }
            }
        }
        result.check = checkOf(point, corners, result.tapes);
        return result;
    }

  private:
    static constexpr double kAmbiguous = 1000; ///< worse than any that is not

    const Polygon& outline() const { return m_floor.polygons().front(); }

    const Vector2d& corner(int index) const { return outline()[static_cast<std::size_t>(index)]; }

    TapeDistance tape(const Vector2d& point, int index) const {
        return {index, (corner(index) - point).norm()};
    }

    /// The tape's hook sits in the corner, a centimetre of it in the wall.
    std::vector<int> seenCorners(const Vector2d& point) const {
        constexpr double kHookM = 0.01;
        std::vector<int> result;
        for (int i = 0; i < static_cast<int>(outline().size()); ++i) {
            const Vector2d toPoint = point - corner(i);
            if (toPoint.norm() > kHookM && m_floor.sees(point, corner(i) + kHookM * toPoint.normalized())) {
                result.push_back(i);
            }
        }
        return result;
    }

    /// The nearest corner in sight that is none of the tapes'.
    std::optional<TapeDistance> checkOf(const Vector2d& point, const std::vector<int>& corners,
                                        const std::vector<TapeDistance>& tapes) const {
        std::optional<TapeDistance> result;
        for (const int index : corners) {
            const TapeDistance candidate = tape(point, index);
            const bool isTaken = std::any_of(tapes.begin(), tapes.end(),
                                             [&](const TapeDistance& one) { return one.corner == index; });
            if (!tapes.empty() && !isTaken && (!result || candidate.metres < result->metres - kEqualM)) {
                result = candidate;
            }
        }
        return result;
    }

    std::optional<double> sigmaOf(const Vector2d& point, int a, int b) const {
        const Vector2d fromA = point - corner(a);
        const Vector2d fromB = point - corner(b);
        const double sine =
            std::abs(fromA.x() * fromB.y() - fromA.y() * fromB.x()) / (fromA.norm() * fromB.norm());
        if (!(sine >= kLeastSine)) {
            return std::nullopt;
        }
        return std::hypot(tapeSigma(fromA.norm()), tapeSigma(fromB.norm())) / sine;
    }

    /// Whether the other point at these distances lies in the room as well.
    bool isAmbiguous(const Vector2d& point, int a, int b) const {
        const Vector2d along = (corner(b) - corner(a)).normalized();
        const Vector2d fromA = point - corner(a);
        const Vector2d other = corner(a) + 2 * fromA.dot(along) * along - fromA;
        return contains(outline(), other);
    }

    Floor m_floor;
};

} // namespace

std::vector<RailMark> railMarks(const Room& room, const Plan& plan) {
    room.validate();
    const TapeFinder tapes(room);
    std::vector<RailMark> result;
    for (int i = 0; i < static_cast<int>(plan.placements.size()); ++i) {
        const RailPlacement& rail = plan.placements[static_cast<std::size_t>(i)];
        result.push_back({i, tapes.mark(rail.origin), tapes.mark(rail.stop(rail.stops - 1))});
    }
    return result;
}

std::string cornerName(int index) {
    constexpr int kLetters = 26;
    std::string name(1, static_cast<char>('A' + index % kLetters));
    return index < kLetters ? name : cornerName(index / kLetters - 1) + name;
}

} // namespace spherewalk::survey
