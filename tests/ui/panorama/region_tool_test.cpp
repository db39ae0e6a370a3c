// SPDX-License-Identifier: GPL-3.0-or-later
#include "photographed_survey.h"
#include "qt_application.h"
#include "random.h"
#include "ui/panorama/panorama_presenter.h"
#include "ui/panorama/panorama_view.h"

#include <QSignalSpy>
#include <QTest>

#include <cmath>
#include <numbers>

namespace spherewalk::ui {

namespace {

const QSize kViewPx(320, 240);

PhotoProjection viewTowards(const Look& look) {
    return {CameraModel(look.camera(kViewPx.width(), kViewPx.height())),
            look.roomFromCamera(Eigen::Vector3d::Zero()).rotation.conjugate()};
}

Look towards(double yawDeg, double upDeg, double fovDeg = 90) {
    return {Degrees(yawDeg), Degrees(upDeg), Degrees(fovDeg)};
}

class RegionToolTest : public testing::Test {
  protected:
    RegionToolTest() {
        view.resize(kViewPx);
        view.show();
        test::activate(view);
        view.setFocus();
    }

    void show(const std::vector<ShownRegion>& regions) {
        const store::PhotoRecord record = survey.open().photos().at(0);
        ShownPhoto photo{survey.open().photoFolder() / record.fileName, "R1", Rigid3{}};
        photo.regions = regions;
        view.presenter().show(photo);
        ASSERT_TRUE(QTest::qWaitFor([&] { return view.presenter().remark().isEmpty(); }));
    }

    void drag(const QPoint& from, const QPoint& to) {
        QTest::mousePress(&view, Qt::LeftButton, {}, from);
        QTest::mouseMove(&view, to);
        QTest::mouseRelease(&view, Qt::LeftButton, {}, to);
    }

    survey::PrivateRegion marked() {
        EXPECT_EQ(wanted.size(), 1);
        return wanted.isEmpty() ? survey::PrivateRegion() : wanted[0][0].value<survey::PrivateRegion>();
    }

    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}, int times = 1) {
        for (; times > 0; --times) {
            QTest::keyClick(&view, key, modifiers);
        }
    }

    std::optional<std::int64_t> selected() {
        const ShownRegion* region = tool.selected();
        return region != nullptr ? std::optional(region->id) : std::nullopt;
    }

    test::PhotographedSurvey survey{1};
    PanoramaView view;
    RegionTool& tool = view.presenter().regions();
    QSignalSpy wanted{&view, &PanoramaView::regionMarked};
    const std::vector<ShownRegion> two{{7, {Degrees(0), Degrees(0), Degrees(20), Degrees(10)}, true},
                                       {9, {Degrees(180), Degrees(0), Degrees(20), Degrees(10)}, false}};
};

} // namespace

TEST(RegionOfABox, HoldsAllOfItWhereverTheViewLooks) {
    test::Random random(1);
    for (int i = 0; i < 500; ++i) {
        // Seam and poles among them.
        const Look look = towards(random.uniform(-180, 180), i % 5 == 0 ? 90 : random.uniform(-90, 90),
                                  random.uniform(20, 120));
        const PhotoProjection view = viewTowards(look);
        const QPointF from(random.uniform(0, 320), random.uniform(0, 240));
        const QPointF to(random.uniform(0, 320), random.uniform(0, 240));
        const QRectF box = QRectF(from, to).normalized();
        const survey::PrivateRegion region = regionAround(box, view);
        EXPECT_NO_THROW(region.validate());
        const survey::RegionFrame frame(region);
        for (const QPointF& corner : {box.topLeft(), box.topRight(), box.bottomLeft(), box.bottomRight()}) {
            const auto at = frame.at(view.direction(corner));
            ASSERT_TRUE(at) << i;
            EXPECT_LE(at->cwiseAbs().maxCoeff(), 1 + 1e-9) << i;
        }
    }
}

TEST(RegionOfABox, IsNoLargerThanItInALevelView) {
    const PhotoProjection view = viewTowards(towards(170, 0));
    const survey::PrivateRegion region = regionAround({200, 90, 100, 60}, view);
    const double focalPx = 160; // of 90 degrees
    const double left = Degrees(Radians(std::atan((200 - view.camera.intrinsics().cx) / focalPx))).value();
    const double right = Degrees(Radians(std::atan((300 - view.camera.intrinsics().cx) / focalPx))).value();
    EXPECT_NEAR(Degrees(region.azimuth).value(), 170 - 0.5 * (left + right), 0.1);
    EXPECT_NEAR(Degrees(region.width).value(), right - left, 0.1);
    const PhotoProjection across = viewTowards(towards(180, 0));
    EXPECT_NEAR(std::abs(Degrees(regionAround({150, 110, 20, 20}, across).azimuth).value()), 180, 1)
        << "across the seam";
}

TEST(RegionOutline, EndsWhereTheViewEnds) {
    const survey::PrivateRegion region{Degrees(0), Degrees(0), Degrees(20), Degrees(10)};
    const QRectF ahead = outlineOf(region, viewTowards(towards(0, 0))).boundingRect();
    EXPECT_NEAR(ahead.center().x(), 159.5, 1);
    EXPECT_NEAR(ahead.width(), 2 * 160 * std::tan(std::numbers::pi / 18), 1);
    EXPECT_TRUE(outlineOf(region, viewTowards(towards(180, 0))).isEmpty());
    const survey::PrivateRegion wide{Degrees(0), Degrees(0), Degrees(150), Degrees(10)};
    const QPolygonF half = outlineOf(wide, viewTowards(towards(60, 0))); // partly behind the camera
    ASSERT_FALSE(half.isEmpty());
    for (const QPointF& corner : half) {
        EXPECT_TRUE(std::isfinite(corner.x()) && std::isfinite(corner.y()));
    }
}

TEST_F(RegionToolTest, ADraggedBoxIsMarked) {
    show({});
    tool.setMarking(true);
    drag({200, 60}, {100, 160}); // from any corner
    const survey::RegionFrame frame(marked());
    EXPECT_TRUE(frame.contains(Eigen::Vector3d(1, 0.02, 0)));
    EXPECT_FALSE(tool.isMarking());
    EXPECT_EQ(view.presenter().look().yaw.value(), 0) << "the view has not turned";
}

TEST_F(RegionToolTest, ADragWithoutSizeMarksNothing) {
    show({});
    tool.setMarking(true);
    drag({100, 100}, {100, 100});
    drag({100, 100}, {200, 101});
    drag({100, 100}, {101, 200});
    EXPECT_TRUE(wanted.isEmpty());
    EXPECT_TRUE(tool.isMarking());
    drag({100, 100}, {5000, 5000}); // out of the view
    EXPECT_NO_THROW(marked().validate());
}

TEST_F(RegionToolTest, TheKeyboardAloneMovesSizesAndMarksTheBox) {
    show({});
    tool.setMarking(true);
    const QRectF first = tool.box();
    press(Qt::Key_Right);
    press(Qt::Key_Down);
    EXPECT_GT(tool.box().center().x(), first.center().x());
    EXPECT_GT(tool.box().center().y(), first.center().y());
    press(Qt::Key_Right, Qt::ShiftModifier);
    press(Qt::Key_Down, Qt::ShiftModifier);
    EXPECT_GT(tool.box().width(), first.width());
    EXPECT_LT(tool.box().height(), first.height());
    EXPECT_EQ(view.presenter().look().yaw.value(), 0);
    press(Qt::Key_Return);
    const survey::PrivateRegion region = marked();
    EXPECT_LT(Degrees(region.azimuth).value(), 0) << "right of the middle";
    EXPECT_LT(Degrees(region.elevation).value(), 0);
    EXPECT_GT(region.width.value(), region.height.value());
    tool.setMarking(true);
    press(Qt::Key_Escape);
    EXPECT_FALSE(tool.isMarking());
    EXPECT_EQ(wanted.size(), 1);
}

TEST_F(RegionToolTest, TheViewTurnsWhereTheBoxComesToItsRim) {
    show({});
    tool.setMarking(true);
    press(Qt::Key_Left, {}, 60);
    EXPECT_NEAR(tool.box().left(), 0, 1e-9);
    EXPECT_GT(Degrees(view.presenter().look().yaw).value(), 30);
    press(Qt::Key_Up, {}, 120);
    EXPECT_NEAR(Degrees(view.presenter().look().up).value(), 90, 1e-9);
    press(Qt::Key_Up, Qt::ShiftModifier, 100);   // no larger than the view
    press(Qt::Key_Left, Qt::ShiftModifier, 100); // and never nothing
    EXPECT_GT(tool.box().width(), 0);
    press(Qt::Key_Return);
    EXPECT_NO_THROW(marked().validate());
}

TEST_F(RegionToolTest, TabGoesThroughTheRegionsAndThenLeaves) {
    show(two);
    press(Qt::Key_Tab);
    EXPECT_EQ(selected(), 7);
    EXPECT_TRUE(view.accessibleDescription().contains("1 of 2, found by the search"));
    press(Qt::Key_Tab);
    EXPECT_EQ(selected(), 9);
    EXPECT_NEAR(std::abs(Degrees(view.presenter().look().yaw).value()), 180, 1e-9) << "it is behind";
    EXPECT_TRUE(view.accessibleDescription().contains("2 of 2, marked by hand"));
    EXPECT_FALSE(view.presenter().selectNextRegion(1));
    press(Qt::Key_Backtab);
    EXPECT_EQ(selected(), 7);
    press(Qt::Key_Escape);
    EXPECT_EQ(selected(), std::nullopt);
}

TEST_F(RegionToolTest, AClickSelectsTheSmallestRegionThere) {
    show({two[0], {8, {Degrees(0), Degrees(0), Degrees(60), Degrees(60)}, false}});
    QTest::mouseClick(&view, Qt::LeftButton, {}, {160, 120});
    EXPECT_EQ(selected(), 7);
    QTest::mouseClick(&view, Qt::LeftButton, {}, {160, 80});
    EXPECT_EQ(selected(), 8);
    drag({160, 120}, {200, 120});
    EXPECT_EQ(selected(), 8) << "turning selects nothing else";
    QTest::mouseClick(&view, Qt::LeftButton, {}, {5, 5});
    EXPECT_EQ(selected(), std::nullopt);
}

TEST_F(RegionToolTest, DeleteWantsTheSelectedRegionRemoved) {
    show(two);
    QSignalSpy removed(&view, &PanoramaView::removalWanted);
    press(Qt::Key_Delete);
    EXPECT_TRUE(removed.isEmpty());
    press(Qt::Key_Tab);
    press(Qt::Key_Delete);
    EXPECT_EQ(removed.size(), 1);
}

TEST_F(RegionToolTest, FoundAndMarkedRegionsAreDrawnWithOtherLines) {
    show({two[0]});
    const auto lightShare = [&] { // of the upper side, where the line is not interrupted
        const QImage picture = view.grab().toImage();
        const QRectF outline = view.presenter().regionOutlines(kViewPx).at(0).corners.boundingRect();
        int dark = 0;
        const int y = qRound(outline.top());
        for (int x = qRound(outline.left()) + 4; x < outline.right() - 4; ++x) {
            dark += picture.pixelColor(x, y).lightness() < 90 ? 1 : 0;
        }
        return dark;
    };
    const int foundGaps = lightShare();
    show({{7, two[0].region, false}});
    EXPECT_EQ(lightShare(), 0);
    EXPECT_GT(foundGaps, 8);
}

TEST_F(RegionToolTest, AsExportedTheRegionIsBlurredAndNotOutlined) {
    show({{7, {Degrees(0), Degrees(0), Degrees(40), Degrees(40)}, false}});
    const auto contrast = [&] { // of neighbouring pixels within the region
        const QImage picture = view.presenter().picture(kViewPx);
        int sum = 0;
        for (int x = 130; x < 190; ++x) {
            sum += std::abs(picture.pixelColor(x, 120).green() - picture.pixelColor(x + 1, 120).green());
        }
        return sum;
    };
    const int before = contrast();
    view.presenter().setAsExported(true);
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.presenter().remark().isEmpty(); }));
    EXPECT_LT(contrast(), before / 2);
    EXPECT_TRUE(view.presenter().regionOutlines(kViewPx).empty());
    tool.select(7);
    EXPECT_EQ(view.presenter().regionOutlines(kViewPx).size(), 1U) << "for who removes it";
}

} // namespace spherewalk::ui
