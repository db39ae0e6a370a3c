// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/shape.h"

#include <algorithm>
#include <array>

namespace spherewalk::practice {

namespace {

constexpr double kNearest = 1e-9; ///< a surface closer than this is the one that the ray starts on

/// Division by a component that may be zero, without NaN.
double inverse(double component) {
    return 1 / (std::abs(component) < 1e-300 ? 1e-300 : component);
}

struct Interval {
    double enter;
    double leave;

    void meet(double a, double b) {
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }

    double result() const { return enter <= leave && enter > kNearest ? enter : kNothing; }
};

double distanceToBox(const Shape& box, const Eigen::Vector3d& fromCentre, const Eigen::Vector3d& direction) {
    const Eigen::Vector3d p = box.toLocal(fromCentre);
    const Eigen::Vector3d d = box.toLocal(direction);
    Interval interval{-kNothing, kNothing};
    for (int axis = 0; axis < 3; ++axis) {
        const double factor = inverse(d[axis]);
        interval.meet((-box.half[axis] - p[axis]) * factor, (box.half[axis] - p[axis]) * factor);
    }
    return interval.result();
}

double distanceToSphere(const Shape& sphere, const Eigen::Vector3d& fromCentre,
                        const Eigen::Vector3d& direction) {
    const double along = -fromCentre.dot(direction);
    const double missSquared = (fromCentre + along * direction).squaredNorm();
    const double halfChordSquared = sphere.half.x() * sphere.half.x() - missSquared;
    if (halfChordSquared < 0) {
        return kNothing;
    }
    const double distance = along - std::sqrt(halfChordSquared);
    return distance > kNearest ? distance : kNothing;
}

double distanceToCylinder(const Shape& cylinder, const Eigen::Vector3d& fromCentre,
                          const Eigen::Vector3d& direction) {
    const double a = direction.head<2>().squaredNorm();
    const double b = fromCentre.head<2>().dot(direction.head<2>());
    const double c = fromCentre.head<2>().squaredNorm() - cylinder.half.x() * cylinder.half.x();
    Interval interval{-kNothing, kNothing};
    if (a > 1e-24) {
        const double discriminant = b * b - a * c;
        if (discriminant < 0) {
            return kNothing;
        }
        const double root = std::sqrt(discriminant);
        interval.meet((-b - root) / a, (-b + root) / a);
    } else if (c > 0) {
        return kNothing;
    }
    const double factor = inverse(direction.z());
    interval.meet((-cylinder.half.z() - fromCentre.z()) * factor,
                  (cylinder.half.z() - fromCentre.z()) * factor);
    return interval.result();
}

/// u runs to the right as seen from outside, v up (on horizontal faces: the local x and y), from the face's
/// lower left corner.
SurfacePoint boxSurface(const Shape& box, const Eigen::Vector3d& local) {
    int axis = 0;
    double outermost = -1;
    for (int i = 0; i < 3; ++i) {
        const double share = std::abs(local[i]) - box.half[i];
        if (i == 0 || share > outermost) {
            outermost = share;
            axis = i;
        }
    }
    const double sign = local[axis] < 0 ? -1 : 1;
    SurfacePoint surface;
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    normal[axis] = sign;
    surface.normal = box.toRoom(normal).cast<float>();
    surface.face = axis * 2 + (sign < 0 ? 0 : 1);
    const int across = axis == 0 ? 1 : 0;
    const int up = axis == 2 ? 1 : 2;
    // Seen from outside, the right is +y on the +x face and -x on the +y face.
    const double right = axis == 0 ? sign : axis == 1 ? -sign : 1;
    surface.u = static_cast<float>(right * local[across] + box.half[across]);
    surface.v = static_cast<float>(local[up] + box.half[up]);
    surface.width = static_cast<float>(2 * box.half[across]);
    surface.height = static_cast<float>(2 * box.half[up]);
    return surface;
}

SurfacePoint roundSurface(const Shape& shape, const Eigen::Vector3d& local) {
    SurfacePoint surface;
    const bool isCap = shape.kind == Shape::Kind::Cylinder &&
                       std::abs(local.z()) - shape.half.z() > local.head<2>().norm() - shape.half.x();
    Eigen::Vector3d normal = local;
    if (isCap) {
        normal = {0, 0, local.z() < 0 ? -1.0 : 1.0};
    } else if (shape.kind == Shape::Kind::Cylinder) {
        normal.z() = 0;
    }
    surface.normal = normal.normalized().cast<float>();
    surface.face = isCap ? (local.z() < 0 ? 4 : 5) : 0;
    const double halfHeight = shape.kind == Shape::Kind::Sphere ? shape.half.x() : shape.half.z();
    surface.u = static_cast<float>(local.x() + shape.half.x());
    surface.v = static_cast<float>(local.z() + halfHeight);
    surface.width = static_cast<float>(2 * shape.half.x());
    surface.height = static_cast<float>(2 * halfHeight);
    return surface;
}

/// Size of the shape as a neighbour sees it: of its two larger extents.
double shadeScale(const Shape& shape) {
    std::array<double, 3> extents = {shape.half.x(), shape.half.y(), shape.half.z()};
    if (shape.kind == Shape::Kind::Sphere) {
        extents = {shape.half.x(), shape.half.x(), shape.half.x()};
    }
    std::sort(extents.begin(), extents.end());
    return 0.7 * std::sqrt(extents[1] * extents[2]);
}

constexpr double kReachInScales = 4;

} // namespace

double distanceTo(const Shape& shape, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
    const Eigen::Vector3d fromCentre = origin - shape.centre;
    const double along = fromCentre.dot(direction);
    if (fromCentre.squaredNorm() - along * along > shape.boundRadius * shape.boundRadius * (1 + 1e-9)) {
        return kNothing;
    }
    switch (shape.kind) {
    case Shape::Kind::Box:
        return distanceToBox(shape, fromCentre, direction);
    case Shape::Kind::Sphere:
        return distanceToSphere(shape, fromCentre, direction);
    case Shape::Kind::Cylinder:
        return distanceToCylinder(shape, fromCentre, direction);
    }
    return kNothing;
}

double surfaceDistance(const Shape& shape, const Eigen::Vector3d& point) {
    const Eigen::Vector3d local = shape.toLocal(point - shape.centre);
    if (shape.kind == Shape::Kind::Sphere) {
        return std::abs(local.norm() - shape.half.x());
    }
    const double acrossM = local.head<2>().norm();
    const Eigen::Vector3d beyond =
        shape.kind == Shape::Kind::Box
            ? Eigen::Vector3d(local.cwiseAbs() - shape.half)
            : Eigen::Vector3d(acrossM - shape.half.x(), -kNothing, std::abs(local.z()) - shape.half.z());
    const double inside = beyond.maxCoeff();
    return inside <= 0 ? -inside : beyond.cwiseMax(0).norm();
}

SurfacePoint surfaceAt(const Shape& shape, const Eigen::Vector3d& point) {
    const Eigen::Vector3d local = shape.toLocal(point - shape.centre);
    SurfacePoint surface =
        shape.kind == Shape::Kind::Box ? boxSurface(shape, local) : roundSurface(shape, local);
    surface.local = local.cast<float>();
    surface.isRound = shape.kind != Shape::Kind::Box;
    return surface;
}

float shadeFrom(const Shape& shape, const Eigen::Vector3d& point) {
    const Eigen::Vector3d local = shape.toLocal(point - shape.centre);
    Eigen::Vector3d half = shape.half;
    if (shape.kind != Shape::Kind::Box) {
        half = {half.x() * 0.8, half.x() * 0.8,
                shape.kind == Shape::Kind::Sphere ? half.x() * 0.8 : half.z()};
    }
    const double distanceSquared = (local.cwiseAbs() - half).cwiseMax(0).squaredNorm();
    constexpr double kAtReach = 1 / (1 + kReachInScales * kReachInScales);
    const double share = 1 / (1 + distanceSquared / (shape.shadeScale * shape.shadeScale)) - kAtReach;
    return share <= 0 ? 0.0F : shape.shade * static_cast<float>(0.5 / (1 - kAtReach) * share);
}

double shadeReach(const Shape& shape) {
    return kReachInScales * shape.shadeScale;
}

Shape completed(Shape shape) {
    switch (shape.kind) {
    case Shape::Kind::Box:
        shape.boundRadius = shape.half.norm();
        break;
    case Shape::Kind::Sphere:
        shape.boundRadius = shape.half.x();
        break;
    case Shape::Kind::Cylinder:
        shape.boundRadius = std::hypot(shape.half.x(), shape.half.z());
        break;
    }
    shape.shadeScale = shadeScale(shape);
    return shape;
}

} // namespace spherewalk::practice
