// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/statistics.h"
#include "spherewalk/jobs/align_survey.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace spherewalk::jobs {

namespace {

/// A photo that was moved farther from its tag than this was not where its tag says.
constexpr double kMovedSigmas = 5;
/// Of fewer photos, nobody can say which of them move together.
constexpr std::size_t kLeastTogether = 5;

/// Where photos are tagged and where they were solved, along the floor.
struct Places {
    std::vector<Eigen::Vector2d> tagged;
    std::vector<Eigen::Vector2d> solved;
};

/// A turn and a shift along the floor.
struct FloorMotion {
    Eigen::Rotation2Dd turn{0};
    Eigen::Vector2d shift = Eigen::Vector2d::Zero();
};

std::vector<double> offsets(const Places& places, const FloorMotion& motion) {
    std::vector<double> metres;
    for (std::size_t i = 0; i < places.tagged.size(); ++i) {
        metres.push_back((places.solved[i] - (motion.turn * places.tagged[i] + motion.shift)).norm());
    }
    return metres;
}

/// The motion that brings two tags as near to their solved places as can be; nothing if they lie together.
std::optional<FloorMotion> motionOfTwo(const Places& places, std::size_t a, std::size_t b) {
    const Eigen::Vector2d tagged = places.tagged[b] - places.tagged[a];
    const Eigen::Vector2d solved = places.solved[b] - places.solved[a];
    constexpr double kTogetherM = 0.02;
    if (tagged.norm() < kTogetherM || solved.norm() < kTogetherM) {
        return std::nullopt;
    }
    FloorMotion motion;
    motion.turn =
        Eigen::Rotation2Dd(std::atan2(tagged.x() * solved.y() - tagged.y() * solved.x(), tagged.dot(solved)));
    motion.shift =
        (places.solved[a] + places.solved[b] - motion.turn * (places.tagged[a] + places.tagged[b])) / 2;
    return motion;
}

/// How far each photo was moved besides what more than half of them have in common. A wrong tag pulls at all
/// photos together, and that must not hide it.
std::vector<double> ownMoves(const Places& places) {
    std::vector<double> best = offsets(places, {});
    const std::size_t count = best.size();
    if (count < kLeastTogether) {
        return best;
    }
    double bestMedian = median(best);
    constexpr std::size_t kMostPairs = 2000;
    const std::size_t step = std::max<std::size_t>(1, count * (count - 1) / 2 / kMostPairs);
    for (std::size_t pair = 0, a = 0; a < count; ++a) {
        for (std::size_t b = a + 1; b < count; ++b, ++pair) {
            const auto motion = pair % step == 0 ? motionOfTwo(places, a, b) : std::nullopt;
            if (!motion) {
                continue;
            }
            std::vector<double> own = offsets(places, *motion);
            if (const double usual = median(own); usual < bestMedian) {
                bestMedian = usual;
                best = std::move(own);
            }
        }
    }
    return best;
}

} // namespace

std::vector<PhotoMove> movedPhotos(std::span<const align::PhotoPrior> tagged,
                                   const align::Alignment& alignment) {
    std::map<int, std::vector<std::size_t>> parts;
    for (std::size_t i = 0; i < tagged.size(); ++i) {
        if (alignment.photos[i].isSolved) {
            parts[alignment.photos[i].component].push_back(i);
        }
    }
    std::vector<PhotoMove> moves;
    std::vector<double> metres;
    for (const auto& [component, photos] : parts) {
        Places places;
        for (const std::size_t photo : photos) {
            places.tagged.emplace_back(tagged[photo].positionM.head<2>());
            places.solved.emplace_back(alignment.photos[photo].roomFromPhoto.translation.head<2>());
        }
        const std::vector<double> own = ownMoves(places);
        for (std::size_t i = 0; i < photos.size(); ++i) {
            moves.push_back({photos[i], own[i]});
        }
        metres.insert(metres.end(), own.begin(), own.end());
    }
    // Of a length in two dimensions the median is 1.18 standard deviations along either axis.
    const double usualM = metres.empty() ? 0 : median(std::move(metres)) / 1.18;
    std::erase_if(moves, [&](const PhotoMove& moved) {
        return moved.byM <= kMovedSigmas * std::max(usualM, tagged[moved.photo].positionSigmaM);
    });
    std::ranges::sort(moves, {}, &PhotoMove::photo);
    return moves;
}

} // namespace spherewalk::jobs
