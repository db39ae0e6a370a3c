// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/scene.h"

#include "room/noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spherewalk::practice {

namespace {

using Eigen::Vector3d;

constexpr int kFirstShape = kWalls; ///< ids: walls, then shapes
constexpr float kTexelsPerMetre = 32;
constexpr double kMirrorNudge = 1e-6;
constexpr double kShadowNudge = 1e-4;
constexpr float kFootprint = 0.05F; ///< Of light that is gathered.
constexpr float kDark = 1e-6F;
constexpr int kDirections = 12; ///< Of light on objects and in their shadows, along each axis.

int wallAxis(int wall) {
    constexpr std::array<int, kWalls> kAxes = {2, 2, 1, 1, 0, 0};
    return kAxes[static_cast<std::size_t>(wall)];
}

bool isHighWall(int wall) {
    return wall % 2 == 1; // ceiling, north, east: at the size, not at zero
}

float squared(float x) {
    return x * x;
}

/// The columns are two directions across the third one.
Eigen::Matrix3d frameAbout(const Vector3d& up) {
    Eigen::Matrix3d frame;
    frame.col(0) = up.unitOrthogonal();
    frame.col(1) = up.cross(frame.col(0));
    frame.col(2) = up;
    return frame;
}

/// Calls body(share, angle) for evenly spread shares of [0, 1] and angles of a turn.
template <class Body>
void forSquare(Body&& body) {
    for (int j = 0; j < kDirections; ++j) {
        for (int i = 0; i < kDirections; ++i) {
            body((j + 0.5) / kDirections, 2 * std::numbers::pi * (i + 0.5) / kDirections);
        }
    }
}

/// Exposure and a soft shoulder; then the square root in place of the sRGB curve, which it follows closely.
Rgb stored(const Rgb& radiance) {
    const Rgb exposed = radiance * 1.35F;
    const Rgb mapped = exposed * (1 + exposed * 0.10F) / (1 + exposed * 0.62F) * 1.47F;
    return mapped.max(0.0F).min(1.0F).sqrt() * 255.0F;
}

Shape shapeOf(const PracticeObject& object, const Vector3d& origin) {
    Shape shape;
    shape.kind = object.shape == PracticeObject::Shape::Sphere ? Shape::Kind::Sphere : Shape::Kind::Box;
    shape.centre = object.centreM - origin;
    shape.half = object.halfSizeM;
    shape.cosYaw = cos(object.yaw);
    shape.sinYaw = sin(object.yaw);
    shape.shade = 0;
    shape.isObject = true;
    shape.castsShadow = object.castsShadow;
    for (int i = 0; i < 3; ++i) {
        shape.finish.first[i] =
            squared(static_cast<float>(object.colour[static_cast<std::size_t>(i)]) / 255.0F);
    }
    return completed(shape);
}

} // namespace

Scene::Scene(const PracticeRoomOptions& options)
    : m_size(options.sizeM), m_furniture(furnished(options.style, options.sizeM)) {
    for (const PracticeTag& tag : options.tags) {
        m_furniture.shapes.push_back(sheetOf(tag, options.originM));
    }
    for (std::size_t i = 0; i < m_furniture.shapes.size(); ++i) {
        m_all.push_back(static_cast<std::uint16_t>(i));
        m_allUnsorted.push_back({-kNothing, static_cast<std::uint16_t>(i)});
    }
    for (const PracticeObject& object : options.objects) {
        if (object.castsShadow) {
            m_casters.push_back(static_cast<std::uint16_t>(m_furniture.shapes.size()));
        }
        m_furniture.shapes.push_back(shapeOf(object, options.originM));
    }
    for (const Shape& shape : m_furniture.shapes) {
        auto& near = m_shadedBy.emplace_back();
        for (const std::uint16_t i : m_all) {
            const Shape& other = m_furniture.shapes[i];
            const double reach = shape.boundRadius + other.boundRadius + 0.5 * shadeReach(other);
            if (&other != &shape && other.shade >= 0.3F && !shape.isObject &&
                (other.centre - shape.centre).norm() < reach) {
                near.push_back(i);
            }
        }
        // The nearest few: more cannot be seen.
        std::stable_sort(near.begin(), near.end(), [&](std::uint16_t a, std::uint16_t b) {
            const auto far = [&](std::uint16_t i) {
                const Shape& other = m_furniture.shapes[i];
                return (other.centre - shape.centre).norm() / (other.boundRadius * other.shade);
            };
            return far(a) < far(b);
        });
        near.resize(std::min<std::size_t>(near.size(), 6));
    }
    for (int wall = 0; wall < kWalls; ++wall) {
        m_lightMaps[static_cast<std::size_t>(wall)] = bakedWall(wall);
    }
}

void Scene::candidates(const Vector3d& eye, const Vector3d& axis, double halfAngle, Content content,
                       std::vector<Candidate>& found) const {
    found.clear();
    for (std::size_t i = 0; i < m_furniture.shapes.size(); ++i) {
        const Shape& shape = m_furniture.shapes[i];
        if (shape.isObject ? content == Content::Room : content == Content::Objects) {
            continue;
        }
        const Vector3d towards = shape.centre - eye;
        const double distance = towards.norm();
        const double bound = shape.boundRadius * (1 + 1e-9);
        if (distance <= bound || std::atan2(towards.cross(axis).norm(), towards.dot(axis)) <=
                                     halfAngle + std::asin(bound / distance)) {
            found.push_back({distance - bound, static_cast<std::uint16_t>(i)});
        }
    }
    // Nearest first, so that a ray is done at the first candidate beyond what it has met.
    std::sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
        return std::pair(a.nearest, a.shape) < std::pair(b.nearest, b.shape);
    });
}

Hit Scene::hit(const Vector3d& eye, const Vector3d& direction, std::span<const Candidate> candidates,
               bool withWalls) const {
    Hit nearest;
    if (withWalls) {
        double enter = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double component = direction[axis];
            if (component == 0) {
                continue;
            }
            const double towards = ((component > 0 ? m_size[axis] : 0) - eye[axis]) / component;
            const double away = ((component > 0 ? 0 : m_size[axis]) - eye[axis]) / component;
            enter = std::max(enter, away);
            if (towards < nearest.distance) {
                nearest.distance = towards;
                constexpr std::array<int, 3> kLowWalls = {static_cast<int>(Wall::West),
                                                          static_cast<int>(Wall::South),
                                                          static_cast<int>(Wall::Floor)};
                nearest.id = kLowWalls[static_cast<std::size_t>(axis)] + (component > 0 ? 1 : 0);
            }
        }
        if (nearest.distance < enter) {
            nearest = {};
        }
    }
    for (const Candidate& candidate : candidates) {
        if (candidate.nearest >= nearest.distance) {
            break;
        }
        const double distance = distanceTo(m_furniture.shapes[candidate.shape], eye, direction);
        if (distance < nearest.distance) {
            nearest = {distance, kFirstShape + candidate.shape};
        }
    }
    return nearest;
}

double Scene::surfaceDistance(const Eigen::Vector3d& point) const {
    double nearest = std::min(point.cwiseAbs().minCoeff(), (m_size - point).cwiseAbs().minCoeff());
    for (const std::uint16_t i : m_all) {
        nearest = std::min(nearest, practice::surfaceDistance(m_furniture.shapes[i], point));
    }
    return nearest;
}

Rgb Scene::colour(const Hit& hit, const Vector3d& eye, const Vector3d& direction, float footprint) const {
    if (hit.id < 0) {
        return Rgb::Zero();
    }
    const Rgb behind = radiance(hit, eye, direction, footprint, true);
    return stored(throughPanes(behind, hit.distance, eye, direction, footprint));
}

Rgb Scene::throughPanes(const Rgb& behind, double distance, const Vector3d& eye, const Vector3d& direction,
                        float footprint) const {
    constexpr float kReflected = 0.08F; // two faces of glass at normal incidence
    Rgb result = behind;
    for (const Shape& pane : m_furniture.panes) {
        const double away = distanceTo(pane, eye, direction);
        if (away >= distance) {
            continue;
        }
        const Vector3d point = eye + away * direction;
        const Vector3d normal = surfaceAt(pane, point).normal.cast<double>();
        const Vector3d mirrored = (direction - 2 * direction.dot(normal) * normal).normalized();
        const Vector3d from = point + kMirrorNudge * normal;
        const auto facing = static_cast<float>(-normal.dot(direction));
        const float share = kReflected + (1 - kReflected) * squared(squared(1 - facing)) * (1 - facing);
        const Hit seen = hit(from, mirrored, m_allUnsorted, true);
        result = result * (1 - share) + radiance(seen, from, mirrored, footprint, false) * share;
    }
    return result;
}

Rgb Scene::radiance(const Hit& hit, const Vector3d& eye, const Vector3d& direction, float footprint,
                    bool mayMirror) const {
    const Vector3d point = eye + hit.distance * direction;
    const bool isWall = hit.id < kFirstShape;
    const auto index = static_cast<std::size_t>(isWall ? hit.id : hit.id - kFirstShape);
    const SurfacePoint surface =
        isWall ? wallSurface(hit.id, point) : surfaceAt(m_furniture.shapes[index], point);
    const Finish& finish = isWall ? m_furniture.walls[index] : m_furniture.shapes[index].finish;
    const float facing = std::max(0.02F, -surface.normal.dot(direction.cast<float>()));
    const float width = footprint * static_cast<float>(hit.distance) / std::sqrt(std::sqrt(facing));

    const Rgb reflected = albedo(finish, surface, std::max(width, 1e-5F));
    Rgb light = Rgb::Constant(finish.glow);
    if (isWall) {
        light += wallLight(hit.id, surface.u, surface.v);
    } else if (finish.glow == 0) {
        light += lightAt(point, surface.normal) * openness(point, m_shadedBy[index]);
        if (surface.normal.z() > 0.9F) {
            light += sunAt(point);
        }
    }
    const bool isCaster = !isWall && m_furniture.shapes[index].castsShadow;
    if (isCaster) {
        light = gathered(point, surface.normal.cast<double>());
    } else if (mayMirror && !m_casters.empty() && finish.glow == 0) {
        light *= leftByObjects(point, surface.normal.cast<double>());
    }
    Rgb result = reflected * light;
    if (isWall && wallAxis(hit.id) != 2) {
        const float skirting = boxStep(surface.v, 0.07F, width);
        result += (linear(0xE4DCCB) * light - result) * skirting;
    }
    if (finish.mirror > 0 && mayMirror) {
        const Vector3d normal = surface.normal.cast<double>();
        const Vector3d mirrored = (direction - 2 * direction.dot(normal) * normal).normalized();
        const Vector3d from = point + kMirrorNudge * normal;
        const Hit seen = this->hit(from, mirrored, m_allUnsorted, true);
        const float share = finish.mirror + (1 - finish.mirror) * squared(squared(1 - facing)) * 0.6F;
        // A curved mirror shows more of the room in a pixel than a flat one.
        const float spread = footprint + (surface.isRound ? 2 * width / surface.width * 2 : 0);
        const Rgb tint = finish.mirror > 0.4F ? finish.first : Rgb(Rgb::Ones());
        result = result * (1 - share) + radiance(seen, from, mirrored, spread, false) * tint * share;
    }
    return result;
}

Rgb Scene::gathered(const Vector3d& point, const Vector3d& normal) const {
    const Vector3d from = point + kShadowNudge * normal;
    const Eigen::Matrix3d frame = frameAbout(normal);
    Rgb sum = Rgb::Zero();
    forSquare([&](double a, double b) { // more directions where the cosine is greater
        const double sine = std::sqrt(a);
        const Vector3d towards = frame * Vector3d(sine * std::cos(b), sine * std::sin(b), std::sqrt(1 - a));
        const Hit seen = hit(from, towards, m_allUnsorted, true);
        sum += seen.id < 0 ? Rgb(Rgb::Zero()) : radiance(seen, from, towards, kFootprint, false);
    });
    return sum / (kDirections * kDirections);
}

Rgb Scene::leftByObjects(const Vector3d& point, const Vector3d& normal) const {
    constexpr double kLeastShare = 0.002;
    Rgb hidden = Rgb::Zero();
    for (const std::uint16_t i : m_casters) {
        const Shape& ball = m_furniture.shapes[i];
        const Vector3d to = ball.centre - point;
        const double share = std::min(1.0, ball.half.x() * ball.half.x() / to.squaredNorm());
        if (share < kLeastShare || to.dot(normal) + ball.half.x() <= 0) {
            continue;
        }
        const Vector3d from = point + kShadowNudge * normal;
        const Eigen::Matrix3d frame = frameAbout(to.normalized());
        const double cap = 1 - std::sqrt(1 - share); // its solid angle is 2 pi times as large
        Rgb sum = Rgb::Zero();
        forSquare([&](double a, double b) {
            const double cosine = 1 - a * cap;
            const double sine = std::sqrt(1 - cosine * cosine);
            const Vector3d towards = frame * Vector3d(sine * std::cos(b), sine * std::sin(b), cosine);
            const auto facing = static_cast<float>(towards.dot(normal));
            const Hit seen = hit(from, towards, m_allUnsorted, true);
            if (facing > 0 && seen.distance > distanceTo(ball, from, towards)) {
                sum += radiance(seen, from, towards, kFootprint, false) * facing;
            }
        });
        hidden += sum * static_cast<float>(2 * cap / (kDirections * kDirections));
    }
    return hidden.maxCoeff() > 0 ? Rgb((1 - hidden / gathered(point, normal).max(kDark)).max(0.0F).min(1.0F))
                                 : Rgb(Rgb::Ones());
}

SurfacePoint Scene::wallSurface(int wall, const Vector3d& point) const {
    const int axis = wallAxis(wall);
    const int across = axis == 0 ? 1 : 0;
    const int up = axis == 2 ? 1 : 2;
    SurfacePoint surface;
    surface.u = static_cast<float>(point[across]);
    surface.v = static_cast<float>(point[up]);
    surface.width = static_cast<float>(m_size[across]);
    surface.height = static_cast<float>(m_size[up]);
    surface.normal = Eigen::Vector3f::Zero();
    surface.normal[axis] = isHighWall(wall) ? -1 : 1;
    return surface;
}

Vector3d Scene::wallPoint(int wall, float u, float v) const {
    const int axis = wallAxis(wall);
    Vector3d point;
    point[axis] = isHighWall(wall) ? m_size[axis] : 0;
    point[axis == 0 ? 1 : 0] = u;
    point[axis == 2 ? 1 : 2] = v;
    return point;
}

Scene::LightMap Scene::bakedWall(int wall) const {
    const SurfacePoint corner = wallSurface(wall, m_size);
    LightMap map;
    map.perMetre = kTexelsPerMetre;
    map.columns = static_cast<int>(std::ceil(corner.width * map.perMetre)) + 2;
    map.rows = static_cast<int>(std::ceil(corner.height * map.perMetre)) + 2;
    std::vector<std::uint16_t> near;
    for (const std::uint16_t i : m_all) {
        const Shape& shape = m_furniture.shapes[i];
        const int axis = wallAxis(wall);
        const double away = std::abs(shape.centre[axis] - (isHighWall(wall) ? m_size[axis] : 0));
        if (shape.shade >= 0.2F && away < shape.boundRadius + shadeReach(shape)) {
            near.push_back(i);
        }
    }
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            const Vector3d point = wallPoint(wall, static_cast<float>(column) / map.perMetre,
                                             static_cast<float>(row) / map.perMetre);
            Rgb light = lightAt(point, corner.normal) * openness(point, near) * cornerOpenness(point, wall);
            if (wall == static_cast<int>(Wall::Floor)) {
                light += sunAt(point);
            }
            map.values.push_back(light);
        }
    }
    return map;
}

Rgb Scene::wallLight(int wall, float u, float v) const {
    const LightMap& map = m_lightMaps[static_cast<std::size_t>(wall)];
    const float x = std::max(0.0F, u * map.perMetre);
    const float y = std::max(0.0F, v * map.perMetre);
    const int column = std::min(static_cast<int>(x), map.columns - 2);
    const int row = std::min(static_cast<int>(y), map.rows - 2);
    const float tx = std::min(1.0F, x - static_cast<float>(column));
    const float ty = std::min(1.0F, y - static_cast<float>(row));
    const Rgb* at = map.values.data() +
                    static_cast<std::size_t>(row) * static_cast<std::size_t>(map.columns) +
                    static_cast<std::size_t>(column);
    const Rgb low = at[0] + (at[1] - at[0]) * tx;
    const Rgb high = at[map.columns] + (at[map.columns + 1] - at[map.columns]) * tx;
    return low + (high - low) * ty;
}

Rgb Scene::lightAt(const Vector3d& point, const Eigen::Vector3f& normal) const {
    const Rgb sky(0.98F, 1.0F, 1.05F);
    const Rgb bounce(0.62F, 0.50F, 0.38F);
    Rgb light = (sky * (0.5F + 0.5F * normal.z()) + bounce * (0.5F - 0.5F * normal.z())) * 0.42F;

    const Eigen::Vector3f toWindow = (m_furniture.windowCentre - point).cast<float>();
    const auto area = static_cast<float>(4 * m_furniture.windowHalf.y() * m_furniture.windowHalf.z());
    const float windowSquared = toWindow.squaredNorm() + 0.05F;
    const float towards = 1 / std::sqrt(windowSquared);
    // A large lamp wraps around: its light does not end at the horizon of the surface.
    const float window = clamp01((normal.dot(toWindow) * towards + 0.25F) / 1.25F) *
                         clamp01(0.15F - toWindow.x() * towards) * area / (area + 2.5F * windowSquared);
    light += Rgb(1.9F, 2.0F, 2.15F) * window;

    const auto lamp = [&](const Vector3d& at, const Rgb& colour) {
        const Eigen::Vector3f to = (at - point).cast<float>();
        const float distanceSquared = to.squaredNorm();
        const float cosine = normal.dot(to) / std::sqrt(distanceSquared + 1e-6F);
        light += colour * (clamp01((cosine + 0.15F) / 1.15F) / (0.5F + distanceSquared));
    };
    lamp(m_furniture.ceilingLamp, Rgb(1.00F, 0.88F, 0.68F) * 0.95F);
    lamp(m_furniture.floorLamp, Rgb(1.00F, 0.80F, 0.52F) * 0.50F);
    return light;
}

Rgb Scene::sunAt(const Vector3d& point) const {
    // From the window down into the room; the sun's patch gets softer with the way.
    const Vector3d fromSun(1.0, 0.28, -0.86);
    const double way = point.x() / fromSun.x();
    const Vector3d atWindow = point - way * fromSun - m_furniture.windowCentre;
    const auto softness = static_cast<float>(0.02 + 0.03 * way);
    const auto inside = [&](double offset, double half) {
        return smoothStep(-softness, softness, static_cast<float>(half - std::abs(offset)));
    };
    const auto bar = [&](double offset, double half) {
        return 1 -
               inside(offset, half) * static_cast<float>(half) / (static_cast<float>(half) + softness) * 2;
    };
    const float open =
        inside(atWindow.y(), m_furniture.windowHalf.y()) * inside(atWindow.z(), m_furniture.windowHalf.z()) *
        std::max(0.0F, bar(atWindow.y(), 0.03)) * std::max(0.0F, bar(atWindow.z() - 0.25, 0.02));
    return Rgb(1.15F, 1.05F, 0.85F) * (1.1F * open);
}

float Scene::openness(const Vector3d& point, std::span<const std::uint16_t> near) const {
    float open = 1;
    for (const std::uint16_t i : near) {
        open *= 1 - shadeFrom(m_furniture.shapes[i], point);
    }
    return open;
}

float Scene::cornerOpenness(const Vector3d& point, int wall) const {
    float open = 1;
    for (int axis = 0; axis < 3; ++axis) {
        if (axis == wallAxis(wall)) {
            continue;
        }
        for (const double away : {point[axis], m_size[axis] - point[axis]}) {
            open *= 1 - 0.28F / (1 + squared(static_cast<float>(away) / 0.22F));
        }
    }
    return open;
}

} // namespace spherewalk::practice
