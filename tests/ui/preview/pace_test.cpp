// SPDX-License-Identifier: GPL-3.0-or-later
// How large views are while the robot drives.
#include "preview_fixture.h"
#include "ui/preview/drive_view.h"

#include <cmath>
#include <limits>
#include <set>

namespace spherewalk::ui {

namespace {

/// Drives so many views on a machine on which a whole view takes this long, and each a constant part besides.
double shareAfter(DrivePace& pace, double wholeS, int views, double constantS = 0.002) {
    for (int i = 0; i < views; ++i) {
        pace.took(pace.share(), constantS + wholeS * pace.share() * pace.share());
    }
    return pace.share();
}

} // namespace

TEST(DrivePace, IsWholeWhereThatHoldsTheRate) {
    DrivePace pace;
    EXPECT_EQ(pace.share(), 1);
    EXPECT_EQ(shareAfter(pace, 0.025, 300), 1);
}

TEST(DrivePace, IsTheLargestThatHoldsTheRate) {
    for (const auto& [wholeS, share] : {std::pair(0.045, 0.75), std::pair(0.1, 0.5), std::pair(0.18, 0.375),
                                        std::pair(0.4, 0.25), std::pair(5.0, 0.25)}) {
        DrivePace pace;
        EXPECT_EQ(shareAfter(pace, wholeS, 200), share) << wholeS;
    }
}

TEST(DrivePace, OneLateViewIsNoPace) {
    DrivePace pace;
    shareAfter(pace, 0.02, 50);
    pace.took(1, 0.06);
    EXPECT_EQ(pace.share(), 1);
}

TEST(DrivePace, GrowsAgainOnceTheMachineIsFree) {
    DrivePace pace;
    EXPECT_EQ(shareAfter(pace, 0.1, 100), 0.5);
    EXPECT_EQ(shareAfter(pace, 0.015, 2000), 1);
}

TEST(DrivePace, DoesNotSwingBetweenTwoSizes) {
    DrivePace pace;
    shareAfter(pace, 0.034, 100); // just too slow
    int changes = 0;
    for (int i = 0; i < 600; ++i) {
        const double before = pace.share();
        changes += shareAfter(pace, 0.034, 1) != before ? 1 : 0;
    }
    EXPECT_LE(changes, 4); // twenty seconds
}

TEST(DrivePace, TimesThatAreNoneCountForNothing) {
    DrivePace pace;
    for (const double wrong : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        for (int i = 0; i < 10; ++i) {
            pace.took(1, wrong);
        }
    }
    pace.took(0.5, 100); // of a size that is not the present one
    EXPECT_EQ(pace.share(), 1);
}

TEST(SmallerCamera, SeesTheSame) {
    const CameraIntrinsics whole = CameraIntrinsics::pinhole(1280, 720, 1.2);
    for (const double share : DrivePace::kShares) {
        const CameraIntrinsics small = scaled(whole, share);
        small.validate();
        EXPECT_EQ(small.width, std::lround(1280 * share));
        const CameraModel a(whole);
        const CameraModel b(small);
        const Eigen::Vector3d corner =
            *a.ray(Eigen::Vector2d(-0.5, -0.5)); // of the picture, not of a pixel's middle
        EXPECT_NEAR((corner - *b.ray(Eigen::Vector2d(-0.5, -0.5))).norm(), 0, 1e-9);
    }
    EXPECT_EQ(scaled(CameraIntrinsics::pinhole(2, 2, 1), 0.25).width, 1);
}

TEST_F(PreviewTest, IsWholeWhenTheRobotStands) {
    CameraIntrinsics camera =
        CameraIntrinsics::pinhole(2560, 1440, 1.2); // too many for 30 views a second here
    camera.fx = camera.fy = 2000;
    presenter().setCamera(camera);
    preview();
    presenter().setSides({{render::SceneKind::Sphere, render::Sampling::Bicubic}});
    auto& view = widget<DriveView>("view");
    view.setFocus();
    std::set<int> widths;
    const QObject scope; // the page shows views after the test, too
    QObject::connect(&presenter(), &PreviewPresenter::viewsChanged, &scope,
                     [&] { widths.insert(presenter().views().front().picture.width()); });
    QTest::keyPress(&view, Qt::Key_D);
    ASSERT_TRUE(QTest::qWaitFor([&] { return widths.size() > 1; }, 100'000));
    EXPECT_LT(*widths.begin(), 2560);
    QTest::keyRelease(&view, Qt::Key_D);
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return presenter().views().front().picture.width() == 2560; }, 100'000));
    const MadeView& whole = presenter().views().front();
    EXPECT_EQ(whole.share, 1);
    EXPECT_FALSE(DriveView::reportText(whole.report, whole.share).contains("of the size"));
    EXPECT_TRUE(DriveView::reportText(whole.report, 0.5).contains("50 % of the size"));
}

} // namespace spherewalk::ui
