// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/measure/displacement.h"

#include "contest.h"

#include "spherewalk/base/error.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::measure {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr std::size_t kBeside = 6;
constexpr int kWitnesses = 2;

struct Moved {
    Vector2d from;
    Vector2d by;
};

/// Whether neighbours moved alike.
bool hasWitnesses(const std::vector<Moved>& all, std::size_t of) {
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i != of) {
            near.emplace_back((all[i].from - all[of].from).squaredNorm(), i);
        }
    }
    const std::size_t count = std::min(near.size(), kBeside);
    std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), near.end());
    const double tolerance = 2 + 0.25 * all[of].by.norm();
    return std::count_if(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), [&](const auto& n) {
               return (all[n.second].by - all[of].by).norm() < tolerance;
           }) >= kWitnesses;
}

} // namespace

std::vector<Displacement> matchedDisplacements(const RgbImage& truth, const RgbImage& computed) {
    return matchedDisplacements(PictureFeatures(truth), PictureFeatures(computed));
}

std::vector<Displacement> matchedDisplacements(const PictureFeatures& truth,
                                               const PictureFeatures& computed) {
    if (truth.width() != computed.width() || truth.height() != computed.height()) {
        throw Error(ErrorKind::InvalidInput, "Pictures of different sizes cannot be compared.");
    }
    std::vector<Moved> all;
    for (const PictureMatch& match : pictureMatches(truth, computed)) {
        all.push_back({match.inA, match.inB - match.inA});
    }
    std::vector<Displacement> result;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (hasWitnesses(all, i)) {
            result.push_back({all[i].from, all[i].by.norm()});
        }
    }
    return result;
}

std::vector<Displacement> exactDisplacements(const CameraModel& camera, const Rigid3& roomFromCamera,
                                             const Vector3d& photoInRoom, const DepthImage& trueZ,
                                             const DepthImage& takenZ, int every) {
    const bool isFar = takenZ.empty();
    if (trueZ.width() != camera.width() || trueZ.height() != camera.height() || every < 1 ||
        (!isFar && (takenZ.width() != trueZ.width() || takenZ.height() != trueZ.height()))) {
        throw Error(ErrorKind::InvalidInput, "A depth and its view have different sizes.");
    }
    const Vector3d photo = roomFromCamera.inverse() * photoInRoom; // in the camera's frame
    std::vector<Displacement> result;
    for (int y = 0; y < trueZ.height(); y += every) {
        for (int x = 0; x < trueZ.width(); x += every) {
            const Vector2d at(x, y);
            const auto ray = camera.ray(at);
            const double z = *trueZ.at(x, y);
            if (!ray || !(z > 0) || !std::isfinite(z) || !(ray->z() > 0)) {
                continue;
            }
            const Vector3d thing = z / ray->z() * *ray;
            const double taken = isFar ? HUGE_VAL : *takenZ.at(x, y);
            const Vector3d seen = std::isfinite(taken) ? Vector3d(taken / ray->z() * *ray - photo) : *ray;
            const auto shown = camera.project(photo + (thing - photo).norm() * seen.normalized());
            if (shown) {
                result.push_back({at, (*shown - at).norm()});
            }
        }
    }
    return result;
}

std::optional<double> quantile(const std::vector<Displacement>& displacements, double share) {
    if (displacements.empty()) {
        return std::nullopt;
    }
    std::vector<double> errors;
    for (const Displacement& displacement : displacements) {
        errors.push_back(displacement.errorPx);
    }
    return quantile(std::move(errors), share);
}

} // namespace spherewalk::measure
