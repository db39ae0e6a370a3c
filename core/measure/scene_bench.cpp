// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene_bench.h"

#include "contest.h"

#include "spherewalk/base/text.h"
#include "spherewalk/render/dataset_format.h"

#include <algorithm>
#include <string>
#include <utility>

namespace spherewalk::measure {

namespace {

std::string rowName(render::SceneKind scene, render::Sampling sampling) {
    return text("scene.", name(scene), ".", name(sampling));
}

void addViews(const Subject& subject, render::SceneKind scene, render::Sampling sampling,
              const CameraModel& camera, render::View& view, Contest& contest) {
    constexpr int kDirections = 120;
    render::ViewOptions options;
    options.threads = 1;
    options.scene = scene;
    options.sampling = sampling;
    const double asideM = std::min(0.5 * subject.freeM(), 0.5);
    const auto look = [&, options, asideM](int run) {
        const Rigid3 pose = lookingTo(360.0 / kDirections * run, 0, {0.8 * asideM, 0.6 * asideM, 0});
        subject.renderer().render(camera, subject.roomFromCamera(pose), options, view);
    };
    for (int run = 0; run < kDirections; ++run) { // what is read and decoded once does not count
        look(run);
    }
    contest.add(rowName(scene, sampling), look);
}

} // namespace

std::vector<BenchRow> measureScenes(const Subject& subject, int rounds, ProgressSink& progress,
                                    const std::stop_token& stop) {
    std::vector<BenchRow> rows;
    const std::vector<render::SceneKind> scenes = scenesOf(subject.dataset().info());
    const auto isSurface = [](render::SceneKind scene) {
        return scene == render::SceneKind::Room || scene == render::SceneKind::Depth;
    };
    if (!subject.radiusM() || std::none_of(scenes.begin(), scenes.end(), isSurface)) {
        return rows;
    }
    const CameraModel camera = standardCamera(57);
    for (const render::Sampling sampling : {render::Sampling::Bilinear, render::Sampling::Footprint}) {
        Contest contest;
        render::View view;
        for (const render::SceneKind scene : scenes) {
            if (scene != render::SceneKind::None) {
                addViews(subject, scene, sampling, camera, view, contest);
            }
        }
        contest.run(rounds, std::clamp(rounds / 4, 1, 10), progress, "Timing scene models", stop);
        const Measured sphere = contest.of(rowName(render::SceneKind::Sphere, sampling));
        for (const render::SceneKind scene : scenes) {
            if (isSurface(scene)) {
                BenchRow row;
                row.name = rowName(scene, sampling);
                row.own = contest.of(row.name);
                row.peer = {kSphereView, sphere.medianMs};
                row.view = ViewSetting{57, 0};
                rows.push_back(std::move(row));
            }
        }
    }
    return rows;
}

} // namespace spherewalk::measure
