// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/depth_map.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace spherewalk::render {

namespace {

constexpr std::string_view kMagic = "P5\n# inverse distance: value / 2 / 1600 per metre; odd: sure\n";
constexpr int kLeastWidth = 16;
constexpr int kMostWidth = 8192;

bool isSize(int width, int height) {
    return width >= kLeastWidth && width <= kMostWidth && width == 2 * height;
}

[[noreturn]] void refuse(std::string_view source, std::string_view what) {
    throw Error(ErrorKind::Corrupt,
                text("The depth ", source, " is damaged: ", what, "; export the dataset again."));
}

/// A positive number and the one character after it. Position: after that.
std::optional<int> number(std::string_view text, std::size_t& position) {
    int value = 0;
    const std::size_t begin = position;
    while (position < text.size() && text[position] >= '0' && text[position] <= '9' && value <= 100000) {
        value = 10 * value + (text[position++] - '0');
    }
    if (position == begin || position >= text.size()) {
        return std::nullopt;
    }
    ++position;
    return value;
}

} // namespace

DepthMap::DepthMap(Image<float, 1> inverseM, MaskImage sure)
    : m_inverseM(std::move(inverseM)), m_sure(std::move(sure)) {
    if (m_sure.empty()) {
        m_sure = MaskImage(m_inverseM.width(), m_inverseM.height());
        std::fill(m_sure.values().begin(), m_sure.values().end(), std::uint8_t{255});
    }
    if (!isSize(width(), height()) || m_sure.width() != width() || m_sure.height() != height()) {
        throw Error(ErrorKind::InvalidInput,
                    text("A depth of ", width(), " x ", height(),
                         " pixels cannot be used: it must be twice as wide as high, 16 to 8192 wide."));
    }
    for (float& value : m_inverseM.values()) {
        if (std::isnan(value)) {
            throw Error(ErrorKind::InvalidInput, "A depth holds values that are no numbers.");
        }
        const double steps = std::clamp(std::floor(value / kStepPerM + 0.5), 1.0, double{kSteps});
        value = static_cast<float>(steps * kStepPerM);
    }
}

DepthMap DepthMap::parse(ByteView bytes, std::string_view source) {
    const std::string_view content(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (!content.starts_with(kMagic)) {
        refuse(source, "it does not begin as a depth does");
    }
    std::size_t position = kMagic.size();
    const auto width = number(content, position);
    const auto height = width ? number(content, position) : std::nullopt;
    const auto most = height ? number(content, position) : std::nullopt;
    if (!most || *most != 65535 || !isSize(*width, *height)) {
        refuse(source, "its size makes no sense");
    }
    const std::size_t count = static_cast<std::size_t>(*width) * static_cast<std::size_t>(*height);
    if (bytes.size() - position != 2 * count) {
        refuse(source, "it has another length than its size asks for");
    }
    Image<float, 1> inverse(*width, *height);
    MaskImage sure(*width, *height);
    for (std::size_t i = 0; i < count; ++i) {
        const int value =
            256 * static_cast<int>(bytes[position + 2 * i]) + static_cast<int>(bytes[position + 2 * i + 1]);
        inverse.values()[i] = static_cast<float>(value / 2 * kStepPerM);
        sure.values()[i] = value % 2 == 1 ? 255 : 0;
    }
    return DepthMap(std::move(inverse), std::move(sure));
}

Bytes DepthMap::serialised() const {
    const std::string header = text(kMagic, width(), " ", height(), "\n65535\n");
    Bytes bytes(header.begin(), header.end());
    bytes.reserve(bytes.size() + 2 * m_inverseM.values().size());
    for (std::size_t i = 0; i < m_inverseM.values().size(); ++i) {
        const auto steps = static_cast<int>(std::lround(m_inverseM.values()[i] / kStepPerM));
        const int value = 2 * steps + (m_sure.values()[i] != 0 ? 1 : 0);
        bytes.push_back(static_cast<Bytes::value_type>(value / 256));
        bytes.push_back(static_cast<Bytes::value_type>(value % 256));
    }
    return bytes;
}

} // namespace spherewalk::render
