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

/// A pose as Gazebo says it.
struct NamedPose {
    std::string child;  ///< what it is of: scoped ("robot::base") or bare ("base")
    std::string parent; ///< what it is relative to; "" if the message does not say, as on scene topics
    simulator::Stamp stamp{};
    Rigid3 parentFromChild;
};

/// The world's pose of one frame, put together from poses of it, its link, its model, each relative to the
/// one above.
///
/// Frames are named with their scopes, "robot::base::camera". Poses that name their parents (the
/// pose-publisher system) are followed upwards until a parent of which no pose comes, which is the world.
/// Poses that do not (the scene's topics) are told by the bare names of the scopes in turn.
class PoseTree {
  public:
    explicit PoseTree(std::string frame);

    const std::string& frame() const { return m_frame; }

    /// Adds the poses of a message. What comes back is the frame's pose, if this message completes it for its
    /// stamp: all that moved at the stamp before have come. What stood still at the stamp before keeps its
    /// pose.
    std::optional<Rigid3> add(const std::vector<NamedPose>& poses);

    /// How many stamps in a row, up to the last whole one, gave no pose.
    std::uint64_t missedSteps() const { return m_missedSteps; }

    /// Why they did not, as a sentence.
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
