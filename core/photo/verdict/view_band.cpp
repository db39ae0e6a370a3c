// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/photo/view_band.h"

#include "picture/opencv_picture.h"

#include "spherewalk/jpeg/jpeg.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <opencv2/imgproc.hpp>

#include <cmath>

namespace spherewalk::photo {

namespace {

constexpr int kLeastWidth = 640;
constexpr int kBlock = 16;
constexpr int kLeastBlocks = 30;
constexpr double kLeastSlope = 3;   ///< Grey levels a pixel, root mean square across the block's edges.
constexpr double kMostAside = 0.25; ///< Pixels.
constexpr double kMostUnlike = 0.2; ///< Of the block's own variance.
constexpr double kLeastShare = 0.75;

enum class Block { Flat, Same, Other };

/// By one step of Lucas and Kanade (1981) from no displacement, across the block's edges: the least squares
/// of b - a against the slopes of a. Brightness counts without its mean and its scale.
Block compared(const cv::Mat& a, const cv::Mat& b, const cv::Mat& alongX, const cv::Mat& alongY) {
    cv::Scalar meanA;
    cv::Scalar meanB;
    cv::Scalar deviationA;
    cv::Scalar deviationB;
    cv::meanStdDev(a, meanA, deviationA);
    cv::meanStdDev(b, meanB, deviationB);
    const double gain = deviationB[0] > 0 ? deviationA[0] / deviationB[0] : 0;
    Eigen::Matrix2d slopes = Eigen::Matrix2d::Zero();
    Eigen::Vector2d product = Eigen::Vector2d::Zero();
    double difference2 = 0;
    for (int y = 0; y < a.rows; ++y) {
        for (int x = 0; x < a.cols; ++x) {
            const Eigen::Vector2d slope(alongX.at<float>(y, x), alongY.at<float>(y, x));
            const double difference = gain * (b.at<float>(y, x) - meanB[0]) - (a.at<float>(y, x) - meanA[0]);
            slopes += slope * slope.transpose();
            product += difference * slope;
            difference2 += difference * difference;
        }
    }
    const double pixels = a.rows * a.cols;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solved(slopes);
    const double across2 = solved.eigenvalues()[1];
    if (across2 < pixels * kLeastSlope * kLeastSlope) {
        return Block::Flat;
    }
    const bool isAside = std::abs(solved.eigenvectors().col(1).dot(product)) > kMostAside * across2;
    const bool isUnlike = difference2 > kMostUnlike * pixels * deviationA[0] * deviationA[0];
    return isAside || isUnlike ? Block::Other : Block::Same;
}

cv::Mat softened(const ViewBand& band) {
    const cv::Mat grey(band.height(), band.width(), CV_8U, const_cast<std::uint8_t*>(band.values().data()));
    cv::Mat soft;
    grey.convertTo(soft, CV_32F);
    cv::GaussianBlur(soft, soft, {3, 3}, 0);
    return soft;
}

} // namespace

ViewBand viewBand(ByteView jpeg, std::string_view source) {
    const int width = jpeg::readInfo(jpeg, source).width;
    int denominator = 1;
    while (denominator < 8 && width >= 2 * denominator * kLeastWidth) {
        denominator *= 2;
    }
    const RgbImage picture = jpeg::decode(jpeg, source, denominator);
    return translated("read a photo's brightness", [&] {
        const int top = picture.height() / 3;
        ViewBand band(picture.width(), top);
        cv::Mat grey(band.height(), band.width(), CV_8U, band.values().data());
        cv::cvtColor(matOver(picture)(cv::Rect(0, top, band.width(), band.height())), grey,
                     cv::COLOR_RGB2GRAY);
        return band;
    });
}

std::optional<bool> isSameView(const ViewBand& a, const ViewBand& b) {
    if (a.width() != b.width() || a.height() != b.height()) {
        return std::nullopt;
    }
    return translated("compare two photos", [&]() -> std::optional<bool> {
        const cv::Mat softA = softened(a);
        const cv::Mat softB = softened(b);
        constexpr double kOfSobel = 1.0 / 8;
        cv::Mat alongX;
        cv::Mat alongY;
        cv::Sobel(softA, alongX, CV_32F, 1, 0, 3, kOfSobel);
        cv::Sobel(softA, alongY, CV_32F, 0, 1, 3, kOfSobel);
        int textured = 0;
        int same = 0;
        for (int y = 0; y + kBlock <= softA.rows; y += kBlock) {
            for (int x = 0; x + kBlock <= softA.cols; x += kBlock) {
                const cv::Rect at(x, y, kBlock, kBlock);
                const Block block = compared(softA(at), softB(at), alongX(at), alongY(at));
                textured += block == Block::Flat ? 0 : 1;
                same += block == Block::Same ? 1 : 0;
            }
        }
        return textured < kLeastBlocks ? std::nullopt : std::optional(same >= kLeastShare * textured);
    });
}

} // namespace spherewalk::photo
