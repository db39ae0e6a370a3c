// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/dataset.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <mutex>
#include <utility>

namespace spherewalk::render {

namespace {

constexpr std::uint64_t kLargestDescription = 1ULL << 30;

/// The size of a file of the dataset. Stores of large files keep it elsewhere and leave a link, so links are
/// followed. Errors: NotFound.
std::uint64_t sizeOf(const std::filesystem::path& folder, const std::string& name) {
    const std::filesystem::path file = folder / name;
    std::error_code failure;
    const auto status = std::filesystem::status(file, failure);
    if (failure || !std::filesystem::is_regular_file(status)) {
        const bool isLink = std::filesystem::is_symlink(std::filesystem::symlink_status(file, failure));
        throw Error(ErrorKind::NotFound,
                    text("Could not open the dataset ", folder.string(), ": its file ", name,
                         isLink ? " is a link to a file that is not here; fetch that file."
                                : " is missing; export it again."));
    }
    return std::filesystem::file_size(file);
}

[[noreturn]] void refuseChanged(const std::filesystem::path& folder, const DatasetPhoto& photo,
                                const std::string& how) {
    throw Error(ErrorKind::Corrupt, text("Could not use the dataset ", folder.string(), ": its photo ",
                                         photo.file, " ", how, "; copy or export the dataset again."));
}

bool hasScene(const DatasetInfo& info, std::size_t photo, SceneKind kind) {
    switch (kind) {
    case SceneKind::Sphere:
        return info.sphereRadiusM.has_value();
    case SceneKind::Room:
        return info.roomShape.has_value();
    case SceneKind::Depth:
    case SceneKind::Blend:
        return !info.photos[photo].depth.empty();
    default:
        return true;
    }
}

} // namespace

std::vector<SceneKind> scenesOf(const DatasetInfo& info) {
    std::vector<SceneKind> scenes{SceneKind::None};
    if (info.sphereRadiusM) {
        scenes.push_back(SceneKind::Sphere);
    }
    if (info.roomShape) {
        scenes.push_back(SceneKind::Room);
    }
    if (std::any_of(info.photos.begin(), info.photos.end(),
                    [](const DatasetPhoto& photo) { return !photo.depth.empty(); })) {
        scenes.insert(scenes.end(), {SceneKind::Depth, SceneKind::Blend});
    }
    return scenes;
}

SceneKind bestScene(const DatasetInfo& info, std::size_t photo) {
    if (!info.photos[photo].depth.empty()) {
        return SceneKind::Depth;
    }
    if (info.roomShape) {
        return SceneKind::Room;
    }
    return info.sphereRadiusM ? SceneKind::Sphere : SceneKind::None;
}

SceneKind autoScene(const DatasetInfo& info, std::size_t photo, const CameraIntrinsics& camera) {
    if (info.choice && info.choice->isFor(camera)) {
        const SceneKind chosen = info.photos[photo].scene.value_or(info.choice->scene);
        if (hasScene(info, photo, chosen)) {
            return chosen;
        }
    }
    return bestScene(info, photo);
}

Sampling autoSampling(const DatasetInfo& info, Sampling sampling, const CameraIntrinsics& camera) {
    const bool isChosen = sampling == Sampling::Auto && info.choice && info.choice->isFor(camera);
    return isChosen ? info.choice->sampling : sampling;
}

Dataset Dataset::open(const std::filesystem::path& folder, Verify verify, ProgressSink& progress,
                      const std::stop_token& stop) {
    const std::filesystem::path file = folder / kDatasetFile;
    if (!std::filesystem::exists(file)) {
        throw Error(ErrorKind::NotFound, text("Could not open ", folder.string(),
                                              " as a dataset: it holds no ", kDatasetFile, "."));
    }
    const Json json =
        parseJson(readTextFile(file, kLargestDescription), file.string(), {kLargestDescription, 32});
    Dataset dataset(folder, parseDatasetInfo(json, file.string()));
    dataset.checkSizes();
    if (verify == Verify::Hashes) {
        const int count = static_cast<int>(dataset.m_info.photos.size());
        int done = 0;
        std::mutex mutex;
        parallelFor(count, 1, 0, [&](int begin, int /*end*/) {
            throwIfStopped(stop);
            dataset.readPhoto(static_cast<std::size_t>(begin));
            const std::scoped_lock lock(mutex);
            progress.progress(static_cast<double>(++done) / count, "Checking the dataset");
        });
    }
    return dataset;
}

void Dataset::checkSizes() const {
    for (const DatasetPhoto& photo : m_info.photos) {
        const std::uint64_t size = sizeOf(m_folder, photo.file);
        if (size != photo.sizeBytes) {
            refuseChanged(m_folder, photo,
                          text("has ", size, " bytes, not the ", photo.sizeBytes, " it should have"));
        }
        for (const std::string& name : {photo.restartIndex, photo.thumbnail, photo.depth}) {
            if (!name.empty()) {
                sizeOf(m_folder, name);
            }
        }
    }
}

Bytes Dataset::readPhoto(std::size_t photo) const {
    const DatasetPhoto& entry = m_info.photos.at(photo);
    Bytes bytes = readFile(m_folder / entry.file, entry.sizeBytes);
    if (sha256Hex(bytes) != entry.sha256) {
        refuseChanged(m_folder, entry, "was changed after the export (its SHA-256 is another)");
    }
    return bytes;
}

} // namespace spherewalk::render
