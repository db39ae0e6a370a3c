// SPDX-License-Identifier: Apache-2.0
#include "surface/coordinates.h"

#include "pixels/fixed_point.h"
#include "pixels/photo_plane.h"
#include "surface/cells.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

namespace spherewalk::render {

using Eigen::Vector3d;

namespace {

simd::PhotoTarget targetOf(const Rigid3& roomFromCamera, const SourcePhoto& photo) {
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
    target.aheadM = static_cast<float>(photo.lenses.aheadM);
    target.perRadian = static_cast<float>(photo.size.width / (2 * std::numbers::pi));
    target.lastU = static_cast<float>(photo.size.width + PlaneLayout::kGuard - 0.5);
    target.lastV = static_cast<float>(photo.size.height + PlaneLayout::kGuard - 0.5);
    return target;
}

/// The rays of a row of cells, in single precision.
class RowRays {
  public:
    /// width: the pixels of whole cells.
    RowRays(const PixelRays& rays, int width);

    /// Goes to a row of cells.
    void cast(int row);

    /// Range: x a multiple of kCell.
    std::array<simd::CellRays, 3> cell(int x) const;

    bool isPinhole() const { return m_isPinhole; }

    /// The pixels of a row that belong to the view, without those that fill up its last cell.
    int viewWidth() const { return m_rays.camera().width(); }

    /// Range: a pinhole.
    simd::NodeRays nodes() const;

    /// Whether the lens sees nothing there. Range: not a pinhole; y in the row of cells.
    bool isBlind(int x, int y) const {
        const auto i = static_cast<std::size_t>(y * m_width + x);
        return m_x[i] == 0 && m_y[i] == 0 && m_z[i] == 0;
    }

  private:
    const PixelRays& m_rays;
    int m_width;
    bool m_isPinhole;
    std::vector<float> m_x;
    std::vector<float> m_y;
    std::vector<float> m_z;
    std::array<std::vector<float>, 3> m_nodes; ///< The x of the cells' nodes.
};

RowRays::RowRays(const PixelRays& rays, int width) : m_rays(rays), m_width(width) {
    const CameraIntrinsics& k = rays.camera().intrinsics();
    m_isPinhole = k.lens == LensModel::Pinhole;
    const int rows = m_isPinhole ? 1 : kCell;
    m_x.resize(static_cast<std::size_t>(width * rows));
    m_y.resize(m_isPinhole ? std::size_t{kCell} * kCell : m_x.size());
    m_z.resize(m_isPinhole ? kCell : m_x.size(), 1);
    for (int x = 0; x < width && m_isPinhole; ++x) {
        m_x[static_cast<std::size_t>(x)] = static_cast<float>((x - k.cx) / k.fx);
    }
    for (std::size_t node = 0; node < m_nodes.size() && m_isPinhole; ++node) {
        for (int x = simd::NodeRays::kNodes[node]; x < width; x += kCell) {
            m_nodes[node].push_back(m_x[static_cast<std::size_t>(x)]);
        }
        m_nodes[node].resize(m_nodes[node].size() + kCell); // SIMD reads beyond the end
    }
}

void RowRays::cast(int row) {
    const CameraIntrinsics& k = m_rays.camera().intrinsics();
    for (int y = 0; y < kCell; ++y) {
        const int line = row * kCell + y;
        if (m_isPinhole) {
            std::fill_n(m_y.begin() + y * kCell, kCell, static_cast<float>((line - k.cy) / k.fy));
            continue;
        }
        for (int x = 0; x < m_width; ++x) {
            const bool isInView = x < k.width && line < k.height;
            const Vector3d ray = isInView ? m_rays.ray(x, line) : Vector3d(0, 0, 1);
            const auto i = static_cast<std::size_t>(y * m_width + x);
            m_x[i] = static_cast<float>(ray.x());
            m_y[i] = static_cast<float>(ray.y());
            m_z[i] = static_cast<float>(ray.z());
        }
    }
}

std::array<simd::CellRays, 3> RowRays::cell(int x) const {
    if (m_isPinhole) {
        return {{{m_x.data() + x, 0}, {m_y.data(), kCell}, {m_z.data(), 0}}};
    }
    return {{{m_x.data() + x, m_width}, {m_y.data() + x, m_width}, {m_z.data() + x, m_width}}};
}

simd::NodeRays RowRays::nodes() const {
    const CameraIntrinsics& k = m_rays.camera().intrinsics();
    simd::NodeRays nodes;
    for (std::size_t i = 0; i < m_nodes.size(); ++i) {
        nodes.x[i] = m_nodes[i].data();
        nodes.y[i] = m_y[static_cast<std::size_t>(simd::NodeRays::kNodes[i] * kCell)];
    }
    nodes.stepX = static_cast<float>(1 / k.fx);
    nodes.stepY = static_cast<float>(1 / k.fy);
    return nodes;
}

/// Finds the coordinates of one row of cells after the other.
class RowLocator {
  public:
    RowLocator(const PixelRays& rays, std::span<const simd::PhotoTarget> targets, const OpenCells& open,
               float usualInverse, SurfaceCoordinates& coordinates)
        : m_rays(rays, coordinates.source.width()),
          m_targets(targets),
          m_open(open),
          m_usualInverse(usualInverse),
          m_coordinates(coordinates),
          m_least(static_cast<std::size_t>(coordinates.columns() + kCell), 1),
          m_greatest(m_least),
          m_shows(static_cast<std::size_t>(coordinates.columns())),
          m_fits(targets.size(), simd::CellFits(coordinates.columns())) {}

    void locateRow(int row) {
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
        for (int column = 0; column < m_coordinates.columns(); ++column) {
            locateCell(column, row);
        }
    }

    /// The slopes of a cell of the row that was located last; nothing where the cell could not be fitted.
    std::optional<std::array<std::int32_t, 4>> slopes(int column, int row, std::size_t photo) const {
        if (!isFitted(column, photo)) {
            return std::nullopt;
        }
        constexpr int kMiddle = simd::NodeRays::kNodes[1];
        const float inverse = *m_coordinates.inverse.at(column * kCell + kMiddle, row * kCell + kMiddle);
        return simd::slopes(m_fits[photo], column, inverse);
    }

  private:
    bool isFitted(int column, std::size_t photo) const {
        return m_rays.isPinhole() &&
               m_fits[photo].errorPx[static_cast<std::size_t>(column)] <= simd::CellFits::kTolerancePx;
    }

    void fitCells(int row) {
        const int columns = m_coordinates.columns();
        for (int column = 0; column < columns; ++column) {
            const auto [least, greatest] = simd::range(m_coordinates.inverse.at(column * kCell, row * kCell),
                                                       m_coordinates.inverse.width());
            m_least[static_cast<std::size_t>(column)] = least;
            m_greatest[static_cast<std::size_t>(column)] = greatest;
        }
        for (std::size_t photo = 0; photo < m_targets.size(); ++photo) {
            for (int column = 0; column < columns; ++column) {
                m_shows[static_cast<std::size_t>(column)] =
                    m_coordinates.wants(m_coordinates.index(column, row), photo) ? 1 : 0;
            }
            simd::fit(m_targets[photo], m_rays.nodes(), m_least.data(), m_greatest.data(), m_shows,
                      m_fits[photo]);
        }
    }

    void markBlind(int row) {
        for (int y = 0; y < kCell; ++y) {
            for (int x = 0; x < m_coordinates.source.width(); ++x) {
                if (m_rays.isBlind(x, y)) {
                    *m_coordinates.source.at(x, row * kCell + y) = SurfaceCoordinates::kUnseen;
                    *m_coordinates.inverse.at(x, row * kCell + y) = m_usualInverse;
                    m_coordinates.sources[m_coordinates.index(x / kCell, row)] |= SurfaceCoordinates::kBlind;
                }
            }
        }
    }

    /// Whether a row of a cell has a hole.
    static bool hasHole(const float* inverse) {
        int holes = 0;
        for (int x = 0; x < kCell; ++x) {
            holes += inverse[x] > 0 ? 0 : 1;
        }
        return holes > 0;
    }

    void fillHoles(int y) {
        float* inverse = m_coordinates.inverse.at(0, y);
        // What is beyond the view is 1 in the buffer, and covers nothing.
        const int width = m_rays.viewWidth();
        for (int column = 0; column < m_coordinates.columns(); ++column) {
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

    void locateCell(int column, int row) {
        const std::size_t cell = m_coordinates.index(column, row);
        const std::uint32_t sources = m_coordinates.sources[cell];
        std::int32_t* u = m_coordinates.u.data() + cell * SurfaceCoordinates::kCellPixels;
        std::int32_t* v = m_coordinates.v.data() + cell * SurfaceCoordinates::kCellPixels;
        const bool isMixed = (sources & SurfaceCoordinates::kMixed) != 0;
        bool isFirst = true;
        for (std::size_t photo = 0; photo < m_targets.size(); ++photo) {
            if (!m_coordinates.wants(cell, photo)) {
                continue;
            }
            const bool keepsBeside = photo == 1 && isMixed;
            std::int32_t* ofMixed = m_coordinates.mixedU.data() + cell * SurfaceCoordinates::kCellPixels;
            std::int32_t* ownU = isFirst ? u : keepsBeside ? ofMixed : m_u.data();
            ofMixed = m_coordinates.mixedV.data() + cell * SurfaceCoordinates::kCellPixels;
            std::int32_t* ownV = isFirst ? v : keepsBeside ? ofMixed : m_v.data();
            locate(column, row, photo, ownU, ownV);
            if (!isFirst && (sources >> photo & 1U) != 0) {
                simd::takeOwn(ownU, ownV, m_coordinates.source.at(column * kCell, row * kCell),
                              m_coordinates.source.width(), static_cast<std::uint8_t>(photo), u, v);
            }
            isFirst = false;
        }
    }

    void locate(int column, int row, std::size_t photo, std::int32_t* u, std::int32_t* v) const {
        const float* inverse = m_coordinates.inverse.at(column * kCell, row * kCell);
        if (isFitted(column, photo)) {
            simd::locate(m_fits[photo], column, inverse, m_coordinates.inverse.width(), u, v);
        } else {
            simd::locate(m_targets[photo], m_rays.cell(column * kCell), inverse,
                         m_coordinates.inverse.width(), u, v);
        }
    }

    RowRays m_rays;
    std::span<const simd::PhotoTarget> m_targets;
    const OpenCells& m_open;
    float m_usualInverse;
    SurfaceCoordinates& m_coordinates;
    std::vector<float> m_least; ///< The inverse depths of each cell.
    std::vector<float> m_greatest;
    std::vector<std::uint8_t> m_shows;  ///< Whether a cell shows a photo.
    std::vector<simd::CellFits> m_fits; ///< One a photo.
    std::array<std::int32_t, SurfaceCoordinates::kCellPixels> m_u;
    std::array<std::int32_t, SurfaceCoordinates::kCellPixels> m_v;
};

/// The coordinates in double precision; nothing near the poles.
std::optional<Eigen::Vector2d> exactCoordinates(const PixelRays& rays, const Rigid3& roomFromCamera,
                                                const SourcePhoto& photo, const Eigen::Vector2d& viewPixel,
                                                double inverse) {
    const auto ray = rays.camera().ray(viewPixel);
    if (!ray) {
        return std::nullopt;
    }
    const bool isPinhole = rays.camera().intrinsics().lens == LensModel::Pinhole;
    const Vector3d step = isPinhole ? Vector3d(*ray / ray->z()) : *ray;
    const Vector3d fromMiddle = photo.roomFromPhoto.rotation.conjugate() *
                                (roomFromCamera.rotation * step +
                                 inverse * (roomFromCamera.translation - photo.roomFromPhoto.translation));
    const Vector3d inPhoto = photo.lenses.directionTo(fromMiddle, inverse);
    if (inPhoto.head<2>().norm() < 0.17 * inPhoto.norm()) {
        return std::nullopt;
    }
    return pixel(photo.size, inPhoto);
}

} // namespace

void SurfaceCoordinates::reset(int width, int height) {
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

void SurfaceCoordinates::take(const InverseBuffer& seen, std::uint8_t photo, const OpenCells& open,
                              WorkerPool& pool, int threads) {
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

int SurfaceCoordinates::mix(const InverseBuffer& seen, float perFirst, WorkerPool& pool, int threads) {
    if (share.width() != source.width() || share.height() != source.height()) {
        share = MaskImage(source.width(), source.height());
        mixedU.resize(u.size());
        mixedV.resize(v.size());
    }
    std::vector<int> open(static_cast<std::size_t>(rows()));
    pool.run(rows(), threads, [&](int row, int) {
        for (int column = 0; column < columns(); ++column) {
            const int x = column * kCell;
            const int y = row * kCell;
            const simd::Mixture mixture = simd::mixDistances(
                seen.at(x, y), inverse.width(), perFirst, inverse.at(x, y), source.at(x, y), share.at(x, y));
            open[static_cast<std::size_t>(row)] += mixture.open;
            sources[index(column, row)] |=
                (mixture.hasOthers ? 1U << 1 : 0U) | (mixture.isMixed ? kMixed : 0U);
        }
    });
    return std::accumulate(open.begin(), open.end(), 0);
}

std::array<std::int32_t, 4> coordinateSlopes(const PixelRays& rays, const Rigid3& roomFromCamera,
                                             const SourcePhoto& photo, int x, int y, float inverse) {
    std::array<std::int32_t, 4> slopes{};
    const Eigen::Vector2d at(x, y);
    for (const int axis : {0, 1}) {
        const Eigen::Vector2d step = 0.5 * (axis == 0 ? Eigen::Vector2d(1, 0) : Eigen::Vector2d(0, 1));
        const auto before = exactCoordinates(rays, roomFromCamera, photo, at - step, inverse);
        const auto after = exactCoordinates(rays, roomFromCamera, photo, at + step, inverse);
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

void findCoordinates(const PixelRays& rays, const Rigid3& roomFromCamera, std::span<const SourcePhoto> photos,
                     const OpenCells& open, double usualDistanceM, bool wantsSlopes, WorkerPool& pool,
                     int threads, const std::function<void(int row)>& found,
                     SurfaceCoordinates& coordinates) {
    std::vector<simd::PhotoTarget> targets;
    for (const SourcePhoto& photo : photos) {
        targets.push_back(targetOf(roomFromCamera, photo));
    }
    coordinates.slopes.resize(coordinates.sources.size() * photos.size());
    const auto findSlopes = [&](const RowLocator& locator, int column, int row) {
        const std::size_t cell = coordinates.index(column, row);
        for (std::size_t i = 0; i < photos.size(); ++i) {
            if (coordinates.wants(cell, i)) {
                const int x = column * kCell + std::min(kCell, rays.camera().width() - column * kCell) / 2;
                const int y = row * kCell + std::min(kCell, rays.camera().height() - row * kCell) / 2;
                const auto fitted = locator.slopes(column, row, i);
                coordinates.slopes[cell * photos.size() + i] =
                    fitted ? *fitted
                           : coordinateSlopes(rays, roomFromCamera, photos[i], x, y,
                                              *coordinates.inverse.at(x, y));
            }
        }
    };
    constexpr int kRows = 3; // one worker does so many rows of cells in turn
    pool.run((coordinates.rows() + kRows - 1) / kRows, threads, [&](int band, int) {
        RowLocator locator(rays, targets, open, static_cast<float>(1 / usualDistanceM), coordinates);
        for (int row = band * kRows; row < std::min(coordinates.rows(), (band + 1) * kRows); ++row) {
            locator.locateRow(row);
            for (int column = 0; column < coordinates.columns() && wantsSlopes; ++column) {
                findSlopes(locator, column, row);
            }
            found(row);
        }
    });
}

} // namespace spherewalk::render
