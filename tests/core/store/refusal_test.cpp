// SPDX-License-Identifier: GPL-3.0-or-later
#include "database.h"
#include "survey_fixture.h"

#include <cstdlib>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace spherewalk::store {

namespace fs = std::filesystem;
using spherewalk::test::expectError;
using spherewalk::test::TemporaryFolder;

namespace {

/// What is refused for opening, in either way.
void expectNotOpened(ErrorKind kind, const std::string& part, const fs::path& path) {
    for (const Access access : {Access::Read, Access::Write}) {
        expectError(kind, part, [&] { SurveyStore::open(path, access); });
    }
}

class Damaged : public testing::Test {
  protected:
    void SetUp() override {
        SurveyStore store = test::createSurvey(m_path);
        store.addPhoto(test::newPhoto(store, store.stations()[0].id, "a", "a.JPG"));
    }

    fs::path database() const { return m_path / "survey.sqlite"; }

    void execute(const std::string& sql) const {
        Database raw(database(), Database::Mode::Write, std::chrono::seconds(1));
        raw.execute(sql);
    }

    TemporaryFolder m_folder;
    fs::path m_path = m_folder / "damaged.spherewalk";
};

} // namespace

TEST(SurveyStore, WorksUnderAnyNameThatAFolderCanHave) {
    const TemporaryFolder folder;
    for (const char* name :
         {"Kuchnia świąteczna — 台所 100%?#.spherewalk", "a'b\"c;d.spherewalk", "trailing.spherewalk/"}) {
        test::createSurvey(folder / name);
        const SurveyStore store = SurveyStore::open(folder / name, Access::Write);
        EXPECT_EQ(store.stations().size(), 24U) << name;
        EXPECT_EQ(SurveyStore::open(folder / name, Access::Read).info().name, "Small room");
    }
}

TEST(SurveyStore, IsNotCreatedOverAnything) {
    const TemporaryFolder folder;
    writeFile(folder / "file", bytesOf("precious"));
    fs::create_directory(folder / "empty");
    fs::create_symlink("nowhere", folder / "link");
    test::createSurvey(folder / "survey");
    for (const char* name : {"file", "empty", "survey", "link"}) {
        expectError(ErrorKind::Exists, "there is something by that name already",
                    [&] { test::createSurvey(folder / name); });
    }
    EXPECT_EQ(readTextFile(folder / "file"), "precious");
    EXPECT_TRUE(fs::is_empty(folder / "empty"));
}

TEST(SurveyStore, LeavesNothingBehindWhenItCannotBeCreated) {
    const TemporaryFolder folder;
    expectError(ErrorKind::NotFound, "create the folder it shall lie in first",
                [&] { test::createSurvey(folder / "none" / "x.spherewalk"); });
    expectError(ErrorKind::Full, "the disk is full",
                [&] { test::createSurvey(folder / "x.spherewalk", {.maxDatabaseBytes = 8192}); });
    survey::Room broken = test::smallRoom();
    broken.ceilingM = 0;
    expectError(ErrorKind::InvalidInput, "The ceiling cannot be at",
                [&] { SurveyStore::create(folder / "x.spherewalk", "x", broken, {}, {}); });
    expectError(ErrorKind::InvalidInput, "The name of the survey", [&] {
        SurveyStore::create(folder / "x.spherewalk", "\xff\n", test::smallRoom(), test::twoHeights(), {});
    });
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(SurveyStore, RefusesWhatIsNotThere) {
    const TemporaryFolder folder;
    expectNotOpened(ErrorKind::NotFound, "There is no survey", folder / "none.spherewalk");
}

TEST(SurveyStore, RefusesFoldersAndFilesThatAreNoSurvey) {
    const TemporaryFolder folder;
    writeFile(folder / "file.spherewalk", bytesOf("x"));
    expectNotOpened(ErrorKind::InvalidInput, "is not a survey: it is not a folder",
                    folder / "file.spherewalk");
    fs::create_directory(folder / "folder");
    expectNotOpened(ErrorKind::InvalidInput, "is not a survey: it holds no readable file survey.sqlite",
                    folder / "folder");
    fs::create_directory(folder / "folder" / "survey.sqlite");
    expectNotOpened(ErrorKind::InvalidInput, "is not a survey: it holds no readable file survey.sqlite",
                    folder / "folder");
    EXPECT_FALSE(fs::exists(folder / "folder" / "writer.lock"));
}

TEST_F(Damaged, IsRefusedWhenItBelongsToAnotherProgram) {
    execute("PRAGMA application_id = 1");
    expectNotOpened(ErrorKind::InvalidInput,
                    "is not a survey: its file survey.sqlite belongs to another program", m_path);
}

TEST_F(Damaged, IsRefusedUnmodifiedWhenNewer) {
    execute("PRAGMA user_version = 10; PRAGMA wal_checkpoint(TRUNCATE)");
    const std::string before = sha256HexOfFile(database());
    expectNotOpened(
        ErrorKind::Unsupported,
        "was written by a newer Spherewalk (format 10, this one knows up to 9); update Spherewalk", m_path);
    EXPECT_EQ(sha256HexOfFile(database()), before);
}

TEST_F(Damaged, IsRefusedForReadingWhenOlderAndInUse) {
    const SurveyStore writer =
        SurveyStore::open(m_path, Access::Write); // so that nobody can bring it up to date
    execute("PRAGMA user_version = 1");
    expectError(ErrorKind::Unsupported,
                "was written by an older Spherewalk (format 1) and cannot be brought to format",
                [&] { SurveyStore::open(m_path, Access::Read); });
}

TEST_F(Damaged, IsRefusedWhenEmpty) {
    writeFile(database(), {});
    expectNotOpened(ErrorKind::Corrupt, "survey.sqlite is empty", m_path);
}

TEST_F(Damaged, IsRefusedWhenItIsGarbage) {
    writeFile(database(), bytesOf(std::string(20000, 'x')));
    expectNotOpened(ErrorKind::Corrupt, "is damaged: it is no database", m_path);
}

TEST_F(Damaged, IsRefusedWhenCutShort) {
    const auto size = fs::file_size(database());
    // The last page holds an empty table: what it loses at its end are zeros, which SQLite takes as read.
    for (const std::uintmax_t left : {size - 4096, size / 2, std::uintmax_t(4096), std::uintmax_t(50)}) {
        fs::resize_file(database(), left);
        expectNotOpened(ErrorKind::Corrupt, "is damaged", m_path);
    }
}

TEST_F(Damaged, IsRefusedWhenAPageIsOverwritten) {
    Bytes bytes = readFile(database());
    ASSERT_GT(bytes.size(), 5U * 4096);
    std::fill(bytes.begin() + 2 * 4096, bytes.begin() + 3 * 4096, 0x5a);
    writeFile(database(), bytes);
    expectNotOpened(ErrorKind::Corrupt, "is damaged", m_path);
}

TEST_F(Damaged, NamesMissingTables) {
    execute("PRAGMA foreign_keys = OFF; DROP TABLE shot");
    const SurveyStore store = SurveyStore::open(m_path, Access::Read);
    expectError(ErrorKind::Corrupt, "its tables are not those of a survey", [&] { store.openShots(); });
}

TEST_F(Damaged, RefusesForgedValues) {
    execute("UPDATE survey SET ceiling_m = 9e999; UPDATE placement SET stops = 2000000000 WHERE id = 1;"
            "UPDATE photo SET added_utc = 'yesterday'; UPDATE survey SET created_utc = "
            "'2026-99-01T00:00:00.000Z'");
    const SurveyStore store = SurveyStore::open(m_path, Access::Read);
    expectError(ErrorKind::Corrupt, R"(its value of "ceiling_m" is none)", [&] { store.room(); });
    expectError(ErrorKind::Corrupt, R"(its value of "stops" is none)", [&] { store.plan(); });
    expectError(ErrorKind::Corrupt, "the record of a photo cannot be", [&] { store.photos(); });
    expectError(ErrorKind::Corrupt, "a time in it is none", [&] { store.info(); });
}

TEST_F(Damaged, RefusesAForgedRoom) {
    execute("DELETE FROM corner WHERE polygon = 0 AND corner > 1");
    const SurveyStore store = SurveyStore::open(m_path, Access::Read);
    expectError(ErrorKind::Corrupt, "its plan cannot be (The outline cannot be used: it has 2 corners",
                [&] { store.room(); });
    execute("DELETE FROM survey");
    expectError(ErrorKind::Corrupt, "it does not say which survey it is", [&] { store.info(); });
}

TEST(SurveyStore, RefusesChangesWhenOpenForReading) {
    const TemporaryFolder folder;
    SurveyStore writer = test::createSurvey(folder / "x.spherewalk");
    SurveyStore reader = SurveyStore::open(folder / "x.spherewalk", Access::Read);
    const std::string part = "it is open for reading only";
    const std::int64_t station = writer.stations()[0].id;
    const NewPhoto photo = test::newPhoto(writer, station, "a", "a.JPG");
    expectError(ErrorKind::InvalidInput, part, [&] { reader.addPhoto(photo); });
    expectError(ErrorKind::InvalidInput, part, [&] { reader.beginShot(station, "", {"", 0}); });
    expectError(ErrorKind::InvalidInput, part, [&] { reader.addStation({0, 0, 1}); });
    expectError(ErrorKind::InvalidInput, part, [&] { reader.addSolution({}, true); });
    expectError(ErrorKind::InvalidInput, part, [&] { reader.choosePhoto(1); });
    expectError(ErrorKind::InvalidInput, part, [&] { reader.markStarted(1, ""); });
}

TEST(SurveyStore, KeepsEverythingWhenTheDiskIsFull) {
    const TemporaryFolder folder;
    const fs::path path = folder / "x.spherewalk";
    test::createSurvey(path);
    const auto size = fs::file_size(path / "survey.sqlite");
    int recorded = 0;
    {
        SurveyStore store = SurveyStore::open(path, Access::Write, {.maxDatabaseBytes = size + 3 * 4096});
        const std::int64_t station = store.stations()[0].id;
        expectError(
            ErrorKind::Full,
            "the disk is full; free some space and try again. What was recorded before is kept.", [&] {
                for (; recorded < 10000; ++recorded) {
                    store.addPhoto(test::newPhoto(store, station, text("p", recorded), text("p", recorded)));
                }
            });
        ASSERT_GT(recorded, 0);
        EXPECT_EQ(store.counts().photos, recorded);
        EXPECT_EQ(store.chosenPhoto(station)->fileName, text("p", recorded - 1));
    }
    SurveyStore store = SurveyStore::open(path, Access::Write);
    EXPECT_EQ(store.counts().photos, recorded);
    EXPECT_TRUE(store.check(noProgress(), {}).isSound());
    store.addPhoto(test::newPhoto(store, store.stations()[0].id, text("p", recorded), text("p", recorded)));
    EXPECT_EQ(store.counts().photos, recorded + 1);
}

TEST(SurveyStore, IsReadButNotWrittenInAFolderThatCannotBeWritten) {
    const TemporaryFolder folder;
    const fs::path path = folder / "read only ü.spherewalk";
    test::createSurvey(path);
    fs::permissions(folder.path(), fs::perms(0755));
    for (const auto& entry : fs::directory_iterator(path)) {
        fs::permissions(entry.path(), entry.is_directory() ? fs::perms(0555) : fs::perms(0444));
    }
    fs::permissions(path, fs::perms(0555));
    // Permissions do not hold for root, so a child gives up that right first.
    const pid_t child = ::fork();
    if (child == 0) {
        if (!test::giveUpRoot()) {
            ::_exit(10);
        }
        try {
            if (SurveyStore::open(path, Access::Read).stations().size() != 24) {
                ::_exit(11);
            }
        } catch (const Error& error) {
            std::fprintf(stderr, "%s\n", error.what());
            ::_exit(12);
        }
        try {
            SurveyStore::open(path, Access::Write);
            ::_exit(13);
        } catch (const Error& error) {
            ::_exit(error.kind() == ErrorKind::Io &&
                            error.sentence().find("check the permissions") != std::string::npos
                        ? 0
                        : 14);
        }
    }
    int status = -1;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 0);
    fs::permissions(path, fs::perms(0755));
}

} // namespace spherewalk::store
