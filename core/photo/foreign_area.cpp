// SPDX-License-Identifier: GPL-3.0-or-later
#include "opencv_picture.h"
#include "sketch_match.h"

#include "spherewalk/geometry/equirect.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace spherewalk::photo {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kNearestM = 0.7; ///< to the camera, of what both photos must show alike
constexpr int kMostShift = 24;
constexpr int kPatch = 5;
constexpr int kStride = 2;                          ///< of the search: the sketches are softened as much
constexpr int kFirstRow = kSketchHeight * 20 / 180; ///< 70 degrees above the horizon
constexpr int kRows = kSketchHeight * 115 / 180;    ///< down to 45 degrees below it: then comes the cart
constexpr double kForeign = 14; ///< mean difference of a patch's strongest channel, grey levels
constexpr double kOfActivity = 0.6;

using Planes = std::array<cv::Mat, 3>;

Planes planesOf(const cv::Mat& picture) {
    Planes planes;
    cv::split(picture, planes.data());
    return planes;
}

/// The neighbour in the photo's turn and colours.
cv::Mat alike(const MatchedSketch& neighbour) {
    const RgbImage& picture = neighbour.sketch->picture;
    const int shift = static_cast<int>(
        std::lround(-neighbour.match.turn.value() / (2 * kPi) * kSketchWidth + kSketchWidth));
    cv::Mat result(kSketchHeight, kSketchWidth, CV_8UC3);
    for (int v = 0; v < kSketchHeight; ++v) {
        for (int u = 0; u < kSketchWidth; ++u) {
            const std::uint8_t* p = picture.at((u + shift) % kSketchWidth, v);
            auto& q = result.at<cv::Vec3b>(v, u);
            for (int c = 0; c < 3; ++c) {
                q[c] = cv::saturate_cast<std::uint8_t>(p[c] *
                                                       neighbour.match.gains[static_cast<std::size_t>(c)]);
            }
        }
    }
    return result;
}

/// How far parallax may move things, in columns.
int reach(double distanceM) {
    const double columns = std::atan2(distanceM, kNearestM) / (2 * kPi) * kSketchWidth;
    return std::clamp(static_cast<int>(std::ceil(columns)) + 1, 3, kMostShift);
}

/// Keeps in `least` how well each patch is found in the neighbour, anywhere within the reach.
void compare(const Planes& photo, const MatchedSketch& neighbour, cv::Mat& least) {
    const int across = reach(neighbour.distanceM);
    const int along = across / 2 + 1;
    cv::Mat wide;
    cv::blur(alike(neighbour), wide, {3, 3});
    cv::copyMakeBorder(wide, wide, 0, 0, across, across, cv::BORDER_WRAP);
    cv::copyMakeBorder(wide, wide, along, along, 0, 0, cv::BORDER_REPLICATE);
    const Planes other = planesOf(wide);
    cv::Mat difference;
    cv::Mat channel;
    for (int y = 0; y <= 2 * along; y += kStride) {
        for (int x = 0; x <= 2 * across; x += kStride) {
            const cv::Rect part(x, y + kFirstRow, kSketchWidth, kRows);
            cv::absdiff(photo[0], other[0](part), difference);
            for (std::size_t c = 1; c < 3; ++c) {
                cv::absdiff(photo[c], other[c](part), channel);
                cv::max(difference, channel, difference);
            }
            cv::blur(difference, channel, {kPatch, kPatch});
            cv::min(least, channel, least);
        }
    }
}

/// How much a patch varies by itself: what is full of detail never fits to the last grey level.
cv::Mat activity(const Planes& photo) {
    cv::Mat most(kRows, kSketchWidth, CV_8U, cv::Scalar(0));
    cv::Mat mean;
    cv::Mat detail;
    for (const cv::Mat& plane : photo) {
        cv::blur(plane, mean, {kPatch, kPatch});
        cv::absdiff(plane, mean, detail);
        cv::blur(detail, detail, {kPatch, kPatch});
        cv::max(most, detail, most);
    }
    return most;
}

/// Connected areas, those across the seam too. Shape: kRows x kSketchWidth.
ForeignArea largestArea(const cv::Mat& mask) {
    cv::Mat twice;
    cv::hconcat(mask, mask, twice);
    cv::Mat labels;
    const int count = cv::connectedComponents(twice, labels, 8);

    struct Sum {
        double area = 0;
        double u = 0;
        double v = 0;
        int left = 2 * kSketchWidth;
        int right = 0;
    };

    std::vector<Sum> sums(static_cast<std::size_t>(count));
    for (int v = 0; v < labels.rows; ++v) {
        const double weight = std::cos(kPi / 2 - kPi * (v + kFirstRow + 0.5) / kSketchHeight);
        for (int u = 0; u < labels.cols; ++u) {
            Sum& sum = sums[static_cast<std::size_t>(labels.at<int>(v, u))];
            sum.area += weight;
            sum.u += weight * u;
            sum.v += weight * v;
            sum.left = std::min(sum.left, u);
            sum.right = std::max(sum.right, u);
        }
    }
    const double sphere = 2.0 * kSketchWidth * kSketchHeight / kPi; // what the weights of a picture add up to
    ForeignArea result;
    for (std::size_t label = 1; label < sums.size(); ++label) {
        const Sum& sum = sums[label];
        const double part =
            std::min(sum.right - sum.left >= kSketchWidth ? sum.area / 2 : sum.area, sphere) / sphere;
        if (part > result.part) {
            const EquirectSize size{kSketchWidth, kSketchHeight};
            const SphericalDirection middle =
                sphericalDirection(direction(size, Eigen::Vector2d(std::fmod(sum.u / sum.area, kSketchWidth),
                                                                   sum.v / sum.area + kFirstRow)));
            result = {part, middle.azimuth, middle.elevation};
        }
    }
    return result;
}

} // namespace

ForeignArea foreignArea(const Sketch& photo, std::span<const MatchedSketch> neighbours) {
    if (neighbours.empty()) {
        return {};
    }
    return translated("compare a photo with its neighbours", [&] {
        cv::Mat soft;
        cv::blur(matOver(photo.picture), soft, {3, 3});
        const Planes own = planesOf(soft.rowRange(kFirstRow, kFirstRow + kRows));
        cv::Mat least(kRows, kSketchWidth, CV_8U, cv::Scalar(255));
        for (const MatchedSketch& neighbour : neighbours) {
            compare(own, neighbour, least);
        }
        cv::Mat limit;
        activity(own).convertTo(limit, CV_8U, kOfActivity, kForeign);
        return largestArea(least > limit);
    });
}

} // namespace spherewalk::photo
