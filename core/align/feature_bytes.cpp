// SPDX-License-Identifier: GPL-3.0-or-later
#include "feature_bytes.h"

#include "spherewalk/base/sha256.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace spherewalk::align {

static_assert(std::endian::native == std::endian::little, "the file is little endian");

namespace {

constexpr std::string_view kMagic = "SWFEAT01";
constexpr std::size_t kDigestBytes = 64;
constexpr std::uint32_t kMostCount = 50000;
constexpr std::uint32_t kMostDescriptorBytes = 128;

template <class Value>
void append(const Value* values, std::size_t count, Bytes& bytes) {
    const auto* first = reinterpret_cast<const std::uint8_t*>(values);
    bytes.insert(bytes.end(), first, first + count * sizeof(Value));
}

/// Takes values off the front of bytes of which enough are left, as fromBytes() has made sure.
template <class Value>
void take(ByteView& bytes, std::size_t count, Value* values) {
    if (count > 0) {
        std::memcpy(values, bytes.data(), count * sizeof(Value));
        bytes = bytes.subspan(count * sizeof(Value));
    }
}

bool isUsable(const Features& features) {
    const auto isUnit = [](const Eigen::Vector3f& b) { return std::abs(b.norm() - 1) < 1e-4F; };
    const auto isSigma = [](float sigma) { return sigma > 0 && sigma < 1; };
    const auto isFinite = [](float response) { return std::isfinite(response); };
    return std::all_of(features.bearings.begin(), features.bearings.end(), isUnit) &&
           std::all_of(features.sigmasRad.begin(), features.sigmasRad.end(), isSigma) &&
           std::all_of(features.responses.begin(), features.responses.end(), isFinite);
}

} // namespace

Bytes toBytes(const Features& features, std::string_view key) {
    const auto count = static_cast<std::uint32_t>(features.count());
    const std::uint32_t header[] = {static_cast<std::uint32_t>(key.size()),
                                    static_cast<std::uint32_t>(features.detector), count,
                                    static_cast<std::uint32_t>(features.descriptorBytes)};
    Bytes bytes;
    append(kMagic.data(), kMagic.size(), bytes);
    append(header, std::size(header), bytes);
    append(key.data(), key.size(), bytes);
    for (const Eigen::Vector3f& bearing : features.bearings) {
        append(bearing.data(), 3, bytes);
    }
    append(features.sigmasRad.data(), count, bytes);
    append(features.responses.data(), count, bytes);
    append(features.descriptors.data(), features.descriptors.size(), bytes);
    const std::string digest = sha256Hex(bytes);
    append(digest.data(), digest.size(), bytes);
    return bytes;
}

std::optional<Features> fromBytes(ByteView bytes, std::string_view key) {
    std::uint32_t header[4] = {};
    const std::size_t front = kMagic.size() + sizeof(header) + key.size();
    if (bytes.size() < front + kDigestBytes) {
        return std::nullopt;
    }
    const ByteView content = bytes.first(bytes.size() - kDigestBytes);
    if (textOf(bytes.last(kDigestBytes)) != sha256Hex(content) ||
        textOf(content.first(kMagic.size())) != kMagic) {
        return std::nullopt;
    }
    ByteView rest = content.subspan(kMagic.size());
    take(rest, std::size(header), header);
    const auto [keyBytes, detector, count, descriptorBytes] = std::to_array(header);
    const std::size_t each = 5 * sizeof(float) + descriptorBytes;
    if (keyBytes != key.size() || textOf(rest.first(key.size())) != key || detector > 2 ||
        count > kMostCount || descriptorBytes > kMostDescriptorBytes || descriptorBytes % 32 != 0 ||
        (count > 0 && descriptorBytes == 0) || rest.size() - key.size() != count * each) {
        return std::nullopt;
    }
    rest = rest.subspan(key.size());
    Features features;
    features.detector = static_cast<Detector>(detector);
    features.descriptorBytes = static_cast<int>(descriptorBytes);
    features.bearings.resize(count);
    features.sigmasRad.resize(count);
    features.responses.resize(count);
    features.descriptors.resize(static_cast<std::size_t>(count) * descriptorBytes);
    for (Eigen::Vector3f& bearing : features.bearings) {
        take(rest, 3, bearing.data());
    }
    take(rest, count, features.sigmasRad.data());
    take(rest, count, features.responses.data());
    take(rest, features.descriptors.size(), features.descriptors.data());
    return isUsable(features) ? std::optional(std::move(features)) : std::nullopt;
}

} // namespace spherewalk::align
