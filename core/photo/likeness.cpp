// SPDX-License-Identifier: GPL-3.0-or-later
#include "opencv_picture.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/photo/picture_file.h"

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <cstdint>
#include <limits>

namespace spherewalk::photo {

namespace {

void checkSizes(const RgbImage& a, const RgbImage& b) {
    if (a.empty() || a.width() != b.width() || a.height() != b.height()) {
        throw Error(ErrorKind::InvalidInput,
                    text("Pictures of ", a.width(), " x ", a.height(), " and ", b.width(), " x ", b.height(),
                         " pixels cannot be compared: they must be of one size."));
    }
}

cv::Mat brightness(const RgbImage& picture) {
    cv::Mat grey;
    cv::cvtColor(matOver(picture), grey, cv::COLOR_RGB2GRAY);
    cv::Mat result;
    grey.convertTo(result, CV_32F);
    return result;
}

cv::Mat smoothed(const cv::Mat& values) {
    cv::Mat result;
    cv::GaussianBlur(values, result, {11, 11}, 1.5);
    return result;
}

} // namespace

double psnr(const RgbImage& a, const RgbImage& b) {
    checkSizes(a, b);
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

double structuralSimilarity(const RgbImage& a, const RgbImage& b) {
    checkSizes(a, b);
    return translated("compare pictures", [&] {
        const cv::Mat x = brightness(a);
        const cv::Mat y = brightness(b);
        const cv::Mat meanX = smoothed(x);
        const cv::Mat meanY = smoothed(y);
        const cv::Mat varianceX = smoothed(x.mul(x)) - meanX.mul(meanX);
        const cv::Mat varianceY = smoothed(y.mul(y)) - meanY.mul(meanY);
        const cv::Mat covariance = smoothed(x.mul(y)) - meanX.mul(meanY);
        constexpr double kMean = 0.01 * 255 * 0.01 * 255;
        constexpr double kVariance = 0.03 * 255 * 0.03 * 255;
        const cv::Mat top = (2 * meanX.mul(meanY) + kMean).mul(2 * covariance + kVariance);
        const cv::Mat bottom =
            (meanX.mul(meanX) + meanY.mul(meanY) + kMean).mul(varianceX + varianceY + kVariance);
        return cv::mean(top / bottom)[0];
    });
}

} // namespace spherewalk::photo
