// SPDX-License-Identifier: Apache-2.0
#include "reference_sampling.h"

#include <cmath>

namespace spherewalk::render {

namespace {

Eigen::Vector3d pixelValue(const RgbImage& photo, int x, int y) {
    if (y < 0 || y >= photo.height()) {
        y = y < 0 ? -1 - y : 2 * photo.height() - 1 - y;
        x += photo.width() / 2;
    }
    x %= photo.width();
    const std::uint8_t* rgb = photo.at(x < 0 ? x + photo.width() : x, y);
    return {static_cast<double>(rgb[0]), static_cast<double>(rgb[1]), static_cast<double>(rgb[2])};
}

Eigen::Vector3d pixelValue(const PlaneView& photo, int x, int y) {
    return Eigen::Vector3d(photo.stored(x, y, 0), photo.stored(x, y, 1), photo.stored(x, y, 2)).array() + 128;
}

template <class Photo>
Eigen::Vector3d blend(const Photo& photo, const Eigen::Vector2d& pixel) {
    const double left = std::floor(pixel.x());
    const double top = std::floor(pixel.y());
    const double a = pixel.x() - left;
    const double b = pixel.y() - top;
    const int x = static_cast<int>(left);
    const int y = static_cast<int>(top);
    return (1 - b) * ((1 - a) * pixelValue(photo, x, y) + a * pixelValue(photo, x + 1, y)) +
           b * ((1 - a) * pixelValue(photo, x, y + 1) + a * pixelValue(photo, x + 1, y + 1));
}

} // namespace

Eigen::Vector3d bilinear(const RgbImage& photo, const Eigen::Vector2d& pixel) {
    return blend(photo, pixel);
}

Eigen::Vector3d bilinear(const PlaneView& photo, const Eigen::Vector2d& pixel) {
    return blend(photo, pixel);
}

} // namespace spherewalk::render
