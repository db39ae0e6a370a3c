// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/measure/picture_matches.h"

#include "spherewalk/base/error.h"

#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include <cfloat>
#include <utility>

namespace spherewalk::measure {

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

} // namespace spherewalk::measure
