// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/camera/new_files.h"

#include "spherewalk/base/text.h"
#include "spherewalk/camera/endpoint.h"

#include <algorithm>

namespace spherewalk::camera {

namespace {

/// The size, which hardly ever repeats; a time is told in the zone that the camera happens to be set to.
std::string markOf(const FileEntry& entry) {
    if (entry.sizeBytes) {
        return text(*entry.sizeBytes);
    }
    std::string mark = entry.dateTime;
    std::replace(mark.begin(), mark.end(), ' ', '_');
    return mark;
}

/// Whether the file at this place of the list is the newest of before.
bool isLatest(const Baseline& before, const FileList& list, std::size_t index) {
    if (index >= list.entries.size() || before.latestFileUrl.empty()) {
        return index >= list.entries.size() && before.latestFileUrl.empty();
    }
    return isFile(before.latestFileUrl, list.entries[index]);
}

NewFiles doubtful(std::string why) {
    return {NewFiles::Count::Doubtful, {}, std::move(why)};
}

} // namespace

std::string markedUrl(const FileEntry& entry) {
    return text(entry.fileUrl, "#", markOf(entry));
}

bool isMarked(std::string_view url) {
    return url.find('#') != std::string_view::npos;
}

bool isFile(std::string_view url, const FileEntry& entry) {
    const std::size_t mark = url.find('#');
    const bool isSameMark = mark == std::string_view::npos || url.substr(mark + 1) == markOf(entry);
    return isSameMark && pathOfUrl(entry.fileUrl) == pathOfUrl(url);
}

NewFiles newFilesSince(const Baseline& before, const FileList& newest) {
    if (newest.totalEntries == before.totalEntries && isLatest(before, newest, 0)) {
        return {};
    }
    if (newest.totalEntries > before.totalEntries + 1) {
        return doubtful(text("The camera holds ", newest.totalEntries - before.totalEntries,
                             " new photos where one was expected: another program or the camera's own button "
                             "took photos as well."));
    }
    const bool grewByOne = newest.totalEntries == before.totalEntries + 1;
    if (grewByOne && !newest.entries.empty() && !isLatest(before, newest, 0) && isLatest(before, newest, 1)) {
        return {NewFiles::Count::One, newest.entries.front().fileUrl, {}};
    }
    return doubtful(text("The camera's files have changed in another way than by one photo (",
                         before.totalEntries, " before, ", newest.totalEntries,
                         " now): some were deleted, its file counter was reset, or its storage changed."));
}

} // namespace spherewalk::camera
