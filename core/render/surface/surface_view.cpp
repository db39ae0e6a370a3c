// SPDX-License-Identifier: Apache-2.0
#include "surface/surface_view.h"

#include "pixels/sampler.h"
#include "surface/cells.h"

#include "spherewalk/render/colour_correction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <mutex>

namespace spherewalk::render {

namespace {

double pixels(std::int32_t fixed) {
    return fixed / double{kFixedOne} - PlaneLayout::kGuard;
}

/// The bounds of the photo coordinates of some pixels.
struct Box {
    std::int32_t left = std::numeric_limits<std::int32_t>::max(), right = 0;
    std::int32_t top = std::numeric_limits<std::int32_t>::max(), bottom = 0;

    void insert(std::int32_t u, std::int32_t v) {
        left = std::min(left, u);
        right = std::max(right, u);
        top = std::min(top, v);
        bottom = std::max(bottom, v);
    }

    /// Whether a pixel of the photo about this box may be the rim of a thing.
    bool hasRims(const SurfaceMesh& mesh, const EquirectSize& size) const {
        const double perPixel = static_cast<double>(mesh.width()) / size.width;
        return mesh.hasRims(pixels(left) * perPixel, pixels(top) * perPixel, pixels(right) * perPixel,
                            pixels(bottom) * perPixel);
    }

    void addTo(TileSet& tiles) const {
        constexpr double kReachPx = 2; // of the sampling's filter
        tiles.insertBox(pixels(left) - kReachPx, pixels(top) - kReachPx, pixels(right) + kReachPx,
                        pixels(bottom) + kReachPx);
    }
};

/// Adds the tiles of the pixels to the right (first) and to the left of the seam.
void addBothSides(std::array<Box, 2> boxes, TileSet& tiles) {
    const std::int32_t middle = tiles.grid().photo().width / 2 << kFractionBits;
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

} // namespace

Rigid3 between(const Rigid3& roomFromCamera, const Rigid3& roomFromPhoto) {
    const Eigen::Quaterniond cameraFromRoom = roomFromCamera.rotation.conjugate();
    return {(cameraFromRoom * roomFromPhoto.rotation).normalized(),
            cameraFromRoom * (roomFromPhoto.translation - roomFromCamera.translation)};
}

SurfaceView::Drawn::Drawn(const SurfacePhoto& photo) : mesh(photo.mesh), size(photo.grid.photo()) {
    constexpr double kVisible = 0.01; // less cannot be told from noise
    if ((photo.gain.array() - 1).abs().maxCoeff() < kVisible) {
        return;
    }
    for (int channel = 0; channel < 3; ++channel) {
        const auto values = exposedValues(photo.gain[channel], photo.highlightRolloff);
        levels.insert(levels.end(), values.begin(), values.end());
    }
}

void SurfaceView::Drawn::brighten(std::uint8_t* colours, std::size_t pixels) const {
    for (std::size_t i = 0; i < pixels && !levels.empty(); ++i) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            std::uint8_t& level = colours[3 * i + channel];
            level = levels[256 * channel + level];
        }
    }
}

SurfaceView::Cell SurfaceView::cell(int column, int row) const {
    return {column, row, std::min(kCell, m_width - column * kCell), std::min(kCell, m_height - row * kCell)};
}

/// Adds the tiles of a cell's pixels that come from a photo. Returns whether the cell is mixed and some may
/// show a rim.
bool SurfaceView::needOfCell(const Cell& at, std::size_t source, TileSet& tiles) const {
    const std::int32_t middle = tiles.grid().photo().width / 2 << kFractionBits;
    const std::size_t index = m_coordinates.index(at.column, at.row);
    const bool isMixed = (m_coordinates.sources[index] & SurfaceCoordinates::kMixed) != 0;
    const std::int32_t* u = m_coordinates.u.data() + index * SurfaceCoordinates::kCellPixels;
    const std::int32_t* v = m_coordinates.v.data() + index * SurfaceCoordinates::kCellPixels;
    if (at.width == kCell && at.height == kCell) {
        const std::array<std::int32_t, 4> all =
            (m_coordinates.sources[index] & ~(SurfaceCoordinates::kMixed | SurfaceCoordinates::kRims)) == 1U
                ? simd::boxOfCell(u, v)
                : simd::boxOfCell(u, v, m_coordinates.source.at(at.column * kCell, at.row * kCell),
                                  m_coordinates.source.width(), static_cast<std::uint8_t>(source));
        if (all[1] - all[0] < middle / 2) {
            const Box box{all[0], all[1], all[2], all[3]};
            box.addTo(tiles);
            return isMixed && box.hasRims(*m_drawn[source].mesh, m_drawn[source].size);
        }
    }
    std::array<Box, 2> boxes; // pixels to either side of the seam have boxes of their own
    for (int y = 0; y < at.height; ++y) {
        const std::uint8_t* of = m_coordinates.source.at(at.column * kCell, at.row * kCell + y);
        for (int x = 0; x < at.width; ++x) {
            if (of[x] == source) {
                boxes[u[y * kCell + x] < middle ? 0 : 1].insert(u[y * kCell + x], v[y * kCell + x]);
            }
        }
    }
    addBothSides(boxes, tiles);
    return isMixed;
}

/// Adds the tiles of a cell's pixels in which the second photo may have a share. Returns whether some may
/// show a rim.
bool SurfaceView::needOfMixed(const Cell& at, TileSet& tiles) const {
    const std::int32_t middle = tiles.grid().photo().width / 2 << kFractionBits;
    const std::size_t first = m_coordinates.index(at.column, at.row) * SurfaceCoordinates::kCellPixels;
    const std::array<std::int32_t, 4> all =
        simd::boxOfCell(m_coordinates.mixedU.data() + first, m_coordinates.mixedV.data() + first);
    if (all[1] - all[0] < middle / 2) {
        const Box box{all[0], all[1], all[2], all[3]};
        box.addTo(tiles);
        return box.hasRims(*m_drawn[1].mesh, m_drawn[1].size);
    }
    std::array<Box, 2> boxes;
    for (std::size_t i = first; i < first + SurfaceCoordinates::kCellPixels; ++i) {
        boxes[m_coordinates.mixedU[i] < middle ? 0 : 1].insert(m_coordinates.mixedU[i],
                                                               m_coordinates.mixedV[i]);
    }
    addBothSides(boxes, tiles);
    return true;
}

/// Adds the tiles of each photo that a row of cells needs.
void SurfaceView::needOfRow(int row, std::vector<TileSet>& tiles) {
    for (int column = 0; column < m_coordinates.columns(); ++column) {
        const Cell at = cell(column, row);
        std::uint32_t& sources = m_coordinates.sources[m_coordinates.index(column, row)];
        bool hasRims = false;
        for (std::size_t i = 0; i < m_drawn.size(); ++i) {
            if ((sources >> i & 1U) != 0) {
                hasRims |= needOfCell(at, i, tiles[i]);
            }
        }
        if ((sources & SurfaceCoordinates::kMixed) != 0) {
            hasRims |= needOfMixed(at, tiles[1]);
        }
        sources |= hasRims ? SurfaceCoordinates::kRims : 0U;
    }
}

/// Draws what the camera sees of each photo's surface, the first photo first.
std::vector<SourcePhoto> SurfaceView::drawPhotos(const PixelRays& rays, const Rigid3& roomFromCamera,
                                                 std::span<const SurfacePhoto> photos, WorkerPool& pool,
                                                 int threads) {
    // Photos that are nearer to the camera than this count alike.
    constexpr double kNearestM = 2e-4;
    constexpr double kBesideM = 0.02; // So near to a photo the next one gains nothing: the view is the photo.
    const CameraModel& camera = rays.camera();
    const double pixels = static_cast<double>(m_width) * m_height;
    std::vector<SourcePhoto> drawn;
    double firstOffset = 0;
    for (std::size_t i = 0; i < photos.size() && m_open.any(); ++i) {
        const bool isMixed = m_mixes && i == 1;
        const Rigid3 cameraFromPhoto = between(roomFromCamera, photos[i].roomFromPhoto);
        const double offset = cameraFromPhoto.translation.squaredNorm() + kNearestM * kNearestM;
        m_raster.draw(*photos[i].mesh, cameraFromPhoto, photos[i].lenses, camera, m_open,
                      i == 0 || isMixed ? kTolerancePx : kFurtherTolerancePx, pool, threads,
                      i == 0 ? m_coordinates.inverse : m_seen);
        drawn.push_back({photos[i].roomFromPhoto, photos[i].grid.photo(), photos[i].lenses});
        m_drawn.emplace_back(photos[i]);
        if (i == 0) {
            firstOffset = offset;
        }
        if (i == 0 && m_mixes && photos.size() > 1) {
            continue; // the second photo is drawn in all of the view
        }
        if (isMixed) {
            const double weight =
                std::sqrt(firstOffset / offset) * firstOffset / (firstOffset + kBesideM * kBesideM);
            m_filledShare = m_coordinates.mix(m_seen, static_cast<float>(weight), pool, threads) / pixels;
        } else if (i > 0) {
            m_coordinates.take(m_seen, static_cast<std::uint8_t>(i), m_open, pool, threads);
        }
        if (m_mixes && i > 0) {
            m_coordinates.reopenNarrow(static_cast<std::uint8_t>(i), m_width, m_height, pool, threads);
        }
        const double openShare = m_open.update(m_coordinates.inverse, pool, threads) / pixels;
        if (i == 0) {
            m_filledShare = openShare;
        }
        if (i > 0 && openShare < kLeastOpenShare) {
            break;
        }
    }
    return drawn;
}

void SurfaceView::begin(const PixelRays& rays, int samplesPerAxis) {
    m_width = rays.camera().width();
    m_height = rays.camera().height();
    m_samples = samplesPerAxis;
    m_coordinates.reset(m_width, m_height);
    m_open = OpenCells(m_width, m_height);
    m_drawn.clear();
}

std::vector<TileSet> SurfaceView::prepare(const PixelRays& rays, const Rigid3& roomFromCamera,
                                          std::span<const SurfacePhoto> photos, double usualDistanceM,
                                          int samplesPerAxis, WorkerPool& pool, int threads) {
    begin(rays, samplesPerAxis);
    const std::vector<SourcePhoto> drawn = drawPhotos(rays, roomFromCamera, photos, pool, threads);
    if (m_mixes) {
        markHoles(pool, threads);
    }
    return locate(rays, roomFromCamera, photos, drawn, usualDistanceM, pool, threads);
}

/// Finds the coordinates and tells which tiles of each photo are needed.
std::vector<TileSet> SurfaceView::locate(const PixelRays& rays, const Rigid3& roomFromCamera,
                                         std::span<const SurfacePhoto> photos,
                                         std::span<const SourcePhoto> drawn, double usualDistanceM,
                                         WorkerPool& pool, int threads) {
    std::vector<TileSet> needs;
    for (const SurfacePhoto& photo : photos) {
        needs.emplace_back(photo.grid);
    }
    std::mutex mutex;
    const auto addNeeds = [&](int row) {
        std::vector<TileSet> own;
        for (const SurfacePhoto& photo : photos) {
            own.emplace_back(photo.grid);
        }
        needOfRow(row, own);
        const std::scoped_lock lock(mutex);
        for (std::size_t i = 0; i < needs.size(); ++i) {
            needs[i].merge(own[i]);
        }
    };
    findCoordinates(rays, roomFromCamera, drawn, m_open, usualDistanceM, m_samples > 1, pool, threads,
                    addNeeds, m_coordinates);
    return needs;
}

/// Computes the places of the samples of a cell's pixels.
void SurfaceView::fillPlaces(std::size_t cell, std::size_t source, const PlaneView& plane, Sampling sampling,
                             const PixelRows& rows, SampleSpace& space) const {
    const Placing round = simd::placing(plane, sampling);
    constexpr std::int32_t kHalf = 1 << (kFractionBits - 1);
    constexpr std::int32_t kFirst = (PlaneLayout::kGuard << kFractionBits) - kHalf;
    simd::SamplePlacing placing{round.roundingU,
                                round.roundingV,
                                kFirst,
                                plane.size().width << kFractionBits,
                                kFirst + (plane.size().height << kFractionBits),
                                plane.stride() * PlaneLayout::kPixelBytes};
    const int parts = m_samples * m_samples;
    for (int part = 0; part < parts; ++part) {
        if (m_samples > 1) {
            const std::array<std::int32_t, 4>& slopes = m_coordinates.slopes[cell * m_drawn.size() + source];
            const auto right = (part % m_samples + 0.5F) / static_cast<float>(m_samples) - 0.5F;
            const auto down = (part / m_samples + 0.5F) / static_cast<float>(m_samples) - 0.5F;
            placing.addU = round.roundingU + static_cast<std::int32_t>(right * static_cast<float>(slopes[0]) +
                                                                       down * static_cast<float>(slopes[2]));
            placing.addV = round.roundingV + static_cast<std::int32_t>(right * static_cast<float>(slopes[1]) +
                                                                       down * static_cast<float>(slopes[3]));
        }
        simd::placeRows(placing, rows.u, rows.v, rows.count, parts, space.places.data() + part * kCell,
                        space.fractions.data() + part * kCell);
    }
}

/// Samples the pixels that come from a photo other than the first.
void SurfaceView::samplePart(const Cell& at, std::size_t source, const PlaneView& plane, Sampling sampling,
                             SampleSpace& space, RgbImage& picture) const {
    const std::size_t cell = m_coordinates.index(at.column, at.row);
    const std::int32_t* u = m_coordinates.u.data() + cell * SurfaceCoordinates::kCellPixels;
    const std::int32_t* v = m_coordinates.v.data() + cell * SurfaceCoordinates::kCellPixels;
    const int left = at.column * kCell;
    const int top = at.row * kCell;
    std::size_t count = 0;
    for (int y = 0; y < at.height; ++y) {
        const std::uint8_t* of = m_coordinates.source.at(left, top + y);
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
    m_drawn[source].brighten(space.colours.data(), count);
    for (std::size_t i = 0; i < count; ++i) {
        const int pixel = space.pixels[i];
        std::copy_n(space.colours.data() + 3 * i, 3, picture.at(left + pixel % kCell, top + pixel / kCell));
    }
}

/// Prepares the samples of a cell for the first photo.
void SurfaceView::fillFirst(const Cell& at, const PlaneView& plane, Sampling sampling,
                            SampleSpace& space) const {
    const std::size_t cell = m_coordinates.index(at.column, at.row);
    fillPlaces(cell, 0, plane, sampling,
               {m_coordinates.u.data() + cell * SurfaceCoordinates::kCellPixels,
                m_coordinates.v.data() + cell * SurfaceCoordinates::kCellPixels, kCell},
               space);
    space.step =
        simd::stepToOtherMemory(space.places.data(), static_cast<int>(space.places.size()), plane.stride());
}

/// Samples the pixels from other photos, and blackens those that the lens does not see.
void SurfaceView::sampleOthers(const Cell& at, std::span<const PlaneView> planes, Sampling sampling,
                               SampleSpace& space, RgbImage& picture) const {
    const std::uint32_t sources = m_coordinates.sources[m_coordinates.index(at.column, at.row)];
    for (std::size_t i = 1; i < planes.size(); ++i) {
        if ((sources >> i & 1U) != 0) {
            samplePart(at, i, planes[i], sampling, space, picture);
        }
    }
    const int left = at.column * kCell;
    const int top = at.row * kCell;
    for (int y = 0; y < at.height && (sources & SurfaceCoordinates::kBlind) != 0; ++y) {
        for (int x = 0; x < at.width; ++x) {
            if (*m_coordinates.source.at(left + x, top + y) == SurfaceCoordinates::kUnseen) {
                std::fill_n(picture.at(left + x, top + y), 3, std::uint8_t{0});
            }
        }
    }
}

void SurfaceView::sample(const PixelRays& rays, std::span<const PlaneView> planes, Sampling sampling,
                         WorkerPool& pool, int threads, RgbImage& picture) {
    if (picture.width() != rays.camera().width() || picture.height() != rays.camera().height()) {
        picture = RgbImage(rays.camera().width(), rays.camera().height());
    }
    pool.run(m_coordinates.rows(), threads, [&](int row, int) {
        std::array<SampleSpace, 2> first{SampleSpace(m_samples), SampleSpace(m_samples)};
        SampleSpace others(m_samples);
        // A cell's pixels are on their way from memory while the cell before it is sampled.
        fillFirst(cell(0, row), planes[0], sampling, first[0]);
        for (int column = 0; column < m_coordinates.columns(); ++column) {
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
            if (column + 1 < m_coordinates.columns()) {
                SampleSpace& next = first[static_cast<std::size_t>((column + 1) % 2)];
                fillFirst(cell(column + 1, row), planes[0], sampling, next);
                samples.next = next.places.data();
                samples.nextStep = next.step;
            }
            simd::sample(planes[0], sampling, samples);
            sampleOthers(at, planes, sampling, others, picture);
            if (m_mixes) {
                mix(at, planes, sampling, others, picture);
            }
        }
    });
    if (m_mixes) {
        fillSoftly(m_known, m_coordinates.inverse, pool, threads, picture);
    }
}

DepthImage SurfaceView::depth(const PixelRays& rays, WorkerPool& pool, int threads, DepthImage memory) const {
    DepthImage depth = std::move(memory);
    if (depth.width() != m_width || depth.height() != m_height) {
        depth = DepthImage(m_width, m_height);
    }
    const bool isPinhole = rays.camera().intrinsics().lens == LensModel::Pinhole;
    pool.run(m_height, threads, [&](int y, int) {
        const float* inverse = m_coordinates.inverse.at(0, y);
        float* row = depth.at(0, y);
        for (int x = 0; x < m_width && isPinhole; ++x) {
            row[x] = 1 / inverse[x];
        }
        for (int x = 0; x < m_width && !isPinhole; ++x) {
            const double along = rays.ray(x, y).z();
            const bool isSeen = *m_coordinates.source.at(x, y) != SurfaceCoordinates::kUnseen && along > 0;
            row[x] = isSeen ? static_cast<float>(along / inverse[x]) : std::numeric_limits<float>::infinity();
        }
    });
    return depth;
}

} // namespace spherewalk::render
