// SPDX-License-Identifier: GPL-3.0-or-later
#include "polar_map.h"

#include "spherewalk/base/statistics.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/render/scene_depth.h"
#include "spherewalk/scene/exposure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace spherewalk::scene {

namespace {

constexpr double kFadeRad = 1.0 * std::numbers::pi / 180;
constexpr double kLowestWithoutWalls = 15; ///< Degrees below the horizon.
constexpr double kFullBesideRad =
    8 * std::numbers::pi / 180; ///< Beside what it carries along a photo counts in full.

/// The place of the room in a direction of the photo; nothing where the room is not known.
class RoomSurface {
  public:
    explicit RoomSurface(const survey::Room& room) {
        if (room.outline.size() >= 3 && room.ceilingM > 0) {
            m_shape = {room.outline, 0, room.ceilingM};
        }
    }

    /// Whether no wall stands between a point and a place of the room.
    bool isInSight(const Eigen::Vector3d& from, const Eigen::Vector3d& place) const {
        constexpr double kNearer = 1.05;
        return !m_shape ||
               render::inverseDistance(*m_shape, from, place - from) * (place - from).norm() < kNearer;
    }

    /// 1 / the distance in a direction; 0 where the room is not known.
    double inverseM(const Eigen::Vector3d& from, const Eigen::Vector3d& way) const {
        static const double kLowest = -std::sin(kLowestWithoutWalls * std::numbers::pi / 180);
        return m_shape             ? render::inverseDistance(*m_shape, from, way)
               : way.z() < kLowest ? -way.z() / from.z()
                                   : 0;
    }

    std::optional<Eigen::Vector3d> placeOn(const Eigen::Vector3d& from, const Eigen::Vector3d& way) const {
        const double inverse = inverseM(from, way);
        return inverse > 0 ? std::optional<Eigen::Vector3d>(from + way / inverse) : std::nullopt;
    }

  private:
    std::optional<render::RoomShape> m_shape;
};

/// 1 / the distance of the room in each direction of a photo; next to nothing where the room is not known.
Image<float, 1> inverseTo(const RoomSurface& room, const Rigid3& roomFromPhoto) {
    constexpr EquirectSize kSize{128, 64};
    constexpr double kLeast = 1e-3;
    Image<float, 1> inverse(kSize.width, kSize.height);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            const Eigen::Vector3d way = roomFromPhoto.rotation * direction(kSize, Eigen::Vector2d(x, y));
            *inverse.at(x, y) =
                static_cast<float>(std::max(kLeast, room.inverseM(roomFromPhoto.translation, way)));
        }
    }
    return inverse;
}

/// Gains in directions of a photo.
using GainMap = PolarMap<Eigen::Vector3f>;

/// A direction of a photo between the azimuths and steps of such a map.
class PolarPlace {
  public:
    explicit PolarPlace(const Eigen::Vector3d& way) {
        const double turn = indexOf(std::atan2(way.y(), way.x()));
        const double up = std::atan2(way.head<2>().norm(), -way.z()) / kPolarStepRad - 0.5;
        const double step = std::clamp(up, 0.0, kPolarSteps - 1.001);
        m_azimuth = static_cast<int>(std::floor(turn));
        m_step = static_cast<int>(step);
        m_across = static_cast<float>(turn - m_azimuth);
        m_up = static_cast<float>(step - m_step);
    }

    Eigen::Vector3f in(const GainMap& map) const {
        const auto across = [&](int step) -> Eigen::Vector3f {
            return (1 - m_across) * map.at(m_azimuth, step) + m_across * map.at(m_azimuth + 1, step);
        };
        return (1 - m_up) * across(m_step) + m_up * across(m_step + 1);
    }

  private:
    int m_azimuth;
    int m_step;
    float m_across;
    float m_up;
};

/// Another photo that shows places of the room.
struct Helper {
    const RgbImage* picture;
    Eigen::Quaterniond photoFromRoom;
    Eigen::Vector3d position;
    GainMap gains = {}; ///< With them it is as bright as the photo that is filled, by directions of that.

    FastPixel placeOf(const Eigen::Vector3d& pInRoom) const {
        return placeIn(*picture, photoFromRoom * (pInRoom - position));
    }

    /// How far beside what it carries along a place of the picture is: an angle, below 0 within.
    double beside(const FastPixel& at, const CarriedThings& things) const {
        const double pixelRad = 2 * std::numbers::pi / picture->width();
        return -things.depthInside(std::numbers::pi - (at.u + 0.5) * pixelRad,
                                   std::numbers::pi - (at.v + 0.5) * pixelRad);
    }
};

using Ring = std::array<std::vector<Eigen::Vector3f>, kAzimuths>;

/// The logarithms of the factors by which the photo is brighter than a helper, where both show the room
/// beside what is carried along. A glossy floor is bright from one side and dark from another.
Ring factorsBeside(const PosedPicture& photo, const Helper& helper, const CarriedThings& things,
                   const RoomSurface& room) {
    constexpr float kDarkestBeside = 8;
    constexpr float kBrightestBeside = 250;
    Ring ring;
    for (int azimuth = 0; azimuth < kAzimuths; ++azimuth) {
        const auto i = static_cast<std::size_t>(azimuth);
        for (const double besideDeg : {1.0, 2.0, 3.0, 4.5, 6.0}) {
            const Eigen::Vector3d way =
                fromBelow(azimuthOf(azimuth), things.reachRad()[i] + besideDeg * std::numbers::pi / 180);
            const auto place =
                room.placeOn(photo.roomFromPhoto.translation, photo.roomFromPhoto.rotation * way);
            if (!place || !room.isInSight(helper.position, *place) ||
                helper.beside(helper.placeOf(*place), things) <= 0) {
                continue;
            }
            const Eigen::Vector3f own = colourAt(*photo.picture, placeIn(*photo.picture, way));
            const Eigen::Vector3f other = colourAt(*helper.picture, helper.placeOf(*place));
            if (std::min(own.minCoeff(), other.minCoeff()) > kDarkestBeside &&
                std::max(own.maxCoeff(), other.maxCoeff()) < kBrightestBeside) {
                ring[i].push_back((own.array() / other.array()).log());
            }
        }
    }
    return ring;
}

/// The median of what `of` says of the factors of an azimuth and so many to either side; nothing if there are
/// few.
template <class Of>
std::optional<float> medianAbout(const Ring& ring, std::size_t azimuth, std::size_t reach, const Of& of) {
    constexpr std::size_t kFewestFactors = 12;
    std::vector<float> values;
    for (std::size_t k = kAzimuths - reach; k <= kAzimuths + reach; ++k) {
        std::ranges::transform(ring[(azimuth + k) % kAzimuths], std::back_inserter(values), of);
    }
    return values.size() < kFewestFactors ? std::nullopt : std::optional(quantileInPlace(values, 0.5));
}

/// The gains of a helper, from the logarithms of a ring: on the border of what is carried they are those of
/// the ring beside it, and within, means of these of which near ones count most. So nothing ends at the
/// border. usual: what a helper has that shares no place with the photo.
GainMap gainsWithin(const Ring& ring, const CarriedThings& things, const Eigen::Vector3f& usual) {
    constexpr std::size_t kReach = 6;
    constexpr std::size_t kAll = kAzimuths / 2;
    constexpr float kMost = 0.7F; // What differs by more from the rest of the ring is another thing.
    const auto brightness = [](const Eigen::Vector3f& factor) { return factor.mean(); };
    const float middle = medianAbout(ring, 0, kAll, brightness).value_or(usual.mean());
    std::vector<std::pair<Eigen::Vector3f, float>> border; // ways and factors of brightness
    for (std::size_t i = 0; i < ring.size(); ++i) {
        if (const auto gain = medianAbout(ring, i, kReach, brightness)) {
            border.emplace_back(fromBelow(azimuthOf(static_cast<int>(i)), things.reachRad()[i]).cast<float>(),
                                std::clamp(*gain, middle - kMost, middle + kMost));
        }
    }
    Eigen::Vector3f tint = usual.array() - usual.mean();
    for (Eigen::Index c = 0; c < 3; ++c) {
        const auto of = [c](const Eigen::Vector3f& factor) { return factor[c] - factor.mean(); };
        tint[c] = medianAbout(ring, 0, kAll, of).value_or(tint[c]);
    }
    return GainMap([&](int azimuth, int step) -> Eigen::Vector3f {
        constexpr float kNearest = 1e-4F;
        const Eigen::Vector3f way = wayOf(azimuth, step).cast<float>();
        float sum = 0;
        float weights = 0;
        for (const auto& [at, gain] : border) {
            const float squared = (at - way).squaredNorm() + kNearest;
            const float weight = 1 / (squared * std::sqrt(squared));
            sum += weight * gain;
            weights += weight;
        }
        return (tint.array() + (weights > 0 ? sum / weights : middle)).exp();
    });
}

std::vector<Helper> helpers(const PosedPicture& photo, std::span<const PosedPicture> others,
                            const CarriedThings& things, const RoomSurface& room) {
    const std::vector<Gains> gains = gainsTo(photo, inverseTo(room, photo.roomFromPhoto), others);
    std::vector<Helper> result;
    for (std::size_t i = 0; i < others.size(); ++i) {
        result.push_back({others[i].picture, others[i].roomFromPhoto.rotation.conjugate(),
                          others[i].roomFromPhoto.translation});
        result.back().gains = gainsWithin(factorsBeside(photo, result.back(), things, room), things,
                                          Eigen::Vector3f(gains[i].data()).array().log());
    }
    return result;
}

/// The colour of a place by the photos that see it; nothing if none does. Near ones count most, and those
/// that hardly see it beside what they carry along count little, so that no photo's share ends at a line.
/// way: to the place, in the photo that is filled.
std::optional<Eigen::Vector3f> colourOf(const Eigen::Vector3d& place, const Eigen::Vector3d& way,
                                        std::span<const Helper> all, const CarriedThings& things,
                                        const RoomSurface& room) {
    constexpr double kNearestHelperM = 0.01; // a camera on a wall
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    float weights = 0;
    const PolarPlace at(way);
    for (const Helper& helper : all) {
        const FastPixel in = helper.placeOf(place);
        const double beside = helper.beside(in, things);
        if (beside <= 0 || !room.isInSight(helper.position, place)) {
            continue;
        }
        const double squared =
            std::max(kNearestHelperM * kNearestHelperM, (place - helper.position).squaredNorm());
        const auto weight = static_cast<float>(std::min(1.0, beside / kFullBesideRad) / (squared * squared));
        sum.array() += weight * colourAt(*helper.picture, in).array() * at.in(helper.gains).array();
        weights += weight;
    }
    return weights > 0 ? std::optional<Eigen::Vector3f>((sum / weights).cwiseMin(255)) : std::nullopt;
}

} // namespace

FilledPicture withoutCarried(const PosedPicture& photo, std::span<const PosedPicture> others,
                             const CarriedThings& things, const survey::Room& room) {
    const EquirectSize size{photo.picture->width(), photo.picture->height()};
    FilledPicture result{*photo.picture, MaskImage(size.width, size.height)};
    const RoomSurface surface(room);
    const std::vector<Helper> all = helpers(photo, others, things, surface);
    const double most = *std::max_element(things.reachRad().begin(), things.reachRad().end());
    const int first = std::max(0, static_cast<int>(size.height * (1 - most / std::numbers::pi)) - 1);
    for (int y = things.empty() ? size.height : first; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const Eigen::Vector3d way = direction(size, Eigen::Vector2d(x, y));
            const double inside = things.depthInside(way);
            const auto place = inside > 0 ? surface.placeOn(photo.roomFromPhoto.translation,
                                                            photo.roomFromPhoto.rotation * way)
                                          : std::nullopt;
            const auto colour = place ? colourOf(*place, way, all, things, surface) : std::nullopt;
            if (!colour) {
                continue;
            }
            const auto share = static_cast<float>(std::min(1.0, inside / kFadeRad));
            for (int c = 0; c < RgbImage::kChannels; ++c) {
                std::uint8_t& value = result.picture.at(x, y)[c];
                value = static_cast<std::uint8_t>(
                    nearestInt((1 - share) * static_cast<float>(value) + share * (*colour)[c]));
            }
            *result.filled.at(x, y) = 255;
        }
    }
    return result;
}

} // namespace spherewalk::scene
