// SPDX-License-Identifier: Apache-2.0
#include "sphere/sphere_view.h"

#include "pixels/sampler.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/recently_used.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/panorama.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace spherewalk::render {

namespace {

/// One worker does so many rows of cells in turn: neighbouring rows share their nodes.
constexpr int kRowsInTurn = 3;
/// A view that zooms has a new camera with each step.
constexpr std::size_t kPanoramaCameras = 4;

Rigid3 unitPose(const Rigid3& pose) {
    return {pose.rotation.normalized(), pose.translation};
}

void blackenUnseen(const RayTable::ExplicitCell& cell, const simd::CellSamples& samples) {
    for (int y = 0; y < samples.height; ++y) {
        for (int x = 0; x < samples.width; ++x) {
            if (cell.seen[static_cast<std::size_t>(kCell * y + x)] == 0) {
                std::memset(samples.out + y * samples.pitch + 3 * x, 0, 3);
            }
        }
    }
}

void renderRow(const LatticeFrame& frame, const PlaneView& photo, Sampling sampling, int cellY,
               Workspace::Worker& worker, RgbImage& picture) {
    const RayTable& rays = *frame.rays;
    worker.row.beginRow(frame, cellY);
    const int count = kCell * kCell * rays.samplesPerAxis() * rays.samplesPerAxis();
    const Placing to = simd::placing(photo, sampling);
    int step = 1;
    const auto samples = [&](int cellX) {
        Workspace::Coordinates& at = worker.coordinates[static_cast<std::size_t>(cellX % 2)];
        worker.row.places(frame, cellX, to, at.u.data(), at.v.data());
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
        worker.row = LatticeRow(m_cellsX);
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
    const LatticeFrame frame(rays, roomFromCamera, source.roomFromPhoto, source.photo.size(), source.scene,
                             source.sphereRadiusM);
    const int bands = (rays.cellsY() + kRowsInTurn - 1) / kRowsInTurn;
    pool.run(bands, threads, [&](int band, int index) {
        Workspace::Worker& worker = workspace.worker(index);
        worker.row.restart();
        for (int cellY = kRowsInTurn * band; cellY < std::min(kRowsInTurn * (band + 1), rays.cellsY());
             ++cellY) {
            renderRow(frame, source.photo, sampling, cellY, worker, picture);
        }
    });
}

Panorama::Panorama(const RgbImage& photo) : m_plane(std::make_shared<const PhotoPlane>(photo)) {
}

EquirectSize Panorama::size() const {
    return m_plane->view().size();
}

struct PanoramaRenderer::State {
    explicit State(int threads) : pool(threads) {}

    RecentlyUsed<std::pair<CameraIntrinsics, int>, RayTable> rays{
        kPanoramaCameras}; ///< The key has the samples per axis, too.
    WorkerPool pool;
    Workspace workspace;
};

PanoramaRenderer::PanoramaRenderer(int threads) : m_state(std::make_unique<State>(threads)) {
}

PanoramaRenderer::~PanoramaRenderer() = default;
PanoramaRenderer::PanoramaRenderer(PanoramaRenderer&&) noexcept = default;
PanoramaRenderer& PanoramaRenderer::operator=(PanoramaRenderer&&) noexcept = default;

void PanoramaRenderer::render(const Panorama& photo, const PanoramaScene& scene, const CameraModel& camera,
                              const Rigid3& roomFromCamera, Sampling sampling, RgbImage& picture) {
    const bool isRadius =
        !scene.sphereRadiusM || (std::isfinite(*scene.sphereRadiusM) && *scene.sphereRadiusM > 0);
    if (!isPose(roomFromCamera) || !isPose(scene.roomFromPhoto) || !isRadius) {
        throw Error(ErrorKind::InvalidInput,
                    "A photo cannot be shown: its pose, the camera's, or the sphere's radius is none.");
    }
    if (sampling == Sampling::Auto || sampling == Sampling::Reduced) {
        sampling = Sampling::Bilinear;
    }
    const int samples = samplesPerAxis(sampling, minification(camera, photo.size().width));
    const auto rays =
        m_state->rays.get({camera.intrinsics(), samples}, [&] { return RayTable(camera, samples); });
    const ViewSource source{photo.m_plane->view(), unitPose(scene.roomFromPhoto),
                            scene.sphereRadiusM ? SceneKind::Sphere : SceneKind::None,
                            scene.sphereRadiusM.value_or(1)};
    renderView(*rays, unitPose(roomFromCamera), source, sampling, m_state->pool, 0, m_state->workspace,
               picture);
}

} // namespace spherewalk::render
