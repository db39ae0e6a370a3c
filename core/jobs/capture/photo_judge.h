// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shared_store.h"

#include "spherewalk/photo/verdict.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <stop_token>
#include <vector>

namespace spherewalk::jobs {

/// Judges photos of a survey against the survey's profile and the photos near them, and keeps the verdicts in
/// the store. What was seen of the latest photos stays in memory, so that neighbours are not read again.
/// Threads: any.
class PhotoJudge {
  public:
    explicit PhotoJudge(SharedStore& store);

    /// Errors: NotFound; those of reading the file; those of the store; Stopped, before the photo itself is
    /// looked at. Cost: a third of a second for 5376 x 2688 pixels, and a fifth for each neighbour that is
    /// not in memory.
    photo::Verdict judge(std::int64_t photo, const std::stop_token& stop);

  private:
    std::vector<store::PhotoRecord> neighbours(const store::PhotoRecord& of) const;
    /// Null for one that cannot be read.
    std::shared_ptr<const photo::Sketch> sketchOf(const store::PhotoRecord& photo);
    std::shared_ptr<const photo::Sketch> keep(std::int64_t photo, photo::Sketch sketch);
    photo::JudgedPhoto judged(const store::PhotoRecord& photo, std::span<const photo::Neighbour> near) const;

    SharedStore& m_store;
    std::mutex m_mutex;
    photo::ExpectedSettings m_expected;
    std::filesystem::path m_folder;
    std::map<std::int64_t, std::shared_ptr<const photo::Sketch>> m_sketches;
};

/// As the store keeps it.
store::PhotoVerdict recordOf(std::int64_t photo, const photo::Verdict& verdict);

} // namespace spherewalk::jobs
