// SPDX-License-Identifier: GPL-3.0-or-later
#include "survey_fixture.h"

#include <cmath>

namespace spherewalk::store {

namespace {

class PhotoRecords : public test::SurveyTest {};

} // namespace

TEST_F(PhotoRecords, KeepEveryField) {
    NewPhoto photo = photoOf(stationAt(2), "a");
    photo.note = "Żółć: lamp was off";
    photo.takenAt = Moment(std::chrono::milliseconds(1767323045678));
    const std::int64_t id = m_store.addPhoto(photo);
    const PhotoRecord read = SurveyStore::open(m_path, Access::Read).photo(id);
    EXPECT_EQ(read.station, photo.station);
    EXPECT_EQ(read.fileName, photo.fileName);
    EXPECT_EQ(read.cameraFileName, photo.cameraFileName);
    EXPECT_EQ(read.cameraSerial, photo.cameraSerial);
    EXPECT_EQ(read.fileUrl, photo.fileUrl);
    EXPECT_EQ(read.cameraSha256, photo.cameraSha256);
    EXPECT_EQ(read.fileSha256, photo.fileSha256);
    EXPECT_EQ(read.sizeBytes, photo.sizeBytes);
    EXPECT_EQ(read.width, photo.width);
    EXPECT_EQ(read.height, photo.height);
    EXPECT_EQ(read.takenAt, photo.takenAt);
    EXPECT_EQ(read.positionM, photo.positionM);
    EXPECT_EQ(read.note, photo.note);
    EXPECT_TRUE(read.choose);
    EXPECT_EQ(m_store.findPhoto(photo.cameraSha256)->id, id);
    EXPECT_FALSE(m_store.findPhoto(std::string(64, '0')).has_value());
}

TEST_F(PhotoRecords, HaveExactlyOneChosenPhotoAtAStation) {
    const std::int64_t station = stationAt(0);
    NewPhoto first = photoOf(station, "a");
    first.choose = false;
    const std::int64_t a = m_store.addPhoto(first);
    EXPECT_EQ(m_store.chosenPhoto(station)->id, a) << "the only one is chosen in any case";
    const std::int64_t b = m_store.addPhoto(photoOf(station, "b"));
    EXPECT_EQ(m_store.chosenPhoto(station)->id, b);
    NewPhoto third = photoOf(station, "c");
    third.choose = false;
    m_store.addPhoto(third);
    EXPECT_EQ(m_store.chosenPhoto(station)->id, b);
    m_store.choosePhoto(a);
    EXPECT_EQ(m_store.chosenPhoto(station)->id, a);
    EXPECT_EQ(m_store.chosenPhotos().size(), 1U);
    EXPECT_EQ(m_store.photosAt(station).size(), 3U);
    EXPECT_FALSE(m_store.chosenPhoto(stationAt(1)).has_value());
}

TEST_F(PhotoRecords, LeaveTheStationsWithoutOneInWalkingOrder) {
    m_store.addPhoto(photoOf(stationAt(0), "a"));
    m_store.addPhoto(photoOf(stationAt(3), "b"));
    std::vector<StationRecord> expected = m_store.stations();
    expected.erase(expected.begin() + 3);
    expected.erase(expected.begin());
    const std::vector<StationRecord> left = m_store.stationsWithoutPhoto();
    ASSERT_EQ(left.size(), expected.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
        EXPECT_EQ(left[i].id, expected[i].id);
    }
    EXPECT_EQ(m_store.counts().stationsWithPhoto, 2);
    EXPECT_EQ(m_store.counts().photos, 2);
    EXPECT_EQ(m_store.counts().stations, 24);
}

TEST_F(PhotoRecords, RefuseThePhotoThatIsThereAlready) {
    NewPhoto photo = photoOf(stationAt(0), "a");
    m_store.addPhoto(photo);
    photo.station = stationAt(1);
    photo.fileName = "again.JPG";
    writeFile(m_store.photoFolder() / photo.fileName, bytesOf("a"));
    expectRefused(ErrorKind::Exists,
                  "The photo again.JPG is in the survey already, as a.JPG at rail 1, stop 1 at 1.60 m.",
                  [&] { m_store.addPhoto(photo); });
    NewPhoto other = photoOf(stationAt(1), "b");
    other.fileName = "A.jpg";
    expectRefused(ErrorKind::Exists, "a.JPG at rail 1, stop 1 at 1.60 m has that name; choose another.",
                  [&] { m_store.addPhoto(other); });
    EXPECT_EQ(m_store.photos().size(), 1U);
}

TEST_F(PhotoRecords, RefuseAnUnknownStationAndAnUnknownPhoto) {
    expectRefused(ErrorKind::NotFound, "There is no station 77 in the survey",
                  [&] { m_store.addPhoto(photoOf(77, "a")); });
    expectRefused(ErrorKind::NotFound, "There is no photo 5 in the survey", [&] { m_store.choosePhoto(5); });
}

TEST_F(PhotoRecords, RefuseAFileThatIsNotThereOrShort) {
    NewPhoto photo = photoOf(stationAt(0), "a");
    ++photo.sizeBytes;
    expectRefused(ErrorKind::Corrupt, "it has 1 bytes, and should have 2 bytes",
                  [&] { m_store.addPhoto(photo); });
    photo.fileName = "none.JPG";
    expectRefused(ErrorKind::NotFound, "there is no such file", [&] { m_store.addPhoto(photo); });
    EXPECT_EQ(m_store.counts().photos, 0);
}

TEST_F(PhotoRecords, RefuseValuesThatCannotBe) {
    const NewPhoto good = photoOf(stationAt(0), "a");
    const auto expect = [&](const std::string& part, const std::function<void(NewPhoto&)>& spoil) {
        NewPhoto photo = good;
        spoil(photo);
        expectRefused(ErrorKind::InvalidInput, part, [&] { m_store.addPhoto(photo); });
    };
    for (const std::string name : {"../a.JPG", "", "/etc/passwd", "x/a.JPG", "."}) {
        expect("its name is no file's name", [&](NewPhoto& photo) { photo.fileName = name; });
    }
    expect("SHA-256", [](NewPhoto& photo) { photo.cameraSha256 = "ABC"; });
    expect("SHA-256", [](NewPhoto& photo) { photo.fileSha256[0] = 'G'; });
    expect("it cannot have 0 x 2688 pixels", [](NewPhoto& photo) { photo.width = 0; });
    expect("its position is not a number", [](NewPhoto& photo) { photo.positionM.y() = NAN; });
    expect("The photo's note", [](NewPhoto& photo) { photo.note = "\xff"; });
    EXPECT_EQ(m_store.counts().photos, 0);
}

TEST_F(PhotoRecords, GiveTheCamerasNameWhileItIsFree) {
    const std::string hash = sha256Hex(bytesOf("new"));
    EXPECT_EQ(m_store.freePhotoName("R0010001.JPG", hash), "R0010001.JPG");
    m_store.addPhoto(test::newPhoto(m_store, stationAt(0), "old", "R0010001.JPG"));
    EXPECT_EQ(m_store.freePhotoName("R0010001.JPG", hash), "R0010001_" + hash.substr(0, 8) + ".JPG");
    EXPECT_EQ(m_store.freePhotoName("r0010001.jpg", hash), "r0010001_" + hash.substr(0, 8) + ".jpg");
}

TEST_F(PhotoRecords, DoNotGiveTheNameOfAForeignFileButOfTheirOwnLeftOver) {
    writeFile(m_store.photoFolder() / "R1.JPG", bytesOf("left over"));
    EXPECT_EQ(m_store.freePhotoName("R1.JPG", sha256Hex(bytesOf("left over"))), "R1.JPG");
    const std::string hash = sha256Hex(bytesOf("other"));
    EXPECT_EQ(m_store.freePhotoName("R1.JPG", hash), "R1_" + hash.substr(0, 8) + ".JPG");
}

TEST_F(PhotoRecords, ReplaceNamesThatAreNoFiles) {
    const std::string hash(64, 'a');
    for (const std::string name : {"", "..", "../../x.JPG", "a/b.JPG", "a\nb.JPG", ".hidden"}) {
        EXPECT_EQ(m_store.freePhotoName(name, hash), "photo.JPG") << name;
    }
    EXPECT_EQ(m_store.freePhotoName(std::string(300, 'x'), hash), "photo.JPG");
}

TEST(PhotoAtStation, IsNamedOnce) {
    EXPECT_EQ(photoAtStation("R1.JPG", "rail 3, stop 5"), "R1.JPG (rail 3, stop 5)");
    EXPECT_EQ(photoAtStation("R1.JPG", "unknown place of R1.JPG"), "R1.JPG");
    EXPECT_EQ(photoAtStation("R1.JPG", "place of R1.JPG"), "R1.JPG");
    EXPECT_EQ(photoAtStation("R1.JPG", "place of R11.JPG"), "R1.JPG (place of R11.JPG)");
    EXPECT_EQ(photoAtStation("R1_0123abcd.JPG", "place of R1.JPG"), "R1_0123abcd.JPG");
    EXPECT_EQ(photoAtStation("R1.JPG", "unplanned position (1.20, 3.40)"), "R1.JPG");
    EXPECT_EQ(photoAtStation("_1", "in the middle"), "_1 (in the middle)");
}

} // namespace spherewalk::store
