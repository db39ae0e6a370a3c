// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "picture/made_photo.h"
#include "temporary_folder.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/file.h"
#include "spherewalk/photo/integrity.h"

#include <gtest/gtest.h>

namespace spherewalk {
namespace {

class PhotoIntegrity : public testing::Test {
  protected:
    Bytes photo = test::madePhoto(test::madeExif({.theta = test::thetaFields()}).tiff, "", 512, 256);

    static void expectRefused(const Bytes& jpeg, const std::string& part,
                              const photo::PhotoExpectation& expectation = {}) {
        test::expectError(ErrorKind::Corrupt, part,
                          [&] { photo::checkPhoto(jpeg, "R0010001.JPG", expectation); });
        test::expectError(ErrorKind::Corrupt, "R0010001.JPG",
                          [&] { photo::checkPhoto(jpeg, "R0010001.JPG", expectation); });
    }
};

TEST_F(PhotoIntegrity, TellsSizeAndHashOfAWholePhoto) {
    const photo::PhotoFacts expected{photo.size(), 512, 256, sha256Hex(photo)};
    EXPECT_EQ(photo::checkPhoto(photo, "a.jpg", {photo.size(), sha256Hex(photo), 512}), expected);
    const test::TemporaryFolder folder;
    writeFile(folder / "a.jpg", photo);
    EXPECT_EQ(photo::checkPhotoFile(folder / "a.jpg"), expected);
}

TEST_F(PhotoIntegrity, ToleratesPaddingBehindTheEnd) {
    photo.insert(photo.end(), 1000, std::uint8_t{0});
    EXPECT_EQ(photo::checkPhoto(photo, "a.jpg").width, 512);
    photo.insert(photo.end(), 7, std::uint8_t{0xFF});
    EXPECT_EQ(photo::checkPhoto(photo, "a.jpg").width, 512);
}

TEST_F(PhotoIntegrity, RefusesAnotherSizeOrHash) {
    expectRefused(photo, "instead of", {.sizeBytes = photo.size() + 1});
    expectRefused(photo, "SHA-256", {.sha256 = std::string(64, '0')});
}

TEST_F(PhotoIntegrity, RefusesAPhotoCutAnywhere) {
    for (std::size_t size = 0; size < photo.size(); size += 1 + photo.size() / 400) {
        SCOPED_TRACE(size);
        expectRefused(Bytes(photo.begin(), photo.begin() + static_cast<std::ptrdiff_t>(size)), "photo");
    }
    expectRefused(Bytes(photo.begin(), photo.end() - 1), "end is missing");
    expectRefused({}, "not a JPEG");
}

TEST_F(PhotoIntegrity, RefusesAPhotoWithAGapEvenIfItsEndIsThere) {
    const auto middle = photo.begin() + static_cast<std::ptrdiff_t>(photo.size() * 3 / 4);
    photo.erase(middle, middle + static_cast<std::ptrdiff_t>(photo.size() / 5));
    expectRefused(photo, "R0010001.JPG");
}

TEST_F(PhotoIntegrity, RefusesWhatIsNotSphericalOrTooSmall) {
    expectRefused(test::madePhoto(ByteView(), "", 640, 319), "not spherical");
    expectRefused(test::madePhoto(ByteView(), "", 510, 255), "preview");
    EXPECT_EQ(photo::checkPhoto(test::madePhoto(ByteView(), "", 510, 255), "a", {.minWidth = 510}).width,
              510);
}

TEST_F(PhotoIntegrity, NamesOddFilesAsWhatTheyAreWithTheCure) {
    const auto begins = [](std::string_view head) {
        Bytes file(head.begin(), head.end());
        file.resize(200, 7);
        return file;
    };
    using namespace std::string_view_literals;
    expectRefused(begins("\x89PNG\r\n\x1a\n"sv), "a PNG and not a JPEG; save it as a JPEG");
    expectRefused(begins("\0\0\0\x18"
                         "ftypheic"sv),
                  "a HEIF picture");
    expectRefused(begins("\0\0\0\x18"
                         "ftypisom"sv),
                  "an MP4 video");
    expectRefused(begins("II*\0"sv), "a TIFF or a raw picture");
    expectRefused(begins("RIFF\0\0\0\0WEBP"sv), "a WebP picture");
    const std::string cropped =
        test::gpanoXmp("<GPano:FullPanoHeightPixels>2688</GPano:FullPanoHeightPixels>");
    expectRefused(test::madePhoto(ByteView(), cropped, 640, 200),
                  "a part of a panorama, 640 x 200 pixels of 5376 x 2688; export the whole sphere");
    expectRefused(test::madePhoto(ByteView(), "", 256, 512), "lies on its side");
    expectRefused(test::madePhoto(ByteView(), "", 640, 480), "as a whole stitched sphere");
}

TEST_F(PhotoIntegrity, NamesAMissingFile) {
    const test::TemporaryFolder folder;
    test::expectError(ErrorKind::NotFound, "none.jpg", [&] { photo::checkPhotoFile(folder / "none.jpg"); });
}

} // namespace
} // namespace spherewalk
