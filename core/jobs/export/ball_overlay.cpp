// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/ball_overlay.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

namespace spherewalk::jobs {

namespace {

/// Pixels that may show the ball.
struct Box {
    int left = 0;
    int top = 0;
    int right = 0; ///< exclusive
    int bottom = 0;
};

/// Around the corners of a cube about the ball; all of the picture if one of them has no pixel.
Box boxAround(const Eigen::Vector3d& pInCamera, double radius, const CameraModel& camera) {
    const Box whole{0, 0, camera.width(), camera.height()};
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

void shade(const Ball& ball, const Eigen::Vector3d& normalInRoom, std::uint8_t* pixel) {
    static const Eigen::Vector3d kLight = Eigen::Vector3d(0.3, 0.2, 0.93).normalized();
    const double brightness = 0.4 + 0.6 * std::max(0.0, normalInRoom.dot(kLight));
    for (std::size_t c = 0; c < 3; ++c) {
        pixel[c] = static_cast<std::uint8_t>(std::lround(brightness * ball.colour[c]));
    }
    pixel[3] = 255;
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

render::Overlay ballOverlay(const Ball& ball, const CameraModel& camera, const Rigid3& roomFromCamera) {
    ball.validate();
    render::Overlay overlay;
    overlay.camera = camera.intrinsics();
    overlay.picture = RgbaImage(camera.width(), camera.height());
    overlay.depth = DepthImage(camera.width(), camera.height());
    std::fill(overlay.depth.values().begin(), overlay.depth.values().end(),
              std::numeric_limits<float>::infinity());
    const Eigen::Vector3d centre = roomFromCamera.inverse() * ball.centreM;
    const double outside = centre.squaredNorm() - ball.radiusM * ball.radiusM;
    if (outside <= 0) {
        return overlay;
    }
    const Box box = boxAround(centre, ball.radiusM, camera);
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
            shade(ball, roomFromCamera.rotation * ((hit - centre) / ball.radiusM), overlay.picture.at(x, y));
        }
    }
    return overlay;
}

MaskImage ballMask(const Ball& ball, const CameraModel& camera, const Rigid3& roomFromCamera) {
    const RgbaImage picture = ballOverlay(ball, camera, roomFromCamera).picture;
    MaskImage mask(picture.width(), picture.height());
    for (std::size_t i = 0; i < mask.values().size(); ++i) {
        mask.values()[i] = picture.values()[4 * i + 3];
    }
    return mask;
}

} // namespace spherewalk::jobs
