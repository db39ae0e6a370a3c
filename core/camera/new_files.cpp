// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/camera/new_files.h"

#include "spherewalk/base/text.h"
#include "spherewalk/camera/endpoint.h"

namespace spherewalk::camera {

namespace {

/// The camera's address may have changed meanwhile, so that only paths compare. "" if there is no file.
std::string pathAt(const FileList& list, std::size_t index) {
    return index < list.entries.size() ? pathOfUrl(list.entries[index].fileUrl) : std::string();
}

NewFiles doubtful(std::string why) {
    return {NewFiles::Count::Doubtful, {}, std::move(why)};
}

} // namespace

NewFiles newFilesSince(const Baseline& before, const FileList& newest) {
    const std::string latestBefore =
        before.latestFileUrl.empty() ? std::string() : pathOfUrl(before.latestFileUrl);
    const std::string first = pathAt(newest, 0);
    if (newest.totalEntries == before.totalEntries && first == latestBefore) {
        return {};
    }
    if (newest.totalEntries > before.totalEntries + 1) {
        return doubtful(text("The camera holds ", newest.totalEntries - before.totalEntries,
                             " new photos where one was expected: another program or the camera's own button "
                             "took photos as well."));
    }
    const bool grewByOne = newest.totalEntries == before.totalEntries + 1;
    if (grewByOne && !first.empty() && first != latestBefore && pathAt(newest, 1) == latestBefore) {
        return {NewFiles::Count::One, newest.entries.front().fileUrl, {}};
    }
    return doubtful(text("The camera's files have changed in another way than by one photo (",
                         before.totalEntries, " before, ", newest.totalEntries,
                         " now): some were deleted, its file counter was reset, or its storage changed."));
}

} // namespace spherewalk::camera
