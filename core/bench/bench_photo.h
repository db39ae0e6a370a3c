// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/image.h"
#include "spherewalk/render/renderer.h"

#include <memory>
#include <optional>

namespace spherewalk::measure {

/// The camera of every measurement: 640 x 480 pixels, no distortion.
CameraModel standardCamera(double fieldDeg);

/// Looking so many degrees left and up. Frames: from the optical to the panorama frame.
Rigid3 lookingTo(double leftDeg, double upDeg, const Eigen::Vector3d& at = Eigen::Vector3d::Zero());

/// The photo that is decoded and looked at: the dataset's first. Threads: const, any number.
class Subject {
  public:
    /// Errors: those of reading and decoding the photo.
    explicit Subject(std::shared_ptr<const render::Dataset> dataset);

    const render::Dataset& dataset() const { return m_renderer.dataset(); }

    const render::DatasetPhoto& photo() const { return dataset().info().photos[m_index]; }

    const Bytes& jpeg() const { return m_jpeg; }

    /// All of it, by libjpeg-turbo.
    const RgbImage& picture() const { return m_picture; }

    /// Has room for all of the photo and its reduced level.
    const render::Renderer& renderer() const { return m_renderer; }

    /// Of the sphere scene model, if the dataset has one.
    std::optional<double> radiusM() const { return dataset().info().sphereRadiusM; }

    /// The one that views are timed with, and OpenCV's too.
    render::SceneKind scene() const {
        return radiusM() ? render::SceneKind::Sphere : render::SceneKind::None;
    }

    /// How far a camera can be from the photo and still see no other one; infinity if there is no other.
    double freeM() const { return m_freeM; }

    Rigid3 roomFromCamera(const Rigid3& photoFromCamera) const {
        return photo().roomFromPhoto * photoFromCamera;
    }

  private:
    std::size_t m_index;
    Bytes m_jpeg;
    RgbImage m_picture;
    render::Renderer m_renderer;
    double m_freeM;
};

} // namespace spherewalk::measure
