// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/measure/displacement.h"

#include "contest.h"

#include "spherewalk/base/error.h"

#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <utility>

namespace spherewalk::measure {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr int kFeatures = 1500;
constexpr float kByFar = 0.75F; ///< of the second best distance
constexpr std::size_t kBeside = 6;
constexpr int kWitnesses = 2;

struct Moved {
    Vector2d from;
    Vector2d by;
};

/// The best and the second best partner of a feature, by squared distance.
struct Partners {
    int best = -1;
    float distance = FLT_MAX;
    float second = FLT_MAX;

    void offer(int partner, float d) {
        if (d < distance) {
            second = std::exchange(distance, d);
            best = partner;
        } else if (d < second) {
            second = d;
        }
    }
};

/// Whether neighbours moved alike.
bool hasWitnesses(const std::vector<Moved>& all, std::size_t of) {
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i != of) {
            near.emplace_back((all[i].from - all[of].from).squaredNorm(), i);
        }
    }
    const std::size_t count = std::min(near.size(), kBeside);
    std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), near.end());
    const double tolerance = 2 + 0.25 * all[of].by.norm();
    return std::count_if(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), [&](const auto& n) {
               return (all[n.second].by - all[of].by).norm() < tolerance;
           }) >= kWitnesses;
}

} // namespace

struct PictureFeatures::Found {
    int width = 0;
    int height = 0;
    std::vector<cv::KeyPoint> points;
    cv::Mat descriptors;
    cv::Mat squares; ///< of the descriptors' lengths, a row
};

namespace {

using RowMatrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Eigen::Map<const RowMatrix> rowsOf(const cv::Mat& descriptors) {
    return {descriptors.ptr<float>(), descriptors.rows, descriptors.cols};
}

template <class Found>
std::vector<Moved> bestOfEachOther(const Found& a, const Found& b) {
    std::vector<Moved> result;
    if (a.points.size() < 2 || b.points.size() < 2) {
        return result;
    }
    const RowMatrix products = rowsOf(a.descriptors) * rowsOf(b.descriptors).transpose();
    std::vector<Partners> there(a.points.size());
    std::vector<Partners> back(b.points.size());
    for (int i = 0; i < products.rows(); ++i) {
        const float* row = products.row(i).data();
        const auto k = static_cast<std::size_t>(i);
        for (int j = 0; j < products.cols(); ++j) {
            const float squared =
                a.squares.template at<float>(i) + b.squares.template at<float>(j) - 2 * row[j];
            there[k].offer(j, squared);
            back[static_cast<std::size_t>(j)].offer(i, squared);
        }
    }
    for (std::size_t i = 0; i < there.size(); ++i) {
        const auto partner = static_cast<std::size_t>(there[i].best);
        if (there[i].distance < kByFar * kByFar * there[i].second &&
            back[partner].best == static_cast<int>(i)) {
            const cv::Point2f from = a.points[i].pt;
            const cv::Point2f to = b.points[partner].pt;
            result.push_back({{from.x, from.y}, {to.x - from.x, to.y - from.y}});
        }
    }
    return result;
}

[[noreturn]] void refused(const cv::Exception& error) {
    throw Error(ErrorKind::Internal, "Could not match pictures: OpenCV refused them; please report this.",
                error.what());
}

} // namespace

PictureFeatures::PictureFeatures(const RgbImage& picture) {
    Found found{picture.width(), picture.height(), {}, {}, {}};
    try {
        const cv::Mat rgb(picture.height(), picture.width(), CV_8UC3,
                          const_cast<std::uint8_t*>(picture.values().data()));
        cv::Mat grey;
        cv::cvtColor(rgb, grey, cv::COLOR_RGB2GRAY);
        cv::SIFT::create(kFeatures)->detectAndCompute(grey, cv::noArray(), found.points, found.descriptors);
        if (!found.points.empty()) {
            cv::reduce(found.descriptors.mul(found.descriptors), found.squares, 1, cv::REDUCE_SUM);
        }
    } catch (const cv::Exception& error) {
        refused(error);
    }
    m_found = std::make_shared<const Found>(std::move(found));
}

std::vector<Displacement> matchedDisplacements(const RgbImage& truth, const RgbImage& computed) {
    return matchedDisplacements(PictureFeatures(truth), PictureFeatures(computed));
}

std::vector<Displacement> matchedDisplacements(const PictureFeatures& truth,
                                               const PictureFeatures& computed) {
    const PictureFeatures::Found& a = *truth.m_found;
    const PictureFeatures::Found& b = *computed.m_found;
    if (a.width != b.width || a.height != b.height) {
        throw Error(ErrorKind::InvalidInput, "Pictures of different sizes cannot be compared.");
    }
    try {
        const std::vector<Moved> all = bestOfEachOther(a, b);
        std::vector<Displacement> result;
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (hasWitnesses(all, i)) {
                result.push_back({all[i].from, all[i].by.norm()});
            }
        }
        return result;
    } catch (const cv::Exception& error) {
        refused(error);
    }
}

std::vector<Displacement> exactDisplacements(const CameraModel& camera, const Rigid3& roomFromCamera,
                                             const Vector3d& photoInRoom, const DepthImage& trueZ,
                                             const DepthImage& takenZ, int every) {
    const bool isFar = takenZ.empty();
    if (trueZ.width() != camera.width() || trueZ.height() != camera.height() || every < 1 ||
        (!isFar && (takenZ.width() != trueZ.width() || takenZ.height() != trueZ.height()))) {
        throw Error(ErrorKind::InvalidInput, "A depth and its view have different sizes.");
    }
    const Vector3d photo = roomFromCamera.inverse() * photoInRoom; // in the camera's frame
    std::vector<Displacement> result;
    for (int y = 0; y < trueZ.height(); y += every) {
        for (int x = 0; x < trueZ.width(); x += every) {
            const Vector2d at(x, y);
            const auto ray = camera.ray(at);
            const double z = *trueZ.at(x, y);
            if (!ray || !(z > 0) || !std::isfinite(z) || !(ray->z() > 0)) {
                continue;
            }
            const Vector3d thing = z / ray->z() * *ray;
            const double taken = isFar ? HUGE_VAL : *takenZ.at(x, y);
            const Vector3d seen = std::isfinite(taken) ? Vector3d(taken / ray->z() * *ray - photo) : *ray;
            const auto shown = camera.project(photo + (thing - photo).norm() * seen.normalized());
            if (shown) {
                result.push_back({at, (*shown - at).norm()});
            }
        }
    }
    return result;
}

std::optional<double> quantile(const std::vector<Displacement>& displacements, double share) {
    if (displacements.empty()) {
        return std::nullopt;
    }
    std::vector<double> errors;
    for (const Displacement& displacement : displacements) {
        errors.push_back(displacement.errorPx);
    }
    return quantile(std::move(errors), share);
}

} // namespace spherewalk::measure
