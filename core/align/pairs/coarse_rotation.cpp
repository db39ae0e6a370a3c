// SPDX-License-Identifier: GPL-3.0-or-later
#include "pairs/nearest.h"
#include "pairs/pair_geometry.h"

#include "spherewalk/align/match_pairs.h"
#include "spherewalk/base/fixed_random.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::align {

namespace {

constexpr double kVoteReachRad = 0.35;      ///< Parallax may move a vote by this much: 20 degrees.
constexpr double kAnotherRotationRad = 1.0; ///< Two rotations farther apart than this are different answers.
constexpr double kLeastLead = 2;            ///< Least ratio of the votes to the rival's votes.
constexpr int kMostTrials = 1000;

struct BearingVote {
    Eigen::Vector3d inA;
    Eigen::Vector3d inB;
};

/// The rotation that turns b's two bearings best onto a's. Empty if the bearings are too near to each other,
/// or if they make another angle in a than in b.
std::optional<Eigen::Quaterniond> rotationOf(const BearingVote& first, const BearingVote& second) {
    const auto frame = [](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
        Eigen::Matrix3d axes;
        axes.col(0) = (p + q).normalized();
        axes.col(1) = p.cross(q).normalized();
        axes.col(2) = axes.col(0).cross(axes.col(1));
        return axes;
    };
    const double cosA = first.inA.dot(second.inA);
    const double cosB = first.inB.dot(second.inB);
    if (std::abs(cosA) > 0.9 || std::abs(cosB) > 0.9 ||
        std::abs(std::acos(cosA) - std::acos(cosB)) > 2 * kVoteReachRad) {
        return std::nullopt;
    }
    return Eigen::Quaterniond(frame(first.inA, second.inA) * frame(first.inB, second.inB).transpose());
}

bool isFor(const Eigen::Matrix3d& aFromB, const BearingVote& vote) {
    return vote.inA.dot(aFromB * vote.inB) > std::cos(kVoteReachRad);
}

int votesFor(const Eigen::Quaterniond& aFromB, const std::vector<BearingVote>& votes) {
    const Eigen::Matrix3d rotation = aFromB.toRotationMatrix();
    return static_cast<int>(std::count_if(votes.begin(), votes.end(),
                                          [&](const BearingVote& vote) { return isFor(rotation, vote); }));
}

/// The rotation that fits the bearings of its voters best.
Eigen::Quaterniond centred(const Eigen::Quaterniond& aFromB, const std::vector<BearingVote>& votes) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    const Eigen::Matrix3d rotation = aFromB.toRotationMatrix();
    for (const BearingVote& vote : votes) {
        if (isFor(rotation, vote)) {
            sum += vote.inA * vote.inB.transpose();
        }
    }
    return Eigen::Quaterniond(bestRotation(sum));
}

/// The pairs of votes that are tried: all if they are few, else a fixed choice.
std::vector<std::pair<std::size_t, std::size_t>> trials(std::size_t count) {
    std::vector<std::pair<std::size_t, std::size_t>> result;
    if (count < 2 || count * (count - 1) / 2 <= kMostTrials) {
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t j = i + 1; j < count; ++j) {
                result.emplace_back(i, j);
            }
        }
        return result;
    }
    FixedRandom random(1);
    while (result.size() < kMostTrials) {
        const std::size_t i = random.below(count);
        const std::size_t j = random.below(count);
        if (i != j) {
            result.emplace_back(i, j);
        }
    }
    return result;
}

} // namespace

std::optional<CoarseRotation> coarseRotation(const Features& a, const Features& b,
                                             const MatchOptions& options) {
    std::vector<BearingVote> votes;
    Search search;
    search.most = options.firstLook;
    search.mostRatio = options.mostRatio;
    for (const auto& [i, j] : mutualNearest(a, b, search)) {
        votes.push_back({a.bearings[static_cast<std::size_t>(i)].cast<double>(),
                         b.bearings[static_cast<std::size_t>(j)].cast<double>()});
    }
    std::vector<Eigen::Quaterniond> tried;
    CoarseRotation best;
    for (const auto& [i, j] : trials(votes.size())) {
        if (const auto rotation = rotationOf(votes[i], votes[j])) {
            tried.push_back(*rotation);
            const int count = votesFor(*rotation, votes);
            if (count > best.votes) {
                best.votes = count;
                best.aFromB = *rotation;
            }
        }
    }
    // Bearings near the axis between two rotations vote for both, so they decide nothing.
    std::vector<BearingVote> others = votes;
    std::erase_if(others,
                  [&](const BearingVote& vote) { return isFor(best.aFromB.toRotationMatrix(), vote); });
    for (const Eigen::Quaterniond& rotation : tried) {
        if (rotation.angularDistance(best.aFromB) > kAnotherRotationRad) {
            best.rivalVotes = std::max(best.rivalVotes, votesFor(rotation, others));
        }
    }
    if (best.votes < options.leastVotes || best.votes < kLeastLead * best.rivalVotes) {
        return std::nullopt;
    }
    best.aFromB = centred(best.aFromB, votes);
    return best;
}

} // namespace spherewalk::align
