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

} // namespace spherewalk::jobs
