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
          CameraIntrinsics{640, 480, 300, 300, 320, 240, LensModel::Equidistant, {0.1, 0.2, 0.3, 0.4}}}) {
        EXPECT_EQ(intrinsicsOf(calibration(camera)), camera);
    }
}

TEST(Calibration, FromOutsideIsNotBelieved) {
    const auto expectRefused = [](ErrorKind kind, const std::string& part, auto change) {
        Calibration one = calibration(CameraIntrinsics::pinhole(640, 480, 1));
        change(one);
        test::expectError(kind, part, [&] { intrinsicsOf(one); });
    };
    expectRefused(ErrorKind::Unsupported, "skewed", [](Calibration& c) { c.k[1] = 3; });
    expectRefused(ErrorKind::Unsupported, "skewed", [](Calibration& c) { c.k = {}; });
    expectRefused(ErrorKind::Unsupported, "distortion model",
                  [](Calibration& c) { c.d = {1}, c.distortionModel = "fish"; });
    expectRefused(ErrorKind::InvalidInput, "", [](Calibration& c) { c.d = {1, 2}; });
    expectRefused(ErrorKind::InvalidInput, "", [](Calibration& c) { c.width = -1; });
    expectRefused(ErrorKind::InvalidInput, "", [](Calibration& c) { c.height = 1 << 30; });
    expectRefused(ErrorKind::InvalidInput, "",
                  [](Calibration& c) { c.k[0] = std::numeric_limits<double>::quiet_NaN(); });
}

} // namespace spherewalk
