// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/memory_journal.h"

#include "spherewalk/base/digest.h"

#include <gtest/gtest.h>

namespace spherewalk::test {

void MemoryJournal::recorded(const std::string& event) {
    m_log.add(event);
    onRecorded(event);
}

survey::Shot MemoryJournal::begin(std::int64_t station, const std::string& serial,
                                  const survey::Baseline& baseline) {
    for (const survey::Shot& open : openShots()) {
        EXPECT_EQ(open.step, survey::ShotStep::Taken) << "a shot was begun before an earlier one was settled";
    }
    survey::Shot shot;
    shot.id = static_cast<std::int64_t>(shots.size()) + 1;
    shot.station = station;
    shot.intendedAt = m_clock.utc();
    shot.cameraSerial = serial;
    shot.baseline = baseline;
    shots[shot.id] = shot;
    recorded("begin");
    return shot;
}

void MemoryJournal::started(std::int64_t id, const std::string& commandId) {
    EXPECT_EQ(shot(id).step, survey::ShotStep::Intended);
    shot(id).step = survey::ShotStep::Started;
    shot(id).commandId = commandId;
    recorded("started");
}

void MemoryJournal::taken(std::int64_t id, const std::string& fileUrl) {
    EXPECT_TRUE(shot(id).step == survey::ShotStep::Intended || shot(id).step == survey::ShotStep::Started);
    shot(id).step = survey::ShotStep::Taken;
    shot(id).fileUrl = fileUrl;
    recorded("taken");
}

void MemoryJournal::notTaken(std::int64_t id) {
    EXPECT_TRUE(shot(id).step == survey::ShotStep::Intended || shot(id).step == survey::ShotStep::Started);
    shot(id).step = survey::ShotStep::NotTaken;
    recorded("notTaken");
}

void MemoryJournal::unclear(std::int64_t id, const std::string& why, const std::string& fileUrl) {
    EXPECT_TRUE(shot(id).step == survey::ShotStep::Intended || shot(id).step == survey::ShotStep::Started ||
                shot(id).step == survey::ShotStep::Taken);
    shot(id).step = survey::ShotStep::Unclear;
    shot(id).note = why;
    shot(id).fileUrl = fileUrl;
    recorded("unclear");
}

survey::Shot MemoryJournal::downloaded(std::int64_t id, const camera::DownloadedPhoto& photo) {
    EXPECT_EQ(shot(id).step, survey::ShotStep::Taken);
    photos[id] = readFile(photo.temporaryFile);
    EXPECT_EQ(photo.sizeBytes, photos[id].size());
    EXPECT_EQ(photo.cameraSha256, sha256Hex(photos[id]));
    std::filesystem::remove(photo.temporaryFile);
    shot(id).step = survey::ShotStep::Downloaded;
    recorded("downloaded");
    return shot(id);
}

std::vector<survey::Shot> MemoryJournal::openShots() const {
    std::vector<survey::Shot> open;
    for (const auto& [id, shot] : shots) {
        if (shot.step == survey::ShotStep::Intended || shot.step == survey::ShotStep::Started ||
            shot.step == survey::ShotStep::Taken) {
            open.push_back(shot);
        }
    }
    return open;
}

} // namespace spherewalk::test
