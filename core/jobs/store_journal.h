// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/camera/capture_journal.h"
#include "spherewalk/store/survey_store.h"

namespace spherewalk::jobs {

/// The capture workflow's journal, kept in the survey's store.
class StoreJournal : public camera::CaptureJournal {
  public:
    /// Owner: the store must outlive the journal and be open for writing.
    explicit StoreJournal(store::SurveyStore& store) : m_store(store) {}

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
    store::SurveyStore& m_store;
};

} // namespace spherewalk::jobs
