// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/panorama.h"

#include "fast_view.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/recently_used.h"
#include "spherewalk/geometry/pose_check.h"

#include <cmath>
#include <utility>

namespace spherewalk::render {

namespace {

constexpr std::size_t kCamerasKept = 4; ///< a view that zooms has a new one with each step

Rigid3 normalized(const Rigid3& pose) {
    return {pose.rotation.normalized(), pose.translation};
}

} // namespace

Panorama::Panorama(const RgbImage& photo) : m_plane(std::make_shared<const PhotoPlane>(photo)) {
}

EquirectSize Panorama::size() const {
    return m_plane->view().size();
}

struct PanoramaRenderer::State {
    explicit State(int threads) : pool(threads) {}

    RecentlyUsed<std::pair<CameraIntrinsics, int>, RayTable> rays{kCamerasKept}; ///< by samples per axis
    WorkerPool pool;
    Workspace workspace;
};

PanoramaRenderer::PanoramaRenderer(int threads) : m_state(std::make_unique<State>(threads)) {
}

PanoramaRenderer::~PanoramaRenderer() = default;
PanoramaRenderer::PanoramaRenderer(PanoramaRenderer&&) noexcept = default;
PanoramaRenderer& PanoramaRenderer::operator=(PanoramaRenderer&&) noexcept = default;

void PanoramaRenderer::render(const Panorama& photo, const PanoramaPlace& place, const CameraModel& camera,
                              const Rigid3& roomFromCamera, Sampling sampling, RgbImage& picture) {
    const bool isRadius =
        !place.sphereRadiusM || (std::isfinite(*place.sphereRadiusM) && *place.sphereRadiusM > 0);
    if (!isPose(roomFromCamera) || !isPose(place.roomFromPhoto) || !isRadius) {
        throw Error(ErrorKind::InvalidInput,
                    "A photo cannot be shown: its pose, the camera's, or the sphere's radius is none.");
    }
    if (sampling == Sampling::Auto || sampling == Sampling::Reduced) {
        sampling = Sampling::Bilinear;
    }
    const int samples = samplesPerAxis(sampling, minification(camera, photo.size().width));
    const auto rays =
        m_state->rays.get({camera.intrinsics(), samples}, [&] { return RayTable(camera, samples); });
    const ViewSource source{photo.m_plane->view(), normalized(place.roomFromPhoto),
                            place.sphereRadiusM ? SceneKind::Sphere : SceneKind::None,
                            place.sphereRadiusM.value_or(1)};
    renderView(*rays, normalized(roomFromCamera), source, sampling, m_state->pool, 0, m_state->workspace,
               picture);
}

} // namespace spherewalk::render
