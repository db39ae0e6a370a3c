// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/walk_frames.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/dataset/coco.h"
#include "spherewalk/photo/picture_file.h"

#include <algorithm>
#include <string>

namespace spherewalk::jobs {

WalkFrames::WalkFrames(const render::Renderer& renderer, const CameraModel& camera,
                       const std::vector<TimedPose>& path, const WalkOptions& options,
                       const std::vector<BallLight>& lights)
    : m_camera(camera),
      m_path(path),
      m_options(options),
      m_lights(lights),
      m_stream(renderer, camera, options.stream),
      m_pool(options.view.threads) {
    if (options.sensor) {
        m_sensor.emplace(*options.sensor, camera, options.view.threads);
    }
}

void WalkFrames::makeView(const Rigid3& roomFromCamera, double timeS, bool isMain, render::View& view) {
    const bool wantsDepth = isMain && (m_options.writesDepth || (m_sensor && m_sensor->needsDepth()));
    const bool hasObjects = !m_options.balls.empty() || !m_options.meshes.empty();
    render::ViewOptions options = m_options.view;
    options.wantsDepth = wantsDepth || hasObjects; // what hides objects, and what their shadows fall on
    m_stream.next(roomFromCamera, timeS, options, view);
    const bool wantsLabels = isMain && m_options.writesLabels;
    if ((wantsDepth || wantsLabels) && view.report.scene == render::SceneKind::None) {
        throw Error(ErrorKind::InvalidInput,
                    "The scene model \"none\" knows no depth: choose sphere, room or "
                    "depth by --scene, or export the dataset with one of them.");
    }
    if (hasObjects) {
        layObjects(roomFromCamera, isMain, view);
    }
}

/// Lays the objects into the view, whose depth is the room's.
void WalkFrames::layObjects(const Rigid3& roomFromCamera, bool isMain, render::View& view) {
    m_overlays.clear();
    for (std::size_t i = 0; i < m_options.balls.size(); ++i) {
        const Ball& ball = m_options.balls[i];
        m_overlays.push_back(m_lights.empty()
                                 ? ballOverlay(ball, m_camera, roomFromCamera)
                                 : litBallOverlay(ball, m_camera, roomFromCamera, m_lights[i], view.depth));
    }
    for (const PlacedMesh& mesh : m_options.meshes) {
        m_overlays.push_back(meshOverlay(mesh, m_camera, roomFromCamera));
    }
    render::ComposeOptions compose = m_options.view.compose;
    compose.threads = m_options.view.threads;
    m_composer.compose(m_overlays, m_camera, view.depth, compose, m_pool, view.picture, &view.overlaid,
                       isMain && m_options.writesLabels ? &view.labels : nullptr);
    if (isMain && !view.depth.empty()) {
        m_composer.layDepth(m_overlays, m_camera, view.overlaid, compose, m_pool, view.depth);
    }
}

void WalkFrames::pass(std::size_t frame) {
    const TimedPose& pose = m_path[frame];
    if (!m_sensor) {
        m_stream.pass(pose.roomFromCamera, m_options.view);
    } else if (m_sensor->isAutomatic()) {
        make(frame);
    } else {
        const auto at = [this](double timeS) { return poseAt(m_path, timeS); };
        for (const double timeS : m_sensor->times(at, pose.timeS)) {
            m_stream.pass(at(timeS), m_options.view);
        }
    }
}

const render::View& WalkFrames::make(std::size_t frame) {
    const TimedPose& pose = m_path[frame];
    if (!m_sensor) {
        makeView(pose.roomFromCamera, pose.timeS, true, m_view);
        return m_view;
    }
    m_sensorReport =
        m_sensor->take([this](const Rigid3& roomFromCamera, double timeS, bool isMain,
                              render::View& view) { makeView(roomFromCamera, timeS, isMain, view); },
                       [this](double timeS) { return poseAt(m_path, timeS); }, pose.timeS, frame, m_view);
    m_sensor->measureDepth(frame, m_view.depth);
    return m_view;
}

namespace {

constexpr const char* kBall = "ball";

/// The objects in a frame, in the order of the overlays, which numbers them.
std::vector<dataset::LabelledObject> objectsAt(const Rigid3& roomFromCamera, const CameraModel& camera,
                                               const WalkOptions& options) {
    std::vector<dataset::LabelledObject> objects;
    const auto next = [&objects] { return static_cast<std::uint16_t>(objects.size() + 1); };
    for (const Ball& ball : options.balls) {
        const double widthM = 2 * ball.radiusM;
        objects.push_back({next(),
                           kBall,
                           {Eigen::Quaterniond::Identity(), ball.centreM},
                           {widthM, widthM, widthM},
                           ballMask(ball, camera, roomFromCamera)});
    }
    for (const PlacedMesh& mesh : options.meshes) {
        objects.push_back({next(), mesh.category, mesh.roomFromBox(), mesh.boxSizeM(),
                           meshMask(mesh, camera, roomFromCamera)});
    }
    return objects;
}

} // namespace

Json annotations(const CameraModel& camera, const std::vector<TimedPose>& path, const WalkOptions& options,
                 const std::vector<std::filesystem::path>& labels) {
    std::vector<std::string> categories{kBall};
    for (const PlacedMesh& mesh : options.meshes) {
        if (std::find(categories.begin(), categories.end(), mesh.category) == categories.end()) {
            categories.push_back(mesh.category);
        }
    }
    return dataset::cocoJson(categories, path.size(), [&](std::size_t i) {
        const std::string file = labels[i].filename().string();
        return dataset::LabelledFrame{file,
                                      text(labels[i].parent_path().filename().string(), "/", file),
                                      path[i].timeS,
                                      path[i].roomFromCamera,
                                      photo::readPng16(labels[i]),
                                      objectsAt(path[i].roomFromCamera, camera, options)};
    });
}

} // namespace spherewalk::jobs
