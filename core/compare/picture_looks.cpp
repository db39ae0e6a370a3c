// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/compare/picture_looks.h"

#include "grey_picture.h"

namespace spherewalk::compare {

namespace {

constexpr int kWindow = 11; ///< pixels
constexpr double kWindowSigma = 1.5;
constexpr int kEdgeMargin = 4; ///< pixels that blur and slope reach
constexpr double kEdgeBlurPx = 1;
constexpr double kWeakEdge = 40;
constexpr double kStrongEdge = 120;
constexpr double kSamePlacePx = 2;

/// 255 where the pixel counts: every pixel within `reach` of it is valid.
cv::Mat countedPixels(const MaskImage& valid, const RgbImage& picture, int reach) {
    if (valid.empty()) {
        return {picture.height(), picture.width(), CV_8UC1, cv::Scalar(255)};
    }
    if (valid.width() != picture.width() || valid.height() != picture.height()) {
        throw Error(ErrorKind::InvalidInput, text("A mask of ", valid.width(), " x ", valid.height(),
                                                  " pixels cannot be that of a picture of ", picture.width(),
                                                  " x ", picture.height(), ": they must be of one size."));
    }
    const cv::Mat mask(valid.height(), valid.width(), CV_8UC1,
                       const_cast<std::uint8_t*>(valid.values().data()));
    cv::Mat counted;
    cv::erode(mask != 0, counted, cv::Mat::ones(2 * reach + 1, 2 * reach + 1, CV_8U));
    return counted;
}

cv::Mat windowMean(const cv::Mat& values) {
    cv::Mat result;
    cv::GaussianBlur(values, result, {kWindow, kWindow}, kWindowSigma);
    return result;
}

cv::Mat brightness(const RgbImage& picture) {
    cv::Mat result;
    greyPicture(picture).convertTo(result, CV_32F);
    return result;
}

cv::Mat edgesOf(const RgbImage& picture) {
    cv::Mat blurred;
    cv::GaussianBlur(greyPicture(picture), blurred, {0, 0}, kEdgeBlurPx);
    cv::Mat edges;
    cv::Canny(blurred, edges, kWeakEdge, kStrongEdge);
    return edges;
}

/// The share of these pixels that have no edge nearby.
double lonelyShare(const cv::Mat& pixels, const cv::Mat& edges) {
    const int count = cv::countNonZero(pixels);
    if (count == 0) {
        return 0;
    }
    cv::Mat distance; // to the nearest edge; OpenCV says a large number where there is none
    cv::distanceTransform(edges == 0, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    return cv::countNonZero(pixels & (distance > kSamePlacePx)) / static_cast<double>(count);
}

} // namespace

std::optional<double> structuralSimilarity(const RgbImage& a, const RgbImage& b, const MaskImage& valid) {
    requireOneSize(a, b);
    return withOpenCv([&]() -> std::optional<double> {
        const cv::Mat counted = countedPixels(valid, a, kWindow / 2);
        if (cv::countNonZero(counted) == 0) {
            return std::nullopt;
        }
        const cv::Mat x = brightness(a);
        const cv::Mat y = brightness(b);
        const cv::Mat meanX = windowMean(x);
        const cv::Mat meanY = windowMean(y);
        const cv::Mat varianceX = windowMean(x.mul(x)) - meanX.mul(meanX);
        const cv::Mat varianceY = windowMean(y.mul(y)) - meanY.mul(meanY);
        const cv::Mat covariance = windowMean(x.mul(y)) - meanX.mul(meanY);
        constexpr double kMean = 0.01 * 255 * 0.01 * 255;
        constexpr double kVariance = 0.03 * 255 * 0.03 * 255;
        const cv::Mat top = (2 * meanX.mul(meanY) + kMean).mul(2 * covariance + kVariance);
        const cv::Mat bottom =
            (meanX.mul(meanX) + meanY.mul(meanY) + kMean).mul(varianceX + varianceY + kVariance);
        return cv::mean(top / bottom, counted)[0];
    });
}

EdgeAgreement edgeAgreement(const RgbImage& truth, const RgbImage& view, const MaskImage& valid) {
    requireOneSize(truth, view);
    return withOpenCv([&] {
        const cv::Mat counted = countedPixels(valid, truth, kEdgeMargin);
        const cv::Mat ofTruth = edgesOf(truth);
        const cv::Mat ofView = edgesOf(view);
        const cv::Mat countedOfTruth = ofTruth & counted;
        const cv::Mat countedOfView = ofView & counted;
        return EdgeAgreement{lonelyShare(countedOfView, ofTruth), lonelyShare(countedOfTruth, ofView),
                             static_cast<std::size_t>(cv::countNonZero(countedOfView)),
                             static_cast<std::size_t>(cv::countNonZero(countedOfTruth))};
    });
}

} // namespace spherewalk::compare
