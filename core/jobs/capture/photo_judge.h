// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "capture/store_journal.h"

#include "spherewalk/photo/verdict.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace spherewalk::jobs {

/// Judges photos of a survey against the survey's profile and the photos near them. The store keeps the
/// verdicts. Sketches of the latest photos stay in memory, so that neighbours are not read again.
/// Threads: any, one at a time.
class PhotoJudge {
  public:
    explicit PhotoJudge(SharedStore& store);

    /// The verdict on a photo; the store has it, too.
    ///
    /// Cost: a third of a second for 5376 x 2688 pixels, and a fifth for each neighbour not in memory. Once
    /// in a photo's life it is judged again, when the second photo beside it comes in. Errors: NotFound;
    /// those of reading the file, and of the store. Stop: Stopped, before the photo itself is read.
    photo::Verdict judge(std::int64_t photo, const std::stop_token& stop);

    /// A photo that was judged before others stood beside it, and again with them.
    struct Again {
        store::PhotoRecord photo;
        photo::Verdict before;
        photo::Verdict verdict; ///< The store has it.
    };

    /// Those since the last call.
    std::vector<Again> takeAgain();

  private:
    /// What a photo shows of the place where it was taken.
    struct Standing {
        store::PhotoRecord photo;
        photo::ViewBand band;
    };

    /// A photo near another.
    struct Near {
        store::PhotoRecord photo;
        double distanceM = 0;
    };

    /// Whether too few photos stand beside one: none is near, or no third one tells which of two is right.
    static bool isEarly(const std::vector<Near>& beside);

    photo::JudgedPhoto judgedBeside(const store::PhotoRecord& photo, const std::vector<Near>& beside,
                                    const std::stop_token& stop);
    void judgeEarlyAgain(const std::vector<Near>& photos, const std::stop_token& stop);

    /// As many as a verdict asks for, the nearest first. A photo of unknown place has the others of unknown
    /// places.
    std::vector<Near> neighbours(const store::PhotoRecord& of) const;
    /// Null for a photo that cannot be read.
    std::shared_ptr<const photo::Sketch> sketchOf(const store::PhotoRecord& photo);
    std::shared_ptr<const photo::Sketch> keep(std::int64_t photo, photo::Sketch sketch);
    /// Adds a finding if the camera had not moved since the photo before, which belongs to another station.
    void tellIfUnmoved(Standing standing, photo::Verdict& verdict);
    photo::JudgedPhoto judged(const store::PhotoRecord& photo, std::span<const photo::Neighbour> near) const;

    /// Nothing for a photo that cannot be read.
    std::optional<Standing> standingOf(const store::PhotoRecord& photo) const;

    SharedStore& m_store;
    std::mutex m_mutex;
    photo::ExpectedSettings m_expected;
    std::filesystem::path m_folder;
    std::map<std::int64_t, std::shared_ptr<const photo::Sketch>> m_sketches;
    std::optional<Standing> m_latest;
    std::map<std::int64_t, photo::Verdict> m_early; ///< On photos that were judged beside too few.
    std::vector<Again> m_again;
};

/// The verdict as the store keeps it.
store::PhotoVerdict recordOf(std::int64_t photo, const photo::Verdict& verdict);

} // namespace spherewalk::jobs
