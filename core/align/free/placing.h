// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "graph/pose_graph.h"
#include "solve/pair_normal.h"

#include "spherewalk/align/agreeing_parts.h"
#include "spherewalk/align/free_places.h"
#include "spherewalk/align/photo_pair.h"
#include "spherewalk/base/image.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/polygon.h"

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

// The steps that place photos without positions: first places, adjustment, and the frame of the room.
namespace spherewalk::align {

/// How two photos of a component stand to each other. Frames: the component's.
struct Leg {
    int a = 0; ///< Place of the photo within the component, as b.
    int b = 0;
    Eigen::Vector3d direction = Eigen::Vector3d::Zero(); ///< Unit vector from a to b; zero at one place.
    double sigmaRad = 0;
    std::optional<double> length; ///< In a unit that all legs share; 0 for photos of one place.
    double lengthSigma = 0;       ///< Standard deviation of the length's logarithm.
};

/// The legs of a component's pairs. A thing that a photo shares with two others tells how long one leg is
/// against the other. Legs that no chain of such things joins to most others have no length.
std::vector<Leg> legs(const Component& component, std::span<const PhotoPair> pairs,
                      std::span<const PairEstimate> estimates);

/// Where the photos stand: least squares of directions and lengths, which ignores legs that contradict the
/// others. Empty for photos that no leg with a length joins to most others.
/// Source: Wilson and Snavely 2014 (directions); Cauchy's norm by reweighting.
std::vector<std::optional<Eigen::Vector3d>> averagedPlaces(std::span<const Leg> legs, int photos);

/// A thing as one photo sees it.
struct Ray {
    int photo = 0;                                      ///< Place of the photo within the component.
    Eigen::Vector3d bearing = Eigen::Vector3d::UnitX(); ///< In the photo's frame.
    double sigmaRad = 0;
};

/// A thing that several photos see.
struct SeenPoint {
    Eigen::Vector3d at = Eigen::Vector3d::Zero(); ///< Frame and unit of the photos' positions.
    std::vector<Ray> rays;
    bool isPlaced = false;
};

/// The photos of a component and the points that they see.
struct Bundle {
    std::vector<PhotoState> photos; ///< All have the same lenses.
    std::vector<SeenPoint> points;
    std::vector<Eigen::Vector3d> seen; ///< All points where rays of the photos meet.
    double scale = 1;                  ///< Of the residuals: 1 if the bearings' sigmas are right.

    std::vector<Eigen::Vector3d> positions() const {
        std::vector<Eigen::Vector3d> all;
        for (const PhotoState& photo : photos) {
            all.push_back(photo.positionM);
        }
        return all;
    }

    /// Where the lens stands that sees the ray.
    Eigen::Vector3d lensOf(const Ray& ray) const {
        const PhotoState& photo = photos[static_cast<std::size_t>(ray.photo)];
        const double ahead = softSide(ray.bearing) * photo.lenses.aheadM;
        return photo.positionM + ahead * (photo.roomFromPhoto * Eigen::Vector3d::UnitX());
    }
};

/// The things that the component's pairs join over its photos, those that most photos see first. A thing that
/// would be two things of one photo is none of that photo. photoOf: places of the photos; -1 leaves one out.
std::vector<SeenPoint> seenPoints(const Component& component, std::span<const int> placeOf,
                                  std::span<const PhotoPair> pairs, std::span<const PairEstimate> estimates);

/// Moves photos and points to where the rays meet best, and finds how far the lenses stand ahead. Rays that
/// miss by far are left out, and so are points without parallax, and points beyond some hundreds a photo:
/// the first ones stay.
/// priors: one a photo of the bundle; they say what is level, and nothing else of them is used. The first
/// photo stays where it is. Errors: Internal if Ceres gives up; Stopped. Source: Triggs et al., Bundle
/// Adjustment: A Modern Synthesis, 2000.
void adjust(Bundle& bundle, std::span<const PhotoPrior> priors, ProgressSink& progress,
            const std::stop_token& stop);

/// Where the rays of things meet, without those of which no two meet. scale: of the rays' sigmas, as
/// Bundle::scale.
std::vector<Eigen::Vector3d> meetingPoints(const Bundle& bundle, std::span<const SeenPoint> things,
                                           double scale);

/// Turns, scales and shifts photos and points, in this order.
void move(Bundle& bundle, const Eigen::Quaterniond& turned, double scale, const Eigen::Vector3d& shift);

/// Turns each ray to where its photo shows what the ray's point looks like in the other photos. Detectors
/// find a thing where its surroundings, at the photo's own scale, are brightest or darkest. So each photo
/// sees it a bit elsewhere, and photos that see it from far are off together. The picture around the ray that
/// sees it from nearest is found again in the others, from photo to photo that see it alike. Rays whose
/// picture is not found stay as they are. picture: the photo of the bundle at this place, with as many pixels
/// as it has up to that width. Threads: the same result for any number. Stop: heard at each point. Cost: 0.2
/// ms a ray and 3 MB a photo. Source: Lindenberger, Sarlin, Larsson, Pollefeys 2021 (what is refined);
/// Evangelidis and Psarakis 2008 (enhanced correlation, as OpenCV has it).
void refineRays(Bundle& bundle, const std::function<RgbImage(int place, int width)>& picture, int threads,
                ProgressSink& progress, const std::stop_token& stop);

/// Standard deviations of one photo's pose against all others, when all are moved, turned and scaled
/// together.
struct BundleSigma {
    double turnRad = 0; ///< About the worst axis.
    double place = 0;   ///< Along the worst axis, in the unit of the positions.
};

std::vector<BundleSigma> bundleSigmas(const Bundle& bundle);

/// Standard deviation of how far the lenses stand ahead, in the unit of the positions.
double lensSigma(const Bundle& bundle);

/// Whether the photos stand so near to each other that nothing tells how far things are: most things show no
/// parallax, and that of the others is the noise of their rays. things: how many there are.
bool isOnePlace(const Bundle& bundle, std::size_t things);

/// By how much floors are uneven from patch to patch, with carpets, thresholds and features above ground:
/// standard deviation, as a share of the lens's height.
inline constexpr double kUnevenFloor = 0.004;

/// A floor below the photos, in the unit of the positions.
struct FloorPlane {
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ(); ///< Unit normal.
    double at = 0;                                 ///< Height of the plane along `up`.
    double lensHeight = 0;                         ///< Median height of the photos above it.
    double heightSigma = 0;                        ///< Standard deviation of lensHeight.
    double upSigmaRad = 0;                         ///< Standard deviation of `up`.
    int points = 0;                                ///< Number of points that lie on it.
};

/// The lowest level plane that many points lie on. up: what is up, about; mostLean: how far it may err. Empty
/// where the points show no floor. Reflections in a floor lie below it, but fewer of them.
std::optional<FloorPlane> floorBelow(std::span<const Eigen::Vector3d> photos,
                                     std::span<const Eigen::Vector3d> points, const Eigen::Vector3d& up,
                                     Radians mostLean);

/// The heading of the walls: the turn about z, below a quarter, after which most points lie in upright planes
/// along x and y. Frames: z is up. Zero for too few points.
Radians wallHeading(std::span<const Eigen::Vector3d> pointsM);

/// The walls around points and photos as a rectangle along x and y. It holds nearly all points and, with some
/// clearance, all photos.
Polygon wallsAround(std::span<const Eigen::Vector3d> photosM, std::span<const Eigen::Vector3d> pointsM);

/// Height of the ceiling: nearly the highest point, and above all photos.
double ceilingAbove(std::span<const Eigen::Vector3d> photosM, std::span<const Eigen::Vector3d> pointsM);

/// How the placed photos agree, by which they fall into parts.
class PlaceAgreement {
  public:
    PlaceAgreement(const FreePlaces& places, std::span<const PhotoPair> pairs);

    /// What agreeingParts() returns for this share.
    std::vector<int> parts(double leastShare) const;

    /// The estimates without those that the places bear out, although what stands around one photo is not
    /// there around the other: both show something that is there twice. Empty if they would be all. Shape:
    /// one for each pair.
    std::vector<PairEstimate> withoutLookalikes(std::span<const PairEstimate> estimates) const;

  private:
    std::vector<bool> m_isPlaced;
    std::vector<int> m_fitting; ///< Number of each pair's matches that fit the places.
    std::vector<PhotoAgreement> m_agreements;
    bool m_isInMetres = true;
};

/// The parts into which photos fall, and the pairs that tell how the photos of each stand to each other.
struct CertainPairs {
    std::vector<int> parts;              ///< One entry a photo, as agreeingParts() has them.
    std::vector<PairEstimate> estimates; ///< Between parts, and where something is there twice, none agrees.
};

/// Finds the pairs that may be believed. Where photos do not agree, pairs that what is there twice explains
/// are left out, and then parts are cut off. placed: places the photos by estimates; it is
/// called last with those that are returned.
CertainPairs certainPairs(std::vector<PairEstimate> estimates,
                          const std::function<PlaceAgreement(std::span<const PairEstimate>)>& placed);

/// Says it of photos that hang together with the largest part too loosely: little of what either side lets
/// expect is seen from the other, or the floors of both lie at different heights, as where one side's lengths
/// are wrong. Where a floor gave the scale, it is then that of the largest room. lensHeightM: of the photos.
void doubtLooseParts(FreePlaces& places, const PlaceAgreement& agreement, double lensHeightM);

} // namespace spherewalk::align
