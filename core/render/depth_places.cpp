// SPDX-License-Identifier: Apache-2.0
#include "depth_places.h"

#include "lattice.h"
#include "photo_plane.h"

#include "spherewalk/geometry/fast_angle.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace spherewalk::render {

using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kHalfPi = 0.5F * kPi;

/// A photo as the kernel needs it: the direction in it is m * ray + inverse * offset.
struct Target {
    std::array<float, 9> m;
    std::array<float, 3> offset;
    float perRadian;
    float width;
    float lastLine;
};

Target targetOf(const Rigid3& roomFromCamera, const PlacedPhoto& photo) {
    const Eigen::Matrix3d m =
        (photo.roomFromPhoto.rotation.conjugate() * roomFromCamera.rotation).toRotationMatrix();
    const Vector3d offset = photo.roomFromPhoto.rotation.conjugate() *
                            (roomFromCamera.translation - photo.roomFromPhoto.translation);
    Target target{};
    for (int i = 0; i < 9; ++i) {
        target.m[static_cast<std::size_t>(i)] = static_cast<float>(m(i / 3, i % 3));
    }
    for (int i = 0; i < 3; ++i) {
        target.offset[static_cast<std::size_t>(i)] = static_cast<float>(offset[i]);
    }
    target.perRadian = static_cast<float>(photo.size.width / (2 * std::numbers::pi));
    target.width = static_cast<float>(photo.size.width);
    target.lastLine = static_cast<float>(photo.size.height) - 0.5F;
    return target;
}

/// Rays of a row, each component contiguous.
struct RowOfRays {
    std::vector<float> x;
    std::vector<float> y;
    std::vector<float> z;
};

void locate(const Target& target, const RowOfRays& rays, const float* inverse, int begin, int end,
            std::int32_t* __restrict u, std::int32_t* __restrict v) {
    const std::array<float, 9> m = target.m;
    const std::array<float, 3> o = target.offset;
    constexpr float kOne = 1 << kFractionBits;
    constexpr auto kAddU = static_cast<float>(PlaneLayout::kGuard + kRoundingU - 0.5);
    constexpr auto kAddV = static_cast<float>(PlaneLayout::kGuard - 0.5);
    const float lastU = target.width + PlaneLayout::kGuard - 0.5F;
    const float lastV = target.lastLine + PlaneLayout::kGuard;
    for (int i = begin; i < end; ++i) {
        const float x = m[0] * rays.x[i] + m[1] * rays.y[i] + m[2] * rays.z[i] + inverse[i] * o[0];
        const float y = m[3] * rays.x[i] + m[4] * rays.y[i] + m[5] * rays.z[i] + inverse[i] * o[1];
        const float z = m[6] * rays.x[i] + m[7] * rays.y[i] + m[8] * rays.z[i] + inverse[i] * o[2];
        float column = (kPi - fastAngle(y, x)) * target.perRadian + kAddU;
        column = column > lastU ? lastU : column;
        float line = (kHalfPi - fastAngle(z, std::sqrt(x * x + y * y))) * target.perRadian + kAddV;
        line = line > lastV ? lastV : line;
        u[i] = static_cast<std::int32_t>(column * kOne);
        v[i] = static_cast<std::int32_t>(line * kOne);
    }
}

/// One row of a view.
class RowPlacer {
  public:
    RowPlacer(const PixelRays& rays, std::span<const PlacedPhoto> photos, std::span<const Target> targets,
              float usualInverse, DepthPlaces& places)
        : m_rays(rays), m_photos(photos), m_targets(targets), m_usualInverse(usualInverse), m_places(places) {
        const auto width = static_cast<std::size_t>(places.source.width());
        for (std::vector<float>* values : {&m_row.x, &m_row.y, &m_row.z}) {
            values->resize(width);
        }
    }

    void place(int y) {
        castRays(y);
        chooseSources(y);
        fillHoles(y);
        const std::uint8_t* source = m_places.source.at(0, y);
        const int width = m_places.source.width();
        for (int begin = 0; begin < width;) {
            int end = begin + 1;
            while (end < width && source[end] == source[begin]) {
                ++end;
            }
            const std::size_t photo = source[begin] == DepthPlaces::kUnseen ? 0 : source[begin];
            locate(m_targets[photo], m_row, m_places.inverse.at(0, y), begin, end, m_places.u.at(0, y),
                   m_places.v.at(0, y));
            begin = end;
        }
    }

  private:
    void castRays(int y) {
        const CameraIntrinsics& k = m_rays.camera().intrinsics();
        const bool isPinhole = k.lens == LensModel::Pinhole;
        const double across = 1 / k.fx;
        const double line = (y - k.cy) / k.fy;
        for (std::size_t x = 0; x < m_row.x.size(); ++x) {
            const Vector3d ray = isPinhole ? Vector3d((static_cast<double>(x) - k.cx) * across, line, 1)
                                           : m_rays.ray(static_cast<int>(x), y);
            m_row.x[x] = static_cast<float>(ray.x());
            m_row.y[x] = static_cast<float>(ray.y());
            m_row.z[x] = static_cast<float>(ray.z());
        }
    }

    void chooseSources(int y) {
        for (int x = 0; x < m_places.source.width(); ++x) {
            const auto i = static_cast<std::size_t>(x);
            std::uint8_t source = 0;
            float inverse = 0;
            for (std::size_t k = 0; k < m_photos.size() && !(inverse > 0); ++k) {
                inverse = *m_photos[k].seen->at(x, y);
                source = inverse > 0 ? static_cast<std::uint8_t>(k) : source;
            }
            const bool isSeen = m_row.x[i] != 0 || m_row.y[i] != 0 || m_row.z[i] != 0;
            *m_places.source.at(x, y) = isSeen ? source : DepthPlaces::kUnseen;
            *m_places.inverse.at(x, y) = isSeen ? inverse : m_usualInverse;
        }
    }

    void fillHoles(int y) {
        float* inverse = m_places.inverse.at(0, y);
        const int width = m_places.inverse.width();
        for (int begin = 0; begin < width; ++begin) {
            if (inverse[begin] > 0) {
                continue;
            }
            int end = begin;
            while (end < width && !(inverse[end] > 0)) {
                ++end;
            }
            const float left = begin > 0 ? inverse[begin - 1] : HUGE_VALF;
            const float right = end < width ? inverse[end] : HUGE_VALF;
            const float farther = std::min(left, right);
            std::fill(inverse + begin, inverse + end, std::isfinite(farther) ? farther : m_usualInverse);
            begin = end;
        }
    }

    const PixelRays& m_rays;
    std::span<const PlacedPhoto> m_photos;
    std::span<const Target> m_targets;
    float m_usualInverse;
    DepthPlaces& m_places;
    RowOfRays m_row;
};

/// Coordinates in double precision; nothing near the poles.
std::optional<Eigen::Vector2d> exactPlace(const PixelRays& rays, const Rigid3& roomFromCamera,
                                          const PlacedPhoto& photo, const Eigen::Vector2d& viewPixel,
                                          double inverse) {
    const auto ray = rays.camera().ray(viewPixel);
    if (!ray) {
        return std::nullopt;
    }
    const bool isPinhole = rays.camera().intrinsics().lens == LensModel::Pinhole;
    const Vector3d step = isPinhole ? Vector3d(*ray / ray->z()) : *ray;
    const Vector3d inPhoto = photo.roomFromPhoto.rotation.conjugate() *
                             (roomFromCamera.rotation * step +
                              inverse * (roomFromCamera.translation - photo.roomFromPhoto.translation));
    if (inPhoto.head<2>().norm() < 0.17 * inPhoto.norm()) {
        return std::nullopt;
    }
    return pixel(photo.size, inPhoto);
}

} // namespace

void DepthPlaces::resize(int width, int height) {
    if (source.width() != width || source.height() != height) {
        source = MaskImage(width, height);
        inverse = Image<float, 1>(width, height);
        u = Image<std::int32_t, 1>(width, height);
        v = u;
    }
}

void placePixels(const PixelRays& rays, const Rigid3& roomFromCamera, std::span<const PlacedPhoto> photos,
                 double usualDistanceM, WorkerPool& pool, int threads, DepthPlaces& places) {
    places.resize(rays.camera().width(), rays.camera().height());
    std::vector<Target> targets;
    for (const PlacedPhoto& photo : photos) {
        targets.push_back(targetOf(roomFromCamera, photo));
    }
    constexpr int kBand = 16;
    const int height = places.source.height();
    pool.run((height + kBand - 1) / kBand, threads, [&](int band, int) {
        RowPlacer placer(rays, photos, targets, static_cast<float>(1 / usualDistanceM), places);
        for (int y = band * kBand; y < std::min(height, (band + 1) * kBand); ++y) {
            placer.place(y);
        }
    });
}

std::array<std::int32_t, 4> placeSlopes(const PixelRays& rays, const Rigid3& roomFromCamera,
                                        const PlacedPhoto& photo, int x, int y, float inverse) {
    std::array<std::int32_t, 4> slopes{};
    const Eigen::Vector2d at(x, y);
    for (const int axis : {0, 1}) {
        const Eigen::Vector2d step = 0.5 * (axis == 0 ? Eigen::Vector2d(1, 0) : Eigen::Vector2d(0, 1));
        const auto before = exactPlace(rays, roomFromCamera, photo, at - step, inverse);
        const auto after = exactPlace(rays, roomFromCamera, photo, at + step, inverse);
        if (before && after) {
            Eigen::Vector2d change = *after - *before;
            change.x() -= photo.size.width * std::round(change.x() / photo.size.width);
            slopes[static_cast<std::size_t>(2 * axis)] =
                static_cast<std::int32_t>(std::lround(change.x() * (1 << kFractionBits)));
            slopes[static_cast<std::size_t>(2 * axis + 1)] =
                static_cast<std::int32_t>(std::lround(change.y() * (1 << kFractionBits)));
        }
    }
    return slopes;
}

} // namespace spherewalk::render
