// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/preview/view_maker.h"

#include "ui/panorama/picture.h"

#include <utility>

namespace spherewalk::ui {

ViewMaker::ViewMaker(render::Renderer renderer, const CameraIntrinsics& camera)
    : m_renderer(std::move(renderer)), m_camera(camera) {
}

render::ViewStream& ViewMaker::stream(std::size_t side) {
    while (m_streams.size() <= side) {
        m_streams.push_back(std::make_unique<render::ViewStream>(
            m_renderer, m_camera, render::StreamOptions{render::LatePolicy::Coarse, 0.4}));
    }
    return *m_streams[side];
}

std::vector<MadeView> ViewMaker::make(const ViewOrder& order) {
    std::vector<render::Overlay> overlays;
    if (order.ball) {
        overlays.push_back(jobs::ballOverlay(*order.ball, m_camera, order.roomFromCamera));
    }
    std::vector<MadeView> made;
    for (std::size_t side = 0; side < order.sides.size(); ++side) {
        render::ViewOptions options;
        options.scene = order.sides[side].scene;
        options.sampling = order.sides[side].sampling;
        options.overlays = overlays;
        stream(side).next(order.roomFromCamera, order.timeS, options, m_view);
        made.push_back({qtImage(m_view.picture), m_view.report});
    }
    return made;
}

} // namespace spherewalk::ui
