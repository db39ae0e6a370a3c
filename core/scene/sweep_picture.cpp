// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep_cost.h"

#include "spherewalk/base/parallel.h"
#include "spherewalk/photo/picture_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace spherewalk::scene {

PictureSizes::PictureSizes(RgbImage picture, int mostWidth) {
    constexpr int kLeastWidth = 64;
    const bool isTooWide = mostWidth > 0 && picture.width() > mostWidth;
    m_pictures.push_back(
        isTooWide ? photo::resized(picture, mostWidth, mostWidth * picture.height() / picture.width())
                  : std::move(picture));
    while (m_pictures.back().width() >= 2 * kLeastWidth && m_pictures.back().height() >= 2) {
        const RgbImage& last = m_pictures.back();
        m_pictures.push_back(photo::resized(last, last.width() / 2, last.height() / 2));
    }
}

const RgbImage& PictureSizes::atLeast(int width) const {
    const auto isWide = [&](const RgbImage& picture) { return picture.width() >= width; };
    const auto found = std::find_if(m_pictures.rbegin(), m_pictures.rend(), isWide);
    return found != m_pictures.rend() ? *found : m_pictures.front();
}

void sampleColour(const RgbImage& photo, float u, float v, float* rgb) {
    const int left = std::min(static_cast<int>(u), photo.width() - 1);
    const int right = left + 1 < photo.width() ? left + 1 : 0;
    const int above = std::min(static_cast<int>(v), photo.height() - 1);
    const int below = std::min(above + 1, photo.height() - 1);
    const float across = u - static_cast<float>(left);
    const float down = v - static_cast<float>(above);
    const std::array<const std::uint8_t*, 4> p{photo.at(left, above), photo.at(right, above),
                                               photo.at(left, below), photo.at(right, below)};
    for (int c = 0; c < 3; ++c) {
        const auto upper = static_cast<float>(p[0][c]) + across * static_cast<float>(p[1][c] - p[0][c]);
        const auto lower = static_cast<float>(p[2][c]) + across * static_cast<float>(p[3][c] - p[2][c]);
        rgb[c] = upper + down * (lower - upper);
    }
}

namespace {

/// Finds where a photo shows a row of a frame's directions.
class TurnedRow {
  public:
    TurnedRow(Eigen::Matrix3f photoFromFrame, int width)
        : m_turn(std::move(photoFromFrame)),
          m_angles(width),
          m_u(static_cast<std::size_t>(width)),
          m_v(m_u) {}

    /// photoWidth: in pixels.
    SPHEREWALK_VECTOR_CLONES
    void place(int line, int photoWidth) {
        const std::size_t width = m_u.size();
        const float level = m_angles.cosElevation[static_cast<std::size_t>(line)];
        const Eigen::Vector3f x = level * m_turn.col(0);
        const Eigen::Vector3f y = level * m_turn.col(1);
        const Eigen::Vector3f up = m_angles.sinElevation[static_cast<std::size_t>(line)] * m_turn.col(2);
        for (std::size_t i = 0; i < width; ++i) {
            const float c = m_angles.cosAzimuth[i];
            const float s = m_angles.sinAzimuth[i];
            const FastPixel at = fastPixel(x[0] * c + y[0] * s + up[0], x[1] * c + y[1] * s + up[1],
                                           x[2] * c + y[2] * s + up[2], static_cast<float>(photoWidth));
            m_u[i] = at.u;
            m_v[i] = at.v;
        }
    }

    float u(int x) const { return m_u[static_cast<std::size_t>(x)]; }

    float v(int x) const { return m_v[static_cast<std::size_t>(x)]; }

  private:
    Eigen::Matrix3f m_turn;
    PixelAngles m_angles;
    std::vector<float> m_u;
    std::vector<float> m_v;
};

Image<float, 3> turned(const RgbImage& photo, const Eigen::Matrix3d& photoFromFrame, int width, int threads) {
    Image<float, 3> picture(width, width / 2);
    parallelFor(picture.height(), 32, threads, [&](int begin, int end) {
        TurnedRow row(photoFromFrame.cast<float>(), width);
        for (int y = begin; y < end; ++y) {
            row.place(y, photo.width());
            for (int x = 0; x < width; ++x) {
                sampleColour(photo, row.u(x), row.v(x), picture.at(x, y));
            }
        }
    });
    return picture;
}

void brighten(Image<float, 3>& picture, const Gains& gains) {
    if (gains == Gains{1, 1, 1}) {
        return;
    }
    const std::span<float> values = picture.values();
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = std::min(255.0F, gains[i % 3] * values[i]);
    }
}

float brightnessOf(const float* rgb) {
    return 0.299F * rgb[0] + 0.587F * rgb[1] + 0.114F * rgb[2];
}

} // namespace

std::vector<float> turnedValues(const Image<float, 1>& plane, const Eigen::Matrix3d& planeFromFrame,
                                int threads) {
    const auto pitch = static_cast<std::size_t>(plane.width()) + 1;
    std::vector<float> result(pitch * (static_cast<std::size_t>(plane.height()) + 1));
    parallelFor(plane.height(), 32, threads, [&](int begin, int end) {
        TurnedRow row(planeFromFrame.cast<float>(), plane.width());
        for (int y = begin; y < end; ++y) {
            row.place(y, plane.width());
            float* out = result.data() + pitch * static_cast<std::size_t>(y);
            for (int x = 0; x < plane.width(); ++x) {
                const int column = nearestInt(row.u(x)) % plane.width();
                const int line = std::min(nearestInt(row.v(x)), plane.height() - 1);
                out[x] = *plane.at(column, line);
            }
            out[plane.width()] = out[0];
        }
    });
    std::copy_n(result.end() - 2 * static_cast<std::ptrdiff_t>(pitch), pitch,
                result.end() - static_cast<std::ptrdiff_t>(pitch));
    return result;
}

SweepPicture::SweepPicture(const RgbImage& photo, const Eigen::Matrix3d& photoFromFrame, int width,
                           int threads, const Gains& gains)
    : m_width(width),
      m_values(4 * static_cast<std::size_t>(width + 1) * static_cast<std::size_t>(width / 2 + 1)) {
    // At twice the width a bilinear sample in the middle of a wanted pixel is about the mean over it.
    Image<float, 3> picture = photo.width() >= 4 * width ? turned(photo::resized(photo, 2 * width, width),
                                                                  photoFromFrame, width, threads)
                                                         : turned(photo, photoFromFrame, width, threads);
    brighten(picture, gains);
    parallelFor(height(), 32, threads, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            differentiate(picture, y);
        }
    });
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
