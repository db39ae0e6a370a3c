// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/capture_pipeline.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/import_photos.h"

#include <gmock/gmock.h>

namespace spherewalk::jobs {

namespace {

/// Pictures that lie on the camera, and come into the survey by another way before they are downloaded.
class KnownPhoto : public CapturePipeline {
  protected:
    /// Takes all pictures, of which none can be downloaded yet.
    void takeWithoutDownload() {
        m_camera->arm({practice::FaultKind::ServiceUnavailable, "/files", 0, 1000, 0});
        Cart cart(endpoint());
        capture(cart);
        m_camera->disarm();
        ASSERT_EQ(m_store->openShots().size(), m_stations.size());
    }

    /// Brings the picture of a shot in by hand, at a station.
    void importPicture(const survey::Shot& shot, const store::StationRecord& at) {
        const std::string url = shot.fileUrl.substr(0, shot.fileUrl.find('#'));
        const std::filesystem::path name = std::filesystem::path(url).filename();
        std::filesystem::create_directories(m_folder / "in");
        for (const auto& entry : std::filesystem::recursive_directory_iterator(m_camera->storageFolder())) {
            if (entry.path().filename() == name) {
                std::filesystem::copy_file(entry.path(), m_folder / "in" / name);
            }
        }
        const Eigen::Vector3d& p = at.station.positionM;
        writeFile(m_folder / "p.csv", bytesOf(text("file,x_m,y_m,z_m\n", name.string(), ",", p.x(), ",",
                                                   p.y(), ",", p.z(), "\n")));
        ASSERT_EQ(importPhotos(*m_store, {m_folder / "in", m_folder / "p.csv"}, noProgress(), {}).imported,
                  1);
    }
};

} // namespace

TEST_F(KnownPhoto, AShotWhosePictureWasImportedAtItsStationIsDoneWithThatPhoto) {
    takeWithoutDownload();
    const survey::Shot shot = m_store->openShots().at(1);
    importPicture(shot, m_stations.at(1));
    Cart cart(endpoint());
    const CaptureSurveyReport report = capture(cart);
    EXPECT_TRUE(report.missed.empty()) << report.missed.front().sentence;
    EXPECT_TRUE(m_store->openShots().empty());
    EXPECT_EQ(m_store->shot(shot.id).step, survey::ShotStep::Downloaded);
    EXPECT_EQ(m_store->photos().size(), m_stations.size());
    EXPECT_EQ(cart.exposures, 0);
    expectAllPhotosAreWhereTheyBelong();
}

TEST_F(KnownPhoto, AShotWhosePictureIsAtAnotherStationIsAskedAboutAndHoldsUpNoOther) {
    takeWithoutDownload();
    const survey::Shot shot = m_store->openShots().at(1);
    importPicture(shot, m_stations.at(0));
    Cart cart(endpoint());
    const CaptureSurveyReport report = capture(cart);
    EXPECT_EQ(report.taken, static_cast<int>(m_stations.size())); // its station was taken again
    EXPECT_TRUE(m_store->openShots().empty());
    const survey::Shot ended = m_store->shot(shot.id);
    EXPECT_EQ(ended.step, survey::ShotStep::Unclear);
    EXPECT_THAT(ended.note, testing::HasSubstr(m_stations.at(0).name));
    EXPECT_TRUE(m_store->stationsWithoutPhoto().empty());
    m_store->giveUp(shot.id);
    EXPECT_TRUE(m_store->unclearShots().empty());
}

TEST_F(KnownPhoto, AShotThatIsGivenUpIsNotFetchedAnyMore) {
    takeWithoutDownload();
    for (const survey::Shot& shot : m_store->openShots()) {
        m_store->giveUp(shot.id);
    }
    Cart cart(endpoint());
    const CaptureSurveyReport report = capture(cart);
    EXPECT_EQ(report.resumed, 0);
    EXPECT_EQ(report.taken, static_cast<int>(m_stations.size()));
    EXPECT_TRUE(report.missed.empty());
}

TEST_F(KnownPhoto, AnOlderPictureThatComesInLateDoesNotReplaceANewerOne) {
    takeWithoutDownload();
    practice::PracticeCameraOptions options;
    options.width = 1024;
    options.seed = 2;
    auto second = std::make_unique<practice::PracticeCamera>(options);
    second->start();
    std::swap(m_camera, second);
    Cart cart(endpoint());
    capture(cart); // the first camera's pictures are not to be had, and are taken again
    std::vector<std::int64_t> chosen;
    for (const store::PhotoRecord& photo : m_store->chosenPhotos()) {
        chosen.push_back(photo.id);
    }
    ASSERT_EQ(chosen.size(), m_stations.size());
    std::swap(m_camera, second);
    const CaptureSurveyReport late = capture(cart);
    EXPECT_EQ(late.resumed, static_cast<int>(m_stations.size()));
    EXPECT_EQ(late.warnings.size(), m_stations.size());
    EXPECT_THAT(late.warnings, testing::Each(testing::HasSubstr("stays chosen")));
    for (const std::int64_t photo : chosen) {
        EXPECT_TRUE(m_store->photo(photo).choose) << m_store->photo(photo).fileName;
    }
}

TEST_F(KnownPhoto, APictureThatCanNeverBeHadHoldsUpNothingOnceItsStationHasAnother) {
    m_camera->arm({practice::FaultKind::SmallPhoto, "camera.takePicture"});
    Cart cart(endpoint());
    EXPECT_EQ(capture(cart).missed.size(), 1U);
    EXPECT_TRUE(capture(cart).missed.empty()); // taken again
    EXPECT_TRUE(m_store->stationsWithoutPhoto().empty());
    ASSERT_EQ(m_store->openShots().size(), 1U); // it may still be had, if somebody repairs the file
    EXPECT_TRUE(capture(cart).missed.empty());
    m_store->giveUp(m_store->openShots().front().id);
    EXPECT_EQ(m_store->counts().openShots, 0);
}

} // namespace spherewalk::jobs
