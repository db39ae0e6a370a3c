// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "camera_node.h"

#include "spherewalk/simulator/refusals.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace spherewalk::ros {

struct Refused {
    simulator::Refusal kind = simulator::Refusal::FrameId;
    std::string sentence;
};

/// The frames of a robot and how they move, as /tf and /tf_static tell: what tf2 does, for middleware that
/// has no tf2. Transforms of the last 10 s are kept; between two the pose is interpolated, beyond them there
/// is none. Of transforms that would make a ring the newest
/// hold. Threads: one at a time.
class TransformTree {
  public:
    /// How a frame stands in its parent. A stamp more than a second before the frame's newest is a new start:
    /// simulations are reset. isStatic: at all times. A "/" in front of names is left out. Returns why it was
    /// not used, if so: a place that is not finite, a quaternion more than 1 % off unit length, a time before
    /// zero, names that are empty or the same, a frame beyond the 10000th.
    std::optional<Refused> put(const Transform& transform, bool isStatic);

    /// The newest time at which all between the two frames is known; Stamp::max() if nothing between them
    /// moves. Nothing if they are not connected.
    std::optional<Stamp> newest(const std::string& target, const std::string& source) const;

    /// targetFromSource at that time. Nothing where newest() has none, and for times that are not known.
    std::optional<Rigid3> at(const std::string& target, const std::string& source, Stamp stamp) const;

  private:
    struct Frame {
        std::string parent;
        bool isStatic = false;
        std::map<Stamp, Rigid3> parentFromThis; ///< one if it is static
    };

    /// From a frame up to the root, without the root.
    struct Step {
        std::string child;
        const Frame* frame;
    };

    using Chain = std::vector<Step>;

    /// Takes away what would close a ring with this transform.
    void cutRing(const std::string& parent, const std::string& child);
    Chain up(const std::string& frame) const;
    /// Both ways to the nearest frame in common.
    bool connect(const std::string& target, const std::string& source, Chain& down, Chain& up) const;
    static std::optional<Rigid3> along(const Chain& chain, Stamp stamp);

    std::map<std::string, Frame> m_frames; ///< by the child's name
};

} // namespace spherewalk::ros
