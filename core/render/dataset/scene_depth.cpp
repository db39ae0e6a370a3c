// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/scene_depth.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/equirect.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

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

DepthMap DepthMap::read(const std::filesystem::path& file) {
    constexpr std::uint64_t kLargestFile = 128ULL << 20;
    return parse(readFile(file, kLargestFile), file.string());
}

DepthMap DepthMap::parse(ByteView bytes, std::string_view source) {
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
    const std::size_t count = static_cast<std::size_t>(*width) * static_cast<std::size_t>(*height);
    if (bytes.size() - position != 2 * count) {
        refuseDepth(source, "it has another length than its size asks for");
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
    const std::string header = text(kDepthMagic, width(), " ", height(), "\n65535\n");
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

void RoomShape::validate() const {
    const bool isFinite = std::all_of(outline.begin(), outline.end(),
                                      [](const Eigen::Vector2d& corner) { return corner.allFinite(); });
    if (outline.size() < 3 || !isFinite || !std::isfinite(floorM) || !std::isfinite(ceilingM) ||
        !(ceilingM > floorM)) {
        throw Error(ErrorKind::InvalidInput, "A room needs an outline of at least three corners, and a "
                                             "ceiling above its floor.");
    }
}

double inverseDistance(const RoomShape& room, const Eigen::Vector3d& pInRoom,
                       const Eigen::Vector3d& direction) {
    const double height = direction.z() < 0 ? room.floorM - pInRoom.z() : room.ceilingM - pInRoom.z();
    double greatest = std::abs(height) > 1e-9 ? std::max(0.0, direction.z() / height) : 0;
    for (std::size_t i = 0; i < room.outline.size(); ++i) {
        const Eigen::Vector2d a = room.outline[i] - pInRoom.head<2>();
        const Eigen::Vector2d wall = room.outline[(i + 1) % room.outline.size()] - room.outline[i];
        const double across = direction.x() * wall.y() - direction.y() * wall.x();
        const double along = a.x() * direction.y() - a.y() * direction.x(); // times across
        const double reach = a.x() * wall.y() - a.y() * wall.x();
        const double share = across != 0 ? along / across : -1;
        if (share >= 0 && share <= 1 && std::abs(reach) > 1e-9 && across / reach > 0) {
            greatest = std::max(greatest, across / reach);
        }
    }
    return greatest / direction.norm();
}

DepthMap roomDepth(const RoomShape& room, const Rigid3& roomFromPhoto, int width) {
    room.validate();
    const EquirectSize size{width, width / 2};
    Image<float, 1> inverse(size.width, size.height);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const Eigen::Vector3d ray = roomFromPhoto.rotation * direction(size, Eigen::Vector2d(x, y));
            *inverse.at(x, y) = static_cast<float>(inverseDistance(room, roomFromPhoto.translation, ray));
        }
    }
    return DepthMap(std::move(inverse));
}

} // namespace spherewalk::render
