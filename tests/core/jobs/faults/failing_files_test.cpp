// SPDX-License-Identifier: GPL-3.0-or-later
#include "failing_database.h"
#include "failing_operations.h"
#include "made_survey.h"
#include "temporary_folder.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/jobs/import_photos.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/render/dataset.h"
#include "spherewalk/store/survey_store.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <map>

// A survey is made, photos are imported, and a dataset is exported, while one file operation after the other
// fails: those of core/base and those of the database.
namespace spherewalk::jobs {

namespace fs = std::filesystem;

namespace {

constexpr int kCodes[] = {ENOSPC, EIO, EACCES};
constexpr int kMostOperations = 2000; // many more than any of the jobs has

struct Outcome {
    bool hasFailed = false; ///< The fault was met.
    bool succeeded = false; ///< The job returned without an error.
};

/// Runs the job while its n-th file operation fails. An error must be one clear sentence.
template <class Job>
Outcome runWithFault(int n, const Job& job) {
    const int code = kCodes[n % 3];
    const test::FailingOperations failing(n, code);
    Outcome outcome;
    try {
        job();
        outcome.succeeded = true;
    } catch (const Error& error) {
        const std::string& sentence = error.sentence();
        EXPECT_TRUE(error.kind() != ErrorKind::Internal && error.kind() != ErrorKind::Stopped) << sentence;
        EXPECT_GT(sentence.size(), 20U) << sentence;
        EXPECT_EQ(sentence.back(), '.') << sentence;
        EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
    } catch (const std::exception& foreign) {
        ADD_FAILURE() << "operation " << n << ": a foreign error: " << foreign.what();
    }
    outcome.hasFailed = failing.hasFailed();
    EXPECT_TRUE(outcome.hasFailed || outcome.succeeded) << "operation " << n << ": an error without a fault";
    return outcome;
}

/// The bytes of all files of a folder, by their names, as digests.
std::map<std::string, std::string> digests(const fs::path& folder) {
    std::map<std::string, std::string> found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            found[fs::relative(entry.path(), folder).string()] = sha256HexOfFile(entry.path());
        }
    }
    return found;
}

class FailingFiles : public testing::Test {
  protected:
    FailingFiles() {
        fs::create_directories(m_folder / "in");
        std::string positions = "file,x_m,y_m,z_m,qw,qx,qy,qz\n";
        for (int i = 0; i < 3; ++i) {
            RgbImage picture(512, 256);
            for (std::size_t k = 0; k < picture.values().size(); ++k) {
                picture.values()[k] =
                    static_cast<std::uint8_t>((k / 96 + 40U * static_cast<unsigned>(i)) % 256);
            }
            const std::string name = std::string(1, static_cast<char>('a' + i)) + ".JPG";
            writeFile(m_folder / "in" / name, jpeg::encode(picture, 80));
            positions += name + "," + std::to_string(0.5 + i) + ",0.5,1.2,1,0,0,0\n";
        }
        writeFile(m_folder / "p.csv", bytesOf(positions));
        writeFile(m_folder / "first.csv", bytesOf(positions.substr(0, positions.find("b.JPG"))));
    }

    ImportReport import(const fs::path& survey, const char* positions = "p.csv") const {
        auto store = store::SurveyStore::open(survey, store::Access::Write);
        return importPhotos(store, {m_folder / "in", m_folder / positions}, noProgress(), {});
    }

    /// A survey with one photo, as it was before the job. Returns its folder.
    fs::path freshSurvey() const {
        const fs::path original = m_folder / "original.spherewalk";
        if (!fs::exists(original)) {
            test::makeSurvey(original, 1);
            import(original, "first.csv");
        }
        const fs::path copy = m_folder / "s.spherewalk";
        fs::remove_all(copy);
        fs::copy(original, copy, fs::copy_options::recursive);
        return copy;
    }

    /// The survey opens for writing, is sound, and has the photos that it had.
    static void expectWhole(const fs::path& survey, std::size_t leastPhotos, std::size_t mostPhotos, int n) {
        try {
            const auto store = store::SurveyStore::open(survey, store::Access::Write);
            EXPECT_TRUE(store.check(noProgress(), {}).isSound()) << "operation " << n;
            EXPECT_GE(store.photos().size(), leastPhotos) << "operation " << n;
            EXPECT_LE(store.photos().size(), mostPhotos) << "operation " << n;
        } catch (const Error& error) {
            ADD_FAILURE() << "operation " << n << ": the survey does not open again: " << error.sentence();
        }
    }

    test::TemporaryFolder m_folder;
    test::FailingDatabase m_database;
};

} // namespace

TEST_F(FailingFiles, ASurveyIsMadeCompletelyOrNotAtAll) {
    const fs::path survey = m_folder / "new.spherewalk";
    bool wasMetToTheEnd = false;
    for (int n = 1; n < kMostOperations && !wasMetToTheEnd; ++n) {
        const Outcome outcome = runWithFault(n, [&] { test::makeSurvey(survey, 1); });
        if (fs::exists(survey)) {
            expectWhole(survey, 0, 0, n);
        }
        EXPECT_TRUE(fs::exists(survey) || !outcome.succeeded) << "operation " << n;
        fs::remove_all(survey);
        for (const fs::directory_entry& entry : fs::directory_iterator(m_folder.path())) {
            EXPECT_EQ(entry.path().string().find("new.spherewalk"), std::string::npos) << entry.path();
        }
        wasMetToTheEnd = !outcome.hasFailed;
    }
    EXPECT_TRUE(wasMetToTheEnd);
}

TEST_F(FailingFiles, AnImportLosesNothingAndCanBeRepeated) {
    bool wasMetToTheEnd = false;
    for (int n = 1; n < kMostOperations && !wasMetToTheEnd; ++n) {
        const fs::path survey = freshSurvey();
        const auto before = digests(survey / "photos");
        const Outcome outcome = runWithFault(n, [&] { import(survey); });
        expectWhole(survey, 1, 3, n);
        const auto after = digests(survey / "photos");
        for (const auto& [name, digest] : before) {
            EXPECT_TRUE(after.contains(name) && after.at(name) == digest)
                << "operation " << n << ": " << name;
        }
        EXPECT_NO_THROW(import(survey)) << "operation " << n;
        expectWhole(survey, 3, 3, n);
        wasMetToTheEnd = !outcome.hasFailed;
    }
    EXPECT_TRUE(wasMetToTheEnd);
}

TEST_F(FailingFiles, AnExportIsCompleteOrAbsentAndLeavesTheSurveyAsItWas) {
    const fs::path survey = freshSurvey();
    import(survey);
    const auto photos = digests(survey / "photos");
    const fs::path dataset = m_folder / "d";
    bool wasMetToTheEnd = false;
    for (int n = 1; n < kMostOperations && !wasMetToTheEnd; ++n) {
        const Outcome outcome = runWithFault(n, [&] {
            const auto store = store::SurveyStore::open(survey, store::Access::Read);
            exportDataset(store, dataset, {}, noProgress(), {});
        });
        EXPECT_TRUE(fs::exists(dataset) || !outcome.succeeded) << "operation " << n;
        if (fs::exists(dataset)) {
            EXPECT_EQ(render::Dataset::open(dataset, render::Verify::Hashes).info().photos.size(), 3U) << n;
            fs::remove_all(dataset);
        }
        for (const fs::directory_entry& entry : fs::directory_iterator(m_folder.path())) {
            EXPECT_NE(entry.path().extension(), ".part") << entry.path();
        }
        EXPECT_EQ(digests(survey / "photos"), photos) << "operation " << n;
        expectWhole(survey, 3, 3, n);
        wasMetToTheEnd = !outcome.hasFailed;
    }
    EXPECT_TRUE(wasMetToTheEnd);
}

} // namespace spherewalk::jobs
