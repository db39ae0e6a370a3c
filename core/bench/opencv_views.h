// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"

#include <memory>
#include <optional>
#include <string>

namespace spherewalk::bench {

/// The peer of our views: the same views as programs commonly make them with OpenCV, on one thread. Errors of
/// all functions: Internal if OpenCV refuses. Threads: one.
class OpenCvViews {
  public:
    /// radiusM: radius of the sphere scene model; without it there is no scene model. Owner: photo and camera
    /// must outlive this object. OpenCV has one thread while this object lives.
    OpenCvViews(const RgbImage& photo, const CameraModel& camera, std::optional<double> radiusM);
    ~OpenCvViews();
    OpenCvViews(const OpenCvViews&) = delete;
    OpenCvViews& operator=(const OpenCvViews&) = delete;

    /// Computes maps in double precision without needless steps, then a bilinear remap. Frames: camera is
    /// optical. The returned view stays valid until the next call.
    const RgbImage& mapsAndRemap(const Rigid3& photoFromCamera);

    /// Computes and keeps the fixed-point maps of one more pose.
    void keepMaps(const Rigid3& photoFromCamera);

    /// A bilinear remap with the kept maps number `pose` modulo their count. The returned view stays valid
    /// until the next call. Range: at least one pose was kept.
    const RgbImage& remap(int pose);

    /// OpenCV's version, such as "4.6.0".
    static std::string version();

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace spherewalk::bench
