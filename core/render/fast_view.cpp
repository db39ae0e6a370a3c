// SPDX-License-Identifier: Apache-2.0
#include "fast_view.h"

#include "sampler.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>

namespace spherewalk::render {

namespace {

constexpr int kCell = RayTable::kCell;
constexpr int kBand = 3; ///< rows of cells that one worker does in turn, sharing the nodes between them

void blackenUnseen(const RayTable::ExplicitCell& cell, const simd::CellSamples& samples) {
    for (int y = 0; y < samples.height; ++y) {
        for (int x = 0; x < samples.width; ++x) {
            if (cell.seen[static_cast<std::size_t>(kCell * y + x)] == 0) {
                std::memset(samples.out + y * samples.pitch + 3 * x, 0, 3);
            }
        }
    }
}

void renderRow(const Lattice& lattice, const PlaneView& photo, Sampling sampling, int cellY,
               Workspace::Worker& worker, RgbImage& picture) {
    const RayTable& rays = *lattice.rays;
    worker.lattice.beginRow(lattice, cellY);
    const int count = kCell * kCell * rays.samplesPerAxis() * rays.samplesPerAxis();
    const simd::Rounding round = simd::rounding(sampling);
    const Placing to{photo.stride(), round.u, round.v};
    int step = 1;
    const auto samples = [&](int cellX) {
        Workspace::Coordinates& at = worker.coordinates[static_cast<std::size_t>(cellX % 2)];
        worker.lattice.places(lattice, cellX, to, at.u.data(), at.v.data());
        step = simd::stepToOtherMemory(at.u.data(), count, photo.stride());
        return simd::CellSamples{at.u.data(),
                                 at.v.data(),
                                 rays.samplesPerAxis(),
                                 picture.at(kCell * cellX, kCell * cellY),
                                 std::ptrdiff_t{3} * picture.width(),
                                 std::min(kCell, picture.width() - kCell * cellX),
                                 std::min(kCell, picture.height() - kCell * cellY),
                                 kCell * (cellX + 1) + 2 <= picture.width()};
    };
    // A cell's pixels are on their way from memory while the cell before it is sampled.
    simd::CellSamples next = samples(0);
    for (int cellX = 0; cellX < rays.cellsX(); ++cellX) {
        simd::CellSamples now = next;
        if (cellX + 1 < rays.cellsX()) {
            next = samples(cellX + 1);
            now.next = next.places;
            now.nextStep = step;
        }
        simd::sample(photo, sampling, now);
        if (const RayTable::ExplicitCell* cell = rays.explicitCell(cellX, cellY)) {
            blackenUnseen(*cell, now);
        }
    }
}

} // namespace

double minification(const CameraModel& camera, int photoWidth) {
    const CameraIntrinsics& k = camera.intrinsics();
    const Eigen::Vector2d centre(0.5 * (k.width - 1), 0.5 * (k.height - 1));
    const double perRadian = photoWidth / (2 * std::numbers::pi);
    double most = 0;
    for (const Eigen::Vector2d& step : {Eigen::Vector2d(0.5, 0), Eigen::Vector2d(0, 0.5)}) {
        const auto a = camera.ray(centre - step);
        const auto b = camera.ray(centre + step);
        if (a && b) {
            most = std::max(most, perRadian * (*a - *b).norm());
        }
    }
    return most;
}

int samplesPerAxis(Sampling sampling, double minification) {
    return sampling == Sampling::Footprint
               ? static_cast<int>(std::clamp(std::ceil(minification / 1.5), 2.0, 8.0))
               : 1;
}

double expectedDb(Sampling sampling, double minification) {
    // Of a made-up panorama with details down to the pixel and of a photo of a room, the worst of 40 or 9
    // directions; resources/docs/render.md has the figures.
    struct Row {
        double minification, nearest, bilinear, reduced, footprint, bicubic;
    };

    static constexpr std::array<Row, 6> kMeasured{{{0.47, 32.6, 48.2, 32.5, 58.2, 42.6},
                                                   {0.72, 32.2, 45.2, 32.8, 55.3, 40.7},
                                                   {1.45, 31.5, 40.7, 35.5, 52.4, 36.7},
                                                   {2.05, 31.2, 38.0, 37.5, 50.7, 35.1},
                                                   {2.67, 30.2, 36.1, 37.7, 48.7, 33.5},
                                                   {3.82, 30.9, 35.0, 39.4, 48.7, 33.1}}};
    const auto value = [&](const Row& row) {
        switch (sampling) {
        case Sampling::Nearest:
            return row.nearest;
        case Sampling::Bilinear:
            return row.bilinear;
        case Sampling::Reduced:
            return row.reduced;
        case Sampling::Bicubic:
            return row.bicubic;
        default:
            return row.footprint;
        }
    };
    const auto above = std::find_if(kMeasured.begin(), kMeasured.end(),
                                    [&](const Row& row) { return row.minification >= minification; });
    if (above == kMeasured.begin() || above == kMeasured.end()) {
        return value(above == kMeasured.begin() ? kMeasured.front() : kMeasured.back());
    }
    const Row& below = *(above - 1);
    const double share = (minification - below.minification) / (above->minification - below.minification);
    return value(below) + share * (value(*above) - value(below));
}

Sampling chosenSampling(Sampling sampling, double minification, double toleranceDb) {
    if (sampling != Sampling::Auto) {
        return sampling;
    }
    for (const Sampling rung : {Sampling::Reduced, Sampling::Bilinear}) { // cheapest first
        if (expectedDb(rung, minification) >= toleranceDb) {
            return rung;
        }
    }
    return Sampling::Footprint;
}

void Workspace::prepare(const RayTable& rays, int workers) {
    const std::size_t samples =
        static_cast<std::size_t>(kCell * kCell * rays.samplesPerAxis() * rays.samplesPerAxis());
    if (samples <= m_samples && rays.cellsX() <= m_cellsX && workers <= static_cast<int>(m_workers.size())) {
        return;
    }
    m_samples = std::max(samples, m_samples);
    m_cellsX = std::max(rays.cellsX(), m_cellsX);
    m_workers.clear();
    for (int i = 0; i < std::max(workers, 1); ++i) {
        Worker& worker = m_workers.emplace_back();
        worker.lattice = LatticeScratch(m_cellsX);
        for (Coordinates& coordinates : worker.coordinates) {
            coordinates.u = AlignedBuffer<std::int32_t>(m_samples);
            coordinates.v = AlignedBuffer<std::int32_t>(m_samples);
        }
    }
}

void renderView(const RayTable& rays, const Rigid3& roomFromCamera, const ViewSource& source,
                Sampling sampling, WorkerPool& pool, int threads, Workspace& workspace, RgbImage& picture) {
    if (sampling != Sampling::Footprint && rays.samplesPerAxis() != 1) {
        throw Error(ErrorKind::InvalidInput,
                    text("The sampling ", name(sampling), " takes one sample a pixel, not ",
                         rays.samplesPerAxis(), " x ", rays.samplesPerAxis(), "."));
    }
    if (picture.width() != rays.width() || picture.height() != rays.height()) {
        picture = RgbImage(rays.width(), rays.height());
    }
    workspace.prepare(rays, pool.threads());
    const Lattice lattice(rays, roomFromCamera, source.roomFromPhoto, source.photo.size(), source.scene,
                          source.sphereRadiusM);
    const int bands = (rays.cellsY() + kBand - 1) / kBand;
    pool.run(bands, threads, [&](int band, int index) {
        Workspace::Worker& worker = workspace.worker(index);
        worker.lattice.restart();
        for (int cellY = kBand * band; cellY < std::min(kBand * (band + 1), rays.cellsY()); ++cellY) {
            renderRow(lattice, source.photo, sampling, cellY, worker, picture);
        }
    });
}

} // namespace spherewalk::render
