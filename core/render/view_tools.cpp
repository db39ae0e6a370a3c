// SPDX-License-Identifier: Apache-2.0
#include "view_tools.h"

#include <algorithm>

namespace spherewalk::render {

namespace {

constexpr std::size_t kCamerasKept = 8;
constexpr std::size_t kPlanesKept = 2;

} // namespace

std::shared_ptr<const RayTable> RayTables::get(const CameraModel& camera, int samplesPerAxis) {
    const std::scoped_lock lock(m_mutex);
    const auto found = std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry& entry) {
        return entry.samplesPerAxis == samplesPerAxis && entry.camera == camera.intrinsics();
    });
    if (found != m_entries.end()) {
        m_entries.splice(m_entries.begin(), m_entries, found);
    } else {
        m_entries.push_front(
            {camera.intrinsics(), samplesPerAxis, std::make_shared<const RayTable>(camera, samplesPerAxis)});
        m_entries.resize(std::min(m_entries.size(), kCamerasKept));
    }
    return m_entries.front().table;
}

Planes::Entry& Planes::entry(const std::shared_ptr<const RgbImage>& picture) {
    m_entries.remove_if([](const Entry& entry) { return entry.picture.expired(); });
    const auto found = std::find_if(m_entries.begin(), m_entries.end(),
                                    [&](const Entry& entry) { return entry.picture.lock() == picture; });
    if (found != m_entries.end()) {
        m_entries.splice(m_entries.begin(), m_entries, found);
    } else {
        m_entries.push_front({picture, std::make_shared<const PhotoPlane>(*picture), nullptr});
        m_entries.resize(std::min(m_entries.size(), kPlanesKept));
    }
    return m_entries.front();
}

std::shared_ptr<const PhotoPlane> Planes::whole(const std::shared_ptr<const RgbImage>& picture) {
    const std::scoped_lock lock(m_mutex);
    return entry(picture).whole;
}

std::shared_ptr<const PhotoPlane> Planes::half(const std::shared_ptr<const RgbImage>& picture) {
    const std::scoped_lock lock(m_mutex);
    Entry& found = entry(picture);
    if (!found.half && found.whole->canBeHalved()) {
        found.half = std::make_shared<const PhotoPlane>(found.whole->halved());
    }
    return found.half;
}

} // namespace spherewalk::render
