// SPDX-License-Identifier: GPL-3.0-or-later
#include "database.h"
#include "survey_fixture.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <sys/wait.h>
#include <unistd.h>

namespace spherewalk::store {

namespace {

class Sharing : public test::SurveyTest {};

/// The exit status of a child that runs this and nothing after.
int inAnotherProgram(const std::function<int()>& run) {
    const pid_t child = ::fork();
    if (child == 0) {
        ::_exit(run());
    }
    int status = -1;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

} // namespace

TEST_F(Sharing, LetsOneProgramWriteAndNamesIt) {
    expectRefused(ErrorKind::Busy,
                  text("is being written by another program (process ", static_cast<long long>(::getpid()),
                       "); close it there, or open it here for reading."),
                  [&] { SurveyStore::open(m_path, Access::Write); });
}

TEST_F(Sharing, HoldsAcrossPrograms) {
    EXPECT_EQ(inAnotherProgram([&] {
                  try {
                      SurveyStore::open(m_path, Access::Write);
                      return 1;
                  } catch (const Error& error) {
                      return error.kind() == ErrorKind::Busy ? 0 : 2;
                  }
              }),
              0);
}

TEST_F(Sharing, EndsWhenTheWriterCloses) {
    { const SurveyStore closed = std::move(m_store); }
    const SurveyStore next = SurveyStore::open(m_path, Access::Write);
    EXPECT_EQ(next.stations().size(), 24U);
    m_store = SurveyStore::open(m_path, Access::Read);
}

TEST_F(Sharing, ShowsReadersWhatIsWrittenMeanwhile) {
    const SurveyStore reader = SurveyStore::open(m_path, Access::Read);
    for (int i = 0; i < 20; ++i) {
        m_store.addPhoto(photoOf(stationAt(0), text("p", i)));
        ASSERT_EQ(reader.counts().photos, i + 1);
        ASSERT_EQ(reader.chosenPhoto(stationAt(0))->fileName, text("p", i, ".JPG"));
    }
}

TEST_F(Sharing, AReaderWithoutRightsSeesWhatTheOwnerWritesLater) {
    namespace fs = std::filesystem;
    Database(m_path / "survey.sqlite", Database::Mode::Write, std::chrono::seconds(1))
        .execute("PRAGMA wal_checkpoint(TRUNCATE)");
    ASSERT_EQ(fs::file_size(m_path / "survey.sqlite-wal"), 0U);
    fs::permissions(m_path.parent_path(), fs::perms(0755));
    for (const auto& entry : fs::directory_iterator(m_path)) {
        fs::permissions(entry.path(), entry.is_directory() ? fs::perms(0755) : fs::perms(0644));
    }
    fs::permissions(m_path, fs::perms(0755));
    std::array<int, 2> toChild{};
    std::array<int, 2> toOwner{};
    ASSERT_EQ(::pipe(toChild.data()) | ::pipe(toOwner.data()), 0);
    constexpr int kPhotos = 5;
    // Permissions do not hold for root, so the reader gives up that right.
    const pid_t reader = ::fork();
    if (reader == 0) {
        if (!test::giveUpRoot()) {
            ::_exit(10);
        }
        try {
            const SurveyStore store = SurveyStore::open(m_path, Access::Read);
            char word = 'r';
            for (int photos = 1; photos <= kPhotos; ++photos) {
                if (::write(toOwner[1], &word, 1) != 1 || ::read(toChild[0], &word, 1) != 1) {
                    ::_exit(11);
                }
                if (store.counts().photos != photos) {
                    ::_exit(12);
                }
            }
            ::_exit(0);
        } catch (const Error& error) {
            std::fprintf(stderr, "%s\n", error.what());
            ::_exit(13);
        }
    }
    ::close(toOwner[1]);
    for (char word = 0; ::read(toOwner[0], &word, 1) == 1;) {
        m_store.addPhoto(photoOf(stationAt(0), text("p", m_store.counts().photos)));
        ASSERT_EQ(::write(toChild[1], &word, 1), 1);
    }
    int status = -1;
    ASSERT_EQ(::waitpid(reader, &status, 0), reader);
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 0);
    EXPECT_EQ(m_store.counts().photos, kPhotos);
    for (const int end : {toChild[0], toChild[1], toOwner[0]}) {
        ::close(end);
    }
}

TEST_F(Sharing, NeedsNoMemoryOfOneMachineOnAShare) {
    const auto journal = [&] {
        const Database database(m_path / "survey.sqlite", Database::Mode::Read, std::chrono::seconds(1));
        Statement mode = database.query("PRAGMA journal_mode");
        mode.step();
        return mode.text(0);
    };
    for (const bool isOnShare : {true, false, true}) {
        { const SurveyStore closed = std::move(m_store); }
        m_store = SurveyStore::open(m_path, Access::Write, {.isOnShare = isOnShare});
        EXPECT_EQ(journal(), isOnShare ? "delete" : "wal");
        EXPECT_EQ(std::filesystem::exists(m_path / "survey.sqlite-shm"), !isOnShare);
        const SurveyStore reader = SurveyStore::open(m_path, Access::Read);
        const std::size_t before = reader.stations().size();
        m_store.addStation({0, 0, 1});
        EXPECT_EQ(reader.stations().size(), before + 1);
    }
}

TEST_F(Sharing, SaysBusyWhenAnotherProgramHoldsTheDatabase) {
    { const SurveyStore closed = std::move(m_store); }
    m_store = SurveyStore::open(m_path, Access::Write, {.patience = std::chrono::milliseconds(20)});
    Database foreign(m_path / "survey.sqlite", Database::Mode::Write, std::chrono::seconds(1));
    foreign.execute("BEGIN IMMEDIATE");
    expectRefused(ErrorKind::Busy, "another program is using it; try again when it is done.", [&] {
        m_store.addStation({0, 0, 1});
    });
    foreign.execute("ROLLBACK");
    EXPECT_NO_THROW(m_store.addStation({0, 0, 1}));
}

} // namespace spherewalk::store
