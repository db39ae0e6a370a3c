// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "qt_application.h"
#include "temporary_folder.h"
#include "ui/map/floor_picture.h"
#include "ui/map/robot_map_file.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace spherewalk::ui {

namespace {

QString pathIn(const test::TemporaryFolder& folder, const char* name) {
    return QString::fromStdString((folder / name).string());
}

QString pictureIn(const test::TemporaryFolder& folder) {
    const QString file = pathIn(folder, "plan.png");
    EXPECT_TRUE(QImage(50, 20, QImage::Format_RGB32).save(file));
    return file;
}

/// A map of 4 x 3 pixels: a wall at the left, floor, and one unknown pixel at the upper right.
QString robotMapIn(const test::TemporaryFolder& folder, const std::string& more) {
    std::string pixels = "P5\n4 3\n255\n";
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 4; ++x) {
            pixels += static_cast<char>(x == 0 ? 0 : x == 3 && y == 0 ? 205 : 254);
        }
    }
    writeFile(folder / "map.pgm", bytesOf(pixels));
    writeFile(folder / "map.yaml", bytesOf("image: map.pgm\nresolution: 0.05\n" + more));
    return pathIn(folder, "map.yaml");
}

void expectPlace(const FloorPicture& picture, const QPointF& pixel, const QPointF& place) {
    const QPointF found = picture.roomFromPicture().map(pixel);
    EXPECT_NEAR(found.x(), place.x(), 1e-9);
    EXPECT_NEAR(found.y(), place.y(), 1e-9);
}

} // namespace

TEST(FloorPicture, ScalesAroundTheFirstPointOfTheLine) {
    FloorPicture picture;
    picture.place(0.01, {1, 1});
    picture.setLength(QLineF(3, 1, 5, 1), 4);
    EXPECT_DOUBLE_EQ(picture.metresPerPixel(), 0.02);
    EXPECT_EQ(picture.origin(), QPointF(-1, 1)); // twice as far from the line's beginning
}

TEST(FloorPicture, IsTenMetresWideAtFirst) {
    const test::TemporaryFolder folder;
    FloorPicture picture;
    picture.load(pictureIn(folder));
    EXPECT_EQ(picture.extent(), QRectF(0, 0, 10, 4));
    expectPlace(picture, {0, 20}, {0, 0}); // the lower left corner of the picture
    expectPlace(picture, {50, 0}, {10, 4});
}

TEST(FloorPicture, TwoOfItsPointsCanBeLaidOntoTwoCorners) {
    const test::TemporaryFolder folder;
    FloorPicture picture;
    picture.load(pictureIn(folder));
    const QTransform before = picture.roomFromPicture();
    const QPointF a = before.map(QPointF(10, 10));
    const QPointF b = before.map(QPointF(40, 5));
    picture.move(a, {3, 1});
    picture.pull({3, 1}, picture.roomFromPicture().map(QPointF(40, 5)), {2, 5});
    expectPlace(picture, {10, 10}, {3, 1});
    expectPlace(picture, {40, 5}, {2, 5});
    EXPECT_NEAR(picture.metresPerPixel(), 0.2 * std::hypot(1, 4) / QLineF(a, b).length(), 1e-9);
}

TEST(FloorPicture, IsFoundAgainForItsSurveyOnly) {
    const test::TemporaryFolder folder;
    FloorPicture picture;
    picture.load(pictureIn(folder));
    picture.place(0.05, {1, 2}, Radians(0.3));
    picture.keep("uuid");
    EXPECT_EQ(FloorPicture::kept("uuid").roomFromPicture(), picture.roomFromPicture());
    EXPECT_TRUE(FloorPicture::kept("another").isEmpty());
    FloorPicture().keep("uuid");
    EXPECT_TRUE(FloorPicture::kept("uuid").isEmpty());
}

TEST(FloorPicture, StaysAsItIsIfAFileIsNoPicture) {
    FloorPicture picture;
    test::expectError(ErrorKind::Corrupt, "no picture", [&] { picture.load("/no/such/file.png"); });
    EXPECT_TRUE(picture.isEmpty());
}

TEST(FloorPicture, CanBeThePageOfAPdf) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(QImage(30, 20, QImage::Format_RGB32).save(pathIn(folder, "page.png")));
    writeFile(folder / "plan.pdf", bytesOf("%PDF-1.4\n"));
    // In place of poppler's program, which draws the page.
    writeFile(folder / "pdftoppm", bytesOf("#!/bin/sh\ncat \"$(dirname \"$0\")/page.png\"\n"));
    std::filesystem::permissions(folder / "pdftoppm", std::filesystem::perms::owner_all);
    const QByteArray before = qgetenv("PATH");
    qputenv("PATH", QByteArray::fromStdString(folder.path().string()) + ":" + before);
    FloorPicture picture;
    picture.load(pathIn(folder, "plan.pdf"));
    EXPECT_EQ(picture.image().size(), QSize(30, 20));
    qputenv("PATH", QByteArray::fromStdString((folder / "empty").string()));
    test::expectError(ErrorKind::Unsupported, "pdftoppm", [&] { picture.load(pathIn(folder, "plan.pdf")); });
    qputenv("PATH", before);
}

TEST(RobotMap, LiesWhereItsFileSays) {
    const test::TemporaryFolder folder;
    FloorPicture picture;
    picture.load(robotMapIn(folder, "origin: [-2.0, 1.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\n"
                                    "free_thresh: 0.196\n"));
    EXPECT_EQ(picture.extent(), QRectF(-2, 1, 0.2, 0.15));
    EXPECT_EQ(picture.image().pixelColor(0, 1), QColor(Qt::black));
    EXPECT_EQ(picture.image().pixelColor(1, 1), QColor(Qt::white));
    EXPECT_EQ(picture.image().pixelColor(3, 0), QColor(170, 170, 170));
}

TEST(RobotMap, IsTurnedAroundItsOrigin) {
    const test::TemporaryFolder folder;
    FloorPicture picture;
    picture.load(robotMapIn(folder, "origin: [1, 2, 1.5707963267948966]\n"));
    expectPlace(picture, {0, 3}, {1, 2});
    expectPlace(picture, {4, 3}, {1, 2.2});
    expectPlace(picture, {0, 0}, {0.85, 2});
}

TEST(RobotMap, NegateAndModeTellWhatAPixelMeans) {
    RobotMapFile map;
    QImage pixels(3, 1, QImage::Format_Grayscale8);
    pixels.setPixelColor(0, 0, QColor(0, 0, 0));
    pixels.setPixelColor(1, 0, QColor(130, 130, 130));
    pixels.setPixelColor(2, 0, QColor(255, 255, 255));
    const auto greys = [&] {
        const QImage picture = mapPicture(map, pixels);
        return std::array{qGray(picture.pixel(0, 0)), qGray(picture.pixel(1, 0)), qGray(picture.pixel(2, 0))};
    };
    EXPECT_EQ(greys(), (std::array{0, 170, 255}));
    map.isNegated = true;
    EXPECT_EQ(greys(), (std::array{255, 170, 0}));
    map.isNegated = false;
    map.mode = RobotMapFile::Mode::Scale;
    EXPECT_EQ(greys(), (std::array{0, 130, 255}));
    map.mode = RobotMapFile::Mode::Raw; // 0 is free, and more than 100 is unknown
    EXPECT_EQ(greys(), (std::array{255, 170, 170}));
}

TEST(RobotMap, SaysWhichEntryIsMissing) {
    const test::TemporaryFolder folder;
    FloorPicture picture;
    test::expectError(ErrorKind::Corrupt, "origin", [&] { picture.load(robotMapIn(folder, "")); });
    test::expectError(ErrorKind::Corrupt, "origin",
                      [&] { picture.load(robotMapIn(folder, "origin: [1, 2]\n")); });
    test::expectError(ErrorKind::Corrupt, "mode",
                      [&] { picture.load(robotMapIn(folder, "origin: [1, 2, 0]\nmode: other\n")); });
}

} // namespace spherewalk::ui
