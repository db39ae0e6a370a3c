// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/opencv_picture.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/photo/picture_file.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace spherewalk::photo {

namespace {

constexpr int kMaxSide = 65535;
constexpr int kGap = 4;
constexpr int kCaptionHeight = 18;
constexpr std::uint8_t kBackground = 40;

void writeCaption(RgbImage& sheet, const std::string& caption, int left, int bottom, int width) {
    cv::Mat pixels = matOver(sheet);
    cv::Mat cell = pixels(cv::Rect(left, bottom - kCaptionHeight, width, kCaptionHeight));
    cv::putText(cell, caption, {2, kCaptionHeight - 5}, cv::FONT_HERSHEY_SIMPLEX, 0.4, {230, 230, 230}, 1,
                cv::LINE_AA);
}

void checkSheet(std::span<const RgbImage> pictures, int columns, int cellWidth,
                std::span<const std::string> captions) {
    if (pictures.empty() || std::ranges::any_of(pictures, &RgbImage::empty) || columns < 1 || cellWidth < 1 ||
        (!captions.empty() && captions.size() != pictures.size())) {
        throw Error(
            ErrorKind::InvalidInput,
            text("A contact sheet needs pictures, columns and a width, and as many captions as pictures: ",
                 pictures.size(), " pictures, ", columns, " columns of ", cellWidth, " pixels and ",
                 captions.size(), " captions were given."));
    }
}

int scaledHeight(const RgbImage& picture, int width) {
    const double height = static_cast<double>(picture.height()) * width / picture.width();
    return std::max(1, static_cast<int>(std::lround(height)));
}

void copyInto(const RgbImage& from, RgbImage& to, int left, int top) {
    for (int y = 0; y < from.height(); ++y) {
        std::ranges::copy(from.row(y), to.at(left, top + y));
    }
}

void checkSameSize(const RgbImage& a, const RgbImage& b) {
    if (a.empty() || a.width() != b.width() || a.height() != b.height()) {
        throw Error(ErrorKind::InvalidInput,
                    text("Pictures of ", a.width(), " x ", a.height(), " and ", b.width(), " x ", b.height(),
                         " pixels cannot be compared: they must be of one size."));
    }
}

} // namespace

RgbImage resized(const RgbImage& picture, int width, int height) {
    if (picture.empty() || width < 1 || height < 1 || width > kMaxSide || height > kMaxSide) {
        throw Error(ErrorKind::InvalidInput, text("A picture of ", picture.width(), " x ", picture.height(),
                                                  " pixels cannot be made ", width, " x ", height, "."));
    }
    return translated("resize a picture", [&] {
        RgbImage result(width, height);
        cv::Mat pixels = matOver(result);
        cv::resize(matOver(picture), pixels, pixels.size(), 0, 0, cv::INTER_AREA);
        return result;
    });
}

RgbImage contactSheet(std::span<const RgbImage> pictures, int columns, int cellWidth,
                      std::span<const std::string> captions) {
    checkSheet(pictures, columns, cellWidth, captions);
    const int captionHeight = captions.empty() ? 0 : kCaptionHeight;
    int cellHeight = 0;
    for (const RgbImage& picture : pictures) {
        cellHeight = std::max(cellHeight, scaledHeight(picture, cellWidth));
    }
    cellHeight += captionHeight;
    const auto used =
        static_cast<std::int64_t>(std::min<std::size_t>(pictures.size(), static_cast<std::size_t>(columns)));
    const std::int64_t rows = (static_cast<std::int64_t>(pictures.size()) + columns - 1) / columns;
    const std::int64_t width = used * (std::int64_t{cellWidth} + kGap) + kGap;
    const std::int64_t height = rows * (std::int64_t{cellHeight} + kGap) + kGap;
    if (width > kMaxSide || height > kMaxSide) {
        throw Error(ErrorKind::InvalidInput, text("A contact sheet of ", width, " x ", height,
                                                  " pixels is too large; use smaller cells."));
    }
    RgbImage sheet(static_cast<int>(width), static_cast<int>(height));
    std::ranges::fill(sheet.values(), kBackground);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const int left = kGap + static_cast<int>(i % static_cast<std::size_t>(columns)) * (cellWidth + kGap);
        const int top = kGap + static_cast<int>(i / static_cast<std::size_t>(columns)) * (cellHeight + kGap);
        copyInto(resized(pictures[i], cellWidth, scaledHeight(pictures[i], cellWidth)), sheet, left, top);
        if (!captions.empty()) {
            translated("write a caption",
                       [&] { writeCaption(sheet, captions[i], left, top + cellHeight, cellWidth); });
        }
    }
    return sheet;
}

double psnr(const RgbImage& a, const RgbImage& b) {
    checkSameSize(a, b);
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < a.values().size(); ++i) {
        const int difference = a.values()[i] - b.values()[i];
        sum += static_cast<std::uint64_t>(difference * difference);
    }
    if (sum == 0) {
        return std::numeric_limits<double>::infinity();
    }
    const double mean = static_cast<double>(sum) / static_cast<double>(a.values().size());
    return 10 * std::log10(255.0 * 255.0 / mean);
}

} // namespace spherewalk::photo
