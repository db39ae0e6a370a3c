// SPDX-License-Identifier: GPL-3.0-or-later
#include "qt_application.h"
#include "ui/align/align_mode.h"
#include "ui/align/align_model.h"

#include <QImage>
#include <QPainter>
#include <QSignalSpy>
#include <gtest/gtest.h>

namespace spherewalk::ui {

namespace {

jobs::PhotoFinding finding(std::int64_t photo, std::optional<survey::Quality> quality) {
    jobs::PhotoFinding result;
    result.photo = photo;
    result.station = 100 + photo;
    result.stationName = "rail 1, stop 1";
    result.quality = quality;
    return result;
}

QImage painted(HeadingLayer& layer) {
    QImage canvas(200, 200, QImage::Format_RGB32);
    canvas.fill(Qt::white);
    QPainter painter(&canvas);
    layer.paint(painter, QTransform::fromScale(50, 50));
    return canvas;
}

} // namespace

TEST(AlignModel, FindsAPhotoByItsId) {
    AlignModel model;
    model.setPhotos({finding(3, survey::Quality::Good), finding(5, survey::Quality::Failed)});
    ASSERT_NE(model.photo(5), nullptr);
    EXPECT_EQ(model.photo(5)->station, 105);
    EXPECT_EQ(model.photo(4), nullptr);
}

TEST(AlignModel, EachColumnHasATitleAndAnExplanation) {
    const AlignModel model;
    for (int column = 0; column < AlignModel::Columns; ++column) {
        EXPECT_FALSE(model.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString().isEmpty())
            << column;
        EXPECT_FALSE(model.headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString().isEmpty())
            << column;
    }
}

TEST(AlignModel, FlagsWhatIsNotGoodOrHasAProposal) {
    jobs::PhotoFinding proposed = finding(3, survey::Quality::Good);
    proposed.cure = jobs::Cure::Mask;
    AlignModel model;
    model.setPhotos({finding(1, survey::Quality::Good), finding(2, survey::Quality::Doubtful), proposed});
    const auto isFlagged = [&](int row) {
        return model.index(row, 0).data(AlignModel::FlaggedRole).toBool();
    };
    EXPECT_FALSE(isFlagged(0));
    EXPECT_TRUE(isFlagged(1));
    EXPECT_TRUE(isFlagged(2));
}

TEST(AlignProxy, UnknownNumbersSortBehindKnownOnes) {
    jobs::PhotoFinding known = finding(1, survey::Quality::Good);
    known.sigmaYaw = Degrees(0.5);
    AlignModel model;
    model.setPhotos({finding(2, survey::Quality::Good), known});
    AlignProxy table(model);
    table.sort(AlignModel::SigmaYaw);
    EXPECT_EQ(table.index(0, 0).data(AlignModel::PhotoRole).toLongLong(), 1);
}

TEST(AlignProxy, ListsOnlyFlaggedRowsIfWanted) {
    AlignModel model;
    model.setPhotos({finding(1, survey::Quality::Good), finding(2, survey::Quality::Failed)});
    AlignProxy table(model);
    table.setOnlyFlagged(true);
    ASSERT_EQ(table.rowCount(), 1);
    EXPECT_EQ(table.index(0, 0).data(AlignModel::StationRole).toLongLong(), 102);
}

TEST(HeadingLayer, DrawsOnlyPhotosThatAreSolved) {
    HeadingLayer layer;
    const QImage empty = painted(layer);
    layer.setPhotos({finding(1, survey::Quality::Failed)});
    EXPECT_EQ(painted(layer), empty);
    jobs::PhotoFinding solved = finding(2, survey::Quality::Good);
    solved.roomFromPhoto = Rigid3{Eigen::Quaterniond::Identity(), {2, 2, 1}};
    solved.sigmaYaw = Degrees(0.1);
    layer.setPhotos({solved});
    EXPECT_NE(painted(layer), empty);
}

} // namespace spherewalk::ui
