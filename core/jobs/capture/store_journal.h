// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/camera/capture_journal.h"
#include "spherewalk/store/survey_store.h"

#include <mutex>

namespace spherewalk::jobs {

/// A survey's store that two threads use in turn. Owner: the store must outlive the object.
class SharedStore {
  public:
    explicit SharedStore(store::SurveyStore& store) : m_store(store) {}

    /// Calls with the store, while no other thread uses it. Returns what the call returns. Range: calls are
    /// never nested.
    template <class Call>
    auto use(Call&& call) {
        const std::scoped_lock lock(m_mutex);
        return call(m_store);
    }

  private:
    store::SurveyStore& m_store;
    std::mutex m_mutex;
};

/// The capture workflow's journal in the survey's store. Threads: one for each journal; journals of several
/// threads may share a store.
class StoreJournal : public camera::CaptureJournal {
  public:
    /// Which open shots openShots() lists. Fetching lists those that can be downloaded while others are
    /// exposed: their URLs differ from those of later files of the same name.
    enum class View { All, Fetching };

    /// Owner: the store must outlive the journal and be open for writing.
    StoreJournal(SharedStore& store, View view) : m_store(store), m_view(view) {}

    survey::Shot begin(std::int64_t station, const std::string& cameraSerial,
                       const survey::Baseline& baseline) override;
    void started(std::int64_t shot, const std::string& commandId) override;
    void taken(std::int64_t shot, const std::string& fileUrl) override;
    void notTaken(std::int64_t shot) override;
    void unclear(std::int64_t shot, const std::string& why, const std::string& fileUrl) override;
    survey::Shot downloaded(std::int64_t shot, const camera::DownloadedPhoto& photo) override;
    std::vector<survey::Shot> openShots() const override;
    std::filesystem::path downloadFolder() const override;

  private:
    SharedStore& m_store;
    View m_view;
};

} // namespace spherewalk::jobs
