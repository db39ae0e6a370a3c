// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/sight.h"

#include "spherewalk/base/parallel.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/base/statistics.h"

#include <opencv2/imgproc.hpp>

namespace spherewalk::align {

namespace {

constexpr int kStep = 2; ///< Points are sought at every second cell of every second row.
constexpr int kColumns = kSightColumns / kStep;
constexpr int kRows = kSightRows / kStep;
/// Beyond them the ratio of two values is not that of their light.
constexpr int kDark = 12;
constexpr int kBurnt = 243;
/// Variance of the logarithm of what noise of two grey levels leaves in a pixel.
constexpr double kNoise = 1e-4;
constexpr double kAlike = 2; ///< Factor of the least variance.
constexpr int kWidest = 3;   ///< Number of distances at which a point may lie.

/// The logarithms of a picture's channels and, in the fourth, 1 where they say nothing.
cv::Mat logarithmsOf(const RgbImage& picture) {
    const cv::Mat large(picture.height(), picture.width(), CV_8UC3,
                        const_cast<std::uint8_t*>(picture.values().data()));
    std::vector<cv::Mat> planes;
    cv::split(large, planes);
    const cv::Mat least = cv::min(cv::min(planes[0], planes[1]), planes[2]);
    const cv::Mat most = cv::max(cv::max(planes[0], planes[1]), planes[2]);
    cv::Mat isSilent = (least < kDark) | (most > kBurnt);
    cv::dilate(isSilent, isSilent, cv::Mat::ones(3, 3, CV_8U));
    const cv::Size size(kSightColumns, kSightRowsOfSphere);
    cv::Mat small;
    cv::resize(large, small, size, 0, 0, cv::INTER_AREA);
    cv::resize(isSilent, isSilent, size, 0, 0, cv::INTER_AREA);
    cv::Mat logs(size, CV_32FC4);
    for (int y = 0; y < small.rows; ++y) {
        for (int x = 0; x < small.cols; ++x) {
            cv::Vec4f& to = logs.at<cv::Vec4f>(y, x);
            for (int c = 0; c < 3; ++c) {
                to[c] = std::log(std::max(1.F, static_cast<float>(small.at<cv::Vec3b>(y, x)[c])));
            }
            to[3] = isSilent.at<std::uint8_t>(y, x) > 0 ? 1.F : 0.F;
        }
    }
    return logs;
}

/// The rays to all points, row by row.
std::vector<Eigen::Vector3f> rays() {
    std::vector<Eigen::Vector3f> all;
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            all.push_back(sightDirection(kStep * row, kStep * column));
        }
    }
    return all;
}

/// How a photo fits another one at some distance, a value for each point.
struct Fit {
    cv::Mat ratio;    ///< Of the logarithms of each channel, the mean of a patch.
    cv::Mat variance; ///< Of the channels' mean within the patch, which no gain changes.
};

/// shift: from the other photo to the own one, in the other's frame, divided by the distance.
Fit fitOf(const cv::Mat& own, const cv::Mat& other, const Eigen::Matrix3f& otherFromOwn,
          const Eigen::Vector3f& shift) {
    constexpr float kNoFit = 1e3F;
    static const std::vector<Eigen::Vector3f> kRays = rays();
    cv::Mat ratio(kRows, kColumns, CV_32FC4);
    cv::Mat square(kRows, kColumns, CV_32F);
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            const Eigen::Vector3f& ray = kRays[static_cast<std::size_t>(row * kColumns + column)];
            const SightPlace at = placeOf(otherFromOwn * ray + shift, kSightColumns);
            const int y = std::clamp(static_cast<int>(at.v), 0, kSightRowsOfSphere - 1);
            const int x = static_cast<int>(at.u) & (kSightColumns - 1);
            const cv::Vec4f& p = own.at<cv::Vec4f>(kStep * row + kSightTop, kStep * column);
            const cv::Vec4f& q = other.at<cv::Vec4f>(y, x);
            const float mean = (p[0] + p[1] + p[2] - q[0] - q[1] - q[2]) / 3;
            ratio.at<cv::Vec4f>(row, column) = {p[0] - q[0], p[1] - q[1], p[2] - q[2], mean};
            square.at<float>(row, column) = p[3] + q[3] > 0 ? kNoFit : mean * mean;
        }
    }
    cv::blur(ratio, ratio, {3, 3});
    cv::blur(square, square, {3, 3});
    cv::Mat mean;
    cv::extractChannel(ratio, mean, 3);
    return {ratio, square - mean.mul(mean)};
}

/// For each point what half of the neighbours keep below.
cv::Mat middleOf(const std::vector<Fit>& fits) {
    cv::Mat middle(kRows, kColumns, CV_32F);
    std::vector<float> values(fits.size());
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            std::ranges::transform(fits, values.begin(),
                                   [&](const Fit& fit) { return fit.variance.at<float>(row, column); });
            const auto rank = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
            std::ranges::nth_element(values, rank);
            middle.at<float>(row, column) = *rank;
        }
    }
    return middle;
}

/// Where a photo shows points whose distance its neighbours tell, and how each neighbour fits there.
struct Points {
    cv::Mat is;    ///< 255 for a point.
    cv::Mat limit; ///< A neighbour with a smaller variance shows the point too.
    std::vector<Fit> fits;
};

Points pointsOf(std::size_t photo, std::span<const SightPhoto> photos, std::span<const cv::Mat> logs,
                std::span<const int> neighbours) {
    Points points;
    cv::Mat least;
    std::vector<cv::Mat> ofLevel;
    for (int level = 0; level < kSightLevels; ++level) {
        std::vector<Fit> fits;
        for (const int neighbour : neighbours) {
            const auto other = static_cast<std::size_t>(neighbour);
            const Rigid3 otherFromOwn = photos[other].roomFromPhoto->inverse() * *photos[photo].roomFromPhoto;
            fits.push_back(fitOf(logs[photo], logs[other], otherFromOwn.rotation.matrix().cast<float>(),
                                 (inverseOf(level) * otherFromOwn.translation).cast<float>()));
        }
        ofLevel.push_back(middleOf(fits));
        if (level == 0) {
            least = ofLevel[0].clone();
            points.fits = std::move(fits);
            continue;
        }
        const cv::Mat isBetter = ofLevel.back() < least;
        ofLevel.back().copyTo(least, isBetter);
        for (std::size_t j = 0; j < fits.size(); ++j) {
            fits[j].ratio.copyTo(points.fits[j].ratio, isBetter);
            fits[j].variance.copyTo(points.fits[j].variance, isBetter);
        }
    }
    points.limit = kAlike * (least + kNoise);
    // What shows no detail fits anything that shows none.
    const cv::Mat plain(logs[photo].size(), CV_32FC4, cv::Scalar::all(0));
    points.is = fitOf(logs[photo], plain, Eigen::Matrix3f::Identity(), Eigen::Vector3f::Zero()).variance >
                points.limit;
    cv::Mat width(kRows, kColumns, CV_8U, cv::Scalar(0));
    for (const cv::Mat& level : ofLevel) {
        cv::add(width, cv::Scalar(1), width, level < points.limit);
    }
    points.is &= width <= kWidest;
    return points;
}

/// How much brighter a photo is than one of its neighbours.
struct Ratio {
    std::size_t a = 0;
    std::size_t b = 0;
    std::array<double, 3> log{};
    double points = 0;
};

/// The ratios of one photo to its neighbours.
std::vector<Ratio> ratiosOf(std::size_t photo, std::span<const SightPhoto> photos,
                            std::span<const cv::Mat> logs, std::span<const int> neighbours) {
    std::vector<Ratio> ratios;
    if (neighbours.empty()) {
        return ratios;
    }
    const Points points = pointsOf(photo, photos, logs, neighbours);
    for (std::size_t j = 0; j < neighbours.size(); ++j) {
        const cv::Mat isShown = points.is & (points.fits[j].variance < points.limit);
        std::array<std::vector<double>, 3> values;
        for (int row = 0; row < kRows; ++row) {
            for (int column = 0; column < kColumns; ++column) {
                for (std::size_t c = 0; c < 3 && isShown.at<std::uint8_t>(row, column) != 0; ++c) {
                    values[c].push_back(points.fits[j].ratio.at<cv::Vec4f>(row, column)[static_cast<int>(c)]);
                }
            }
        }
        Ratio ratio{
            photo, static_cast<std::size_t>(neighbours[j]), {}, static_cast<double>(values[0].size())};
        std::ranges::transform(values, ratio.log.begin(), [](auto& of) { return median(std::move(of)); });
        ratios.push_back(ratio);
    }
    return ratios;
}

} // namespace

PhotoGains gainsOf(std::span<const SightPhoto> photos, std::span<const std::vector<int>> neighbours,
                   int threads, const std::stop_token& stop) {
    std::vector<cv::Mat> logs(photos.size());
    for (std::size_t i = 0; i < photos.size(); ++i) {
        logs[i] = photos[i].picture.empty() ? cv::Mat() : logarithmsOf(photos[i].picture);
    }
    std::vector<std::vector<Ratio>> ratios(photos.size());
    parallelFor(static_cast<int>(photos.size()), 1, threads, [&](int begin, int end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            throwIfStopped(stop);
            ratios[i] = ratiosOf(i, photos, logs, neighbours[i]);
        }
    });
    PhotoGains gains(photos.size(), {0, 0, 0});
    constexpr int kRounds = 30;
    for (int round = 0; round < kRounds; ++round) {
        PhotoGains sums(photos.size(), {0, 0, 0});
        std::vector<double> points(photos.size(), 0);
        for (const std::vector<Ratio>& ofPhoto : ratios) {
            for (const Ratio& ratio : ofPhoto) {
                for (std::size_t c = 0; c < 3; ++c) {
                    sums[ratio.a][c] += ratio.points * (gains[ratio.b][c] + ratio.log[c]);
                    sums[ratio.b][c] += ratio.points * (gains[ratio.a][c] - ratio.log[c]);
                }
                points[ratio.a] += ratio.points;
                points[ratio.b] += ratio.points;
            }
        }
        for (std::size_t i = 0; i < photos.size(); ++i) {
            for (std::size_t c = 0; c < 3 && points[i] > 0; ++c) {
                gains[i][c] = 0.5 * (gains[i][c] + sums[i][c] / points[i]); // Half the way: it never swings.
            }
        }
    }
    for (auto& photo : gains) {
        for (double& value : photo) {
            value = std::exp(-value);
        }
    }
    return gains;
}

} // namespace spherewalk::align
