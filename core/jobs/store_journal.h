// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shared_store.h"

#include "spherewalk/camera/capture_journal.h"

namespace spherewalk::jobs {

/// The capture workflow's journal, kept in the survey's store. Threads: one each, side by side.
class StoreJournal : public camera::CaptureJournal {
  public:
    /// Whose open shots are told: all, or those that can be downloaded while others are exposed, which their
    /// URLs tell from later files of the same name.
    enum class View { All, Fetching };

    /// Owner: the store must outlive the journal and be open for writing.
    StoreJournal(SharedStore& store, View view) : m_store(store), m_view(view) {}

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
    SharedStore& m_store;
    View m_view;
};

} // namespace spherewalk::jobs
