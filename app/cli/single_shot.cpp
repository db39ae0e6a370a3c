// SPDX-License-Identifier: GPL-3.0-or-later
#include "single_shot.h"

namespace spherewalk::cli {

using camera::ShotStep;

camera::Shot SingleShot::begin(std::int64_t station, const std::string& cameraSerial,
                               const camera::Baseline& baseline) {
    m_shot = {};
    m_shot.id = 1;
    m_shot.station = station;
    m_shot.intendedAt = std::chrono::system_clock::now();
    m_shot.cameraSerial = cameraSerial;
    m_shot.baseline = baseline;
    return m_shot;
}

void SingleShot::started(std::int64_t /*shot*/, const std::string& commandId) {
    m_shot.step = ShotStep::Started;
    m_shot.commandId = commandId;
}

void SingleShot::taken(std::int64_t /*shot*/, const std::string& fileUrl) {
    m_shot.step = ShotStep::Taken;
    m_shot.fileUrl = fileUrl;
}

void SingleShot::notTaken(std::int64_t /*shot*/) {
    m_shot.step = ShotStep::NotTaken;
}

void SingleShot::unclear(std::int64_t /*shot*/, const std::string& why) {
    m_shot.step = ShotStep::Unclear;
    m_shot.note = why;
}

void SingleShot::downloaded(std::int64_t /*shot*/, const camera::DownloadedPhoto& photo) {
    std::filesystem::rename(photo.temporaryFile, m_out);
    m_shot.step = ShotStep::Downloaded;
}

std::vector<camera::Shot> SingleShot::openShots() const {
    const bool isOpen = m_shot.id != 0 && m_shot.step <= ShotStep::Taken;
    return isOpen ? std::vector<camera::Shot>{m_shot} : std::vector<camera::Shot>{};
}

std::filesystem::path SingleShot::downloadFolder() const {
    return m_out.has_parent_path() ? m_out.parent_path() : std::filesystem::path(".");
}

} // namespace spherewalk::cli
