// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/render/scene_depth.h"
#include "spherewalk/web/page.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::web {

namespace {

constexpr int kWidestDepth = 512;
constexpr float kMostJump = 1.08F; // of 1 / distance within one surface, as views take it

/// Source: RFC 4648, section 4.
std::string base64(ByteView bytes) {
    constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string result;
    result.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group = group << 8U | (k < count ? bytes[i + k] : 0U);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            result += k <= count ? kLetters[group >> (18 - 6 * k) & 63U] : '=';
        }
    }
    return result;
}

/// The picture without what says who took it where and with which camera.
Bytes onlyPicture(ByteView jpeg, std::string_view source) {
    Bytes result = {0xFF, jpeg::kSoi};
    std::size_t end = result.size();
    for (const jpeg::Segment& segment : jpeg::segments(jpeg, source)) {
        const bool isForDecoders = segment.marker == jpeg::kApp0 || segment.marker == 0xEE; // JFIF, Adobe
        const bool isTold =
            segment.marker == jpeg::kCom || (segment.marker >= jpeg::kApp0 && segment.marker <= jpeg::kApp15);
        if (isForDecoders || !isTold) {
            const ByteView whole = segment.whole(jpeg);
            result.insert(result.end(), whole.begin(), whole.end());
        }
        end = segment.offset + segment.size;
    }
    result.insert(result.end(), jpeg.begin() + static_cast<std::ptrdiff_t>(end), jpeg.end());
    return result;
}

/// The greatest width up to kWidestDepth that divides the depth's own.
int shownDepthWidth(int width) {
    int parts = 1;
    while (width / parts > kWidestDepth || width % parts != 0) {
        ++parts;
    }
    return width / parts;
}

/// One value of the reduced depth, as files have it, from a block of pixels.
std::uint16_t reduced(const render::DepthMap& depth, int left, int top, int size) {
    float least = HUGE_VALF;
    float most = 0;
    float sum = 0;
    bool isSure = true;
    for (int y = top; y < top + size; ++y) {
        for (int x = left; x < left + size; ++x) {
            const float inverse = *depth.inverseM().at(x, y);
            least = std::min(least, inverse);
            most = std::max(most, inverse);
            sum += inverse;
            isSure = isSure && *depth.sure().at(x, y) != 0;
        }
    }
    const bool isOneSurface = most <= kMostJump * least;
    const float inverse = isOneSurface ? sum / static_cast<float>(size * size) : most;
    const auto steps = std::lround(static_cast<double>(inverse) / render::DepthMap::kStepPerM);
    return static_cast<std::uint16_t>(steps << 1 | (isSure && isOneSurface ? 1 : 0));
}

Bytes depthBytes(const render::DepthMap& depth) {
    const int width = shownDepthWidth(depth.width());
    const int size = depth.width() / width;
    Bytes bytes;
    for (int y = 0; y < width / 2; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::uint16_t value = reduced(depth, x * size, y * size, size);
            bytes.push_back(static_cast<std::uint8_t>(value & 0xFFU));
            bytes.push_back(static_cast<std::uint8_t>(value >> 8U));
        }
    }
    return bytes;
}

} // namespace

std::string scriptName(std::size_t photo) {
    const std::string digits = text(photo + 1);
    return text("photos/", std::string(4 - std::min<std::size_t>(4, digits.size()), '0'), digits, ".js");
}

std::string photoScript(std::size_t photo, ByteView jpeg, const std::filesystem::path& depthFile) {
    Json content{{"picture", base64(onlyPicture(jpeg, text("photo ", photo + 1)))}};
    if (!depthFile.empty()) {
        content["depth"] = base64(depthBytes(render::DepthMap::read(depthFile)));
    }
    return text("spherewalk.arrived(", photo, ", ", content.dump(), ");\n");
}

} // namespace spherewalk::web
