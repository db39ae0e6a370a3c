// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/compare/picture_matches.h"

#include "grey_picture.h"

#include "spherewalk/base/statistics.h"

#include <opencv2/features2d.hpp>

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

constexpr std::size_t kBeside = 6;
constexpr int kWitnesses = 2;

struct Moved {
    Vector2d from;
    Vector2d by;
};

/// How the features nearest to a pixel moved; those at the pixel itself are left out.
std::vector<Vector2d> movesBeside(const std::vector<Moved>& all, const Vector2d& pixel) {
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].from != pixel) {
            near.emplace_back((all[i].from - pixel).squaredNorm(), i);
        }
    }
    const std::size_t count = std::min(near.size(), kBeside);
    std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), near.end());
    std::vector<Vector2d> moves;
    for (std::size_t i = 0; i < count; ++i) {
        moves.push_back(all[near[i].second].by);
    }
    return moves;
}

bool hasWitnesses(const std::vector<Moved>& all, const Moved& one) {
    const std::vector<Vector2d> beside = movesBeside(all, one.from);
    const double tolerance = 2 + 0.25 * one.by.norm();
    return std::count_if(beside.begin(), beside.end(), [&](const Vector2d& move) {
               return (move - one.by).norm() < tolerance;
           }) >= kWitnesses;
}

} // namespace

struct PictureFeatures::Found {
    int width = 0;
    int height = 0;
    cv::Mat grey;
    std::vector<cv::KeyPoint> points;
    cv::Mat descriptors;
    cv::Mat squares; ///< of the descriptors' lengths, a row
};

PictureFeatures::PictureFeatures(const RgbImage& picture, double leastContrast) {
    Found found{picture.width(), picture.height(), {}, {}, {}, {}};
    withOpenCv([&] {
        found.grey = greyPicture(picture);
        cv::SIFT::create(kFeatures, kSiftLayers, leastContrast)
            ->detectAndCompute(found.grey, cv::noArray(), found.points, found.descriptors);
        if (!found.points.empty()) {
            cv::reduce(found.descriptors.mul(found.descriptors), found.squares, 1, cv::REDUCE_SUM);
        }
    });
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

std::vector<PictureMatch> witnessedMatches(const PictureFeatures& a, const PictureFeatures& b) {
    if (a.width() != b.width() || a.height() != b.height()) {
        throw Error(ErrorKind::InvalidInput, "Pictures of different sizes cannot be compared.");
    }
    const std::vector<PictureMatch> matches = pictureMatches(a, b);
    std::vector<Moved> all;
    all.reserve(matches.size());
    for (const PictureMatch& match : matches) {
        all.push_back({match.inA, match.inB - match.inA});
    }
    std::vector<PictureMatch> result;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (hasWitnesses(all, all[i])) {
            result.push_back(matches[i]);
        }
    }
    return result;
}

std::vector<Displacement> matchedDisplacements(const PictureFeatures& truth,
                                               const PictureFeatures& computed) {
    std::vector<Displacement> result;
    for (const PictureMatch& match : witnessedMatches(truth, computed)) {
        result.push_back({match.inA, (match.inB - match.inA).norm()});
    }
    return result;
}

namespace {

constexpr int kPatch = 10;       ///< pixels to each side
constexpr int kPatchReach = 16;  ///< pixels
constexpr int kPlaceBorder = 16; ///< pixels
constexpr double kLeastContrast = 5;
constexpr double kLeastLikeness = 0.65;
constexpr double kLikenessAPixel = 0.02; ///< that a farther place must be more alike

/// Where a patch is in another picture.
struct FoundPatch {
    double likeness = -1; ///< correlation, less what its distance from the expected place costs
    Vector2d by = Vector2d::Zero();
};

/// Of a maximum between its neighbours, in steps.
double peakOffset(double before, double at, double after) {
    const double bend = before - 2 * at + after;
    return bend < 0 ? std::clamp(0.5 * (before - after) / bend, -0.5, 0.5) : 0;
}

/// Where the patch about a pixel is most alike, within reach of the place that a move leads to.
FoundPatch foundPatch(const cv::Mat& truth, const cv::Mat& computed, const cv::Point& at,
                      const cv::Point& move) {
    const cv::Rect patch(at.x - kPatch, at.y - kPatch, 2 * kPatch + 1, 2 * kPatch + 1);
    const cv::Rect area = cv::Rect(patch.x + move.x - kPatchReach, patch.y + move.y - kPatchReach,
                                   patch.width + 2 * kPatchReach, patch.height + 2 * kPatchReach) &
                          cv::Rect(0, 0, computed.cols, computed.rows);
    if (area.width < patch.width || area.height < patch.height) {
        return {};
    }
    cv::Mat correlations;
    cv::matchTemplate(computed(area), truth(patch), correlations, cv::TM_CCOEFF_NORMED);
    FoundPatch best;
    cv::Point where;
    for (int y = 0; y < correlations.rows; ++y) {
        for (int x = 0; x < correlations.cols; ++x) {
            const Vector2d by(x + area.x - patch.x, y + area.y - patch.y);
            const double likeness = static_cast<double>(correlations.at<float>(y, x)) -
                                    kLikenessAPixel * (by - Vector2d(move.x, move.y)).norm();
            if (likeness > best.likeness) {
                best = {likeness, by};
                where = {x, y};
            }
        }
    }
    const auto value = [&](int x, int y) {
        return static_cast<double>(correlations.at<float>(std::clamp(y, 0, correlations.rows - 1),
                                                          std::clamp(x, 0, correlations.cols - 1)));
    };
    const double peak = value(where.x, where.y);
    best.by.x() += peakOffset(value(where.x - 1, where.y), peak, value(where.x + 1, where.y));
    best.by.y() += peakOffset(value(where.x, where.y - 1), peak, value(where.x, where.y + 1));
    return best;
}

/// The pixels of a picture's features, each once.
std::vector<cv::Point> placesOf(const std::vector<cv::KeyPoint>& points) {
    std::vector<cv::Point> places;
    places.reserve(points.size());
    for (const cv::KeyPoint& point : points) {
        places.emplace_back(cvRound(point.pt.x), cvRound(point.pt.y));
    }
    const auto before = [](const cv::Point& a, const cv::Point& b) {
        return a.y != b.y ? a.y < b.y : a.x < b.x;
    };
    std::sort(places.begin(), places.end(), before);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
}

bool isPlace(const cv::Mat& grey, const cv::Point& at) {
    if (at.x < kPlaceBorder || at.y < kPlaceBorder || at.x >= grey.cols - kPlaceBorder ||
        at.y >= grey.rows - kPlaceBorder) {
        return false;
    }
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(grey(cv::Rect(at.x - kPatch, at.y - kPatch, 2 * kPatch + 1, 2 * kPatch + 1)), mean,
                   deviation);
    return deviation[0] >= kLeastContrast;
}

} // namespace

double PlaceDisplacements::missedShare() const {
    const std::size_t all = found.size() + missed;
    return all == 0 ? 0 : static_cast<double>(missed) / static_cast<double>(all);
}

PlaceDisplacements placeDisplacements(const PictureFeatures& truth, const PictureFeatures& computed) {
    PlaceDisplacements result;
    std::vector<Moved> moved;
    cv::Mat matched(truth.height(), truth.width(), CV_8UC1, cv::Scalar(0));
    for (const PictureMatch& match : witnessedMatches(truth, computed)) {
        moved.push_back({match.inA, match.inB - match.inA});
        result.found.push_back({match.inA, moved.back().by.norm()});
        matched.at<std::uint8_t>(cvRound(match.inA.y()), cvRound(match.inA.x())) = 1;
    }
    const cv::Mat& grey = truth.m_found->grey;
    withOpenCv([&] {
        for (const cv::Point& at : placesOf(truth.m_found->points)) {
            if (matched.at<std::uint8_t>(at) != 0 || !isPlace(grey, at)) {
                continue;
            }
            FoundPatch best = foundPatch(grey, computed.m_found->grey, at, {0, 0});
            const Vector2d pixel(at.x, at.y);
            const std::vector<Vector2d> moves = movesBeside(moved, pixel);
            if (best.likeness < kLeastLikeness && !moves.empty()) {
                const cv::Point near(cvRound(moves[0].x()), cvRound(moves[0].y()));
                best = foundPatch(grey, computed.m_found->grey, at, near);
            }
            if (best.likeness >= kLeastLikeness) {
                result.found.push_back({pixel, best.by.norm()});
            } else {
                ++result.missed;
            }
        }
    });
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
    errors.reserve(displacements.size());
    for (const Displacement& displacement : displacements) {
        errors.push_back(displacement.errorPx);
    }
    return quantileInPlace(errors, share);
}

} // namespace spherewalk::compare
