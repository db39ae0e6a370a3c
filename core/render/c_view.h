// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/render/view.h"
#include "spherewalk/spherewalk.h"

/// Views on their way to the caller of the C interface.
namespace spherewalk::render {

struct PictureSize {
    int width = 0;
    int height = 0;
};

/// options: may be NULL. Errors: InvalidInput for what means nothing.
ViewOptions viewOptions(const spherewalk_view_options* options);

/// The caller's memory for a view and its report.
class ViewTarget {
  public:
    /// report: may be NULL. Errors: InvalidInput, before anything is rendered, for structs of unknown
    /// versions and buffers that are too small.
    ViewTarget(const spherewalk_view* view, spherewalk_report* report, PictureSize size);

    void fill(const View& view) const;

  private:
    spherewalk_view m_view;
    spherewalk_report* m_report;
    PictureSize m_size;
};

} // namespace spherewalk::render
