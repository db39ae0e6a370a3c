// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "random.h"
#include "temporary_folder.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/file.h"
#include "spherewalk/dataset/writer.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/jpeg/restart.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/render/dataset.h"

#include <algorithm>

namespace spherewalk::dataset {

namespace fs = std::filesystem;
using test::expectError;
using test::TemporaryFolder;

namespace {

RgbImage noise(int width, int height, unsigned seed) {
    test::Random random(seed);
    RgbImage picture(width, height);
    for (std::uint8_t& value : picture.values()) {
        value = static_cast<std::uint8_t>(random.integer(0, 255));
    }
    return picture;
}

class WriterTest : public testing::Test {
  protected:
    WriterTest() {
        contents.info.id = contents.info.surveyId = "id";
        contents.info.name = "Küche";
        for (int i = 0; i < 3; ++i) {
            addPhoto("R001000" + std::to_string(i) + ".JPG",
                     jpeg::encode(noise(320, 160, static_cast<unsigned>(i)), 90));
        }
    }

    void addPhoto(const std::string& name, const Bytes& jpeg) {
        writeFile(folder / name, jpeg);
        render::DatasetPhoto entry;
        entry.roomFromPhoto = {Eigen::Quaterniond::Identity(),
                               {static_cast<double>(contents.photos.size()), 0, 1}};
        entry.rotationSource = "imported";
        contents.photos.push_back({folder / name, sha256Hex(jpeg), entry});
    }

    WriteReport write(const std::stop_token& stop = {}) {
        return writeDataset(contents, out, {}, noProgress(), stop);
    }

    /// What lies in the parent folder besides the source photos.
    std::vector<std::string> leftovers() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder.path())) {
            if (entry.path().extension() != ".JPG" && entry.path() != out) {
                names.push_back(entry.path().filename());
            }
        }
        return names;
    }

    TemporaryFolder folder;
    fs::path out = folder / "data set ü";
    Contents contents;
};

} // namespace

TEST_F(WriterTest, WritesADatasetThatOpensAndKeepsEveryPixel) {
    const WriteReport report = write();
    EXPECT_EQ(report.photos, 3U);
    EXPECT_TRUE(leftovers().empty());
    const render::Dataset dataset = render::Dataset::open(out, render::Verify::Hashes);
    ASSERT_EQ(dataset.info().photos.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        const render::DatasetPhoto& photo = dataset.info().photos[i];
        const Bytes written = dataset.readPhoto(i);
        EXPECT_EQ(jpeg::decode(written, "x"), jpeg::decode(readFile(contents.photos[i].file), "x"));
        EXPECT_EQ(photo.file, "photos/" + contents.photos[i].file.stem().string() + ".jpg");
        EXPECT_EQ(photo.roomFromPhoto.translation, contents.photos[i].entry.roomFromPhoto.translation);
        const jpeg::RestartIndex index = jpeg::parseRestartIndex(readFile(out / photo.restartIndex), "x");
        EXPECT_EQ(index, jpeg::indexRestarts(written, "x"));
        EXPECT_EQ(index.mcusPerInterval, 10); // of the 20 in a row, the nearest to 8
        EXPECT_EQ(index.fileSizeBytes, written.size());
        // An ordinary viewer's decoder reads photo and thumbnail.
        EXPECT_EQ(photo::readPicture(out / photo.file).width(), 320);
        EXPECT_GT(photo::readPicture(out / photo.thumbnail).width(), 100);
    }
}

TEST_F(WriterTest, ThumbnailsAreMeansOfTheAreasThatTheyShow) {
    RgbImage bright(1280, 640);
    std::fill(bright.values().begin(), bright.values().end(), std::uint8_t{40});
    for (int y = 0; y < 640; ++y) { // a fine pattern in the right half, whose mean is 140
        for (int x = 640; x < 1280; ++x) {
            std::fill_n(bright.at(x, y), 3, static_cast<std::uint8_t>(x % 2 == 0 ? 40 : 240));
        }
    }
    addPhoto("fine.JPG", jpeg::encode(bright, 95));
    WriteOptions options;
    options.thumbnailWidth = 200;
    writeDataset(contents, out, options, noProgress(), {});
    const render::Dataset dataset = render::Dataset::open(out);
    const RgbImage thumbnail = photo::readPicture(out / dataset.info().photos[3].thumbnail);
    ASSERT_EQ(thumbnail.width(), 200);
    ASSERT_EQ(thumbnail.height(), 100);
    for (int y = 10; y < 90; y += 10) {
        EXPECT_NEAR(*thumbnail.at(50, y), 40, 4) << y;
        EXPECT_NEAR(*thumbnail.at(150, y), 140, 6) << y;
    }
    // A photo that is smaller than a thumbnail keeps its size.
    EXPECT_EQ(photo::readPicture(out / dataset.info().photos[0].thumbnail).width(), 200);
    addPhoto("small.JPG", jpeg::encode(noise(64, 32, 9), 90));
    out = folder / "second";
    writeDataset(contents, out, options, noProgress(), {});
    EXPECT_EQ(photo::readPicture(out / "thumbnails/small.jpg").width(), 64);
}

TEST_F(WriterTest, CopiesDepthAndCountsEveryByte) {
    writeFile(folder / "depth.JPG", bytesOf("a depth map"));
    contents.photos[1].depthFile = folder / "depth.JPG";
    const WriteReport report = write();
    EXPECT_EQ(textOf(readFile(out / "depth" / "R0010001.pgm")), "a depth map");
    std::uint64_t all = 0;
    for (const auto& entry : fs::recursive_directory_iterator(out)) {
        all += entry.is_regular_file() ? entry.file_size() : 0;
    }
    EXPECT_EQ(report.totalBytes, all);
    EXPECT_GT(report.photoBytes, report.sourceBytes); // restart markers take room
}

TEST_F(WriterTest, LeavesTheIndexOfFurtherPicturesOutWithThePictures) {
    Bytes photo = jpeg::encode(noise(320, 160, 9), 90);
    const Bytes whole = photo;
    const std::string index("\xff\xe2\x00\x0aMPF\0II*\0", 12);
    photo.insert(photo.begin() + 2, index.begin(), index.end());
    photo.insert(photo.end(), whole.begin(), whole.end()); // the second picture
    addPhoto("GOPRO.JPG", photo);
    write();
    const Bytes exported = readFile(out / "photos/GOPRO.jpg");
    for (const jpeg::Segment& segment : jpeg::segments(exported, "exported")) {
        EXPECT_NE(segment.marker, 0xE2);
    }
    EXPECT_EQ(jpeg::decode(exported, "exported"), jpeg::decode(whole, "whole"));
}

TEST_F(WriterTest, ReplacesNothing) {
    fs::create_directories(out);
    expectError(ErrorKind::Exists, "exists already", [&] { write(); });
    EXPECT_TRUE(fs::is_empty(out));
}

TEST_F(WriterTest, KeepsPhotosApartThatHaveOneName) {
    fs::create_directories(folder / "b.JPG");
    const Bytes other = jpeg::encode(noise(64, 32, 9), 90);
    addPhoto("b.JPG/R0010000.JPG", other);
    write();
    const render::Dataset dataset = render::Dataset::open(out);
    EXPECT_EQ(dataset.info().photos[0].file, "photos/R0010000.jpg");
    EXPECT_EQ(dataset.info().photos[3].file, "photos/R0010000_2.jpg");
    EXPECT_EQ(jpeg::decode(dataset.readPhoto(3), "x"), jpeg::decode(other, "x"));
}

TEST_F(WriterTest, LeavesNothingAfterAnyFailure) {
    Bytes changed = readFile(contents.photos[1].file);
    changed[changed.size() / 2] ^= 1;
    writeFile(contents.photos[1].file, changed);
    expectError(ErrorKind::Corrupt, "R0010001.JPG: the file was changed", [&] { write(); });
    EXPECT_TRUE(leftovers().empty());
    EXPECT_FALSE(fs::exists(out));

    fs::remove(contents.photos[1].file);
    expectError(ErrorKind::NotFound, "R0010001.JPG", [&] { write(); });
    contents.photos.erase(contents.photos.begin() + 1);
    addPhoto("square.JPG", jpeg::encode(noise(64, 64, 1), 90));
    expectError(ErrorKind::Corrupt, "64 x 64", [&] { write(); });
    contents.photos.clear();
    expectError(ErrorKind::InvalidInput, "nothing to export", [&] { write(); });
    EXPECT_TRUE(leftovers().empty());
    EXPECT_FALSE(fs::exists(out));
}

TEST_F(WriterTest, StopsWhenAskedAndLeavesNothing) {
    std::stop_source stop;
    stop.request_stop();
    expectError(ErrorKind::Stopped, "Stopped", [&] { write(stop.get_token()); });
    EXPECT_TRUE(leftovers().empty());
    EXPECT_FALSE(fs::exists(out));
}

TEST(WriteOptions, RefusesWhatTheFormatCannotHold) {
    for (const WriteOptions& options :
         {WriteOptions{0, 512, 0}, WriteOptions{65536, 512, 0}, WriteOptions{8, 1, 0}}) {
        expectError(ErrorKind::InvalidInput, "restart markers", [&] { options.validate(); });
    }
}

} // namespace spherewalk::dataset
