// SPDX-License-Identifier: Apache-2.0
#include "dataset/depth_steps.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"

#include <cmath>
#include <optional>

namespace spherewalk::render {

namespace {

constexpr std::string_view kDepthMagic = "P5\n# inverse distance: value / 2 / 1600 per metre; odd: sure\n";
constexpr int kLeastDepthWidth = 16;
constexpr int kMostDepthWidth = 8192;

bool isDepthSize(int width, int height) {
    return width >= kLeastDepthWidth && width <= kMostDepthWidth && width == 2 * height;
}

[[noreturn]] void refuseDepth(std::string_view source, std::string_view what) {
    throw Error(ErrorKind::Corrupt,
                text("The depth ", source, " is damaged: ", what, "; export the dataset again."));
}

/// Reads a positive number and the one character after it. position: moves behind that character.
std::optional<int> headerNumber(std::string_view text, std::size_t& position) {
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

DepthSteps DepthSteps::read(const std::filesystem::path& file) {
    constexpr std::uint64_t kLargestFile = 128ULL << 20;
    return parse(readFile(file, kLargestFile), file.string());
}

DepthSteps DepthSteps::parse(ByteView bytes, std::string_view source) {
    const std::string_view content(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (!content.starts_with(kDepthMagic)) {
        refuseDepth(source, "it does not begin as a depth does");
    }
    std::size_t position = kDepthMagic.size();
    const auto width = headerNumber(content, position);
    const auto height = width ? headerNumber(content, position) : std::nullopt;
    const auto most = height ? headerNumber(content, position) : std::nullopt;
    if (!most || *most != 65535 || !isDepthSize(*width, *height)) {
        refuseDepth(source, "its size makes no sense");
    }
    DepthSteps depth(*width, *height);
    if (bytes.size() - position != 2 * depth.m_values.size()) {
        refuseDepth(source, "it has another length than its size asks for");
    }
    const auto* at = reinterpret_cast<const std::uint8_t*>(bytes.data()) + position;
    std::uint16_t* values = depth.m_values.data();
    for (std::size_t i = 0; i < depth.m_values.size(); ++i) {
        const auto value = static_cast<std::uint16_t>(at[2 * i] << 8 | at[2 * i + 1]);
        values[i] = value < 2 ? static_cast<std::uint16_t>(value + 2) : value;
    }
    return depth;
}

DepthSteps::DepthSteps(const DepthMap& map) : DepthSteps(map.width(), map.height()) {
    for (std::size_t i = 0; i < m_values.size(); ++i) {
        const auto steps = static_cast<int>(std::lround(map.inverseM().values()[i] / DepthMap::kStepPerM));
        m_values[i] = static_cast<std::uint16_t>(2 * steps + (map.sure().values()[i] != 0 ? 1 : 0));
    }
}

DepthMap::DepthMap(Image<float, 1> inverseM, MaskImage sure)
    : m_inverseM(std::move(inverseM)), m_sure(std::move(sure)) {
    if (m_sure.empty()) {
        m_sure = MaskImage(m_inverseM.width(), m_inverseM.height());
        std::fill(m_sure.values().begin(), m_sure.values().end(), std::uint8_t{255});
    }
    if (!isDepthSize(width(), height()) || m_sure.width() != width() || m_sure.height() != height()) {
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

DepthMap::DepthMap(const DepthSteps& steps)
    : m_inverseM(steps.width(), steps.height()), m_sure(steps.width(), steps.height()) {
    for (int y = 0; y < height(); ++y) {
        const std::uint16_t* values = steps.row(y);
        float* inverse = m_inverseM.at(0, y);
        std::uint8_t* sure = m_sure.at(0, y);
        for (int x = 0; x < width(); ++x) {
            inverse[x] = DepthSteps::inverseM(values[x]);
            sure[x] = DepthSteps::isSure(values[x]) ? 255 : 0;
        }
    }
}

DepthMap DepthMap::read(const std::filesystem::path& file) {
    return DepthMap(DepthSteps::read(file));
}

DepthMap DepthMap::parse(ByteView bytes, std::string_view source) {
    return DepthMap(DepthSteps::parse(bytes, source));
}

Bytes DepthMap::serialised() const {
    const std::string header = text(kDepthMagic, width(), " ", height(), "\n65535\n");
    Bytes bytes(header.begin(), header.end());
    bytes.reserve(bytes.size() + 2 * m_inverseM.values().size());
    const DepthSteps steps(*this);
    for (int y = 0; y < height(); ++y) {
        for (int x = 0; x < width(); ++x) {
            bytes.push_back(static_cast<Bytes::value_type>(steps.row(y)[x] / 256));
            bytes.push_back(static_cast<Bytes::value_type>(steps.row(y)[x] % 256));
        }
    }
    return bytes;
}

} // namespace spherewalk::render
