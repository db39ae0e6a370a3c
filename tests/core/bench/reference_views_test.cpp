// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench_photo.h"
#include "made_dataset.h"
#include "measurements.h"
#include "opencv_views.h"
#include "random.h"
#include "sphere/exact_view.h"
#include "temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace spherewalk::bench {

using Eigen::Vector3d;

namespace {

/// Colours that change slowly and fit together at the seam, so that a wrong pixel shows but a rounding does
/// not.
RgbImage smoothPanorama(int width) {
    RgbImage picture(width, width / 2);
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < width; ++x) {
            const double turn = 2 * EIGEN_PI * x / width;
            picture.at(x, y)[0] = static_cast<std::uint8_t>(128 + 100 * std::sin(turn));
            picture.at(x, y)[1] = static_cast<std::uint8_t>(128 + 100 * std::cos(turn));
            picture.at(x, y)[2] = static_cast<std::uint8_t>(250 * y / picture.height());
        }
    }
    return picture;
}

Rigid3 anyPose(test::Random& random) {
    return lookingTo(random.uniform(-180, 180), random.uniform(-25, 25), 0.3 * random.direction());
}

/// The greatest difference of any value, in grey levels.
int worstDifference(const RgbImage& a, const RgbImage& b) {
    int worst = a.values().size() == b.values().size() ? 0 : 256;
    for (std::size_t i = 0; worst < 256 && i < a.values().size(); ++i) {
        worst = std::max(worst, std::abs(a.values()[i] - b.values()[i]));
    }
    return worst;
}

class Peers : public testing::Test {
  protected:
    RgbImage m_photo = smoothPanorama(1024);
    CameraModel m_camera = standardCamera(90);
    test::Random m_random{31};
};

/// What an even photo and its views are measured with.
std::vector<RungFidelity> fidelityOf(const test::MadeDataset& made, double fieldDeg, int directions) {
    const test::TemporaryFolder folder;
    const BenchPhoto photo(test::openMadeDataset(folder.path(), made));
    return measureFidelity(photo, fieldDeg, {directions, 32}, noProgress(), {});
}

} // namespace

TEST_F(Peers, FollowTheDefinitionOfAView) {
    for (const std::optional<double> radiusM : {std::optional<double>(), std::optional<double>(2.0)}) {
        OpenCvViews views(m_photo, m_camera, radiusM);
        for (int i = 0; i < 3; ++i) {
            const Rigid3 pose = anyPose(m_random);
            const render::Projection projection(m_camera, pose, {}, {m_photo.width(), m_photo.height()},
                                                radiusM ? render::SceneKind::Sphere : render::SceneKind::None,
                                                radiusM.value_or(1));
            const RgbImage& view =
                views.mapsAndRemap(radiusM ? pose : Rigid3{pose.rotation, Vector3d::Zero()});
            for (int k = 0; k < 500; ++k) {
                const int x = m_random.integer(0, 639);
                const int y = m_random.integer(0, 479);
                const Vector3d expected = render::bilinear(m_photo, *projection.photoPixel({x, y}));
                for (int c = 0; c < 3; ++c) {
                    EXPECT_NEAR(view.at(x, y)[c], expected[c], 2) << x << " " << y;
                }
            }
        }
    }
}

TEST_F(Peers, MakeTheSameViewWithKeptMaps) {
    OpenCvViews views(m_photo, m_camera, 2.0);
    // The seam is behind the camera: there, kept maps lose a pixel.
    const Rigid3 pose = lookingTo(20, 10, {0.1, 0.2, 0});
    views.keepMaps(pose);
    const RgbImage kept = views.remap(0);
    EXPECT_LE(worstDifference(kept, views.mapsAndRemap(pose)), 2);
}

TEST_F(Peers, TakeKeptMapsInTurns) {
    OpenCvViews views(m_photo, m_camera, std::nullopt);
    for (const double left : {-40.0, 0.0, 40.0}) {
        views.keepMaps(lookingTo(left, 0));
    }
    const RgbImage first = views.remap(0);
    const RgbImage second = views.remap(1);
    EXPECT_EQ(views.remap(3), first);
    EXPECT_EQ(views.remap(301), second);
    EXPECT_GT(worstDifference(first, second), 20);
}

TEST_F(Peers, TurnTheViewWithTheCamera) {
    OpenCvViews views(m_photo, m_camera, std::nullopt);
    // A photo whose columns are turned by a quarter, seen by a camera that is turned as much.
    RgbImage turned(m_photo.width(), m_photo.height());
    for (int y = 0; y < turned.height(); ++y) {
        for (int x = 0; x < turned.width(); ++x) {
            std::copy_n(m_photo.at((x + 256) % 1024, y), 3, turned.at(x, y));
        }
    }
    OpenCvViews others(turned, m_camera, std::nullopt);
    EXPECT_LE(worstDifference(views.mapsAndRemap(lookingTo(-90, 5)), others.mapsAndRemap(lookingTo(0, 5))),
              1);
}

TEST_F(Peers, SayTheirVersion) {
    EXPECT_THAT(OpenCvViews::version(), testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+.*"));
}

TEST(Fidelity, OfAnEvenPhotoIsPerfect) {
    test::MadeDataset made;
    made.places = {{0, 0, 1}};
    made.isEven = true;
    for (const RungFidelity& row : fidelityOf(made, 90, 3)) {
        EXPECT_NEAR(row.meanDb, 100, 1e-9) << name(row.rung);
        EXPECT_EQ(row.worstDb, 100) << name(row.rung);
    }
}

TEST(Fidelity, HasEachRungOnceAndInItsOrder) {
    test::MadeDataset made;
    made.places = {{0, 0, 1}};
    const std::vector<RungFidelity> rows = fidelityOf(made, 33, 2);
    ASSERT_EQ(rows.size(), kRungs.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i].rung, kRungs[i]);
        EXPECT_EQ(rows[i].fieldDeg, 33);
    }
}

TEST(Fidelity, OfOneDirectionHasTheSameMeanAndWorst) {
    test::MadeDataset made;
    made.places = {{0, 0, 1}};
    for (const RungFidelity& row : fidelityOf(made, 60, 1)) {
        EXPECT_DOUBLE_EQ(row.meanDb, row.worstDb) << name(row.rung);
    }
}

TEST(Psnr, LosesSixDecibelsWhereErrorsAreTwiceAsGreat) {
    RgbImage picture(6, 4);
    std::fill(picture.values().begin(), picture.values().end(), std::uint8_t{100});
    test::Random random(32);
    std::vector<Vector3d> expected(24);
    std::vector<Vector3d> twice(24);
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const Vector3d error = random.vector(5);
        expected[i] = Vector3d::Constant(100) + error;
        twice[i] = Vector3d::Constant(100) + 2 * error;
    }
    EXPECT_NEAR(psnrDb(expected, picture, 1) - psnrDb(twice, picture, 1), 20 * std::log10(2.0), 1e-9);
}

TEST(Psnr, FallsWithEachPixelThatIsWrong) {
    RgbImage picture(8, 8);
    const std::vector<Vector3d> expected(64, Vector3d::Zero());
    double before = psnrDb(expected, picture, 1);
    EXPECT_EQ(before, 100);
    for (int i = 0; i < 64; ++i) {
        picture.at(i % 8, i / 8)[i % 3] = 50;
        const double now = psnrDb(expected, picture, 1);
        EXPECT_LT(now, before) << i;
        before = now;
    }
}

TEST(StandardCamera, HasTheFieldOfViewThatIsAskedFor) {
    for (const double fieldDeg : {1.0, 57.0, 90.0, 170.0}) {
        const CameraModel camera = standardCamera(fieldDeg);
        const Vector3d left = camera.ray({-0.5, 239.5})->normalized();
        const Vector3d right = camera.ray({639.5, 239.5})->normalized();
        EXPECT_NEAR(std::acos(left.dot(right)) * 180 / EIGEN_PI, fieldDeg, 1e-9);
    }
}

TEST(BenchPhoto, IsFreeHalfTheWayToTheNextPlace) {
    const auto freeM = [](const std::vector<Vector3d>& places) {
        const test::TemporaryFolder folder;
        test::MadeDataset made;
        made.places = places;
        return BenchPhoto(test::openMadeDataset(folder.path(), made)).freeM();
    };
    EXPECT_DOUBLE_EQ(freeM({{0, 0, 1}, {3, 0, 1}, {0, 0.5, 1}}), 0.25);
    EXPECT_DOUBLE_EQ(freeM({{0, 0, 1}, {0, 0, 1}, {2, 0, 1}}), 1); // a second photo of the place is none
    EXPECT_EQ(freeM({{0, 0, 1}}), std::numeric_limits<double>::infinity());
}

} // namespace spherewalk::bench
