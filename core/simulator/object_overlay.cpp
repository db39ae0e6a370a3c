// SPDX-License-Identifier: GPL-3.0-or-later
#include "object_overlay.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/error.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spherewalk::simulator {

namespace {

constexpr EnumNames<ObjectsBy, 3> kNames{
    {{ObjectsBy::Labels, "labels"}, {ObjectsBy::Depth, "depth"}, {ObjectsBy::Alone, "alone"}}};

render::RoomShape roomOf(const render::DatasetInfo& dataset) {
    if (dataset.roomShape) {
        return *dataset.roomShape;
    }
    if (dataset.outline.size() < 3 || !(dataset.ceilingM > 0)) {
        throw Error(ErrorKind::InvalidInput,
                    "Objects cannot be told by their depth: the dataset does not say where its walls and its "
                    "ceiling are. Tell them by labels.");
    }
    return {dataset.outline, 0, dataset.ceilingM};
}

} // namespace

std::string_view name(ObjectsBy by) {
    return nameOf(kNames, by);
}

ObjectsBy objectsBy(std::string_view name) {
    return valueOf(kNames, "The way to tell objects from the room,", name);
}

void OverlayOptions::validate() const {
    if (wait < Stamp::zero() || wait > std::chrono::seconds(10)) {
        throw Error(ErrorKind::InvalidInput, "A frame can wait 0 to 10 s for its overlay.");
    }
    if (!(nearerM >= 0) || !(nearerShare >= 0) || !std::isfinite(nearerM) || !std::isfinite(nearerShare)) {
        throw Error(ErrorKind::InvalidInput,
                    "How much nearer than the room objects are must be 0 or more, in metres and as a share.");
    }
    if (camera) {
        camera->validate();
    }
}

void OverlayParts::take(OverlayParts&& other) {
    const auto replace = [](auto& own, auto& with) {
        if (!with.empty()) {
            own = std::move(with);
        }
    };
    replace(colour, other.colour);
    replace(depth, other.depth);
    replace(labels, other.labels);
}

ObjectOverlay::ObjectOverlay(const OverlayOptions& options, const render::DatasetInfo& dataset,
                             const CameraIntrinsics& camera, int threads)
    : m_options(options), m_camera(camera), m_threads(threads), m_pool(threads) {
    for (const std::uint8_t label : options.roomLabels) {
        m_isRoom[label] = true;
    }
    if (options.by == ObjectsBy::Depth) {
        m_room = roomOf(dataset);
        m_rays.emplace(CameraModel(camera), m_pool, threads);
    }
}

render::Overlay ObjectOverlay::overlay(OverlayParts parts, const Rigid3& roomFromCamera) {
    render::Overlay overlay;
    overlay.camera = m_camera;
    overlay.picture = RgbaImage(m_camera.width, m_camera.height);
    m_pool.run(m_camera.height, m_threads, [&](int y, int) {
        for (int x = 0; x < m_camera.width; ++x) {
            if (isObject(parts, roomFromCamera, x, y)) {
                std::uint8_t* rgba = overlay.picture.at(x, y);
                std::copy_n(parts.colour.at(x, y), 3, rgba);
                rgba[3] = 255;
            }
        }
    });
    overlay.depth = std::move(parts.depth);
    return overlay;
}

bool ObjectOverlay::isObject(const OverlayParts& parts, const Rigid3& roomFromCamera, int x, int y) const {
    const float depth = *parts.depth.at(x, y);
    if (!(depth > 0) || !std::isfinite(depth)) {
        return false;
    }
    switch (m_options.by) {
    case ObjectsBy::Labels:
        return !m_isRoom[*parts.labels.at(x, y)];
    case ObjectsBy::Depth:
        return isNearer(depth, roomFromCamera, x, y);
    case ObjectsBy::Alone:
        break;
    }
    return true;
}

bool ObjectOverlay::isNearer(float depth, const Rigid3& roomFromCamera, int x, int y) const {
    const Eigen::Vector3d ray = m_rays->ray(x, y);
    if (!(ray.z() > 0)) {
        return false;
    }
    const double inverse =
        render::inverseDistance(m_room, roomFromCamera.translation, roomFromCamera.rotation * ray);
    if (inverse <= 0) {
        return true; // outside of the room, and looking away from it
    }
    const double room = ray.z() / inverse;
    return static_cast<double>(depth) < room - std::max(m_options.nearerM, m_options.nearerShare * room);
}

} // namespace spherewalk::simulator
