// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/file.h"
#include "spherewalk/base/image.h"
#include "spherewalk/jpeg/restart.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>

namespace spherewalk::jpeg {

/// A rectangle of pixels; (x, y) is its top left one.
struct PixelRect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    bool operator==(const PixelRect&) const = default;
};

struct RegionOptions {
    int denominator = 1; ///< 1, 2, 4 or 8. Rectangles count pixels of the reduced picture.
    int threads = 1;     ///< 0 means all of the machine. The pixels do not depend on it.
    std::stop_token stop;
};

/// Takes one row of a region: `y` counts from the picture's top, and `pixels` holds region.width RGB pixels.
/// Threads: several threads call at the same time, with different rows.
using RowSink = std::function<void(int y, const std::uint8_t* pixels)>;

/// The restart intervals that were decoded for a region, and the bytes that were read.
struct RegionCost {
    std::uint64_t intervals = 0;
    std::uint64_t bytesRead = 0;
};

/// The samples that the JPEG stores, before chroma upsampling and colour conversion.
struct Planes {
    using Plane = Image<std::uint8_t, 1>;
    Plane luma;
    Plane blue; ///< Empty for grey pictures, as is red.
    Plane red;
    int horizontal = 1; ///< Luma samples for each chroma sample.
    int vertical = 1;
};

/// Decodes parts of a JPEG with restart markers. It reads and decodes only the restart intervals that a part
/// touches. Every pixel equals that of decode() of the whole picture, because neighbours that chroma
/// upsampling needs are decoded too.
/// Cost: that of the touched intervals. It is least where the interval divides the MCUs of a row, see
/// dividingInterval(). Otherwise whole rows are decoded, between rows at which an interval begins.
/// Threads: any number may share one.
class RegionDecoder {
  public:
    /// Errors: Corrupt if the picture's header and the index contradict each other; Unsupported for pictures
    /// without restart markers; those of the source.
    RegionDecoder(std::shared_ptr<const ByteSource> source, RestartIndex index);

    const RestartIndex& index() const { return m_index; }

    /// The size of the picture, reduced by the denominator.
    int width(int denominator = 1) const;
    int height(int denominator = 1) const;

    /// Decodes a region and gives its rows to the sink, in any order; rows may come before an error.
    /// Errors: InvalidInput for a rectangle that is empty or leaves the picture; Corrupt for damaged
    /// intervals; Stopped; those of the source and the sink.
    RegionCost decode(const PixelRect& region, const RegionOptions& options, const RowSink& sink) const;

    /// The region as a picture. Errors: those of the other decode(), without the sink's.
    RgbImage decode(const PixelRect& region, const RegionOptions& options = {}) const;

    /// The samples of the region, widened to whole chroma samples. Errors: those of decode(); Unsupported
    /// where a chroma channel has more than one block in an MCU.
    Planes decodePlanes(const PixelRect& region, int threads = 1) const;

  private:
    struct Band;

    void check(const PixelRect& region, int denominator) const;
    Band bandAround(PixelRect wanted, int denominator, int reach) const;
    void forEachBand(const PixelRect& region, const RegionOptions& options, int reach,
                     const std::function<void(const Band&)>& body) const;

    std::shared_ptr<const ByteSource> m_source;
    RestartIndex m_index;
    Bytes m_header; ///< SOI to SOS, with only the segments that decoding needs.
};

/// The restart interval with which regions are decoded at the least cost. It divides the MCUs of a row and is
/// nearest to the wanted one. If there is none between half and twice the wanted one, it is a whole row.
/// Range: width, mcuWidth and wanted >= 1.
int dividingInterval(int width, int mcuWidth, int wanted);

} // namespace spherewalk::jpeg
