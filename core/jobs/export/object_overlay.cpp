// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/object_overlay.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/colour_correction.h"
#include "spherewalk/render/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <sstream>
#include <vector>

namespace spherewalk::jobs {

namespace {

/// Pixels that may show an object.
struct PixelBox {
    int left = 0;
    int top = 0;
    int right = 0; ///< exclusive
    int bottom = 0;
};

/// The pixels around the corners of a cube about a ball; all of the picture if one of them has no pixel.
PixelBox boxAround(const Eigen::Vector3d& pInCamera, double radius, const CameraModel& camera) {
    const PixelBox whole{0, 0, camera.width(), camera.height()};
    if (pInCamera.squaredNorm() <= 3 * radius * radius) { // the cube is around the camera
        return whole;
    }
    Eigen::Vector2d least(1e9, 1e9);
    Eigen::Vector2d greatest = -least;
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d side((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                                   (corner & 4) != 0 ? 1 : -1);
        const auto pixel = camera.project(pInCamera + radius * side);
        if (!pixel) {
            return whole;
        }
        least = least.cwiseMin(*pixel);
        greatest = greatest.cwiseMax(*pixel);
    }
    const auto inside = [](double value, int most) {
        return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(most)));
    };
    return {inside(std::floor(least.x()), whole.right), inside(std::floor(least.y()), whole.bottom),
            inside(std::ceil(greatest.x()) + 1, whole.right),
            inside(std::ceil(greatest.y()) + 1, whole.bottom)};
}

/// An overlay of the camera's size that shows nothing.
render::Overlay emptyOverlay(const CameraModel& camera) {
    render::Overlay overlay;
    overlay.camera = camera.intrinsics();
    overlay.picture = RgbaImage(camera.width(), camera.height());
    overlay.depth = DepthImage(camera.width(), camera.height());
    std::fill(overlay.depth.values().begin(), overlay.depth.values().end(),
              std::numeric_limits<float>::infinity());
    return overlay;
}

/// Gives a pixel the colour of an object. Range: brightness in [0, 1]. pixel: red, green, blue and alpha.
void shade(const std::array<std::uint8_t, 3>& colour, double brightness, std::uint8_t* pixel) {
    for (std::size_t c = 0; c < 3; ++c) {
        pixel[c] = static_cast<std::uint8_t>(std::lround(brightness * colour[c]));
    }
    pixel[3] = 255;
}

/// A matt surface, lit from above.
double brightness(const Eigen::Vector3d& normalInRoom) {
    static const Eigen::Vector3d kLight = Eigen::Vector3d(0.3, 0.2, 0.93).normalized();
    return 0.4 + 0.6 * std::max(0.0, normalInRoom.dot(kLight));
}

/// Faces that look away from the light differ from each other, too.
double faceBrightness(const Eigen::Vector3d& normalInRoom) {
    static const Eigen::Vector3d kLight = Eigen::Vector3d(0.5, 0.35, 0.8).normalized();
    return 0.3 + 0.35 * (1 + normalInRoom.dot(kLight));
}

} // namespace

void Ball::validate() const {
    if (!centreM.allFinite() || !std::isfinite(radiusM) || radiusM <= 0) {
        throw Error(ErrorKind::InvalidInput,
                    "A ball has a place in metres and a radius above zero; give \"x y z radius\".");
    }
}

Ball parseBall(std::string_view text) {
    std::istringstream words{std::string(text)};
    std::vector<double> numbers;
    for (std::string word; words >> word;) {
        numbers.push_back(parseNumber(word).value_or(std::numeric_limits<double>::quiet_NaN()));
    }
    numbers.resize(numbers.size() == 4 ? 4 : 0);
    Ball ball;
    ball.radiusM = numbers.empty() ? 0 : numbers[3];
    ball.centreM =
        numbers.empty() ? Eigen::Vector3d(0, 0, 0) : Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
    ball.validate();
    return ball;
}

namespace {

/// Calls paint(normal in the room, pixel) for each pixel that shows the ball. pixel: red, green, blue, alpha.
template <class Paint>
render::Overlay paintedBall(const Ball& ball, const CameraModel& camera, const Rigid3& roomFromCamera,
                            Paint&& paint) {
    ball.validate();
    render::Overlay overlay = emptyOverlay(camera);
    const Eigen::Vector3d centre = roomFromCamera.inverse() * ball.centreM;
    const double outside = centre.squaredNorm() - ball.radiusM * ball.radiusM;
    if (outside <= 0) {
        return overlay;
    }
    const PixelBox box = boxAround(centre, ball.radiusM, camera);
    for (int y = box.top; y < box.bottom; ++y) {
        for (int x = box.left; x < box.right; ++x) {
            const auto ray = camera.ray(Eigen::Vector2d(x, y));
            const double along = ray ? ray->dot(centre) : 0;
            const double root = along * along - outside;
            if (along <= 0 || root <= 0 || ray->z() <= 0) {
                continue;
            }
            const Eigen::Vector3d hit = (along - std::sqrt(root)) * *ray;
            *overlay.depth.at(x, y) = static_cast<float>(hit.z());
            paint(roomFromCamera.rotation * ((hit - centre) / ball.radiusM), overlay.picture.at(x, y));
        }
    }
    return overlay;
}

/// The points of the room that a row of pixels shows; not a number where there is none.
std::vector<Eigen::Vector3d> rowOfPoints(const DepthImage& depth, int y, const CameraModel& camera,
                                         const Rigid3& roomFromCamera) {
    std::vector<Eigen::Vector3d> points;
    points.reserve(static_cast<std::size_t>(depth.width()));
    for (int x = 0; x < depth.width(); ++x) {
        const auto ray = camera.ray(Eigen::Vector2d(x, y));
        const float z = *depth.at(x, y);
        const bool isThere = ray && ray->z() > 0 && z > 0 && std::isfinite(z);
        points.push_back(isThere ? Eigen::Vector3d(roomFromCamera * (*ray * (z / ray->z())))
                                 : Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
    }
    return points;
}

/// The normal towards the camera of a surface through three points; zero where they are no surface.
Eigen::Vector3d normalOf(const Eigen::Vector3d& point, const Eigen::Vector3d& right,
                         const Eigen::Vector3d& below, const Eigen::Vector3d& eye) {
    constexpr double kJump = 0.1; // of the distance: another surface
    const Eigen::Vector3d across = (right - point).cross(below - point);
    const double most = kJump * (point - eye).norm();
    if (!((right - point).norm() < most && (below - point).norm() < most && across.norm() > 0)) {
        return Eigen::Vector3d::Zero();
    }
    return across.normalized() * (across.dot(eye - point) < 0 ? -1 : 1);
}

bool isInTheWay(const Ball& ball, const Eigen::Vector3d& point, const Eigen::Vector3d& towards) {
    const Eigen::Vector3d to = ball.centreM - point;
    const double along = to.dot(towards);
    return along > 0 && (to - along * towards).squaredNorm() < ball.radiusM * ball.radiusM;
}

Image<float, 1> shadowOf(const Ball& ball, const CameraModel& camera, const Rigid3& roomFromCamera,
                         const std::vector<render::DirectionalLight>& lights, const DepthImage& roomDepth) {
    constexpr double kLeastShare = 0.002; // of a surface's light that a ball may hide
    constexpr int kApart = 2;             // pixels between the points of a normal: depths are rough
    std::vector<std::vector<Eigen::Vector3d>> points;
    points.reserve(static_cast<std::size_t>(roomDepth.height()));
    for (int y = 0; y < roomDepth.height(); ++y) {
        points.push_back(rowOfPoints(roomDepth, y, camera, roomFromCamera));
    }
    Image<float, 1> shadow(roomDepth.width(), roomDepth.height());
    const double reachM = ball.radiusM / std::sqrt(kLeastShare);
    parallelFor(shadow.height(), 1, 0, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            std::fill(shadow.row(y).begin(), shadow.row(y).end(), 1.0F);
            const int below = y + kApart < shadow.height() ? y + kApart : y - kApart;
            for (int x = 0; x < shadow.width() && below >= 0; ++x) {
                const Eigen::Vector3d& point =
                    points[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
                const int right = x + kApart < shadow.width() ? x + kApart : x - kApart;
                if (!((point - ball.centreM).norm() < reachM) || right < 0) {
                    continue;
                }
                const Eigen::Vector3d normal =
                    normalOf(point, points[static_cast<std::size_t>(y)][static_cast<std::size_t>(right)],
                             points[static_cast<std::size_t>(below)][static_cast<std::size_t>(x)],
                             roomFromCamera.translation);
                *shadow.at(x, y) = render::lightLeft(lights, normal, [&](const Eigen::Vector3d& towards) {
                    return isInTheWay(ball, point, towards);
                });
            }
        }
    });
    return shadow;
}

} // namespace

render::Overlay ballOverlay(const Ball& ball, const CameraModel& camera, const Rigid3& roomFromCamera) {
    return paintedBall(ball, camera, roomFromCamera, [&](const Eigen::Vector3d& normal, std::uint8_t* pixel) {
        shade(ball.colour, brightness(normal), pixel);
    });
}

namespace {

constexpr int kLights = 512;

render::LightProbe probeAt(const render::Renderer& renderer, const Ball& ball,
                           const render::ViewOptions& views) {
    render::ProbeOptions options;
    options.scene = views.scene;
    options.threads = views.threads;
    return render::lightProbe(renderer, ball.centreM, options);
}

} // namespace

BallLight::BallLight(const render::Renderer& renderer, const Ball& ball, const render::ViewOptions& views)
    : BallLight(probeAt(renderer, ball, views)) {
}

BallLight::BallLight(const render::LightProbe& probe)
    : harmonics(render::lightHarmonics(probe.radiance)),
      lights(render::directionalLights(probe.radiance, kLights)) {
}

render::Overlay litBallOverlay(const Ball& ball, const CameraModel& camera, const Rigid3& roomFromCamera,
                               const BallLight& light, const DepthImage& roomDepth) {
    if (!roomDepth.empty() &&
        (roomDepth.width() != camera.width() || roomDepth.height() != camera.height())) {
        throw Error(ErrorKind::InvalidInput,
                    text("The room's depth has ", roomDepth.width(), " x ", roomDepth.height(),
                         " pixels, and the camera ", camera.width(), " x ", camera.height(), "."));
    }
    const auto paint = [&](const Eigen::Vector3d& normal, std::uint8_t* pixel) {
        const Eigen::Vector3d falls = light.harmonics.irradiance(normal) / std::numbers::pi;
        for (std::size_t c = 0; c < 3; ++c) {
            const double albedo = render::linearLight(ball.colour[c] / 255.0);
            const double shown = albedo * falls[static_cast<Eigen::Index>(c)];
            pixel[c] = static_cast<std::uint8_t>(
                std::lround(255 * render::storedValue(std::clamp(shown, 0.0, 1.0))));
        }
        pixel[3] = 255;
    };
    render::Overlay overlay = paintedBall(ball, camera, roomFromCamera, paint);
    if (!roomDepth.empty()) {
        overlay.shadow = shadowOf(ball, camera, roomFromCamera, light.lights, roomDepth);
    }
    return overlay;
}

namespace {

/// How much of each pixel the object covers.
MaskImage coverOf(const render::Overlay& overlay) {
    MaskImage mask(overlay.picture.width(), overlay.picture.height());
    for (std::size_t i = 0; i < mask.values().size(); ++i) {
        mask.values()[i] = overlay.picture.values()[4 * i + 3];
    }
    return mask;
}

} // namespace

MaskImage ballMask(const Ball& ball, const CameraModel& camera, const Rigid3& roomFromCamera) {
    return coverOf(ballOverlay(ball, camera, roomFromCamera));
}

MaskImage meshMask(const PlacedMesh& object, const CameraModel& camera, const Rigid3& roomFromCamera) {
    return coverOf(meshOverlay(object, camera, roomFromCamera));
}

Eigen::Vector3d PlacedMesh::boxSizeM() const {
    return sizeM * mesh->sides().cast<double>();
}

Rigid3 PlacedMesh::roomFromBox() const {
    return {yawRotation(yaw), footM + Eigen::Vector3d(0, 0, 0.5 * boxSizeM().z())};
}

void PlacedMesh::validate() const {
    if (mesh == nullptr || !footM.allFinite() || !std::isfinite(yaw.value()) || !std::isfinite(sizeM) ||
        sizeM <= 0) {
        throw Error(ErrorKind::InvalidInput,
                    "An object has a mesh, a place in metres, a heading, and a size above zero.");
    }
}

render::Overlay meshOverlay(const PlacedMesh& object, const CameraModel& camera,
                            const Rigid3& roomFromCamera) {
    object.validate();
    render::Overlay overlay = emptyOverlay(camera);
    const Eigen::Matrix3d roomFromObject =
        Eigen::AngleAxisd(object.yaw.value(), Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const Eigen::Matrix3d objectFromRoom = roomFromObject.transpose() / object.sizeM;
    const Eigen::Vector3d eye = objectFromRoom * (roomFromCamera.translation - object.footM);
    if (object.mesh->contains(eye)) {
        return overlay;
    }
    const Eigen::Matrix3d objectFromCamera = objectFromRoom * roomFromCamera.rotation.toRotationMatrix();
    const Eigen::Vector3d sidesM = object.sizeM * object.mesh->sides().cast<double>();
    const Eigen::Vector3d middle =
        roomFromCamera.inverse() * (object.footM + Eigen::Vector3d(0, 0, 0.5 * sidesM.z()));
    const PixelBox box = boxAround(middle, 0.5 * sidesM.norm(), camera);
    constexpr int kRows = 16; // a piece of the work
    parallelFor(std::max(0, box.bottom - box.top), kRows, 0, [&](int begin, int end) {
        for (int y = box.top + begin; y < box.top + end; ++y) {
            for (int x = box.left; x < box.right; ++x) {
                const auto ray = camera.ray(Eigen::Vector2d(x, y));
                ObjectMesh::Hit hit;
                if (ray && ray->z() > 0 && object.mesh->meets(eye, objectFromCamera * *ray, hit)) {
                    *overlay.depth.at(x, y) = static_cast<float>(hit.along * ray->z());
                    shade(object.colour, faceBrightness(roomFromObject * hit.normal.cast<double>()),
                          overlay.picture.at(x, y));
                }
            }
        }
    });
    return overlay;
}

} // namespace spherewalk::jobs
