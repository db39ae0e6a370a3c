// SPDX-License-Identifier: GPL-3.0-or-later
// Two photos are compared as the place of the first one sees them, and never turned differently.
#include "photographed_survey.h"
#include "qt_application.h"
#include "ui/panorama/panorama_presenter.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/practice/practice_room.h"
#include "spherewalk/render/scene_depth.h"

#include <QTest>
#include <gtest/gtest.h>

#include <cmath>

namespace spherewalk::ui {

namespace {

constexpr QSize kView(200, 100);
constexpr EquirectSize kSize{512, 256};

class PhotoMoverTest : public testing::Test {
  protected:
    ShownPhoto taken(const std::string& name, const Rigid3& pose, bool isAligned = true) {
        writeFile(folder / name, jpeg::encode(room.spherical(pose, kSize), 90));
        return {folder / name, QString::fromStdString(name),
                isAligned ? pose : Rigid3{Eigen::Quaterniond::Identity(), pose.translation}, isAligned};
    }

    /// Mean difference between what the viewer shows of the first photo and of the second one.
    double difference(const ShownPhoto& first, const ShownPhoto& second) {
        presenter.show(first);
        presenter.setOther(second);
        presenter.setComparison(Comparison::Slider);
        EXPECT_TRUE(QTest::qWaitFor([&] { return presenter.remark().isEmpty(); }, 100'000));
        QTest::qWait(0);
        presenter.setShare(1);
        const QImage own = presenter.picture(kView);
        presenter.setShare(0);
        const QImage other = presenter.picture(kView);
        double sum = 0;
        for (int y = 0; y < kView.height(); ++y) {
            for (int x = 0; x < kView.width(); ++x) {
                sum += std::abs(own.pixelColor(x, y).lightness() - other.pixelColor(x, y).lightness());
            }
        }
        return sum / (kView.width() * kView.height());
    }

    test::TemporaryFolder folder;
    practice::PracticeRoom room{practice::PracticeRoomOptions()};
    PanoramaPresenter presenter;
    Rigid3 here{yawRotation(Degrees(20)), {2.2, 1.9, 1.2}};
    Rigid3 there{yawRotation(Degrees(150)), {2.7, 2.1, 1.2}};
};

} // namespace

TEST_F(PhotoMoverTest, TheNearerToTruthTheSurroundingsTheLessDiffers) {
    ShownPhoto first = taken("a.jpg", here);
    const ShownPhoto second = taken("b.jpg", there);
    const double turned = difference(first, second);
    EXPECT_EQ(presenter.movedWords(), "turned as the first");
    const practice::RoomPlan plan = room.plan();
    presenter.setSurroundings({render::RoomShape{plan.outline, 0, plan.ceilingM}, std::nullopt});
    const double byRoom = difference(first, second);
    EXPECT_EQ(presenter.movedWords(), "as seen from here, by the drawn walls");
    EXPECT_LT(byRoom, 0.8 * turned);
    Image<float, 1> inverseM(kSize.width, kSize.height);
    const DepthImage range = room.sphericalRange(here, kSize);
    for (std::size_t i = 0; i < inverseM.values().size(); ++i) {
        inverseM.values()[i] = 1 / range.values()[i];
    }
    first.depthFile = folder / "a.pgm";
    writeFile(first.depthFile, render::DepthMap(std::move(inverseM)).serialised());
    const double byDepth = difference(first, second);
    EXPECT_EQ(presenter.movedWords(), "as seen from here, by measured depth");
    EXPECT_LT(byDepth, 0.8 * byRoom);
}

TEST_F(PhotoMoverTest, PhotosThatAreNotAlignedAreTurnedByWhatTheyShow) {
    const ShownPhoto first = taken("a.jpg", here, false);
    const ShownPhoto sameWay = taken("b.jpg", {here.rotation, there.translation}, false);
    const ShownPhoto otherwise = taken("c.jpg", there, false);
    const double best = difference(first, sameWay);
    EXPECT_NEAR(difference(first, otherwise), best, 0.3 * best);
    EXPECT_TRUE(presenter.isComparingUnaligned());
}

TEST_F(PhotoMoverTest, PhotosOfWhichNothingTellsTheTurnAreNotCompared) {
    const ShownPhoto first = taken("a.jpg", here, false);
    RgbImage grey(kSize.width, kSize.height);
    std::fill(grey.values().begin(), grey.values().end(), std::uint8_t{110});
    writeFile(folder / "grey.jpg", jpeg::encode(grey, 90));
    presenter.show(first);
    presenter.setOther(ShownPhoto{folder / "grey.jpg", "grey", there, false});
    presenter.setComparison(Comparison::Blink);
    ASSERT_TRUE(QTest::qWaitFor([&] { return presenter.remark().contains("cannot be compared"); }, 100'000));
    const QImage own = presenter.picture(kView);
    presenter.blink();
    EXPECT_EQ(presenter.picture(kView), own);
    EXPECT_TRUE(presenter.movedWords().isEmpty());
}

TEST_F(PhotoMoverTest, ADepthThatIsGoneIsReplacedByTheRoom) {
    ShownPhoto first = taken("a.jpg", here);
    first.depthFile = folder / "gone.pgm";
    const practice::RoomPlan plan = room.plan();
    presenter.setSurroundings({render::RoomShape{plan.outline, 0, plan.ceilingM}, std::nullopt});
    difference(first, taken("b.jpg", there));
    EXPECT_EQ(presenter.movedWords(), "as seen from here, by the drawn walls");
}

} // namespace spherewalk::ui
