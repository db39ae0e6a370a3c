// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/text.h"
#include "spherewalk/camera/endpoint.h"
#include "spherewalk/camera/shot_settler.h"

#include <gtest/gtest.h>

namespace spherewalk::camera {
namespace {

std::string url(int number) {
    return text("http://192.168.1.1/files/100RICOH/R", number, ".JPG");
}

survey::Baseline before(int latest, int total) {
    return {latest == 0 ? "" : url(latest), total};
}

/// The newest files, newest first.
FileList now(std::vector<int> newest, int total) {
    FileList list;
    for (const int number : newest) {
        FileEntry entry;
        entry.fileUrl = url(number);
        list.entries.push_back(entry);
    }
    list.totalEntries = total;
    return list;
}

TEST(NewFiles, NoneIfNothingChanged) {
    EXPECT_EQ(newFilesSince(before(5, 7), now({5, 4}, 7)).count, NewFiles::Count::None);
    EXPECT_EQ(newFilesSince(before(0, 0), now({}, 0)).count, NewFiles::Count::None);
}

TEST(NewFiles, OneIfItStandsAboveTheOldNewest) {
    const NewFiles found = newFilesSince(before(5, 7), now({6, 5}, 8));
    EXPECT_EQ(found.count, NewFiles::Count::One);
    EXPECT_EQ(found.fileUrl, url(6));
    EXPECT_EQ(newFilesSince(before(0, 0), now({1}, 1)).count, NewFiles::Count::One);
}

TEST(NewFiles, IgnoresTheAddressOfTheCamera) {
    survey::Baseline moved = before(5, 7);
    moved.latestFileUrl = "http://10.0.0.7:8080/files/100RICOH/R5.JPG";
    EXPECT_EQ(newFilesSince(moved, now({5, 4}, 7)).count, NewFiles::Count::None);
    EXPECT_EQ(newFilesSince(moved, now({6, 5}, 8)).count, NewFiles::Count::One);
}

TEST(NewFiles, TellsAFileFromAnotherOfItsName) {
    FileEntry entry;
    entry.fileUrl = url(5);
    entry.sizeBytes = 4'000'000;
    entry.dateTime = "2026:01:02 03:04:05+00:00";
    FileEntry later = entry;
    later.sizeBytes = 4'000'001;
    EXPECT_TRUE(isFile(markedUrl(entry), entry));
    EXPECT_FALSE(isFile(markedUrl(entry), later));
    EXPECT_TRUE(isFile(url(5), later));
    EXPECT_EQ(pathOfUrl(markedUrl(entry)), "/files/100RICOH/R5.JPG");
    FileList list = now({}, 7);
    list.entries = {later};
    EXPECT_EQ(newFilesSince({markedUrl(entry), 7}, list).count, NewFiles::Count::Doubtful);
    list.entries = {entry};
    EXPECT_EQ(newFilesSince({markedUrl(entry), 7}, list).count, NewFiles::Count::None);
}

TEST(NewFiles, DoubtfulIfSeveralAreNew) {
    const NewFiles found = newFilesSince(before(5, 7), now({7, 6}, 9));
    EXPECT_EQ(found.count, NewFiles::Count::Doubtful);
    EXPECT_NE(found.why.find("2 new photos"), std::string::npos);
}

TEST(NewFiles, DoubtfulIfTheCameraWasResetOrFilesWereDeleted) {
    EXPECT_EQ(newFilesSince(before(5, 7), now({1}, 1)).count, NewFiles::Count::Doubtful);
    EXPECT_EQ(newFilesSince(before(5, 7), now({}, 0)).count, NewFiles::Count::Doubtful);
    EXPECT_EQ(newFilesSince(before(5, 7), now({4, 3}, 6)).count, NewFiles::Count::Doubtful);
}

TEST(NewFiles, DoubtfulIfOneWasDeletedAndOneIsNew) {
    EXPECT_EQ(newFilesSince(before(5, 7), now({6, 5}, 7)).count, NewFiles::Count::Doubtful);
    EXPECT_EQ(newFilesSince(before(5, 7), now({6, 4}, 8)).count, NewFiles::Count::Doubtful);
}

TEST(NewFiles, DoubtfulIfTheNewestIsOldThoughTheCountGrew) {
    EXPECT_EQ(newFilesSince(before(5, 7), now({5, 4}, 8)).count, NewFiles::Count::Doubtful);
    EXPECT_EQ(newFilesSince(before(5, 7), now({}, 8)).count, NewFiles::Count::Doubtful);
}

} // namespace
} // namespace spherewalk::camera
