// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/folder.h"

#include <gtest/gtest.h>

namespace spherewalk {

namespace fs = std::filesystem;

namespace {

std::ptrdiff_t childCount(const fs::path& folder) {
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

} // namespace

TEST(Folder, IsThereWhenItIsWhole) {
    const test::TemporaryFolder folder;
    makeFolder(folder / "new", "the thing", [&](const fs::path& at) {
        EXPECT_FALSE(fs::exists(folder / "new"));
        fs::create_directories(at / "inner");
        writeFile(at / "inner" / "file", bytesOf("x"));
    });
    EXPECT_EQ(readTextFile(folder / "new" / "inner" / "file"), "x");
    EXPECT_EQ(childCount(folder.path()), 1);
}

TEST(Folder, LeavesNothingAfterAnError) {
    const test::TemporaryFolder folder;
    test::expectError(ErrorKind::Stopped, "enough", [&] {
        makeFolder(folder / "new", "the thing", [](const fs::path& at) {
            writeFile(at / "file", bytesOf("x"));
            throw Error(ErrorKind::Stopped, "enough");
        });
    });
    test::expectError(ErrorKind::Io, "Could not write the thing", [&] {
        makeFolder(folder / "new", "the thing",
                   [](const fs::path& at) { fs::rename(at / "none", at / "other"); });
    });
    EXPECT_EQ(childCount(folder.path()), 0);
}

TEST(Folder, ReplacesNothing) {
    const test::TemporaryFolder folder;
    fs::create_directories(folder / "new");
    test::expectError(ErrorKind::Exists, "the thing", [&] {
        makeFolder(folder / "new", "the thing", [](const fs::path&) { FAIL() << "it is there"; });
    });
    test::expectError(ErrorKind::Exists, "already", [&] {
        makeFolder(folder / "meanwhile", "the thing",
                   [&](const fs::path&) { fs::create_directories(folder / "meanwhile"); });
    });
}

} // namespace spherewalk
