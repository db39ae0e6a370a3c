// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/jobs/ball_overlay.h"
#include "spherewalk/render/view_stream.h"

#include <QImage>

#include <memory>
#include <optional>
#include <vector>

namespace spherewalk::ui {

/// One of the views that are compared.
struct ViewSide {
    std::optional<render::SceneKind> scene; ///< nothing: the dataset's best
    render::Sampling sampling = render::Sampling::Footprint;

    bool operator==(const ViewSide&) const = default;
};

/// What is to be shown next.
struct ViewOrder {
    Rigid3 roomFromCamera; ///< of the optical frame
    double timeS = 0;
    std::vector<ViewSide> sides; ///< one, or two to compare
    std::optional<jobs::Ball> ball;
};

struct MadeView {
    QImage picture;
    render::ViewReport report;
};

/// Makes the views of a camera that moves through a dataset. Threads: one at a time, any.
class ViewMaker {
  public:
    /// Errors: those of ViewStream.
    ViewMaker(render::Renderer renderer, const CameraIntrinsics& camera);

    /// One a side. What is not decoded yet is shown coarsely first, and isLate says so. Errors: those of
    /// ViewStream::next().
    std::vector<MadeView> make(const ViewOrder& order);

    const CameraModel& camera() const { return m_camera; }

    const render::Renderer& renderer() const { return m_renderer; }

  private:
    render::ViewStream& stream(std::size_t side);

    render::Renderer m_renderer;
    CameraModel m_camera;
    std::vector<std::unique_ptr<render::ViewStream>> m_streams; ///< of the sides
    render::View m_view;
};

} // namespace spherewalk::ui
