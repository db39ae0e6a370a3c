// SPDX-License-Identifier: GPL-3.0-or-later
#include "photographed_survey.h"
#include "qt_application.h"
#include "ui/panorama/photo_pictures.h"

#include <QTest>

namespace spherewalk::ui {

namespace {

class PhotoDecoderTest : public testing::Test {
  protected:
    std::filesystem::path photo(std::size_t index) const {
        return survey.open().photoFolder() / survey.open().photos().at(index).fileName;
    }

    bool waitFor(const std::filesystem::path& file) {
        return QTest::qWaitFor([&] { return decoder.find(file) && decoder.find(file)->denominator == 1; });
    }

    test::PhotographedSurvey survey{2};
    PhotoDecoder decoder;
};

} // namespace

TEST_F(PhotoDecoderTest, DecodesAWantedPhotoInFull) {
    EXPECT_FALSE(decoder.find(photo(0)));
    decoder.want({photo(0)});
    EXPECT_TRUE(waitFor(photo(0)));
    EXPECT_TRUE(decoder.sentence(photo(0)).isEmpty());
}

TEST_F(PhotoDecoderTest, KeepsThePhotoThatWasWantedBefore) {
    decoder.want({photo(0)});
    ASSERT_TRUE(waitFor(photo(0)));
    decoder.want({photo(1)});
    ASSERT_TRUE(waitFor(photo(1)));
    EXPECT_TRUE(decoder.find(photo(0)));
}

TEST_F(PhotoDecoderTest, SaysWhyAPhotoCannotBeDecoded) {
    const std::filesystem::path missing = survey / "missing.JPG";
    decoder.want({missing});
    EXPECT_TRUE(QTest::qWaitFor([&] { return !decoder.sentence(missing).isEmpty(); }));
    EXPECT_FALSE(decoder.find(missing));
}

TEST(QtImage, HasTheSamePixels) {
    RgbImage picture(3, 2);
    picture.row(1)[3 * 2] = 200;
    const QImage copy = qtImage(picture);
    EXPECT_EQ(copy.size(), QSize(3, 2));
    EXPECT_EQ(copy.pixelColor(2, 1), QColor(200, 0, 0));
}

} // namespace spherewalk::ui
