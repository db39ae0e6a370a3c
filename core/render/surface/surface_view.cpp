// SPDX-License-Identifier: Apache-2.0
#include "depth_view.h"

#include "depth_cells.h"
#include "fast_view.h"
#include "sampler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <mutex>

namespace spherewalk::render {

namespace {

double pixels(std::int32_t fixed) {
    return fixed / static_cast<double>(1 << kFractionBits) - PlaneLayout::kGuard;
}

/// Photo coordinates that some pixels have.
struct Box {
    std::int32_t left = std::numeric_limits<std::int32_t>::max(), right = 0;
    std::int32_t top = std::numeric_limits<std::int32_t>::max(), bottom = 0;

    void insert(std::int32_t u, std::int32_t v) {
        left = std::min(left, u);
        right = std::max(right, u);
        top = std::min(top, v);
        bottom = std::max(bottom, v);
    }

    void addTo(TileSet& tiles) const {
        constexpr double kReachPx = 2; // of the sampling's filter
        tiles.insertBox(pixels(left) - kReachPx, pixels(top) - kReachPx, pixels(right) + kReachPx,
                        pixels(bottom) + kReachPx);
    }
};

} // namespace

DepthView::Cell DepthView::cell(int column, int row) const {
    return {column, row, std::min(kCell, m_width - column * kCell), std::min(kCell, m_height - row * kCell)};
}

void DepthView::needOfCell(const Cell& at, std::size_t source, TileSet& tiles) const {
    const std::int32_t middle = tiles.grid().photo().width / 2 << kFractionBits;
    const std::size_t index = m_places.index(at.column, at.row);
    const std::int32_t* u = m_places.u.data() + index * DepthPlaces::kCellPixels;
    const std::int32_t* v = m_places.v.data() + index * DepthPlaces::kCellPixels;
    if (at.width == kCell && at.height == kCell) {
        const std::array<std::int32_t, 4> all =
            m_places.sources[index] == 1U
                ? simd::boxOfCell(u, v)
                : simd::boxOfCell(u, v, m_places.source.at(at.column * kCell, at.row * kCell),
                                  m_places.source.width(), static_cast<std::uint8_t>(source));
        if (all[1] - all[0] < middle / 2) {
            Box{all[0], all[1], all[2], all[3]}.addTo(tiles);
            return;
        }
    }
    std::array<Box, 2> boxes; // pixels to either side of the seam have boxes of their own
    for (int y = 0; y < at.height; ++y) {
        const std::uint8_t* of = m_places.source.at(at.column * kCell, at.row * kCell + y);
        for (int x = 0; x < at.width; ++x) {
            if (of[x] == source) {
                boxes[u[y * kCell + x] < middle ? 0 : 1].insert(u[y * kCell + x], v[y * kCell + x]);
            }
        }
    }
    if (boxes[0].right > 0 && boxes[1].right > 0 && boxes[1].left - boxes[0].right < middle / 2) {
        boxes[0] = {boxes[0].left, boxes[1].right, std::min(boxes[0].top, boxes[1].top),
                    std::max(boxes[0].bottom, boxes[1].bottom)};
        boxes[1] = {};
    }
    for (const Box& box : boxes) {
        if (box.right > 0) {
            box.addTo(tiles);
        }
    }
}

/// What the camera sees of each photo's surface, the first one's first.
std::vector<PlacedPhoto> DepthView::drawPhotos(const PixelRays& rays, const Rigid3& roomFromCamera,
                                               std::span<const DepthPhoto> photos, WorkerPool& pool,
                                               int threads) {
    const CameraModel& camera = rays.camera();
    const Rigid3 cameraFromRoom = roomFromCamera.inverse();
    std::vector<PlacedPhoto> placed;
    for (std::size_t i = 0; i < photos.size() && m_open.any(); ++i) {
        // Positions are subtracted first: a room may lie at 10^6 m.
        const Rigid3 cameraFromPhoto{
            (cameraFromRoom.rotation * photos[i].roomFromPhoto.rotation).normalized(),
            cameraFromRoom.rotation * (photos[i].roomFromPhoto.translation - roomFromCamera.translation)};
        m_raster.draw(*photos[i].mesh, cameraFromPhoto, camera, m_open,
                      i == 0 ? kTolerancePx : kFurtherTolerancePx, pool, threads,
                      i == 0 ? m_places.inverse : m_seen);
        if (i > 0) {
            m_places.take(m_seen, static_cast<std::uint8_t>(i), m_open, pool, threads);
        }
        const int uncovered = m_open.update(m_places.inverse, pool, threads);
        const double openShare = uncovered / (static_cast<double>(m_width) * m_height);
        if (i == 0) {
            m_filledShare = openShare;
        }
        placed.push_back({photos[i].roomFromPhoto, photos[i].grid.photo()});
        if (i > 0 && openShare < kLeastOpenShare) {
            break;
        }
    }
    return placed;
}

std::vector<TileSet> DepthView::place(const PixelRays& rays, const Rigid3& roomFromCamera,
                                      std::span<const DepthPhoto> photos, double usualDistanceM,
                                      int samplesPerAxis, WorkerPool& pool, int threads) {
    m_width = rays.camera().width();
    m_height = rays.camera().height();
    m_samples = samplesPerAxis;
    m_places.reset(m_width, m_height);
    m_open = OpenCells(m_width, m_height);
    const std::vector<PlacedPhoto> placed = drawPhotos(rays, roomFromCamera, photos, pool, threads);
    m_photos = placed.size();
    std::vector<TileSet> needs;
    for (const DepthPhoto& photo : photos) {
        needs.emplace_back(photo.grid);
    }
    std::mutex mutex;
    const auto addNeeds = [&](int row) {
        std::vector<TileSet> own;
        for (const DepthPhoto& photo : photos) {
            own.emplace_back(photo.grid);
        }
        for (int column = 0; column < m_places.columns(); ++column) {
            const Cell at = cell(column, row);
            const std::size_t index = m_places.index(column, row);
            for (std::size_t i = 0; i < placed.size(); ++i) {
                if ((m_places.sources[index] >> i & 1U) != 0) {
                    needOfCell(at, i, own[i]);
                }
            }
        }
        const std::scoped_lock lock(mutex);
        for (std::size_t i = 0; i < needs.size(); ++i) {
            needs[i].merge(own[i]);
        }
    };
    placePixels(rays, roomFromCamera, placed, m_open, usualDistanceM, m_samples > 1, pool, threads, addNeeds,
                m_places);
    return needs;
}

/// Of the samples of a cell.
struct DepthView::SampleSpace {
    explicit SampleSpace(int samplesPerAxis)
        : places(DepthPlaces::kCellPixels * static_cast<std::size_t>(samplesPerAxis * samplesPerAxis)),
          fractions(places.size()) {}

    std::vector<std::int32_t> places;
    std::vector<std::int32_t> fractions;
    int step = 1; ///< CellSamples::nextStep

    // Of the pixels that are taken from another photo than the first:
    std::array<std::int32_t, DepthPlaces::kCellPixels> u;
    std::array<std::int32_t, DepthPlaces::kCellPixels> v;
    std::array<std::uint8_t, DepthPlaces::kCellPixels> pixels; ///< of the cell
    std::array<std::uint8_t, 3 * DepthPlaces::kCellPixels + 16> colours;
};

/// Places of samples of a cell's pixels.
void DepthView::fillPlaces(std::size_t cell, std::size_t source, const PlaneView& plane, Sampling sampling,
                           const PixelRows& rows, SampleSpace& space) const {
    const simd::Rounding round = simd::rounding(sampling);
    constexpr std::int32_t kHalf = 1 << (kFractionBits - 1);
    constexpr std::int32_t kFirst = (PlaneLayout::kGuard << kFractionBits) - kHalf;
    simd::PartPlacing placing{round.u,
                              round.v,
                              kFirst,
                              plane.size().width << kFractionBits,
                              kFirst + (plane.size().height << kFractionBits),
                              plane.stride() * PlaneLayout::kPixelBytes};
    const int parts = m_samples * m_samples;
    for (int part = 0; part < parts; ++part) {
        if (m_samples > 1) {
            const std::array<std::int32_t, 4>& slopes = m_places.slopes[cell * m_photos + source];
            const auto right = (part % m_samples + 0.5F) / static_cast<float>(m_samples) - 0.5F;
            const auto down = (part / m_samples + 0.5F) / static_cast<float>(m_samples) - 0.5F;
            placing.addU = round.u + static_cast<std::int32_t>(right * static_cast<float>(slopes[0]) +
                                                               down * static_cast<float>(slopes[2]));
            placing.addV = round.v + static_cast<std::int32_t>(right * static_cast<float>(slopes[1]) +
                                                               down * static_cast<float>(slopes[3]));
        }
        simd::placeRows(placing, rows.u, rows.v, rows.count, parts, space.places.data() + part * kCell,
                        space.fractions.data() + part * kCell);
    }
}

/// Those pixels that are taken from a photo that is not the first.
void DepthView::samplePart(const Cell& at, std::size_t source, const PlaneView& plane, Sampling sampling,
                           SampleSpace& space, RgbImage& picture) const {
    const std::size_t cell = m_places.index(at.column, at.row);
    const std::int32_t* u = m_places.u.data() + cell * DepthPlaces::kCellPixels;
    const std::int32_t* v = m_places.v.data() + cell * DepthPlaces::kCellPixels;
    const int left = at.column * kCell;
    const int top = at.row * kCell;
    std::size_t count = 0;
    for (int y = 0; y < at.height; ++y) {
        const std::uint8_t* of = m_places.source.at(left, top + y);
        if (std::memchr(of, static_cast<int>(source), static_cast<std::size_t>(at.width)) == nullptr) {
            continue;
        }
        for (int x = 0; x < at.width; ++x) {
            if (of[x] == source) {
                const int pixel = y * kCell + x;
                space.pixels[count] = static_cast<std::uint8_t>(pixel);
                space.u[count] = u[pixel];
                space.v[count] = v[pixel];
                ++count;
            }
        }
    }
    for (std::size_t i = count; i % kCell != 0; ++i) {
        space.u[i] = space.u[count - 1];
        space.v[i] = space.v[count - 1];
    }
    const int rows = (static_cast<int>(count) + kCell - 1) / kCell;
    fillPlaces(cell, source, plane, sampling, {space.u.data(), space.v.data(), rows}, space);
    simd::sample(plane, sampling,
                 {space.places.data(), space.fractions.data(), m_samples, space.colours.data(),
                  std::ptrdiff_t{3} * kCell, kCell, rows, true});
    for (std::size_t i = 0; i < count; ++i) {
        const int pixel = space.pixels[i];
        std::copy_n(space.colours.data() + 3 * i, 3, picture.at(left + pixel % kCell, top + pixel / kCell));
    }
}

/// What a cell shows of the first photo.
void DepthView::fillFirst(const Cell& at, const PlaneView& plane, Sampling sampling,
                          SampleSpace& space) const {
    const std::size_t cell = m_places.index(at.column, at.row);
    fillPlaces(cell, 0, plane, sampling,
               {m_places.u.data() + cell * DepthPlaces::kCellPixels,
                m_places.v.data() + cell * DepthPlaces::kCellPixels, kCell},
               space);
    space.step =
        simd::stepToOtherMemory(space.places.data(), static_cast<int>(space.places.size()), plane.stride());
}

/// What the cell has of other photos, and what the lens does not see.
void DepthView::sampleOthers(const Cell& at, std::span<const PlaneView> planes, Sampling sampling,
                             SampleSpace& space, RgbImage& picture) const {
    const std::uint32_t sources = m_places.sources[m_places.index(at.column, at.row)];
    for (std::size_t i = 1; i < planes.size(); ++i) {
        if ((sources >> i & 1U) != 0) {
            samplePart(at, i, planes[i], sampling, space, picture);
        }
    }
    const int left = at.column * kCell;
    const int top = at.row * kCell;
    for (int y = 0; y < at.height && (sources & DepthPlaces::kBlind) != 0; ++y) {
        for (int x = 0; x < at.width; ++x) {
            if (*m_places.source.at(left + x, top + y) == DepthPlaces::kUnseen) {
                std::fill_n(picture.at(left + x, top + y), 3, std::uint8_t{0});
            }
        }
    }
}

void DepthView::sample(const PixelRays& rays, std::span<const PlaneView> planes, Sampling sampling,
                       WorkerPool& pool, int threads, RgbImage& picture) const {
    if (picture.width() != rays.camera().width() || picture.height() != rays.camera().height()) {
        picture = RgbImage(rays.camera().width(), rays.camera().height());
    }
    pool.run(m_places.rows(), threads, [&](int row, int) {
        std::array<SampleSpace, 2> first{SampleSpace(m_samples), SampleSpace(m_samples)};
        SampleSpace others(m_samples);
        // A cell's pixels are on their way from memory while the cell before it is sampled.
        fillFirst(cell(0, row), planes[0], sampling, first[0]);
        for (int column = 0; column < m_places.columns(); ++column) {
            const Cell at = cell(column, row);
            const SampleSpace& now = first[static_cast<std::size_t>(column % 2)];
            simd::CellSamples samples{now.places.data(),
                                      now.fractions.data(),
                                      m_samples,
                                      picture.at(column * kCell, row * kCell),
                                      std::ptrdiff_t{3} * picture.width(),
                                      at.width,
                                      at.height,
                                      (column + 1) * kCell + 2 <= m_width};
            if (column + 1 < m_places.columns()) {
                SampleSpace& next = first[static_cast<std::size_t>((column + 1) % 2)];
                fillFirst(cell(column + 1, row), planes[0], sampling, next);
                samples.next = next.places.data();
                samples.nextStep = next.step;
            }
            simd::sample(planes[0], sampling, samples);
            sampleOthers(at, planes, sampling, others, picture);
        }
    });
}

DepthImage DepthView::depth(const PixelRays& rays) const {
    DepthImage depth(m_width, m_height);
    const bool isPinhole = rays.camera().intrinsics().lens == LensModel::Pinhole;
    for (int y = 0; y < depth.height(); ++y) {
        for (int x = 0; x < depth.width(); ++x) {
            const double along = isPinhole ? 1 : rays.ray(x, y).z();
            const bool isSeen = *m_places.source.at(x, y) != DepthPlaces::kUnseen && along > 0;
            *depth.at(x, y) = isSeen ? static_cast<float>(along / *m_places.inverse.at(x, y))
                                     : std::numeric_limits<float>::infinity();
        }
    }
    return depth;
}

} // namespace spherewalk::render
