// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/digest.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/dataset/writer.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"

#include <filesystem>

namespace spherewalk::test {

/// The part of flat-a in tests/data: a photo of a real-looking room, its depth, and two pictures of a robot's
/// camera, with exact poses. See tests/data/flat-a/README.md.
struct FlatRoom {
    static std::filesystem::path data() { return std::filesystem::path(SPHEREWALK_TEST_DATA) / "flat-a"; }

    static CameraModel camera() {
        return CameraModel(CameraIntrinsics::pinhole(320, 240, Radians(Degrees(57)).value()));
    }

    /// Of view_03.png, 11 cm from the photo.
    static Rigid3 view3() {
        return {Eigen::Quaterniond(-0.650191389, 0.650774241, -0.278638623, 0.275870555).normalized(),
                {0.411969577, 0.345292726, 1.1}};
    }

    /// A dataset of the one photo and its depth.
    static void write(const std::filesystem::path& folder) {
        dataset::Contents contents;
        contents.info.id = "00000000-0000-4000-8000-000000000000";
        contents.info.name = "flat";
        contents.info.createdUtc = "2026-01-01T00:00:00.000Z";
        contents.info.sphereRadiusM = 2;
        dataset::SourcePhoto photo;
        photo.file = data() / "R0010013.JPG";
        photo.sha256 = sha256Hex(readFile(photo.file));
        photo.depthFile = data() / "R0010013_depth.pgm";
        photo.entry.roomFromPhoto = {
            Eigen::Quaterniond(0.999675759, -0.005054734, 0.005535741, -0.024334772).normalized(),
            {0.401014, 0.400029, 1.2}};
        contents.photos.push_back(photo);
        dataset::writeDataset(contents, folder, {}, noProgress(), {});
    }
};

} // namespace spherewalk::test
