// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/photo/blurred_photo.h"

#include "metadata/xmp_packet.h"

#include "spherewalk/base/error.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/jpeg/jpeg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace spherewalk::photo {

using Eigen::Vector2d;
using Eigen::Vector3d;
using survey::PrivateRegion;
using survey::RegionFrame;

namespace {

constexpr int kLeastCellPx = 8; ///< Smaller cells would keep what is there of a small region.

/// Columns of the picture, which wrap at its width.
struct Columns {
    int first = 0;
    int count = 0;
};

/// The columns that a region may reach.
Columns columnsOf(const PrivateRegion& region, const RegionFrame& frame, const EquirectSize& size) {
    const double reach = frame.reach().value();
    if (std::abs(region.elevation.value()) + reach >= std::numbers::pi / 2) { // it holds a pole
        return {0, size.width};
    }
    const double aside = std::asin(std::sin(reach) / cos(region.elevation));
    const double perRadian = size.width / (2 * std::numbers::pi);
    const double middle = pixel(size, frame.middle()).x();
    const int first = static_cast<int>(std::floor(middle - aside * perRadian)) - 1;
    const int last = static_cast<int>(std::ceil(middle + aside * perRadian)) + 1;
    return {first, std::min(last - first + 1, size.width)};
}

/// Calls use(x, y, place, weight) for each pixel within the region. weight: the pixel's share of the sphere.
template <class Use>
void forEachPixel(const PrivateRegion& region, const EquirectSize& size, const Use& use) {
    const RegionFrame frame(region);
    const Columns columns = columnsOf(region, frame, size);
    const double perRadian = size.height / std::numbers::pi;
    const double middle = pixel(size, frame.middle()).y();
    const double reach = frame.reach().value() * perRadian + 1;
    const int top = std::max(0, static_cast<int>(std::floor(middle - reach)));
    const int bottom = std::min(size.height - 1, static_cast<int>(std::ceil(middle + reach)));
    for (int y = top; y <= bottom; ++y) {
        const double weight = std::sin(std::numbers::pi * (y + 0.5) / size.height);
        for (int i = 0; i < columns.count; ++i) {
            const int x = ((columns.first + i) % size.width + size.width) % size.width;
            const auto place = frame.at(direction(size, Vector2d(x, y)));
            if (place && place->cwiseAbs().maxCoeff() <= 1) {
                use(x, y, *place, weight);
            }
        }
    }
}

/// The mean colours of a region's cells.
class Cells {
  public:
    Cells(const PrivateRegion& region, const EquirectSize& size)
        : m_columns(countFor(region.width, size)), m_rows(countFor(region.height, size)) {}

    void add(const Vector2d& place, const std::uint8_t* colour, double weight) {
        Cell& cell = at(std::min(static_cast<int>((place.x() + 1) / 2 * m_columns), m_columns - 1),
                        std::min(static_cast<int>((place.y() + 1) / 2 * m_rows), m_rows - 1));
        cell.sum += weight * Vector3d(colour[0], colour[1], colour[2]);
        cell.weight += weight;
    }

    /// Gives the cells that no pixel fell into the mean of all.
    void finish() {
        Cell all;
        for (const Cell& cell : m_cells) {
            all.sum += cell.sum;
            all.weight += cell.weight;
        }
        for (Cell& cell : m_cells) {
            cell = cell.weight > 0 ? cell : all;
        }
    }

    /// Between the middles of cells, colours run evenly.
    Vector3d colour(const Vector2d& place) const {
        const double x = std::clamp((place.x() + 1) / 2 * m_columns - 0.5, 0.0, m_columns - 1.0);
        const double y = std::clamp((place.y() + 1) / 2 * m_rows - 0.5, 0.0, m_rows - 1.0);
        const int left = std::min(static_cast<int>(x), std::max(0, m_columns - 2));
        const int low = std::min(static_cast<int>(y), std::max(0, m_rows - 2));
        const int right = std::min(left + 1, m_columns - 1);
        const int high = std::min(low + 1, m_rows - 1);
        const double u = x - left;
        const double v = y - low;
        return (1 - v) * ((1 - u) * mean(left, low) + u * mean(right, low)) +
               v * ((1 - u) * mean(left, high) + u * mean(right, high));
    }

  private:
    struct Cell {
        Vector3d sum = Vector3d::Zero();
        double weight = 0;
    };

    static int countFor(Radians side, const EquirectSize& size) {
        const double sidePx = side.value() / (2 * std::numbers::pi) * size.width;
        return std::clamp(static_cast<int>(sidePx / kLeastCellPx), 1, kBlurCells);
    }

    static std::size_t index(int column, int row) {
        return static_cast<std::size_t>(row) * kBlurCells + static_cast<std::size_t>(column);
    }

    Cell& at(int column, int row) { return m_cells[index(column, row)]; }

    Vector3d mean(int column, int row) const {
        const Cell& cell = m_cells[index(column, row)];
        return cell.sum / cell.weight;
    }

    int m_columns;
    int m_rows;
    std::array<Cell, static_cast<std::size_t>(kBlurCells) * kBlurCells> m_cells;
};

} // namespace

MaskImage blurRegions(RgbImage& picture, std::span<const PrivateRegion> regions) {
    const EquirectSize size{picture.width(), picture.height()};
    MaskImage changed(picture.width(), picture.height());
    for (const PrivateRegion& region : regions) {
        Cells cells(region, size);
        forEachPixel(region, size, [&](int x, int y, const Vector2d& place, double weight) {
            cells.add(place, picture.at(x, y), weight);
        });
        cells.finish();
        forEachPixel(region, size, [&](int x, int y, const Vector2d& place, double /*weight*/) {
            const Vector3d colour = cells.colour(place);
            for (int channel = 0; channel < RgbImage::kChannels; ++channel) {
                picture.at(x, y)[channel] = static_cast<std::uint8_t>(std::lround(colour[channel]));
            }
            *changed.at(x, y) = 255;
        });
    }
    return changed;
}

using jpeg::Segment;

namespace {

constexpr int kGreyQuality = 95;           ///< Of a grey photo, which is encoded anew.
constexpr std::size_t kLongestText = 2048; ///< A longer value of XMP may be a picture.
constexpr std::uint8_t kApp2 = 0xE2;
constexpr std::uint8_t kApp14 = 0xEE;
constexpr std::size_t kJfifWithoutThumbnail = 14;

/// The numbers of a TIFF in its own order of bytes. Reading and writing outside of it does nothing.
class Tiff {
  public:
    explicit Tiff(std::span<std::uint8_t> bytes) : m_bytes(bytes) {
        m_isLittle = bytes.size() > 1 && bytes[0] == 'I' && bytes[1] == 'I';
        m_isTiff = number(2, 2) == 42 && (m_isLittle || (bytes[0] == 'M' && bytes[1] == 'M'));
    }

    bool isTiff() const { return m_isTiff; }

    /// 0 beyond the end.
    std::uint32_t number(std::size_t at, std::size_t size) const {
        std::uint32_t value = 0;
        for (std::size_t i = 0; at + size <= m_bytes.size() && i < size; ++i) {
            value = value << 8U | m_bytes[m_isLittle ? at + size - 1 - i : at + i];
        }
        return value;
    }

    void clear(std::size_t at, std::size_t size) {
        const std::size_t first = std::min(at, m_bytes.size());
        std::ranges::fill(m_bytes.subspan(first, std::min(size, m_bytes.size() - first)), std::uint8_t(0));
    }

    /// Where the offset of the next directory stands.
    std::size_t nextOf(std::size_t directory) const { return directory + 2 + 12UL * number(directory, 2); }

  private:
    std::span<std::uint8_t> m_bytes;
    bool m_isLittle = false;
    bool m_isTiff = false;
};

/// Overwrites every JPEG within the bytes, wherever a maker note may have put it.
void clearPictures(std::span<std::uint8_t> bytes) {
    for (std::size_t i = 0; i + 2 < bytes.size(); ++i) {
        if (bytes[i] != 0xFF || bytes[i + 1] != jpeg::kSoi || bytes[i + 2] != 0xFF) {
            continue;
        }
        while (i + 1 < bytes.size() && !(bytes[i] == 0xFF && bytes[i + 1] == jpeg::kEoi)) {
            bytes[i++] = 0;
        }
        std::ranges::fill(bytes.subspan(i, std::min<std::size_t>(2, bytes.size() - i)), std::uint8_t(0));
    }
}

/// Exif without its thumbnail. Nothing moves, because the maker note knows where it stands. Nothing is
/// returned for Exif that is damaged.
std::optional<Bytes> withoutThumbnail(ByteView segment) {
    constexpr std::size_t kHeader = 4; // marker and length
    constexpr std::size_t kStrips = 0x0111;
    constexpr std::size_t kStripSizes = 0x0117;
    Bytes result(segment.begin(), segment.end());
    const std::span<std::uint8_t> all(result);
    Tiff tiff(all.subspan(kHeader + exifSignature().size()));
    if (!tiff.isTiff()) {
        return std::nullopt;
    }
    const std::size_t next = tiff.nextOf(tiff.number(4, 4));
    if (const std::size_t second = tiff.number(next, 4); second != 0) {
        std::uint32_t strips = 0;
        std::uint32_t stripBytes = 0;
        const std::size_t end = tiff.nextOf(second);
        for (std::size_t entry = second + 2; entry < end; entry += 12) {
            strips = tiff.number(entry, 2) == kStrips ? tiff.number(entry + 8, 4) : strips;
            stripBytes = tiff.number(entry, 2) == kStripSizes ? tiff.number(entry + 8, 4) : stripBytes;
        }
        tiff.clear(strips, strips == 0 ? 0 : stripBytes);
        tiff.clear(second, end + 4 - second);
        tiff.clear(next, 4);
    }
    clearPictures(all.subspan(kHeader));
    return result;
}

/// XMP without pictures. Nothing is returned for XMP that is damaged.
std::optional<Bytes> withoutPictures(ByteView segment, std::string_view source) {
    constexpr std::size_t kHeader = 4;
    const XmpSession session;
    try {
        Exiv2::XmpData xmp = session.decoded(segment.subspan(kHeader + xmpSignature().size()), source);
        Exiv2::XmpData kept;
        for (const Exiv2::Xmpdatum& datum : xmp) {
            const std::string key = datum.key();
            if (key.find("Thumbnail") == std::string::npos &&
                key.find("HasExtendedXMP") == std::string::npos && datum.toString().size() <= kLongestText) {
                kept.add(datum);
            }
        }
        if (kept.count() == xmp.count()) {
            return Bytes(segment.begin(), segment.end());
        }
        const std::string packet = session.encoded(kept);
        const std::size_t length = 2 + xmpSignature().size() + packet.size();
        Bytes result{0xFF, jpeg::kApp1, static_cast<std::uint8_t>(length >> 8U),
                     static_cast<std::uint8_t>(length)};
        for (const std::string_view part : {xmpSignature(), std::string_view(packet)}) {
            result.insert(result.end(), part.begin(), part.end());
        }
        return result;
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::Corrupt) {
            return std::nullopt;
        }
        throw;
    }
}

/// What is kept of a segment of the original's header. Nothing is kept of those that may hold a picture.
std::optional<Bytes> keptOf(const Segment& segment, ByteView jpeg, std::string_view source) {
    const ByteView whole = segment.whole(jpeg);
    const std::string_view content = textOf(segment.content(jpeg));
    if (segment.marker == jpeg::kApp1 && content.starts_with(exifSignature())) {
        return withoutThumbnail(whole);
    }
    if (segment.marker == jpeg::kApp1 && content.starts_with(xmpSignature())) {
        return withoutPictures(whole, source);
    }
    const bool isHarmless = (segment.marker == jpeg::kApp0 && content.starts_with("JFIF") &&
                             content.size() <= kJfifWithoutThumbnail) ||
                            (segment.marker == kApp2 && content.starts_with("ICC_PROFILE")) ||
                            segment.marker == kApp14;
    return isHarmless ? std::optional(Bytes(whole.begin(), whole.end())) : std::nullopt;
}

bool isOfApplication(const Segment& segment) {
    return (segment.marker >= jpeg::kApp0 && segment.marker <= jpeg::kApp15) || segment.marker == jpeg::kCom;
}

/// The picture with those segments of the original that give nothing away.
Bytes withSegments(ByteView picture, ByteView original, std::string_view source) {
    Bytes result{0xFF, jpeg::kSoi};
    const auto append = [&](ByteView bytes) { result.insert(result.end(), bytes.begin(), bytes.end()); };
    for (const Segment& segment : jpeg::segments(original, source)) {
        if (const auto kept = isOfApplication(segment) ? keptOf(segment, original, source) : std::nullopt) {
            append(*kept);
        }
    }
    const std::vector<Segment> segments = jpeg::segments(picture, source);
    for (const Segment& segment : segments) {
        if (!isOfApplication(segment)) {
            append(&segment == &segments.back() ? picture.subspan(segment.offset) : segment.whole(picture));
        }
    }
    return result;
}

} // namespace

Bytes blurredPhoto(ByteView jpeg, std::span<const survey::PrivateRegion> regions, std::string_view source) {
    if (regions.empty()) {
        return {jpeg.begin(), jpeg.end()};
    }
    for (const survey::PrivateRegion& region : regions) {
        region.validate();
    }
    RgbImage picture = jpeg::decode(jpeg, source);
    const MaskImage changed = blurRegions(picture, regions);
    const bool isGrey = jpeg::readInfo(jpeg, source).components != RgbImage::kChannels;
    const Bytes blurred =
        isGrey ? jpeg::encode(picture, kGreyQuality) : jpeg::withPixels(jpeg, picture, changed, source);
    return withSegments(blurred, jpeg, source);
}

} // namespace spherewalk::photo
