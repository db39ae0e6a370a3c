// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/temporary_folder.h"
#include "spherewalk/jobs/depth_survey.h"
#include "spherewalk/render/renderer.h"

#include <span>

namespace spherewalk::jobs {

/// A dataset of some photos of another one, as if no others had been taken. Removed at the end.
class SubsetDataset {
  public:
    /// depth: of these photos, in their order; its radius and room replace those of the whole dataset; null:
    /// none. Errors: Io, Full; those of Dataset::open().
    SubsetDataset(const render::Dataset& whole, std::span<const std::size_t> photos,
                  const SurveyDepth* depth);

    const render::Renderer& renderer() const { return *m_renderer; }

  private:
    TemporaryFolder m_folder{"spherewalk-subset"};
    std::optional<render::Renderer> m_renderer;
};

} // namespace spherewalk::jobs
