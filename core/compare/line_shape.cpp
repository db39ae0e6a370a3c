// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/compare/line_shape.h"

#include "grey_picture.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace spherewalk::compare {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double kBlurPx = 1;
constexpr double kLeastSlope = 4; ///< grey levels a pixel
constexpr double kProfileStepPx = 0.5;
constexpr std::size_t kFewestPoints = 8;
constexpr double kLeastFound = 0.5;
constexpr double kAboutAsMany = 0.9;
constexpr double kMostReachPx = 100;
constexpr int kRoomSamples = 2000; ///< of a line in the room, before they are thinned to a pixel apart

/// Catmull and Rom's weights of four neighbours.
Eigen::Vector4d cubicWeights(double t) {
    const double t2 = t * t;
    const double t3 = t2 * t;
    return {0.5 * (-t3 + 2 * t2 - t), 0.5 * (3 * t3 - 5 * t2 + 2), 0.5 * (-3 * t3 + 4 * t2 + t),
            0.5 * (t3 - t2)};
}

/// The brightness between pixels; nothing outside. Linear interpolation would draw edge points to pixels.
std::optional<double> brightnessAt(const cv::Mat& grey, const Vector2d& pixel) {
    const int x = static_cast<int>(std::floor(pixel.x()));
    const int y = static_cast<int>(std::floor(pixel.y()));
    if (x < 1 || y < 1 || x + 2 >= grey.cols || y + 2 >= grey.rows) {
        return std::nullopt;
    }
    const Eigen::Vector4d across = cubicWeights(pixel.x() - x);
    const Eigen::Vector4d down = cubicWeights(pixel.y() - y);
    double sum = 0;
    for (int row = 0; row < 4; ++row) {
        const float* values = grey.ptr<float>(y - 1 + row) + x - 1;
        for (int column = 0; column < 4; ++column) {
            sum += down[row] * across[column] * values[column];
        }
    }
    return sum;
}

/// Across the line at one of its points.
Vector2d normalAt(const PictureLine& line, std::size_t i) {
    const Vector2d along = (line[std::min(i + 2, line.size() - 1)] - line[i < 2 ? 0 : i - 2]).normalized();
    return {-along.y(), along.x()};
}

/// An edge point: how far along the line, and how far across it.
struct EdgePoint {
    double along = 0;
    double across = 0;
};

/// The slopes of brightness across the line at one point, from a step beyond the reach to a step beyond it
/// on the other side; 0 outside the picture.
std::vector<double> slopesAcross(const cv::Mat& grey, const Vector2d& at, const Vector2d& normal, int steps) {
    std::vector<std::optional<double>> values;
    for (int k = -steps - 2; k <= steps + 2; ++k) {
        values.push_back(brightnessAt(grey, at + k * kProfileStepPx * normal));
    }
    std::vector<double> slopes;
    for (std::size_t i = 1; i + 1 < values.size(); ++i) {
        const bool isKnown = values[i - 1] && values[i + 1];
        slopes.push_back(isKnown ? (*values[i + 1] - *values[i - 1]) / (2 * kProfileStepPx) : 0);
    }
    return slopes;
}

/// Where the strongest slope is, from the line; nothing below the least slope.
std::optional<double> strongestSlope(const std::vector<double>& slopes, int steps) {
    const auto best = std::max_element(slopes.begin() + 1, slopes.end() - 1);
    if (*best < kLeastSlope) {
        return std::nullopt;
    }
    const double bend = *(best - 1) - 2 * *best + *(best + 1);
    const double part = bend < 0 ? std::clamp(0.5 * (*(best - 1) - *(best + 1)) / bend, -0.5, 0.5) : 0;
    return kProfileStepPx * (static_cast<double>(best - slopes.begin()) - (steps + 1) + part);
}

/// Those where it gets brighter, and those where it gets darker.
std::array<std::vector<EdgePoint>, 2> edgePoints(const cv::Mat& grey, const PictureLine& line,
                                                 double reachPx) {
    const int steps = static_cast<int>(reachPx / kProfileStepPx);
    std::array<std::vector<EdgePoint>, 2> points;
    double along = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        along += i == 0 ? 0 : (line[i] - line[i - 1]).norm();
        std::vector<double> slopes = slopesAcross(grey, line[i], normalAt(line, i), steps);
        for (std::vector<EdgePoint>& ofSign : points) {
            if (const auto across = strongestSlope(slopes, steps)) {
                ofSign.push_back({along, *across});
            }
            std::ranges::transform(slopes, slopes.begin(), std::negate<>());
        }
    }
    return points;
}

/// The distances from the straight line that fits them best.
std::vector<double> bends(const std::vector<EdgePoint>& points) {
    Eigen::MatrixX2d system(static_cast<Eigen::Index>(points.size()), 2);
    Eigen::VectorXd across(system.rows());
    for (Eigen::Index i = 0; i < system.rows(); ++i) {
        system.row(i) << 1, points[static_cast<std::size_t>(i)].along;
        across[i] = points[static_cast<std::size_t>(i)].across;
    }
    const Vector2d fit = system.colPivHouseholderQr().solve(across);
    const Eigen::VectorXd rest = across - system * fit;
    return {rest.begin(), rest.end()};
}

double meanBend(const std::vector<EdgePoint>& points) {
    if (points.size() < kFewestPoints) {
        return HUGE_VAL;
    }
    double sum = 0;
    for (const double bend : bends(points)) {
        sum += std::abs(bend);
    }
    return sum / static_cast<double>(points.size());
}

void requireFinite(bool isFinite) {
    if (!isFinite) {
        throw Error(ErrorKind::InvalidInput, "A line needs two finite points.");
    }
}

cv::Mat blurredBrightness(const RgbImage& picture) {
    if (picture.empty()) {
        throw Error(ErrorKind::InvalidInput, "An empty picture shows no lines.");
    }
    cv::Mat grey;
    greyPicture(picture).convertTo(grey, CV_32F);
    cv::GaussianBlur(grey, grey, {0, 0}, kBlurPx);
    return grey;
}

std::optional<LineShape> shapeIn(const cv::Mat& grey, const PictureLine& line, double reachPx) {
    if (line.size() < kFewestPoints) {
        return std::nullopt;
    }
    auto [points, others] = edgePoints(grey, line, reachPx);
    // Of two signs that are about as frequent (a thin line has both), the evener one is the line's.
    const auto [fewer, more] = std::minmax({points.size(), others.size()});
    const bool areAlike = static_cast<double>(fewer) >= kAboutAsMany * static_cast<double>(more);
    if (areAlike ? meanBend(others) < meanBend(points) : others.size() > points.size()) {
        std::swap(points, others);
    }
    const double share = static_cast<double>(points.size()) / static_cast<double>(line.size());
    if (points.size() < kFewestPoints || share < kLeastFound) {
        return std::nullopt;
    }
    LineShape shape;
    shape.points = points.size();
    shape.foundShare = share;
    for (const EdgePoint& point : points) {
        shape.offPx += std::abs(point.across) / static_cast<double>(points.size());
    }
    double squares = 0;
    for (const double bend : bends(points)) {
        squares += bend * bend;
        shape.worstPx = std::max(shape.worstPx, std::abs(bend));
    }
    shape.rmsPx = std::sqrt(squares / static_cast<double>(points.size()));
    return shape;
}

void requireReach(double reachPx) {
    if (!(reachPx >= 1 && reachPx <= kMostReachPx)) {
        throw Error(ErrorKind::InvalidInput,
                    text("An edge is sought from 1 to 100 pixels away, not ", reachPx, "."));
    }
}

} // namespace

PictureLine pictureLine(const Vector2d& from, const Vector2d& to) {
    requireFinite(from.allFinite() && to.allFinite());
    const int steps = std::max(1, static_cast<int>(std::lround((to - from).norm())));
    PictureLine line;
    for (int i = 0; i <= steps; ++i) {
        line.push_back(from + (static_cast<double>(i) / steps) * (to - from));
    }
    return line;
}

PictureLine pictureLine(const CameraModel& camera, const Rigid3& roomFromCamera, const Vector3d& fromInRoom,
                        const Vector3d& toInRoom) {
    requireFinite(fromInRoom.allFinite() && toInRoom.allFinite());
    const Rigid3 cameraFromRoom = roomFromCamera.inverse();
    PictureLine line;
    for (int i = 0; i <= kRoomSamples; ++i) {
        const Vector3d at = fromInRoom + (static_cast<double>(i) / kRoomSamples) * (toInRoom - fromInRoom);
        const auto pixel = camera.project(cameraFromRoom * at);
        if (pixel && pixel->x() >= 0 && pixel->y() >= 0 && pixel->x() <= camera.width() - 1 &&
            pixel->y() <= camera.height() - 1 && (line.empty() || (*pixel - line.back()).norm() >= 1)) {
            line.push_back(*pixel);
        }
    }
    return line;
}

std::vector<PictureLine> straightLines(const RgbImage& picture, double leastPx) {
    if (picture.empty()) {
        throw Error(ErrorKind::InvalidInput, "An empty picture shows no lines.");
    }
    return withOpenCv([&] {
        std::vector<cv::Vec4f> found;
        cv::createLineSegmentDetector()->detect(greyPicture(picture), found);
        std::vector<PictureLine> lines;
        for (const cv::Vec4f& line : found) {
            const Vector2d from(line[0], line[1]);
            const Vector2d to(line[2], line[3]);
            if ((to - from).norm() >= leastPx) {
                lines.push_back(pictureLine(from, to));
            }
        }
        return lines;
    });
}

std::optional<LineShape> lineShape(const RgbImage& view, const PictureLine& line, double reachPx) {
    requireReach(reachPx);
    return withOpenCv([&] { return shapeIn(blurredBrightness(view), line, reachPx); });
}

Straightness straightness(const RgbImage& view, const std::vector<PictureLine>& lines, double reachPx) {
    requireReach(reachPx);
    return withOpenCv([&] {
        const cv::Mat grey = blurredBrightness(view);
        Straightness result;
        result.lines = lines.size();
        double squares = 0;
        std::size_t points = 0;
        for (const PictureLine& line : lines) {
            if (const auto shape = shapeIn(grey, line, reachPx)) {
                ++result.found;
                points += shape->points;
                squares += shape->rmsPx * shape->rmsPx * static_cast<double>(shape->points);
                result.worstPx = std::max(result.worstPx.value_or(0), shape->rmsPx);
            }
        }
        if (points > 0) {
            result.rmsPx = std::sqrt(squares / static_cast<double>(points));
        }
        return result;
    });
}

} // namespace spherewalk::compare
