// SPDX-License-Identifier: GPL-3.0-or-later
#include "transform_tree.h"

#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rigid3.h"

#include <algorithm>
#include <iterator>

namespace spherewalk::ros {

namespace {

constexpr Stamp kKept = std::chrono::seconds(10);
constexpr Stamp kRestart = std::chrono::seconds(1);
constexpr std::size_t kMostFrames = 10000;
constexpr std::size_t kMostSteps = 100; ///< from a frame to its root; more are a ring
constexpr double kUnitTolerance = 0.01;

std::string named(const std::string& frame) {
    return frame.starts_with('/') ? frame.substr(1) : frame;
}

std::optional<Refused> refusalOf(const Transform& transform) {
    const auto& [parent, child, stamp, pose] = transform;
    const auto refused = [&parent = parent, &child = child](simulator::Refusal kind, std::string_view why) {
        return Refused{kind, text("A transform of \"", printable(child), "\" in \"", printable(parent),
                                  "\" came and was not used: ", why)};
    };
    if (named(parent).empty() || named(child).empty() || named(parent) == named(child)) {
        return refused(simulator::Refusal::FrameId,
                       "a frame and its parent have names, and not the same one.");
    }
    if (!isPose({Eigen::Quaterniond::Identity(), pose.translation})) {
        return refused(simulator::Refusal::Place, "its place is not finite, or beyond 10^9 m.");
    }
    if (!isPose(pose, kUnitTolerance)) {
        return refused(simulator::Refusal::Rotation, "its rotation is not a unit quaternion.");
    }
    if (stamp < Stamp::zero()) {
        return refused(simulator::Refusal::Time, "its time is before zero.");
    }
    return std::nullopt;
}

std::optional<Rigid3> poseAt(const std::map<Stamp, Rigid3>& poses, Stamp stamp) {
    const auto after = poses.lower_bound(stamp);
    if (after == poses.end()) {
        return std::nullopt;
    }
    if (after->first == stamp) {
        return after->second;
    }
    if (after == poses.begin()) {
        return std::nullopt;
    }
    const auto before = std::prev(after);
    const double share = static_cast<double>((stamp - before->first).count()) /
                         static_cast<double>((after->first - before->first).count());
    return interpolated(before->second, after->second, share);
}

} // namespace

std::optional<Refused> TransformTree::put(const Transform& transform, bool isStatic) {
    if (std::optional<Refused> refused = refusalOf(transform)) {
        return refused;
    }
    const std::string parent = named(transform.parent);
    const std::string child = named(transform.child);
    const Rigid3& pose = transform.parentFromChild;
    const Stamp stamp = transform.stamp;
    if (!m_frames.contains(child) && m_frames.size() >= kMostFrames) {
        return Refused{simulator::Refusal::FrameId,
                       text("The frame \"", printable(child), "\" came and was not used: there are ",
                            kMostFrames, " already.")};
    }
    cutRing(parent, child);
    Frame& frame = m_frames[child];
    auto& poses = frame.parentFromThis;
    const bool isNewStart = !poses.empty() && stamp + kRestart < poses.rbegin()->first;
    if (isStatic || frame.isStatic || frame.parent != parent || isNewStart) {
        poses.clear();
    }
    frame.parent = parent;
    frame.isStatic = isStatic;
    poses[stamp] = {pose.rotation.normalized(), pose.translation};
    while (poses.begin()->first + kKept < poses.rbegin()->first) {
        poses.erase(poses.begin());
    }
    return std::nullopt;
}

void TransformTree::cutRing(const std::string& parent, const std::string& child) {
    for (const Step& step : up(parent)) {
        if (step.frame->parent == child) {
            m_frames.erase(step.child);
            return;
        }
    }
}

TransformTree::Chain TransformTree::up(const std::string& frame) const {
    Chain chain;
    for (auto it = m_frames.find(frame); it != m_frames.end() && chain.size() < kMostSteps;
         it = m_frames.find(it->second.parent)) {
        chain.push_back({it->first, &it->second});
    }
    return chain;
}

bool TransformTree::connect(const std::string& target, const std::string& source, Chain& down,
                            Chain& rising) const {
    rising = up(source);
    down = up(target);
    const std::string& root = rising.empty() ? source : rising.back().frame->parent;
    if (root != (down.empty() ? target : down.back().frame->parent)) {
        return false;
    }
    while (!rising.empty() && !down.empty() && rising.back().child == down.back().child) {
        rising.pop_back();
        down.pop_back();
    }
    return true;
}

std::optional<Stamp> TransformTree::newest(const std::string& target, const std::string& source) const {
    Chain down;
    Chain rising;
    if (!connect(target, source, down, rising)) {
        return std::nullopt;
    }
    std::optional<Stamp> newest;
    for (const Chain* chain : {&down, &rising}) {
        for (const Step& step : *chain) {
            if (!step.frame->isStatic) {
                const Stamp last = step.frame->parentFromThis.rbegin()->first;
                newest = std::min(newest.value_or(last), last);
            }
        }
    }
    return newest.value_or(Stamp::max());
}

/// The last parent of the chain from its first child.
std::optional<Rigid3> TransformTree::along(const Chain& chain, Stamp stamp) {
    Rigid3 lastFromFirst;
    for (const Step& step : chain) {
        const auto& poses = step.frame->parentFromThis;
        const auto pose = step.frame->isStatic ? poses.begin()->second : poseAt(poses, stamp);
        if (!pose) {
            return std::nullopt;
        }
        lastFromFirst = *pose * lastFromFirst;
    }
    return lastFromFirst;
}

std::optional<Rigid3> TransformTree::at(const std::string& target, const std::string& source,
                                        Stamp stamp) const {
    Chain down;
    Chain rising;
    if (!connect(target, source, down, rising)) {
        return std::nullopt;
    }
    const auto commonFromTarget = along(down, stamp);
    const auto commonFromSource = along(rising, stamp);
    if (!commonFromTarget || !commonFromSource) {
        return std::nullopt;
    }
    return commonFromTarget->inverse() * *commonFromSource;
}

} // namespace spherewalk::ros
