// SPDX-License-Identifier: GPL-3.0-or-later
#include "photographed_survey.h"
#include "qt_application.h"
#include "ui/panorama/photo_pictures.h"

#include <QSignalSpy>
#include <QTest>

namespace spherewalk::ui {

namespace {

class Thumbnails : public testing::Test {
  protected:
    QImage fetched(ThumbnailCache& cache, const std::filesystem::path& picture, const QString& hash) {
        QSignalSpy ready(&cache, &ThumbnailCache::ready);
        if (cache.find(picture, hash).isNull()) {
            ready.wait();
        }
        return cache.find(picture, hash);
    }

    test::PhotographedSurvey survey{1};
    store::PhotoRecord photo = survey.open().photos().at(0);
    std::filesystem::path file = survey.open().photoFolder() / photo.fileName;
    QString sha256 = QString::fromStdString(photo.fileSha256);
};

} // namespace

TEST_F(Thumbnails, AreMadeInTheBackground) {
    ThumbnailCache cache(survey / "cache");
    EXPECT_TRUE(cache.find(file, sha256).isNull());
    const QImage picture = fetched(cache, file, sha256);
    EXPECT_EQ(picture.size(), QSize(ThumbnailCache::kWidth, ThumbnailCache::kHeight));
    // The middle of the picture looks along x, where the world is red.
    const QColor middle = picture.pixelColor(picture.rect().center());
    EXPECT_GT(middle.red(), middle.blue() + 30);
}

TEST_F(Thumbnails, AreKeptOnTheDiskByTheirHash) {
    {
        ThumbnailCache cache(survey / "cache");
        fetched(cache, file, sha256);
    }
    ThumbnailCache later(survey / "cache");
    EXPECT_FALSE(fetched(later, survey / "moved-away.JPG", sha256).isNull());
}

TEST_F(Thumbnails, AreMadeAgainIfTheKeptOneIsBroken) {
    std::filesystem::create_directories(survey / "cache");
    writeFile((survey / "cache") / (sha256.toStdString() + ".jpg"), bytesOf("broken"));
    ThumbnailCache cache(survey / "cache");
    EXPECT_FALSE(fetched(cache, file, sha256).isNull());
}

TEST_F(Thumbnails, SayWhichPhotoCannotBeRead) {
    ThumbnailCache cache(survey / "cache");
    fetched(cache, survey / "nothing.JPG", "0");
    EXPECT_TRUE(cache.isUnreadable("0"));
    EXPECT_FALSE(cache.isUnreadable(sha256));
}

} // namespace spherewalk::ui
