// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/camera/capture_journal.h"

#include <filesystem>

namespace spherewalk::cli {

/// The journal of one picture that belongs to no survey: the steps are kept in memory only, and the picture
/// is put where the user wants it.
class SingleShot : public camera::CaptureJournal {
  public:
    explicit SingleShot(std::filesystem::path out) : m_out(std::move(out)) {}

    camera::Shot begin(std::int64_t station, const std::string& cameraSerial,
                       const camera::Baseline& baseline) override;
    void started(std::int64_t shot, const std::string& commandId) override;
    void taken(std::int64_t shot, const std::string& fileUrl) override;
    void notTaken(std::int64_t shot) override;
    void unclear(std::int64_t shot, const std::string& why) override;
    void downloaded(std::int64_t shot, const camera::DownloadedPhoto& photo) override;
    std::vector<camera::Shot> openShots() const override;
    std::filesystem::path downloadFolder() const override;

  private:
    std::filesystem::path m_out;
    camera::Shot m_shot;
};

} // namespace spherewalk::cli
