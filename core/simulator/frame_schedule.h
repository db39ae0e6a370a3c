// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/simulator/camera_options.h"

#include <map>
#include <optional>

namespace spherewalk::simulator {

/// A pose with its stamp.
struct StampedPose {
    Stamp stamp{};
    Rigid3 roomFromCamera;
};

/// A frame that is due.
struct DueFrame {
    Stamp stamp{};
    Rigid3 roomFromCamera;
    std::chrono::steady_clock::time_point takenAt;
    std::optional<StampedPose> before;   ///< The pose before; nothing after a start.
    std::optional<OverlayParts> overlay; ///< Nothing if no overlay is wanted or none came.
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
    explicit FrameSchedule(const CameraOptions& options) : m_options(options) {}

    /// Range: stamp >= 0. A stamp before the last one is a new start; the same stamp again is ignored.
    void addPose(Stamp stamp, const Rigid3& roomFromCamera, std::chrono::steady_clock::time_point takenAt);

    /// The parts of a stamp, to be filled before the next call. Null if the overlays of stamps nearer to the
    /// newest pose take all the room. Range: stamp >= 0.
    OverlayParts* partsOf(Stamp stamp);

    /// The next frame, if one can be rendered.
    std::optional<DueFrame> next();

    /// Drops all that waits, as after a new start.
    void clear();

    void forgetOverlays() { m_overlays.clear(); }

    const Counters& counters() const { return m_counters; }

  private:
    struct Pose {
        Rigid3 roomFromCamera;
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

    const CameraOptions& m_options;
    std::optional<Stamp> m_newest;
    Rigid3 m_newestPose;                    ///< At m_newest.
    std::optional<std::int64_t> m_lastSlot; ///< The last slot that was due.
    Slots m_due;                            ///< Slots at their first poses.
    std::map<Stamp, Pose> m_recent;         ///< An overlay may still come for these poses.
    std::map<Stamp, OverlayParts> m_overlays;
    Counters m_counters;
};

} // namespace spherewalk::simulator
