// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench_photo.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jpeg/jpeg.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace spherewalk::bench {

using Eigen::Vector3d;

namespace {

render::RendererOptions withRoomFor(const RgbImage& picture) {
    render::RendererOptions options;
    options.cacheBytes = std::max<std::uint64_t>(options.cacheBytes, 2 * picture.values().size());
    return options;
}

double halfWayToNext(const render::DatasetInfo& info, const Vector3d& from) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const render::DatasetPhoto& photo : info.photos) {
        const double distance = (photo.roomFromPhoto.translation - from).norm();
        nearest = distance > 0 ? std::min(nearest, distance) : nearest;
    }
    return nearest / 2;
}

} // namespace

CameraModel standardCamera(double fieldDeg) {
    return CameraModel(CameraIntrinsics::pinhole(640, 480, Radians(Degrees(fieldDeg)).value()));
}

Rigid3 lookingTo(double leftDeg, double upDeg, const Vector3d& at) {
    return {rotation({Degrees(leftDeg), Degrees(-upDeg), Degrees(0)}) * bodyFromOptical(), at};
}

BenchPhoto::BenchPhoto(const std::shared_ptr<const render::Dataset>& dataset)
    : m_index(dataset->nearestPhoto(dataset->info().photos.front().roomFromPhoto.translation)),
      m_jpeg(dataset->readPhoto(m_index)),
      m_picture(jpeg::decode(m_jpeg, dataset->info().photos[m_index].file)),
      m_renderer(dataset, withRoomFor(m_picture)),
      m_freeM(halfWayToNext(dataset->info(), dataset->info().photos[m_index].roomFromPhoto.translation)) {
}

} // namespace spherewalk::bench
