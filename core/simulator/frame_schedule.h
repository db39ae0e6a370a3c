// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/simulator/camera_options.h"

#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <utility>
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
/// whose overlay has come. The stamps are the only clock. With Pace::Every the frames come in the order of
/// their stamps, and one that gets no overlay costs the others nothing: it is given without when its wait is
/// over, or earlier, when 16 later frames have theirs.
///
/// Memory: at most 256 frames are due, and at most 34 overlays (one of each camera) are kept. Beyond that,
/// Pace::Every gives the latest frame without its overlay; Pace::Newest forgets the overlay whose stamp is
/// farthest from the newest pose. Threads: one at a time.
class FrameSchedule {
  public:
    struct Counters {
        std::uint64_t dropped = 0; ///< Also those that waited when time went back.
        std::uint64_t restarts = 0;
        std::uint64_t overlaysUnused = 0;
    };

    /// Owner: the options must outlive the schedule.
    explicit FrameSchedule(const CameraOptions& options, std::size_t cameras = 1)
        : m_options(options), m_cameras(cameras) {}

    /// Range: stamp >= 0, and a pose for each camera. A stamp before the last one is a new start; the same
    /// stamp again is ignored.
    void addPose(Stamp stamp, const RigPose& roomFromCameras, std::chrono::steady_clock::time_point takenAt);

    /// Whether a pose of this stamp would make a frame due.
    bool isDue(Stamp stamp) const;

    /// The parts of a stamp and a camera, to be filled before the next call. Null if other overlays take all
    /// the room. An overlay of a frame that was given already is not used, unless time goes back to it at the
    /// next pose. Range: stamp >= 0.
    OverlayParts* partsOf(Stamp stamp, std::size_t camera = 0);

    /// The next frame, if one can be rendered.
    std::optional<DueFrame> next();

    /// Drops all that waits, as after a new start.
    void clear();

    void forgetOverlays();

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
        bool isGivenUp = false; ///< Its overlay came, and there was no room for it.
    };

    struct Overlay {
        std::vector<OverlayParts> cameras; ///< One a camera.
        Stamp cameAt{};                    ///< The newest pose at that time.
    };

    using Slots = std::map<std::int64_t, Slot>;

    std::int64_t slotOf(Stamp stamp) const;
    std::optional<Pose> poseAt(Stamp stamp) const; ///< Looks among the recent poses.
    std::optional<DueFrame> frameOf(const Slots::value_type& slot);
    std::optional<DueFrame> take(Slots::iterator slot);
    void startAnew(Stamp stamp);
    void forgetOld();
    void forgetOverlaysUpTo(std::int64_t slot);
    Overlay& stray(Stamp stamp);
    /// Whether no frame that is due, or may become due, can have an overlay of this stamp.
    bool fitsNothing(Stamp stamp) const;
    bool waitsInVain(const Slots::value_type& slot) const;
    bool isWhole(const Overlay& overlay) const;

    const CameraOptions& m_options;
    std::size_t m_cameras;
    std::optional<Stamp> m_newest;
    RigPose m_newestPose;                           ///< At m_newest.
    std::optional<Stamp> m_endBefore;               ///< The newest pose before time went back.
    std::optional<std::int64_t> m_lastSlot;         ///< The last slot that was due.
    Slots m_due;                                    ///< Slots at their first poses.
    std::map<Stamp, Pose> m_recent;                 ///< An overlay may still come for these poses.
    std::map<Stamp, Overlay> m_overlays;            ///< Of frames that are due, and of poses to come.
    std::deque<std::pair<Stamp, Overlay>> m_strays; ///< They are late, or time is about to go back.
    Counters m_counters;
};

} // namespace spherewalk::simulator
