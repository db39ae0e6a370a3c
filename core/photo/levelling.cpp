// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/photo/levelling.h"

#include "spherewalk/geometry/rotation.h"

#include <cmath>

namespace spherewalk::photo {

namespace {

/// Pitch and roll, if the photo says both.
std::optional<YawPitchRoll> tilt(const PhotoMetadata& metadata) {
    if (!metadata.panorama || !metadata.panorama->pitch || !metadata.panorama->roll) {
        return std::nullopt;
    }
    // GPano counts looking up as positive, our pitch looking down.
    return YawPitchRoll{Radians(0), -Radians(*metadata.panorama->pitch), Radians(*metadata.panorama->roll)};
}

} // namespace

bool isLevel(const PhotoMetadata& metadata) {
    if (metadata.theta && metadata.theta->isLevelled) {
        return *metadata.theta->isLevelled;
    }
    if (metadata.model == "RICOH THETA S" || metadata.model == "RICOH THETA SC") {
        return false;
    }
    const std::optional<YawPitchRoll> angles = tilt(metadata);
    if (!angles) {
        return metadata.model.starts_with("RICOH THETA ");
    }
    constexpr Radians kAlmostLevel = Degrees(0.5);
    return std::abs(angles->pitch.value()) < kAlmostLevel.value() &&
           std::abs(angles->roll.value()) < kAlmostLevel.value();
}

std::optional<Eigen::Quaterniond> levelFromPhoto(const PhotoMetadata& metadata) {
    if (isLevel(metadata)) {
        return Eigen::Quaterniond::Identity();
    }
    const std::optional<YawPitchRoll> angles = tilt(metadata);
    return angles ? std::optional(rotation(*angles)) : std::nullopt;
}

} // namespace spherewalk::photo
