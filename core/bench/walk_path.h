// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/folder.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/render/dataset.h"

#include <Eigen/Core>

#include <memory>
#include <stop_token>
#include <vector>

namespace spherewalk::bench {

/// The places where photos were taken, each once, in an order in which a robot would visit them: layer by
/// layer upwards, rows along x, to and fro. Frames: room.
std::vector<Eigen::Vector3d> serpentine(const render::DatasetInfo& info);

/// A path through places that is walked to its end and back, again and again. Units: metres.
class StationPath {
  public:
    /// Range: at least one place.
    explicit StationPath(std::vector<Eigen::Vector3d> places);

    /// The position after a way of this length. Range: walkedM >= 0.
    Eigen::Vector3d at(double walkedM) const;

    /// The way from one end to the other.
    double lengthM() const { return m_reachedM.back(); }

  private:
    std::vector<Eigen::Vector3d> m_places;
    std::vector<double> m_reachedM; ///< The way from the first place to each place.
};

/// A dataset of copies of one photo in a row, 20 cm apart. The copies are files of their own, so that reading
/// one does not put another into the system's cache. Owner: their temporary folder lives as long as the row.
class PhotoRow {
  public:
    static constexpr double kStepM = 0.2;

    /// Copies the dataset's first photo. Errors: Full if the folder for temporary files (TMPDIR) has no room
    /// for the copies; Io; Stopped.
    PhotoRow(const render::Dataset& dataset, int copies, ProgressSink& progress, const std::stop_token& stop);

    const std::shared_ptr<const render::Dataset>& dataset() const { return m_dataset; }

  private:
    void checkRoom(std::uint64_t neededBytes) const;
    void copy(const render::Dataset& dataset, int copies, ProgressSink& progress,
              const std::stop_token& stop);

    TemporaryFolder m_folder{"spherewalk-bench"};
    std::shared_ptr<const render::Dataset> m_dataset;
};

} // namespace spherewalk::bench
