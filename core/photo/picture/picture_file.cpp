// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/photo/picture_file.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>
#include <spng.h>
#include <utility>

namespace spherewalk::photo {

namespace {

using namespace std::string_view_literals;

constexpr std::uint64_t kMostPictureBytes = 1ULL << 30;
constexpr std::uint64_t kMostPicturePixels = 1ULL << 28;
constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR"sv;

std::uint64_t bigEndian(ByteView bytes) {
    return std::uint64_t{bytes[0]} << 24 | bytes[1] << 16 | bytes[2] << 8 | bytes[3];
}

void checkPngSize(ByteView png, const std::string& name) {
    const ByteView size = png.subspan(kPngSignature.size());
    const std::uint64_t width = size.size() < 8 ? 0 : bigEndian(size);
    const std::uint64_t height = size.size() < 8 ? 0 : bigEndian(size.subspan(4));
    // Deflate packs at most 1032 to 1, and a pixel is a bit at least.
    constexpr std::uint64_t kMostPixelsPerByte = 1032 * 8;
    if (width == 0 || height == 0 || width > UINT32_MAX / 2 || height > UINT32_MAX / 2 ||
        width * height > png.size() * kMostPixelsPerByte) {
        throw Error(ErrorKind::Corrupt,
                    text("Could not read ", name, ": the PNG is damaged, copy it again."));
    }
    if (width * height > kMostPicturePixels) {
        throw Error(ErrorKind::Unsupported, text("Could not read ", name, ": it has ", width, " x ", height,
                                                 " pixels, more than this version takes; reduce it."));
    }
}

struct FreeContext {
    void operator()(spng_ctx* context) const { spng_ctx_free(context); }
};

using PngContext = std::unique_ptr<spng_ctx, FreeContext>;

/// flags: of spng_ctx_new().
PngContext pngContext(int flags) {
    PngContext context(spng_ctx_new(flags));
    if (!context) {
        throw std::bad_alloc();
    }
    return context;
}

/// Throws Error{Corrupt} if libspng reports an error.
void checkDecoded(int status, const std::string& name) {
    if (status != SPNG_OK) {
        throw Error(ErrorKind::Corrupt, text("Could not read ", name, ": the PNG is damaged, copy it again."),
                    spng_strerror(status));
    }
}

/// A decoder of the file and what its header says.
struct PngReader {
    PngContext context = pngContext(0);
    spng_ihdr header{};

    /// Throws Error{Corrupt, Unsupported}. Owner: the bytes must outlive the reader.
    PngReader(ByteView png, const std::string& name) {
        checkPngSize(png, name);
        // What the picture does not need may be damaged.
        spng_set_crc_action(context.get(), SPNG_CRC_ERROR, SPNG_CRC_DISCARD);
        checkDecoded(spng_set_png_buffer(context.get(), png.data(), png.size()), name);
        checkDecoded(spng_get_ihdr(context.get(), &header), name);
    }

    /// The pixels in one of libspng's formats. Alpha is left out, and so is any correction of gamma.
    template <class T, int kChannels>
    Image<T, kChannels> decode(spng_format format, const std::string& name) {
        Image<T, kChannels> picture(static_cast<int>(header.width), static_cast<int>(header.height));
        const std::span<T> values = picture.values();
        checkDecoded(spng_decode_image(context.get(), values.data(), values.size_bytes(), format, 0), name);
        checkDecoded(spng_decode_chunks(context.get()), name); // to the end
        return picture;
    }
};

RgbImage decodePng(const Bytes& png, const std::string& name) {
    return PngReader(png, name).decode<std::uint8_t, 3>(SPNG_FMT_RGB8, name);
}

Image<std::uint16_t, 1> decodePng16(const Bytes& png, const std::string& name) {
    PngReader reader(png, name);
    if (reader.header.bit_depth != 16 || reader.header.color_type != SPNG_COLOR_TYPE_GRAYSCALE) {
        throw Error(ErrorKind::Unsupported,
                    text("Could not read ", name, ": it is no PNG with one channel of 16 bits."));
    }
    return reader.decode<std::uint16_t, 1>(SPNG_FMT_PNG, name);
}

} // namespace

Image<std::uint16_t, 1> readPng16(const std::filesystem::path& file) {
    const Bytes bytes = readFile(file, kMostPictureBytes);
    return decodePng16(bytes, file.string());
}

DepthImage readDepthPng(const std::filesystem::path& file) {
    const Image<std::uint16_t, 1> millimetres = readPng16(file);
    DepthImage depth(millimetres.width(), millimetres.height());
    std::transform(
        millimetres.values().begin(), millimetres.values().end(), depth.values().begin(),
        [](std::uint16_t value) { return value == 0 ? HUGE_VALF : static_cast<float>(value) / 1000; });
    return depth;
}

RgbImage readPicture(const std::filesystem::path& file) {
    const Bytes bytes = readFile(file, kMostPictureBytes);
    const std::string name = file.string();
    if (textOf(bytes).starts_with(kPngSignature)) {
        return decodePng(bytes, name);
    }
    if (textOf(bytes).starts_with("\xFF\xD8"sv)) {
        return jpeg::decode(bytes, name);
    }
    throw Error(ErrorKind::Unsupported, text("Could not read ", name, ": it is neither a PNG nor a JPEG."));
}

namespace {

/// Throws Error{Internal} if libspng reports an error.
void checkEncoded(int status, const std::filesystem::path& file) {
    if (status != SPNG_OK) {
        throw Error(ErrorKind::Internal,
                    text("Could not write ", file.string(), ": libspng refused it; please report this."),
                    spng_strerror(status));
    }
}

template <class T, int kChannels>
void writePngOf(const std::filesystem::path& file, const Image<T, kChannels>& picture,
                spng_color_type colours) {
    if (picture.empty()) {
        throw Error(ErrorKind::InvalidInput,
                    text("Could not write ", file.string(), ": the picture is empty."));
    }
    const PngContext context = pngContext(SPNG_CTX_ENCODER);
    spng_ihdr header{};
    header.width = static_cast<std::uint32_t>(picture.width());
    header.height = static_cast<std::uint32_t>(picture.height());
    header.bit_depth = 8 * sizeof(T);
    header.color_type = colours;
    checkEncoded(spng_set_ihdr(context.get(), &header), file);
    // zlib's fastest level, and its strategy for runs: smaller files take several times as long.
    constexpr int kBestSpeed = 1;
    constexpr int kRunLength = 3;
    for (const auto& [option, value] :
         {std::pair(SPNG_ENCODE_TO_BUFFER, 1), std::pair(SPNG_IMG_COMPRESSION_LEVEL, kBestSpeed),
          std::pair(SPNG_IMG_COMPRESSION_STRATEGY, kRunLength),
          std::pair(SPNG_FILTER_CHOICE, static_cast<int>(SPNG_FILTER_CHOICE_SUB))}) {
        checkEncoded(spng_set_option(context.get(), option, value), file);
    }
    const std::span<const T> values = picture.values();
    checkEncoded(spng_encode_image(context.get(), values.data(), values.size_bytes(), SPNG_FMT_PNG,
                                   SPNG_ENCODE_FINALIZE),
                 file);
    std::size_t size = 0;
    int status = SPNG_OK;
    const std::unique_ptr<void, decltype(&std::free)> png(spng_get_png_buffer(context.get(), &size, &status),
                                                          std::free);
    checkEncoded(status, file);
    writeFile(file, ByteView(static_cast<const std::uint8_t*>(png.get()), size));
}

} // namespace

void writePng(const std::filesystem::path& file, const RgbImage& picture) {
    writePngOf(file, picture, SPNG_COLOR_TYPE_TRUECOLOR);
}

void writePng(const std::filesystem::path& file, const Image<std::uint16_t, 1>& picture) {
    writePngOf(file, picture, SPNG_COLOR_TYPE_GRAYSCALE);
}

} // namespace spherewalk::photo
