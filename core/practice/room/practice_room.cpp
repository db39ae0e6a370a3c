// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/practice/practice_room.h"

#include "room/picture.h"
#include "room/scene.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/polygon.h"
#include "spherewalk/photo/april_tag.h"

#include <algorithm>
#include <utility>

namespace spherewalk::practice {

namespace {

[[noreturn]] void refuse(std::string_view why) {
    throw Error(ErrorKind::InvalidInput, text("Could not make the practice room: ", why));
}

bool isWithin(double value, double least, double most) {
    return value >= least && value <= most; // false for NaN
}

} // namespace

void PracticeRoomOptions::validate() const {
    if (!isWithin(sizeM.x(), 4, 12) || !isWithin(sizeM.y(), 3.5, 12) || !isWithin(sizeM.z(), 2.3, 5)) {
        refuse(text("its size must be between 4 x 3.5 x 2.3 m and 12 x 12 x 5 m, not ", sizeM.x(), " x ",
                    sizeM.y(), " x ", sizeM.z(), " m."));
    }
    if (style == RoomStyle::Flat && (sizeM.x() < 7 || sizeM.y() < 5.5)) {
        refuse(text("a flat needs at least 7 x 5.5 m, not ", sizeM.x(), " x ", sizeM.y(), " m."));
    }
    if (!(originM.cwiseAbs().maxCoeff() <= 1e8) || !originM.allFinite()) {
        refuse("its corner must lie within 100000 km of the origin.");
    }
    if (objects.size() > 1000) {
        refuse(text("it can hold 1000 objects, not ", objects.size(), "."));
    }
    for (const PracticeObject& object : objects) {
        const Eigen::Vector3d inside = object.centreM - originM;
        if (!inside.allFinite() || !object.halfSizeM.allFinite() || !(object.halfSizeM.minCoeff() > 0) ||
            inside.minCoeff() < 0 || (sizeM - inside).minCoeff() < 0 || !std::isfinite(object.yaw.value())) {
            refuse("each object needs a size above zero and a centre inside the room.");
        }
        if (object.castsShadow && object.shape != PracticeObject::Shape::Sphere) {
            refuse("only spheres can cast shadows.");
        }
    }
    for (const PracticeTag& tag : tags) {
        const Eigen::Vector3d inside = tag.centreM - originM;
        if (tag.number < 0 || tag.number >= photo::kTagNumbers || !isWithin(tag.sizeM, 0.02, 1) ||
            !inside.allFinite() || inside.minCoeff() < 0 || (sizeM - inside).minCoeff() < 0 ||
            !std::isfinite(tag.facing.value())) {
            refuse(text("each tag needs a number from 0 to ", photo::kTagNumbers - 1,
                        ", a size of 2 cm to 1 m, and a centre inside the room."));
        }
    }
}

struct PracticeRoom::State {
    explicit State(PracticeRoomOptions given) : options(std::move(given)), scene(options) {}

    /// In the frame of the room's corner: subtracted in double, before anything else.
    Rigid3 local(const Rigid3& roomFromEye) const {
        return {roomFromEye.rotation, roomFromEye.translation - options.originM};
    }

    PracticeRoomOptions options;
    Scene scene;
};

PracticeRoom::PracticeRoom(PracticeRoomOptions options) {
    options.validate();
    m_state = std::make_unique<State>(std::move(options));
}

PracticeRoom::~PracticeRoom() = default;
PracticeRoom::PracticeRoom(PracticeRoom&&) noexcept = default;
PracticeRoom& PracticeRoom::operator=(PracticeRoom&&) noexcept = default;

const PracticeRoomOptions& PracticeRoom::options() const {
    return m_state->options;
}

RoomPlan PracticeRoom::plan() const {
    const Eigen::Vector2d corner = m_state->options.originM.head<2>();
    const Eigen::Vector3d& size = m_state->options.sizeM;
    RoomPlan plan;
    plan.ceilingM = size.z();
    plan.outline = {corner, corner + Eigen::Vector2d(size.x(), 0), corner + size.head<2>(),
                    corner + Eigen::Vector2d(0, size.y())};
    plan.obstacles = m_state->scene.furniture().obstacles;
    for (Polygon& obstacle : plan.obstacles) {
        for (Eigen::Vector2d& vertex : obstacle) {
            // What touches a wall may reach into it by a turned corner.
            vertex = vertex.cwiseMax(0).cwiseMin(size.head<2>()) + corner;
        }
    }
    return plan;
}

Sample PracticeRoom::cast(const Eigen::Vector3d& originM, const Eigen::Vector3d& direction, double footprint,
                          Content content) const {
    const Eigen::Vector3d eye = originM - m_state->options.originM;
    const Eigen::Vector3d unitDirection = direction.normalized();
    const Scene& scene = m_state->scene;
    std::vector<Candidate> candidates;
    scene.candidates(eye, unitDirection, 0, content, candidates);
    const Hit hit = scene.hit(eye, unitDirection, candidates, content != Content::Objects);
    const Rgb colour = scene.colour(hit, eye, unitDirection, static_cast<float>(footprint));
    return {{colour[0], colour[1], colour[2]}, hit.distance};
}

double PracticeRoom::surfaceDistanceM(const Eigen::Vector3d& pInRoom) const {
    return m_state->scene.surfaceDistance(pInRoom - m_state->options.originM);
}

RgbImage PracticeRoom::spherical(const Rigid3& roomFromPhoto, const EquirectSize& size,
                                 const PictureOptions& options, ProgressSink& progress,
                                 const std::stop_token& stop) const {
    const SphericalRays rays(m_state->local(roomFromPhoto), size);
    return Picture(m_state->scene, rays, options, progress, stop).colours();
}

RgbImage PracticeRoom::view(const CameraModel& camera, const Rigid3& roomFromCamera,
                            const PictureOptions& options, ProgressSink& progress,
                            const std::stop_token& stop) const {
    const ViewRays rays(camera, m_state->local(roomFromCamera), options.threads);
    return Picture(m_state->scene, rays, options, progress, stop).colours();
}

DepthImage PracticeRoom::sphericalRange(const Rigid3& roomFromPhoto, const EquirectSize& size,
                                        const PictureOptions& options) const {
    const SphericalRays rays(m_state->local(roomFromPhoto), size);
    return Picture(m_state->scene, rays, options, noProgress(), {}).distances([](const Eigen::Vector3d&) {
        return 1.0;
    });
}

DepthImage PracticeRoom::viewDepth(const CameraModel& camera, const Rigid3& roomFromCamera,
                                   const PictureOptions& options) const {
    const ViewRays rays(camera, m_state->local(roomFromCamera), options.threads);
    return Picture(m_state->scene, rays, options, noProgress(), {})
        .distances(
            [&](const Eigen::Vector3d& direction) { return std::max(1e-12, direction.dot(rays.axis())); });
}

namespace {

/// All places of a grid that are clear.
std::vector<Eigen::Vector3d> clearPlaces(const PracticeRoom& room, double stepM, double lensHeightM) {
    constexpr double kClearM = 0.3;
    const RoomPlan plan = room.plan();
    const Bounds2 around = bounds(plan.outline);
    std::vector<Eigen::Vector3d> places;
    for (double y = around.least.y() + stepM; y < around.greatest.y(); y += stepM) {
        for (double x = around.least.x() + stepM; x < around.greatest.x(); x += stepM) {
            const Eigen::Vector2d p(x, y);
            const bool isOnFloor = contains(plan.outline, p) &&
                                   std::ranges::none_of(plan.obstacles, [&](const Polygon& obstacle) {
                                       return contains(obstacle, p);
                                   });
            const Eigen::Vector3d lens(x, y, lensHeightM);
            if (isOnFloor && room.surfaceDistanceM(lens) > kClearM) {
                places.push_back(lens);
            }
        }
    }
    return places;
}

} // namespace

std::vector<Eigen::Vector3d> walkThrough(const PracticeRoom& room, double stepM, double lensHeightM) {
    constexpr double kThroughWallsM = 100; // as if they were so much farther away
    std::vector<Eigen::Vector3d> left = clearPlaces(room, stepM, lensHeightM);
    std::vector<Eigen::Vector3d> walk;
    while (!left.empty()) {
        const Eigen::Vector3d here = walk.empty() ? left.front() : walk.back();
        const auto way = [&](const Eigen::Vector3d& there) {
            const double away = (there - here).norm();
            const bool isSeen = away == 0 || room.cast(here, there - here, 1e-3).rangeM > away;
            return isSeen ? away : away + kThroughWallsM;
        };
        const auto next = std::ranges::min_element(left, {}, way);
        walk.push_back(*next);
        left.erase(next);
    }
    return walk;
}

} // namespace spherewalk::practice
