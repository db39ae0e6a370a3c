// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/place/seen_depth.h"

#include "spherewalk/geometry/equirect.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace spherewalk::place {

namespace {

constexpr float kNoisePx = 0.5F;   ///< of parallax, standard deviation
constexpr float kMostJump = 1.08F; ///< of 1 / distance within one surface, as views take it
constexpr double kLeastBaselineM = 0.05;
constexpr std::size_t kNeighbours = 6;
constexpr float kHereM = 0.05F;         ///< a point as near to a surface belongs to it
constexpr float kLikelyBeyondM = 0.15F; ///< farther than this from a depth that is not sure it does not
constexpr int kLikelyPhotos = 2;        ///< that are not sure and make a point occupied
constexpr float kOutsideM = 0.15F;      ///< from a wall along the ray, beside two standard deviations
constexpr int kMirrorPhotos = 3;        ///< that show something outside and make a point a mirror's
constexpr double kFloorM = 0.05;        ///< from the floor, beside two standard deviations
constexpr float kPi = std::numbers::pi_v<float>;

/// Whether a photo shows the floor in a point's direction.
bool isFloor(const SeenDepth& photo, const Eigen::Vector3d& pInRoom, const Sight& sight,
             std::optional<double> floorM) {
    const double z = photo.roomFromPhoto().translation.z();
    const double seenZ = z + (pInRoom.z() - z) * static_cast<double>(sight.rangeM / sight.pointM);
    return floorM.has_value() && std::abs(seenZ - *floorM) < kFloorM + 2 * photo.sigmaM(sight.rangeM);
}

} // namespace

SeenDepth::SeenDepth(const render::DepthMap& depth, const Rigid3& roomFromPhoto, const LensPair& lenses,
                     double baselineM, const render::RoomShape* room)
    : m_steps(depth.width(), depth.height()),
      m_roomFromPhoto(roomFromPhoto),
      m_photoFromRoom(roomFromPhoto.inverse()),
      m_lenses(lenses),
      m_sigmaPerM(kNoisePx * 2 * kPi / static_cast<float>(depth.width()) / static_cast<float>(baselineM) +
                  static_cast<float>(render::DepthMap::kStepPerM / std::sqrt(12.0))) {
    const std::span<const float> inverse = depth.inverseM().values();
    const std::span<const std::uint8_t> sure = depth.sure().values();
    for (std::size_t i = 0; i < inverse.size(); ++i) {
        const auto steps = std::lround(static_cast<double>(inverse[i]) / render::DepthMap::kStepPerM);
        m_steps.values()[i] = static_cast<std::uint16_t>(steps | (sure[i] != 0 ? kSure : 0));
    }
    if (room != nullptr && contains(room->outline, roomFromPhoto.translation.head<2>())) {
        dropOutside(*room);
    }
}

void SeenDepth::dropOutside(const render::RoomShape& room) {
    for (int y = 0; y < height(); ++y) {
        for (int x = 0; x < width(); ++x) {
            const Eigen::Vector3d ray = direction(EquirectSize{width(), height()}, Eigen::Vector2d(x, y));
            const Eigen::Vector3d from = m_roomFromPhoto * m_lenses.place(ray);
            const double wallM = 1 / render::inverseDistance(room, from, m_roomFromPhoto.rotation * ray);
            std::uint16_t& steps = *m_steps.at(x, y);
            const float range =
                1 / (static_cast<float>(steps & ~kSure) * static_cast<float>(render::DepthMap::kStepPerM));
            steps = range > wallM + kOutsideM + 2 * sigmaM(range) ? std::uint16_t{0} : steps;
        }
    }
}

Eigen::Vector3d SeenDepth::directionTo(const Eigen::Vector3d& pInRoom) const {
    return m_lenses.directionTo(m_photoFromRoom * pInRoom);
}

Sight SeenDepth::sight(const Eigen::Vector3d& pInRoom) const {
    const Eigen::Vector3f d = directionTo(pInRoom).cast<float>();
    const float u = (kPi - std::atan2(d.y(), d.x())) * static_cast<float>(width()) / (2 * kPi) - 0.5F;
    const float v =
        (kPi / 2 - std::atan2(d.z(), d.head<2>().norm())) * static_cast<float>(height()) / kPi - 0.5F;
    const float left = std::floor(u);
    const float top = std::clamp(std::floor(v), 0.0F, static_cast<float>(height() - 2));
    const float x = u - left;
    const float y = std::clamp(v - top, 0.0F, 1.0F);
    const int x0 = (static_cast<int>(left) + width()) % width();
    const int x1 = (x0 + 1) % width();
    const int y0 = static_cast<int>(top);
    const std::array pixels = {*m_steps.at(x0, y0), *m_steps.at(x1, y0), *m_steps.at(x0, y0 + 1),
                               *m_steps.at(x1, y0 + 1)};
    const auto steps = [&](std::size_t i) { return static_cast<float>(pixels[i] & ~kSure); };
    const auto [least, most] = std::minmax({steps(0), steps(1), steps(2), steps(3)});
    Sight sight{d.norm(), 0, (pixels[0] & pixels[1] & pixels[2] & pixels[3] & kSure) != 0};
    float inverse = (steps(0) * (1 - x) + steps(1) * x) * (1 - y) + (steps(2) * (1 - x) + steps(3) * x) * y;
    if (most > kMostJump * least) {
        const std::size_t nearest = (x < 0.5F ? 0U : 1U) + (y < 0.5F ? 0U : 2U);
        inverse = steps(nearest);
        sight.isSure = (pixels[nearest] & kSure) != 0;
        sight.isEdge = true;
    }
    sight.rangeM = inverse > 0 ? 1 / (inverse * static_cast<float>(render::DepthMap::kStepPerM)) : 0;
    return sight;
}

float SeenDepth::rangeM(int x, int y) const {
    const std::uint16_t steps = *m_steps.at(x, y);
    return (steps & kSure) == 0
               ? 0
               : 1 / (static_cast<float>(steps & ~kSure) * static_cast<float>(render::DepthMap::kStepPerM));
}

Eigen::Vector3d SeenDepth::point(int x, int y, double rangeM) const {
    const Eigen::Vector3d ray = direction(EquirectSize{width(), height()}, Eigen::Vector2d(x, y));
    return m_roomFromPhoto * (m_lenses.place(ray) + rangeM * ray);
}

Space spaceAt(std::span<const SeenDepth> photos, const Eigen::Vector3d& pInRoom, float marginM,
              std::optional<double> mirroredFloorM) {
    int surelyThrough = 0;
    int through = 0;
    int here = 0;
    int outside = 0;
    for (const SeenDepth& photo : photos) {
        const Sight sight = photo.sight(pInRoom);
        if (sight.isEdge) {
            continue;
        }
        const float sigma = photo.sigmaM(sight.rangeM);
        const float beyondM = sight.rangeM - sight.pointM;
        const bool isThrough = beyondM > marginM + 2 * sigma;
        if (sight.isOutside() || (isThrough && isFloor(photo, pInRoom, sight, mirroredFloorM))) {
            ++outside;
        } else if (sight.isSure && isThrough) {
            ++surelyThrough;
        } else {
            through += beyondM > kLikelyBeyondM ? 1 : 0;
            here += std::abs(beyondM) < kHereM ? 1 : 0;
        }
    }
    if (outside >= kMirrorPhotos && surelyThrough <= outside) {
        return Space::Mirror;
    }
    if (surelyThrough > 0 || through > here) {
        return Space::Free;
    }
    return here >= kLikelyPhotos ? Space::Occupied : Space::Unknown;
}

bool isSeenThrough(std::span<const SeenDepth> photos, const Eigen::Vector3d& pInRoom) {
    return std::any_of(photos.begin(), photos.end(), [&](const SeenDepth& photo) {
        const Sight sight = photo.sight(pInRoom);
        return sight.isSure && !sight.isOutside() &&
               sight.rangeM - sight.pointM > 2 * photo.sigmaM(sight.rangeM);
    });
}

std::vector<double> baselinesM(std::span<const Rigid3> roomFromPhotos) {
    std::vector<double> result;
    for (const Rigid3& photo : roomFromPhotos) {
        std::vector<double> distances;
        for (const Rigid3& other : roomFromPhotos) {
            const double distance = (other.translation - photo.translation).norm();
            if (distance >= kLeastBaselineM) {
                distances.push_back(distance);
            }
        }
        const std::size_t count = std::min(kNeighbours, distances.size());
        std::partial_sort(distances.begin(), distances.begin() + static_cast<std::ptrdiff_t>(count),
                          distances.end());
        double sum = 0;
        for (std::size_t i = 0; i < count; ++i) {
            sum += distances[i];
        }
        result.push_back(count > 0 ? sum / static_cast<double>(count) : 0);
    }
    return result;
}

} // namespace spherewalk::place
