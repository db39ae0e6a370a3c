// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep_picture.h"

#include "spherewalk/base/parallel.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/render/bilinear.h"

#include <algorithm>

namespace spherewalk::scene {

namespace {

Image<float, 3> turned(const RgbImage& photo, const Eigen::Matrix3d& photoFromFrame, int width, int threads) {
    const EquirectSize from{photo.width(), photo.height()};
    const EquirectSize to{width, width / 2};
    Image<float, 3> picture(to.width, to.height);
    parallelFor(to.height, 8, threads, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            for (int x = 0; x < to.width; ++x) {
                const Eigen::Vector3d ray = photoFromFrame * direction(to, Eigen::Vector2d(x, y));
                Eigen::Map<Eigen::Vector3f>(picture.at(x, y)) =
                    render::bilinear(photo, pixel(from, ray)).cast<float>();
            }
        }
    });
    return picture;
}

float brightnessOf(const float* rgb) {
    return 0.299F * rgb[0] + 0.587F * rgb[1] + 0.114F * rgb[2];
}

} // namespace

SweepPicture::SweepPicture(const RgbImage& photo, const Eigen::Matrix3d& photoFromFrame, int width,
                           int threads)
    : m_width(width),
      m_values(4 * static_cast<std::size_t>(width + 1) * static_cast<std::size_t>(width / 2 + 1)) {
    // At twice the width a bilinear sample in the middle of a wanted pixel is about the mean over it.
    const Image<float, 3> picture =
        photo.width() >= 4 * width
            ? turned(photo::resized(photo, 2 * width, width), photoFromFrame, width, threads)
            : turned(photo, photoFromFrame, width, threads);
    for (int y = 0; y < height(); ++y) {
        differentiate(picture, y);
    }
    repeatEdges();
}

void SweepPicture::differentiate(const Image<float, 3>& picture, int y) {
    const int above = std::max(0, y - 1);
    const int below = std::min(height() - 1, y + 1);
    for (int x = 0; x < m_width; ++x) {
        const float* here = picture.at(x, y);
        const float* right = picture.at((x + 1) % m_width, y);
        const float* left = picture.at((x + m_width - 1) % m_width, y);
        float* out = at(x, y);
        out[0] = brightnessOf(here);
        out[1] = 0.5F * (brightnessOf(right) - brightnessOf(left));
        out[2] = 0.5F * (brightnessOf(picture.at(x, below)) - brightnessOf(picture.at(x, above)));
        out[3] = 0.5F * (here[0] - here[2]);
    }
}

void SweepPicture::repeatEdges() {
    for (int y = 0; y < height(); ++y) {
        std::copy_n(at(0, y), 4, at(m_width, y));
    }
    std::copy_n(at(0, height() - 1), stride(), at(0, height()));
}

} // namespace spherewalk::scene
