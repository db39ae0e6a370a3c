// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace spherewalk::store {

/// A photo whose file is not what was recorded.
struct PhotoFinding {
    enum class Kind { Missing, Unreadable, SizeDiffers, BytesDiffer };

    std::int64_t photo = 0;
    std::string fileName;
    Kind kind = Kind::Missing;
    std::string sentence;
};

/// What a check of the whole survey found. Findings are reported, not thrown.
struct SurveyCheck {
    int photosChecked = 0;
    std::vector<PhotoFinding> photos;
    std::vector<std::string> filesWithoutPhoto; ///< names in the photo folder that no photo has
    std::vector<std::string> database;          ///< SQLite's own findings, and broken rules, as sentences

    /// Files without a photo do no harm, and do not count.
    bool isSound() const { return photos.empty() && database.empty(); }
};

} // namespace spherewalk::store
