// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"
#include "survey_fixture.h"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <sys/wait.h>
#include <unistd.h>

namespace spherewalk::store {

namespace fs = std::filesystem;

namespace {

/// What a child has been told is on disk: the shot, and its photo if that was recorded.
struct Acknowledged {
    std::int64_t shot = 0;
    std::int64_t photo = 0;
};

/// Records shots with their photos until it is killed, and tells the pipe each time a record is on disk.
[[noreturn]] void recordForEver(const fs::path& path, int pipe, int round) {
    try {
        SurveyStore store = SurveyStore::open(path, Access::Write);
        const std::vector<StationRecord> stations = store.stations();
        const auto tell = [&](const Acknowledged& done) {
            if (::write(pipe, &done, sizeof done) != sizeof done) {
                ::_exit(2);
            }
        };
        for (int i = 0;; ++i) {
            const std::int64_t station = stations[static_cast<std::size_t>(i) % stations.size()].id;
            const std::int64_t shot = store.beginShot(station, "YN1", {"", i}).id;
            tell({shot, 0});
            store.markStarted(shot, text("command ", i));
            store.markTaken(shot, text("http://camera/", i));
            const std::string name = text("round", round, "-", i);
            tell({shot, store.recordDownload(shot, test::newPhoto(store, station, name, name + ".JPG"))});
        }
    } catch (const Error& error) {
        std::fprintf(stderr, "child: %s\n", error.what());
    }
    ::_exit(3);
}

/// Lets this much time pass: the law is that any instant will do.
void spin(std::chrono::microseconds duration) {
    const auto end = std::chrono::steady_clock::now() + duration;
    while (std::chrono::steady_clock::now() < end) {
    }
}

/// Lets a child record until this many records are acknowledged, kills it there and then, and returns all
/// that it was told.
std::vector<Acknowledged> killAfter(const fs::path& path, int round, int records,
                                    std::chrono::microseconds after) {
    std::array<int, 2> pipe{};
    EXPECT_EQ(::pipe(pipe.data()), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        ::close(pipe[0]);
        recordForEver(path, pipe[1], round);
    }
    ::close(pipe[1]);
    std::vector<Acknowledged> done;
    Acknowledged next;
    while (static_cast<int>(done.size()) < records && ::read(pipe[0], &next, sizeof next) == sizeof next) {
        done.push_back(next);
    }
    // Not always right after an acknowledgement: somewhere in the next record.
    spin(after);
    ::kill(child, SIGKILL);
    while (::read(pipe[0], &next, sizeof next) == sizeof next) {
        done.push_back(next);
    }
    ::close(pipe[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status)) << "the child ended by itself";
    return done;
}

} // namespace

TEST(Crash, LosesNothingThatWasAcknowledged) {
    spherewalk::test::Random random(404);
    const spherewalk::test::TemporaryFolder folder;
    const fs::path path = folder / "killed.spherewalk";
    test::createSurvey(path);
    std::vector<Acknowledged> all;
    for (int round = 0; round < 25; ++round) {
        SCOPED_TRACE(testing::Message() << "seed " << random.seed() << " round " << round);
        const int records = random.integer(1, 30);
        const std::vector<Acknowledged> done =
            killAfter(path, round, records, std::chrono::microseconds(random.integer(0, 5000)));
        EXPECT_GE(static_cast<int>(done.size()), records);
        all.insert(all.end(), done.begin(), done.end());

        const SurveyStore store = SurveyStore::open(path, Access::Write);
        const SurveyCheck check = store.check(noProgress(), {});
        EXPECT_TRUE(check.isSound()) << testing::PrintToString(check.database);
        for (const Acknowledged& record : all) {
            const survey::Shot shot = store.shot(record.shot);
            if (record.photo != 0) {
                EXPECT_EQ(shot.step, survey::ShotStep::Downloaded);
                EXPECT_EQ(shot.photo, record.photo);
                EXPECT_EQ(store.photo(record.photo).station, shot.station);
            }
        }
        // Each kill leaves at most the one shot open that was being recorded.
        EXPECT_LE(store.openShots().size(), static_cast<std::size_t>(round + 1));
    }
    EXPECT_GT(all.size(), 100U);
}

TEST(Crash, LeavesNoHalfSurveyBehind) {
    const spherewalk::test::TemporaryFolder folder;
    spherewalk::test::Random random(405);
    for (int round = 0; round < 20; ++round) {
        const fs::path path = folder / text("created ", round, ".spherewalk");
        const pid_t child = ::fork();
        if (child == 0) {
            try {
                test::createSurvey(path);
            } catch (const Error& error) {
                std::fprintf(stderr, "child: %s\n", error.what());
            }
            ::_exit(0);
        }
        spin(std::chrono::microseconds(random.integer(0, 60'000)));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        if (fs::exists(path)) {
            EXPECT_EQ(SurveyStore::open(path, Access::Write).stations().size(), 24U);
        } else {
            EXPECT_EQ(test::createSurvey(path).stations().size(), 24U);
        }
    }
}

} // namespace spherewalk::store
