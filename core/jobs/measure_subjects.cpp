// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure_subjects.h"

#include "cache_key.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/sha256.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/photo/picture_file.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace spherewalk::jobs {

namespace {

Subject robotSubject(const RobotPicture& picture, const CameraModel& camera) {
    Subject subject{picture.roomFromCamera, readRobotPicture(picture, camera), {}, {}};
    if (!picture.depthFile.empty()) {
        subject.depth = photo::readDepthPng(picture.depthFile);
    }
    return subject;
}

std::string fileKey(const std::filesystem::path& file) {
    return file.empty() ? "-" : sha256HexOfFile(file);
}

/// How far away the photo says things are, along the camera's axis; empty if it says nothing.
DepthImage depthFromPhoto(const render::Renderer& renderer, std::size_t photo, const CameraModel& camera,
                          const Rigid3& roomFromCamera) {
    if (renderer.dataset().info().photos[photo].depth.empty()) {
        return {};
    }
    render::ViewOptions view;
    view.scene = render::SceneKind::Depth;
    view.sampling = render::Sampling::Nearest; // its pixels are not looked at
    view.threads = 1;
    view.wantsDepth = true;
    return renderer.render(camera, roomFromCamera, view).depth;
}

} // namespace

std::vector<SpreadView> spreadViews(std::size_t photos, int directions, std::size_t most) {
    const auto turns = static_cast<std::size_t>(directions);
    const std::size_t count = std::min(photos * turns, most);
    const std::size_t spread = std::min(photos, count);
    std::set<SpreadView> views;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = k % spread;
        views.insert({i * photos / spread, (i + k / spread) % turns});
    }
    return {views.begin(), views.end()};
}

Subjects robotSubjects(const MeasureOptions& options, const CameraModel& camera) {
    return {options.pictures.size(),
            [&](std::size_t i) {
                const RobotPicture& picture = options.pictures[i];
                return Subjects::Place{picture.file.filename().string(), picture.roomFromCamera, {}};
            },
            [&](std::size_t i) { return robotSubject(options.pictures[i], camera); },
            [&](std::size_t i) {
                const RobotPicture& picture = options.pictures[i];
                return text(fileKey(picture.file), " ", fileKey(picture.depthFile), " ",
                            keyOf(picture.roomFromCamera));
            }};
}

Rigid3 levelPose(const render::DatasetPhoto& photo, Radians turn) {
    return {(yawRotation(turn) * bodyFromOptical()).normalized(), photo.roomFromPhoto.translation};
}

render::Sampling bestSampling(const render::Renderer& renderer, std::size_t photo,
                              const CameraModel& camera) {
    const double photoPxPerRad = renderer.dataset().info().photos[photo].width / (2 * std::numbers::pi);
    return photoPxPerRad < camera.intrinsics().fx ? render::Sampling::Bicubic : render::Sampling::Footprint;
}

RgbImage truthFromPhoto(const render::Renderer& renderer, std::size_t photo, const CameraModel& camera,
                        const Rigid3& roomFromCamera) {
    render::ViewOptions view;
    view.scene = render::SceneKind::None; // from its own place a photo is the truth
    view.sampling = bestSampling(renderer, photo, camera);
    view.threads = 1;
    return renderer.render(camera, roomFromCamera, view).picture;
}

Subjects leftOutSubjects(const MeasureOptions& options, const render::Renderer& renderer,
                         const CameraModel& camera) {
    const std::vector<render::DatasetPhoto>& photos = renderer.dataset().info().photos;
    if (photos.size() < 2) {
        return {};
    }
    const std::vector<SpreadView> views =
        spreadViews(photos.size(), options.directions, static_cast<std::size_t>(options.mostViews));
    const double step = 2 * std::numbers::pi / options.directions;
    const auto place = [=, &photos](std::size_t i) {
        const std::size_t photo = views[i].photo;
        const Radians turn(step * static_cast<double>(views[i].direction));
        return Subjects::Place{text(photos[photo].file, " ", std::lround(Degrees(turn).value()), " deg"),
                               levelPose(photos[photo], turn), photo};
    };
    const auto get = [=, &renderer, &camera](std::size_t i) {
        const Subjects::Place at = place(i);
        return Subject{at.roomFromCamera, truthFromPhoto(renderer, *at.without, camera, at.roomFromCamera),
                       depthFromPhoto(renderer, *at.without, camera, at.roomFromCamera), at.without};
    };
    const auto key = [=](std::size_t i) {
        return text("left out ", views[i].photo, " ", step * static_cast<double>(views[i].direction));
    };
    return {views.size(), place, get, key};
}

} // namespace spherewalk::jobs
