// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame_schedule.h"

#include "spherewalk/geometry/rigid3.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace spherewalk::simulator {

namespace {

// At usual rates, no wait for an overlay makes as many frames due. The overlays bound the memory; half of
// their room is left for those that come while a frame is rendered. The poses suffice for one at each physics
// step of 1 ms during the longest wait of 10 s.
constexpr std::size_t kMostDue = 256;
constexpr std::size_t kMostOverlays = 32;
constexpr std::ptrdiff_t kMostWholeBehind = 16;
constexpr std::size_t kMostStrays = 2;
constexpr std::size_t kMostPoses = 16384;

/// How long an overlay waits for its pose at least, where it may be one from before time went back.
constexpr Stamp kPoseWait = std::chrono::seconds(1);

/// Simulators round 1/30 s to whole nanoseconds, some downwards.
constexpr long double kEarlyNs = 1000;

} // namespace

std::int64_t FrameSchedule::slotOf(Stamp stamp) const {
    if (m_options.rateHz == 0) {
        return stamp.count();
    }
    const auto seconds = (static_cast<long double>(stamp.count()) + kEarlyNs) * 1e-9L;
    return static_cast<std::int64_t>(std::floor(seconds * static_cast<long double>(m_options.rateHz)));
}

void FrameSchedule::clear() {
    m_newest.reset();
    m_endBefore.reset();
    m_lastSlot.reset();
    m_due.clear();
    m_recent.clear();
    forgetOverlays();
}

void FrameSchedule::forgetOverlays() {
    m_overlays.clear();
    m_strays.clear();
}

/// The overlay of the new start's first pose may have come before that pose.
void FrameSchedule::startAnew(Stamp stamp) {
    const Stamp endBefore = *m_newest;
    auto strays = std::move(m_strays);
    m_counters.dropped += m_due.size();
    ++m_counters.restarts;
    clear();
    m_endBefore = endBefore;
    for (auto& [of, overlay] : strays) {
        if (of >= stamp) {
            overlay.cameAt = stamp;
            m_overlays.emplace(of, std::move(overlay));
            --m_counters.overlaysUnused;
        }
    }
}

bool FrameSchedule::isDue(Stamp stamp) const {
    return !m_newest || stamp < *m_newest || (stamp > *m_newest && slotOf(stamp) > *m_lastSlot);
}

void FrameSchedule::addPose(Stamp stamp, const RigPose& roomFromCameras,
                            std::chrono::steady_clock::time_point takenAt) {
    if (m_newest && stamp < *m_newest) {
        startAnew(stamp);
    }
    if (m_newest == stamp) {
        return;
    }
    const Pose pose{roomFromCameras, takenAt,
                    m_newest ? std::optional(StampedPose{*m_newest, m_newestPose}) : std::nullopt};
    m_newest = stamp;
    m_newestPose = roomFromCameras;
    const std::int64_t slot = slotOf(stamp);
    if (!m_lastSlot || slot > *m_lastSlot) {
        m_due.emplace(slot, Slot{stamp, pose});
        m_lastSlot = slot;
    }
    if (m_options.overlay) {
        m_recent.emplace(stamp, pose);
    }
    forgetOld();
}

OverlayParts* FrameSchedule::partsOf(Stamp stamp, std::size_t camera) {
    if (fitsNothing(stamp)) {
        return &stray(stamp).cameras[camera];
    }
    const Stamp now = m_newest.value_or(stamp);
    const auto of = m_overlays.try_emplace(stamp, Overlay{std::vector<OverlayParts>(m_cameras), now}).first;
    if (m_overlays.size() <= kMostOverlays) {
        return &of->second.cameras[camera];
    }
    const auto first = m_overlays.begin();
    const auto last = std::prev(m_overlays.end());
    const bool isEvery = m_options.pace == Pace::Every;
    const auto forgotten = isEvery || last->first - now > now - first->first ? last : first;
    if (const auto slot = m_due.find(slotOf(forgotten->first)); isEvery && slot != m_due.end()) {
        slot->second.isGivenUp = true;
    }
    OverlayParts* const parts = forgotten == of ? nullptr : &of->second.cameras[camera];
    m_overlays.erase(forgotten);
    ++m_counters.overlaysUnused;
    return parts;
}

FrameSchedule::Overlay& FrameSchedule::stray(Stamp stamp) {
    for (auto& [of, overlay] : m_strays) {
        if (of == stamp) {
            return overlay;
        }
    }
    ++m_counters.overlaysUnused;
    if (m_strays.size() == kMostStrays) {
        m_strays.pop_front();
    }
    return m_strays.emplace_back(stamp, Overlay{std::vector<OverlayParts>(m_cameras), *m_newest}).second;
}

bool FrameSchedule::fitsNothing(Stamp stamp) const {
    return m_newest && stamp <= *m_newest && (!m_due.contains(slotOf(stamp)) || !poseAt(stamp));
}

void FrameSchedule::forgetOld() {
    while (m_due.size() > kMostDue) {
        forgetOverlaysUpTo(m_due.begin()->first);
        m_due.erase(m_due.begin());
        ++m_counters.dropped;
    }
    if (!m_options.overlay) {
        return;
    }
    // Frames that are due hold on to the poses since their own.
    const Stamp wait = m_options.overlay->wait;
    const Stamp since = m_due.empty() ? *m_newest : m_due.begin()->second.stamp;
    const Stamp oldest = std::min(since, *m_newest - wait);
    while (!m_recent.empty() && (m_recent.begin()->first < oldest || m_recent.size() > kMostPoses)) {
        m_recent.erase(m_recent.begin());
    }
    const auto isFromBefore = [&](const auto& overlay) {
        const auto& [stamp, of] = overlay;
        return m_endBefore && stamp > *m_newest && stamp - wait <= *m_endBefore &&
               *m_newest - of.cameAt > std::max(wait, kPoseWait);
    };
    m_counters.overlaysUnused += std::erase_if(
        m_overlays, [&](const auto& overlay) { return fitsNothing(overlay.first) || isFromBefore(overlay); });
}

void FrameSchedule::forgetOverlaysUpTo(std::int64_t slot) {
    while (!m_overlays.empty() && slotOf(m_overlays.begin()->first) <= slot) {
        m_overlays.erase(m_overlays.begin());
        ++m_counters.overlaysUnused;
    }
}

std::optional<FrameSchedule::Pose> FrameSchedule::poseAt(Stamp stamp) const {
    const auto after = m_recent.lower_bound(stamp);
    if (after == m_recent.end()) {
        return std::nullopt;
    }
    if (after->first == stamp) {
        return after->second;
    }
    if (!m_options.overlay->interpolatesPoses || after == m_recent.begin()) {
        return std::nullopt;
    }
    const auto before = std::prev(after);
    const double share = static_cast<double>((stamp - before->first).count()) /
                         static_cast<double>((after->first - before->first).count());
    RigPose between;
    for (std::size_t i = 0; i < m_cameras; ++i) {
        between.push_back(
            interpolated(before->second.roomFromCameras[i], after->second.roomFromCameras[i], share));
    }
    return Pose{std::move(between), after->second.takenAt,
                StampedPose{before->first, before->second.roomFromCameras}};
}

bool FrameSchedule::isWhole(const Overlay& overlay) const {
    return std::all_of(overlay.cameras.begin(), overlay.cameras.end(),
                       [this](const OverlayParts& parts) { return parts.isWhole(m_options.overlay->by); });
}

bool FrameSchedule::waitsInVain(const Slots::value_type& slot) const {
    const auto& [number, first] = slot;
    if (first.isGivenUp || *m_newest - first.stamp >= m_options.overlay->wait) {
        return true;
    }
    // Of overlays ahead of all poses, none is known to be of a frame.
    const auto end = m_overlays.upper_bound(*m_newest);
    return std::count_if(m_overlays.begin(), end, [&, after = number](const auto& overlay) {
               return slotOf(overlay.first) > after && isWhole(overlay.second);
           }) >= kMostWholeBehind;
}

std::optional<DueFrame> FrameSchedule::frameOf(const Slots::value_type& slot) {
    const auto& [number, first] = slot;
    if (!m_options.overlay) {
        return DueFrame{first.stamp, first.pose.roomFromCameras, first.pose.takenAt, first.pose.before, {}};
    }
    for (auto it = m_overlays.begin(); it != m_overlays.end(); ++it) {
        if (slotOf(it->first) != number || !isWhole(it->second)) {
            continue;
        }
        if (const std::optional<Pose> pose = poseAt(it->first)) {
            DueFrame frame{it->first, pose->roomFromCameras, pose->takenAt, pose->before,
                           std::move(it->second.cameras)};
            m_overlays.erase(it);
            return frame;
        }
    }
    if (waitsInVain(slot)) {
        return DueFrame{first.stamp, first.pose.roomFromCameras, first.pose.takenAt, first.pose.before, {}};
    }
    return std::nullopt;
}

std::optional<DueFrame> FrameSchedule::next() {
    if (m_options.pace == Pace::Every) {
        return m_due.empty() ? std::nullopt : take(m_due.begin());
    }
    for (auto slot = m_due.end(); slot != m_due.begin();) {
        --slot;
        if (std::optional<DueFrame> frame = take(slot)) {
            return frame;
        }
    }
    return std::nullopt;
}

/// Takes out the slot, and the slots before it, which are late, with all their overlays.
std::optional<DueFrame> FrameSchedule::take(Slots::iterator slot) {
    std::optional<DueFrame> frame = frameOf(*slot);
    if (frame) {
        m_counters.dropped += static_cast<std::uint64_t>(std::distance(m_due.begin(), slot));
        forgetOverlaysUpTo(slot->first);
        m_due.erase(m_due.begin(), std::next(slot));
    }
    return frame;
}

} // namespace spherewalk::simulator
