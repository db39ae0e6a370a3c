// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "portrait_photo.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/photo/face_search.h"

#include <gtest/gtest.h>

namespace spherewalk::photo {

using test::photoWithPortrait;

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
