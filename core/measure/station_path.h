// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/render/dataset_format.h"

#include <Eigen/Core>

#include <vector>

namespace spherewalk::measure {

/// Where photos were taken, each place once, in an order in which a robot would visit them: layer by layer
/// upwards, rows along x, to and fro.
std::vector<Eigen::Vector3d> serpentine(const render::DatasetInfo& info);

/// A path through places, walked to its end and back, again and again.
class StationPath {
  public:
    /// Range: at least one place.
    explicit StationPath(std::vector<Eigen::Vector3d> places);

    /// Where somebody is who has walked so far. Range: >= 0.
    Eigen::Vector3d at(double walkedM) const;

    double lengthM() const { return m_reachedM.back(); }

  private:
    std::vector<Eigen::Vector3d> m_places;
    std::vector<double> m_reachedM; ///< the way to each place
};

} // namespace spherewalk::measure
