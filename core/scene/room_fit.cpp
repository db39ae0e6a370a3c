// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/scene/room_fit.h"

#include "spherewalk/base/statistics.h"
#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/equirect.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace spherewalk::scene {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// Directions spread evenly over the sphere. Source: the spherical Fibonacci lattice (Gonzalez 2010).
std::vector<Vector3d> evenDirections(int count) {
    const double turn = 2 * std::numbers::pi / (std::numbers::phi * std::numbers::phi);
    std::vector<Vector3d> result;
    for (int i = 0; i < count; ++i) {
        const double z = 1 - (2 * i + 1.0) / count;
        const double r = std::sqrt(1 - z * z);
        result.emplace_back(r * std::cos(turn * i), r * std::sin(turn * i), z);
    }
    return result;
}

/// Where a ray meets the outline first.
struct WallHit {
    std::size_t wall = 0;
    double inverseM = 0; ///< 1 / distance along the ray; 0 if it meets no wall.
};

WallHit firstWall(const Polygon& outline, const Vector3d& from, const Vector3d& ray) {
    WallHit first;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vector2d a = outline[i] - from.head<2>();
        const Vector2d wall = outline[(i + 1) % outline.size()] - outline[i];
        const double across = ray.x() * wall.y() - ray.y() * wall.x();
        const double along = (a.x() * ray.y() - a.y() * ray.x()) / across; // Place on the wall, from 0 to 1.
        const double t = (a.x() * wall.y() - a.y() * wall.x()) / across;
        if (across != 0 && along >= 0 && along <= 1 && t > 0 && 1 / t > first.inverseM) {
            first = {i, 1 / t};
        }
    }
    return first;
}

double inverseDistance(const survey::Room& room, const Vector3d& from, const Vector3d& ray) {
    const double flat = ray.z() < 0 ? -ray.z() / from.z() : ray.z() / (room.ceilingM - from.z());
    return std::max(flat, firstWall(room.outline, from, ray).inverseM);
}

} // namespace

std::optional<double> sphereRadius(const survey::Room& room, const std::vector<Vector3d>& pInRoom) {
    constexpr int kDirections = 500;
    const std::vector<Vector3d> directions = evenDirections(kDirections);
    double sum = 0;
    std::size_t count = 0;
    for (const Vector3d& point : pInRoom) {
        const bool inside = point.z() > 0 && point.z() < room.ceilingM &&
                            contains(room.outline, point.head<2>()) &&
                            distanceToEdge(room.outline, point.head<2>()) > 0;
        if (!inside) {
            continue;
        }
        for (const Vector3d& ray : directions) {
            sum += inverseDistance(room, point, ray);
        }
        count += directions.size();
    }
    if (count == 0) {
        return std::nullopt;
    }
    return static_cast<double>(count) / sum;
}

namespace {

constexpr double kBinM = 0.02;
constexpr double kPeakShare = 0.4;     ///< Share of the highest peak from which another one counts.
constexpr double kNearPeakM = 0.05;    ///< Points within this distance belong to the surface.
constexpr double kReachM = 0.5;        ///< Largest way of a wall, floor or ceiling from where it was drawn.
constexpr double kHighestM = 3;        ///< A camera's height, at most.
constexpr double kTallestM = 10;       ///< A ceiling's height above the camera, at most.
constexpr double kFarM = 10;           ///< What is farther counts as if it were as near as that.
constexpr double kLowestWallM = 0.3;   ///< Walls are looked at from this height above the floor ...
constexpr double kBelowCeilingM = 0.1; ///< ... to this far below the ceiling.
constexpr double kOutsideM = 0.3;      ///< Points count up to this far beyond a wall's ends.
constexpr double kShortestM = 0.6;     ///< Shorter walls, as a door's jambs, stay where they were drawn.
constexpr double kCoveredM = 0.2;      ///< Parts of a wall that are looked for points, and
constexpr double kCoveredShare = 0.4;  ///< the share of them that must have some if it is to be moved.
constexpr std::size_t kFewestPoints = 200;
constexpr int kEvery = 4; ///< Pixels of a depth, of which one is looked at.

/// A point that a photo sees, and the area that its pixel covers across the ray.
struct Seen {
    Vector3d atM;
    Vector2d fromM; ///< Where the photo stands.
    double areaM2 = 0;
    double solidAngle = 0; ///< Of the pixel, in those of one at the horizon.
};

struct Value {
    double value = 0;
    double weight = 0;
};

std::vector<Seen> pointsOf(std::span<const PosedDepth> depths) {
    std::vector<Seen> points;
    for (const PosedDepth& posed : depths) {
        const PhotoDepth& depth = *posed.depth;
        const EquirectSize size{depth.inverseM.width(), depth.inverseM.height()};
        const double side = kEvery * 2 * std::numbers::pi / size.width;
        for (int y = kEvery / 2; y < size.height; y += kEvery) {
            for (int x = kEvery / 2; x < size.width; x += kEvery) {
                if (*depth.sure.at(x, y) == 0) {
                    continue;
                }
                const Vector3d ray = direction(size, Vector2d(x, y));
                const double distance = 1 / static_cast<double>(*depth.inverseM.at(x, y));
                points.push_back({posed.roomFromPhoto * (posed.lenses.place(ray) + distance * ray),
                                  posed.roomFromPhoto.translation.head<2>(),
                                  std::pow(side * std::min(distance, kFarM), 2) * ray.head<2>().norm(),
                                  ray.head<2>().norm()});
            }
        }
    }
    return points;
}

/// Lets what is farther than usual count by its solid angle. Where nobody said how large the room is, what is
/// falsely far would heap up most.
void boundAreas(std::vector<Seen>& points) {
    std::vector<double> areas(points.size()); // Of pixels at the horizon.
    std::ranges::transform(points, areas.begin(), [](const Seen& at) { return at.areaM2 / at.solidAngle; });
    const double usual = areas.empty() ? 0 : median(std::move(areas));
    for (Seen& point : points) {
        point.areaM2 = std::min(point.areaM2, usual * point.solidAngle);
    }
}

/// The value where values heap up: the first peak that is high enough. An order of -1 looks from the
/// greatest value down. Empty if there are too few values.
std::optional<double> firstPeak(const std::vector<Value>& values, int order) {
    if (values.size() < kFewestPoints) {
        return std::nullopt;
    }
    const auto [least, most] = std::minmax_element(
        values.begin(), values.end(), [](const Value& a, const Value& b) { return a.value < b.value; });
    const double begin = least->value;
    std::vector<double> bins(static_cast<std::size_t>((most->value - begin) / kBinM) + 3);
    for (const Value& value : values) {
        bins[static_cast<std::size_t>((value.value - begin) / kBinM) + 1] += value.weight;
    }
    std::vector<double> smooth(bins.size());
    for (std::size_t i = 1; i + 1 < bins.size(); ++i) {
        smooth[i] = bins[i - 1] + bins[i] + bins[i + 1];
    }
    const double highest = *std::max_element(smooth.begin(), smooth.end());
    const auto isPeak = [&](std::size_t i) {
        return smooth[i] >= kPeakShare * highest && smooth[i] >= smooth[i - 1] && smooth[i] >= smooth[i + 1];
    };
    std::size_t peak = 0;
    for (std::size_t k = 1; k + 1 < smooth.size() && peak == 0; ++k) {
        const std::size_t i = order > 0 ? k : smooth.size() - 1 - k;
        peak = isPeak(i) ? i : 0;
    }
    const double middle = begin + (static_cast<double>(peak) - 0.5) * kBinM;
    double sum = 0;
    double weight = 0;
    for (const Value& value : values) {
        if (std::abs(value.value - middle) < kNearPeakM) {
            sum += value.weight * value.value;
            weight += value.weight;
        }
    }
    return weight > 0 ? sum / weight : middle;
}

/// The height at which points heap up, of those between two heights. A glossy floor shows a second room below
/// it, and a window the sky. order: 1 for the lowest such height, -1 for the highest.
std::optional<double> level(const std::vector<Seen>& points, double fromM, double toM, int order) {
    std::vector<Value> heights;
    for (const Seen& point : points) {
        if (point.atM.z() > fromM && point.atM.z() < toM) {
            heights.push_back({point.atM.z(), point.areaM2});
        }
    }
    return firstPeak(heights, order);
}

/// The heights of floor and ceiling; nothing where too little is seen of them, and nothing is drawn.
std::pair<std::optional<double>, std::optional<double>> levels(const std::vector<Seen>& points, double standM,
                                                               const DrawnRoom& drawn) {
    constexpr double kApartM = 0.3;
    const bool isFloorDrawn = drawn.outline.size() >= 3;
    const bool isCeilingDrawn = drawn.ceilingM > 0;
    auto floorM = isFloorDrawn ? level(points, -kReachM, kReachM, 1)
                               : level(points, standM - kHighestM, standM - kApartM, 1);
    auto ceilingM = isCeilingDrawn ? level(points, drawn.ceilingM - kReachM, drawn.ceilingM + kReachM, -1)
                                   : level(points, standM + kApartM, standM + kTallestM, -1);
    if (isFloorDrawn) {
        floorM = floorM.value_or(0);
    }
    if (isCeilingDrawn) {
        ceilingM = ceilingM.value_or(drawn.ceilingM);
    }
    return {floorM, ceilingM};
}

/// How much the points of walls heap up along two directions at right angles.
double heaping(const std::vector<Seen>& walls, double heading) {
    double sum = 0;
    for (const double turn : {0.0, std::numbers::pi / 2}) {
        const Vector2d normal(std::cos(heading + turn), std::sin(heading + turn));
        std::vector<double> bins(4096);
        for (const Seen& point : walls) {
            const double bin = normal.dot(point.atM.head<2>() - walls.front().atM.head<2>()) / (2 * kBinM);
            bins[static_cast<std::size_t>(std::clamp(bin + 2048, 0.0, 4095.0))] += point.areaM2;
        }
        for (const double bin : bins) {
            sum += bin * bin;
        }
    }
    return sum;
}

/// A rectangle about most points of walls.
Polygon rectangleAbout(const std::vector<Seen>& walls) {
    double best = 0;
    double heading = 0;
    for (int degree = 0; degree < 90; ++degree) {
        const double tried = Radians(Degrees(degree)).value();
        const double heaped = heaping(walls, tried);
        heading = heaped > best ? tried : heading;
        best = std::max(best, heaped);
    }
    const Vector2d along(std::cos(heading), std::sin(heading));
    const Vector2d across(-along.y(), along.x());
    const auto range = [&](const Vector2d& axis) {
        std::vector<double> values;
        values.reserve(walls.size());
        for (const Seen& point : walls) {
            values.push_back(axis.dot(point.atM.head<2>()));
        }
        std::sort(values.begin(), values.end());
        return Vector2d(values[values.size() / 100], values[values.size() - 1 - values.size() / 100]);
    };
    const Vector2d x = range(along);
    const Vector2d y = range(across);
    return {x[0] * along + y[0] * across, x[1] * along + y[0] * across, x[1] * along + y[1] * across,
            x[0] * along + y[1] * across};
}

/// Whether most of the points stand beyond the outline by more than a wall is moved. Through doors and
/// windows photos see beyond a right one, too, but less than they see of its own walls.
bool contradicts(const std::vector<Seen>& walls, const Polygon& outline) {
    double all = 0;
    double beyond = 0;
    for (const Seen& point : walls) {
        const Vector2d at = point.atM.head<2>();
        all += point.solidAngle;
        beyond += !contains(outline, at) && distanceToEdge(outline, at) > kReachM ? point.solidAngle : 0;
    }
    return 2 * beyond > all;
}

/// What photos show towards a drawn wall: solid angles, as in Seen.
struct Towards {
    double all = 0;
    double beyond = 0; ///< Farther than the wall by more than a wall is moved.
    std::size_t count = 0;

    void add(double beyondM, double solidAngle) {
        const bool isBeyond = beyondM > kReachM;
        all += solidAngle;
        beyond += isBeyond ? solidAngle : 0;
        count += isBeyond ? 1 : 0;
    }
};

/// Adds what one photo shows between two heights. What is not sure counts as the wall, as does furniture
/// before it.
void addTowards(const PosedDepth& posed, const Polygon& outline, std::pair<double, double> heightsM,
                std::vector<Towards>& walls) {
    const Image<float, 1>& inverseM = posed.depth->inverseM;
    const EquirectSize size{inverseM.width(), inverseM.height()};
    const Vector3d& from = posed.roomFromPhoto.translation;
    for (int y = kEvery / 2; y < size.height; y += kEvery) {
        for (int x = kEvery / 2; x < size.width; x += kEvery) {
            const Vector3d inPhoto = direction(size, Vector2d(x, y));
            const Vector3d ray = posed.roomFromPhoto.rotation * inPhoto;
            const WallHit hit = firstWall(outline, from, ray);
            const double heightM = from.z() + ray.z() / hit.inverseM;
            if (!(heightM > heightsM.first && heightM < heightsM.second)) {
                continue;
            }
            const Vector2d along = outline[(hit.wall + 1) % outline.size()] - outline[hit.wall];
            const double across = std::abs(ray.x() * along.y() - ray.y() * along.x()) / along.norm();
            const double seenM = 1 / static_cast<double>(*inverseM.at(x, y));
            const double beyondM = *posed.depth->sure.at(x, y) == 0 ? 0 : across * (seenM - 1 / hit.inverseM);
            walls[hit.wall].add(beyondM, inPhoto.head<2>().norm());
        }
    }
}

/// The drawn walls towards which photos see farther than these in most directions.
std::vector<std::size_t> seenThrough(std::span<const PosedDepth> depths, const Polygon& outline,
                                     std::pair<double, double> heightsM) {
    std::vector<Towards> walls(outline.size());
    for (const PosedDepth& posed : depths) {
        if (contains(outline, posed.roomFromPhoto.translation.head<2>())) {
            addTowards(posed, outline, heightsM, walls);
        }
    }
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        if (walls[i].count >= kFewestPoints && 2 * walls[i].beyond > walls[i].all) {
            result.push_back(i);
        }
    }
    return result;
}

/// The share of a wall's parts where points lie in its plane. A few beside each other are a thing before it.
double coveredShare(const std::vector<Value>& offsets, const std::vector<double>& places, double planeM,
                    double lengthM) {
    std::vector<bool> parts(static_cast<std::size_t>(std::ceil(lengthM / kCoveredM)));
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i] >= 0 && places[i] < lengthM && std::abs(offsets[i].value - planeM) < kNearPeakM) {
            parts[std::min(static_cast<std::size_t>(places[i] / kCoveredM), parts.size() - 1)] = true;
        }
    }
    return static_cast<double>(std::count(parts.begin(), parts.end(), true)) /
           static_cast<double>(parts.size());
}

/// How far to move a wall inwards. Empty if too little of it is seen. Photos behind the wall show its other
/// side, which is ten centimetres away where rooms adjoin.
std::optional<double> shift(const std::vector<Seen>& walls, const Vector2d& a, const Vector2d& b,
                            const Vector2d& inwards) {
    const double lengthM = (b - a).norm();
    if (lengthM < kShortestM) {
        return std::nullopt;
    }
    const Vector2d along = (b - a) / lengthM;
    std::vector<Value> offsets;
    std::vector<double> places;
    for (const Seen& point : walls) {
        const Vector2d fromA = point.atM.head<2>() - a;
        const double place = along.dot(fromA);
        const double offset = inwards.dot(fromA);
        if (place > -kOutsideM && place < lengthM + kOutsideM && std::abs(offset) < kReachM &&
            inwards.dot(point.fromM - a) > 0) {
            offsets.push_back({offset, point.areaM2});
            places.push_back(place);
        }
    }
    const std::optional<double> peak = firstPeak(offsets, 1);
    return peak && coveredShare(offsets, places, *peak, lengthM) >= kCoveredShare ? peak : std::nullopt;
}

/// The point where two walls meet, each given by a point and a direction; b if they are nearly parallel.
Vector2d meeting(const Vector2d& a, const Vector2d& alongA, const Vector2d& b, const Vector2d& alongB) {
    const double across = alongA.x() * alongB.y() - alongA.y() * alongB.x();
    if (std::abs(across) < 0.1) {
        return b;
    }
    const Vector2d apart = b - a;
    return a + (apart.x() * alongB.y() - apart.y() * alongB.x()) / across * alongA;
}

} // namespace

std::optional<double> sphereRadius(std::span<const PosedDepth> depths) {
    constexpr double kHorizon = std::numbers::pi / 6;
    double sum = 0;
    std::size_t count = 0;
    for (const PosedDepth& posed : depths) {
        const Image<float, 1>& of = posed.depth->inverseM;
        const int band = static_cast<int>(kHorizon / std::numbers::pi * of.height());
        for (int y = of.height() / 2 - band; y < of.height() / 2 + band; ++y) {
            for (int x = 0; x < of.width(); ++x) {
                sum += static_cast<double>(*of.at(x, y));
                ++count;
            }
        }
    }
    return count == 0 ? std::nullopt : std::optional(static_cast<double>(count) / sum);
}

std::optional<FittedRoom> fittedRoom(std::span<const PosedDepth> depths, const DrawnRoom& room) {
    std::vector<Seen> points = pointsOf(depths);
    if (room.outline.size() < 3) {
        boundAreas(points);
    }
    double standM = 0;
    for (const PosedDepth& posed : depths) {
        standM += posed.roomFromPhoto.translation.z() / static_cast<double>(depths.size());
    }
    const auto [floorM, ceilingM] = levels(points, standM, room);
    std::vector<Seen> walls;
    if (floorM && ceilingM) {
        std::copy_if(points.begin(), points.end(), std::back_inserter(walls),
                     [from = *floorM + kLowestWallM, to = *ceilingM - kBelowCeilingM](const Seen& point) {
                         return point.atM.z() > from && point.atM.z() < to;
                     });
    }
    if (walls.size() < kFewestPoints) {
        return std::nullopt;
    }
    const bool isDrawn = room.outline.size() >= 3;
    const bool isWrong = isDrawn && contradicts(walls, room.outline);
    const Polygon drawn = isDrawn && !isWrong ? room.outline : rectangleAbout(walls);
    const double turn = signedArea(drawn) > 0 ? 1 : -1;
    Polygon moved;
    std::vector<Vector2d> directions;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const Vector2d& b = drawn[(i + 1) % drawn.size()];
        const Vector2d along = (b - drawn[i]).normalized();
        const Vector2d inwards = turn * Vector2d(-along.y(), along.x());
        moved.push_back(drawn[i] + shift(walls, drawn[i], b, inwards).value_or(0) * inwards);
        directions.push_back(along);
    }
    render::RoomShape shape{{}, *floorM, *ceilingM};
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const std::size_t before = (i + drawn.size() - 1) % drawn.size();
        shape.outline.push_back(meeting(moved[before], directions[before], moved[i], directions[i]));
    }
    if (defect(shape.outline) && !defect(drawn)) {
        shape.outline = drawn; // walls were moved through each other
    }
    FittedRoom fitted{std::move(shape), isWrong, {}};
    if (isDrawn && !isWrong) {
        fitted.wallsSeenThrough =
            seenThrough(depths, room.outline, {*floorM + kLowestWallM, *ceilingM - kBelowCeilingM});
    }
    return fitted;
}

} // namespace spherewalk::scene
