// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/store/records.h"

#include <cstdint>
#include <set>

namespace spherewalk::jobs {

/// Which poses of a solution were imported. An alignment into which poses are imported stays an alignment:
/// what it said of the other photos, and of all together, still holds.
class ImportedPoses {
  public:
    /// Errors: Corrupt if the solution's report is none.
    explicit ImportedPoses(const store::SolutionRecord& solution);

    bool has(std::int64_t photo) const { return m_areAll || m_photos.contains(photo); }

  private:
    bool m_areAll;
    std::set<std::int64_t> m_photos;
};

/// Takes over source, model and report of an alignment into a solution that also has these imported poses.
/// What the alignment said of their photos is left out. Errors: Corrupt if the alignment's report is none.
void takeOver(const store::SolutionRecord& alignment, const std::set<std::int64_t>& imported,
              store::NewSolution& solution);

} // namespace spherewalk::jobs
