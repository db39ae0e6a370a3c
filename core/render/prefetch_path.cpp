// SPDX-License-Identifier: Apache-2.0
#include "prefetch_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spherewalk::render {

CameraMotion motionBetween(const Rigid3& from, const Rigid3& to, double seconds) {
    constexpr double kFastest = 1000;
    CameraMotion motion;
    if (!(seconds > 0)) {
        return motion;
    }
    motion.velocity = (to.translation - from.translation) / seconds;
    Eigen::Quaterniond turn = to.rotation * from.rotation.conjugate();
    if (turn.w() < 0) {
        turn.coeffs() = -turn.coeffs(); // the shorter way round
    }
    const double sine = turn.vec().norm();
    if (sine > 0) {
        motion.turnRate = turn.vec() * (2 * std::atan2(sine, turn.w()) / sine / seconds);
    }
    if (!motion.velocity.allFinite() || !motion.turnRate.allFinite() || motion.velocity.norm() > kFastest) {
        return {};
    }
    return motion;
}

Rigid3 predicted(const Rigid3& roomFromCamera, const CameraMotion& motion, double seconds) {
    Rigid3 pose = roomFromCamera;
    pose.translation += motion.velocity * seconds;
    const double angle = motion.turnRate.norm() * seconds;
    if (angle > 0) {
        const Eigen::AngleAxisd turn(angle, motion.turnRate.normalized());
        pose.rotation = (Eigen::Quaterniond(turn) * pose.rotation).normalized();
    }
    return pose;
}

std::vector<TileNeed> prefetchPlan(const Rigid3& roomFromCamera, const CameraMotion& motion,
                                   const PrefetchOptions& options, const std::stop_token& stop,
                                   const NeedOfView& needOfView) {
    std::vector<TileNeed> plan;
    const int steps =
        options.stepSeconds > 0
            ? static_cast<int>(std::clamp(options.horizonSeconds / options.stepSeconds, 0.0, 1e4))
            : 0;
    int tiles = 0;
    for (int step = 1; step <= steps && !stop.stop_requested(); ++step) {
        TileNeed need = needOfView(predicted(roomFromCamera, motion, step * options.stepSeconds));
        const auto found = std::find_if(plan.begin(), plan.end(),
                                        [&](const TileNeed& planned) { return planned.level == need.level; });
        const int before = found == plan.end() ? 0 : found->tiles.count();
        if (found != plan.end()) {
            need.tiles.merge(found->tiles);
        }
        tiles += need.tiles.count() - before;
        if (tiles > options.mostTiles) {
            break;
        }
        if (found == plan.end()) {
            plan.push_back(std::move(need));
        } else {
            *found = std::move(need);
        }
    }
    return plan;
}

} // namespace spherewalk::render
