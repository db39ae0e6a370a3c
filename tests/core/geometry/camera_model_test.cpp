// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "random.h"

#include "spherewalk/geometry/camera_model.h"

#include <numbers>

namespace spherewalk {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

CameraIntrinsics withLens(LensModel lens, std::vector<double> distortion) {
    CameraIntrinsics intrinsics = CameraIntrinsics::pinhole(640, 480, 1.4);
    intrinsics.lens = lens;
    intrinsics.distortion = std::move(distortion);
    return intrinsics;
}

std::vector<CameraIntrinsics> lenses() {
    return {withLens(LensModel::Pinhole, {}),
            withLens(LensModel::PlumbBob, {-0.28, 0.07, 1e-3, -5e-4, 0}),
            withLens(LensModel::PlumbBob, {0.1, -0.2, -0.002, 0.001, 0.05}),
            withLens(LensModel::RationalPolynomial, {0.5, 0.1, 1e-4, -1e-4, 0.01, 0.8, 0.2, 0.03}),
            withLens(LensModel::RationalPolynomial,
                     {0.5, 0.1, 1e-3, -2e-3, 0.01, 0.8, 0.2, 0.03, 0.004, -0.002, 0.003, 0.001}),
            withLens(LensModel::RationalPolynomial,
                     {0.5, 0.1, 1e-3, -2e-3, 0.01, 0.8, 0.2, 0.03, 0.004, -0.002, 0.003, 0.001, 0.05, -0.12}),
            withLens(LensModel::Equidistant, {-0.01, 0.005, -0.001, 0.0001}),
            withLens(LensModel::Equidistant, {0, 0, 0, 0})};
}

} // namespace

TEST(CameraModel, FollowsRosPixelConventions) {
    const CameraModel camera(CameraIntrinsics::pinhole(640, 480, std::numbers::pi / 2));
    EXPECT_NEAR(camera.intrinsics().fx, 320, 1e-10);
    EXPECT_LT((*camera.ray({319.5, 239.5}) - Vector3d::UnitZ()).norm(), 1e-15);
    EXPECT_GT(camera.ray({600, 239.5})->x(), 0);
    EXPECT_GT(camera.ray({319.5, 400})->y(), 0);
    EXPECT_LT((*camera.project({1, 0, 1}) - Vector2d(639.5, 239.5)).norm(), 1e-10);
}

TEST(CameraModel, RaysProjectBackToTheirPixelForEveryLens) {
    for (const CameraIntrinsics& intrinsics : lenses()) {
        const CameraModel camera(intrinsics);
        int missing = 0;
        for (int v = 0; v < 480; v += 7) {
            for (int u = 0; u < 640; u += 7) {
                const Vector2d at(u, v);
                const auto ray = camera.ray(at);
                if (!ray) {
                    ++missing;
                    continue;
                }
                ASSERT_NEAR(ray->norm(), 1, 1e-12);
                ASSERT_LT((*camera.project(*ray * 3.7) - at).norm(), 1e-7)
                    << name(intrinsics.lens) << " " << at.transpose();
            }
        }
        EXPECT_EQ(missing, 0) << name(intrinsics.lens);
    }
}

TEST(CameraModel, ShowsOneDirectionInAPixelOfEveryLens) {
    std::vector<CameraIntrinsics> all = lenses();
    all.push_back(withLens(LensModel::PlumbBob, {0.05, 0, 0.03, -0.02, 0})); // it folds far off the axis
    test::Random random(83);
    for (const CameraIntrinsics& intrinsics : all) {
        const CameraModel camera(intrinsics);
        for (int i = 0; i < 2000; ++i) {
            const Vector3d direction = random.direction();
            const auto pixel = camera.project(direction);
            if (pixel && pixel->x() > 0 && pixel->x() < 639 && pixel->y() > 0 && pixel->y() < 479) {
                ASSERT_TRUE(camera.ray(*pixel)) << name(intrinsics.lens) << " " << direction.transpose();
                ASSERT_LT((*camera.ray(*pixel) - direction).norm(), 1e-6)
                    << name(intrinsics.lens) << " " << direction.transpose();
            }
        }
    }
}

// Values computed from the published formulas by hand: x' = 0.5, y' = -0.25, r2 = 0.3125.
TEST(CameraModel, DistortsAsRosAndOpenCvDocument) {
    const Vector3d p(0.5, -0.25, 1);
    const auto at = [&](LensModel lens, std::vector<double> d) {
        CameraIntrinsics intrinsics = withLens(lens, std::move(d));
        intrinsics.width = intrinsics.height = 1;
        intrinsics.fx = intrinsics.fy = 1;
        intrinsics.cx = intrinsics.cy = 0;
        return *CameraModel(intrinsics).project(p);
    };
    const double r2 = 0.3125;
    const double radial = 1 + 0.1 * r2 + 0.01 * r2 * r2 + 0.001 * r2 * r2 * r2;
    const Vector2d brown(0.5 * radial + 2 * 0.02 * 0.5 * -0.25 + 0.03 * (r2 + 2 * 0.25),
                         -0.25 * radial + 0.02 * (r2 + 2 * 0.0625) + 2 * 0.03 * 0.5 * -0.25);
    EXPECT_LT((at(LensModel::PlumbBob, {0.1, 0.01, 0.02, 0.03, 0.001}) - brown).norm(), 1e-15);
    const Vector2d rational = Vector2d(0.5, -0.25) * (1 + 0.1 * r2) / (1 + 0.2 * r2);
    EXPECT_LT((at(LensModel::RationalPolynomial, {0.1, 0, 0, 0, 0, 0.2, 0, 0}) - rational).norm(), 1e-15);
    const double angle = std::atan(std::sqrt(r2));
    const Vector2d fisheye = Vector2d(0.5, -0.25) / std::sqrt(r2) * (angle * (1 + 0.1 * angle * angle));
    EXPECT_LT((at(LensModel::Equidistant, {0.1, 0, 0, 0}) - fisheye).norm(), 1e-15);
}

// Made by projectPoints() and fisheye::projectPoints() of OpenCV 4.6.
TEST(CameraModel, ProjectsAsOpenCvDoes) {
    const std::array<Vector3d, 4> points{
        Vector3d(0.3, -0.2, 1), {-0.7, 0.5, 1}, {0.9, 0.6, 1.5}, {-0.1, -0.8, 1.2}};

    struct Case {
        LensModel lens;
        std::vector<double> distortion;
        std::array<Vector2d, 4> pixels;
    };

    const std::vector<Case> cases = {
        {LensModel::RationalPolynomial,
         {0.5, 0.1, 1e-3, -2e-3, 0.01, 0.8, 0.2, 0.03},
         {Vector2d(463.612718347842, 141.481251523467),
          {25.610499761939, 453.457750173445},
          {580.681567821718, 417.722266118768},
          {282.099585608041, -61.773839771720}}},
        {LensModel::RationalPolynomial,
         {0.5, 0.1, 1e-3, -2e-3, 0.01, 0.8, 0.2, 0.03, 0.004, -0.002, 0.003, 0.001},
         {Vector2d(463.855818347842, 141.688770523467),
          {26.542899761939, 454.869226173445},
          {581.451167821718, 418.655770118768},
          {282.798611456806, -60.979301287924}}},
        {LensModel::RationalPolynomial,
         {0.5, 0.1, 1e-3, -2e-3, 0.01, 0.8, 0.2, 0.03, 0.004, -0.002, 0.003, 0.001, 0.05, -0.12},
         {Vector2d(468.669303220381, 139.940069582426),
          {38.366587394682, 443.229593509148},
          {606.550858725380, 436.408222422125},
          {283.897937047622, -50.462489614327}}},
        {LensModel::PlumbBob,
         {-0.28, 0.07, 1e-3, -5e-4, 0.01},
         {Vector2d(464.083245500000, 141.227593060000),
          {26.405516000000, 453.282881200000},
          {581.850224000000, 418.251752320000},
          {282.406175289843, -62.034567968214}}},
        {LensModel::Equidistant,
         {0, 0, 0, 0},
         {Vector2d(463.464225350546, 141.604326761629),
          {30.459975481170, 450.086303578005},
          {579.413320197330, 416.241057734185},
          {282.811406075963, -59.878926420141}}},
        {LensModel::Equidistant,
         {-.0062, .0445, -.0420, .0081},
         {Vector2d(463.439063424543, 141.621436871311),
          {29.496943269528, 450.787941332201},
          {579.946146977000, 416.603379944360},
          {282.752639588388, -60.358460958758}}},
    };
    for (const Case& one : cases) {
        CameraIntrinsics intrinsics = withLens(one.lens, one.distortion);
        intrinsics.fx = 500;
        intrinsics.fy = 510;
        intrinsics.cx = 319.5;
        intrinsics.cy = 239.5;
        const CameraModel camera(intrinsics);
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_LT((*camera.project(points[i]) - one.pixels[i]).norm(), 1e-9)
                << name(one.lens) << " with " << one.distortion.size() << ", point " << i;
        }
    }
}

TEST(CameraModel, TakesALensThatSeesOnlyThePixelsBesideItsAxis) {
    CameraIntrinsics narrow{3, 70, 0.495, 0.495, 1, 34.5, LensModel::Equidistant, {0.01, -0.01, 0, 0}};
    EXPECT_TRUE(CameraModel(narrow).ray({1, 34}).has_value());
    EXPECT_FALSE(CameraModel(narrow).ray({1, 30}).has_value());
}

TEST(CameraModel, RefusesALensThatSeesNothing) {
    for (const auto& [lens, distortion] :
         {std::pair(LensModel::PlumbBob, std::vector<double>{1e300, 0, 0, 0, 0}),
          {LensModel::Equidistant, {-1e9, 0, 0, 0}}}) {
        test::expectError(ErrorKind::InvalidInput, "sees nothing",
                          [&] { CameraModel camera(withLens(lens, distortion)); });
    }
}

TEST(CameraModel, SeesBehindItselfOnlyThroughAFisheye) {
    const CameraModel pinhole(withLens(LensModel::Pinhole, {}));
    const CameraModel fisheye(withLens(LensModel::Equidistant, {0, 0, 0, 0}));
    EXPECT_FALSE(pinhole.project({0.1, 0, -1}));
    EXPECT_FALSE(pinhole.project({1, 0, 0}));
    EXPECT_FALSE(pinhole.project({std::nan(""), 0, 1}));
    EXPECT_TRUE(fisheye.project({1, 0, -0.5}));
    EXPECT_FALSE(fisheye.project({0, 0, -1}));
    EXPECT_FALSE(fisheye.project({0, 0, 0}));
}

TEST(CameraModel, GivesNoRayWhereTheDistortionFoldsOver) {
    CameraIntrinsics barrel =
        withLens(LensModel::PlumbBob, {-0.5, 0, 0, 0, 0}); // grows until r = sqrt(1 / 1.5)
    barrel.fx = barrel.fy = 200;
    const CameraModel camera(barrel);
    EXPECT_TRUE(camera.ray({319.5, 239.5}));
    EXPECT_FALSE(camera.ray({0, 0}));
    EXPECT_FALSE(camera.project({2, 0, 1}));
}

TEST(CameraModel, WorksFromOneDegreeToOneHundredSeventyNineAndForOnePixel) {
    for (const double degrees : {1.0, 57.0, 179.0}) {
        for (const int width : {1, 2, 640, 32768}) {
            const CameraModel camera(CameraIntrinsics::pinhole(width, 1, degrees * std::numbers::pi / 180));
            const Vector2d edge(-0.5, 0);
            const double angle = std::atan2(-camera.ray(edge)->x(), camera.ray(edge)->z());
            EXPECT_NEAR(angle, degrees * std::numbers::pi / 360, 1e-12);
            EXPECT_LT((*camera.project(*camera.ray(edge)) - edge).norm(), 1e-6);
        }
    }
}

TEST(CameraModel, RefusesImpossibleIntrinsicsInASentence) {
    const auto refused = [](auto change, const std::string& part) {
        CameraIntrinsics intrinsics = CameraIntrinsics::pinhole(640, 480, 1);
        change(intrinsics);
        test::expectError(ErrorKind::InvalidInput, part, [&] { CameraModel camera(intrinsics); });
    };
    refused([](auto& k) { k.width = 0; }, "0 x 480");
    refused([](auto& k) { k.height = 40000; }, "640 x 40000");
    refused([](auto& k) { k.fx = 0; }, "focal lengths");
    refused([](auto& k) { k.fy = std::nan(""); }, "focal lengths");
    refused([](auto& k) { k.cx = HUGE_VAL; }, "principal point");
    refused([](auto& k) { k.distortion = {1}; }, "0 distortion parameters, not 1");
    refused([](auto& k) { k.lens = LensModel::RationalPolynomial, k.distortion.resize(9); },
            "8, 12 or 14 distortion parameters, not 9");
    refused(
        [](auto& k) {
            k.lens = LensModel::RationalPolynomial, k.distortion.resize(14), k.distortion[13] = -1.6;
        },
        "tilted by a quarter turn");
    refused(
        [](auto& k) {
            k.lens = LensModel::Equidistant, k.distortion = {0, 0, 0, std::nan("")};
        },
        "not a number");
}

} // namespace spherewalk
