// SPDX-License-Identifier: Apache-2.0
#include "depth_view.h"

#include "fast_view.h"
#include "sampler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>

namespace spherewalk::render {

namespace {

constexpr int kCell = RayTable::kCell;
constexpr int kCellPixels = kCell * kCell;

double pixels(std::int32_t fixed) {
    return fixed / static_cast<double>(1 << kFractionBits) - PlaneLayout::kGuard;
}

} // namespace

DepthView::Cell DepthView::cell(int column, int row) const {
    return {column * kCell, row * kCell, std::min((column + 1) * kCell, m_places.source.width()),
            std::min((row + 1) * kCell, m_places.source.height())};
}

/// A bit for each photo that a pixel is taken from; the lens's blind pixels count for the first.
std::uint32_t DepthView::sourcesIn(const Cell& at) const {
    std::uint32_t bits = 0;
    for (int y = at.y; y < at.endY; ++y) {
        const std::uint8_t* source = m_places.source.at(0, y);
        for (int x = at.x; x < at.endX; ++x) {
            bits |= 1U << (source[x] == DepthPlaces::kUnseen ? 0 : source[x]);
        }
    }
    return bits;
}

void DepthView::needOfCell(const Cell& at, std::size_t source, TileSet& tiles) const {
    // Pixels to either side of the seam have boxes of their own.
    constexpr double kReachPx = 2; // of the sampling's filter
    const std::int32_t middle = tiles.grid().photo().width / 2 << kFractionBits;

    struct Box {
        std::int32_t left = std::numeric_limits<std::int32_t>::max(), right = 0;
        std::int32_t top = std::numeric_limits<std::int32_t>::max(), bottom = 0;
    };

    std::array<Box, 2> boxes;
    for (int y = at.y; y < at.endY; ++y) {
        const std::uint8_t* of = m_places.source.at(0, y);
        const std::int32_t* u = m_places.u.at(0, y);
        const std::int32_t* v = m_places.v.at(0, y);
        for (int x = at.x; x < at.endX; ++x) {
            if (of[x] == source) {
                Box& box = boxes[u[x] < middle ? 0 : 1];
                box.left = std::min(box.left, u[x]);
                box.right = std::max(box.right, u[x]);
                box.top = std::min(box.top, v[x]);
                box.bottom = std::max(box.bottom, v[x]);
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
            tiles.insertBox(pixels(box.left) - kReachPx, pixels(box.top) - kReachPx,
                            pixels(box.right) + kReachPx, pixels(box.bottom) + kReachPx);
        }
    }
}

std::vector<TileSet> DepthView::place(const PixelRays& rays, const Rigid3& roomFromCamera,
                                      std::span<const DepthPhoto> photos, double usualDistanceM,
                                      int samplesPerAxis, WorkerPool& pool, int threads) {
    const CameraModel& camera = rays.camera();
    m_photos = photos.size();
    m_samples = samplesPerAxis;
    m_columns = (camera.width() + kCell - 1) / kCell;
    m_rows = (camera.height() + kCell - 1) / kCell;
    m_seen.resize(photos.size());
    OpenCells open(camera.width(), camera.height());
    std::vector<PlacedPhoto> placed;
    for (std::size_t i = 0; i < photos.size(); ++i) {
        if (open.any()) {
            const Rigid3 cameraFromRoom = roomFromCamera.inverse();
            // Positions are subtracted first: a room may lie at 10^6 m.
            const Rigid3 cameraFromPhoto{
                (cameraFromRoom.rotation * photos[i].roomFromPhoto.rotation).normalized(),
                cameraFromRoom.rotation * (photos[i].roomFromPhoto.translation - roomFromCamera.translation)};
            m_raster.draw(*photos[i].mesh, cameraFromPhoto, camera, open, kTolerancePx, pool, threads,
                          m_seen[i]);
            placed.push_back({photos[i].roomFromPhoto, photos[i].grid.photo(), &m_seen[i]});
        }
        if (i + 1 < photos.size()) {
            open.update({m_seen.data(), placed.size()}, pool, threads);
        }
    }
    placePixels(rays, roomFromCamera, placed, usualDistanceM, pool, threads, m_places);
    m_slopes.resize(static_cast<std::size_t>(m_columns * m_rows) * m_photos);
    std::vector<TileSet> needs;
    for (const DepthPhoto& photo : photos) {
        needs.emplace_back(photo.grid);
    }
    std::mutex mutex;
    pool.run(m_rows, threads, [&](int row, int) {
        std::vector<TileSet> own;
        for (const DepthPhoto& photo : photos) {
            own.emplace_back(photo.grid);
        }
        for (int column = 0; column < m_columns; ++column) {
            const Cell at = cell(column, row);
            const std::uint32_t sources = sourcesIn(at);
            for (std::size_t i = 0; i < placed.size(); ++i) {
                if ((sources >> i & 1U) == 0) {
                    continue;
                }
                needOfCell(at, i, own[i]);
                if (m_samples > 1) {
                    const int x = (at.x + at.endX) / 2;
                    const int y = (at.y + at.endY) / 2;
                    m_slopes[static_cast<std::size_t>(row * m_columns + column) * m_photos + i].of =
                        placeSlopes(rays, roomFromCamera, placed[i], x, y, *m_places.inverse.at(x, y));
                }
            }
        }
        const std::scoped_lock lock(mutex);
        for (std::size_t i = 0; i < needs.size(); ++i) {
            needs[i].merge(own[i]);
        }
    });
    return needs;
}

/// Places of a cell's samples. What another photo shows is sampled too, anywhere, and not used.
void DepthView::fillPlaces(const Cell& at, std::size_t source, const PlaneView& plane, Sampling sampling,
                           std::int32_t* places, std::int32_t* fractions) const {
    const auto index = static_cast<std::size_t>(at.y / kCell * m_columns + at.x / kCell) * m_photos + source;
    const simd::Rounding round = simd::rounding(sampling);
    constexpr std::int32_t kHalf = 1 << (kFractionBits - 1);
    constexpr std::int32_t kFirst = (PlaneLayout::kGuard << kFractionBits) - kHalf;
    const std::int32_t turn = plane.size().width << kFractionBits;
    const std::int32_t lastV = kFirst + (plane.size().height << kFractionBits);
    const int rowBytes = plane.stride() * PlaneLayout::kPixelBytes;
    for (int part = 0; part < m_samples * m_samples; ++part) {
        std::int32_t addU = round.u;
        std::int32_t addV = round.v;
        if (m_samples > 1) {
            const std::array<std::int32_t, 4>& slopes = m_slopes[index].of;
            const auto right = (part % m_samples + 0.5F) / static_cast<float>(m_samples) - 0.5F;
            const auto down = (part / m_samples + 0.5F) / static_cast<float>(m_samples) - 0.5F;
            addU += static_cast<std::int32_t>(right * static_cast<float>(slopes[0]) +
                                              down * static_cast<float>(slopes[2]));
            addV += static_cast<std::int32_t>(right * static_cast<float>(slopes[1]) +
                                              down * static_cast<float>(slopes[3]));
        }
        for (int y = at.y; y < at.endY; ++y) {
            const std::int32_t* fromU = m_places.u.at(at.x, y);
            const std::int32_t* fromV = m_places.v.at(at.x, y);
            const std::ptrdiff_t to =
                ((y - at.y) * m_samples * m_samples + part) * static_cast<std::ptrdiff_t>(kCell);
            for (int x = 0; x < at.endX - at.x; ++x) {
                std::int32_t u = fromU[x] + addU;
                u = u < kFirst ? u + turn : u;
                u = u >= kFirst + turn ? u - turn : u;
                u = std::min(std::max(u, 0), kFirst + turn); // of another photo's size
                const std::int32_t v = std::min(std::max(fromV[x] + addV, kFirst), lastV);
                places[to + x] =
                    (v >> kFractionBits) * rowBytes + (u >> kFractionBits) * PlaneLayout::kPixelBytes;
                fractions[to + x] =
                    static_cast<std::int32_t>((static_cast<std::uint32_t>(v) << kFractionBits) |
                                              (static_cast<std::uint32_t>(u) & ((1U << kFractionBits) - 1)));
            }
        }
    }
}

void DepthView::sampleCell(const Cell& at, std::span<const PlaneView> planes, Sampling sampling,
                           std::int32_t* places, std::int32_t* fractions, RgbImage& picture) const {
    const std::uint32_t sources = sourcesIn(at);
    const bool isOne = (sources & (sources - 1)) == 0;
    std::array<std::uint8_t, 3 * kCellPixels + 16> own{};
    for (std::size_t i = 0; i < planes.size(); ++i) {
        if ((sources >> i & 1U) == 0) {
            continue;
        }
        fillPlaces(at, i, planes[i], sampling, places, fractions);
        const simd::CellSamples samples{places,
                                        fractions,
                                        m_samples,
                                        isOne ? picture.at(at.x, at.y) : own.data(),
                                        std::ptrdiff_t{3} * (isOne ? picture.width() : kCell),
                                        at.endX - at.x,
                                        at.endY - at.y,
                                        false};
        simd::sample(planes[i], sampling, samples);
        for (int y = at.y; y < at.endY && !isOne; ++y) {
            for (int x = at.x; x < at.endX; ++x) {
                if (*m_places.source.at(x, y) == i) {
                    std::copy_n(own.data() + 3 * ((y - at.y) * kCell + x - at.x), 3, picture.at(x, y));
                }
            }
        }
    }
    for (int y = at.y; y < at.endY; ++y) {
        for (int x = at.x; x < at.endX; ++x) {
            if (*m_places.source.at(x, y) == DepthPlaces::kUnseen) {
                std::fill_n(picture.at(x, y), 3, std::uint8_t{0});
            }
        }
    }
}

void DepthView::sample(const PixelRays& rays, std::span<const PlaneView> planes, Sampling sampling,
                       WorkerPool& pool, int threads, RgbImage& picture) const {
    if (picture.width() != rays.camera().width() || picture.height() != rays.camera().height()) {
        picture = RgbImage(rays.camera().width(), rays.camera().height());
    }
    pool.run(m_rows, threads, [&](int row, int) {
        const auto count = static_cast<std::size_t>(kCellPixels * m_samples * m_samples);
        std::vector<std::int32_t> places(count);
        std::vector<std::int32_t> fractions(count);
        for (int column = 0; column < m_columns; ++column) {
            sampleCell(cell(column, row), planes, sampling, places.data(), fractions.data(), picture);
        }
    });
}

DepthImage DepthView::depth(const PixelRays& rays) const {
    DepthImage depth(m_places.source.width(), m_places.source.height());
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

double DepthView::filledShare() const {
    std::size_t others = 0;
    const InverseBuffer& first = m_seen.front();
    for (const float value : first.values()) {
        others += value > 0 ? 0 : 1;
    }
    return static_cast<double>(others) / static_cast<double>(first.values().size());
}

} // namespace spherewalk::render
