// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/keypoints.h"
#include "features/sphere_view.h"

#include "spherewalk/align/features.h"
#include "spherewalk/geometry/equirect.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace spherewalk::align {

namespace {

constexpr int kViews = 8;                ///< Flat views around the horizon, in which edges stay straight.
constexpr Degrees kHighest(50);          ///< Of a view's middle column. Cart and operator lie lower.
constexpr Degrees kMostLean(20);         ///< Of a photo, against its own vertical axis.
constexpr int kMostWidth = 2048;         ///< Pixels per turn that are looked at.
constexpr int kBins = 36;                ///< Directions around the horizon that count for themselves.
constexpr double kLeastLengthRad = 0.12; ///< Of an edge.
constexpr double kMostWorthRad = 0.7;    ///< A longer edge says no more of what stands upright.
constexpr double kPointPx = 0.5;         ///< Standard deviation of an edge's points, two pixels apart.
constexpr double kStandingRad = 2.6e-3;  ///< By which edges that people built upright lean.
constexpr std::size_t kLeastEdges = 12;  ///< That agree.
constexpr std::size_t kLeastBins = 6;    ///< In which such edges lie.
constexpr double kLeastLead = 1.5;       ///< Over any other direction for which edges speak.
constexpr double kMostSigmaRad = 2.6e-3;

/// An edge that may stand upright.
struct Edge {
    Eigen::Vector3d normal; ///< Of the plane through the lens that the edge lies in.
    double sigmaRad;        ///< By which the plane may miss the vertical.
    double worth;
    int bin;
};

/// Where the pixels of the view at azimuth 0 lie in the photo. Those of other views lie as far aside in the
/// photo as the view is turned.
class ViewMap {
  public:
    explicit ViewMap(const GreyImage& photo)
        : m_focalPx(photo.width() / (2 * std::numbers::pi)),
          m_size(2 * halfPx(std::numbers::pi / kViews) + 1, 2 * halfPx(Radians(kHighest).value()) + 1),
          m_x(m_size, CV_32F),
          m_y(m_size, CV_32F) {
        for (int y = 0; y < m_size.height; ++y) {
            for (int x = 0; x < m_size.width; ++x) {
                const Eigen::Vector2d at = pixel({photo.width(), photo.height()}, bearing(x, y));
                m_x.at<float>(y, x) = static_cast<float>(at.x());
                m_y.at<float>(y, x) = static_cast<float>(at.y());
            }
        }
    }

    double focalPx() const { return m_focalPx; }

    /// In the view's frame: x forward, y left, z up.
    Eigen::Vector3d bearing(double x, double y) const {
        return Eigen::Vector3d(m_focalPx, (m_size.width - 1) / 2.0 - x, (m_size.height - 1) / 2.0 - y)
            .normalized();
    }

    /// The view that looks so far to the left.
    cv::Mat view(const cv::Mat& photo, double azimuthRad) const {
        const cv::Mat x = m_x - azimuthRad * m_focalPx;
        cv::Mat seen;
        cv::remap(photo, seen, x, m_y, cv::INTER_LINEAR, cv::BORDER_WRAP);
        return seen;
    }

  private:
    int halfPx(double angleRad) const { return static_cast<int>(std::ceil(m_focalPx * std::tan(angleRad))); }

    double m_focalPx;
    cv::Size m_size;
    cv::Mat m_x;
    cv::Mat m_y;
};

std::vector<Edge> uprightEdges(const GreyImage& photo, const FeatureOptions& options, const MaskImage& mask) {
    const cv::Mat whole = matrixOf(photo);
    const ViewMap map(photo);
    const cv::Ptr<cv::LineSegmentDetector> detector = cv::createLineSegmentDetector();
    std::vector<Edge> edges;
    for (int i = 0; i < kViews; ++i) {
        const double azimuth = 2 * std::numbers::pi * i / kViews;
        const Eigen::AngleAxisd turned(azimuth, Eigen::Vector3d::UnitZ());
        std::vector<cv::Vec4f> segments;
        detector->detect(map.view(whole, azimuth), segments);
        for (const cv::Vec4f& segment : segments) {
            const double lengthPx = std::hypot(segment[2] - segment[0], segment[3] - segment[1]);
            const Eigen::Vector3d one = turned * map.bearing(segment[0], segment[1]);
            const Eigen::Vector3d other = turned * map.bearing(segment[2], segment[3]);
            const double lengthRad = std::atan2(one.cross(other).norm(), one.dot(other));
            const Eigen::Vector3d normal = one.cross(other).normalized();
            const Eigen::Vector3d middle = (one + other).normalized();
            if (lengthPx < kLeastLengthRad * map.focalPx() || std::abs(normal.z()) > sin(kMostLean) ||
                !isSearched(options, mask, middle, Radians(0))) {
                continue;
            }
            const double slopeRad = kPointPx * std::sqrt(12 / (lengthPx / 2)) / lengthPx;
            const double around = std::atan2(middle.y(), middle.x()) / (2 * std::numbers::pi) + 0.5;
            edges.push_back({normal, std::hypot(slopeRad, kStandingRad), std::min(lengthRad, kMostWorthRad),
                             std::clamp(static_cast<int>(around * kBins), 0, kBins - 1)});
        }
    }
    return edges;
}

/// By how much the plane of an edge misses a direction. up: its slopes along x and y.
double missOf(const Edge& edge, const Eigen::Vector2d& up) {
    return (edge.normal.z() + edge.normal.head<2>().dot(up)) / std::sqrt(1 + up.squaredNorm());
}

/// The direction for which most edges speak. Empty if another one comes close.
std::optional<Eigen::Vector2d> mostVotes(const std::vector<Edge>& edges) {
    constexpr Degrees kStep(0.5);
    constexpr double kNearRad = 0.01;
    constexpr double kApart = 5; // Steps between two directions that are not the same.
    constexpr int kSteps = 40;
    static_assert(kSteps * kStep.value() == kMostLean.value());
    std::array<std::array<double, 2 * kSteps + 1>, 2 * kSteps + 1> votes{};
    const auto at = [&](int i, int j) -> double& {
        return votes[static_cast<std::size_t>(i + kSteps)][static_cast<std::size_t>(j + kSteps)];
    };
    const auto slope = [&](int step) { return std::tan(step * Radians(kStep).value()); };
    int bestX = 0;
    int bestY = 0;
    for (int i = -kSteps; i <= kSteps; ++i) {
        for (int j = -kSteps; j <= kSteps; ++j) {
            for (const Edge& edge : edges) {
                const double miss = missOf(edge, {slope(i), slope(j)});
                const double near = kNearRad * kNearRad + edge.sigmaRad * edge.sigmaRad;
                at(i, j) += edge.worth * std::max(0.0, 1 - miss * miss / near);
            }
            if (at(i, j) > at(bestX, bestY)) {
                bestX = i;
                bestY = j;
            }
        }
    }
    double second = 0;
    for (int i = -kSteps; i <= kSteps; ++i) {
        for (int j = -kSteps; j <= kSteps; ++j) {
            second = std::hypot(i - bestX, j - bestY) > kApart ? std::max(second, at(i, j)) : second;
        }
    }
    return at(bestX, bestY) > kLeastLead * second ? std::optional(Eigen::Vector2d(slope(bestX), slope(bestY)))
                                                  : std::nullopt;
}

/// The direction that the planes of most edges contain, by least squares that ignore those which miss it.
class VerticalFit {
  public:
    VerticalFit(const std::vector<Edge>& edges, const Eigen::Vector2d& start) : m_edges(edges), m_up(start) {
        constexpr std::array<double, 3> kWidths = {6, 3, 1.5};
        constexpr int kRounds = 8;
        for (const double width : kWidths) {
            for (int round = 0; round < kRounds && m_isSolved; ++round) {
                step(width);
            }
        }
    }

    /// Empty if the edges that agree are too few, or do not tell enough.
    std::optional<Vertical> vertical() const {
        const auto bins =
            static_cast<std::size_t>(std::ranges::count_if(m_isUsed, [](bool is) { return is; }));
        if (!m_isSolved || m_agreeing < kLeastEdges || bins < kLeastBins) {
            return std::nullopt;
        }
        // What leans in one direction does so together, so directions around the horizon are what counts.
        const Eigen::Matrix2d inverse = m_normal.inverse();
        Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
        for (const Eigen::Vector2d& pull : m_pulls) {
            scatter += pull * pull.transpose();
        }
        const auto count = static_cast<double>(bins);
        const Eigen::Matrix2d covariance = inverse * scatter * inverse * (count / (count - 2));
        const auto worst = [](const Eigen::Matrix2d& of) {
            return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(of).eigenvalues()(1);
        };
        const double sigmaRad = std::sqrt(std::max(worst(covariance), worst(inverse)));
        if (!(sigmaRad <= kMostSigmaRad)) { // NaN fails too.
            return std::nullopt;
        }
        return Vertical{Eigen::Vector3d(m_up.x(), m_up.y(), 1).normalized(), sigmaRad};
    }

  private:
    void step(double width) {
        m_normal.setZero();
        m_pulls.fill(Eigen::Vector2d::Zero());
        m_isUsed.fill(false);
        m_agreeing = 0;
        Eigen::Vector2d pull = Eigen::Vector2d::Zero();
        for (const Edge& edge : m_edges) {
            const double miss = missOf(edge, m_up);
            const double over = miss / (width * edge.sigmaRad);
            const double root = 1 / (edge.sigmaRad * (1 + over * over));
            const Eigen::Vector2d by = edge.normal.head<2>();
            m_normal += root * root * by * by.transpose();
            m_pulls[static_cast<std::size_t>(edge.bin)] += root * root * miss * by;
            pull += root * root * miss * by;
            if (std::abs(over) < 2) {
                ++m_agreeing;
                m_isUsed[static_cast<std::size_t>(edge.bin)] = true;
            }
        }
        m_isSolved = m_normal.determinant() > 0;
        if (m_isSolved) {
            m_up -= m_normal.inverse() * pull;
        }
    }

    const std::vector<Edge>& m_edges;
    Eigen::Vector2d m_up;
    bool m_isSolved = true;
    Eigen::Matrix2d m_normal = Eigen::Matrix2d::Zero();
    std::array<Eigen::Vector2d, kBins> m_pulls{};
    std::array<bool, kBins> m_isUsed{};
    std::size_t m_agreeing = 0;
};

} // namespace

std::optional<Vertical> findVertical(const Image<std::uint8_t, 1>& photo, const FeatureOptions& options,
                                     const MaskImage& mask) {
    if (photo.width() > kMostWidth) {
        GreyImage smaller(kMostWidth, kMostWidth / 2);
        cv::Mat to = matrixOf(smaller);
        cv::resize(matrixOf(photo), to, to.size(), 0, 0, cv::INTER_AREA);
        return findVertical(smaller, options, mask);
    }
    const std::vector<Edge> edges = uprightEdges(photo, options, mask);
    if (edges.size() < kLeastEdges) {
        return std::nullopt;
    }
    const auto start = mostVotes(edges);
    return start ? VerticalFit(edges, *start).vertical() : std::nullopt;
}

} // namespace spherewalk::align
