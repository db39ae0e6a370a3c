// SPDX-License-Identifier: GPL-3.0-or-later
#include "portrait_photo.h"
#include "review_page.h"
#include "ui/panorama/panorama_presenter.h"
#include "ui/panorama/panorama_view.h"
#include "ui/review/review_model.h"

#include <QCheckBox>
#include <QComboBox>
#include <QListView>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

namespace spherewalk::ui {

namespace {

class PrivateRegionsTest : public ReviewPage {
  protected:
    PanoramaView& view() { return *mode.findChild<PanoramaView*>(); }

    std::vector<store::RegionRecord> regions() const { return session->store().regions(); }

    /// Marks a region by the keyboard alone.
    void markByKeys() {
        QTest::keyClick(&widget<QListView>("stations"), Qt::Key_H);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    }

    void storeFound(std::size_t station) {
        session->write(SurveySession::Photos, [&](store::SurveyStore& store) {
            store.setFoundRegions(photo(station), {{Degrees(90), Degrees(0), Degrees(20), Degrees(20)}}, 1);
        });
    }
};

} // namespace

TEST_F(PrivateRegionsTest, ABoxThatIsDraggedIsStoredAndSelected) {
    QTest::mouseClick(&widget<QToolButton>("hideRegion"), Qt::LeftButton);
    const QPoint middle = view().rect().center();
    QTest::mousePress(&view(), Qt::LeftButton, {}, middle - QPoint(30, 20));
    QTest::mouseMove(&view(), middle + QPoint(30, 20));
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, middle + QPoint(30, 20));
    ASSERT_EQ(regions().size(), 1U);
    EXPECT_EQ(regions()[0].photo, photo(0));
    EXPECT_EQ(regions()[0].origin, store::RegionOrigin::Marked);
    EXPECT_EQ(view().presenter().regions().selected()->id, regions()[0].id);
    EXPECT_FALSE(widget<QToolButton>("hideRegion").isChecked());
    EXPECT_TRUE(widget<QPushButton>("removeRegion").isEnabled());
}

TEST_F(PrivateRegionsTest, TheKeyboardAloneMarksRemovesUndoesAndRedoes) {
    markByKeys();
    ASSERT_EQ(regions().size(), 1U);
    const store::RegionRecord marked = regions()[0];
    EXPECT_EQ(QApplication::focusWidget(), &view());
    QTest::keyClick(&view(), Qt::Key_Delete);
    EXPECT_TRUE(regions().empty());
    EXPECT_EQ(session->store().review(photo(0)).decision, store::Decision::Open) << "no photo was rejected";
    session->undoStack()->undo();
    ASSERT_EQ(regions().size(), 1U);
    EXPECT_EQ(regions()[0], marked);
    session->undoStack()->undo();
    EXPECT_TRUE(regions().empty());
    session->undoStack()->redo();
    ASSERT_EQ(regions().size(), 1U);
    EXPECT_EQ(regions()[0], marked);
    session->undoStack()->redo();
    EXPECT_TRUE(regions().empty());
}

TEST_F(PrivateRegionsTest, WhatASearchFoundIsRemovedForGoodAndComesBackByUndo) {
    storeFound(0);
    QTest::keyClick(&view(), Qt::Key_Tab);
    QTest::mouseClick(&widget<QPushButton>("removeRegion"), Qt::LeftButton);
    ASSERT_EQ(regions().size(), 1U);
    EXPECT_EQ(regions()[0].origin, store::RegionOrigin::Rejected);
    EXPECT_TRUE(view().presenter().regions().regions().empty());
    session->selection()->setCurrent(session->store().stations().at(2).id);
    session->undoStack()->undo();
    EXPECT_EQ(regions()[0].origin, store::RegionOrigin::Found);
    EXPECT_EQ(session->selection()->current(), session->store().stations().at(0).id);
    EXPECT_TRUE(view().presenter().regions().regions().at(0).isFound);
}

TEST_F(PrivateRegionsTest, EscapeAndAnotherPhotoLeaveTheTool) {
    auto& tool = view().presenter().regions();
    QTest::keyClick(&widget<QListView>("stations"), Qt::Key_H);
    EXPECT_TRUE(tool.isMarking());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    EXPECT_FALSE(tool.isMarking());
    QTest::keyClick(&view(), Qt::Key_H);
    QTest::keyClick(&view(), Qt::Key_J);
    EXPECT_FALSE(tool.isMarking());
    EXPECT_TRUE(regions().empty());
}

TEST_F(PrivateRegionsTest, WithoutAPhotoThereIsNothingToHide) {
    session->selection()->setCurrent(session->store().stations().at(3).id);
    EXPECT_FALSE(widget<QToolButton>("hideRegion").isEnabled());
    EXPECT_FALSE(widget<QPushButton>("removeRegion").isEnabled());
}

TEST_F(PrivateRegionsTest, TheListCountsThemAndTheFilterLeadsThroughThem) {
    storeFound(1);
    const QModelIndex row = widget<QListView>("stations").model()->index(1, 0);
    EXPECT_EQ(row.data(ReviewModel::RegionsRole).toInt(), 1);
    EXPECT_TRUE(row.data(Qt::AccessibleTextRole).toString().contains("private region"));
    EXPECT_TRUE(row.data(Qt::ToolTipRole).toString().contains("private region"));
    mode.showPart("regions");
    EXPECT_EQ(widget<QListView>("stations").model()->rowCount(), 1);
    EXPECT_EQ(session->selection()->current(), session->store().stations().at(1).id);
    ASSERT_NE(view().presenter().regions().selected(), nullptr);
    EXPECT_FALSE(view().presenter().regionOutlines({400, 300}).empty()) << "the view looks there";
}

TEST_F(PrivateRegionsTest, AsExportedShowsThemBlurred) {
    markByKeys();
    widget<QCheckBox>("asExported").click();
    EXPECT_TRUE(view().presenter().isAsExported());
    ASSERT_TRUE(QTest::qWaitFor([&] { return view().presenter().remark().isEmpty(); }));
}

TEST_F(PrivateRegionsTest, ASearchFindsFacesAndLeadsToThem) {
    writeFile(session->store().photoFolder() / session->store().photos().at(1).fileName,
              jpeg::encode(test::photoWithPortrait({Degrees(20), Degrees(0)}, 1.2), 90));
    QSignalSpy messages(&mode, &Mode::message);
    auto& search = widget<QPushButton>("searchFaces");
    EXPECT_TRUE(search.text().contains('3'));
    search.click();
    EXPECT_FALSE(search.isVisible());
    EXPECT_TRUE(widget<QPushButton>("stopFaces").isVisible());
    EXPECT_FALSE(widget<QToolButton>("accept").isEnabled()) << "the search writes";
    ASSERT_TRUE(QTest::qWaitFor([&] { return search.isVisible(); }, 120'000));
    ASSERT_FALSE(messages.isEmpty());
    const Told told = messages.last()[0].value<Told>();
    EXPECT_TRUE(told.text.contains("1 face(s) found in 1 photo(s)")) << told.text.toStdString();
    EXPECT_EQ(told.cure, Cure::Regions);
    EXPECT_EQ(regions().size(), 1U);
    EXPECT_EQ(widget<QListView>("stations").model()->index(1, 0).data(ReviewModel::RegionsRole).toInt(), 1);
    EXPECT_TRUE(search.text().contains("again"));
    EXPECT_TRUE(widget<QToolButton>("accept").isEnabled());
}

TEST_F(PrivateRegionsTest, AStoppedSearchKeepsWhatIsDone) {
    widget<QPushButton>("searchFaces").click();
    widget<QPushButton>("stopFaces").click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return widget<QPushButton>("searchFaces").isVisible(); }, 100'000));
    EXPECT_TRUE(widget<QToolButton>("accept").isEnabled());
}

} // namespace spherewalk::ui
