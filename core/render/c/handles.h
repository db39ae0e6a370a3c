// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/light.h"
#include "spherewalk/render/light_probe.h"
#include "spherewalk/render/sensor.h"
#include "spherewalk/render/view_stream.h"
#include "spherewalk/sensor.h"

#include <memory>
#include <mutex>
#include <vector>

/// The objects behind the handles of the C interface, and the parts of a view that its caller gives and gets.
namespace spherewalk::render {

/// Memory that the next view uses again.
struct ViewMemory {
    View view;
    std::vector<Overlay> overlays;
};

/// The C++ form of a view's options. options: may be NULL. camera: the view's camera. overlays: they get the
/// options' overlays, and must live as long as the result. Errors: InvalidInput for values without a meaning.
ViewOptions viewOptions(const spherewalk_view_options* options, const CameraIntrinsics& camera,
                        std::vector<Overlay>& overlays);

/// The caller's memory for a view and its report.
class ViewTarget {
  public:
    /// report: may be NULL. Errors: InvalidInput, before anything is rendered, for structs of unknown
    /// versions and buffers that are too small.
    ViewTarget(const spherewalk_view* view, spherewalk_report* report, const CameraIntrinsics& camera);

    /// Asks for the parts of the view that the caller has memory for.
    void want(ViewOptions& options) const;

    /// Copies the view and its report to the caller's memory.
    void fill(const View& view) const;

  private:
    spherewalk_view m_view;
    spherewalk_report* m_report;
    int m_width;
    int m_height;
};

/// The C++ form of a probe's options. options: may be NULL. Errors: InvalidInput for numbers without a
/// meaning.
ProbeOptions probeOptions(const spherewalk_probe_options* options);

/// The caller's memory for a probe and for what it says.
class ProbeTarget {
  public:
    /// probe, light: may be NULL. Errors: as ViewTarget.
    ProbeTarget(const spherewalk_probe* probe, spherewalk_light* light, int width);

    /// Copies the probe to the caller's memory.
    void fill(const LightProbe& probe) const;

  private:
    spherewalk_probe m_probe;
    spherewalk_light* m_light;
};

} // namespace spherewalk::render

struct spherewalk_dataset {
    std::shared_ptr<const spherewalk::render::Dataset> dataset;
    bool isVerified; ///< Whether all hashes were checked.
};

struct spherewalk_camera {
    spherewalk::CameraModel model;
};

struct spherewalk_renderer {
    spherewalk::render::Renderer renderer;
    mutable std::mutex inUse{}; ///< It guards `spare`.
    mutable spherewalk::render::ViewMemory spare{};
};

struct spherewalk_sensor {
    spherewalk::render::Sensor sensor;
    std::mutex inUse{};
};

struct spherewalk_stream {
    spherewalk::render::ViewStream stream;
    spherewalk::CameraIntrinsics camera;
    std::mutex inUse{};
    spherewalk::render::ViewMemory spare{};
};
