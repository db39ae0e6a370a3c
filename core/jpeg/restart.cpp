// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/jpeg/restart.h"

#include "codec.h"
#include "intervals.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

namespace spherewalk::jpeg {

namespace {

constexpr std::string_view kMagic = "SWRI";
constexpr std::uint16_t kVersion = 1;
// Magic, version, MCU width and height (16 bit); width, height, interval (32 bit); file size (64 bit); count.
constexpr std::size_t kHeaderBytes = 4 + 3 * 2 + 3 * 4 + 8 + 4;
// An interval has one entropy-coded byte at least, and a marker of two bytes behind it.
constexpr std::uint32_t kLeastIntervalBytes = 3;

bool isMcuSide(int side) {
    return side == 8 || side == 16 || side == 24 || side == 32;
}

/// Appends a number, the lowest byte first.
template <class Value>
void appendNumber(Bytes& bytes, Value value) {
    for (std::size_t i = 0; i < sizeof(Value); ++i) {
        bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    }
}

/// Takes little-endian numbers off the front of bytes that are known to be long enough.
class IndexReader {
  public:
    explicit IndexReader(ByteView bytes) : m_rest(bytes) {}

    template <class Value>
    Value take() {
        Value value = 0;
        for (std::size_t i = 0; i < sizeof(Value); ++i) {
            value = static_cast<Value>(value | static_cast<Value>(Value{m_rest[i]} << (8 * i)));
        }
        m_rest = m_rest.subspan(sizeof(Value));
        return value;
    }

    /// A 32-bit number as an int; one beyond its range becomes -1, which no check accepts.
    int takeInt() {
        const auto value = take<std::uint32_t>();
        return value > static_cast<std::uint32_t>(std::numeric_limits<int>::max()) ? -1
                                                                                   : static_cast<int>(value);
    }

  private:
    ByteView m_rest;
};

[[noreturn]] void failIndexFile(std::string_view source, std::string_view what) {
    throw Error(ErrorKind::Corrupt,
                text("Could not read the restart index ", source, ": ", what, "; export the dataset again."));
}

[[noreturn]] void failIndexing(ErrorKind kind, std::string_view source, std::string_view what) {
    throw Error(kind, text("Could not index the restart markers of ", source, ": ", what, "."));
}

int word(ByteView bytes, std::size_t offset) {
    return bytes[offset] << 8 | bytes[offset + 1];
}

/// Size, MCU size and component count of the frame header. Source: T.81, B.2.2.
int readFrame(ByteView content, std::string_view source, RestartIndex& index) {
    const bool isLong = content.size() >= 6;
    const int components = isLong ? content[5] : 0;
    if (!isLong || content.size() != 6 + 3 * static_cast<std::size_t>(components) || components == 0) {
        failIndexing(ErrorKind::Corrupt, source, "its frame header is damaged");
    }
    index.height = word(content, 1);
    index.width = word(content, 3);
    int horizontal = 1;
    int vertical = 1;
    for (int i = 0; i < components; ++i) {
        const int factors = content[7 + 3 * static_cast<std::size_t>(i)];
        horizontal = std::max(horizontal, factors >> 4);
        vertical = std::max(vertical, factors & 15);
    }
    index.mcuWidth = 8 * (components == 1 ? 1 : horizontal);
    index.mcuHeight = 8 * (components == 1 ? 1 : vertical);
    return components;
}

/// The next marker at or behind the position, in entropy-coded data; stuffed and fill bytes are passed over.
std::size_t nextMarker(ByteView jpeg, std::size_t position, std::string_view source) {
    while (position + 1 < jpeg.size()) {
        const void* found = std::memchr(&jpeg[position], 0xFF, jpeg.size() - 1 - position);
        if (found == nullptr) {
            break;
        }
        position = static_cast<std::size_t>(static_cast<const std::uint8_t*>(found) - jpeg.data());
        const std::uint8_t next = jpeg[position + 1];
        if (next != 0x00 && next != 0xFF) {
            return position;
        }
        position += next == 0x00 ? 2 : 1;
    }
    failIndexing(ErrorKind::Corrupt, source, "it ends within the picture");
}

void transcode(jpeg_decompress_struct* from, jpeg_compress_struct* to, int mcusPerInterval) {
    jvirt_barray_ptr* coefficients = jpeg_read_coefficients(from);
    writeCoefficients(from, coefficients, to, mcusPerInterval);
}

} // namespace

bool isPlausible(const RestartIndex& index) {
    return index.width >= 1 && index.width <= 65535 && index.height >= 1 && index.height <= 65535 &&
           isMcuSide(index.mcuWidth) && isMcuSide(index.mcuHeight) && index.mcusPerInterval >= 1 &&
           index.mcusPerInterval <= 65535;
}

std::size_t intervalCount(const RestartIndex& index) {
    const auto parts = [](int whole, int part) {
        return static_cast<std::size_t>((whole + part - 1) / part);
    };
    const std::size_t mcus = parts(index.width, index.mcuWidth) * parts(index.height, index.mcuHeight);
    const auto interval = static_cast<std::size_t>(index.mcusPerInterval);
    return (mcus + interval - 1) / interval;
}

bool areOffsetsPlausible(const RestartIndex& index) {
    std::uint64_t least = 4; // SOI and one marker at least come first
    for (const std::uint32_t offset : index.offsets) {
        if (offset < least) {
            return false;
        }
        least = std::uint64_t{offset} + kLeastIntervalBytes;
    }
    return least <= index.fileSizeBytes;
}

Bytes serialised(const RestartIndex& index) {
    if (!isPlausible(index) || index.offsets.size() != intervalCount(index) || !areOffsetsPlausible(index)) {
        throw Error(ErrorKind::InvalidInput, "A restart index that contradicts itself cannot be written.");
    }
    Bytes bytes(bytesOf(kMagic).begin(), bytesOf(kMagic).end());
    bytes.reserve(kHeaderBytes + 4 * index.offsets.size());
    appendNumber(bytes, kVersion);
    appendNumber(bytes, static_cast<std::uint16_t>(index.mcuWidth));
    appendNumber(bytes, static_cast<std::uint16_t>(index.mcuHeight));
    appendNumber(bytes, static_cast<std::uint32_t>(index.width));
    appendNumber(bytes, static_cast<std::uint32_t>(index.height));
    appendNumber(bytes, static_cast<std::uint32_t>(index.mcusPerInterval));
    appendNumber(bytes, index.fileSizeBytes);
    appendNumber(bytes, static_cast<std::uint32_t>(index.offsets.size()));
    for (const std::uint32_t offset : index.offsets) {
        appendNumber(bytes, offset);
    }
    return bytes;
}

RestartIndex parseRestartIndex(ByteView bytes, std::string_view source) {
    if (bytes.size() < kHeaderBytes || textOf(bytes.first(kMagic.size())) != kMagic) {
        failIndexFile(source, "it is not one");
    }
    IndexReader reader(bytes.subspan(kMagic.size()));
    const auto version = reader.take<std::uint16_t>();
    if (version != kVersion) {
        failIndexFile(source,
                      text("its version is ", version, ", and this program knows version ", kVersion));
    }
    RestartIndex index;
    index.mcuWidth = reader.take<std::uint16_t>();
    index.mcuHeight = reader.take<std::uint16_t>();
    index.width = reader.takeInt();
    index.height = reader.takeInt();
    index.mcusPerInterval = reader.takeInt();
    index.fileSizeBytes = reader.take<std::uint64_t>();
    const auto count = reader.take<std::uint32_t>();
    // The count is checked before anything is reserved by it.
    if (!isPlausible(index) || count != intervalCount(index) ||
        bytes.size() != kHeaderBytes + 4 * std::size_t{count}) {
        failIndexFile(source, "its sizes contradict each other");
    }
    index.offsets.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        index.offsets.push_back(reader.take<std::uint32_t>());
    }
    if (!areOffsetsPlausible(index)) {
        failIndexFile(source, "its offsets do not ascend within the picture's file");
    }
    return index;
}

RestartIndex readRestartLayout(ByteView jpeg, std::string_view source, const std::vector<Segment>& header) {
    RestartIndex index;
    index.fileSizeBytes = jpeg.size();
    int components = 0;
    for (const Segment& segment : header) {
        const ByteView content = segment.content(jpeg);
        if (segment.marker == kSof0 || segment.marker == kSof1) {
            components = readFrame(content, source, index);
        } else if (segment.marker == kDri && content.size() == 2) {
            index.mcusPerInterval = word(content, 0);
        }
    }
    if (components == 0) {
        failIndexing(ErrorKind::Unsupported, source, "it is not a baseline JPEG");
    }
    if (index.mcusPerInterval == 0) {
        failIndexing(ErrorKind::Unsupported, source, "it has none");
    }
    const ByteView scan = header.back().content(jpeg);
    if (scan.empty() || scan[0] != components) {
        failIndexing(ErrorKind::Unsupported, source, "its colours are in separate scans");
    }
    if (!isPlausible(index)) {
        failIndexing(ErrorKind::Corrupt, source, "its header is damaged");
    }
    return index;
}

RestartIndex indexRestarts(ByteView jpeg, std::string_view source) {
    if (jpeg.size() > std::numeric_limits<std::uint32_t>::max()) {
        failIndexing(ErrorKind::Unsupported, source, "it has more than 4 GB");
    }
    const std::vector<Segment> header = segments(jpeg, source);
    RestartIndex index = readRestartLayout(jpeg, source, header);
    const std::size_t intervals = intervalCount(index);
    std::size_t position = header.back().offset + header.back().size;
    index.offsets.push_back(static_cast<std::uint32_t>(position));
    for (;;) {
        position = nextMarker(jpeg, position, source);
        const std::uint8_t marker = jpeg[position + 1];
        if (marker == kEoi) {
            break;
        }
        if (marker < kRst0 || marker > kRst7) {
            failIndexing(ErrorKind::Unsupported, source,
                         text("there is more than one scan, or a foreign marker at byte ", position));
        }
        if (marker != kRst0 + (index.offsets.size() - 1) % 8 || index.offsets.size() == intervals) {
            failIndexing(ErrorKind::Corrupt, source,
                         text("the restart marker at byte ", position, " is out of order"));
        }
        position += 2;
        index.offsets.push_back(static_cast<std::uint32_t>(position));
    }
    if (index.offsets.size() != intervals) {
        failIndexing(ErrorKind::Corrupt, source,
                     text("there are ", index.offsets.size(), " intervals instead of ", intervals));
    }
    if (!areOffsetsPlausible(index)) {
        failIndexing(ErrorKind::Corrupt, source, "some of its restart intervals are empty");
    }
    return index;
}

Bytes withRestartMarkers(ByteView jpeg, int mcusPerInterval, std::string_view source) {
    if (mcusPerInterval < 1 || mcusPerInterval > 65535) {
        throw Error(
            ErrorKind::InvalidInput,
            text("Restart markers can stand every 1 to 65535 MCUs, not every ", mcusPerInterval, "."));
    }
    const std::string tried = text("add restart markers to ", source);
    Decompressor decompressor(jpeg, tried, Decompressor::Keep::AllMarkers);
    Compressor compressor(tried);
    // Both report into one trap: a jump has one place to land in.
    compressor.get()->err = decompressor.trap().manager();
    compressor.get()->client_data = &decompressor.trap();
    decompressor.trap().guarded([&] { transcode(decompressor.get(), compressor.get(), mcusPerInterval); });
    return std::move(compressor.bytes());
}

} // namespace spherewalk::jpeg
