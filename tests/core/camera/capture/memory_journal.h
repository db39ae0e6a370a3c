// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "capture/event_log.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/file.h"
#include "spherewalk/camera/capture_journal.h"

#include <functional>
#include <map>

namespace spherewalk::test {

/// Keeps shots in memory across "restarts" of the workflow, and checks that their steps go forward.
class MemoryJournal : public camera::CaptureJournal {
  public:
    MemoryJournal(Clock& clock, EventLog& log, std::filesystem::path folder)
        : m_clock(clock), m_log(log), m_folder(std::move(folder)) {}

    survey::Shot begin(std::int64_t station, const std::string& serial,
                       const survey::Baseline& baseline) override;
    void started(std::int64_t shot, const std::string& commandId) override;
    void taken(std::int64_t shot, const std::string& fileUrl) override;
    void notTaken(std::int64_t shot) override;
    void unclear(std::int64_t shot, const std::string& why, const std::string& fileUrl) override;
    survey::Shot downloaded(std::int64_t shot, const camera::DownloadedPhoto& photo) override;
    std::vector<survey::Shot> openShots() const override;

    std::filesystem::path downloadFolder() const override { return m_folder; }

    /// Called after each record; throwing from it is the program's death at that instant.
    std::function<void(const std::string& event)> onRecorded = [](const std::string&) {};
    std::map<std::int64_t, survey::Shot> shots;
    std::map<std::int64_t, Bytes> photos; ///< by shot

  private:
    survey::Shot& shot(std::int64_t id) { return shots.at(id); }

    void recorded(const std::string& event);

    Clock& m_clock;
    EventLog& m_log;
    std::filesystem::path m_folder;
};

} // namespace spherewalk::test
