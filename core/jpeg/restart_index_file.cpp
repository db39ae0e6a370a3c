// SPDX-License-Identifier: Apache-2.0
#include "restart_layout.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/restart.h"

#include <algorithm>
#include <limits>

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

template <class Value>
void append(Bytes& bytes, Value value) {
    for (std::size_t i = 0; i < sizeof(Value); ++i) {
        bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    }
}

/// Takes little-endian numbers off the front of bytes that are known to be long enough.
class Reader {
  public:
    explicit Reader(ByteView bytes) : m_rest(bytes) {}

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

[[noreturn]] void fail(std::string_view source, std::string_view what) {
    throw Error(ErrorKind::Corrupt,
                text("Could not read the restart index ", source, ": ", what, "; export the dataset again."));
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
    append(bytes, kVersion);
    append(bytes, static_cast<std::uint16_t>(index.mcuWidth));
    append(bytes, static_cast<std::uint16_t>(index.mcuHeight));
    append(bytes, static_cast<std::uint32_t>(index.width));
    append(bytes, static_cast<std::uint32_t>(index.height));
    append(bytes, static_cast<std::uint32_t>(index.mcusPerInterval));
    append(bytes, index.fileSizeBytes);
    append(bytes, static_cast<std::uint32_t>(index.offsets.size()));
    for (const std::uint32_t offset : index.offsets) {
        append(bytes, offset);
    }
    return bytes;
}

RestartIndex parseRestartIndex(ByteView bytes, std::string_view source) {
    if (bytes.size() < kHeaderBytes || textOf(bytes.first(kMagic.size())) != kMagic) {
        fail(source, "it is not one");
    }
    Reader reader(bytes.subspan(kMagic.size()));
    const auto version = reader.take<std::uint16_t>();
    if (version != kVersion) {
        fail(source, text("its version is ", version, ", and this program knows version ", kVersion));
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
        fail(source, "its sizes contradict each other");
    }
    index.offsets.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        index.offsets.push_back(reader.take<std::uint32_t>());
    }
    if (!areOffsetsPlausible(index)) {
        fail(source, "its offsets do not ascend within the picture's file");
    }
    return index;
}

} // namespace spherewalk::jpeg
