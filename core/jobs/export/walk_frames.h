// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json_fwd.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/jobs/walk.h"
#include "spherewalk/render/overlay.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace spherewalk::jobs {

/// Makes a walk's frames in the order of the path.
class WalkFrames {
  public:
    /// lights: of the balls; none if they are not lit. Owner: all arguments must outlive the frames.
    WalkFrames(const render::Renderer& renderer, const CameraModel& camera,
               const std::vector<TimedPose>& path, const WalkOptions& options,
               const std::vector<BallLight>& lights);

    /// The next frames are the same as if this one had been made.
    void pass(std::size_t frame);
    const render::View& make(std::size_t frame);

    /// Of the frame that was made last.
    const std::optional<render::SensorReport>& sensorReport() const { return m_sensorReport; }

    const render::StreamCounters& counters() const { return m_stream.counters(); }

  private:
    void makeView(const Rigid3& roomFromCamera, double timeS, bool isMain, render::View& view);
    void layObjects(const Rigid3& roomFromCamera, bool isMain, render::View& view);

    const CameraModel& m_camera;
    const std::vector<TimedPose>& m_path;
    const WalkOptions& m_options;
    const std::vector<BallLight>& m_lights;
    render::ViewStream m_stream;
    render::Composer m_composer;
    WorkerPool m_pool;
    std::optional<render::Sensor> m_sensor;
    std::optional<render::SensorReport> m_sensorReport;
    std::vector<render::Overlay> m_overlays;
    render::View m_view;
};

/// What is known of the objects in all frames, as COCO has it. labels: the pictures of labels, one a frame.
Json annotations(const CameraModel& camera, const std::vector<TimedPose>& path, const WalkOptions& options,
                 const std::vector<std::filesystem::path>& labels);

} // namespace spherewalk::jobs
