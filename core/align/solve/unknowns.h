// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solve/pair_normal.h"

#include "spherewalk/align/photo_pair.h"
#include "spherewalk/align/solve.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace spherewalk::align {

/// The unknowns of one component, as the parameters of least squares. Photos and rails are counted within the
/// component. A photo has a turn from its reference, which is a rotation vector about the room's axes, and an
/// offset from its stop. A rail has x, y and heading about the mean of its stops. Frames: the room's axes;
/// the origin is the first photo's planned position. Units: metres and radians.
struct Unknowns {
    using Block = std::array<double, 3>;

    std::vector<int> photo; ///< One a photo: its index among the priors.
    std::vector<Eigen::Quaterniond> reference;
    std::vector<Eigen::Vector3d> plannedM; ///< From the local origin: the first photo's planned position.
    std::vector<int> rail;                 ///< One a photo; -1 if it stands on none.
    std::vector<Eigen::Vector3d> railCentreM;
    std::vector<Block> turn;
    std::vector<Block> offset;
    std::vector<Block> placement; ///< One a rail.
    LensPair lenses;              ///< Those of all photos.
    double lensSigmaM = HUGE_VAL; ///< Standard deviation of how far they stand ahead.

    /// The pose of photo i, its position from the local origin.
    PhotoState state(std::size_t i) const;
    std::vector<PhotoState> states() const;
    /// The derivative of photo i's position by its rail's three parameters. It is zero for a photo on no
    /// rail.
    Eigen::Matrix3d positionByPlacement(std::size_t i) const;
    /// Multiplies the turns into the references and makes them zero. The poses stay.
    void rebase();
};

/// The photos of a component where they are planned, with these rotations as references. Shape: roomFromPhoto
/// has one entry for each of `photos`. Range: there is at least one photo.
Unknowns unknowns(std::span<const int> photos, std::span<const PhotoPrior> priors,
                  std::span<const Eigen::Quaterniond> roomFromPhoto);

/// Sets every photo's tilt to what is known of it, as the model Yaw needs it: levelFromPhoto(). The heading
/// stays; the turns become part of the references.
void level(Unknowns& unknowns, std::span<const PhotoPrior> priors);

/// How far a direction leans from +z: a vector across the floor, towards where it leans, as long as the
/// angle.
struct Lean {
    Eigen::Vector2d vectorRad = Eigen::Vector2d::Zero();
    Eigen::Matrix<double, 2, 3> byTurn; ///< Derivative by a small turn about the room's axes.
};

/// The lean of a unit vector. Its length is the angle up to pi, so it has one zero, and its slope towards
/// upright never fades. Straight down it leans along +x, since any way is as good.
Lean leanOf(const Eigen::Vector3d& up);

/// Standard deviations of a photo's offset from its stop along x, y and z. They are at least 1e-5 m.
Eigen::Vector3d offsetSigmasM(const PhotoPrior& prior);

/// How many offsets along x, y and z are free of what common errors of the priors take up: place, scale and
/// heading; height and tilt; the rails.
Eigen::Vector3d offsetFreedom(const Unknowns& unknowns);

/// How far the photos stand from where they are tagged, over what their priors promise: 1 if these are right.
struct PriorScatter {
    double along = 1;  ///< Along x and y.
    double height = 1; ///< Along z.
};

/// The scatter of solved offsets, by their medians, so that single wrong tags do not count. What the whole
/// may be moved, turned and scaled by takes its share from the offsets and is given back. It is 1 where too
/// few photos are left to tell.
PriorScatter priorScatter(const Unknowns& unknowns, std::span<const PhotoPrior> priors);

/// Standard deviation of the way between two photos by their tags, along any direction of the floor.
double waySigmaM(const PhotoPrior& a, const PhotoPrior& b);

/// How far the places lie from their tags across the floor, in standard deviations of the tags: the root of
/// the mean square, in which no photo counts for more than three.
double tagMisfit(const Unknowns& unknowns, std::span<const PhotoPrior> priors);

/// How far all photos lean together from what they state, over its standard deviation. A camera may err in
/// one direction in all of its photos, so many photos state the common lean no better than one.
double commonLeanScatter(const Unknowns& unknowns, std::span<const PhotoPrior> priors);

inline bool solvesTilt(Model model) {
    return model != Model::Yaw;
}

inline bool solvesPlacement(Model model) {
    return model == Model::Placement || model == Model::Position;
}

inline bool solvesPosition(Model model) {
    return model == Model::Position;
}

} // namespace spherewalk::align
