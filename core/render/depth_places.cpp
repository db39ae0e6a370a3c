// SPDX-License-Identifier: Apache-2.0
#include "depth_places.h"

#include "depth_cells.h"
#include "depth_fit.h"
#include "depth_locate.h"
#include "depth_rays.h"
#include "lattice.h"
#include "photo_plane.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace spherewalk::render {

using Eigen::Vector3d;

namespace {

constexpr int kCell = DepthPlaces::kCell;

simd::PhotoTarget targetOf(const Rigid3& roomFromCamera, const PlacedPhoto& photo) {
    const Eigen::Matrix3d m =
        (photo.roomFromPhoto.rotation.conjugate() * roomFromCamera.rotation).toRotationMatrix();
    const Vector3d offset = photo.roomFromPhoto.rotation.conjugate() *
                            (roomFromCamera.translation - photo.roomFromPhoto.translation);
    simd::PhotoTarget target{};
    for (int i = 0; i < 9; ++i) {
        target.m[static_cast<std::size_t>(i)] = static_cast<float>(m(i / 3, i % 3));
    }
    for (int i = 0; i < 3; ++i) {
        target.offset[static_cast<std::size_t>(i)] = static_cast<float>(offset[i]);
    }
    target.perRadian = static_cast<float>(photo.size.width / (2 * std::numbers::pi));
    target.lastU = static_cast<float>(photo.size.width + PlaneLayout::kGuard - 0.5);
    target.lastV = static_cast<float>(photo.size.height + PlaneLayout::kGuard - 0.5);
    return target;
}

/// Places a row of cells after the other.
class RowPlacer {
  public:
    RowPlacer(const PixelRays& rays, std::span<const simd::PhotoTarget> targets, const OpenCells& open,
              float usualInverse, DepthPlaces& places)
        : m_rays(rays, places.source.width()),
          m_targets(targets),
          m_open(open),
          m_usualInverse(usualInverse),
          m_places(places),
          m_least(static_cast<std::size_t>(places.columns() + kCell), 1),
          m_greatest(m_least),
          m_shows(static_cast<std::size_t>(places.columns())),
          m_fits(targets.size(), simd::CellFits(places.columns())) {}

    void place(int row) {
        m_rays.cast(row);
        if (!m_rays.isPinhole()) {
            markBlind(row);
        }
        for (int y = row * kCell; y < (row + 1) * kCell; ++y) {
            fillHoles(y);
        }
        if (m_rays.isPinhole()) {
            fitCells(row);
        }
        for (int column = 0; column < m_places.columns(); ++column) {
            placeCell(column, row);
        }
    }

    /// Of a cell of the row that was placed last; nothing where it could not be fitted.
    std::optional<std::array<std::int32_t, 4>> slopes(int column, int row, std::size_t photo) const {
        if (!isFitted(column, photo)) {
            return std::nullopt;
        }
        constexpr int kMiddle = simd::NodeRays::kNodes[1];
        const float inverse = *m_places.inverse.at(column * kCell + kMiddle, row * kCell + kMiddle);
        return simd::slopes(m_fits[photo], column, inverse);
    }

  private:
    bool isFitted(int column, std::size_t photo) const {
        return m_rays.isPinhole() &&
               m_fits[photo].errorPx[static_cast<std::size_t>(column)] <= simd::CellFits::kTolerancePx;
    }

    void fitCells(int row) {
        const int columns = m_places.columns();
        for (int column = 0; column < columns; ++column) {
            const auto [least, greatest] =
                simd::range(m_places.inverse.at(column * kCell, row * kCell), m_places.inverse.width());
            m_least[static_cast<std::size_t>(column)] = least;
            m_greatest[static_cast<std::size_t>(column)] = greatest;
        }
        for (std::size_t photo = 0; photo < m_targets.size(); ++photo) {
            for (int column = 0; column < columns; ++column) {
                m_shows[static_cast<std::size_t>(column)] =
                    m_places.sources[m_places.index(column, row)] >> photo & 1U;
            }
            simd::fit(m_targets[photo], m_rays.nodes(), m_least.data(), m_greatest.data(), m_shows,
                      m_fits[photo]);
        }
    }

    void markBlind(int row) {
        for (int y = 0; y < kCell; ++y) {
            for (int x = 0; x < m_places.source.width(); ++x) {
                if (m_rays.isBlind(x, y)) {
                    *m_places.source.at(x, row * kCell + y) = DepthPlaces::kUnseen;
                    *m_places.inverse.at(x, row * kCell + y) = m_usualInverse;
                    m_places.sources[m_places.index(x / kCell, row)] |= DepthPlaces::kBlind;
                }
            }
        }
    }

    /// Of a row of a cell.
    static bool hasHole(const float* inverse) {
        int holes = 0;
        for (int x = 0; x < kCell; ++x) {
            holes += inverse[x] > 0 ? 0 : 1;
        }
        return holes > 0;
    }

    void fillHoles(int y) {
        float* inverse = m_places.inverse.at(0, y);
        const int width = m_places.inverse.width();
        for (int column = 0; column < m_places.columns(); ++column) {
            if (!m_open.isOpen(column, y / kCell) || !hasHole(inverse + column * kCell)) {
                continue;
            }
            for (int begin = column * kCell; begin < (column + 1) * kCell; ++begin) {
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
    }

    void placeCell(int column, int row) {
        const std::size_t cell = m_places.index(column, row);
        const std::uint32_t sources = m_places.sources[cell];
        std::int32_t* u = m_places.u.data() + cell * DepthPlaces::kCellPixels;
        std::int32_t* v = m_places.v.data() + cell * DepthPlaces::kCellPixels;
        bool isFirst = true;
        for (std::size_t photo = 0; photo < m_targets.size(); ++photo) {
            if ((sources >> photo & 1U) == 0) {
                continue;
            }
            locate(column, row, photo, isFirst ? u : m_u.data(), isFirst ? v : m_v.data());
            if (!isFirst) {
                simd::takeOwn(m_u.data(), m_v.data(), m_places.source.at(column * kCell, row * kCell),
                              m_places.source.width(), static_cast<std::uint8_t>(photo), u, v);
            }
            isFirst = false;
        }
    }

    void locate(int column, int row, std::size_t photo, std::int32_t* u, std::int32_t* v) const {
        const float* inverse = m_places.inverse.at(column * kCell, row * kCell);
        if (isFitted(column, photo)) {
            simd::locate(m_fits[photo], column, inverse, m_places.inverse.width(), u, v);
        } else {
            simd::locate(m_targets[photo], m_rays.cell(column * kCell), inverse, m_places.inverse.width(), u,
                         v);
        }
    }

    RowRays m_rays;
    std::span<const simd::PhotoTarget> m_targets;
    const OpenCells& m_open;
    float m_usualInverse;
    DepthPlaces& m_places;
    std::vector<float> m_least; ///< inverse depth of each cell
    std::vector<float> m_greatest;
    std::vector<std::uint8_t> m_shows;  ///< whether a cell shows a photo
    std::vector<simd::CellFits> m_fits; ///< of each photo
    std::array<std::int32_t, DepthPlaces::kCellPixels> m_u;
    std::array<std::int32_t, DepthPlaces::kCellPixels> m_v;
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

void DepthPlaces::reset(int width, int height) {
    fit(inverse, width, height);
    if (source.width() != inverse.width() || source.height() != inverse.height()) {
        source = MaskImage(inverse.width(), inverse.height());
        u.resize(source.values().size());
        v.resize(source.values().size());
        sources.resize(static_cast<std::size_t>(columns() * rows()));
    }
    std::fill(source.values().begin(), source.values().end(), std::uint8_t{0});
    std::fill(sources.begin(), sources.end(), 1U);
}

void DepthPlaces::take(const InverseBuffer& seen, std::uint8_t photo, const OpenCells& open, WorkerPool& pool,
                       int threads) {
    pool.run(rows(), threads, [&](int row, int) {
        for (int column = 0; column < columns(); ++column) {
            const int x = column * kCell;
            const int y = row * kCell;
            if (open.isOpen(column, row) &&
                simd::takeUnseen(seen.at(x, y), inverse.width(), photo, inverse.at(x, y), source.at(x, y))) {
                sources[index(column, row)] |= 1U << photo;
            }
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

void placePixels(const PixelRays& rays, const Rigid3& roomFromCamera, std::span<const PlacedPhoto> photos,
                 const OpenCells& open, double usualDistanceM, bool wantsSlopes, WorkerPool& pool,
                 int threads, const std::function<void(int row)>& placed, DepthPlaces& places) {
    std::vector<simd::PhotoTarget> targets;
    for (const PlacedPhoto& photo : photos) {
        targets.push_back(targetOf(roomFromCamera, photo));
    }
    places.slopes.resize(places.sources.size() * photos.size());
    const auto findSlopes = [&](const RowPlacer& placer, int column, int row) {
        const std::size_t cell = places.index(column, row);
        for (std::size_t i = 0; i < photos.size(); ++i) {
            if ((places.sources[cell] >> i & 1U) != 0) {
                const int x = column * kCell + std::min(kCell, rays.camera().width() - column * kCell) / 2;
                const int y = row * kCell + std::min(kCell, rays.camera().height() - row * kCell) / 2;
                const auto fitted = placer.slopes(column, row, i);
                places.slopes[cell * photos.size() + i] =
                    fitted ? *fitted
                           : placeSlopes(rays, roomFromCamera, photos[i], x, y, *places.inverse.at(x, y));
            }
        }
    };
    constexpr int kBand = 3; ///< rows of cells that one worker does in turn
    pool.run((places.rows() + kBand - 1) / kBand, threads, [&](int band, int) {
        RowPlacer placer(rays, targets, open, static_cast<float>(1 / usualDistanceM), places);
        for (int row = band * kBand; row < std::min(places.rows(), (band + 1) * kBand); ++row) {
            placer.place(row);
            for (int column = 0; column < places.columns() && wantsSlopes; ++column) {
                findSlopes(placer, column, row);
            }
            placed(row);
        }
    });
}

} // namespace spherewalk::render
