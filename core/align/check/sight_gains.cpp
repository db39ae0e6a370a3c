// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/sight.h"

#include "spherewalk/base/parallel.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/base/statistics.h"

#include <Eigen/Cholesky>
#include <opencv2/imgproc.hpp>

#include <cmath>
#include <iterator>

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
    cv::Mat level; ///< Its distance.
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
            points.level = cv::Mat(kRows, kColumns, CV_8U, cv::Scalar(0));
            points.fits = std::move(fits);
            continue;
        }
        const cv::Mat isBetter = ofLevel.back() < least;
        ofLevel.back().copyTo(least, isBetter);
        points.level.setTo(level, isBetter);
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

/// A point that two photos show.
struct SharedPoint {
    Eigen::Vector3f directionInA = Eigen::Vector3f::Zero();
    Eigen::Vector3f directionInB = Eigen::Vector3f::Zero();
    Eigen::Vector3f log = Eigen::Vector3f::Zero(); ///< How much brighter a shows it, of each channel.
};

using TermProducts = Eigen::Matrix<double, GainField::kTerms, GainField::kTerms>;
using FieldTerms = Eigen::Matrix<double, GainField::kTerms, 3>; ///< A column a channel.

/// How much brighter a photo is than one of its neighbours.
struct Ratio {
    std::size_t a = 0;
    std::size_t b = 0;
    Eigen::Vector3d log = Eigen::Vector3d::Zero(); ///< The median.
    double points = 0;
    /// Normal equations of what is beyond the median, as fields of a and of b.
    TermProducts aa = TermProducts::Zero();
    TermProducts ab = TermProducts::Zero();
    TermProducts bb = TermProducts::Zero();
    FieldTerms ofA = FieldTerms::Zero();
    FieldTerms ofB = FieldTerms::Zero();
};

Ratio ratioOf(std::size_t a, std::size_t b, const std::vector<SharedPoint>& shared) {
    constexpr double kLight = 0.1; ///< What lies farther from the median has another reason than light.
    constexpr double kSigmas = 3;
    Ratio ratio;
    ratio.a = a;
    ratio.b = b;
    ratio.points = static_cast<double>(shared.size());
    if (shared.empty()) {
        return ratio;
    }
    Eigen::Vector3d most;
    for (int c = 0; c < 3; ++c) {
        std::vector<double> values;
        std::ranges::transform(shared, std::back_inserter(values),
                               [c](const SharedPoint& point) { return double{point.log[c]}; });
        const MedianAndSpread<double> middle = medianAndSpread(std::move(values));
        ratio.log[c] = middle.median;
        most[c] = std::max(kLight, kSigmas * middle.sigma);
    }
    for (const SharedPoint& point : shared) {
        const Eigen::Vector3d beyond = point.log.cast<double>() - ratio.log;
        if ((beyond.array().abs() > most.array()).any()) {
            continue;
        }
        const auto inA = GainField::terms(point.directionInA).cast<double>().eval();
        const auto inB = GainField::terms(point.directionInB).cast<double>().eval();
        ratio.aa += inA * inA.transpose();
        ratio.ab += inA * inB.transpose();
        ratio.bb += inB * inB.transpose();
        ratio.ofA += inA * beyond.transpose();
        ratio.ofB += inB * beyond.transpose();
    }
    return ratio;
}

/// The ratios of one photo to its neighbours.
std::vector<Ratio> ratiosOf(std::size_t photo, std::span<const SightPhoto> photos,
                            std::span<const cv::Mat> logs, std::span<const int> neighbours) {
    std::vector<Ratio> ratios;
    if (neighbours.empty()) {
        return ratios;
    }
    const Points points = pointsOf(photo, photos, logs, neighbours);
    for (std::size_t j = 0; j < neighbours.size(); ++j) {
        const auto other = static_cast<std::size_t>(neighbours[j]);
        const Rigid3 otherFromOwn = photos[other].roomFromPhoto->inverse() * *photos[photo].roomFromPhoto;
        const Eigen::Matrix3f turn = otherFromOwn.rotation.matrix().cast<float>();
        const Eigen::Vector3f shift = otherFromOwn.translation.cast<float>();
        const cv::Mat isShown = points.is & (points.fits[j].variance < points.limit);
        std::vector<SharedPoint> shared;
        for (int row = 0; row < kRows; ++row) {
            for (int column = 0; column < kColumns; ++column) {
                if (isShown.at<std::uint8_t>(row, column) != 0) {
                    const Eigen::Vector3f ray = sightDirection(kStep * row, kStep * column);
                    const auto inverse =
                        static_cast<float>(inverseOf(points.level.at<std::uint8_t>(row, column)));
                    const cv::Vec4f& log = points.fits[j].ratio.at<cv::Vec4f>(row, column);
                    shared.push_back(
                        {ray, (turn * ray + inverse * shift).normalized(), {log[0], log[1], log[2]}});
                }
            }
        }
        ratios.push_back(ratioOf(photo, other, shared));
    }
    return ratios;
}

/// One gain for each photo and channel.
std::vector<Eigen::Vector3d> evenGains(std::size_t photos, const std::vector<Ratio>& ratios) {
    std::vector<Eigen::Vector3d> gains(photos, Eigen::Vector3d::Zero());
    constexpr int kRounds = 30;
    for (int round = 0; round < kRounds; ++round) {
        std::vector<Eigen::Vector3d> sums(photos, Eigen::Vector3d::Zero());
        std::vector<double> points(photos, 0);
        for (const Ratio& ratio : ratios) {
            sums[ratio.a] += ratio.points * (gains[ratio.b] + ratio.log);
            sums[ratio.b] += ratio.points * (gains[ratio.a] - ratio.log);
            points[ratio.a] += ratio.points;
            points[ratio.b] += ratio.points;
        }
        for (std::size_t i = 0; i < photos; ++i) {
            if (points[i] > 0) {
                gains[i] = 0.5 * (gains[i] + sums[i] / points[i]); // Half the way: it never swings.
            }
        }
    }
    return gains;
}

/// What the points say beyond the even gains, as far as it changes slowly. Nothing where there are few: a
/// person before a plain wall is no reason to call the wall darker.
std::vector<FieldTerms> slowGains(std::size_t photos, const std::vector<Ratio>& ratios,
                                  const std::vector<Eigen::Vector3d>& even) {
    constexpr double kPrior = 100; ///< So many points weigh as much as that there is nothing.
    constexpr int kRounds = 20;
    std::vector<TermProducts> products(photos, kPrior * TermProducts::Identity());
    for (const Ratio& ratio : ratios) {
        products[ratio.a] += ratio.aa;
        products[ratio.b] += ratio.bb;
    }
    std::vector<FieldTerms> fields(photos, FieldTerms::Zero());
    for (int round = 0; round < kRounds; ++round) {
        std::vector<FieldTerms> sides(photos, FieldTerms::Zero());
        for (const Ratio& ratio : ratios) {
            // The even gains of a survey are not the medians of each pair.
            const Eigen::RowVector3d more = (ratio.log - even[ratio.a] + even[ratio.b]).transpose();
            sides[ratio.a] += ratio.ofA + ratio.aa.col(0) * more + ratio.ab * fields[ratio.b];
            sides[ratio.b] -= ratio.ofB + ratio.bb.col(0) * more - ratio.ab.transpose() * fields[ratio.a];
        }
        for (std::size_t i = 0; i < photos; ++i) {
            fields[i] = 0.5 * (fields[i] + FieldTerms(products[i].llt().solve(sides[i])));
        }
    }
    return fields;
}

} // namespace

GainField::Terms GainField::terms(const Eigen::Vector3f& d) {
    const float x = d.x();
    const float y = d.y();
    const float z = d.z();
    Terms terms;
    constexpr float kStitched = 0.15F; // Within some nine degrees one lens goes over into the other.
    terms << 1, x, y, z, 2 * x * y, 2 * y * z, 2 * z * x, x * x - y * y, 1.5F * z * z - 0.5F,
        x / std::hypot(x, kStitched);
    return terms;
}

Eigen::Vector3f GainField::at(const Eigen::Vector3f& directionInPhoto) const {
    return (logs * terms(directionInPhoto)).array().exp();
}

std::vector<GainField> gainsOf(std::span<const SightPhoto> photos,
                               std::span<const std::vector<int>> neighbours, int threads,
                               const std::stop_token& stop) {
    std::vector<cv::Mat> logs(photos.size());
    for (std::size_t i = 0; i < photos.size(); ++i) {
        logs[i] = photos[i].picture.empty() ? cv::Mat() : logarithmsOf(photos[i].picture);
    }
    std::vector<std::vector<Ratio>> ofPhotos(photos.size());
    parallelFor(static_cast<int>(photos.size()), 1, threads, [&](int begin, int end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            throwIfStopped(stop);
            ofPhotos[i] = ratiosOf(i, photos, logs, neighbours[i]);
        }
    });
    std::vector<Ratio> ratios;
    for (std::vector<Ratio>& ofPhoto : ofPhotos) {
        std::ranges::move(ofPhoto, std::back_inserter(ratios));
    }
    const std::vector<Eigen::Vector3d> even = evenGains(photos.size(), ratios);
    const std::vector<FieldTerms> slow = slowGains(photos.size(), ratios, even);
    std::vector<GainField> gains(photos.size());
    for (std::size_t i = 0; i < photos.size(); ++i) {
        gains[i].logs = -slow[i].transpose().cast<float>();
        gains[i].logs.col(0) -= even[i].cast<float>();
    }
    return gains;
}

} // namespace spherewalk::align
