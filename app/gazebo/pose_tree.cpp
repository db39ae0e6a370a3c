// SPDX-License-Identifier: GPL-3.0-or-later
#include "pose_tree.h"

#include "spherewalk/base/text.h"

#include <algorithm>
#include <set>
#include <utility>

namespace spherewalk::gazebo {

namespace {

constexpr std::string_view kScope = "::";
constexpr std::size_t kMostLinks = 4096; ///< of the world, that are remembered
constexpr std::size_t kDeepest = 32;
constexpr std::size_t kNamesTold = 8;

std::vector<std::string> scopesOf(const std::string& frame) {
    std::vector<std::string> scopes;
    std::size_t begin = 0;
    for (std::size_t end = 0; end != std::string::npos; begin = end + kScope.size()) {
        end = frame.find(kScope, begin);
        scopes.push_back(frame.substr(begin, end - begin));
    }
    return scopes;
}

} // namespace

PoseTree::PoseTree(std::string frame) : m_frame(std::move(frame)), m_scopes(scopesOf(m_frame)) {
}

std::optional<Rigid3> PoseTree::add(const std::vector<NamedPose>& poses) {
    std::set<std::string_view> seen;
    for (const NamedPose& pose : poses) {
        put(pose, seen.insert(pose.child).second);
    }
    if (m_given == m_stamp) {
        return std::nullopt;
    }
    const std::optional<Chain> links = chain();
    if (!links ||
        !std::all_of(links->begin(), links->end(), [this](auto* link) { return isCurrent(*link); }) ||
        std::none_of(links->begin(), links->end(), [this](auto* link) { return link->stamp == m_stamp; })) {
        return std::nullopt;
    }
    m_given = m_stamp;
    Rigid3 worldFromFrame;
    for (const Link* link : *links) {
        worldFromFrame = link->parentFromChild * worldFromFrame;
    }
    return worldFromFrame;
}

void PoseTree::put(const NamedPose& pose, bool isFirst) {
    if (m_stamp != pose.stamp) {
        m_missedSteps = m_stamp && m_given != m_stamp ? m_missedSteps + 1 : 0;
        const bool isBack = m_stamp && pose.stamp < *m_stamp;
        if (isBack) {
            m_links.clear();
            m_given.reset();
        }
        m_stampBefore = isBack ? std::nullopt : m_stamp;
        m_stamp = pose.stamp;
    }
    if (m_links.size() >= kMostLinks && !m_links.contains(pose.child)) {
        return;
    }
    m_links[pose.child] = {pose.parent, pose.stamp, pose.parentFromChild, !isFirst};
}

/// Either of this stamp, or it did not move at the stamp before either.
bool PoseTree::isCurrent(const Link& link) const {
    return link.stamp == m_stamp || link.stamp != m_stampBefore;
}

std::optional<PoseTree::Chain> PoseTree::chain() const {
    return m_links.contains(m_frame) && !m_links.find(m_frame)->second.parent.empty() ? scopedChain()
                                                                                      : bareChain();
}

std::optional<PoseTree::Chain> PoseTree::scopedChain() const {
    Chain chain;
    std::string_view name = m_frame;
    for (auto link = m_links.find(name); link != m_links.end(); link = m_links.find(name)) {
        if (chain.size() >= kDeepest || link->second.isAmbiguous) {
            return std::nullopt;
        }
        chain.push_back(&link->second);
        name = link->second.parent;
    }
    // A model or link about whose own place nothing is known is not the world.
    const bool isScope = m_frame.starts_with(std::string(name) + std::string(kScope));
    return isScope ? std::nullopt : std::optional(chain);
}

std::optional<PoseTree::Chain> PoseTree::bareChain() const {
    Chain chain;
    for (auto scope = m_scopes.rbegin(); scope != m_scopes.rend(); ++scope) {
        const auto link = m_links.find(*scope);
        if (link == m_links.end() || link->second.isAmbiguous || !link->second.parent.empty()) {
            return std::nullopt;
        }
        chain.push_back(&link->second);
    }
    return chain;
}

std::string PoseTree::trouble() const {
    for (const std::string& name : m_scopes) {
        const auto link = m_links.find(name);
        if (link != m_links.end() && link->second.isAmbiguous) {
            return text("More than one thing is called ", printable(name), ", so the place of ",
                        printable(m_frame), " is not known; use the topic of a pose publisher.");
        }
    }
    std::string names;
    for (const auto& [name, link] : m_links) {
        names += text(names.empty() ? "" : ", ", printable(name));
        if (names.size() > kNamesTold * 20) {
            names += ", ...";
            break;
        }
    }
    return text(
        "The poses that came do not say where ", printable(m_frame), " is in the world; they are of ",
        names.empty() ? "nothing" : names,
        ". Name one of them with its scopes, and let the pose publisher publish the model's pose too.");
}

} // namespace spherewalk::gazebo
