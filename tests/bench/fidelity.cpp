// SPDX-License-Identifier: Apache-2.0
#include "fidelity.h"

#include "reference_sampling.h"

#include "spherewalk/base/parallel.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/projection.h"

#include <cmath>

namespace spherewalk::bench {

using Eigen::Vector2d;
using Eigen::Vector3d;
using render::Sampling;

namespace {

std::vector<Vector3d> areaReference(const Source& source, const CameraModel& camera, const Rigid3& pose) {
    const EquirectSize size{source.picture.width(), source.picture.height()};
    const render::Projection projection(camera, pose, {}, size, render::SceneKind::None, 1);
    constexpr int kParts = 8;
    std::vector<Vector3d> result(static_cast<std::size_t>(camera.width() * camera.height()));
    parallelFor(camera.height(), 4, 0, [&](int begin, int end) {
        for (int i = begin * camera.width(); i < end * camera.width(); ++i) {
            Vector3d sum = Vector3d::Zero();
            for (int part = 0; part < kParts * kParts; ++part) {
                const Vector2d offset((part % kParts + 0.5) / kParts - 0.5,
                                      (part / kParts + 0.5) / kParts - 0.5);
                const Vector2d pixel(i % camera.width(), i / camera.width());
                sum += render::bilinear(source.picture, *projection.photoPixel(pixel + offset));
            }
            result[static_cast<std::size_t>(i)] = sum / (kParts * kParts);
        }
    });
    return result;
}

double psnrDb(const std::vector<Vector3d>& expected, const RgbImage& picture) {
    double squares = 0;
    for (int i = 0; i < static_cast<int>(expected.size()); ++i) {
        const std::uint8_t* rgb = picture.at(i % picture.width(), i / picture.width());
        squares += (expected[static_cast<std::size_t>(i)] - Vector3d(rgb[0], rgb[1], rgb[2])).squaredNorm();
    }
    return 10 * std::log10(255.0 * 255.0 * 3 * static_cast<double>(expected.size()) / squares);
}

} // namespace

Rigid3 lookingTo(double yawDeg, double pitchDeg, const Vector3d& at) {
    return {rotation({Degrees(yawDeg), Degrees(-pitchDeg), Degrees(0)}) * bodyFromOptical(), at};
}

std::vector<Fidelity> fidelity(const Source& source, const CameraModel& camera, int directions) {
    std::vector<Fidelity> result(kRungs.size(), {0, 1e9});
    WorkerPool pool;
    render::Workspace workspace;
    RgbImage picture;
    for (int i = 0; i < directions; ++i) {
        // Pitches evenly over +-80 degrees, yaws by the golden angle.
        const Rigid3 pose = lookingTo(137.508 * i, -80 + 160.0 * i / std::max(1, directions - 1));
        const std::vector<Vector3d> expected = areaReference(source, camera, pose);
        for (std::size_t rung = 0; rung < kRungs.size(); ++rung) {
            const Sampling sampling = kRungs[rung];
            const render::RayTable rays(
                camera, samplesPerAxis(sampling, render::minification(camera, source.picture.width())));
            const render::PlaneView plane =
                (sampling == Sampling::Reduced ? source.half : source.plane).view();
            renderView(rays, pose, {plane, {}}, sampling, pool, 0, workspace, picture);
            const double db = psnrDb(expected, picture);
            result[rung].meanDb += db / directions;
            result[rung].worstDb = std::min(result[rung].worstDb, db);
        }
    }
    return result;
}

} // namespace spherewalk::bench
