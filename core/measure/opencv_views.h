// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"

#include <memory>
#include <optional>
#include <string>

namespace spherewalk::measure {

/// The peer: the same views as they are commonly made with OpenCV, on one thread. Errors of all functions:
/// Internal, for what OpenCV refuses. Threads: one.
class OpenCvViews {
  public:
    /// Owner: photo and camera must outlive the views. radiusM: of the sphere scene model; nothing: none.
    /// While any of these lives, OpenCV has one thread.
    OpenCvViews(const RgbImage& photo, const CameraModel& camera, std::optional<double> radiusM);
    ~OpenCvViews();
    OpenCvViews(const OpenCvViews&) = delete;
    OpenCvViews& operator=(const OpenCvViews&) = delete;

    /// Maps in double precision with nothing that could be left out, and a bilinear remap. The view stays
    /// valid until the next one.
    const RgbImage& mapsAndRemap(const Rigid3& photoFromCamera);

    /// Keeps the fixed-point maps of one more pose.
    void keepMaps(const Rigid3& photoFromCamera);

    /// A bilinear remap with the kept maps of one pose, modulo their number.
    const RgbImage& remap(int pose);

    static std::string version();

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace spherewalk::measure
