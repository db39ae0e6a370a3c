// SPDX-License-Identifier: GPL-3.0-or-later
#include "object_overlay.h"

#include "spherewalk/base/error.h"
#include "spherewalk/simulator/frame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace spherewalk::simulator {

namespace {

constexpr std::uint8_t kNoLabel = 0; ///< of a simulator's picture
constexpr std::uint16_t kRoom = 0;   ///< of a view

/// False for the black of a camera that sees nothing. Without a label, nothing else tells what the depth
/// camera sees and the colour camera does not: the simulator's own model of a room or a robot.
bool isColoured(const std::uint8_t* rgb) {
    return (rgb[0] | rgb[1] | rgb[2]) != 0;
}

std::uint16_t labelOf(const OverlayParts& parts, int x, int y) {
    const std::uint8_t label = parts.labels.empty() ? kNoLabel : *parts.labels.at(x, y);
    return label == kNoLabel ? kUnlabelled : label;
}

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

ObjectOverlay::ObjectOverlay(const OverlayOptions& options, bool withLabels,
                             const render::DatasetInfo& dataset, const CameraIntrinsics& camera, int threads)
    : m_options(options),
      m_withLabels(withLabels),
      m_camera(camera),
      m_threads(threads),
      m_pool(threads),
      m_nothing(camera.width, camera.height) {
    std::fill(m_nothing.values().begin(), m_nothing.values().end(), std::numeric_limits<float>::infinity());
    for (const std::uint8_t label : options.roomLabels) {
        m_isRoom[label] = true;
    }
    if (options.by == ObjectsBy::Depth) {
        m_room = roomOf(dataset);
        m_rays.emplace(CameraModel(camera), m_pool, threads);
    }
}

render::Overlay ObjectOverlay::overlay(OverlayParts parts, const Rigid3& roomFromCamera,
                                       render::SceneKind scene) {
    render::Overlay overlay;
    overlay.camera = m_camera;
    overlay.picture = RgbaImage(m_camera.width, m_camera.height);
    if (m_withLabels) {
        overlay.labels = render::LabelImage(m_camera.width, m_camera.height);
    }
    switch (m_options.by) {
    case ObjectsBy::Labels:
        show(
            parts,
            [&](int x, int y) {
                const std::uint8_t label = *parts.labels.at(x, y);
                return !m_isRoom[label] && (label != kNoLabel || isColoured(parts.colour.at(x, y)));
            },
            overlay);
        break;
    case ObjectsBy::Depth:
        show(
            parts,
            [&](int x, int y) {
                return isColoured(parts.colour.at(x, y)) &&
                       isNearer(*parts.depth.at(x, y), roomFromCamera, x, y);
            },
            overlay);
        break;
    case ObjectsBy::Alone:
        show(
            parts, [](int, int) { return true; }, overlay);
        break;
    }
    overlay.depth = std::move(parts.depth);
    if (m_options.by != ObjectsBy::Alone && !render::hasSurfaces(scene)) {
        overlay.roomDepth = m_nothing;
    }
    return overlay;
}

template <class IsObject>
void ObjectOverlay::show(const OverlayParts& parts, const IsObject& isObject, render::Overlay& overlay) {
    m_pool.run(m_camera.height, m_threads, [&](int y, int) {
        const float* depth = parts.depth.at(0, y);
        for (int x = 0; x < m_camera.width; ++x) {
            if (depth[x] > 0 && std::isfinite(depth[x]) && isObject(x, y)) {
                std::uint8_t* rgba = overlay.picture.at(x, y);
                std::copy_n(parts.colour.at(x, y), 3, rgba);
                rgba[3] = 255;
                if (m_withLabels) {
                    *overlay.labels.at(x, y) = labelOf(parts, x, y);
                }
            }
        }
    });
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

std::vector<LabelBox> labelBoxes(const render::LabelImage& labels) {
    std::map<std::uint16_t, LabelBox> boxes;
    for (int y = 0; y < labels.height(); ++y) {
        const auto row = labels.row(y);
        for (auto first = row.begin(); first != row.end();) { // runs of one label, as objects are wide
            const std::uint16_t label = *first;
            const auto end =
                std::find_if(first, row.end(), [label](std::uint16_t of) { return of != label; });
            if (label != kRoom) {
                const int left = static_cast<int>(first - row.begin());
                const int right = static_cast<int>(end - row.begin()) - 1;
                LabelBox& box = boxes.try_emplace(label, LabelBox{label, left, y, right, y}).first->second;
                box = {label, std::min(box.left, left), box.top, std::max(box.right, right), y};
            }
            first = end;
        }
    }
    std::vector<LabelBox> result;
    result.reserve(boxes.size());
    for (const auto& [label, box] : boxes) {
        result.push_back(box);
    }
    return result;
}

} // namespace spherewalk::simulator
