// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/jpeg/region.h"

#include "region_band.h"
#include "region_scan.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <utility>

namespace spherewalk::jpeg {

namespace {

// Chroma upsampling looks at one chroma sample to each side: two pixels at most.
constexpr int kUpsamplingReach = 2;
// libjpeg upsamples pictures of one or two chroma samples in another way; a part must not become so narrow.
constexpr int kLeastMcus = 3;

int reduced(int length, int denominator) {
    return (length + denominator - 1) / denominator;
}

/// Moves [begin, end) outwards to multiples of the unit within [0, count).
void alignOutwards(int& begin, int& end, int unit, int count) {
    begin -= begin % unit;
    end = std::min(count, (end + unit - 1) / unit * unit);
}

} // namespace

/// A part of a region that is decoded at once.
struct RegionDecoder::Band {
    PixelRect wanted; ///< of the picture
    PixelRect part;   ///< the same, seen from the MCUs' top left
    McuRect mcus;
};

RegionDecoder::RegionDecoder(std::shared_ptr<const ByteSource> source, RestartIndex index)
    : m_source(std::move(source)), m_index(std::move(index)), m_header(decodingHeader(*m_source, m_index)) {
}

int RegionDecoder::width(int denominator) const {
    return reduced(m_index.width, denominator);
}

int RegionDecoder::height(int denominator) const {
    return reduced(m_index.height, denominator);
}

void RegionDecoder::check(const PixelRect& region, int denominator) const {
    if (denominator != 1 && denominator != 2 && denominator != 4 && denominator != 8) {
        throw Error(ErrorKind::InvalidInput,
                    text("A JPEG can be reduced by 1, 2, 4 or 8 while decoding, not by ", denominator, "."));
    }
    if (region.x < 0 || region.y < 0 || region.width < 1 || region.height < 1 ||
        region.width > width(denominator) - region.x || region.height > height(denominator) - region.y) {
        throw Error(ErrorKind::InvalidInput,
                    text("The region of ", region.width, " x ", region.height, " pixels at ", region.x, ", ",
                         region.y, " is not within the ", width(denominator), " x ", height(denominator),
                         " pixels of ", m_source->name(), "."));
    }
}

RegionDecoder::Band RegionDecoder::bandAround(PixelRect wanted, int denominator, int reach) const {
    const UnitGrid grid(m_index);
    const int mcuWidth = m_index.mcuWidth / denominator;
    const int mcuHeight = m_index.mcuHeight / denominator;
    int left = std::max(0, wanted.x - reach) / mcuWidth;
    int right = std::min(grid.mcuColumns, (wanted.x + wanted.width + reach + mcuWidth - 1) / mcuWidth);
    int top = std::max(0, wanted.y - reach) / mcuHeight;
    int bottom = std::min(grid.mcuRows, (wanted.y + wanted.height + reach + mcuHeight - 1) / mcuHeight);
    right = std::min(grid.mcuColumns, std::max(right, left + kLeastMcus));
    left = std::max(0, std::min(left, right - kLeastMcus));
    alignOutwards(left, right, grid.unitColumns, grid.mcuColumns);
    alignOutwards(top, bottom, grid.unitRows, grid.mcuRows);
    return {wanted,
            {wanted.x - left * mcuWidth, wanted.y - top * mcuHeight, wanted.width, wanted.height},
            {left, top, right - left, bottom - top}};
}

void RegionDecoder::forEachBand(const PixelRect& region, const RegionOptions& options, int reach,
                                const std::function<void(const Band&)>& body) const {
    const int unit = m_index.mcuHeight * UnitGrid(m_index).unitRows / options.denominator;
    const int threads = options.threads > 0 ? options.threads : hardwareThreads();
    const int first = region.y / unit;
    const int units = (region.y + region.height + unit - 1) / unit - first;
    // One band a thread: each band decodes its neighbouring rows once more.
    const int grain = (units + threads - 1) / threads;
    parallelFor(units, grain, threads, [&](int begin, int end) {
        throwIfStopped(options.stop);
        const int top = std::max(region.y, (first + begin) * unit);
        const int bottom = std::min(region.y + region.height, (first + end) * unit);
        body(bandAround({region.x, top, region.width, bottom - top}, options.denominator, reach));
    });
}

RegionCost RegionDecoder::decode(const PixelRect& region, const RegionOptions& options,
                                 const RowSink& sink) const {
    check(region, options.denominator);
    std::atomic<std::uint64_t> intervals{0};
    std::atomic<std::uint64_t> bytesRead{0};
    forEachBand(region, options, kUpsamplingReach, [&](const Band& band) {
        RegionCost cost;
        const Bytes jpeg = bandJpeg(*m_source, m_index, m_header, band.mcus, cost);
        scanRows(jpeg, m_source->name(), band.part, options.denominator,
                 [&](int y, const std::uint8_t* pixels) { sink(band.wanted.y + y, pixels); });
        intervals += cost.intervals;
        bytesRead += cost.bytesRead;
    });
    return {intervals, bytesRead};
}

RgbImage RegionDecoder::decode(const PixelRect& region, const RegionOptions& options) const {
    check(region, options.denominator);
    RgbImage picture(region.width, region.height);
    decode(region, options, [&](int y, const std::uint8_t* pixels) {
        std::memcpy(picture.at(0, y - region.y), pixels, picture.row(0).size());
    });
    return picture;
}

Planes RegionDecoder::decodePlanes(const PixelRect& region, int threads) const {
    check(region, 1);
    Planes planes;
    const bool isGrey = colourSampling(m_header, planes.horizontal, planes.vertical, m_source->name());
    const int left = region.x - region.x % planes.horizontal;
    const int top = region.y - region.y % planes.vertical;
    const PixelRect whole{
        left, top,
        std::min(reduced(region.x + region.width, planes.horizontal) * planes.horizontal, m_index.width) -
            left,
        std::min(reduced(region.y + region.height, planes.vertical) * planes.vertical, m_index.height) - top};
    planes.luma = Planes::Plane(whole.width, whole.height);
    if (!isGrey) {
        planes.blue =
            Planes::Plane(reduced(whole.width, planes.horizontal), reduced(whole.height, planes.vertical));
        planes.red = planes.blue;
    }
    RegionOptions options;
    options.threads = threads;
    forEachBand(whole, options, 0, [&](const Band& band) {
        RegionCost cost;
        const Bytes jpeg = bandJpeg(*m_source, m_index, m_header, band.mcus, cost);
        scanSamples(jpeg, m_source->name(), band.part, [&](int colour, int y, const std::uint8_t* samples) {
            Planes::Plane& plane = colour == 0 ? planes.luma : colour == 1 ? planes.blue : planes.red;
            const int row = (band.wanted.y - top) / (colour == 0 ? 1 : planes.vertical) + y;
            std::memcpy(plane.at(0, row), samples, plane.row(0).size());
        });
    });
    return planes;
}

int dividingInterval(int width, int mcuWidth, int wanted) {
    const int columns = (width + mcuWidth - 1) / mcuWidth;
    for (int step = 0; step <= wanted; ++step) {
        for (const int interval : {wanted - step, wanted + step}) {
            if (2 * interval >= wanted && interval >= 1 && columns % interval == 0) {
                return interval;
            }
        }
    }
    return columns;
}

} // namespace spherewalk::jpeg
