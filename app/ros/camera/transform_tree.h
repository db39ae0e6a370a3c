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

/// The frames of a robot and their motion, from /tf and /tf_static. It replaces tf2 where the middleware has
/// none. The tree keeps the transforms of the last 10 s and interpolates between them; it does not
/// extrapolate. A new transform that closes a ring removes an older one. Threads: one at a time.
class TransformTree {
  public:
    /// Adds a transform. A stamp more than 1 s before the frame's newest forgets the frame's past, since
    /// simulations are reset. isStatic: the transform holds at all times. A "/" in front of names is dropped.
    /// Returns the reason if the transform is refused: a position that is not finite, a quaternion more than
    /// 1 % off unit length, a time before zero, empty or equal names, or a frame beyond the 10000th.
    std::optional<Refused> put(const Transform& transform, bool isStatic);

    /// The newest time at which all transforms between the two frames are known. Returns Stamp::max() if all
    /// of them are static, and nothing if the frames are not connected.
    std::optional<Stamp> newest(const std::string& target, const std::string& source) const;

    /// targetFromSource at that time. Returns nothing if the frames are not connected, or not known at that
    /// time.
    std::optional<Rigid3> at(const std::string& target, const std::string& source, Stamp stamp) const;

  private:
    struct Frame {
        std::string parent;
        bool isStatic = false;
        std::map<Stamp, Rigid3> parentFromThis; ///< One entry if the frame is static.
    };

    /// A step from a frame towards the root.
    struct Step {
        std::string child;
        const Frame* frame;
    };

    using Chain = std::vector<Step>;

    /// Removes the transform that would close a ring with this one.
    void cutRing(const std::string& parent, const std::string& child);
    Chain up(const std::string& frame) const;
    /// The ways of both frames to their nearest common ancestor. Returns false if there is none.
    bool connect(const std::string& target, const std::string& source, Chain& down, Chain& up) const;
    static std::optional<Rigid3> along(const Chain& chain, Stamp stamp);

    std::map<std::string, Frame> m_frames; ///< By the name of the child.
};

} // namespace spherewalk::ros
