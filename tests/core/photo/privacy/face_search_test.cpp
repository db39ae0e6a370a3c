// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/photo/face_search.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/practice/practice_room.h"

#include <gtest/gtest.h>

#include <cmath>

namespace spherewalk::photo {
namespace {

/// A portrait hangs life-size in a photo of the practice room, in this direction.
RgbImage photoWithPortrait(const SphericalDirection& towards, double distanceM) {
    constexpr EquirectSize kPhoto{kFaceSearchWidth, kFaceSearchWidth / 2};
    constexpr double kMetresPerPixel = 0.22 / 116;
    const Eigen::Vector2d face(164, 130); // of the portrait, pixels
    static const RgbImage room = practice::PracticeRoom().spherical(
        {Eigen::Quaterniond::Identity(), {2.5, 2, 1.4}}, {kFaceSearchWidth, kFaceSearchWidth / 2});
    RgbImage photo = room;
    const RgbImage portrait = readPicture(SPHEREWALK_TEST_DATA "/faces/astronaut.jpg");
    const survey::RegionFrame frame({towards.azimuth, towards.elevation, Degrees(90), Degrees(90)});
    for (int y = 0; y < kPhoto.height; ++y) {
        for (int x = 0; x < kPhoto.width; ++x) {
            const auto at = frame.at(direction(kPhoto, Eigen::Vector2d(x, y)));
            if (!at) {
                continue;
            }
            const Eigen::Vector2d pixel =
                Eigen::Vector2d(at->x(), -at->y()) * distanceM / kMetresPerPixel + face;
            const auto column = static_cast<int>(std::lround(pixel.x()));
            const auto row = static_cast<int>(std::lround(pixel.y()));
            if (column >= 0 && row >= 0 && column < portrait.width() && row < portrait.height()) {
                std::copy_n(portrait.at(column, row), 3, photo.at(x, y));
            }
        }
    }
    return photo;
}

} // namespace

TEST(FaceSearch, FindsAFaceOnceWhereverItIs) {
    const FaceSearch search;
    for (const SphericalDirection towards :
         {SphericalDirection{Degrees(20), Degrees(0)}, SphericalDirection{Degrees(180), Degrees(15)},
          SphericalDirection{Degrees(-100), Degrees(-20)}}) {
        const auto faces = search.faces(photoWithPortrait(towards, 1.2), 2, {});
        ASSERT_EQ(faces.size(), 1U) << Degrees(towards.azimuth).value();
        const survey::RegionFrame frame(faces[0]);
        EXPECT_TRUE(frame.contains(direction(towards)));
        EXPECT_NEAR(Degrees(faces[0].height).value(), Degrees(Radians(0.3 / 1.2)).value(), 7);
    }
}

TEST(FaceSearch, DoesNotDependOnThreads) {
    const FaceSearch search;
    const RgbImage photo = photoWithPortrait({Degrees(70), Degrees(5)}, 1.5);
    EXPECT_EQ(search.faces(photo, 1, {}), search.faces(photo, 4, {}));
}

TEST(FaceSearch, NamesThePackageThatIsMissing) {
    const test::TemporaryFolder folder;
    test::expectError(ErrorKind::NotFound, "Install the package opencv-data",
                      [&] { FaceSearch{folder.path()}; });
    writeFile(folder / "haarcascade_frontalface_alt2.xml", bytesOf("<no cascade"));
    test::expectError(ErrorKind::Corrupt, "is no cascade", [&] { FaceSearch{folder.path()}; });
}

TEST(FaceSearch, StopsAndRefusesWhatIsNoSphere) {
    const FaceSearch search;
    std::stop_source stop;
    stop.request_stop();
    test::expectError(ErrorKind::Stopped, "", [&] { search.faces(RgbImage(512, 256), 1, stop.get_token()); });
    test::expectError(ErrorKind::InvalidInput, "not twice as wide",
                      [&] { search.faces(RgbImage(100, 100), 1, {}); });
}

} // namespace spherewalk::photo
