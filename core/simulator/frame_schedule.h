// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/simulator/camera_options.h"

#include <map>
#include <optional>

namespace spherewalk::simulator {

/// A frame that is to be rendered now.
struct DueFrame {
    Stamp stamp{};
    Rigid3 roomFromCamera;
    std::chrono::steady_clock::time_point takenAt;
    std::optional<OverlayParts> overlay; ///< nothing: not wanted, or missing
};

/// Which of the poses become frames, and with which overlay, as CameraOptions say. Simulation time is cut
/// into slots of 1/rate, that begin at its zero; each slot gives a frame at most: at its first pose, or at
/// the pose in it whose overlay has come. Knows no clock but the stamps. Threads: one at a time.
class FrameSchedule {
  public:
    struct Counters {
        std::uint64_t dropped = 0;
        std::uint64_t restarts = 0;
        std::uint64_t overlaysUnused = 0;
    };

    /// Owner: refers to the options.
    explicit FrameSchedule(const CameraOptions& options) : m_options(options) {}

    /// Range: stamp >= 0. One that is before the last is a new start, the same again is ignored.
    void addPose(Stamp stamp, const Rigid3& roomFromCamera, std::chrono::steady_clock::time_point takenAt);

    /// The parts of a stamp, to be filled before the next call; null if there is room only for those nearer
    /// to the newest pose. Range: stamp >= 0.
    OverlayParts* partsOf(Stamp stamp);

    /// The frame whose turn it is, if one can be rendered.
    std::optional<DueFrame> next();

    /// Forgets what waits, as after a new start.
    void clear();

    void forgetOverlays() { m_overlays.clear(); }

    const Counters& counters() const { return m_counters; }

  private:
    struct Pose {
        Rigid3 roomFromCamera;
        std::chrono::steady_clock::time_point takenAt;
    };

    struct Slot {
        Stamp stamp{};
        Pose pose;
    };

    using Slots = std::map<std::int64_t, Slot>;

    std::int64_t slotOf(Stamp stamp) const;
    std::optional<DueFrame> frameOf(const Slots::value_type& slot);
    std::optional<DueFrame> take(Slots::iterator slot);
    void forgetOld();

    const CameraOptions& m_options;
    std::optional<Stamp> m_newest;
    std::optional<std::int64_t> m_lastSlot; ///< that was due
    Slots m_due;                            ///< at their first poses
    std::map<Stamp, Pose> m_recent;         ///< poses that an overlay may still come for
    std::map<Stamp, OverlayParts> m_overlays;
    Counters m_counters;
};

} // namespace spherewalk::simulator
