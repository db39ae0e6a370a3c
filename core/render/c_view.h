// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/render/view.h"
#include "spherewalk/spherewalk.h"

#include <vector>

/// What the caller of the C interface gives for a view and gets of it.
namespace spherewalk::render {

/// Memory that the next view uses again.
struct ViewMemory {
    View view;
    std::vector<Overlay> overlays;
};

/// options: may be NULL. camera: of the view. overlays: made to be those of the options; they must live as
/// long as what is returned. Errors: InvalidInput for what means nothing.
ViewOptions viewOptions(const spherewalk_view_options* options, const CameraIntrinsics& camera,
                        std::vector<Overlay>& overlays);

/// The caller's memory for a view and its report.
class ViewTarget {
  public:
    /// report: may be NULL. Errors: InvalidInput, before anything is rendered, for structs of unknown
    /// versions and buffers that are too small.
    ViewTarget(const spherewalk_view* view, spherewalk_report* report, const CameraIntrinsics& camera);

    /// Asks for what the caller has memory for.
    void want(ViewOptions& options) const;

    void fill(const View& view) const;

  private:
    spherewalk_view m_view;
    spherewalk_report* m_report;
    int m_width;
    int m_height;
};

} // namespace spherewalk::render
