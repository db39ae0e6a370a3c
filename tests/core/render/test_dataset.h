// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/digest.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/jpeg/restart.h"
#include "spherewalk/render/dataset_format.h"
#include "spherewalk/render/scene_depth.h"

#include <cmath>
#include <filesystem>
#include <functional>
#include <vector>

namespace spherewalk::test {

/// A colour for each direction of the room: what an endlessly far world looks like.
using World = std::function<Eigen::Vector3d(const Eigen::Vector3d& directionInRoom)>;

/// Smooth, and different in every direction: no turned, tilted or mirrored picture of it looks like another.
inline Eigen::Vector3d smoothWorld(const Eigen::Vector3d& d) {
    return {128 + 100 * d.x(), 128 + 60 * d.y() + 40 * std::sin(3 * d.z()),
            128 + 80 * d.z() + 20 * std::cos(4 * d.x() + d.y())};
}

inline RgbImage panorama(const World& world, const Eigen::Quaterniond& roomFromPhoto, int width) {
    RgbImage picture(width, width / 2);
    const EquirectSize size{width, width / 2};
    for (int v = 0; v < size.height; ++v) {
        for (int u = 0; u < size.width; ++u) {
            const Eigen::Vector3d colour = world(roomFromPhoto * direction(size, Eigen::Vector2d(u, v)));
            for (int c = 0; c < 3; ++c) {
                picture.at(u, v)[c] = static_cast<std::uint8_t>(std::lround(colour[c]));
            }
        }
    }
    return picture;
}

/// Rewrites dataset.json after a change of the info.
inline void rewriteInfo(const std::filesystem::path& folder, const render::DatasetInfo& info) {
    writeFile(folder / render::kDatasetFile, bytesOf(render::toJson(info).dump(1)));
}

/// Writes a dataset with a photo of the world at each pose.
inline render::DatasetInfo writeTestDataset(const std::filesystem::path& folder,
                                            const std::vector<Rigid3>& poses, const World& world,
                                            int width = 512, std::optional<double> sphereRadiusM = {}) {
    std::filesystem::create_directories(folder / "photos");
    render::DatasetInfo info;
    info.id = "00000000-0000-4000-8000-000000000000";
    info.name = "test";
    info.createdUtc = "2026-01-01T00:00:00.000Z";
    info.madeBy = "test";
    info.surveyId = info.id;
    info.sphereRadiusM = sphereRadiusM;
    for (const Rigid3& pose : poses) {
        const Bytes jpeg = jpeg::encode(panorama(world, pose.rotation, width), 98);
        render::DatasetPhoto photo;
        photo.file = "photos/" + std::to_string(info.photos.size()) + ".jpg";
        photo.sha256 = sha256Hex(jpeg);
        photo.sizeBytes = jpeg.size();
        photo.width = width;
        photo.height = width / 2;
        photo.roomFromPhoto = pose;
        photo.rotationSource = "imported";
        writeFile(folder / photo.file, jpeg);
        info.photos.push_back(photo);
    }
    rewriteInfo(folder, info);
    return info;
}

/// Writes a dataset of an empty room of 3 x 2 x 2.5 m that four photos see, with exact depths.
inline render::DatasetInfo writeEmptyRoom(const std::filesystem::path& folder) {
    constexpr int kWidth = 256;
    std::vector<Rigid3> poses;
    for (const auto& [x, y] : {std::pair{1.0, 0.8}, {2.0, 0.8}, {1.0, 1.3}, {2.0, 1.3}}) {
        poses.push_back({Eigen::Quaterniond::Identity(), {x, y, 1.2}});
    }
    render::DatasetInfo info = writeTestDataset(folder, poses, smoothWorld, kWidth);
    info.roomShape = render::RoomShape{{{0, 0}, {3, 0}, {3, 2}, {0, 2}}, 0, 2.5};
    std::filesystem::create_directories(folder / "depth");
    for (render::DatasetPhoto& photo : info.photos) {
        photo.depth = "depth/" + std::filesystem::path(photo.file).stem().string() + ".pgm";
        writeFile(folder / photo.depth,
                  render::roomDepth(*info.roomShape, photo.roomFromPhoto, kWidth).serialised());
    }
    rewriteInfo(folder, info);
    return info;
}

/// Gives a photo of the dataset restart markers and their index, as export does. The pixels stay the same.
inline void mark(const std::filesystem::path& folder, render::DatasetPhoto& photo, int interval = 8) {
    std::filesystem::create_directories(folder / "index");
    const Bytes marked = jpeg::withRestartMarkers(readFile(folder / photo.file), interval, photo.file);
    writeFile(folder / photo.file, marked);
    photo.sizeBytes = marked.size();
    photo.sha256 = sha256Hex(marked);
    photo.restartIndex = "index/" + std::filesystem::path(photo.file).stem().string() + ".swri";
    writeFile(folder / photo.restartIndex, jpeg::serialised(jpeg::indexRestarts(marked, photo.file)));
}

/// Gives a photo a thumbnail: an eighth of the photo.
inline void addThumbnail(const std::filesystem::path& folder, render::DatasetPhoto& photo) {
    std::filesystem::create_directories(folder / "thumbnails");
    photo.thumbnail = "thumbnails/" + std::filesystem::path(photo.file).filename().string();
    writeFile(folder / photo.thumbnail,
              jpeg::encode(jpeg::decode(readFile(folder / photo.file), photo.file, 8), 90));
}

} // namespace spherewalk::test
