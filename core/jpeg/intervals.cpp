// SPDX-License-Identifier: Apache-2.0
#include "intervals.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <numeric>
#include <string_view>

namespace spherewalk::jpeg {

namespace {

constexpr std::uint64_t kLargestHeader = 32ULL << 20;
// 10 blocks of 64 coefficients of at most 26 bits each, every byte stuffed, and rounded up.
constexpr std::uint64_t kMostBytesPerMcu = 8192;

[[noreturn]] void failPart(const ByteSource& source, std::string_view what) {
    throw Error(ErrorKind::Corrupt,
                text("Could not decode a part of ", source.name(), ": ", what,
                     "; the file or its restart index is damaged, copy or export it again."));
}

bool isFrame(std::uint8_t marker) {
    return marker == kSof0 || marker == kSof1;
}

bool mattersToDecoding(std::uint8_t marker) {
    constexpr std::uint8_t kDqt = 0xDB;
    constexpr std::uint8_t kDht = 0xC4;
    constexpr std::uint8_t kAdobe = 0xEE; // says how the colours are coded, as JFIF (APP0) does
    return marker == kDqt || marker == kDht || marker == kDri || marker == kSos || marker == kApp0 ||
           marker == kAdobe || isFrame(marker);
}

void setWord(std::uint8_t* at, int value) {
    at[0] = static_cast<std::uint8_t>(value >> 8);
    at[1] = static_cast<std::uint8_t>(value);
}

/// Writes the size into the frame headers of bytes that begin with a JPEG's header.
void setSize(Bytes& jpeg, int width, int height) {
    for (const Segment& segment : segments(jpeg, "a part")) {
        if (isFrame(segment.marker)) {
            setWord(&jpeg[segment.offset + 5], height);
            setWord(&jpeg[segment.offset + 7], width);
        }
    }
}

/// Appends runs of intervals to a band, numbering their markers from RST0 on.
class Assembler {
  public:
    Assembler(const ByteSource& source, const RestartIndex& index, Bytes& out)
        : m_source(source), m_index(index), m_out(out) {}

    /// Intervals [first, end). Range: at least one.
    void append(std::size_t first, std::size_t end) {
        if (m_count > 0) {
            m_out.insert(m_out.end(), {0xFF, nextMarker()});
        }
        const std::size_t at = m_out.size();
        const std::uint64_t begin = m_index.offsets[first];
        m_out.resize(at + runBytes(first, end));
        m_source.read(begin, std::span(m_out).subspan(at));
        ++m_count;
        for (std::size_t i = first + 1; i < end; ++i) {
            renumber(&m_out[at + (m_index.offsets[i] - 2 - begin)], i);
        }
        if (end == m_index.offsets.size()) {
            cutAtEnd(at + (m_index.offsets[end - 1] - begin));
        }
    }

    std::size_t count() const { return m_count; }

  private:
    std::uint8_t nextMarker() const { return static_cast<std::uint8_t>(kRst0 + (m_count - 1) % 8); }

    std::uint64_t runBytes(std::size_t first, std::size_t end) const {
        const std::uint64_t most =
            (end - first) * static_cast<std::uint64_t>(m_index.mcusPerInterval) * kMostBytesPerMcu;
        const std::uint64_t begin = m_index.offsets[first];
        if (end == m_index.offsets.size()) {
            // Something may follow the picture's end, which is searched within what the picture can have.
            return std::min(m_index.fileSizeBytes - begin, most);
        }
        const std::uint64_t size = m_index.offsets[end] - 2 - begin;
        if (size > most) {
            failPart(m_source, text("the interval at byte ", begin, " is impossibly long"));
        }
        return size;
    }

    void renumber(std::uint8_t* marker, std::size_t interval) {
        if (marker[0] != 0xFF || marker[1] != kRst0 + (interval - 1) % 8) {
            failPart(m_source, text("no restart marker stands before byte ", m_index.offsets[interval]));
        }
        marker[1] = nextMarker();
        ++m_count;
    }

    void cutAtEnd(std::size_t from) {
        constexpr std::uint8_t kEnd[] = {0xFF, kEoi};
        const auto found = std::search(m_out.begin() + static_cast<std::ptrdiff_t>(from), m_out.end(),
                                       std::begin(kEnd), std::end(kEnd));
        if (found == m_out.end()) {
            failPart(m_source, "it ends within the picture");
        }
        m_out.erase(found, m_out.end());
    }

    const ByteSource& m_source;
    const RestartIndex& m_index;
    Bytes& m_out;
    std::size_t m_count = 0;
};

} // namespace

UnitGrid::UnitGrid(const RestartIndex& index)
    : mcuColumns((index.width + index.mcuWidth - 1) / index.mcuWidth),
      mcuRows((index.height + index.mcuHeight - 1) / index.mcuHeight) {
    const int interval = index.mcusPerInterval;
    const bool divides = mcuColumns % interval == 0;
    unitColumns = divides ? interval : mcuColumns;
    unitRows = divides ? 1 : interval / std::gcd(interval, mcuColumns);
}

Bytes decodingHeader(const ByteSource& source, const RestartIndex& index) {
    if (!isPlausible(index) || index.offsets.size() != intervalCount(index) || !areOffsetsPlausible(index) ||
        index.fileSizeBytes != source.sizeBytes() || index.offsets.front() > kLargestHeader) {
        failPart(source, "the restart index does not fit the file");
    }
    Bytes file(index.offsets.front());
    source.read(0, file);
    const std::vector<Segment> found = segments(file, source.name());
    RestartIndex stated = readRestartLayout(file, source.name(), found);
    stated.fileSizeBytes = index.fileSizeBytes;
    stated.offsets = index.offsets;
    if (stated != index || found.back().offset + found.back().size != file.size()) {
        failPart(source, "its header and its restart index contradict each other");
    }
    Bytes header{0xFF, kSoi};
    for (const Segment& segment : found) {
        if (mattersToDecoding(segment.marker)) {
            const ByteView whole = segment.whole(file);
            header.insert(header.end(), whole.begin(), whole.end());
        }
    }
    return header;
}

bool colourSampling(ByteView header, int& horizontal, int& vertical, std::string_view source) {
    for (const Segment& segment : segments(header, source)) {
        const ByteView content = segment.content(header);
        if (!isFrame(segment.marker)) {
            continue;
        }
        if (content[5] == 1) {
            return true;
        }
        horizontal = content[7] >> 4;
        vertical = content[7] & 15;
        if (content[5] != 3 || content[10] != 0x11 || content[13] != 0x11) {
            throw Error(ErrorKind::Unsupported, text("Could not decode the planes of ", source,
                                                     ": its chroma is sampled in an unusual way."));
        }
    }
    return false;
}

Bytes bandJpeg(const ByteSource& source, const RestartIndex& index, const Bytes& header, const McuRect& mcus,
               RegionCost& cost) {
    const UnitGrid grid(index);
    Bytes jpeg = header;
    setSize(jpeg, std::min(mcus.columns * index.mcuWidth, index.width - mcus.column * index.mcuWidth),
            std::min(mcus.rows * index.mcuHeight, index.height - mcus.row * index.mcuHeight));
    Assembler assembler(source, index, jpeg);
    const auto interval = static_cast<std::size_t>(index.mcusPerInterval);
    // Where the band is as wide as the picture, all of its intervals follow each other in the file.
    const int rowsAtOnce = mcus.columns == grid.mcuColumns ? mcus.rows : 1;
    for (int row = mcus.row; row < mcus.row + mcus.rows; row += rowsAtOnce) {
        const std::size_t first = static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.mcuColumns) +
                                  static_cast<std::size_t>(mcus.column);
        const std::size_t count =
            static_cast<std::size_t>(mcus.columns) * static_cast<std::size_t>(rowsAtOnce);
        assembler.append(first / interval, (first + count + interval - 1) / interval);
    }
    cost.intervals += assembler.count();
    cost.bytesRead += jpeg.size() - header.size();
    jpeg.insert(jpeg.end(), {0xFF, kEoi});
    return jpeg;
}

} // namespace spherewalk::jpeg
