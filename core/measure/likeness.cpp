// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/measure/likeness.h"

#include "spherewalk/base/error.h"

#include <opencv2/imgproc.hpp>

namespace spherewalk::measure {

namespace {

cv::Mat brightness(const RgbImage& picture) {
    const cv::Mat rgb(picture.height(), picture.width(), CV_8UC3,
                      const_cast<std::uint8_t*>(picture.values().data()));
    cv::Mat grey;
    cv::cvtColor(rgb, grey, cv::COLOR_RGB2GRAY);
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

double structuralSimilarity(const RgbImage& a, const RgbImage& b) {
    if (a.width() != b.width() || a.height() != b.height() || a.empty()) {
        throw Error(ErrorKind::InvalidInput, "Pictures of different sizes cannot be compared.");
    }
    try {
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
    } catch (const cv::Exception& error) {
        throw Error(ErrorKind::Internal,
                    "Could not compare pictures: OpenCV refused them; please report this.", error.what());
    }
}

} // namespace spherewalk::measure
