// SPDX-License-Identifier: GPL-3.0-or-later
#include "photographed_survey.h"
#include "qt_application.h"
#include "ui/panorama/panorama_presenter.h"
#include "ui/panorama/panorama_view.h"

#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include <numbers>

namespace spherewalk::ui {

namespace {

class PanoramaViewTest : public testing::Test {
  protected:
    PanoramaViewTest() {
        view.resize(320, 240);
        view.show();
    }

    ShownPhoto photo(std::size_t index,
                     const Eigen::Quaterniond& turned = Eigen::Quaterniond::Identity()) const {
        const store::PhotoRecord record = survey.open().photos().at(index);
        return {survey.open().photoFolder() / record.fileName,
                QString::fromStdString(record.fileName),
                {turned, Eigen::Vector3d::Zero()}};
    }

    /// Waits until all that is wanted is decoded.
    void settle() {
        ASSERT_TRUE(QTest::qWaitFor([&] { return view.presenter().remark().isEmpty(); }));
    }

    QColor at(double share) {
        const QSize size(200, 100);
        return view.presenter().picture(size).pixelColor(static_cast<int>(share * size.width()), 50);
    }

    test::PhotographedSurvey survey{3};
    PanoramaView view;
    Eigen::Quaterniond halfTurn{Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitZ())};
};

} // namespace

TEST(Look, StopsAtThePoles) {
    Look look;
    look.turn(Radians(0), Degrees(200));
    EXPECT_DOUBLE_EQ(Degrees(look.up).value(), 90);
    look.turn(Radians(0), Degrees(-300));
    EXPECT_DOUBLE_EQ(Degrees(look.up).value(), -90);
}

TEST(Look, ZoomsWithinWhatALensCanShow) {
    Look look;
    look.zoom(100);
    EXPECT_DOUBLE_EQ(Degrees(look.fov).value(), Look::kWidest.value());
    look.zoom(0.001);
    EXPECT_DOUBLE_EQ(Degrees(look.fov).value(), Look::kNarrowest.value());
}

TEST(Look, LooksWhereItSays) {
    Look look;
    look.turn(Degrees(90), Degrees(30));
    const Eigen::Vector3d ahead = look.roomFromCamera({1, 2, 3}).rotation * Eigen::Vector3d::UnitZ();
    EXPECT_LT((ahead - Eigen::Vector3d(0, std::cos(std::numbers::pi / 6), 0.5)).norm(), 1e-12);
}

TEST_F(PanoramaViewTest, SaysThatNothingIsChosen) {
    EXPECT_FALSE(view.presenter().remark().isEmpty());
    EXPECT_EQ(at(0.5), QColor(Qt::black));
}

TEST_F(PanoramaViewTest, ShowsThePhotoTurnedAsItWasSolved) {
    view.presenter().show(photo(0));
    settle();
    const int ahead = at(0.5).red();
    view.presenter().show(photo(0, halfTurn));
    settle();
    EXPECT_GT(ahead, at(0.5).red() + 60);
}

TEST_F(PanoramaViewTest, SaysWhenItsPictureIsThere) {
    PanoramaPresenter presenter;
    presenter.show(photo(0));
    QSignalSpy changed(&presenter, &PanoramaPresenter::changed);
    ASSERT_TRUE(changed.wait());
    EXPECT_NE(presenter.picture({20, 10}).pixelColor(10, 5), QColor(Qt::black));
}

TEST_F(PanoramaViewTest, SaysWhyAPhotoCannotBeShown) {
    ShownPhoto missing = photo(0);
    missing.file = survey / "nothing.JPG";
    view.presenter().show(missing);
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.presenter().remark().contains("nothing.JPG"); }));
}

TEST_F(PanoramaViewTest, TurnsWithTheMouse) {
    const double before = view.presenter().look().yaw.value();
    QTest::mousePress(&view, Qt::LeftButton, {}, {100, 100});
    QTest::mouseMove(&view, {180, 120});
    QTest::mouseRelease(&view, Qt::LeftButton, {}, {180, 120});
    EXPECT_NEAR(view.presenter().look().yaw.value() - before, 80.0 / 320 * std::numbers::pi / 2, 1e-9);
    EXPECT_GT(view.presenter().look().up.value(), 0);
    QTest::mouseMove(&view, {10, 10}); // the button is up
    EXPECT_NEAR(view.presenter().look().yaw.value() - before, 80.0 / 320 * std::numbers::pi / 2, 1e-9);
}

TEST_F(PanoramaViewTest, TurnsAndZoomsWithTheKeyboard) {
    QTest::keyClick(&view, Qt::Key_Left);
    EXPECT_NEAR(Degrees(view.presenter().look().yaw).value(), 7.5, 1e-9);
    QTest::keyClick(&view, Qt::Key_Down);
    EXPECT_NEAR(Degrees(view.presenter().look().up).value(), -7.5, 1e-9);
    QTest::keyClick(&view, Qt::Key_Plus);
    EXPECT_LT(Degrees(view.presenter().look().fov).value(), 90);
    QTest::keyClick(&view, Qt::Key_0);
    EXPECT_EQ(view.presenter().look().up.value(), 0);
    EXPECT_NEAR(Degrees(view.presenter().look().fov).value(), 90, 1e-9);
}

TEST_F(PanoramaViewTest, ZoomsWithTheWheel) {
    QWheelEvent closer({50, 50}, view.mapToGlobal(QPointF(50, 50)), {}, {0, 120}, Qt::NoButton, {},
                       Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view, &closer);
    EXPECT_LT(Degrees(view.presenter().look().fov).value(), 80);
}

TEST_F(PanoramaViewTest, ComparesOnEitherSideOfALineThatIsDragged) {
    view.presenter().show(photo(0));
    view.presenter().setOther(photo(0, halfTurn));
    view.presenter().setComparison(Comparison::Slider);
    settle();
    EXPECT_GT(at(0.45).red(), at(0.55).red() + 60);
    QTest::mousePress(&view, Qt::LeftButton, {}, {160, 60});
    QTest::mouseMove(&view, {288, 60});
    QTest::mouseRelease(&view, Qt::LeftButton, {}, {288, 60});
    EXPECT_NEAR(view.presenter().share(), 0.9, 0.01);
    EXPECT_EQ(view.presenter().look().yaw.value(), 0);
    EXPECT_GT(at(0.85).red(), at(0.95).red() + 60);
}

TEST_F(PanoramaViewTest, BlinksByItself) {
    view.presenter().show(photo(0));
    view.presenter().setOther(photo(0, halfTurn));
    view.presenter().setComparison(Comparison::Blink);
    settle();
    const int first = at(0.5).red();
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.presenter().isOtherShown(); }));
    EXPECT_GT(first, at(0.5).red() + 60);
    view.presenter().setComparison(Comparison::Off);
    EXPECT_FALSE(view.presenter().isOtherShown());
}

TEST_F(PanoramaViewTest, IsDrawnAnewWhenTheLookChanges) {
    view.presenter().show(photo(0));
    settle();
    const QImage before = view.grab().toImage();
    view.presenter().turn(Degrees(40), Radians(0));
    EXPECT_NE(view.grab().toImage(), before);
}

} // namespace spherewalk::ui
