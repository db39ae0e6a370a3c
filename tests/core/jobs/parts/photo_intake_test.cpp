// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "made_survey.h"
#include "parts/photo_intake.h"
#include "temporary_folder.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/file.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/position_tag.h"

#include <algorithm>

namespace spherewalk::jobs {

using test::expectError;

namespace {

Bytes photoOf(std::uint8_t level) {
    RgbImage picture(512, 256);
    std::fill(picture.values().begin(), picture.values().end(), level);
    return jpeg::encode(picture, 90);
}

class PhotoIntake : public testing::Test {
  protected:
    PhotoIntake()
        : m_store(
              store::SurveyStore::open(test::makeSurvey(m_folder / "s.spherewalk"), store::Access::Write)) {}

    Arrival arrival(std::uint8_t level, const std::string& name = "R001.JPG") {
        Arrival arrival;
        arrival.jpeg = photoOf(level);
        arrival.source = "in/" + name;
        arrival.station = m_store.stations().at(0).id;
        arrival.positionM = {1, 2, 1.2};
        arrival.cameraFileName = name;
        arrival.cameraSerial = "YL001";
        arrival.fileUrl = "http://camera/" + name;
        return arrival;
    }

    std::size_t filesInTheSurvey() const {
        const std::filesystem::directory_iterator files(m_store.photoFolder());
        return static_cast<std::size_t>(std::distance(begin(files), end(files)));
    }

    test::TemporaryFolder m_folder;
    store::SurveyStore m_store;
};

} // namespace

TEST_F(PhotoIntake, KeepsEveryPixelAndSaysWhereThePhotoWasTaken) {
    const Arrival given = arrival(90);
    const store::NewPhoto row = takeIn(m_store, given);
    const Bytes file = readFile(m_store.photoFolder() / row.fileName);
    const RgbImage kept = jpeg::decode(file, "file");
    const RgbImage original = jpeg::decode(given.jpeg, "given");
    EXPECT_TRUE(std::ranges::equal(kept.values(), original.values()));
    const auto tag = photo::readPositionTag(file, "file");
    ASSERT_TRUE(tag);
    EXPECT_EQ(tag->positionM, Eigen::Vector3d(1, 2, 1.2));
    EXPECT_EQ(tag->surveyId, m_store.info().uuid);
    EXPECT_EQ(tag->stationId, given.station);
    EXPECT_EQ(tag->stationName, m_store.stations().at(0).name);
}

TEST_F(PhotoIntake, ReturnsTheRowOfTheFile) {
    const Arrival given = arrival(90);
    const store::NewPhoto row = takeIn(m_store, given);
    EXPECT_EQ(row.fileSha256, sha256HexOfFile(m_store.photoFolder() / row.fileName));
    EXPECT_EQ(row.cameraSha256, sha256Hex(given.jpeg));
    EXPECT_EQ(row.sizeBytes, std::filesystem::file_size(m_store.photoFolder() / row.fileName));
    EXPECT_EQ(row.width, 512);
    EXPECT_EQ(row.height, 256);
    EXPECT_EQ(row.station, given.station);
    EXPECT_EQ(row.cameraFileName, "R001.JPG");
    EXPECT_EQ(row.cameraSerial, "YL001");
    EXPECT_EQ(row.fileUrl, "http://camera/R001.JPG");
    EXPECT_FALSE(row.takenAt) << "the photo states no time";
}

TEST_F(PhotoIntake, RecordsNothingByItself) {
    takeIn(m_store, arrival(90));
    EXPECT_TRUE(m_store.photos().empty());
    EXPECT_EQ(filesInTheSurvey(), 1U);
}

TEST_F(PhotoIntake, ReplacesTheFileOfATryThatWasKilledBeforeTheRow) {
    const store::NewPhoto first = takeIn(m_store, arrival(90));
    const store::NewPhoto second = takeIn(m_store, arrival(90));
    EXPECT_EQ(second.fileName, first.fileName);
    EXPECT_EQ(filesInTheSurvey(), 1U);
}

TEST_F(PhotoIntake, GivesAnotherPhotoOfTheSameNameAnotherFile) {
    const store::NewPhoto first = takeIn(m_store, arrival(90));
    m_store.addPhoto(first);
    const Bytes before = readFile(m_store.photoFolder() / first.fileName);
    const store::NewPhoto second = takeIn(m_store, arrival(120));
    m_store.addPhoto(second);
    EXPECT_NE(second.fileName, first.fileName);
    EXPECT_EQ(readFile(m_store.photoFolder() / first.fileName), before);
    EXPECT_EQ(m_store.photos().size(), 2U);
    EXPECT_TRUE(m_store.check(noProgress(), {}).isSound());
}

TEST_F(PhotoIntake, PutsAKnownRotationIntoTheTag) {
    Arrival given = arrival(90);
    given.roomFromPhoto = Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5);
    const store::NewPhoto row = takeIn(m_store, given);
    const auto tag = photo::readPositionTag(readFile(m_store.photoFolder() / row.fileName), "file");
    ASSERT_TRUE(tag);
    ASSERT_TRUE(tag->roomFromPhoto);
    EXPECT_LT(tag->roomFromPhoto->angularDistance(*given.roomFromPhoto), 1e-9);
}

TEST_F(PhotoIntake, RefusesWhatIsNoWholePhoto) {
    for (const std::size_t size : {std::size_t{0}, std::size_t{2}, std::size_t{100}}) {
        SCOPED_TRACE(size);
        Arrival cut = arrival(90);
        cut.jpeg.resize(size);
        expectError(ErrorKind::Corrupt, "in/R001.JPG", [&] { takeIn(m_store, cut); });
    }
    EXPECT_EQ(filesInTheSurvey(), 0U);
}

TEST_F(PhotoIntake, SaysThatTheSurveysFolderIsGoneAndNotThePhoto) {
    std::filesystem::remove_all(m_store.photoFolder());
    expectError(ErrorKind::Io, "", [&] { takeIn(m_store, arrival(90)); });
}

} // namespace spherewalk::jobs
