// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "failing_operations.h"
#include "temporary_folder.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/folder.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <set>

namespace spherewalk {

using test::FailingOperations;

namespace {

std::set<std::string> namesIn(const std::filesystem::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        names.insert(entry.path().filename().string());
    }
    return names;
}

/// Lets the first, second, ... operation of the work fail until the work succeeds. `check` looks after each.
template <class Work, class Check>
int failOneByOne(int code, const Work& work, const Check& check) {
    for (int n = 1;; ++n) {
        bool succeeded = true;
        {
            const FailingOperations failing(n, code);
            try {
                work();
            } catch (const Error& error) {
                succeeded = false;
                EXPECT_EQ(error.sentence().back(), '.') << error.sentence();
                EXPECT_EQ(error.kind(), code == ENOSPC ? ErrorKind::Full : ErrorKind::Io) << error.sentence();
            }
            EXPECT_EQ(succeeded, !failing.hasFailed()) << "operation " << n;
        }
        check(succeeded);
        if (succeeded) {
            return n - 1;
        }
    }
}

} // namespace

TEST(FileFault, ADurableFileIsOldOrNewWhicheverOperationFails) {
    for (const int code : {ENOSPC, EIO, EACCES}) {
        const test::TemporaryFolder folder;
        const auto file = folder / "file";
        writeFile(file, bytesOf("old"));
        const int operations = failOneByOne(
            code, [&] { writeFile(file, bytesOf("new")); },
            [&](bool succeeded) {
                const std::string content = readTextFile(file);
                EXPECT_TRUE(content == "new" || (!succeeded && content == "old")) << content;
                EXPECT_EQ(namesIn(folder.path()), std::set<std::string>{"file"});
            });
        EXPECT_EQ(operations, 5) << "open, write, sync, rename, sync of the folder";
    }
}

TEST(FileFault, AFileGetsANewNameWhereRenamesCannotRefuseTakenOnes) {
    const test::TemporaryFolder folder;
    const auto put = [&](const char* content) {
        DurableFile file(folder / "file");
        file.write(bytesOf(content));
        const FailingOperations failing(2, EINVAL); // the sync, then the rename with the flag
        file.commit(DurableFile::Overwrite::No);
        EXPECT_TRUE(failing.hasFailed());
    };
    put("first");
    EXPECT_EQ(readTextFile(folder / "file"), "first");
    test::expectError(ErrorKind::Exists, "exists already", [&] { put("second"); });
    EXPECT_EQ(readTextFile(folder / "file"), "first");
    EXPECT_EQ(namesIn(folder.path()), std::set<std::string>{"file"});
}

TEST(FileFault, AFolderIsCompleteOrAbsentWhicheverOperationFails) {
    for (const int code : {ENOSPC, EIO}) {
        const test::TemporaryFolder parent;
        const auto folder = parent / "new";
        const int operations = failOneByOne(
            code,
            [&] {
                std::filesystem::remove_all(folder);
                makeFolder(folder, "the thing", [](const std::filesystem::path& at) {
                    std::filesystem::create_directory(at / "inner");
                    writeFile(at / "inner" / "a", bytesOf("1"));
                    writeFile(at / "b", bytesOf("2"));
                });
            },
            [&](bool) {
                const auto names = namesIn(parent.path());
                EXPECT_TRUE(names.empty() || names == (std::set<std::string>{"new", "inner", "a", "b"}));
            });
        EXPECT_GE(operations, 14);
    }
}

TEST(FileFault, ReadingSaysWhichFileCouldNotBeRead) {
    const test::TemporaryFolder folder;
    const auto file = folder / "file";
    writeFile(file, bytesOf("content"));
    for (const int n : {1, 2}) {
        const FailingOperations failing(n, EIO);
        test::expectError(ErrorKind::Io, file.string(), [&] { readFile(file); });
    }
    const FileSource source(file);
    const FailingOperations failing(1, EIO);
    Bytes part(3);
    test::expectError(ErrorKind::Io, file.string(), [&] { source.read(1, part); });
}

TEST(FileFault, EndsWithItsScope) {
    const test::TemporaryFolder folder;
    { const FailingOperations failing(1, EIO); }
    EXPECT_NO_THROW(writeFile(folder / "file", bytesOf("x")));
}

} // namespace spherewalk
