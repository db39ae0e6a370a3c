// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/compare/picture_matches.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/statistics.h"

#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <utility>

namespace spherewalk::compare {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr int kFeatures = 1500;
constexpr float kByFar = 0.75F; ///< of the second best distance
constexpr int kSiftLayers = 3;

using RowMatrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Eigen::Map<const RowMatrix> rowsOf(const cv::Mat& descriptors) {
    return {descriptors.ptr<float>(), descriptors.rows, descriptors.cols};
}

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

    bool isByFar() const { return best >= 0 && distance < kByFar * kByFar * second; }
};

[[noreturn]] void refused(const cv::Exception& error) {
    throw Error(ErrorKind::Internal, "Could not match pictures: OpenCV refused them; please report this.",
                error.what());
}

constexpr std::size_t kBeside = 6;
constexpr int kWitnesses = 2;

struct Moved {
    Vector2d from;
    Vector2d by;
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

PictureFeatures::PictureFeatures(const RgbImage& picture, double leastContrast) {
    Found found{picture.width(), picture.height(), {}, {}, {}};
    try {
        const cv::Mat rgb(picture.height(), picture.width(), CV_8UC3,
                          const_cast<std::uint8_t*>(picture.values().data()));
        cv::Mat grey;
        cv::cvtColor(rgb, grey, cv::COLOR_RGB2GRAY);
        cv::SIFT::create(kFeatures, kSiftLayers, leastContrast)
            ->detectAndCompute(grey, cv::noArray(), found.points, found.descriptors);
        if (!found.points.empty()) {
            cv::reduce(found.descriptors.mul(found.descriptors), found.squares, 1, cv::REDUCE_SUM);
        }
    } catch (const cv::Exception& error) {
        refused(error);
    }
    m_found = std::make_shared<const Found>(std::move(found));
}

int PictureFeatures::width() const {
    return m_found->width;
}

int PictureFeatures::height() const {
    return m_found->height;
}

std::vector<PictureMatch> pictureMatches(const PictureFeatures& a, const PictureFeatures& b, double reachPx) {
    const PictureFeatures::Found& ofA = *a.m_found;
    const PictureFeatures::Found& ofB = *b.m_found;
    std::vector<PictureMatch> result;
    if (ofA.points.size() < 2 || ofB.points.size() < 2) {
        return result;
    }
    const auto mayMatch = [&](std::size_t i, std::size_t j) {
        const cv::Point2f apart = ofA.points[i].pt - ofB.points[j].pt;
        return reachPx <= 0 || static_cast<double>(apart.dot(apart)) <= reachPx * reachPx;
    };
    const RowMatrix products = rowsOf(ofA.descriptors) * rowsOf(ofB.descriptors).transpose();
    std::vector<Partners> there(ofA.points.size());
    std::vector<Partners> back(ofB.points.size());
    for (std::size_t i = 0; i < there.size(); ++i) {
        const float* row = products.row(static_cast<Eigen::Index>(i)).data();
        const float own = ofA.squares.at<float>(static_cast<int>(i));
        for (std::size_t j = 0; j < back.size(); ++j) {
            if (mayMatch(i, j)) {
                const float squared = own + ofB.squares.at<float>(static_cast<int>(j)) - 2 * row[j];
                there[i].offer(static_cast<int>(j), squared);
                back[j].offer(static_cast<int>(i), squared);
            }
        }
    }
    for (std::size_t i = 0; i < there.size(); ++i) {
        const auto partner = static_cast<std::size_t>(there[i].best);
        if (there[i].isByFar() && back[partner].best == static_cast<int>(i)) {
            const cv::Point2f inA = ofA.points[i].pt;
            const cv::Point2f inB = ofB.points[partner].pt;
            result.push_back({{inA.x, inA.y}, {inB.x, inB.y}});
        }
    }
    return result;
}

std::vector<Displacement> matchedDisplacements(const RgbImage& truth, const RgbImage& computed) {
    return matchedDisplacements(PictureFeatures(truth), PictureFeatures(computed));
}

std::vector<Displacement> matchedDisplacements(const PictureFeatures& truth,
                                               const PictureFeatures& computed) {
    if (truth.width() != computed.width() || truth.height() != computed.height()) {
        throw Error(ErrorKind::InvalidInput, "Pictures of different sizes cannot be compared.");
    }
    std::vector<Moved> all;
    for (const PictureMatch& match : pictureMatches(truth, computed)) {
        all.push_back({match.inA, match.inB - match.inA});
    }
    std::vector<Displacement> result;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (hasWitnesses(all, i)) {
            result.push_back({all[i].from, all[i].by.norm()});
        }
    }
    return result;
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
    return quantileInPlace(errors, share);
}

} // namespace spherewalk::compare
