// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/renderer.h"

#include "view_engine.h"

#include <utility>

namespace spherewalk::render {

Renderer::Renderer(std::shared_ptr<const Dataset> dataset, const RendererOptions& options)
    : m_engine(std::make_shared<ViewEngine>(std::move(dataset), options)) {
}

View Renderer::render(const CameraModel& camera, const Rigid3& roomFromCamera,
                      const ViewOptions& options) const {
    View view;
    render(camera, roomFromCamera, options, view);
    return view;
}

void Renderer::render(const CameraModel& camera, const Rigid3& roomFromCamera, const ViewOptions& options,
                      View& view) const {
    const ViewRequest request = m_engine->checked(camera, roomFromCamera, options);
    const ViewPlan plan = m_engine->plan(request, m_engine->nearestPhoto(request));
    if (plan.surface) {
        const TileStore::ViewInProgress inProgress(m_engine->store());
        m_engine->makeFromSurfaces(request, plan, view);
        return;
    }
    const TileNeed need = m_engine->need(request, plan);
    const TileStore::ViewInProgress inProgress(m_engine->store());
    Served served;
    served.lease =
        m_engine->store().acquire(need.level, need.tiles, TileStore::Missing::Decode, options.threads);
    served.isLate = served.lease.waitedTiles() > 0;
    m_engine->make(request, plan, served, view);
}

const Dataset& Renderer::dataset() const {
    return m_engine->dataset();
}

LoadCounters Renderer::counters() const {
    return m_engine->store().counters();
}

} // namespace spherewalk::render
