// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/folder.h"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

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

TEST(Folder, RemovesWhatAKilledProgramLeftAndNothingElse) {
    const test::TemporaryFolder folder;
    const auto left = [&](const std::string& name) {
        fs::create_directories(folder / name / "photos");
        return folder / name;
    };
    const pid_t killed = ::fork();
    if (killed == 0) {
        ::_exit(0);
    }
    ::waitpid(killed, nullptr, 0); // its number belongs to nobody now
    const fs::path dead = left("new." + std::to_string(killed) + ".part");
    const fs::path running = left("new." + std::to_string(::getppid()) + ".part");
    const fs::path other = left("newer." + std::to_string(killed) + ".part");
    const fs::path foreign = left("new.copy.part");
    makeFolder(folder / "new", "the thing", [](const fs::path&) {});
    EXPECT_FALSE(fs::exists(dead));
    EXPECT_TRUE(fs::exists(running));
    EXPECT_TRUE(fs::exists(other));
    EXPECT_TRUE(fs::exists(foreign));

    const std::string name = "spherewalk-test-left";
    const fs::path temporary = fs::temp_directory_path() / (name + "-" + std::to_string(killed) + "-AbCdEf");
    fs::create_directories(temporary);
    { const TemporaryFolder next(name); }
    EXPECT_FALSE(fs::exists(temporary));
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
