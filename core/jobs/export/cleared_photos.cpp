// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/cleared_photos.h"

#include "parts/cache_key.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/folder.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/blurred_photo.h"
#include "spherewalk/photo/metadata.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/scene/exposure.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <numbers>
#include <optional>

namespace spherewalk::jobs {

namespace {

constexpr int kMethod = 5; ///< grows when the same photos are cleared in another way
constexpr std::size_t kHelpers = 8;
constexpr double kLeastBaselineM = 0.1; ///< a nearer photo shows nothing that this one does not
constexpr std::size_t kHelpersKept = 16;
constexpr std::size_t kPhotosToLookAt = 24;
constexpr int kLookWidth = 256;
constexpr int kHelperWidth = 2048; ///< of the pictures that floor and walls are taken from, at least

RgbImage decoded(const std::filesystem::path& file, int leastWidth) {
    return jpeg::decodeAtLeast(readFile(file), file.string(), leastWidth);
}

/// The photo as other photos may show it.
RgbImage withoutPrivate(const DepthInput& photo, int leastWidth) {
    RgbImage picture = decoded(photo.file, leastWidth);
    photo::blurRegions(picture, photo.regions);
    return picture;
}

scene::CarriedThings lookedAt(const std::vector<DepthInput>& photos, const std::stop_token& stop) {
    std::vector<RgbImage> pictures;
    for (const DepthInput& photo : photos) {
        throwIfStopped(stop);
        pictures.push_back(photo::resized(decoded(photo.file, kLookWidth), kLookWidth, kLookWidth / 2));
    }
    std::vector<scene::PosedPicture> posed;
    for (std::size_t k = 0; k < photos.size(); ++k) {
        posed.push_back({&pictures[k], photos[k].roomFromPhoto});
    }
    return scene::carriedThings(posed);
}

/// What an earlier run has found; nothing if none did, or if the file is damaged.
std::optional<scene::CarriedThings> keptThings(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::array<float, scene::CarriedThings::kAzimuths> reach{};
    for (float& angle : reach) {
        if (!(in >> angle) || !(angle >= 0 && angle < std::numbers::pi_v<float>)) {
            return std::nullopt;
        }
    }
    return scene::CarriedThings(reach);
}

/// What is carried along. It is looked for once for the same photos.
scene::CarriedThings carriedBy(const std::vector<DepthInput>& all, const std::filesystem::path& cacheFolder,
                               const std::stop_token& stop) {
    const std::vector<DepthInput> photos = spreadEvenly(all, kPhotosToLookAt);
    std::string key = text("carried ", kMethod);
    for (const DepthInput& photo : photos) {
        key += text("\n", photo.sha256, " ", keyOf(photo.roomFromPhoto));
    }
    const std::filesystem::path file = cacheFolder / (sha256Hex(bytesOf(key)).substr(0, 32) + ".txt");
    if (const auto earlier = keptThings(file)) {
        return *earlier;
    }
    const scene::CarriedThings found = lookedAt(photos, stop);
    std::string lines;
    for (const float angle : found.reachRad()) {
        lines += text(angle, "\n");
    }
    ensureFolder(cacheFolder);
    writeFile(file, bytesOf(lines));
    return keptThings(file).value(); // rounded as a later run will find it
}

} // namespace

void tellGains(std::span<DepthInput> photos) {
    std::vector<std::optional<double>> stops;
    for (const DepthInput& photo : photos) {
        stops.push_back(photo::exposureStops(photo::readMetadata(readFile(photo.file), photo.file.string())));
    }
    const auto gains = scene::toldGains(stops);
    for (std::size_t i = 0; i < photos.size(); ++i) {
        photos[i].gains = gains[i];
    }
}

std::vector<DepthInput> depthInputs(std::span<const dataset::SourcePhoto> photos) {
    std::vector<DepthInput> inputs;
    for (const dataset::SourcePhoto& photo : photos) {
        inputs.push_back(
            {photo.file, photo.sha256, photo.entry.roomFromPhoto, photo.entry.lenses, photo.regions});
    }
    tellGains(inputs);
    return inputs;
}

ClearedPhotos::ClearedPhotos(std::vector<DepthInput> photos, survey::Room room,
                             std::filesystem::path cacheFolder, bool looks, const std::stop_token& stop)
    : m_photos(std::move(photos)),
      m_room(std::move(room)),
      m_carried(looks ? carriedBy(m_photos, cacheFolder, stop) : scene::CarriedThings()),
      m_inputs(m_photos),
      m_pictures(kHelpersKept) {
    if (m_carried.empty()) {
        return;
    }
    std::vector<Rigid3> poses;
    for (const DepthInput& photo : m_photos) {
        poses.push_back(photo.roomFromPhoto);
    }
    scene::SweepOptions nearest;
    nearest.neighbours = static_cast<int>(kHelpers);
    nearest.leastBaselineM = kLeastBaselineM;
    for (std::size_t i = 0; i < m_photos.size(); ++i) {
        m_helpers.push_back(scene::sweepNeighbours(poses, i, nearest, m_room.outline));
    }
    for (std::size_t i = 0; i < m_photos.size(); ++i) {
        const std::string key = keyOfPhoto(i);
        m_inputs[i].sha256 = key;
        m_inputs[i].file = cacheFolder / key.substr(0, 32) / m_photos[i].file.filename();
    }
}

std::string ClearedPhotos::keyOfPhoto(std::size_t photo) const {
    std::string key = text("cleared ", kMethod, " ", m_photos[photo].sha256, " ",
                           keyOf(m_photos[photo].roomFromPhoto), "\n", m_room.ceilingM);
    for (const float reach : m_carried.reachRad()) {
        key += text(" ", reach);
    }
    key += keyOf(m_room.outline);
    for (const std::size_t other : m_helpers[photo]) {
        key += text("\n", m_photos[other].sha256, " ", keyOf(m_photos[other].roomFromPhoto));
        for (const survey::PrivateRegion& region : m_photos[other].regions) {
            key += text(" ", region.azimuth.value(), " ", region.elevation.value(), " ", region.width.value(),
                        " ", region.height.value());
        }
    }
    return sha256Hex(bytesOf(key));
}

scene::FilledPicture ClearedPhotos::filled(std::size_t photo, const RgbImage& picture) {
    std::vector<std::shared_ptr<const RgbImage>> pictures;
    std::vector<scene::PosedPicture> others;
    for (const std::size_t other : m_helpers[photo]) {
        pictures.push_back(
            m_pictures.get(other, [&] { return withoutPrivate(m_photos[other], kHelperWidth); }));
        others.push_back({pictures.back().get(), m_photos[other].roomFromPhoto});
    }
    return scene::withoutCarried({&picture, m_photos[photo].roomFromPhoto}, others, m_carried, m_room);
}

void ClearedPhotos::make(std::size_t photo, const std::stop_token& stop) {
    throwIfStopped(stop);
    const std::filesystem::path& file = m_inputs[photo].file;
    if (m_carried.empty() || std::filesystem::is_regular_file(file)) {
        return;
    }
    const std::string name = m_photos[photo].file.string();
    const Bytes bytes = readFile(m_photos[photo].file);
    ensureFolder(file.parent_path());
    if (jpeg::readInfo(bytes, name).components != RgbImage::kChannels) {
        writeFile(file, bytes); // colours cannot be put into a grey photo
        return;
    }
    const scene::FilledPicture clear = filled(photo, jpeg::decode(bytes, name));
    writeFile(file, jpeg::withPixels(bytes, clear.picture, clear.filled, name));
}

} // namespace spherewalk::jobs
