// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "used_pair.h"

#include "spherewalk/align/photo_pair.h"
#include "spherewalk/align/solve.h"

#include <Eigen/Geometry>

#include <array>
#include <span>
#include <vector>

namespace spherewalk::align {

/// All that is solved for of one component, as the parameters of least squares. Photos and rails are counted
/// within the component. Parameters: a photo's turn about the room's axes from its reference; its offset from
/// its stop; a rail's x, y and heading about the middle of its stops.
struct Unknowns {
    using Block = std::array<double, 3>;

    std::vector<int> photo; ///< index among the priors
    std::vector<Eigen::Quaterniond> reference;
    std::vector<Eigen::Vector3d> plannedM; ///< from the local origin
    std::vector<int> rail;                 ///< one a photo; -1: none
    std::vector<Eigen::Vector3d> railCentreM;
    std::vector<Block> turn;
    std::vector<Block> offset;
    std::vector<Block> placement; ///< one a rail

    /// Of photo i.
    PhotoState state(std::size_t i) const;
    std::vector<PhotoState> states() const;
    /// How the photo's position follows its rail's three parameters.
    Eigen::Matrix3d positionByPlacement(std::size_t i) const;
    /// The turns become part of the references.
    void rebase();
};

/// The photos of a component where they are planned, turned as told. Shape: rotations: one a photo of these.
Unknowns unknowns(std::span<const int> photos, std::span<const PhotoPrior> priors,
                  std::span<const Eigen::Quaterniond> roomFromPhoto);

/// Makes every photo's tilt what the photo says, as the model Yaw takes it; the heading stays.
void level(Unknowns& unknowns, std::span<const PhotoPrior> priors);

/// What the photo says is up, in its own frame, and how far that is to be believed.
struct UpPrior {
    Eigen::Vector3d upInPhoto = Eigen::Vector3d::UnitZ();
    double sigmaRad = 0;
};

UpPrior upPrior(const PhotoPrior& prior);

/// Standard deviations of a photo's offset from its stop.
Eigen::Vector3d offsetSigmasM(const PhotoPrior& prior);

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
