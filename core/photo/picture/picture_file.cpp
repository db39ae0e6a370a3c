// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/photo/picture_file.h"

#include "picture/opencv_picture.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

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

RgbImage decodePng(const Bytes& png, const std::string& name) {
    checkPngSize(png, name);
    return translated(text("read ", name), [&] {
        const cv::Mat bgr = cv::imdecode(png, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
        if (bgr.empty()) {
            throw Error(ErrorKind::Corrupt,
                        text("Could not read ", name, ": the PNG is damaged, copy it again."));
        }
        RgbImage picture(bgr.cols, bgr.rows);
        cv::Mat rgb = matOver(picture);
        cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
        return picture;
    });
}

Image<std::uint16_t, 1> decodePng16(const Bytes& png, const std::string& name) {
    checkPngSize(png, name);
    return translated(text("read ", name), [&] {
        const cv::Mat pixels = cv::imdecode(png, cv::IMREAD_UNCHANGED);
        if (pixels.empty() || pixels.type() != CV_16UC1) {
            throw Error(ErrorKind::Unsupported,
                        text("Could not read ", name, ": it is no PNG with one channel of 16 bits."));
        }
        Image<std::uint16_t, 1> picture(pixels.cols, pixels.rows);
        std::copy(pixels.begin<std::uint16_t>(), pixels.end<std::uint16_t>(), picture.values().begin());
        return picture;
    });
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

/// pixels: as OpenCV stores them.
void writePngOf(const std::filesystem::path& file, bool isEmpty, const std::function<cv::Mat()>& pixels) {
    if (isEmpty) {
        throw Error(ErrorKind::InvalidInput,
                    text("Could not write ", file.string(), ": the picture is empty."));
    }
    const Bytes png = translated(text("write ", file.string()), [&] {
        Bytes encoded;
        cv::imencode(".png", pixels(), encoded);
        return encoded;
    });
    writeFile(file, png);
}

} // namespace

void writePng(const std::filesystem::path& file, const RgbImage& picture) {
    writePngOf(file, picture.empty(), [&] {
        cv::Mat bgr;
        cv::cvtColor(matOver(picture), bgr, cv::COLOR_RGB2BGR);
        return bgr;
    });
}

void writePng(const std::filesystem::path& file, const Image<std::uint16_t, 1>& picture) {
    writePngOf(file, picture.empty(), [&] {
        cv::Mat pixels(picture.height(), picture.width(), CV_16UC1);
        std::copy(picture.values().begin(), picture.values().end(), pixels.begin<std::uint16_t>());
        return pixels;
    });
}

} // namespace spherewalk::photo
