// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/simulator/frame.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::gazebo {

/// A pose as a message of Gazebo gives it.
struct NamedPose {
    std::string child;  ///< Name of the posed frame, scoped ("robot::base") or bare ("base").
    std::string parent; ///< Name of the frame of reference; "" on scene topics, which do not tell it.
    simulator::Stamp stamp{};
    Rigid3 parentFromChild;
};

/// Composes the pose of one frame in the world from the poses of its model, its links and itself.
///
/// Frames have scoped names, "robot::base::camera". Poses of the pose-publisher system name their parents:
/// the tree follows them up to a parent without a pose, which is the world. Poses of scene topics name no
/// parents: the tree takes the bare name of each scope in turn.
class PoseTree {
  public:
    explicit PoseTree(std::string frame);

    const std::string& frame() const { return m_frame; }

    /// Adds the poses of a message. Returns the frame's pose if this message completes a stamp, and nothing
    /// otherwise. A stamp is complete when each link that moved at the stamp before has its pose. Other links
    /// keep their last pose.
    std::optional<Rigid3> add(const std::vector<NamedPose>& poses);

    /// Number of stamps in a row, up to the last whole one, without a pose of the frame.
    std::uint64_t missedSteps() const { return m_missedSteps; }

    /// A sentence that says why those stamps gave no pose.
    std::string trouble() const;

  private:
    struct Link {
        std::string parent;
        simulator::Stamp stamp{};
        Rigid3 parentFromChild;
        bool isAmbiguous = false; ///< two of this bare name in one message
    };

    using Chain = std::vector<const Link*>; ///< from the frame upwards

    void put(const NamedPose& pose, bool isFirst);
    std::optional<Chain> chain() const;
    std::optional<Chain> scopedChain() const;
    std::optional<Chain> bareChain() const;
    bool isCurrent(const Link& link) const;

    std::string m_frame;
    std::vector<std::string> m_scopes; ///< of the frame, outermost first
    std::map<std::string, Link, std::less<>> m_links;
    std::optional<simulator::Stamp> m_stamp;
    std::optional<simulator::Stamp> m_stampBefore;
    std::optional<simulator::Stamp> m_given; ///< the last that was complete
    std::uint64_t m_missedSteps = 0;
};

} // namespace spherewalk::gazebo
