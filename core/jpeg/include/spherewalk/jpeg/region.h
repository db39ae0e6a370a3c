// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/byte_source.h"
#include "spherewalk/base/image.h"
#include "spherewalk/jpeg/restart.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>

namespace spherewalk::jpeg {

struct PixelRect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    bool operator==(const PixelRect&) const = default;
};

struct RegionOptions {
    int denominator = 1; ///< 1, 2, 4 or 8: the picture is reduced by it, and rectangles are of that one
    int threads = 1;     ///< 0: all that the machine has; the pixels are the same for any number
    std::stop_token stop;
};

/// Takes row y (of the picture) of the region, region.width pixels of three bytes. Threads: called from
/// several at a time, with different rows.
using RowSink = std::function<void(int y, const std::uint8_t* pixels)>;

/// What a decoded region cost.
struct RegionCost {
    std::uint64_t intervals = 0;
    std::uint64_t bytesRead = 0;
};

/// Samples as the JPEG stores them, before chroma upsampling and colour conversion.
struct Planes {
    using Plane = Image<std::uint8_t, 1>;
    Plane luma;
    Plane blue; ///< empty for grey pictures
    Plane red;
    int horizontal = 1; ///< luma samples for each chroma sample
    int vertical = 1;
};

/// Decodes parts of a JPEG with restart markers, reading only the bytes and decoding only the restart
/// intervals that they touch. Every pixel has the bytes that decode() of the whole gives it: where chroma
/// upsampling looks at a neighbour, the neighbour is decoded too.
/// Cost: that of the intervals touched; least where the interval divides a row's MCUs (see dividingInterval),
/// otherwise whole rows are decoded, from one row at which an interval begins to another.
/// Threads: const, any number.
class RegionDecoder {
  public:
    /// Errors: Corrupt if the picture's header and the index contradict each other; Unsupported for pictures
    /// without restart markers; those of the source.
    RegionDecoder(std::shared_ptr<const ByteSource> source, RestartIndex index);

    const RestartIndex& index() const { return m_index; }

    /// Of the reduced picture.
    int width(int denominator = 1) const;
    int height(int denominator = 1) const;

    /// Errors: InvalidInput for a rectangle that is empty or leaves the picture; Corrupt for intervals that
    /// do not decode; Stopped; those of the source and the sink. Rows may have been given before an error.
    RegionCost decode(const PixelRect& region, const RegionOptions& options, const RowSink& sink) const;

    /// The same as a picture.
    RgbImage decode(const PixelRect& region, const RegionOptions& options = {}) const;

    /// The region's samples, widened to whole chroma samples. Errors: as decode(); Unsupported where a chroma
    /// channel is sampled other than 1 x 1 in an MCU.
    Planes decodePlanes(const PixelRect& region, int threads = 1) const;

  private:
    struct Band;

    void check(const PixelRect& region, int denominator) const;
    Band bandAround(PixelRect wanted, int denominator, int reach) const;
    void forEachBand(const PixelRect& region, const RegionOptions& options, int reach,
                     const std::function<void(const Band&)>& body) const;

    std::shared_ptr<const ByteSource> m_source;
    RestartIndex m_index;
    Bytes m_header; ///< SOI to SOS, without what does not matter to decoding
};

/// The interval that divides a row's MCUs and is nearest to the wanted one, if there is one between half and
/// twice of it; otherwise a whole row. Export with it: regions are then decoded at the least cost.
/// Range: width, mcuWidth and wanted >= 1.
int dividingInterval(int width, int mcuWidth, int wanted);

} // namespace spherewalk::jpeg
