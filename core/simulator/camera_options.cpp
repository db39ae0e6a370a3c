// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/simulator/camera_options.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/geometry/rotation.h"

#include <cmath>
#include <utility>

namespace spherewalk::simulator {

namespace {

constexpr EnumNames<Pace, 2> kPaces{{{Pace::Newest, "newest"}, {Pace::Every, "every"}}};

constexpr EnumNames<ObjectsBy, 3> kWaysToTellObjects{
    {{ObjectsBy::Labels, "labels"}, {ObjectsBy::Depth, "depth"}, {ObjectsBy::Alone, "alone"}}};

} // namespace

Rigid3 Mounting::roomFromOptical(const Rigid3& worldFromLink) const {
    const Rigid3 roomFromCamera = roomFromWorld * worldFromLink * linkFromCamera;
    return axes == CameraAxes::Body ? roomFromCamera * Rigid3{bodyFromOptical(), Eigen::Vector3d::Zero()}
                                    : roomFromCamera;
}

void Mounting::validate() const {
    if (!isPose(roomFromWorld) || !isPose(linkFromCamera)) {
        throw Error(ErrorKind::InvalidInput, "The camera's place on its link and the world's in the room "
                                             "must be finite metres and unit quaternions.");
    }
}

std::string_view name(Pace pace) {
    return nameOf(kPaces, pace);
}

Pace pace(std::string_view name) {
    return valueOf(kPaces, "The pace", name);
}

std::string_view name(ObjectsBy by) {
    return nameOf(kWaysToTellObjects, by);
}

ObjectsBy objectsBy(std::string_view name) {
    return valueOf(kWaysToTellObjects, "The way to tell objects from the room,", name);
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

void CameraOptions::validate() const {
    if (!(rateHz >= 0 && rateHz <= 1000)) {
        throw Error(ErrorKind::InvalidInput,
                    text("A camera cannot give ", rateHz, " frames a second; ask for 0 to 1000."));
    }
    mounting.validate();
    if (overlay) {
        overlay->validate();
    }
    if (sensor) {
        sensor->validate();
    }
}

} // namespace spherewalk::simulator
