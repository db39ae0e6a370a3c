// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/survey/marking.h"

#include "floor.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace spherewalk::survey {

using Eigen::Vector2d;

namespace {

constexpr double kLeastSine = 0.2; ///< Sine of the angle at which two tapes meet; below it they slide.

/// By how much a point moves with each reading, by the number of the reading.
using Influence = std::map<int, Vector2d>;

/// A point on the floor that tapes can begin at. Frames: the floor's own.
struct Anchor {
    TapeOrigin origin;
    Vector2d point = Vector2d::Zero(); ///< As planned.
    Vector2d laid = Vector2d::Zero();  ///< As the printed distances give it.
    Influence influence;               ///< Empty for corners and walls.
    /// Of a wall, towards the floor. Its `point` is where the tape begins.
    std::optional<Vector2d> normal;

    Vector2d towards(const Vector2d& to) const { return normal ? *normal : (to - laid).normalized(); }

    double distance(const Vector2d& to) const { return normal ? normal->dot(to - laid) : (to - laid).norm(); }
};

double cross(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// How far a point is off if all readings are off by a unit, in the worst combination of signs. The
/// displacements fill a polygon, each corner of which has one reading at both limits of its neighbours.
double worst(const Influence& influence) {
    double most = 0;
    for (const auto& [reading, along] : influence) {
        Vector2d sum = Vector2d::Zero();
        for (const auto& [other, by] : influence) {
            const double side = cross(along, by);
            const double sign = side != 0 ? side : along.dot(by);
            sum += (sign < 0 ? -1 : 1) * (other == reading ? Vector2d(Vector2d::Zero()) : by);
        }
        most = std::max({most, (sum + along).norm(), (sum - along).norm()});
    }
    return most;
}

/// The distance as it is printed.
double printed(double metres) {
    return std::round(1000 * metres) / 1000;
}

/// The point at two distances that lies nearest to `wanted`, by Newton's method; nothing if there is none.
std::optional<Vector2d> meeting(const Anchor& a, double fromA, const Anchor& b, double fromB,
                                const Vector2d& wanted) {
    constexpr int kSteps = 8;
    Vector2d point = wanted;
    for (int i = 0; i < kSteps; ++i) {
        Eigen::Matrix2d towards;
        towards << a.towards(point).transpose(), b.towards(point).transpose();
        point += towards.inverse() * Vector2d(fromA - a.distance(point), fromB - b.distance(point));
    }
    return point.allFinite() ? std::optional(point) : std::nullopt;
}

/// What two tapes come to.
struct Fix {
    const Anchor* a = nullptr;
    const Anchor* b = nullptr;
    Vector2d laid = Vector2d::Zero();
    Influence influence;
    std::optional<Vector2d> other; ///< A second point in the room at which the tapes meet.
    double errorM = INFINITY;
    double cost = INFINITY;

    bool holds(const Vector2d& point) const {
        return errorM <= kMostPlaceErrorM && (laid - point).norm() <= kMostPrintedErrorM;
    }
};

/// Chooses the tapes of one point after the other. What is marked serves those that follow.
class TapeFinder {
  public:
    explicit TapeFinder(const Room& room) : m_floor(room) {
        for (std::size_t i = 0; i < outline().size(); ++i) {
            m_corners.push_back(
                {{TapeOrigin::Kind::Corner, static_cast<int>(i)}, outline()[i], outline()[i], {}, {}});
        }
    }

    /// Finds the tapes of an end of a rail. Returns whether they hold it well enough. Others then may hang
    /// on it.
    bool mark(const Vector2d& pInRoom, const TapeOrigin& end, MarkedPoint& result) {
        const Vector2d point = pInRoom - m_floor.anchor();
        result = {pInRoom, {}, {}, {}};
        std::vector<const Anchor*> anchors = seenCorners(point);
        Choice choice = chosen(point, anchors);
        if (!choice.isHeld || !choice.check) {
            const std::vector<const Anchor*> ends = seenEnds(point);
            anchors.insert(anchors.end(), ends.begin(), ends.end());
            improve(choice, point, anchors);
        }
        if (!choice.isHeld || !choice.check || choice.isHanging()) {
            seenWalls(point, anchors);
            improve(choice, point, anchors);
        }
        if (choice.fix.a == nullptr) {
            return false;
        }
        result.tapes = {tape(point, *choice.fix.a), tape(point, *choice.fix.b)};
        result.errorM = choice.fix.errorM;
        result.check = choice.check;
        if (choice.isHeld) {
            m_ends.push_back({end, point, choice.fix.laid, std::move(choice.fix.influence), {}});
        }
        m_readings += 2;
        return choice.isHeld;
    }

  private:
    static constexpr double kAmbiguous = 30; ///< worse than any that is not and holds the point
    static constexpr double kHookM = 0.01;   ///< A tape's hook is not on the free floor.

    /// The tapes of a point and a third one.
    struct Choice {
        Fix fix;
        std::optional<TapeDistance> check;
        bool isHeld = false; ///< The tapes are good enough, and tell one place.

        /// Whether the point hangs on rails so loosely that little can hang on the point.
        bool isHanging() const {
            constexpr double kLooseM = 0.75 * kMostPlaceErrorM;
            return fix.influence.size() > 2 && fix.errorM > kLooseM;
        }
    };

    const Polygon& outline() const { return m_floor.polygons().front(); }

    Choice chosen(const Vector2d& point, const std::vector<const Anchor*>& anchors) const {
        Choice choice{bestOf(point, anchors), {}, false};
        choice.check = checkOf(point, anchors, choice.fix);
        choice.isHeld = choice.fix.holds(point) && (!choice.fix.other || choice.check);
        return choice;
    }

    /// Adds what more origins allow. Corners that hold the point stay.
    void improve(Choice& choice, const Vector2d& point, const std::vector<const Anchor*>& anchors) const {
        if (choice.isHeld && !choice.isHanging()) {
            choice.check = checkOf(point, anchors, choice.fix);
        } else {
            choice = chosen(point, anchors);
        }
    }

    static TapeDistance tape(const Vector2d& point, const Anchor& from) {
        return {from.origin, (from.point - point).norm()};
    }

    /// The tape's hook sits in the corner, a centimetre of it in the wall.
    std::vector<const Anchor*> seenCorners(const Vector2d& point) const {
        std::vector<const Anchor*> result;
        for (const Anchor& corner : m_corners) {
            const Vector2d toPoint = point - corner.point;
            if (toPoint.norm() > kHookM &&
                m_floor.sees(point, corner.point + kHookM * toPoint.normalized())) {
                result.push_back(&corner);
            }
        }
        return result;
    }

    /// The nearest marked ends of rails in sight.
    std::vector<const Anchor*> seenEnds(const Vector2d& point) const {
        constexpr std::size_t kMost = 32;
        std::vector<const Anchor*> result;
        for (const Anchor& end : m_ends) {
            if ((end.point - point).norm() > kEqualM && m_floor.sees(point, end.point)) {
                result.push_back(&end);
            }
        }
        std::stable_sort(result.begin(), result.end(), [&](const Anchor* a, const Anchor* b) {
            return (a->point - point).norm() < (b->point - point).norm();
        });
        result.resize(std::min(result.size(), kMost));
        return result;
    }

    /// Finds the walls that a tape can be held square to.
    void seenWalls(const Vector2d& point, std::vector<const Anchor*>& anchors) {
        constexpr double kFromItsEndsM = 0.05;
        m_walls.clear();
        for (std::size_t i = 0; i < outline().size(); ++i) {
            const Vector2d& begin = outline()[i];
            const Vector2d& end = outline()[(i + 1) % outline().size()];
            const Vector2d along = (end - begin).normalized();
            const double at = along.dot(point - begin);
            const Vector2d foot = begin + at * along;
            const double metres = (point - foot).norm();
            if (at < kFromItsEndsM || at > (end - begin).norm() - kFromItsEndsM || metres < kHookM) {
                continue;
            }
            const Vector2d normal = (point - foot) / metres;
            if (m_floor.sees(point, foot + kHookM * normal)) {
                m_walls.push_back({{TapeOrigin::Kind::Wall, static_cast<int>(i)}, foot, foot, {}, normal});
            }
        }
        for (const Anchor& wall : m_walls) {
            anchors.push_back(&wall);
        }
    }

    Fix bestOf(const Vector2d& point, const std::vector<const Anchor*>& anchors) const {
        Fix best;
        for (std::size_t i = 0; i < anchors.size(); ++i) {
            for (std::size_t k = i + 1; k < anchors.size(); ++k) {
                Fix fix = fixOf(point, *anchors[i], *anchors[k]);
                if (fix.cost < best.cost - kEqualM) {
                    best = std::move(fix);
                }
            }
        }
        return best;
    }

    Fix fixOf(const Vector2d& point, const Anchor& a, const Anchor& b) const {
        constexpr double kDoesNotHold = 1000;
        constexpr double kTight = 2;
        constexpr double kSquare = 2;       // it must be held square
        constexpr double kCostAMetre = 0.2; // a long tape sags, and leads through doorways
        const double fromA = (point - a.point).norm();
        const double fromB = (point - b.point).norm();
        Eigen::Matrix2d towards;
        towards << a.towards(point).transpose(), b.towards(point).transpose();
        if (!(std::abs(towards.determinant()) >= kLeastSine)) {
            return {};
        }
        const std::optional<Vector2d> laid = meeting(a, printed(fromA), b, printed(fromB), point);
        if (!laid) {
            return {};
        }
        Fix fix{&a, &b, *laid, influenceOf(towards, a, b), otherMeeting(point, a, b), 0, 0};
        fix.errorM = kReadingErrorM * worst(fix.influence);
        fix.cost = fix.errorM * (1 + kCostAMetre * (fromA + fromB)) * (fix.other ? kAmbiguous : 1) *
                   (fix.holds(point) ? 1 : kDoesNotHold) * (a.normal || b.normal ? kSquare : 1) *
                   (isTight(point, a.point) || isTight(point, b.point) ? kTight : 1);
        return fix;
    }

    /// The influence of the readings of both tapes, and of those that their origins hang on. towards: the
    /// directions of the tapes as rows.
    Influence influenceOf(const Eigen::Matrix2d& towards, const Anchor& a, const Anchor& b) const {
        const Eigen::Matrix2d byReading = towards.inverse();
        Influence result{{m_readings, byReading.col(0)}, {m_readings + 1, byReading.col(1)}};
        for (const auto& [anchor, row] : {std::pair(&a, 0), {&b, 1}}) {
            for (const auto& [reading, by] : anchor->influence) {
                const Vector2d moved = byReading.col(row) * towards.row(row).dot(by);
                result.try_emplace(reading, Vector2d::Zero()).first->second += moved;
            }
        }
        return result;
    }

    /// Whether the tape passes a wall or an obstacle so closely that the tape touches it.
    bool isTight(const Vector2d& point, const Vector2d& from) const {
        constexpr double kTouchesM = 0.05;
        for (const Polygon& polygon : m_floor.polygons()) {
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const Polygon edge{polygon[i], polygon[(i + 1) % polygon.size()]};
                const bool isOwn = distanceToEdge(edge, from) < kEqualM;
                if (!isOwn && distanceToEdge(edge, from, point) < kTouchesM) {
                    return true;
                }
            }
        }
        return false;
    }

    /// The nearest origin in sight that is none of the tapes'. It tells the point from where the tapes meet
    /// a second time.
    static std::optional<TapeDistance> checkOf(const Vector2d& point,
                                               const std::vector<const Anchor*>& anchors, const Fix& fix) {
        constexpr double kTellsM = 0.1;
        std::optional<TapeDistance> result;
        for (const Anchor* anchor : anchors) {
            const TapeDistance candidate = tape(point, *anchor);
            const bool isTaken = anchor == fix.a || anchor == fix.b;
            const bool tells =
                !fix.other || std::abs(anchor->distance(*fix.other) - anchor->distance(point)) > kTellsM;
            if (!isTaken && tells && (!result || candidate.metres < result->metres - kEqualM)) {
                result = candidate;
            }
        }
        return result;
    }

    /// The other point at these distances, if it lies in the room or nearly so.
    std::optional<Vector2d> otherMeeting(const Vector2d& point, const Anchor& a, const Anchor& b) const {
        constexpr double kNearlyM = 0.05;
        if (a.normal && b.normal) {
            return std::nullopt;
        }
        const Vector2d& from = a.normal ? b.point : a.point;
        const Vector2d axis = a.normal   ? *a.normal
                              : b.normal ? *b.normal
                                         : Vector2d((b.point - a.point).normalized());
        const Vector2d other = from + 2 * (point - from).dot(axis) * axis - (point - from);
        const bool isInRoom = contains(outline(), other) || distanceToEdge(outline(), other) < kNearlyM;
        return isInRoom ? std::optional(other) : std::nullopt;
    }

    Floor m_floor;
    std::vector<Anchor> m_corners;
    std::vector<Anchor> m_ends;  ///< Ends of rails that are held well enough.
    std::vector<Anchor> m_walls; ///< Those beside the present point.
    int m_readings = 0;
};

} // namespace

std::vector<RailMark> railMarks(const Room& room, const Plan& plan) {
    room.validate();
    TapeFinder tapes(room);
    std::vector<RailMark> result;
    std::vector<TapeOrigin> left;
    for (int i = 0; i < static_cast<int>(plan.placements.size()); ++i) {
        result.push_back({i, {}, {}});
        left.push_back({TapeOrigin::Kind::FirstStop, i});
        left.push_back({TapeOrigin::Kind::LastStop, i});
    }
    for (std::size_t before = left.size() + 1; left.size() < before;) { // the others may hang on any by now
        before = left.size();
        std::erase_if(left, [&](const TapeOrigin& end) {
            RailMark& mark = result[static_cast<std::size_t>(end.index)];
            const bool isLast = end.kind == TapeOrigin::Kind::LastStop;
            return tapes.mark(placeOf(end, Vector2d::Zero(), room, plan), end,
                              isLast ? mark.last : mark.first);
        });
    }
    return result;
}

Vector2d placeOf(const TapeOrigin& origin, const Vector2d& point, const Room& room, const Plan& plan) {
    const auto index = static_cast<std::size_t>(origin.index);
    switch (origin.kind) {
    case TapeOrigin::Kind::Corner:
        return room.outline.at(index);
    case TapeOrigin::Kind::FirstStop:
        return plan.placements.at(index).stop(0);
    case TapeOrigin::Kind::LastStop:
        return plan.placements.at(index).stop(plan.placements.at(index).stops - 1);
    case TapeOrigin::Kind::Wall:
        break;
    }
    const Vector2d& begin = room.outline.at(index);
    const Vector2d along = (room.outline.at((index + 1) % room.outline.size()) - begin).normalized();
    return begin + along.dot(point - begin) * along;
}

std::string wallName(const Room& room, int index) {
    const int next = (index + 1) % static_cast<int>(room.outline.size());
    return cornerName(index) + "-" + cornerName(next);
}

std::string cornerName(int index) {
    constexpr int kLetters = 26;
    std::string name(1, static_cast<char>('A' + index % kLetters));
    return index < kLetters ? name : cornerName(index / kLetters - 1) + name;
}

} // namespace spherewalk::survey
