// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/image.h"
#include "spherewalk/render/renderer.h"

#include <memory>
#include <optional>

namespace spherewalk::bench {

/// The camera of every measurement: 640 x 480 pixels, no distortion. fieldDeg: horizontal.
CameraModel standardCamera(double fieldDeg);

/// The pose of a camera that is turned to the left and upwards. Frames: from the optical to the panorama
/// frame.
Rigid3 lookingTo(double leftDeg, double upDeg, const Eigen::Vector3d& at = Eigen::Vector3d::Zero());

/// The photo that is decoded and looked at: the dataset's first one. Threads: const, any number.
class BenchPhoto {
  public:
    /// Errors: those of reading and decoding the photo.
    explicit BenchPhoto(const std::shared_ptr<const render::Dataset>& dataset);

    const render::Dataset& dataset() const { return m_renderer.dataset(); }

    /// The dataset's entry of this photo.
    const render::DatasetPhoto& entry() const { return dataset().info().photos[m_index]; }

    const Bytes& jpeg() const { return m_jpeg; }

    /// The whole photo as libjpeg-turbo decodes it.
    const RgbImage& picture() const { return m_picture; }

    /// A renderer whose cache has room for all of the photo and its reduced level.
    const render::Renderer& renderer() const { return m_renderer; }

    /// The radius of the sphere scene model, if the dataset has one.
    std::optional<double> radiusM() const { return dataset().info().sphereRadiusM; }

    /// The scene model that views are timed with, OpenCV's views too.
    render::SceneKind scene() const {
        return radiusM() ? render::SceneKind::Sphere : render::SceneKind::None;
    }

    /// How far a camera can move from the photo while the photo stays the nearest one; infinity for a
    /// dataset of one place.
    double freeM() const { return m_freeM; }

    Rigid3 roomFromCamera(const Rigid3& photoFromCamera) const {
        return entry().roomFromPhoto * photoFromCamera;
    }

  private:
    std::size_t m_index;
    Bytes m_jpeg;
    RgbImage m_picture;
    render::Renderer m_renderer;
    double m_freeM;
};

} // namespace spherewalk::bench
