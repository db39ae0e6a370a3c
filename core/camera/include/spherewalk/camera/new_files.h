// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/camera/capture_journal.h"
#include "spherewalk/camera/osc_messages.h"

#include <string>
#include <string_view>

namespace spherewalk::camera {

/// What the camera's files say about a shot whose answer was lost.
struct NewFiles {
    enum class Count { None, One, Doubtful };

    Count count = Count::None;
    std::string fileUrl; ///< of the one
    std::string why;     ///< what is doubtful, as a sentence
};

/// The file's URL, with its size (or time) as a fragment: names are given again when a camera's counter
/// begins anew.
std::string markedUrl(const FileEntry& entry);
/// Whether the URL tells its file from a later one of the same name.
bool isMarked(std::string_view url);
/// Whether the URL is this file's; an unmarked one goes by the path alone. Errors: those of pathOfUrl().
bool isFile(std::string_view url, const FileEntry& entry);

/// Compares the newest files (at least two, if there are so many) with what was there before the shot. One:
/// the count grew by one, the newest file is new, and the one below it is the newest of before. None: count
/// and newest file are unchanged, in size too if the baseline was marked. Anything else (two new
/// files, files deleted, a counter reset, a storage changed) is doubtful, as a photo must never be attributed
/// to a station by guessing.
NewFiles newFilesSince(const Baseline& before, const FileList& newest);

} // namespace spherewalk::camera
