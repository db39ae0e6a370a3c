// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "temporary_folder.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/json.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/practice/practice_room.h"
#include "spherewalk/render/renderer.h"
#include "spherewalk/render/scene_depth.h"

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

namespace spherewalk::test {

/// A dataset of a block of small photos of the practice room, 20 cm apart, with all scene models, whose
/// poses, room and depths are the true ones.
class PracticeDataset {
  public:
    static constexpr double kStepM = 0.2;
    static constexpr int kPhotoWidth = 512;

    /// corner: the place of the first photo.
    explicit PracticeDataset(int side, bool hasDepth = true, const practice::PracticeRoomOptions& room = {},
                             const Eigen::Vector2d& corner = {1.9, 1.7}, int width = kPhotoWidth)
        : m_room(room), m_width(width) {
        std::filesystem::create_directories(path() / "photos");
        std::filesystem::create_directories(path() / "depth");
        render::DatasetInfo description = info();
        for (int i = 0; i < side * side; ++i) {
            description.photos.push_back(
                photo(corner.x() + kStepM * (i % side), corner.y() + kStepM * (i / side), i, hasDepth));
        }
        write(path() / render::kDatasetFile, bytesOf(render::toJson(description).dump()));
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

    /// Not durably, which takes longer than all the rest.
    static void write(const std::filesystem::path& file, ByteView bytes) {
        std::ofstream(file, std::ios::binary) << textOf(bytes);
    }

    render::DatasetPhoto photo(double x, double y, int number, bool hasDepth) const {
        const EquirectSize size{m_width, m_width / 2};
        const Rigid3 pose{yawRotation(Radians(0.4 * number)), {x, y, 1.2}};
        const Bytes bytes = jpeg::encode(m_room.spherical(pose, size), 92);
        render::DatasetPhoto photo;
        photo.file = "photos/" + std::to_string(100 + number) + ".jpg";
        photo.sha256 = sha256Hex(bytes);
        photo.sizeBytes = bytes.size();
        photo.width = size.width;
        photo.height = size.height;
        photo.roomFromPhoto = pose;
        photo.rotationSource = "imported";
        write(path() / photo.file, bytes);
        if (hasDepth) {
            Image<float, 1> inverse(size.width, size.height);
            const DepthImage range = m_room.sphericalRange(pose, size);
            for (std::size_t i = 0; i < inverse.values().size(); ++i) {
                inverse.values()[i] = 1 / range.values()[i];
            }
            photo.depth = "depth/" + std::to_string(100 + number) + ".pgm";
            write(path() / photo.depth, render::DepthMap(std::move(inverse)).serialised());
        }
        return photo;
    }

    TemporaryFolder m_folder;
    practice::PracticeRoom m_room;
    int m_width;
};

} // namespace spherewalk::test
