// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "photographed_survey.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/jobs/export_dataset.h"

#include <algorithm>
#include <map>

namespace spherewalk::jobs {

using test::expectError;

namespace {

/// Four small photos of a survey, and a cache of its own.
class DepthSurvey : public testing::Test {
  protected:
    DepthSurvey() {
        const auto store = m_survey.open();
        for (const store::PhotoRecord& photo : store.photos()) {
            m_photos.push_back({store.photoFolder() / photo.fileName,
                                photo.fileSha256,
                                {Eigen::Quaterniond::Identity(), photo.positionM}});
        }
        m_options.cacheFolder = m_survey / "cache";
        m_options.sweep.width = 64;
        m_options.sweep.coarseWidth = 64;
    }

    SurveyDepth estimate(ProgressSink& progress = noProgress(), const std::stop_token& stop = {}) {
        return surveyDepth(m_photos, m_options, progress, stop);
    }

    DepthForecast forecast(bool withTrial = false) {
        return depthForecast(m_photos, m_options, withTrial, {});
    }

    /// All files of the cache, by name.
    std::map<std::string, std::string> cached() const {
        std::map<std::string, std::string> files;
        for (const auto& entry : std::filesystem::directory_iterator(m_options.cacheFolder)) {
            files[entry.path().filename()] = readTextFile(entry.path());
        }
        return files;
    }

    /// When they were written.
    std::map<std::string, std::filesystem::file_time_type> written() const {
        std::map<std::string, std::filesystem::file_time_type> times;
        for (const auto& entry : std::filesystem::directory_iterator(m_options.cacheFolder)) {
            times[entry.path().filename()] = entry.last_write_time();
        }
        return times;
    }

    test::PhotographedSurvey m_survey{4};
    std::vector<DepthInput> m_photos;
    DepthOptions m_options;
};

/// Asks to stop once a job has told of its progress so many times.
class StopAfter : public ProgressSink {
  public:
    explicit StopAfter(int calls) : m_left(calls) {}

    void progress(double /*fraction*/, std::string_view /*activity*/) override {
        if (--m_left <= 0) {
            m_stop.request_stop();
        }
    }

    void warning(std::string_view /*sentence*/) override {}

    std::stop_token token() const { return m_stop.get_token(); }

  private:
    int m_left;
    std::stop_source m_stop;
};

} // namespace

TEST_F(DepthSurvey, HasADepthForEachPhotoThatHasNeighbours) {
    const SurveyDepth found = estimate();
    EXPECT_EQ(found.report.photos, 4U);
    EXPECT_EQ(found.report.reused, 0U);
    ASSERT_EQ(found.files.size(), 4U);
    for (const std::filesystem::path& file : found.files) {
        EXPECT_TRUE(std::filesystem::is_regular_file(file)) << file;
    }
}

TEST_F(DepthSurvey, TakesWhatAnEarlierRunHasFoundWithTheSameResult) {
    const SurveyDepth first = estimate();
    const auto files = cached();
    const SurveyDepth second = estimate();
    EXPECT_EQ(second.report.reused, 4U);
    EXPECT_EQ(second.files, first.files);
    EXPECT_EQ(second.radiusM, first.radiusM);
    EXPECT_EQ(second.room, first.room);
    EXPECT_EQ(cached(), files);
}

TEST_F(DepthSurvey, GoesOnWhereItWasStoppedWithTheSameFiles) {
    StopAfter two(2);
    expectError(ErrorKind::Stopped, "Stopped", [&] { estimate(two, two.token()); });
    const auto begun = written();
    EXPECT_GE(begun.size(), 2U);
    const SurveyDepth rest = estimate();
    EXPECT_EQ(rest.report.photos, 4U);
    const auto finished = written();
    for (const auto& [name, time] : begun) {
        EXPECT_EQ(finished.at(name), time) << name << " was made once more";
    }
    const auto interrupted = cached();
    m_options.cacheFolder = m_survey / "another";
    const SurveyDepth whole = estimate();
    EXPECT_EQ(cached(), interrupted);
    EXPECT_EQ(whole.radiusM, rest.radiusM);
    EXPECT_EQ(whole.room, rest.room);
}

TEST_F(DepthSurvey, IsTheSameForAnyNumberOfThreads) {
    m_options.sweep.threads = 1;
    const SurveyDepth one = estimate();
    const auto files = cached();
    m_options.cacheFolder = m_survey / "another";
    m_options.sweep.threads = 6;
    const SurveyDepth six = estimate();
    EXPECT_EQ(cached(), files);
    EXPECT_EQ(six.gains, one.gains);
}

TEST_F(DepthSurvey, MakesAgainWhatIsMissingBetween) {
    const SurveyDepth first = estimate();
    const auto files = cached();
    for (const auto& [name, content] : files) {
        if (std::none_of(first.files.begin(), first.files.end(),
                         [&](const std::filesystem::path& file) { return file.filename() == name; })) {
            std::filesystem::remove(m_options.cacheFolder / name);
        }
    }
    EXPECT_EQ(estimate().room, first.room);
    EXPECT_EQ(cached(), files);
}

TEST_F(DepthSurvey, ReadsNoPhotoWhenItIsStoppedAtOnce) {
    std::stop_source stop;
    stop.request_stop();
    expectError(ErrorKind::Stopped, "Stopped", [&] { estimate(noProgress(), stop.get_token()); });
    EXPECT_TRUE(cached().empty());
}

TEST_F(DepthSurvey, TakesNoDepthOfAnotherPlaceOrSizeOrFile) {
    estimate();
    m_photos[1].roomFromPhoto.translation.x() += 0.01;
    EXPECT_LT(estimate().report.reused, 4U);
    const std::size_t known = estimate().report.reused;
    EXPECT_EQ(known, 4U);
    m_options.sweep.width = 128;
    EXPECT_EQ(estimate().report.reused, 0U);
    m_photos[0].sha256[0] = m_photos[0].sha256[0] == '0' ? '1' : '0';
    EXPECT_LT(estimate().report.reused, 4U);
}

TEST_F(DepthSurvey, FindsNothingInNoPhotos) {
    m_photos.clear();
    const SurveyDepth found = estimate();
    EXPECT_TRUE(found.files.empty());
    EXPECT_FALSE(found.radiusM);
    EXPECT_FALSE(found.room);
}

TEST_F(DepthSurvey, NamesAPhotoThatCannotBeRead) {
    m_survey.leaveUnchecked();
    std::filesystem::remove(m_photos[3].file);
    expectError(ErrorKind::NotFound, m_photos[3].file.filename(), [&] { estimate(); });
}

TEST_F(DepthSurvey, IsForecastFromWhatIsKnown) {
    DepthForecast before = forecast();
    EXPECT_EQ(before.photos, 4U);
    EXPECT_EQ(before.missing, 4U);
    EXPECT_FALSE(before.secondsAPhoto);
    EXPECT_EQ(before.seconds(), 0);
    EXPECT_TRUE(cached().empty()) << "a forecast without a trial makes nothing";
    estimate();
    EXPECT_EQ(forecast().missing, 0U);
    EXPECT_FALSE(forecast(true).secondsAPhoto) << "nothing is left to try";
}

TEST_F(DepthSurvey, KeepsTheDepthThatATrialHasMade) {
    const DepthForecast tried = forecast(true);
    ASSERT_TRUE(tried.secondsAPhoto);
    EXPECT_GT(*tried.secondsAPhoto, 0);
    EXPECT_DOUBLE_EQ(tried.seconds(), 4 * *tried.secondsAPhoto);
    EXPECT_EQ(forecast().missing, 3U);
}

} // namespace spherewalk::jobs
