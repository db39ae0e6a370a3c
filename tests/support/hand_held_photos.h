// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/practice/practice_options.h"
#include "spherewalk/practice/practice_room.h"

#include <filesystem>
#include <vector>

namespace spherewalk::test {

/// Writes six photos of the practice room, H0.jpg to H5.jpg, that were taken by hand. Nothing in them says
/// where. Returns their true poses.
inline std::vector<Rigid3> writeHandHeldPhotos(const std::filesystem::path& folder) {
    constexpr int kWidth = 1024;
    const practice::PracticeRoom room;
    practice::PhotoErrors errors;
    errors.seed = 5;
    std::vector<Rigid3> truth;
    std::filesystem::create_directories(folder);
    for (int i = 0; i < 6; ++i) {
        const Eigen::Vector3d nominal(1.8 + 0.35 * (i % 3), 1.5 + 0.35 * (i / 3), 1.2);
        truth.push_back(errors.truePose(nominal, i + 1));
        writeFile(folder / text("H", i, ".jpg"),
                  jpeg::encode(room.spherical(truth.back(), {kWidth, kWidth / 2}), 95));
    }
    return truth;
}

} // namespace spherewalk::test
