// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/digest.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/dataset/writer.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/render/dataset.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace spherewalk::test {

/// Different everywhere, with details of a few pixels, and different for each number.
inline RgbImage madePanorama(int width, int number) {
    RgbImage picture(width, width / 2);
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < 3; ++c) {
                const double wave = std::sin(0.05 * (c + 1) * x + number) * std::cos(0.07 * y + c);
                const int joint = (x / 16 + y / 16) % 2 * 40;
                picture.at(x, y)[c] = static_cast<std::uint8_t>(90 + 60 * wave + joint);
            }
        }
    }
    return picture;
}

struct MadeDataset {
    std::vector<Eigen::Vector3d> places{{0, 0, 1.2}, {0.5, 0, 1.2}, {1, 0, 1.2}};
    int width = 512;
    bool hasSphere = true;
    bool hasRoom = false; ///< a box about the places
    bool isEven = false;  ///< All pixels have one colour.
};

/// Writes the dataset with restart markers and thumbnails, as an export does, into `folder`/dataset.
inline std::filesystem::path writeMadeDataset(const std::filesystem::path& folder,
                                              const MadeDataset& made = {}) {
    dataset::Contents contents;
    contents.info.id = contents.info.surveyId = "00000000-0000-4000-8000-000000000000";
    contents.info.name = "made";
    contents.info.createdUtc = "2026-01-01T00:00:00.000Z";
    contents.info.madeBy = "test";
    if (made.hasSphere) {
        contents.info.sphereRadiusM = 2.5;
    }
    if (made.hasRoom) {
        contents.info.roomShape = {{{-2, -2}, {3, -2}, {3, 2}, {-2, 2}}, 0, 2.5};
    }
    for (std::size_t i = 0; i < made.places.size(); ++i) {
        const auto file = folder / (std::to_string(i) + ".jpg");
        RgbImage picture = madePanorama(made.width, static_cast<int>(i));
        if (made.isEven) {
            std::fill(picture.values().begin(), picture.values().end(), std::uint8_t{120});
        }
        const Bytes bytes = jpeg::encode(picture, 90);
        writeFile(file, bytes);
        render::DatasetPhoto entry;
        entry.roomFromPhoto = {Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ())),
                               made.places[i]};
        entry.rotationSource = "imported";
        contents.photos.push_back({file, sha256Hex(bytes), entry});
    }
    dataset::WriteOptions options;
    options.thumbnailWidth = 128;
    dataset::writeDataset(contents, folder / "dataset", options, noProgress(), {});
    return folder / "dataset";
}

inline std::shared_ptr<const render::Dataset> openMadeDataset(const std::filesystem::path& folder,
                                                              const MadeDataset& made = {}) {
    return std::make_shared<const render::Dataset>(render::Dataset::open(writeMadeDataset(folder, made)));
}

/// The same dataset as if its photos had no restart markers.
inline std::shared_ptr<const render::Dataset> withoutMarkers(const render::Dataset& dataset) {
    render::DatasetInfo info = dataset.info();
    for (render::DatasetPhoto& photo : info.photos) {
        photo.restartIndex.clear();
    }
    writeFile(dataset.folder() / render::kDatasetFile, bytesOf(render::toJson(info).dump()));
    return std::make_shared<const render::Dataset>(render::Dataset::open(dataset.folder()));
}

/// A stop that has been asked for.
inline std::stop_token stopped() {
    std::stop_source source;
    source.request_stop();
    return source.get_token();
}

} // namespace spherewalk::test
