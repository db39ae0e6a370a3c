// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/sha256.h"
#include "spherewalk/dataset/writer.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/practice/practice_room.h"
#include "spherewalk/render/depth_map.h"
#include "spherewalk/render/renderer.h"

#include <cmath>
#include <memory>
#include <string>

namespace spherewalk::test {

/// A dataset of a block of small photos of the practice room, 20 cm apart, with all scene models, whose
/// poses, room and depths are the true ones.
class PracticeDataset {
  public:
    static constexpr double kStepM = 0.2;
    static constexpr int kPhotoWidth = 512;

    explicit PracticeDataset(int side, bool hasDepth = true) {
        dataset::Contents contents{info(), {}};
        for (int i = 0; i < side * side; ++i) {
            contents.photos.push_back(
                photo(1.9 + kStepM * (i % side), 1.7 + kStepM * (i / side), i, hasDepth));
        }
        dataset::writeDataset(contents, path(), {8, 64, 0}, noProgress(), {});
    }

    std::filesystem::path path() const { return m_folder / "room.dataset"; }

    const TemporaryFolder& folder() const { return m_folder; }

    const practice::PracticeRoom& room() const { return m_room; }

    render::Renderer renderer() const {
        return render::Renderer(std::make_shared<const render::Dataset>(render::Dataset::open(path())));
    }

    static CameraModel camera() { return CameraModel(CameraIntrinsics::pinhole(240, 180, 1.0)); }

  private:
    render::DatasetInfo info() const {
        const practice::RoomPlan plan = m_room.plan();
        render::DatasetInfo info;
        info.id = info.surveyId = "00000000-0000-4000-8000-000000000000";
        info.name = "practice";
        info.createdUtc = "2026-01-01T00:00:00.000Z";
        info.madeBy = "test";
        info.outline = plan.outline;
        info.obstacles = plan.obstacles;
        info.ceilingM = plan.ceilingM;
        info.stepM = kStepM;
        info.sphereRadiusM = 1.8;
        info.roomShape = render::RoomShape{plan.outline, 0, plan.ceilingM};
        return info;
    }

    dataset::SourcePhoto photo(double x, double y, int number, bool hasDepth) const {
        const EquirectSize size{kPhotoWidth, kPhotoWidth / 2};
        const Rigid3 pose{yawRotation(Radians(0.4 * number)), {x, y, 1.2}};
        const std::string stem = "P" + std::to_string(100 + number);
        dataset::SourcePhoto source;
        source.file = m_folder / (stem + ".jpg");
        const Bytes bytes = jpeg::encode(m_room.spherical(pose, size), 92);
        writeFile(source.file, bytes);
        source.sha256 = sha256Hex(bytes);
        source.entry.roomFromPhoto = pose;
        source.entry.rotationSource = "imported";
        if (hasDepth) {
            Image<float, 1> inverse(size.width, size.height);
            const DepthImage range = m_room.sphericalRange(pose, size);
            for (std::size_t i = 0; i < inverse.values().size(); ++i) {
                inverse.values()[i] = 1 / range.values()[i];
            }
            source.depthFile = m_folder / (stem + ".pgm");
            writeFile(source.depthFile, render::DepthMap(std::move(inverse)).serialised());
        }
        return source;
    }

    TemporaryFolder m_folder;
    practice::PracticeRoom m_room;
};

} // namespace spherewalk::test
