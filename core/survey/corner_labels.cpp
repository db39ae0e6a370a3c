// SPDX-License-Identifier: GPL-3.0-or-later
#include "floor.h"

#include "spherewalk/survey/marking.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace spherewalk::survey {

using Eigen::Vector2d;

namespace {

/// The distance of a point from a segment.
double distanceTo(const Vector2d& begin, const Vector2d& end, const Vector2d& point) {
    const Vector2d along = end - begin;
    const double length2 = along.squaredNorm();
    const double share = length2 > 0 ? std::clamp((point - begin).dot(along) / length2, 0.0, 1.0) : 0;
    return (begin + share * along - point).norm();
}

/// Places one letter after the other, in the floor's own coordinates.
class LabelFinder {
  public:
    LabelFinder(const Room& room, const Plan& plan, double awayM, double radiusM)
        : m_floor(room), m_awayM(awayM), m_radiusM(radiusM) {
        for (const RailPlacement& rail : plan.placements) {
            m_rails.push_back(
                {rail.stop(0) - m_floor.anchor(), rail.stop(rail.stops - 1) - m_floor.anchor()});
        }
    }

    std::vector<Vector2d> labels() {
        for (std::size_t i = 0; i < outline().size(); ++i) {
            m_labels.push_back(best(i));
        }
        std::vector<Vector2d> result;
        for (const Vector2d& label : m_labels) {
            result.emplace_back(label + m_floor.anchor());
        }
        return result;
    }

  private:
    const Polygon& outline() const { return m_floor.polygons().front(); }

    Vector2d best(std::size_t i) const {
        const std::size_t n = outline().size();
        const bool isLeft = signedArea(outline()) > 0;
        const Vector2d& corner = outline()[i];
        const Vector2d next = outline()[(i + (isLeft ? 1 : n - 1)) % n] - corner;
        const Vector2d before = outline()[(i + (isLeft ? n - 1 : 1)) % n] - corner;
        const double from = std::atan2(next.y(), next.x());
        double opening = std::atan2(before.y(), before.x()) - from;
        opening += opening <= 0 ? 2 * std::numbers::pi : 0;
        double least = INFINITY;
        Vector2d result = corner;
        for (const double factor : {1.0, 0.7, 1.4, 0.5, 2.0, 0.35, 0.25, 0.12, 0.06}) {
            for (const double aside : {0.0, 0.2, -0.2, 0.4, -0.4, 0.6, -0.6, 0.8, -0.8}) {
                const double angle = from + 0.5 * (1 + aside) * opening;
                const Vector2d candidate =
                    corner + factor * m_awayM * Vector2d(std::cos(angle), std::sin(angle));
                const double cost =
                    std::abs(std::log2(factor)) + std::abs(aside) + crowding(corner, candidate);
                if (cost < least && belongsTo(i, candidate)) {
                    least = cost;
                    result = candidate;
                }
            }
        }
        return result;
    }

    /// Whether a letter there lies in the room, and is clearly nearest to this corner.
    bool belongsTo(std::size_t i, const Vector2d& label) const {
        constexpr double kClearlyNearer = 0.8;
        const Vector2d& corner = outline()[i];
        const double distance = (label - corner).norm();
        for (std::size_t k = 0; k < outline().size(); ++k) {
            if (k != i && distance > kClearlyNearer * (label - outline()[k]).norm()) {
                return false;
            }
        }
        return contains(outline(), label);
    }

    /// What speaks against a letter there: an obstacle covers it or hides the corner, or it touches walls,
    /// rails, their numbers or other letters.
    double crowding(const Vector2d& corner, const Vector2d& label) const {
        constexpr double kInTheCorner = 0.05; // a sight line that begins at the wall would meet it
        constexpr double kCovered = 20;
        constexpr double kHidden = 10;
        constexpr double kWall = 4;
        constexpr double kLetter = 4;
        constexpr double kRail = 2;
        constexpr double kNumberRadii = 3;
        double cost = m_floor.keepsClear(label, label, m_radiusM) ? 0 : kWall;
        cost += m_floor.has(label) ? 0 : kCovered;
        cost += m_floor.sees(label, corner + kInTheCorner * (label - corner)) ? 0 : kHidden;
        for (const Vector2d& other : m_labels) {
            cost += (other - label).norm() < 2 * m_radiusM ? kLetter : 0;
        }
        for (const Polygon& rail : m_rails) {
            cost += distanceTo(rail[0], rail[1], label) < 1.5 * m_radiusM ? kRail : 0;
            cost += (rail[0] - label).norm() < kNumberRadii * m_radiusM ? kRail : 0;
        }
        return cost;
    }

    Floor m_floor;
    double m_awayM;
    double m_radiusM;
    std::vector<Polygon> m_rails; ///< The first and the last stop of each.
    std::vector<Vector2d> m_labels;
};

} // namespace

std::vector<Vector2d> cornerLabels(const Room& room, const Plan& plan, double awayM, double radiusM) {
    room.validate();
    return LabelFinder(room, plan, awayM, radiusM).labels();
}

} // namespace spherewalk::survey
