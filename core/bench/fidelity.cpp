// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench_photo.h"
#include "measurements.h"
#include "sphere/exact_view.h"

#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::bench {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr int kParts = 8;
constexpr double kGoldenAngleDeg = 137.508;
constexpr double kMostPitchDeg = 80;
constexpr double kEqualDb = 100; // JSON has no infinity

class Reference {
  public:
    Reference(const BenchPhoto& photo, const CameraModel& camera, int pixelStep)
        : m_photo(photo), m_camera(camera), m_step(pixelStep) {}

    std::vector<Vector3d> values(const Rigid3& photoFromCamera, const std::stop_token& stop) const {
        const RgbImage& picture = m_photo.picture();
        const render::Projection projection(m_camera, photoFromCamera, {},
                                            {picture.width(), picture.height()}, render::SceneKind::None, 1);
        const int columns = (m_camera.width() + m_step - 1) / m_step;
        const int rows = (m_camera.height() + m_step - 1) / m_step;
        std::vector<Vector3d> result(static_cast<std::size_t>(columns * rows));
        parallelFor(rows, 1, 0, [&](int row, int /*end*/) {
            throwIfStopped(stop);
            for (int column = 0; column < columns; ++column) {
                result[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                       static_cast<std::size_t>(column)] =
                    mean(projection, Vector2d(column * m_step, row * m_step));
            }
        });
        return result;
    }

  private:
    Vector3d mean(const render::Projection& projection, const Vector2d& pixel) const {
        Vector3d sum = Vector3d::Zero();
        for (int part = 0; part < kParts * kParts; ++part) {
            const int row = part / kParts;
            const Vector2d offset((part % kParts + 0.5) / kParts - 0.5, (row + 0.5) / kParts - 0.5);
            sum += render::bilinear(m_photo.picture(), *projection.photoPixel(pixel + offset));
        }
        return sum / (kParts * kParts);
    }

    const BenchPhoto& m_photo;
    const CameraModel& m_camera;
    int m_step;
};

} // namespace

double psnrDb(const std::vector<Vector3d>& expected, const RgbImage& picture, int pixelStep) {
    const int columns = (picture.width() + pixelStep - 1) / pixelStep;
    double squares = 0;
    for (int i = 0; i < static_cast<int>(expected.size()); ++i) {
        const std::uint8_t* rgb = picture.at(i % columns * pixelStep, i / columns * pixelStep);
        squares += (expected[static_cast<std::size_t>(i)] - Vector3d(rgb[0], rgb[1], rgb[2])).squaredNorm();
    }
    const double mean = squares / (3 * static_cast<double>(expected.size()));
    return std::min(kEqualDb, 10 * std::log10(255.0 * 255.0 / mean));
}

std::vector<RungFidelity> measureFidelity(const BenchPhoto& photo, double fieldDeg,
                                          const FidelityOptions& options, ProgressSink& progress,
                                          const std::stop_token& stop) {
    const CameraModel camera = standardCamera(fieldDeg);
    const Reference reference(photo, camera, options.pixelStep);
    std::vector<RungFidelity> result;
    result.reserve(std::size(kRungs));
    for (const render::Sampling rung : kRungs) {
        result.push_back({rung, fieldDeg, 0, kEqualDb});
    }
    render::View view;
    for (int i = 0; i < options.directions; ++i) {
        const double pitch = kMostPitchDeg * (2.0 * i / std::max(1, options.directions - 1) - 1);
        const Rigid3 photoFromCamera = lookingTo(kGoldenAngleDeg * i, pitch);
        const std::vector<Vector3d> expected = reference.values(photoFromCamera, stop);
        for (RungFidelity& rung : result) {
            render::ViewOptions wanted;
            wanted.sampling = rung.rung;
            photo.renderer().render(camera, photo.roomFromCamera(photoFromCamera), wanted, view);
            const double db = psnrDb(expected, view.picture, options.pixelStep);
            rung.meanDb += db / options.directions;
            rung.worstDb = std::min(rung.worstDb, db);
        }
        progress.progress(static_cast<double>(i + 1) / options.directions,
                          text("Comparing views at ", fieldDeg, " degrees with exact ones"));
    }
    return result;
}

} // namespace spherewalk::bench
