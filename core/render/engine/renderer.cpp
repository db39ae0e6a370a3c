// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/renderer.h"

#include "engine/tile_supply.h"
#include "engine/view_engine.h"

#include "spherewalk/base/enum_names.h"

#include <hwy/highway.h>

#include <utility>

namespace spherewalk::render {

namespace {

constexpr EnumNames<ViewOrigin, 3> kOriginNames{{{ViewOrigin::Photo, "photo"},
                                                 {ViewOrigin::Thumbnail, "thumbnail"},
                                                 {ViewOrigin::PreviousPhoto, "previous"}}};

} // namespace

std::string_view name(ViewOrigin origin) {
    return nameOf(kOriginNames, origin);
}

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
    LateViews late = m_engine->lateViews();
    m_engine->serve(m_engine->request(camera, roomFromCamera, options), LatePolicy::Wait, late, view);
}

const Dataset& Renderer::dataset() const {
    return m_engine->dataset();
}

LoadCounters Renderer::counters() const {
    return m_engine->store().counters();
}

std::string simdTarget() {
    const auto usable = hwy::SupportedTargets() & HWY_TARGETS; // the best has the lowest bit
    return hwy::TargetName(usable & -usable);
}

} // namespace spherewalk::render
