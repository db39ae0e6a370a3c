// SPDX-License-Identifier: Apache-2.0
#include "camera_tables.h"

#include <algorithm>

namespace spherewalk::render {

namespace {

constexpr std::size_t kCamerasKept = 8;

} // namespace

CameraTable CameraTables::get(const CameraModel& camera, int samplesPerAxis) {
    const std::scoped_lock lock(m_mutex);
    const auto isSameCamera = [&](const Entry& entry) { return entry.camera == camera.intrinsics(); };
    const auto found = std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry& entry) {
        return entry.table.rays->samplesPerAxis() == samplesPerAxis && isSameCamera(entry);
    });
    if (found != m_entries.end()) {
        m_entries.splice(m_entries.begin(), m_entries, found);
        return m_entries.front().table;
    }
    const auto relative = std::find_if(m_entries.begin(), m_entries.end(), isSameCamera);
    CameraTable table{std::make_shared<const RayTable>(camera, samplesPerAxis),
                      relative != m_entries.end() ? relative->table.footprint
                                                  : std::make_shared<const ViewFootprint>(camera)};
    m_entries.push_front({camera.intrinsics(), table});
    if (m_entries.size() > kCamerasKept) {
        m_entries.pop_back();
    }
    return table;
}

} // namespace spherewalk::render
