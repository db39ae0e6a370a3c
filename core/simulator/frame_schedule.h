// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/simulator/camera_options.h"

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace spherewalk::simulator {

/// The pose of each camera of a rig at one time: roomFromCamera, of the optical frames. A robot with one
/// camera has one.
using RigPose = std::vector<Rigid3>;

/// The cameras' poses with their stamp.
struct StampedPose {
    Stamp stamp{};
    RigPose roomFromCameras;
};

/// A frame that is due, of all cameras.
struct DueFrame {
    Stamp stamp{};
    RigPose roomFromCameras;
    std::chrono::steady_clock::time_point takenAt;
    std::optional<StampedPose> before;  ///< The poses before; nothing after a start.
    std::vector<OverlayParts> overlays; ///< One a camera; empty if none is wanted or not all came.
};

/// Decides which poses become frames, and with which overlays, as CameraOptions say. Simulation time is cut
/// into slots of 1/rate from its zero. Each slot gives at most one frame: at its first pose, or at the pose
/// whose overlay has come. The stamps are the only clock. Threads: one at a time.
class FrameSchedule {
  public:
    struct Counters {
        std::uint64_t dropped = 0;
        std::uint64_t restarts = 0;
        std::uint64_t overlaysUnused = 0;
    };

    /// Owner: the options must outlive the schedule.
    explicit FrameSchedule(const CameraOptions& options, std::size_t cameras = 1)
        : m_options(options), m_cameras(cameras) {}

    /// Range: stamp >= 0, and a pose for each camera. A stamp before the last one is a new start; the same
    /// stamp again is ignored.
    void addPose(Stamp stamp, const RigPose& roomFromCameras, std::chrono::steady_clock::time_point takenAt);

    /// The parts of a stamp and a camera, to be filled before the next call. Null if the overlays of stamps
    /// nearer to the newest pose take all the room. Range: stamp >= 0.
    OverlayParts* partsOf(Stamp stamp, std::size_t camera = 0);

    /// The next frame, if one can be rendered.
    std::optional<DueFrame> next();

    /// Drops all that waits, as after a new start.
    void clear();

    void forgetOverlays() { m_overlays.clear(); }

    const Counters& counters() const { return m_counters; }

  private:
    struct Pose {
        RigPose roomFromCameras;
        std::chrono::steady_clock::time_point takenAt;
        std::optional<StampedPose> before;
    };

    struct Slot {
        Stamp stamp{};
        Pose pose;
    };

    using Slots = std::map<std::int64_t, Slot>;

    std::int64_t slotOf(Stamp stamp) const;
    std::optional<Pose> poseAt(Stamp stamp) const; ///< Looks among the recent poses.
    std::optional<DueFrame> frameOf(const Slots::value_type& slot);
    std::optional<DueFrame> take(Slots::iterator slot);
    void forgetOld();
    bool isWhole(const std::vector<OverlayParts>& overlays) const;

    const CameraOptions& m_options;
    std::size_t m_cameras;
    std::optional<Stamp> m_newest;
    RigPose m_newestPose;                                  ///< At m_newest.
    std::optional<std::int64_t> m_lastSlot;                ///< The last slot that was due.
    Slots m_due;                                           ///< Slots at their first poses.
    std::map<Stamp, Pose> m_recent;                        ///< An overlay may still come for these poses.
    std::map<Stamp, std::vector<OverlayParts>> m_overlays; ///< One a camera.
    Counters m_counters;
};

} // namespace spherewalk::simulator
