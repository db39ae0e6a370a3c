// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/foreign_check.h"

#include "check/sight.h"

#include "spherewalk/base/parallel.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>

namespace spherewalk::align {

namespace {

constexpr double kLeastBaselineM = 0.08;
constexpr double kMostBaselineM = 3;
constexpr double kBestBaselineM = 0.45; ///< Less says little of distances, more is hidden more often.
constexpr int kSectors = 6;
constexpr std::size_t kMostWitnesses = 10;
constexpr double kLeastPart = 0.002; ///< Of the sphere. Reflections and rims are smaller.

double distanceM(const SightPhoto& a, const SightPhoto& b) {
    return (a.roomFromPhoto->translation - b.roomFromPhoto->translation).norm();
}

bool isUsable(const SightPhoto& photo) {
    return photo.roomFromPhoto && !photo.picture.empty();
}

/// In each direction the photo whose distance tells most.
std::vector<int> neighboursOf(std::size_t photo, std::span<const SightPhoto> photos) {
    std::vector<int> best(kSectors, -1);
    if (!isUsable(photos[photo])) {
        return {};
    }
    const auto merit = [&](std::size_t other) {
        return -std::abs(std::log(distanceM(photos[photo], photos[other]) / kBestBaselineM));
    };
    for (std::size_t other = 0; other < photos.size(); ++other) {
        if (other == photo || !isUsable(photos[other])) {
            continue;
        }
        const double away = distanceM(photos[photo], photos[other]);
        if (away < kLeastBaselineM || away > kMostBaselineM) {
            continue;
        }
        const Eigen::Vector3d to =
            photos[other].roomFromPhoto->translation - photos[photo].roomFromPhoto->translation;
        const double turn = std::atan2(to.y(), to.x()) / (2 * std::numbers::pi) + 0.5;
        int& kept = best[static_cast<std::size_t>(turn * kSectors) % kSectors];
        if (kept < 0 || merit(other) > merit(static_cast<std::size_t>(kept))) {
            kept = static_cast<int>(other);
        }
    }
    std::erase(best, -1);
    return best;
}

/// The nearest photos, whose distances say what is seen through.
std::vector<int> witnessesOf(std::size_t photo, std::span<const SightPhoto> photos,
                             std::span<const PhotoSight> sights) {
    std::vector<int> near;
    for (std::size_t other = 0; other < photos.size(); ++other) {
        if (other != photo && !sights[other].empty() &&
            distanceM(photos[photo], photos[other]) <= kMostBaselineM) {
            near.push_back(static_cast<int>(other));
        }
    }
    std::ranges::stable_sort(near, {}, [&](int other) {
        return distanceM(photos[photo], photos[static_cast<std::size_t>(other)]);
    });
    near.resize(std::min(near.size(), kMostWitnesses));
    return near;
}

double weightOf(int row) {
    return std::cos(std::numbers::pi / 2 - std::numbers::pi * (row + kSightTop + 0.5) / kSightRowsOfSphere);
}

/// Takes away what the mask does not want searched.
void leaveOut(const MaskImage& mask, cv::Mat& foreign) {
    for (int row = 0; row < kSightRows && !mask.empty(); ++row) {
        for (int column = 0; column < kSightColumns; ++column) {
            const int x = (2 * column + 1) * mask.width() / (2 * kSightColumns);
            const int y = (2 * (row + kSightTop) + 1) * mask.height() / (2 * kSightRowsOfSphere);
            if (*mask.at(x, y) == 0) {
                foreign.at<std::uint8_t>(row, column) = 0;
            }
        }
    }
}

/// The connected areas that are large enough, the largest first. An area across the seam counts once.
std::vector<ForeignThing> areasIn(int photo, const cv::Mat& foreign) {
    cv::Mat twice;
    cv::hconcat(foreign, foreign, twice);
    cv::morphologyEx(twice, twice, cv::MORPH_OPEN, cv::Mat::ones(3, 3, CV_8U));
    cv::Mat labels;
    const int count = cv::connectedComponents(twice, labels, 8);
    std::vector<double> areas(static_cast<std::size_t>(count), 0);
    std::vector<int> left(areas.size(), 2 * kSightColumns);
    std::vector<Eigen::Vector3d> sums(areas.size(), Eigen::Vector3d::Zero());
    for (int row = 0; row < labels.rows; ++row) {
        for (int x = 0; x < labels.cols; ++x) {
            const auto label = static_cast<std::size_t>(labels.at<int>(row, x));
            areas[label] += weightOf(row);
            left[label] = std::min(left[label], x);
            sums[label] += weightOf(row) * sightDirection(row, x % kSightColumns).cast<double>();
        }
    }
    const double sphere = 2.0 * kSightColumns * kSightRowsOfSphere / std::numbers::pi;
    std::vector<ForeignThing> things;
    for (std::size_t label = 1; label < areas.size(); ++label) {
        // The second copy of the picture repeats what begins in the first one.
        const bool isRepeated = left[label] == 0 || left[label] >= kSightColumns;
        if (areas[label] / sphere >= kLeastPart && (!isRepeated || left[label] == kSightColumns)) {
            things.push_back({photo, sums[label].normalized(), areas[label] / sphere});
        }
    }
    std::ranges::stable_sort(things, std::greater(), &ForeignThing::part);
    return things;
}

} // namespace

ForeignCheck foreignThings(std::span<const SightPhoto> photos, const ForeignCheckOptions& options,
                           ProgressSink& progress, const std::stop_token& stop) {
    std::vector<std::vector<int>> neighbours;
    for (std::size_t i = 0; i < photos.size(); ++i) {
        neighbours.push_back(neighboursOf(i, photos));
    }
    const auto pictures = softened(photos, gainsOf(photos, neighbours));
    std::vector<PhotoSight> sights(photos.size());
    std::vector<Observer> observers(photos.size());
    std::vector<cv::Mat> foreign(photos.size());
    const auto forEach = [&](const std::function<void(std::size_t)>& work) {
        parallelFor(static_cast<int>(photos.size()), 1, options.threads, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) {
                throwIfStopped(stop);
                work(static_cast<std::size_t>(i));
            }
        });
    };
    forEach([&](std::size_t i) {
        sights[i] = sightOf(static_cast<int>(i), photos, pictures, neighbours[i]);
        if (!sights[i].empty()) {
            observers[i] = observer(photos[i], sights[i]);
        }
    });
    progress.progress(0.7, "Looking for what stands where other photos look through");
    forEach([&](std::size_t i) {
        std::vector<const Observer*> witnesses;
        for (const int other : witnessesOf(i, photos, sights)) {
            witnesses.push_back(&observers[static_cast<std::size_t>(other)]);
        }
        if (!sights[i].empty()) {
            foreign[i] = cv::Mat(foreignCells(photos[i], sights[i], witnesses), true).reshape(1, kSightRows);
            leaveOut(options.mask, foreign[i]);
        }
    });
    ForeignCheck result;
    for (std::size_t i = 0; i < photos.size(); ++i) {
        result.isJudged.push_back(!sights[i].empty());
        if (!sights[i].empty()) {
            std::ranges::move(areasIn(static_cast<int>(i), foreign[i]), std::back_inserter(result.things));
        }
    }
    return result;
}

} // namespace spherewalk::align
