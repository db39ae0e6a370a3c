// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"
#include "spherewalk/base/temporary_folder.h"
#include "spherewalk/render/dataset.h"

#include <filesystem>
#include <memory>
#include <stop_token>

namespace spherewalk::measure {

/// A dataset of copies of one photo in a row, 20 cm apart, in a temporary folder that is removed at the end.
/// The copies are files of their own: reading one does not put another into the system's cache.
class PhotoRow {
  public:
    static constexpr double kStepM = 0.2;

    /// The copied photo is the first. Errors: Full if the folder for temporary files (TMPDIR) has no room
    /// for them; Io; Stopped.
    PhotoRow(const render::Dataset& dataset, int copies, ProgressSink& progress, const std::stop_token& stop);

    const std::shared_ptr<const render::Dataset>& dataset() const { return m_dataset; }

  private:
    void checkRoom(std::uint64_t neededBytes) const;
    void copy(const render::Dataset& dataset, int copies, ProgressSink& progress,
              const std::stop_token& stop);

    TemporaryFolder m_folder{"spherewalk-bench"};
    std::shared_ptr<const render::Dataset> m_dataset;
};

} // namespace spherewalk::measure
