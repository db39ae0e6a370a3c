// SPDX-License-Identifier: Apache-2.0
#include "overlay_map.h"

#include <cmath>

namespace spherewalk::render {

using Eigen::Vector2d;

namespace {

OverlayMap::Place placeOf(const Vector2d& pixel, const CameraModel& view, const CameraModel& other) {
    const auto ray = view.ray(pixel);
    const auto place = ray ? other.project(*ray) : std::nullopt;
    const bool isInside = place && place->x() >= -0.5 && place->x() <= other.width() - 0.5 &&
                          place->y() >= -0.5 && place->y() <= other.height() - 0.5;
    if (!isInside) {
        return {OverlayMap::kNowhere, 0};
    }
    return {static_cast<std::int32_t>(std::lround(OverlayMap::kOne * place->x())),
            static_cast<std::int32_t>(std::lround(OverlayMap::kOne * place->y()))};
}

} // namespace

OverlayMap::OverlayMap(const CameraModel& view, const CameraModel& other, WorkerPool& pool, int threads)
    : m_places(view.width(), view.height()) {
    pool.run(view.height(), threads, [&](int y, int) {
        for (int x = 0; x < view.width(); ++x) {
            const Place place = placeOf(Vector2d(x, y), view, other);
            m_places.at(x, y)[0] = place.u;
            m_places.at(x, y)[1] = place.v;
        }
    });
}

} // namespace spherewalk::render
