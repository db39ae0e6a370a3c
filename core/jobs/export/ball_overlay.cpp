// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/overlay_parts.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/object_overlay.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

namespace spherewalk::jobs {

namespace {

/// A matt surface, lit from above.
double brightness(const Eigen::Vector3d& normalInRoom) {
    static const Eigen::Vector3d kLight = Eigen::Vector3d(0.3, 0.2, 0.93).normalized();
    return 0.4 + 0.6 * std::max(0.0, normalInRoom.dot(kLight));
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
            shade(ball.colour, brightness(roomFromCamera.rotation * ((hit - centre) / ball.radiusM)),
                  overlay.picture.at(x, y));
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
