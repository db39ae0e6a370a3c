// SPDX-License-Identifier: GPL-3.0-or-later
#include "pairs/pair_geometry.h"
#include "tags/changed_misses.h"

#include "spherewalk/align/room_tags.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace spherewalk::align {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kLeastSigmaM = 0.0005;
constexpr double kLeanSigmaRad = 0.005; ///< Of one level frame against the other.
constexpr double kMovedM = 0.03;        ///< A tag that fits worse hangs elsewhere.
constexpr double kMovedSigmas = 5;
constexpr double kStep = 1e-6;

/// A tag in both frames.
struct Common {
    RoomTag own;
    RoomTag other;
};

struct Motion {
    Matrix3d rotation = Matrix3d::Identity();
    Vector3d translation = Vector3d::Zero();
    double scale = 1;

    Vector3d operator*(const Vector3d& p) const { return scale * (rotation * p) + translation; }
};

double sigmaOf(const Common& tag, double scale) {
    return std::max(kLeastSigmaM, std::hypot(scale * tag.own.sigma, tag.other.sigma));
}

double missM(const Motion& motion, const Common& tag) {
    double square = 0;
    for (std::size_t i = 0; i < tag.own.corners.size(); ++i) {
        square += (motion * tag.own.corners[i] - tag.other.corners[i]).squaredNorm();
    }
    return std::sqrt(square / 4);
}

bool fits(const Motion& motion, const Common& tag) {
    return missM(motion, tag) < std::max(kMovedM, kMovedSigmas * sigmaOf(tag, motion.scale));
}

/// The corners' misses, and the lean of what is up, in standard deviations, after a small change.
struct Residuals {
    std::span<const Common> tags;
    Motion about;
    Vector3d middle;

    static Motion changed(const Motion& motion, const Vector3d& middle,
                          const Eigen::Matrix<double, 7, 1>& change) {
        const Matrix3d turned = turn(change.head<3>()).toRotationMatrix();
        Motion made;
        made.scale = motion.scale * std::exp(change[6]);
        made.rotation = turned * motion.rotation;
        // About the tags' middle, so that turns and shifts hardly mix.
        const Vector3d at = motion * middle;
        made.translation = at + change.segment<3>(3) - made.scale * (made.rotation * middle);
        return made;
    }

    Eigen::VectorXd operator()(const Eigen::Matrix<double, 7, 1>& change) const {
        const Motion motion = changed(about, middle, change);
        Eigen::VectorXd made(static_cast<Eigen::Index>(12 * tags.size() + 2));
        Eigen::Index row = 0;
        for (const Common& tag : tags) {
            const double sigma = sigmaOf(tag, about.scale);
            for (std::size_t i = 0; i < tag.own.corners.size(); ++i, row += 3) {
                made.segment<3>(row) = (motion * tag.own.corners[i] - tag.other.corners[i]) / sigma;
            }
        }
        made.tail<2>() = motion.rotation.col(2).head<2>() / kLeanSigmaRad;
        return made;
    }
};

Vector3d middleOf(std::span<const Common> tags) {
    Vector3d sum = Vector3d::Zero();
    for (const Common& tag : tags) {
        sum += (tag.own.corners[0] + tag.own.corners[2]) / 2;
    }
    return sum / static_cast<double>(tags.size());
}

/// The similarity of least squares of the corners alone. Source: Umeyama 1991.
std::optional<Motion> similarity(std::span<const Common> tags) {
    Eigen::Matrix3Xd own(3, 4 * tags.size());
    Eigen::Matrix3Xd other(3, 4 * tags.size());
    Eigen::Index column = 0;
    for (const Common& tag : tags) {
        for (std::size_t i = 0; i < tag.own.corners.size(); ++i, ++column) {
            own.col(column) = tag.own.corners[i];
            other.col(column) = tag.other.corners[i];
        }
    }
    const Eigen::Matrix4d matrix = Eigen::umeyama(own, other, true);
    Motion motion;
    motion.scale = std::cbrt(matrix.topLeftCorner<3, 3>().determinant());
    motion.rotation = matrix.topLeftCorner<3, 3>() / motion.scale;
    motion.translation = matrix.topRightCorner<3, 1>();
    return matrix.allFinite() && motion.scale > 0 ? std::optional(motion) : std::nullopt;
}

Motion refined(const Motion& start, std::span<const Common> tags) {
    const Vector3d middle = middleOf(tags);
    return Residuals::changed(start, middle,
                              ChangedMisses<7, Residuals>({tags, start, middle}, kStep).solved());
}

std::vector<Common> fitting(const Motion& motion, std::span<const Common> tags) {
    std::vector<Common> made;
    std::ranges::copy_if(tags, std::back_inserter(made),
                         [&](const Common& tag) { return fits(motion, tag); });
    return made;
}

/// The motion by the largest set of tags that agree.
Motion agreed(std::span<const Common> tags, const Motion& ofAll) {
    Motion best = ofAll;
    std::size_t most = fitting(ofAll, tags).size();
    for (std::size_t i = 0; i < tags.size() && most < tags.size(); ++i) {
        for (std::size_t j = i + 1; j < tags.size(); ++j) {
            const std::array two{tags[i], tags[j]};
            const std::optional<Motion> motion = similarity(two);
            const std::size_t count = motion ? fitting(*motion, tags).size() : 0;
            if (count > most) {
                best = *motion;
                most = count;
            }
        }
    }
    return best;
}

/// Of the scale, as a share of it; more where tags fit worse than they are known.
double scaleSigma(const Motion& motion, std::span<const Common> tags) {
    using Change = Eigen::Matrix<double, 7, 1>;
    const Residuals residuals{tags, motion, middleOf(tags)};
    const auto slopes = ChangedMisses<7, Residuals>(residuals, kStep).slopesAt(Change::Zero());
    const Eigen::Matrix<double, 7, 7> normal = slopes.transpose() * slopes;
    const double variance = normal.ldlt().solve(Change::Unit(6))[6];
    const double freedom = 12 * static_cast<double>(tags.size()) - 7;
    const double excess = residuals(Change::Zero()).squaredNorm() / freedom;
    return std::sqrt(std::max(0.0, variance) * std::max(1.0, excess));
}

} // namespace

std::optional<TagJoin> joinByTags(std::span<const RoomTag> own, std::span<const RoomTag> other) {
    std::vector<Common> tags;
    for (const RoomTag& tag : own) {
        const auto same = std::ranges::find(other, tag.number, &RoomTag::number);
        if (same != other.end()) {
            tags.push_back({tag, *same});
        }
    }
    const std::optional<Motion> ofAll = tags.empty() ? std::nullopt : similarity(tags);
    if (!ofAll) {
        return std::nullopt;
    }
    Motion motion = agreed(tags, *ofAll);
    std::vector<Common> fit = fitting(motion, tags);
    if (fit.empty()) {
        fit = tags;
    }
    motion = refined(motion, fit);
    TagJoin join;
    join.otherFromOwn = {Eigen::Quaterniond(motion.rotation).normalized(), motion.translation};
    join.scale = motion.scale;
    join.scaleSigma = scaleSigma(motion, fit);
    double square = 0;
    for (const Common& tag : fit) {
        join.numbers.push_back(tag.own.number);
        square += std::pow(missM(motion, tag), 2) / static_cast<double>(fit.size());
    }
    join.misfitM = std::sqrt(square);
    for (const Common& tag : tags) {
        if (!fits(motion, tag)) {
            join.moved.push_back(tag.own.number);
        }
    }
    return join;
}

} // namespace spherewalk::align
