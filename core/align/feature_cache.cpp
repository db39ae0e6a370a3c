// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/feature_cache.h"

#include "feature_bytes.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/sha256.h"
#include "spherewalk/base/text.h"

#include <utility>

namespace spherewalk::align {

namespace {

constexpr int kMethod = 1; ///< grows when the same photo and options give other features
constexpr std::uint64_t kMostFileBytes = 16 << 20;

std::string settingsText(const FeatureOptions& options, const MaskImage& mask) {
    return text("method ", kMethod, " detector ", std::string(name(options.detector)), " width ",
                options.width, " most ", options.most, " contrast ", options.leastContrast, " lowest ",
                options.lowestElevation.value(), " zenith ", static_cast<int>(options.usesZenith),
                " upright ", static_cast<int>(options.isUpright), " mask ", mask.width(), " x ",
                mask.height(), " ", mask.empty() ? std::string("none") : sha256Hex(mask.values()));
}

} // namespace

FeatureCache::FeatureCache(std::filesystem::path folder, const FeatureOptions& options, const MaskImage& mask)
    : m_folder(std::move(folder)), m_settings(settingsText(options, mask)), m_options(options) {
}

std::string FeatureCache::keyOf(const std::string& photoSha256) const {
    return sha256Hex(bytesOf(text(photoSha256, " ", m_settings)));
}

std::filesystem::path FeatureCache::fileOf(const std::string& photoSha256) const {
    return m_folder / (keyOf(photoSha256).substr(0, 32) + ".features");
}

std::optional<Features> FeatureCache::find(const std::string& photoSha256) const {
    Bytes bytes;
    try {
        bytes = readFile(fileOf(photoSha256), kMostFileBytes);
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::NotFound || error.kind() == ErrorKind::Corrupt) { // too large for ours
            return std::nullopt;
        }
        throw;
    }
    auto features = fromBytes(bytes, keyOf(photoSha256));
    const bool isOurs =
        features && features->detector == m_options.detector && features->count() <= m_options.most;
    return isOurs ? std::move(features) : std::nullopt;
}

void FeatureCache::keep(const std::string& photoSha256, const Features& features) const {
    ensureFolder(m_folder);
    writeFile(fileOf(photoSha256), toBytes(features, keyOf(photoSha256)));
}

} // namespace spherewalk::align
