// SPDX-License-Identifier: GPL-3.0-or-later
#include "free/placing.h"

#include "spherewalk/base/fixed_random.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/geometry/rotation.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace spherewalk::align {

namespace {

constexpr double kBand = 0.015;           ///< Half the thickness of a floor, in heights of the lens.
constexpr std::size_t kLeastOnFloor = 30; ///< Points.
constexpr double kLowerShare = 0.3;       ///< A lower plane with so many of a table's points is the floor.
constexpr int kDraws = 600;
constexpr double kLeastDrop = 0.3; ///< Height of the lens above the floor, in usual distances to points.

struct Plane {
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    double at = 0;
};

double heightOver(const Plane& plane, std::span<const Eigen::Vector3d> photos) {
    std::vector<double> heights;
    for (const Eigen::Vector3d& photo : photos) {
        heights.push_back(plane.up.dot(photo) - plane.at);
    }
    return median(std::move(heights));
}

std::vector<Eigen::Vector3d> onPlane(const Plane& plane, std::span<const Eigen::Vector3d> points,
                                     double band) {
    std::vector<Eigen::Vector3d> on;
    for (const Eigen::Vector3d& point : points) {
        if (std::abs(plane.up.dot(point) - plane.at) < band) {
            on.push_back(point);
        }
    }
    return on;
}

/// The plane of least squares, with its normal on the side of `up`.
Plane fittedPlane(std::span<const Eigen::Vector3d> points, const Eigen::Vector3d& up) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : points) {
        middle += point / static_cast<double>(points.size());
    }
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d& point : points) {
        scatter += (point - middle) * (point - middle).transpose();
    }
    Plane plane;
    plane.up = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(0);
    plane.up *= plane.up.dot(up) < 0 ? -1 : 1;
    plane.at = plane.up.dot(middle);
    return plane;
}

/// The median distance of a point from the photo nearest to it. Distances from one photo would grow with the
/// survey.
double usualDistance(std::span<const Eigen::Vector3d> photos, std::span<const Eigen::Vector3d> points) {
    std::vector<double> distances;
    for (const Eigen::Vector3d& point : points) {
        double nearest = 1e300;
        for (const Eigen::Vector3d& photo : photos) {
            nearest = std::min(nearest, (point - photo).norm());
        }
        distances.push_back(nearest);
    }
    return median(std::move(distances));
}

struct FoundPlane {
    Plane plane;
    std::size_t count = 0;
};

/// The level plane with the most points, by planes through three of them, and by planes across `up` through
/// one: where few points lie on the floor, hardly ever all three of them do.
std::optional<FoundPlane> fullestPlane(std::span<const Eigen::Vector3d> photos,
                                       std::span<const Eigen::Vector3d> points, const Eigen::Vector3d& up,
                                       double leastCosine, FixedRandom& random) {
    if (points.size() < kLeastOnFloor) {
        return std::nullopt;
    }
    std::optional<FoundPlane> best;
    const auto consider = [&](const Plane& plane) {
        const double height = heightOver(plane, photos);
        const std::size_t count = height > 0 ? onPlane(plane, points, kBand * height).size() : 0;
        if (count > (best ? best->count : 0)) {
            best = {plane, count};
        }
    };
    for (int draw = 0; draw < kDraws; ++draw) {
        std::array<Eigen::Vector3d, 3> corner;
        std::ranges::generate(corner, [&] { return points[random.below(points.size())]; });
        const Eigen::Vector3d normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
        if (normal.norm() < 1e-9 || std::abs(normal.normalized().dot(up)) < leastCosine) {
            continue;
        }
        const Eigen::Vector3d upright = normal.normalized() * (normal.dot(up) < 0 ? -1 : 1);
        consider({upright, upright.dot(corner[0])});
    }
    const std::size_t step = 1 + points.size() / kDraws;
    for (std::size_t i = 0; i < points.size(); i += step) {
        consider({up, up.dot(points[i])});
    }
    return best;
}

} // namespace

std::optional<FloorPlane> floorBelow(std::span<const Eigen::Vector3d> photos,
                                     std::span<const Eigen::Vector3d> points, const Eigen::Vector3d& up,
                                     Radians mostLean) {
    if (photos.empty()) {
        return std::nullopt;
    }
    double lowest = 1e300;
    for (const Eigen::Vector3d& photo : photos) {
        lowest = std::min(lowest, up.dot(photo));
    }
    const double usual = usualDistance(photos, points);
    std::vector<Eigen::Vector3d> below;
    for (const Eigen::Vector3d& point : points) {
        if (up.dot(point) < lowest - kLeastDrop * usual) {
            below.push_back(point);
        }
    }
    FixedRandom random(0x464C4F4FULL);
    const double leastCosine = std::cos(mostLean.value());
    std::optional<FoundPlane> floor = fullestPlane(photos, below, up, leastCosine, random);
    std::vector<Eigen::Vector3d> lower = below;
    while (floor) {
        const double deepest = floor->plane.at - 4 * kBand * heightOver(floor->plane, photos);
        std::erase_if(lower,
                      [&](const Eigen::Vector3d& point) { return floor->plane.up.dot(point) > deepest; });
        const auto next = fullestPlane(photos, lower, up, leastCosine, random);
        if (!next || next->count < kLeastOnFloor ||
            static_cast<double>(next->count) < kLowerShare * static_cast<double>(floor->count)) {
            break;
        }
        floor = next;
    }
    if (!floor || floor->count < kLeastOnFloor) {
        return std::nullopt;
    }
    Plane plane = floor->plane;
    std::vector<Eigen::Vector3d> on;
    // What stands on the floor is above it: a narrower band leaves it out.
    for (const double band : {kBand, 0.7 * kBand, 0.5 * kBand, 0.4 * kBand, 0.4 * kBand}) {
        on = onPlane(plane, below, band * heightOver(plane, photos));
        if (on.size() < kLeastOnFloor) {
            return std::nullopt;
        }
        plane = fittedPlane(on, up);
    }
    if (plane.up.dot(up) < leastCosine) {
        return std::nullopt;
    }
    FloorPlane made{plane.up, plane.at, heightOver(plane, photos), 0, 0, static_cast<int>(on.size())};
    double square = 0;
    double spread = 0;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : on) {
        square += std::pow(plane.up.dot(point) - plane.at, 2) / static_cast<double>(on.size());
        middle += point / static_cast<double>(on.size());
    }
    for (const Eigen::Vector3d& point : on) {
        spread += (point - middle).squaredNorm() / 2;
    }
    // Neighbouring points err alike, and a floor is not flat: more points do not help without end.
    constexpr double kIndependent = 20;
    const double independent = std::min(static_cast<double>(on.size()), kIndependent);
    made.heightSigma = std::sqrt(square / independent);
    made.upSigmaRad =
        std::sqrt(square / std::max(spread * independent / static_cast<double>(on.size()), 1e-12));
    return made;
}

Radians wallHeading(std::span<const Eigen::Vector3d> pointsM) {
    constexpr double kBinM = 0.04;
    constexpr int kHeadings = 180; // of half a degree
    constexpr std::size_t kLeastPoints = 50;
    if (pointsM.size() < kLeastPoints) {
        return Radians(0);
    }
    double bestHeading = 0;
    double most = -1;
    for (int i = 0; i < kHeadings; ++i) {
        const double heading = i * std::numbers::pi / 2 / kHeadings;
        std::array<std::map<int, double>, 2> bins;
        for (const Eigen::Vector3d& point : pointsM) {
            const Eigen::Vector3d turned = yawRotation(Radians(heading)) * point;
            for (std::size_t axis = 0; axis < 2; ++axis) {
                ++bins[axis][static_cast<int>(std::floor(turned[static_cast<int>(axis)] / kBinM))];
            }
        }
        double squares = 0;
        for (const auto& axis : bins) {
            for (const auto& [bin, count] : axis) {
                squares += count * count;
            }
        }
        if (squares > most) {
            most = squares;
            bestHeading = heading;
        }
    }
    return Radians(bestHeading);
}

namespace {

constexpr double kOutside = 0.02; ///< Share of the points beyond a wall: reflections, and what windows show.
constexpr double kClearanceM = 0.4;

} // namespace

Polygon wallsAround(std::span<const Eigen::Vector3d> photosM, std::span<const Eigen::Vector3d> pointsM) {
    std::array<std::array<double, 2>, 2> sides{};
    for (int axis = 0; axis < 2; ++axis) {
        std::vector<double> along;
        for (const Eigen::Vector3d& point : pointsM) {
            along.push_back(point[axis]);
        }
        double low = along.empty() ? 1e300 : quantile(along, kOutside);
        double high = along.empty() ? -1e300 : quantile(along, 1 - kOutside);
        for (const Eigen::Vector3d& photo : photosM) {
            low = std::min(low, photo[axis] - kClearanceM);
            high = std::max(high, photo[axis] + kClearanceM);
        }
        sides[static_cast<std::size_t>(axis)] = {low, high};
    }
    const auto [left, right] = sides[0];
    const auto [front, back] = sides[1];
    return {{left, front}, {right, front}, {right, back}, {left, back}};
}

double ceilingAbove(std::span<const Eigen::Vector3d> photosM, std::span<const Eigen::Vector3d> pointsM) {
    std::vector<double> heights;
    for (const Eigen::Vector3d& point : pointsM) {
        heights.push_back(point.z());
    }
    double ceilingM = heights.empty() ? 0 : quantile(std::move(heights), 1 - kOutside);
    for (const Eigen::Vector3d& photo : photosM) {
        ceilingM = std::max(ceilingM, photo.z() + kClearanceM);
    }
    return ceilingM;
}

bool isOnePlace(const Bundle& bundle, std::size_t things) {
    // Of the usual distance of things. Walks in real rooms have 0.25 to 2.5, and photos of one place 0.008.
    constexpr double kLeastBaseline = 0.02;
    if (2 * bundle.seen.size() > things) {
        return false;
    }
    const Eigen::Vector3d& first = bundle.photos.front().positionM;
    std::vector<double> distances;
    for (const Eigen::Vector3d& point : bundle.seen) {
        distances.push_back((point - first).norm());
    }
    double farthest = 0;
    for (const PhotoState& photo : bundle.photos) {
        farthest = std::max(farthest, (photo.positionM - first).norm());
    }
    return distances.empty() || farthest < kLeastBaseline * median(std::move(distances));
}

} // namespace spherewalk::align
