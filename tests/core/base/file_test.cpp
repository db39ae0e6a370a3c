// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/fixed_random.h"

#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace spherewalk {

using test::expectError;

namespace {

std::size_t entries(const std::filesystem::path& folder) {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

} // namespace

TEST(File, ComesBackAsItWasWritten) {
    const test::TemporaryFolder folder;
    const Bytes bytes{0, 1, 255, 10};
    const auto file = folder / "ä ö.bin";
    writeFile(file, bytes);
    EXPECT_EQ(readFile(file), bytes);
    Bytes pieces;
    readFileInPieces(file, [&](ByteView piece) { pieces.insert(pieces.end(), piece.begin(), piece.end()); });
    EXPECT_EQ(pieces, bytes);
}

TEST(File, RefusesWhatIsMissingTooLargeOrNoFile) {
    const test::TemporaryFolder folder;
    expectError(ErrorKind::NotFound, "absent", [&] { readFile(folder / "absent"); });
    expectError(ErrorKind::InvalidInput, "not a file", [&] { readFile(folder.path()); });
    writeFile(folder / "large", Bytes(11));
    expectError(ErrorKind::Corrupt, "more than the 10 bytes", [&] { readFile(folder / "large", 10); });
}

TEST(File, APipeIsRefusedAndNotWaitedFor) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    expectError(ErrorKind::InvalidInput, "not a file", [&] { readFile(folder / "pipe"); });
    expectError(ErrorKind::InvalidInput, "not a file", [&] { FileSource(folder / "pipe"); });
}

TEST(DurableFile, AppearsOnlyWhenCommitted) {
    const test::TemporaryFolder folder;
    {
        DurableFile file(folder / "photo.jpg");
        file.write(bytesOf("half"));
        EXPECT_FALSE(exists(folder / "photo.jpg"));
        EXPECT_EQ(entries(folder.path()), 1U);
    }
    EXPECT_EQ(entries(folder.path()), 0U);
    DurableFile file(folder / "photo.jpg");
    file.write(bytesOf("whole"));
    file.commit();
    EXPECT_EQ(readTextFile(folder / "photo.jpg"), "whole");
    EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(DurableFile, OverwritesOnlyWhenAskedTo) {
    const test::TemporaryFolder folder;
    writeFile(folder / "a", bytesOf("old"));
    DurableFile second(folder / "a");
    second.write(bytesOf("new"));
    expectError(ErrorKind::Exists, "exists already", [&] { second.commit(DurableFile::Overwrite::No); });
    EXPECT_EQ(readTextFile(folder / "a"), "old");
    second.commit(DurableFile::Overwrite::Yes);
    EXPECT_EQ(readTextFile(folder / "a"), "new");
}

TEST(DurableFile, ReportsAFullDiskAndLeavesNothingBehind) {
    const test::TemporaryFolder folder;
    // The limit on a file's size is the one "full" that needs no file system of its own; it is the child's
    // alone.
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        ::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{1000, 1000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        try {
            writeFile(folder / "big", Bytes(5000));
        } catch (const Error& error) {
            const bool said =
                error.kind() == ErrorKind::Full && error.sentence().find("full") != std::string::npos;
            ::_exit(said && entries(folder.path()) == 0 ? 0 : 1);
        }
        ::_exit(2);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST(SafeRelativePath, AcceptsPlainNamesAndRefusesWaysOut) {
    for (const char* good : {"photos/R0010001.JPG", "a", "a/b/c", "..a", "ü.jpg", "a b"}) {
        EXPECT_TRUE(isSafeRelativePath(good)) << good;
    }
    for (const char* bad :
         {"", "/etc/passwd", "../a", "a/../b", "a/..", "./a", "a//b", "a/", "a\\b", "a\nb", "\xff"}) {
        EXPECT_FALSE(isSafeRelativePath(bad)) << bad;
    }
    EXPECT_FALSE(isSafeRelativePath(std::string_view("a\0b", 3)));
}

TEST(ByteSource, PartsAreTheSameFromMemoryAndFromAFile) {
    const test::TemporaryFolder folder;
    FixedRandom random(41);
    Bytes bytes(10'000);
    for (std::uint8_t& byte : bytes) {
        byte = static_cast<std::uint8_t>(random.below(256));
    }
    writeFile(folder / "f", bytes);
    const MemorySource memory(bytes, "memory");
    const FileSource file(folder / "f");
    file.fetchAhead();
    EXPECT_EQ(memory.sizeBytes(), bytes.size());
    EXPECT_EQ(file.sizeBytes(), bytes.size());
    for (int i = 0; i < 1000; ++i) {
        const std::size_t offset = random.below(bytes.size() + 1);
        Bytes part(random.below(bytes.size() - offset + 1));
        memory.read(offset, part);
        ASSERT_TRUE(
            std::equal(part.begin(), part.end(), bytes.begin() + static_cast<std::ptrdiff_t>(offset)));
        Bytes same(part.size());
        file.read(offset, same);
        ASSERT_EQ(same, part);
    }
    for (const ByteSource* source :
         {static_cast<const ByteSource*>(&memory), static_cast<const ByteSource*>(&file)}) {
        Bytes part(2);
        expectError(ErrorKind::Corrupt, source->name(), [&] { source->read(bytes.size() - 1, part); });
        expectError(ErrorKind::Corrupt, "ends too early", [&] { source->read(UINT64_MAX, part); });
    }
}

} // namespace spherewalk
