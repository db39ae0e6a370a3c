// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/compare/tag_pose.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"

#include <Eigen/Dense>
#include <opencv2/calib3d.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace spherewalk::compare {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using PoseStep = Eigen::Matrix<double, 6, 1>;
using StepNormal = Eigen::Matrix<double, 6, 6>;

constexpr double kLeastSigmaRad = 5e-5;
/// A corner that misses by more belongs to a tag that hangs elsewhere than it did: so many standard
/// deviations, and what the calibration of a lens may be off by, a pixel or two.
constexpr double kReachSigmas = 5;
constexpr double kReachRad = 0.003;
constexpr int kMostSteps = 30;
/// Beside the best pose, one is surely wrong whose squared misses, in their variances, add up to so much
/// more.
constexpr double kSurelyWorse = 25;
/// Or that misses so many times as much. Deviations are stated too large where a tag's whole place is
/// uncertain. By chance, one of a hundred does: a tag leaves two numbers of eight over.
constexpr double kTimesWorse = 10;
constexpr double kTinyMisfit = 0.01; ///< Rounding leaves as much.

/// A tag whose place is known, as the picture shows it.
struct CommonTag {
    const photo::SeenTag* seen;
    const render::DatasetTag* known;

    double rangeM(const Rigid3& roomFromCamera) const {
        return (known->cornersM[0] - roomFromCamera.translation).norm();
    }
};

Rigid3 stepped(const Rigid3& pose, const PoseStep& change) {
    return pose * Rigid3{turn(change.head<3>()), change.tail<3>()};
}

Vector3d missOf(const Rigid3& cameraFromRoom, const Vector3d& pInRoom, const Vector3d& direction) {
    return (cameraFromRoom * pInRoom).normalized() - direction;
}

/// A corner's place errs, too, as an angle from the camera.
double sigmaOf(const CommonTag& tag, const Rigid3& pose) {
    return std::hypot(std::max(kLeastSigmaRad, tag.seen->sigmaRad),
                      tag.known->sigmaM / std::max(0.05, tag.rangeM(pose)));
}

bool agrees(const CommonTag& tag, const Rigid3& pose) {
    const Rigid3 cameraFromRoom = pose.inverse();
    const double reach = kReachSigmas * sigmaOf(tag, pose) + kReachRad;
    for (std::size_t i = 0; i < tag.known->cornersM.size(); ++i) {
        if (!(missOf(cameraFromRoom, tag.known->cornersM[i], tag.seen->directions[i]).norm() < reach)) {
            return false;
        }
    }
    return true;
}

struct TagSums {
    StepNormal normal = StepNormal::Zero();
    PoseStep gradient = PoseStep::Zero();
    double cost = 0;
    int corners = 0;
};

/// Derivatives by a turn and a shift in the camera's own frame.
TagSums tagSums(const Rigid3& pose, std::span<const CommonTag> tags) {
    TagSums sums;
    const Rigid3 cameraFromRoom = pose.inverse();
    for (const CommonTag& tag : tags) {
        const double sigma = sigmaOf(tag, pose);
        for (std::size_t i = 0; i < tag.known->cornersM.size(); ++i) {
            const Vector3d p = cameraFromRoom * tag.known->cornersM[i];
            const double range = std::max(p.norm(), 1e-9);
            const Vector3d unit = p / range;
            const Matrix3d across = (Matrix3d::Identity() - unit * unit.transpose()) / (range * sigma);
            Eigen::Matrix<double, 3, 6> slopes;
            slopes << across * skew(p), -across;
            const Vector3d miss = (unit - tag.seen->directions[i]) / sigma;
            sums.normal += slopes.transpose() * slopes;
            sums.gradient += slopes.transpose() * miss;
            sums.cost += miss.squaredNorm();
            ++sums.corners;
        }
    }
    return sums;
}

double worstAxisSigma(const Matrix3d& covariance) {
    return std::sqrt(std::max(
        0.0, Eigen::SelfAdjointEigenSolver<Matrix3d>(covariance, Eigen::EigenvaluesOnly).eigenvalues()[2]));
}

TagPose refinedByTags(Rigid3 pose, std::span<const CommonTag> tags) {
    TagSums sums = tagSums(pose, tags);
    double damping = 1e-6;
    for (int round = 0; round < kMostSteps; ++round) {
        StepNormal damped = sums.normal;
        damped.diagonal() *= 1 + damping;
        const Rigid3 next = stepped(pose, -damped.ldlt().solve(sums.gradient));
        const TagSums tried = tagSums(next, tags);
        if (!(tried.cost < sums.cost)) {
            damping = std::max(damping, 1e-8) * 10;
            continue;
        }
        pose = next;
        sums = tried;
        damping /= 10;
    }
    TagPose made;
    made.roomFromCamera = pose;
    made.misfit = std::sqrt(sums.cost / (2.0 * sums.corners));
    const StepNormal covariance = sums.normal.ldlt().solve(StepNormal::Identity()) *
                                  std::max(1.0, sums.cost / std::max(1.0, 2.0 * sums.corners - 6));
    made.sigmaRotation = Radians(worstAxisSigma(covariance.topLeftCorner<3, 3>()));
    made.sigmaM = worstAxisSigma(covariance.bottomRightCorner<3, 3>());
    return made;
}

/// The room from a tag's own frame (x right, y up, z towards the reader), and the tag's size.
std::pair<Rigid3, double> frameOf(const render::DatasetTag& tag) {
    const auto& at = tag.cornersM;
    const Vector3d across = at[1] - at[0] + at[2] - at[3];
    const Vector3d up = at[0] - at[3] + at[1] - at[2];
    Matrix3d axes;
    axes.col(0) = across.normalized();
    axes.col(2) = across.cross(up).normalized();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    return {{Eigen::Quaterniond(axes), (at[0] + at[1] + at[2] + at[3]) / 4}, (across.norm() + up.norm()) / 4};
}

/// The two poses that one tag allows. It is looked at by a camera that is turned to its middle.
std::vector<Rigid3> posesBy(const CommonTag& tag) {
    const auto [roomFromTag, size] = frameOf(*tag.known);
    Vector3d middle = Vector3d::Zero();
    for (const Vector3d& direction : tag.seen->directions) {
        middle += direction;
    }
    const Eigen::Quaterniond cameraFromTurned = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), middle);
    std::vector<cv::Point2d> places;
    for (const Vector3d& direction : tag.seen->directions) {
        const Vector3d turned = cameraFromTurned.conjugate() * direction;
        places.emplace_back(turned.x() / turned.z(), turned.y() / turned.z());
    }
    const double half = size / 2;
    const std::vector<cv::Point3d> square{
        {-half, half, 0}, {half, half, 0}, {half, -half, 0}, {-half, -half, 0}};
    std::vector<cv::Mat> turns;
    std::vector<cv::Mat> shifts;
    try {
        cv::solvePnPGeneric(square, places, cv::Matx33d::eye(), cv::noArray(), turns, shifts, false,
                            cv::SOLVEPNP_IPPE_SQUARE);
    } catch (const cv::Exception&) { // Corners on one line are no square.
        return {};
    }
    std::vector<Rigid3> poses;
    for (std::size_t i = 0; i < turns.size(); ++i) {
        const Vector3d turned(turns[i].at<double>(0), turns[i].at<double>(1), turns[i].at<double>(2));
        const Vector3d shift(shifts[i].at<double>(0), shifts[i].at<double>(1), shifts[i].at<double>(2));
        const Rigid3 turnedFromTag{turn(turned), shift};
        const Rigid3 pose =
            roomFromTag * (Rigid3{cameraFromTurned, Vector3d::Zero()} * turnedFromTag).inverse();
        if (isPose(pose)) {
            poses.push_back(pose);
        }
    }
    return poses;
}

using CommonTags = std::vector<CommonTag>;

/// The poses that most tags agree with.
class Consensus {
  public:
    explicit Consensus(CommonTags tags) : m_tags(std::move(tags)) {}

    /// Tries each tag alone and, since a pose by one small tag misses the others, each two of them.
    std::vector<TagPose> poses() {
        for (const CommonTag& tag : m_tags) {
            for (const Rigid3& start : posesBy(tag)) {
                const Rigid3 alone = refinedByTags(start, std::span(&tag, 1)).roomFromCamera;
                consider(alone);
                for (const CommonTag& other : m_tags) {
                    if (other.known != tag.known) {
                        const std::array two{tag, other};
                        consider(refinedByTags(alone, two).roomFromCamera);
                    }
                }
            }
        }
        std::ranges::stable_sort(m_best, {}, &TagPose::misfit);
        if (!m_best.empty()) {
            const double best = m_best.front().misfit;
            std::erase_if(m_best, [best](const TagPose& pose) {
                const double count = 8.0 * static_cast<double>(pose.numbers.size()); // two a corner
                const double more = count * (pose.misfit * pose.misfit - best * best);
                return more > kSurelyWorse * std::max(1.0, best * best) ||
                       pose.misfit > kTimesWorse * std::max(best, kTinyMisfit);
            });
        }
        return m_best;
    }

  private:
    void consider(const Rigid3& start) {
        CommonTags agreeing = agreeingWith(start);
        if (agreeing.empty() || agreeing.size() < m_most) {
            return;
        }
        TagPose pose = refinedByTags(start, agreeing);
        agreeing = agreeingWith(pose.roomFromCamera);
        if (agreeing.empty() || agreeing.size() < m_most || !isPose(pose.roomFromCamera)) {
            return;
        }
        if (agreeing.size() > m_most) {
            m_most = agreeing.size();
            m_best.clear();
        }
        for (const CommonTag& tag : m_tags) {
            (agrees(tag, pose.roomFromCamera) ? pose.numbers : pose.moved).push_back(tag.known->number);
        }
        const bool isKnown = std::ranges::any_of(m_best, [&](const TagPose& other) {
            constexpr Radians kSame = Degrees(0.02);
            return other.numbers == pose.numbers &&
                   angleBetween(other.roomFromCamera.rotation, pose.roomFromCamera.rotation) < kSame;
        });
        if (!isKnown) {
            m_best.push_back(std::move(pose));
        }
    }

    CommonTags agreeingWith(const Rigid3& pose) const {
        CommonTags made;
        std::ranges::copy_if(m_tags, std::back_inserter(made),
                             [&](const CommonTag& tag) { return agrees(tag, pose); });
        return made;
    }

    CommonTags m_tags;
    std::size_t m_most = 0;
    std::vector<TagPose> m_best;
};

std::string whyNone(std::span<const photo::SeenTag> seen, std::span<const render::DatasetTag> known) {
    if (known.empty()) {
        return "The dataset knows no tags: align the survey with --tag-size, and export it again.";
    }
    if (seen.empty()) {
        return "The picture shows no AprilTag.";
    }
    std::string numbers;
    for (const photo::SeenTag& tag : seen) {
        numbers += text(numbers.empty() ? "" : ", ", tag.number);
    }
    const bool isOneKnown = std::ranges::any_of(seen, [&](const photo::SeenTag& tag) {
        return std::ranges::find(known, tag.number, &render::DatasetTag::number) != known.end();
    });
    return isOneKnown ? text("The picture shows a tag twice (", numbers, "): hang each number once.")
                      : text("The dataset does not know the tags of the picture (", numbers, ").");
}

} // namespace

TagRegistration registeredByTags(std::span<const photo::SeenTag> seen,
                                 std::span<const render::DatasetTag> known) {
    CommonTags tags;
    for (const photo::SeenTag& tag : seen) {
        const auto same = std::ranges::find(known, tag.number, &render::DatasetTag::number);
        const bool isOnce = std::ranges::count(seen, tag.number, &photo::SeenTag::number) == 1;
        if (same != known.end() && isOnce) {
            tags.push_back({&tag, &*same});
        }
    }
    TagRegistration made;
    if (tags.empty()) {
        made.why = whyNone(seen, known);
        return made;
    }
    made.poses = Consensus(std::move(tags)).poses();
    if (made.poses.empty()) {
        made.why = "The tags that the picture shows contradict where they hang.";
    }
    return made;
}

} // namespace spherewalk::compare
