// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/scene/carried.h"

#include "sweep_cost.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/render/scene_depth.h"
#include "spherewalk/scene/exposure.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace spherewalk::scene {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::size_t kFewestPhotos = 6;
constexpr std::size_t kMostPhotos = 24;
constexpr double kLeastSpreadM = 0.1; ///< Of the photos across the line that they are nearest to.
constexpr double kStepRad = 1.4 * kPi / 180;
constexpr int kSteps = 78; ///< To 20 degrees above the horizon.
/// The least change of brightness from one step to the next that is an edge: of its logarithm.
constexpr float kEdge = 0.04F;
constexpr double kAgreeing = 0.7;   ///< Share of the photos that show a carried edge.
constexpr float kDeviation = 0.5F;  ///< Share of the edge by which such a photo may differ.
constexpr int kMostOfRoom = 4;      ///< Steps of the room's own edges that end what is carried.
constexpr int kMostAlike = 11;      ///< Steps without any edge that end it.
constexpr int kMostAlikeBelow = 32; ///< The same straight below the lens.
constexpr float kSpread = 0.08F; ///< Of the logarithm of brightness, from which photos show different things.
constexpr std::size_t kFewestAzimuths = 10; ///< With an edge; fewer come by chance.
constexpr double kMarginRad = 2.1 * kPi / 180;
constexpr double kFadeRad = 1.0 * kPi / 180;
constexpr std::size_t kSmoothing = 2;      ///< Azimuths to either side that count.
constexpr std::size_t kDent = 7;           ///< The same for dents, of which this is half the width.
constexpr double kLeastShare = 0.001;      ///< Of the sphere; less is not worth a new picture.
constexpr double kLowestWithoutWalls = 15; ///< Degrees below the horizon.
constexpr std::size_t kColours = 3;        ///< Photos that give the colour of a place.

/// The colour in a direction.
Eigen::Vector3f colourAt(const RgbImage& picture, const Eigen::Vector3d& way) {
    const Eigen::Vector2d at = pixel({picture.width(), picture.height()}, way);
    Eigen::Vector3f colour;
    sampleColour(picture, static_cast<float>(at.x() < 0 ? at.x() + picture.width() : at.x()),
                 static_cast<float>(std::max(0.0, at.y())), colour.data());
    return colour;
}

/// Slopes are of the logarithm, so that the exposure does not count.
float logBrightness(const RgbImage& picture, const Eigen::Vector3d& way) {
    return std::log(colourAt(picture, way).dot(Eigen::Vector3f(0.299F, 0.587F, 0.114F)) + 16);
}

/// The direction at an angle from straight down.
Eigen::Vector3d fromBelow(double azimuth, double angle) {
    return {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), -std::cos(angle)};
}

double azimuthOf(int index) {
    return -kPi + 2 * kPi * (index + 0.5) / CarriedThings::kAzimuths;
}

/// The change of brightness over a step away from straight down, and over one along the azimuth.
Eigen::Vector2f slopes(const RgbImage& picture, double azimuth, double angle) {
    const Eigen::Vector3d way = fromBelow(azimuth, angle);
    const Eigen::Vector3d away = kStepRad / 2 * fromBelow(azimuth, angle + kPi / 2);
    const Eigen::Vector3d along = kStepRad / 2 * Eigen::Vector3d(-std::sin(azimuth), std::cos(azimuth), 0);
    return {logBrightness(picture, way + away) - logBrightness(picture, way - away),
            logBrightness(picture, way + along) - logBrightness(picture, way - along)};
}

enum class Shown {
    Alike,   ///< All photos show the same, without an edge.
    Carried, ///< An edge at the same place in most photos.
    Room,    ///< What differs from photo to photo.
};

/// How far up all photos are alike at an azimuth.
struct Reach {
    bool hasEdge = false; ///< Whether an edge is carried along.
    bool isKnown = false; ///< Whether it is known where the room begins.
    float angle = 0;
};

using Reaches = std::array<Reach, CarriedThings::kAzimuths>;

/// The angles of all azimuths; all are 0 if hardly any edge is carried along. Where it is not known where the
/// room begins, what is carried is taken to go on as it does beside.
std::array<float, CarriedThings::kAzimuths> completed(const Reaches& reaches) {
    constexpr auto kAll = static_cast<std::size_t>(CarriedThings::kAzimuths);
    std::array<float, kAll> angles{};
    const auto withEdge = static_cast<std::size_t>(
        std::count_if(reaches.begin(), reaches.end(), [](const Reach& reach) { return reach.hasEdge; }));
    if (withEdge < kFewestAzimuths) {
        return angles;
    }
    for (std::size_t i = 0; i < kAll; ++i) {
        std::size_t before = 0;
        std::size_t after = 0;
        while (!reaches[(i + kAll - before) % kAll].isKnown) {
            ++before;
        }
        while (!reaches[(i + after) % kAll].isKnown) {
            ++after;
        }
        const float share =
            before + after == 0 ? 0 : static_cast<float>(before) / static_cast<float>(before + after);
        angles[i] = (1 - share) * reaches[(i + kAll - before) % kAll].angle +
                    share * reaches[(i + after) % kAll].angle;
    }
    return angles;
}

/// Compares what photos show below.
class Comparison {
  public:
    explicit Comparison(std::vector<PosedPicture> photos)
        : m_photos(std::move(photos)), m_brighter(m_photos.size()) {
        std::vector<std::vector<float>> differences(m_photos.size());
        for (int azimuth = 0; azimuth < CarriedThings::kAzimuths; azimuth += 4) {
            for (int step = 0; step < kStepsForExposure; ++step) {
                const std::vector<float> all =
                    brightness(fromBelow(azimuthOf(azimuth), (step + 0.5) * kStepRad));
                const float median = spherewalk::median(all);
                for (std::size_t i = 0; i < all.size(); ++i) {
                    differences[i].push_back(all[i] - median);
                }
            }
        }
        for (std::size_t i = 0; i < m_photos.size(); ++i) {
            m_brighter[i] = quantileInPlace(differences[i], 0.5);
        }
    }

    /// How far what is carried along reaches.
    Reach reach(double azimuth) const {
        int last = -1; // the last step that is carried along
        int firstOfRoom = 0;
        int ofRoom = 0;
        for (int step = 0; step < kSteps && ofRoom <= kMostOfRoom; ++step) {
            if (step - last - 1 > (last < 0 ? kMostAlikeBelow : kMostAlike)) {
                break;
            }
            const Shown shown = shownAt(azimuth, (step + 0.5) * kStepRad);
            if (shown == Shown::Carried) {
                last = step;
                ofRoom = 0;
            } else if (shown == Shown::Room) {
                firstOfRoom = ofRoom == 0 ? step : firstOfRoom;
                ++ofRoom;
            }
        }
        // What is alike up to where the room begins may be carried along, too.
        const bool endsAtRoom = ofRoom > kMostOfRoom;
        const int end = endsAtRoom ? std::max(last + 1, firstOfRoom) : last + 1;
        return {last >= 0, last >= 0 || endsAtRoom, static_cast<float>(end * kStepRad)};
    }

  private:
    static constexpr int kStepsForExposure = 10; ///< What is carried along is there.

    std::vector<float> brightness(const Eigen::Vector3d& way) const {
        std::vector<float> all;
        for (std::size_t i = 0; i < m_photos.size(); ++i) {
            all.push_back(logBrightness(*m_photos[i].picture, way) - m_brighter[i]);
        }
        return all;
    }

    Shown shownAt(double azimuth, double angle) const {
        std::vector<Eigen::Vector2f> all;
        std::array<std::vector<float>, 3> parts;
        for (const PosedPicture& photo : m_photos) {
            all.push_back(slopes(*photo.picture, azimuth, angle));
            parts[0].push_back(all.back().x());
            parts[1].push_back(all.back().y());
            parts[2].push_back(all.back().norm());
        }
        const Eigen::Vector2f usual(quantileInPlace(parts[0], 0.5), quantileInPlace(parts[1], 0.5));
        const auto alike = std::count_if(all.begin(), all.end(), [&](const Eigen::Vector2f& slope) {
            return (slope - usual).norm() < kDeviation * usual.norm();
        });
        if (usual.norm() > kEdge &&
            static_cast<double>(alike) >= kAgreeing * static_cast<double>(all.size())) {
            return Shown::Carried;
        }
        const float spread = medianAndSpread(brightness(fromBelow(azimuth, angle))).sigma;
        return spread > kSpread || quantileInPlace(parts[2], 0.5) > kEdge ? Shown::Room : Shown::Alike;
    }

    std::vector<PosedPicture> m_photos;
    std::vector<float> m_brighter; ///< By how much a photo is brighter than most: of the logarithm.
};

/// Whether the photos stand in one line, or all at one place.
bool areInLine(std::span<const PosedPicture> photos) {
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const PosedPicture& photo : photos) {
        mean += photo.roomFromPhoto.translation.head<2>() / static_cast<double>(photos.size());
    }
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const PosedPicture& photo : photos) {
        const Eigen::Vector2d offset = photo.roomFromPhoto.translation.head<2>() - mean;
        spread += offset * offset.transpose() / static_cast<double>(photos.size());
    }
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvalues()[0] <
           kLeastSpreadM * kLeastSpreadM;
}

/// The quantile of each angle and so many to either side.
std::array<float, CarriedThings::kAzimuths>
quantilesAbout(const std::array<float, CarriedThings::kAzimuths>& of, std::size_t reach, double share) {
    constexpr auto kAll = static_cast<std::size_t>(CarriedThings::kAzimuths);
    std::array<float, kAll> result{};
    for (std::size_t i = 0; i < kAll; ++i) {
        std::vector<float> beside;
        for (std::size_t k = kAll - reach; k <= kAll + reach; ++k) {
            beside.push_back(of[(i + k) % kAll]);
        }
        result[i] = quantileInPlace(beside, share);
    }
    return result;
}

/// The median, so that no single edge makes a spike. Then narrow dents are closed, where the floor happens to
/// look like the cart. At last the greatest of those beside, so that no corner looks out.
std::array<float, CarriedThings::kAzimuths>
smoothed(const std::array<float, CarriedThings::kAzimuths>& from) {
    const auto closed =
        quantilesAbout(quantilesAbout(quantilesAbout(from, kSmoothing, 0.5), kDent, 1), kDent, 0);
    return quantilesAbout(closed, kSmoothing, 1);
}

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
        static const double kLowest = -std::sin(kLowestWithoutWalls * kPi / 180);
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

/// Another photo, as bright as the one that is filled.
struct Helper {
    const RgbImage* picture;
    Eigen::Quaterniond photoFromRoom;
    Eigen::Vector3d position;
    Gains gains;
};

std::vector<Helper> helpers(const PosedPicture& photo, std::span<const PosedPicture> others,
                            const RoomSurface& room) {
    const std::vector<Gains> gains = gainsTo(photo, inverseTo(room, photo.roomFromPhoto), others);
    std::vector<Helper> result;
    for (std::size_t i = 0; i < others.size(); ++i) {
        result.push_back({others[i].picture, others[i].roomFromPhoto.rotation.conjugate(),
                          others[i].roomFromPhoto.translation, gains[i]});
    }
    return result;
}

/// The colour of a place by the photos that see it; nothing if none does.
std::optional<Eigen::Vector3f> colourOf(const Eigen::Vector3d& place, std::span<const Helper> all,
                                        const CarriedThings& things, const RoomSurface& room) {
    std::array<std::pair<double, std::size_t>, kColours> nearest;
    nearest.fill({HUGE_VAL, 0});
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Eigen::Vector3d way = place - all[i].position;
        if (way.squaredNorm() < nearest.back().first &&
            !(things.depthInside(all[i].photoFromRoom * way) > 0) && room.isInSight(all[i].position, place)) {
            nearest.back() = {way.squaredNorm(), i};
            std::sort(nearest.begin(), nearest.end());
        }
    }
    std::array<std::vector<float>, 3> values;
    for (const auto& [distance, i] : nearest) {
        if (std::isfinite(distance)) {
            const Helper& helper = all[i];
            const Eigen::Vector3f colour =
                colourAt(*helper.picture, helper.photoFromRoom * (place - helper.position));
            for (std::size_t c = 0; c < 3; ++c) {
                values[c].push_back(std::min(255.0F, helper.gains[c] * colour[static_cast<int>(c)]));
            }
        }
    }
    if (values[0].empty()) {
        return std::nullopt;
    }
    return Eigen::Vector3f(quantileInPlace(values[0], 0.5), quantileInPlace(values[1], 0.5),
                           quantileInPlace(values[2], 0.5));
}

} // namespace

bool CarriedThings::empty() const {
    return std::all_of(m_reachRad.begin(), m_reachRad.end(), [](float reach) { return reach <= 0; });
}

double CarriedThings::share() const {
    double sum = 0;
    for (const float reach : m_reachRad) {
        sum += (1 - std::cos(reach)) / 2;
    }
    return sum / kAzimuths;
}

double CarriedThings::depthInside(const Eigen::Vector3d& pInPhoto) const {
    const double azimuth = std::atan2(pInPhoto.y(), pInPhoto.x());
    const double angle = std::atan2(pInPhoto.head<2>().norm(), -pInPhoto.z());
    const double at = (azimuth + kPi) / (2 * kPi) * kAzimuths - 0.5 + kAzimuths;
    const auto before = static_cast<std::size_t>(std::floor(at));
    const double share = at - std::floor(at);
    return (1 - share) * m_reachRad[before % kAzimuths] + share * m_reachRad[(before + 1) % kAzimuths] -
           angle;
}

CarriedThings carriedThings(std::span<const PosedPicture> photos) {
    for (const PosedPicture& photo : photos) {
        if (photo.picture == nullptr || photo.picture->empty()) {
            throw Error(ErrorKind::InvalidInput,
                        "Could not look for what the camera carries along: a picture is empty.");
        }
    }
    if (photos.size() < kFewestPhotos || areInLine(photos)) {
        return {};
    }
    const Comparison comparison(spreadEvenly(std::vector(photos.begin(), photos.end()), kMostPhotos));
    Reaches reaches;
    for (int i = 0; i < CarriedThings::kAzimuths; ++i) {
        reaches[static_cast<std::size_t>(i)] = comparison.reach(azimuthOf(i));
    }
    std::array<float, CarriedThings::kAzimuths> reach = smoothed(completed(reaches));
    for (float& angle : reach) {
        angle += angle > 0 ? static_cast<float>(kMarginRad) : 0.0F;
    }
    const CarriedThings found(reach);
    return found.share() < kLeastShare ? CarriedThings() : found;
}

FilledPicture withoutCarried(const PosedPicture& photo, std::span<const PosedPicture> others,
                             const CarriedThings& things, const survey::Room& room) {
    const EquirectSize size{photo.picture->width(), photo.picture->height()};
    FilledPicture result{*photo.picture, MaskImage(size.width, size.height)};
    const RoomSurface surface(room);
    const std::vector<Helper> all = helpers(photo, others, surface);
    const double most = *std::max_element(things.reachRad().begin(), things.reachRad().end());
    const int first = std::max(0, static_cast<int>(size.height * (1 - most / kPi)) - 1);
    for (int y = things.empty() ? size.height : first; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const Eigen::Vector3d way = direction(size, Eigen::Vector2d(x, y));
            const double inside = things.depthInside(way);
            const auto place = inside > 0 ? surface.placeOn(photo.roomFromPhoto.translation,
                                                            photo.roomFromPhoto.rotation * way)
                                          : std::nullopt;
            const auto colour = place ? colourOf(*place, all, things, surface) : std::nullopt;
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
