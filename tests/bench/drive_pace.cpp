// SPDX-License-Identifier: GPL-3.0-or-later
// How many views a second the preview makes of a dataset: spherewalk_drive_pace DATASET [SECONDS]
// A robot drives along the photos at 0.8 m/s, as the preview lets it. For each size of the picture and each
// scene model of the dataset it prints the time of a view itself, from the pose to the picture of Qt: the
// median, the 95th percentile, and the views a second that the median allows. The sizes are those that the
// preview chooses from while it drives. The processor's time of a view, on all of its cores together, is that
// of a machine that does nothing else, too.
#include "ui/preview/drive_pace.h"

#include "ui/preview/robot.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/render/ladder.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

using namespace spherewalk;

namespace {

constexpr double kFrameS = 1.0 / 30;
constexpr double kSpeedMps = ui::Drive::kSpeedMps;
constexpr double kTurnRad = 0.5; ///< To each side of the way.

/// The way from photo to photo, there and back.
Eigen::Vector3d placeAt(const render::DatasetInfo& info, double wayM) {
    double lengthM = 0;
    for (std::size_t i = 1; i < info.photos.size(); ++i) {
        const Eigen::Vector3d& from = info.photos[i - 1].roomFromPhoto.translation;
        const Eigen::Vector3d step = info.photos[i].roomFromPhoto.translation - from;
        if (lengthM + step.norm() >= wayM && step.norm() > 0) {
            return from + (wayM - lengthM) / step.norm() * step;
        }
        lengthM += step.norm();
    }
    return lengthM > 0 ? placeAt(info, std::fmod(wayM, lengthM))
                       : info.photos.front().roomFromPhoto.translation;
}

ui::ViewOrder orderAt(const render::DatasetInfo& info, render::SceneKind scene, double timeS,
                      bool showsError) {
    const Eigen::Vector3d at = placeAt(info, kSpeedMps * timeS);
    const ui::RobotPlace robot{at.head<2>(), Radians(kTurnRad * std::sin(0.7 * timeS))};
    return {ui::roomFromOptical(robot, {at.z(), Radians(0)}),
            timeS,
            {{scene, render::Sampling::Footprint}},
            std::nullopt,
            showsError};
}

void measure(const render::Renderer& renderer, render::SceneKind scene, const QSize& size, bool showsError,
             int views) {
    ui::ViewMaker maker(renderer, CameraIntrinsics::pinhole(size.width(), size.height(), 1.2));
    std::vector<double> timesMs;
    constexpr int kLeadIn = 10; // what is cold is made warm
    std::clock_t begun = 0;
    for (int i = 0; i < views + kLeadIn; ++i) {
        begun = i == kLeadIn ? std::clock() : begun;
        const auto begin = std::chrono::steady_clock::now();
        maker.make(orderAt(renderer.dataset().info(), scene, i * kFrameS, showsError));
        const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
        if (i >= kLeadIn) {
            timesMs.push_back(time.count());
        }
    }
    const double medianMs = quantile(timesMs, 0.5);
    const double processorMs = 1000.0 * static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC / views;
    std::printf("%4d x %4d  %-7s %-6s median %6.1f ms, 95 %% %6.1f ms, %5.1f views/s, processor %6.1f ms\n",
                size.width(), size.height(), std::string(render::name(scene)).c_str(),
                showsError ? "tinted" : "plain", medianMs, quantile(timesMs, 0.95), 1000 / medianMs,
                processorMs);
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "Usage: spherewalk_drive_pace DATASET [SECONDS]\n");
        return 2;
    }
    try {
        const double seconds = argc > 2 ? std::atof(argv[2]) : 10;
        const render::Renderer renderer(
            std::make_shared<const render::Dataset>(render::Dataset::open(argv[1])));
        std::printf("%d threads\n", hardwareThreads());
        for (const render::SceneKind scene : render::scenesOf(renderer.dataset().info())) {
            for (const double share : ui::DrivePace::kShares) {
                const QSize size = QSize(1280, 720) * share;
                for (const bool showsError : {false, true}) {
                    measure(renderer, scene, size, showsError,
                            std::max(1, static_cast<int>(seconds / kFrameS)));
                }
            }
        }
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.sentence().c_str());
        return 1;
    }
    return 0;
}
