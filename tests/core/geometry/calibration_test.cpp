// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"

#include "spherewalk/geometry/camera_model.h"

#include <limits>

namespace spherewalk {

using testing::ElementsAre;

TEST(Calibration, IsWhatRosAndGazeboCallIt) {
    const Calibration pinhole = calibration({640, 480, 500, 501, 319.5, 239.5, LensModel::Pinhole, {}});
    EXPECT_EQ(pinhole.distortionModel, "plumb_bob");
    EXPECT_THAT(pinhole.d, ElementsAre(0, 0, 0, 0, 0));
    EXPECT_THAT(pinhole.k, ElementsAre(500, 0, 319.5, 0, 501, 239.5, 0, 0, 1));
    EXPECT_THAT(pinhole.p, ElementsAre(500, 0, 319.5, 0, 0, 501, 239.5, 0, 0, 0, 1, 0));
    const Calibration fisheye =
        calibration({640, 480, 300, 300, 320, 240, LensModel::Equidistant, {0.1, 0.2, 0.3, 0.4}});
    EXPECT_EQ(fisheye.distortionModel, "equidistant");
    EXPECT_THAT(fisheye.d, ElementsAre(0.1, 0.2, 0.3, 0.4));
}

TEST(Calibration, IsTakenBackAsTheSameCamera) {
    for (const CameraIntrinsics& camera :
         {CameraIntrinsics{640, 480, 500, 501, 319.5, 239.5, LensModel::Pinhole, {}},
          CameraIntrinsics{640, 480, 500, 501, 319.5, 239.5, LensModel::PlumbBob, {-0.1, 0, 0, 0, 0}},
          CameraIntrinsics{
              64, 48, 30, 30, 32, 24, LensModel::RationalPolynomial, {0.1, 0, 0, 0, 0, 0.1, 0, 0}},
          CameraIntrinsics{64,
                           48,
                           30,
                           30,
                           32,
                           24,
                           LensModel::RationalPolynomial,
                           {0.1, 0, 0, 0, 0, 0.1, 0, 0, 0.01, 0, 0, 0, 0, 0.02}},
          CameraIntrinsics{640, 480, 300, 300, 320, 240, LensModel::Equidistant, {0, 0, 0, 0}},
          CameraIntrinsics{640, 480, 300, 300, 320, 240, LensModel::Equidistant, {0.1, 0.2, 0.3, 0.4}}}) {
        EXPECT_EQ(intrinsicsOf(calibration(camera)), camera);
    }
}

TEST(Calibration, OfAnIdealFisheyeIsNoPinhole) {
    for (const char* model : {"equidistant", "fisheye"}) {
        for (const std::size_t count : {0, 4}) {
            Calibration message = calibration({640, 480, 300, 300, 320, 240, LensModel::Pinhole, {}});
            message.distortionModel = model;
            message.d.assign(count, 0);
            const CameraModel camera(intrinsicsOf(message));
            const Eigen::Vector3d ray = *camera.ray({320 + 300, 240}); // one focal length is one radian
            EXPECT_NEAR(std::atan2(ray.x(), ray.z()), 1, 1e-12) << model << " with " << count;
        }
    }
}

TEST(Calibration, LeavesOutParametersThatAreZero) {
    Calibration message = calibration(CameraIntrinsics::pinhole(640, 480, 1));
    const auto countOf = [&](const char* model, std::vector<double> d) {
        message.distortionModel = model;
        message.d = std::move(d);
        return intrinsicsOf(message).distortion.size();
    };
    EXPECT_EQ(countOf("", {}), 0U);
    EXPECT_EQ(countOf("none", {0, 0}), 0U);
    EXPECT_EQ(countOf("plumb_bob", {0, 0, 0, 0, 0}), 0U);
    EXPECT_EQ(countOf("plumb_bob", {0.1, 0, 0, 0}), 5U);
    EXPECT_EQ(countOf("rational_polynomial", std::vector<double>(14)), 0U);
    EXPECT_EQ(countOf("rational_polynomial", {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}), 8U);
    EXPECT_EQ(countOf("rational_polynomial", {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0}), 12U);
    EXPECT_EQ(countOf("rational_polynomial", {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1}), 14U);
}

TEST(Calibration, FromOutsideIsNotBelieved) {
    const auto expectRefused = [](ErrorKind kind, const std::string& part, auto change) {
        Calibration one = calibration(CameraIntrinsics::pinhole(640, 480, 1));
        change(one);
        test::expectError(kind, part, [&] { intrinsicsOf(one); });
    };
    expectRefused(ErrorKind::Unsupported, "skewed", [](Calibration& c) { c.k[1] = 3; });
    expectRefused(ErrorKind::Unsupported, "0 0 1", [](Calibration& c) { c.k = {}; });
    expectRefused(ErrorKind::Unsupported, "0 0 1", [](Calibration& c) { c.k[8] = 2; });
    expectRefused(ErrorKind::Unsupported, "distortion model",
                  [](Calibration& c) { c.d = {1}, c.distortionModel = "fish"; });
    expectRefused(ErrorKind::Unsupported, "distortion model", // zeros are no pinhole of another model
                  [](Calibration& c) { c.distortionModel = "kannala_brandt"; });
    for (const char* none : {"", "none"}) {
        expectRefused(ErrorKind::InvalidInput, "names no distortion model", [&](Calibration& c) {
            c.d = {0.1, 0, 0, 0, 0}, c.distortionModel = none;
        });
    }
    expectRefused(ErrorKind::InvalidInput, "8, 12 or 14",
                  [](Calibration& c) { c.d.assign(13, 0.1), c.distortionModel = "rational_polynomial"; });
    expectRefused(ErrorKind::InvalidInput, "", [](Calibration& c) { c.d = {1, 2}; });
    expectRefused(ErrorKind::InvalidInput, "", [](Calibration& c) { c.width = -1; });
    expectRefused(ErrorKind::InvalidInput, "", [](Calibration& c) { c.height = 1 << 30; });
    expectRefused(ErrorKind::InvalidInput, "",
                  [](Calibration& c) { c.k[0] = std::numeric_limits<double>::quiet_NaN(); });
}

} // namespace spherewalk
