// SPDX-License-Identifier: GPL-3.0-or-later
#include "plane_filters.h"

#include "spherewalk/base/parallel.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/scene/depth_sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>

namespace spherewalk::scene {

namespace {

constexpr double kShare = 0.015; ///< Share of 1 / distance by which two depths may differ.
constexpr double kPixels = 0.75; ///< Parallax in pixels by which two depths may differ.
constexpr int kReach = 48;       ///< In pixels; nothing is taken over from farther away.
constexpr int kAlike = 24; ///< Grey levels in a channel; pixels that differ by more show different things.

/// Whether the neighbour's depth says the same of the point.
bool agrees(const Eigen::Vector3d& pInRoom, const PosedDepth& neighbour, double baselineM) {
    const Image<float, 1>& inverse = neighbour.depth->inverseM;
    const Eigen::Vector3d ray =
        neighbour.roomFromPhoto.rotation.conjugate() * (pInRoom - neighbour.roomFromPhoto.translation);
    const double expected = 1 / std::max(1e-6, ray.norm());
    const Eigen::Vector2d at = pixel({inverse.width(), inverse.height()}, ray);
    const int x = static_cast<int>(std::floor(at.x() + 0.5)) % inverse.width();
    const int y = std::clamp(static_cast<int>(std::floor(at.y() + 0.5)), 0, inverse.height() - 1);
    const double pixelRad = 2 * std::numbers::pi / inverse.width();
    return std::abs(*inverse.at(x, y) - expected) < kShare * expected + kPixels * pixelRad / baselineM;
}

MaskImage agreement(const PosedDepth& photo, std::span<const PosedDepth> neighbours, int threads) {
    const Image<float, 1>& inverse = photo.depth->inverseM;
    const EquirectSize size{inverse.width(), inverse.height()};
    MaskImage sure(size.width, size.height);
    parallelFor(size.height, 8, threads, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            for (int x = 0; x < size.width; ++x) {
                const Eigen::Vector3d point = photo.roomFromPhoto * (direction(size, Eigen::Vector2d(x, y)) /
                                                                     static_cast<double>(*inverse.at(x, y)));
                for (const PosedDepth& neighbour : neighbours) {
                    const double baseline =
                        (neighbour.roomFromPhoto.translation - photo.roomFromPhoto.translation).norm();
                    if (agrees(point, neighbour, std::max(baseline, 1e-3))) {
                        *sure.at(x, y) = 255;
                        break;
                    }
                }
            }
        }
    });
    return sure;
}

/// The inverse distance that an unsure pixel takes over from sure ones in eight directions.
class Filling {
  public:
    Filling(const PhotoDepth& depth, const RgbImage& picture) : m_depth(depth), m_picture(picture) {}

    float at(int x, int y) const {
        std::optional<float> alike;
        std::optional<float> any;
        for (int way = 0; way < 9; ++way) {
            const int dx = way % 3 - 1;
            const int dy = way / 3 - 1;
            if (dx == 0 && dy == 0) {
                continue;
            }
            const auto found = firstSure(x, y, dx, dy);
            if (!found) {
                continue;
            }
            const float value = *m_depth.inverseM.at((*found)[0], (*found)[1]);
            any = std::min(any.value_or(value), value);
            if (lookAlike({x, y}, *found)) {
                alike = std::min(alike.value_or(value), value);
            }
        }
        return alike ? *alike : any.value_or(*m_depth.inverseM.at(x, y));
    }

  private:
    using Place = std::array<int, 2>;

    std::optional<Place> firstSure(int x, int y, int dx, int dy) const {
        const int width = m_depth.sure.width();
        for (int i = 1; i <= kReach; ++i) {
            const int column = (x + i * dx + width) % width;
            const int row = y + i * dy;
            if (row < 0 || row >= m_depth.sure.height()) {
                return std::nullopt;
            }
            if (*m_depth.sure.at(column, row) != 0) {
                return Place{column, row};
            }
        }
        return std::nullopt;
    }

    const std::uint8_t* colour(const Place& place) const {
        const double scale = static_cast<double>(m_picture.width()) / m_depth.sure.width();
        return m_picture.at(static_cast<int>((place[0] + 0.5) * scale),
                            static_cast<int>((place[1] + 0.5) * scale));
    }

    bool lookAlike(const Place& a, const Place& b) const {
        int most = 0;
        for (int c = 0; c < 3; ++c) {
            most = std::max(most, std::abs(colour(a)[c] - colour(b)[c]));
        }
        return most < kAlike;
    }

    const PhotoDepth& m_depth;
    const RgbImage& m_picture;
};

} // namespace

PhotoDepth agreeingDepth(const PosedDepth& photo, const RgbImage& picture,
                         std::span<const PosedDepth> neighbours, int threads) {
    const PhotoDepth checked{photo.depth->inverseM, agreement(photo, neighbours, threads)};
    PhotoDepth result = checked;
    const Filling filling(checked, picture);
    parallelFor(checked.sure.height(), 8, threads, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            for (int x = 0; x < checked.sure.width(); ++x) {
                if (*checked.sure.at(x, y) == 0) {
                    *result.inverseM.at(x, y) = filling.at(x, y);
                }
            }
        }
    });
    result.inverseM = smoothedSurfaces(result.inverseM, threads);
    return result;
}

} // namespace spherewalk::scene
