// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/jpeg/region.h"

#include "codec.h"
#include "intervals.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <utility>

namespace spherewalk::jpeg {

namespace {

// Chroma upsampling looks at one chroma sample to each side: two pixels at most.
constexpr int kUpsamplingReach = 2;
// libjpeg upsamples pictures of one or two chroma samples in another way; a part must not become so narrow.
constexpr int kLeastMcus = 3;
constexpr int kRowsAtOnce = 16;

int reduced(int length, int denominator) {
    return (length + denominator - 1) / denominator;
}

/// Moves [begin, end) outwards to multiples of the unit within [0, count).
void alignOutwards(int& begin, int& end, int unit, int count) {
    begin -= begin % unit;
    end = std::min(count, (end + unit - 1) / unit * unit);
}

/// Takes a row of samples of a colour: 0 luma, 1 blue, 2 red.
using SampleSink = std::function<void(int colour, int y, const std::uint8_t* samples)>;

/// Starts decoding, exactly as decode() does, of the columns that the part needs; the column that comes out
/// first is returned. Idle columns are entropy-decoded only.
int startColumns(jpeg_decompress_struct* info, const PixelRect& part, int denominator) {
    info->out_color_space = JCS_RGB;
    info->dct_method = JDCT_ISLOW;
    info->do_fancy_upsampling = TRUE;
    info->do_block_smoothing = FALSE;
    info->scale_num = 1;
    info->scale_denom = static_cast<unsigned>(denominator);
    jpeg_start_decompress(info);
    const int whole = static_cast<int>(info->output_width);
    if (denominator > 1) {
        // jpeg_crop_scanline() of libjpeg-turbo 2.1 forgets that reducing may leave chroma at another scale
        // (4 x 2 sampling at 1/2); and a reduced inverse DCT costs little.
        return 0;
    }
    // libjpeg upsamples pictures of one or two chroma samples in another way; more stay more.
    constexpr int kLeast = 4 * DCTSIZE;
    int left = std::max(0, part.x - kUpsamplingReach);
    const int right = std::min(whole, std::max(part.x + part.width + kUpsamplingReach, left + kLeast));
    left = std::max(0, std::min(left, right - kLeast));
    if (left > 0 || right < whole) {
        auto offset = static_cast<JDIMENSION>(left);
        auto width = static_cast<JDIMENSION>(right - left);
        jpeg_crop_scanline(info, &offset, &width);
        return static_cast<int>(offset);
    }
    return 0;
}

void startSamples(jpeg_decompress_struct* info) {
    info->raw_data_out = TRUE;
    info->dct_method = JDCT_ISLOW;
    info->do_block_smoothing = FALSE;
    jpeg_start_decompress(info);
}

/// Room for one row of MCUs as jpeg_read_raw_data() fills it.
class SampleRows {
  public:
    explicit SampleRows(const jpeg_decompress_struct& info) {
        for (int colour = 0; colour < info.num_components; ++colour) {
            const jpeg_component_info& component = info.comp_info[colour];
            const std::size_t width = std::size_t{component.width_in_blocks} * DCTSIZE;
            const int rows = component.v_samp_factor * DCTSIZE;
            Bytes& bytes = m_bytes[static_cast<std::size_t>(colour)];
            bytes.resize(width * static_cast<std::size_t>(rows));
            for (int row = 0; row < rows; ++row) {
                m_rows[static_cast<std::size_t>(colour)][static_cast<std::size_t>(row)] =
                    &bytes[width * static_cast<std::size_t>(row)];
            }
            m_planes[static_cast<std::size_t>(colour)] = m_rows[static_cast<std::size_t>(colour)].data();
        }
    }

    JSAMPIMAGE image() { return m_planes.data(); }

  private:
    std::array<Bytes, 3> m_bytes;
    std::array<std::array<JSAMPROW, 4 * DCTSIZE>, 3> m_rows{};
    std::array<JSAMPARRAY, 3> m_planes{};
};

void giveSamples(const jpeg_decompress_struct& info, SampleRows& rows, int top, const PixelRect& part,
                 const SampleSink& sink) {
    for (int colour = 0; colour < info.num_components; ++colour) {
        const jpeg_component_info& component = info.comp_info[colour];
        const int horizontal = info.max_h_samp_factor / component.h_samp_factor;
        const int vertical = info.max_v_samp_factor / component.v_samp_factor;
        const int first = part.y / vertical;
        const int end = (part.y + part.height + vertical - 1) / vertical;
        const int at = top / vertical;
        const int last = std::min(at + component.v_samp_factor * DCTSIZE, end);
        for (int y = std::max(first, at); y < last; ++y) {
            sink(colour, y - first, rows.image()[colour][y - at] + part.x / horizontal);
        }
    }
}

/// Decodes a part of a small JPEG and gives its rows, numbered from the part's top. The part counts pixels of
/// the reduced picture. Pixels within two of an inner edge of the JPEG differ from the whole picture's.
void scanRows(ByteView jpeg, const std::string& source, const PixelRect& part, int denominator,
              const RowSink& sink) {
    Decompressor decompressor(jpeg, text("decode a part of ", source));
    jpeg_decompress_struct* info = decompressor.get();
    int left = 0;
    decompressor.trap().guarded([&] { left = startColumns(info, part, denominator); });
    constexpr std::size_t kPixelBytes = 3;
    const std::size_t rowBytes = info->output_width * kPixelBytes;
    Bytes buffer(rowBytes * kRowsAtOnce);
    std::array<JSAMPROW, kRowsAtOnce> rows{};
    for (std::size_t i = 0; i < kRowsAtOnce; ++i) {
        rows[i] = &buffer[i * rowBytes];
    }
    const std::size_t skipped = static_cast<std::size_t>(part.x - left) * kPixelBytes;
    const int end = part.y + part.height;
    for (int y = 0; y < end;) {
        JDIMENSION got = 0;
        decompressor.trap().guarded([&] {
            got = jpeg_read_scanlines(info, rows.data(),
                                      static_cast<JDIMENSION>(std::min(kRowsAtOnce, end - y)));
        });
        for (JDIMENSION i = 0; i < got; ++i, ++y) {
            if (y >= part.y) {
                sink(y - part.y, rows[i] + skipped);
            }
        }
    }
}

/// Gives the samples of a part as the JPEG stores them. The part counts pixels; it has whole chroma samples,
/// except at the picture's edges.
void scanSamples(ByteView jpeg, const std::string& source, const PixelRect& part, const SampleSink& sink) {
    Decompressor decompressor(jpeg, text("decode a part of ", source));
    jpeg_decompress_struct* info = decompressor.get();
    decompressor.trap().guarded([&] { startSamples(info); });
    SampleRows rows(*info);
    const int mcuHeight = DCTSIZE * (info->num_components == 1 ? 1 : info->max_v_samp_factor);
    for (int top = 0; top < part.y + part.height; top += mcuHeight) {
        decompressor.trap().guarded(
            [&] { jpeg_read_raw_data(info, rows.image(), static_cast<JDIMENSION>(4 * DCTSIZE)); });
        giveSamples(*info, rows, top, part, sink);
    }
}

} // namespace

/// A part of a region that is decoded at once.
struct RegionDecoder::Band {
    PixelRect wanted; ///< In pixels of the picture.
    PixelRect part;   ///< The same pixels, counted from the top left of the MCUs.
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
