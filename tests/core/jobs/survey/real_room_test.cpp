// SPDX-License-Identifier: GPL-3.0-or-later
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/jobs/import_photos.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/render/renderer.h"
#include "spherewalk/store/survey_store.h"

#include <gtest/gtest.h>

namespace spherewalk::jobs {

// A photo and a robot's picture that another program made, with its own conventions:
// tests/data/flat-a/README.md. Through import, export and view, the robot's picture comes out again.
TEST(RealRoom, AnImportedPhotoGivesTheRobotsPicture) {
    const test::TemporaryFolder folder;
    const std::filesystem::path data = std::filesystem::path(SPHEREWALK_TEST_DATA) / "flat-a";
    survey::Room room;
    room.outline = {{-1.7, -1.6}, {2.5, -1.6}, {2.5, 3.4}, {-1.7, 3.4}};
    room.ceilingM = 2.6;
    const survey::PlanOptions options;
    auto store = store::SurveyStore::create(folder / "s.spherewalk", "s", room, options, {});
    writeFile(
        folder / "p.csv",
        bytesOf("file,x_m,y_m,z_m,qw,qx,qy,qz\n"
                "R0010013.JPG,0.401014,0.400029,1.2,0.999675759,-0.005054734,0.005535741,-0.024334772\n"));
    importPhotos(store, {data, folder / "p.csv"}, noProgress(), {});
    exportDataset(store, folder / "d", {}, noProgress(), {});

    const render::Renderer renderer(
        std::make_shared<const render::Dataset>(render::Dataset::open(folder / "d")));
    const RgbImage truth = photo::readPicture(data / "view_00.png");
    const CameraModel camera(CameraIntrinsics::pinhole(320, 240, Radians(Degrees(57)).value()));
    const auto likeness = [&](const Eigen::Quaterniond& roomFromBody) {
        const Rigid3 pose{roomFromBody * bodyFromOptical(), {0.401014, 0.400029, 1.2}};
        return photo::psnr(renderer.render(camera, pose).picture, truth);
    };
    const double right = likeness(yawRotation(Degrees(-23.488746)));
    RecordProperty("psnr_db", std::to_string(right));
    EXPECT_GT(right, 35);
    EXPECT_LT(likeness(yawRotation(Degrees(23.488746))), 20);
    EXPECT_LT(likeness(yawRotation(Degrees(-23.488746 + 180))), 20);
    EXPECT_LT(likeness(yawRotation(Degrees(-22.5))), right - 10);
}

} // namespace spherewalk::jobs
