// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "random.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/picture_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <spng.h>

namespace spherewalk {
namespace {

RgbImage noise(int width, int height, unsigned seed = 3) {
    test::Random random(seed);
    RgbImage picture(width, height);
    for (std::uint8_t& value : picture.values()) {
        value = static_cast<std::uint8_t>(random.integer(0, 255));
    }
    return picture;
}

RgbImage plain(int width, int height, std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
    RgbImage picture(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            picture.at(x, y)[0] = red;
            picture.at(x, y)[1] = green;
            picture.at(x, y)[2] = blue;
        }
    }
    return picture;
}

class PictureFile : public testing::Test {
  protected:
    test::TemporaryFolder folder;

    void expectRefused(ErrorKind kind, const std::string& part, ByteView bytes) const {
        writeFile(folder / "x.png", bytes);
        test::expectError(kind, part, [&] { photo::readPicture(folder / "x.png"); });
        test::expectError(kind, "x.png", [&] { photo::readPicture(folder / "x.png"); });
    }
};

TEST_F(PictureFile, PngKeepsEveryPixel) {
    for (const auto& [width, height] : {std::pair{1, 1}, std::pair{33, 17}, std::pair{1, 200}}) {
        const RgbImage picture = noise(width, height);
        photo::writePng(folder / "a.png", picture);
        EXPECT_EQ(photo::readPicture(folder / "a.png"), picture);
    }
}

// Grey, alpha and 16 bits, as other programs write them. Alpha is left out.
TEST_F(PictureFile, EveryKindOfPngBecomesColours) {
    const auto write = [&](spng_color_type colours, std::uint8_t bits, const Bytes& pixels) {
        const std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)> context(spng_ctx_new(SPNG_CTX_ENCODER),
                                                                          spng_ctx_free);
        spng_ihdr header{2, 1, bits, static_cast<std::uint8_t>(colours), 0, 0, 0};
        ASSERT_EQ(spng_set_ihdr(context.get(), &header), SPNG_OK);
        ASSERT_EQ(spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1), SPNG_OK);
        ASSERT_EQ(spng_encode_image(context.get(), pixels.data(), pixels.size(), SPNG_FMT_RAW,
                                    SPNG_ENCODE_FINALIZE),
                  SPNG_OK);
        std::size_t size = 0;
        int status = 0;
        const std::unique_ptr<void, decltype(&std::free)> png(
            spng_get_png_buffer(context.get(), &size, &status), std::free);
        writeFile(folder / "a.png", ByteView(static_cast<const std::uint8_t*>(png.get()), size));
    };
    const auto read = [&] {
        const RgbImage picture = photo::readPicture(folder / "a.png");
        return Bytes(picture.values().begin(), picture.values().end());
    };
    write(SPNG_COLOR_TYPE_GRAYSCALE, 8, {10, 200});
    EXPECT_EQ(read(), (Bytes{10, 10, 10, 200, 200, 200}));
    write(SPNG_COLOR_TYPE_GRAYSCALE_ALPHA, 8, {10, 0, 200, 128});
    EXPECT_EQ(read(), (Bytes{10, 10, 10, 200, 200, 200}));
    write(SPNG_COLOR_TYPE_TRUECOLOR_ALPHA, 8, {1, 2, 3, 0, 4, 5, 6, 7});
    EXPECT_EQ(read(), (Bytes{1, 2, 3, 4, 5, 6}));
    write(SPNG_COLOR_TYPE_TRUECOLOR, 16, {1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 6, 0});
    EXPECT_EQ(read(), (Bytes{1, 2, 3, 4, 5, 6}));
    test::expectError(ErrorKind::Unsupported, "16 bits", [&] { photo::readPng16(folder / "a.png"); });
    write(SPNG_COLOR_TYPE_GRAYSCALE, 16, {1, 2, 255, 255});
    EXPECT_EQ(*photo::readPng16(folder / "a.png").at(0, 0), 0x102);
    EXPECT_EQ(*photo::readPng16(folder / "a.png").at(1, 0), 0xFFFF);
}

TEST_F(PictureFile, JpegIsReadAsOurDecoderDoes) {
    const Bytes jpeg = jpeg::encode(noise(40, 30), 90);
    writeFile(folder / "a.jpg", jpeg);
    EXPECT_EQ(photo::readPicture(folder / "a.jpg"), jpeg::decode(jpeg, "a.jpg"));
}

TEST_F(PictureFile, EveryTruncationOfAPngIsRefused) {
    photo::writePng(folder / "a.png", noise(4, 3));
    const Bytes png = readFile(folder / "a.png");
    // The last four bytes check a chunk that is always the same.
    for (std::size_t size = 0; size + 4 < png.size(); ++size) {
        writeFile(folder / "x.png", ByteView(png).first(size));
        EXPECT_THROW(photo::readPicture(folder / "x.png"), Error) << size;
    }
}

TEST_F(PictureFile, HostileSizesAreRefused) {
    photo::writePng(folder / "a.png", noise(9, 5));
    Bytes png = readFile(folder / "a.png");
    const auto setSize = [&](std::uint32_t width, std::uint32_t height) {
        for (std::size_t i = 0; i < 4; ++i) {
            png[16 + i] = static_cast<std::uint8_t>(width >> (24 - 8 * i));
            png[20 + i] = static_cast<std::uint8_t>(height >> (24 - 8 * i));
        }
    };
    setSize(0, 5);
    expectRefused(ErrorKind::Corrupt, "damaged", png);
    setSize(0xFFFFFFFF, 0xFFFFFFFF);
    expectRefused(ErrorKind::Corrupt, "damaged", png);
    setSize(20000, 20000);
    expectRefused(ErrorKind::Corrupt, "damaged", png);
    png.resize(200000);
    expectRefused(ErrorKind::Unsupported, "reduce it", png);
}

TEST_F(PictureFile, NamesWhatIsNoPictureOrNotThere) {
    expectRefused(ErrorKind::Unsupported, "neither a PNG nor a JPEG", bytesOf("GIF89a"));
    expectRefused(ErrorKind::Unsupported, "neither a PNG nor a JPEG", {});
    test::expectError(ErrorKind::NotFound, "none.png", [&] { photo::readPicture(folder / "none.png"); });
    test::expectError(ErrorKind::InvalidInput, "empty",
                      [&] { photo::writePng(folder / "e.png", RgbImage()); });
    test::expectError(ErrorKind::NotFound, "b.png",
                      [&] { photo::writePng(folder / "no" / "b.png", noise(2, 2)); });
}

TEST(ResizedPicture, AveragesTheAreaOfEachPixel) {
    const RgbImage picture = noise(8, 6);
    const RgbImage half = photo::resized(picture, 4, 3);
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 4; ++x) {
            for (int c = 0; c < 3; ++c) {
                const int sum = picture.at(2 * x, 2 * y)[c] + picture.at(2 * x + 1, 2 * y)[c] +
                                picture.at(2 * x, 2 * y + 1)[c] + picture.at(2 * x + 1, 2 * y + 1)[c];
                EXPECT_NEAR(half.at(x, y)[c], sum / 4.0, 0.51);
            }
        }
    }
    EXPECT_EQ(photo::resized(picture, 8, 6), picture);
    test::expectError(ErrorKind::InvalidInput, "cannot be made", [&] { photo::resized(picture, 0, 3); });
    test::expectError(ErrorKind::InvalidInput, "cannot be made", [&] { photo::resized(picture, 65536, 1); });
    test::expectError(ErrorKind::InvalidInput, "cannot be made", [] { photo::resized(RgbImage(), 2, 2); });
}

TEST(ContactSheet, ShowsEveryPictureInItsCell) {
    const std::vector<RgbImage> pictures{plain(100, 50, 255, 0, 0), plain(40, 20, 0, 255, 0),
                                         plain(20, 10, 0, 0, 255)};
    const RgbImage sheet = photo::contactSheet(pictures, 2, 20);
    EXPECT_EQ(sheet.width(), 2 * 24 + 4);
    EXPECT_EQ(sheet.height(), 2 * 14 + 4);
    EXPECT_EQ(sheet.at(14, 9)[0], 255);
    EXPECT_EQ(sheet.at(38, 9)[1], 255);
    EXPECT_EQ(sheet.at(14, 23)[2], 255);
    EXPECT_EQ(sheet.at(38, 23)[0], sheet.at(0, 0)[0]);
}

TEST(ContactSheet, WritesCaptionsBelow) {
    const std::vector<RgbImage> pictures{plain(40, 20, 10, 10, 10), plain(40, 20, 10, 10, 10)};
    const std::vector<std::string> captions{"first", ""};
    const RgbImage sheet = photo::contactSheet(pictures, 2, 40, captions);
    const auto brightest = [&](int left) {
        int most = 0;
        for (int y = 24; y < sheet.height(); ++y) {
            for (int x = left; x < left + 40; ++x) {
                most = std::max<int>(most, sheet.at(x, y)[0]);
            }
        }
        return most;
    };
    EXPECT_GT(brightest(4), 150);
    EXPECT_LT(brightest(48), 60);
}

TEST(ContactSheet, RefusesWhatItCannotShow) {
    const std::vector<RgbImage> one{plain(4, 2, 0, 0, 0)};
    const auto refused = [](auto&& call) {
        test::expectError(ErrorKind::InvalidInput, "contact sheet", call);
    };
    refused([] { photo::contactSheet({}, 2, 40); });
    refused([&] { photo::contactSheet(one, 0, 40); });
    refused([&] { photo::contactSheet(one, 2, 0); });
    refused([&] { photo::contactSheet(one, 2, 65000000); });
    refused([&] { photo::contactSheet(std::vector<RgbImage>(1), 2, 40); });
    refused([&] { photo::contactSheet(one, 2, 40, std::vector<std::string>(2)); });
}

TEST(Psnr, FollowsItsFormula) {
    const RgbImage a = noise(16, 16);
    EXPECT_EQ(photo::psnr(a, a), HUGE_VAL);
    EXPECT_NEAR(photo::psnr(plain(3, 3, 0, 0, 0), plain(3, 3, 255, 255, 255)), 0, 1e-12);
    EXPECT_NEAR(photo::psnr(plain(3, 3, 10, 10, 10), plain(3, 3, 11, 9, 11)), 48.1308, 1e-4);
    EXPECT_NEAR(photo::psnr(plain(3, 3, 10, 10, 10), plain(3, 3, 13, 10, 10)), 43.3596, 1e-4);
    test::expectError(ErrorKind::InvalidInput, "one size", [&] { photo::psnr(a, noise(16, 15)); });
    test::expectError(ErrorKind::InvalidInput, "one size", [] { photo::psnr(RgbImage(), RgbImage()); });
}

} // namespace

TEST(DepthPng, HoldsWholeMillimetresAndNoneForZero) {
    const test::TemporaryFolder folder;
    Image<std::uint16_t, 1> millimetres(3, 1);
    *millimetres.at(0, 0) = 1234;
    *millimetres.at(2, 0) = 65535;
    photo::writePng(folder / "depth.png", millimetres);
    EXPECT_EQ(photo::readPng16(folder / "depth.png"), millimetres);
    const DepthImage read = photo::readDepthPng(folder / "depth.png");
    EXPECT_FLOAT_EQ(*read.at(0, 0), 1.234F);
    EXPECT_EQ(*read.at(1, 0), HUGE_VALF);
    EXPECT_FLOAT_EQ(*read.at(2, 0), 65.535F);
    test::expectError(ErrorKind::InvalidInput, "empty",
                      [&] { photo::writePng(folder / "none.png", Image<std::uint16_t, 1>()); });
}

} // namespace spherewalk
