// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/sha256.h"
#include "spherewalk/jobs/walk.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/picture_file.h"

#include <algorithm>

namespace spherewalk::jobs {

using test::expectError;

namespace {

/// A dataset of two photos, one red and one blue, a metre apart.
void writeDataset(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder / "photos");
    render::DatasetInfo info;
    for (int i = 0; i < 2; ++i) {
        RgbImage picture(64, 32);
        for (int p = 0; p < 64 * 32; ++p) {
            picture.values()[static_cast<std::size_t>(3 * p + 2 * i)] = 200;
        }
        const Bytes jpeg = jpeg::encode(picture, 95);
        render::DatasetPhoto photo;
        photo.file = "photos/" + std::to_string(i) + ".jpg";
        photo.sha256 = sha256Hex(jpeg);
        photo.sizeBytes = jpeg.size();
        photo.width = 64;
        photo.height = 32;
        photo.roomFromPhoto.translation.x() = i;
        info.photos.push_back(photo);
        writeFile(folder / photo.file, jpeg);
    }
    writeFile(folder / render::kDatasetFile, bytesOf(render::toJson(info).dump()));
}

class WalkTest : public testing::Test {
  protected:
    WalkTest() {
        writeDataset(folder / "d");
        for (int i = 0; i < 5; ++i) {
            path.push_back({0.1 * i, {Eigen::Quaterniond::Identity(), {0.25 * i, 0, 0}}});
        }
    }

    WalkReport run(const std::stop_token& stop = {}) {
        const render::Renderer renderer(
            std::make_shared<const render::Dataset>(render::Dataset::open(folder / "d")));
        return walk(renderer, CameraModel(CameraIntrinsics::pinhole(32, 24, 1)), path, {},
                    folder / "out/walk", noProgress(), stop);
    }

    test::TemporaryFolder folder;
    std::vector<TimedPose> path;
};

} // namespace

TEST_F(WalkTest, WritesAFrameAPoseWithItsIndexAndASheet) {
    const WalkReport report = run();
    EXPECT_EQ(report.frames, 5U);
    EXPECT_EQ(report.photosUsed, 2U);
    EXPECT_DOUBLE_EQ(report.worstOffsetM, 0.5);
    const RgbImage first = photo::readPicture(folder / "out/walk/000000.png");
    const RgbImage last = photo::readPicture(folder / "out/walk/000004.png");
    EXPECT_GT(first.at(16, 12)[0], 150);
    EXPECT_GT(last.at(16, 12)[2], 150);
    EXPECT_EQ(first.width(), 32);
    EXPECT_FALSE(photo::readPicture(folder / "out/walk/contact-sheet.png").empty());
    const std::string csv = readTextFile(folder / "out/walk/index.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 6);
    EXPECT_NE(csv.find("\n000003.png,0.30000000000000004,0.75,0,0,0,0,0,1,photos/1.jpg,0.25,none,footprint,"),
              std::string::npos)
        << csv;
}

TEST_F(WalkTest, KeepsTheFramesSoFarWhenStopped) {
    std::stop_source stop;
    stop.request_stop();
    expectError(ErrorKind::Stopped, "Stopped", [&] { run(stop.get_token()); });
}

TEST_F(WalkTest, SaysWhichFolderItCannotMake) {
    writeFile(folder / "out", bytesOf("a file"));
    expectError(ErrorKind::Io, "out/walk", [&] { run(); });
}

} // namespace spherewalk::jobs
