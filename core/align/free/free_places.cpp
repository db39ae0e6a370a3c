// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/free_places.h"

#include "features/option_check.h"
#include "free/placing.h"
#include "graph/pose_graph.h"
#include "pairs/pair_geometry.h"
#include "solve/unknowns.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace spherewalk::align {

namespace {

constexpr std::size_t kChecked = 3; ///< From so many photos on, a pair needs a third photo that confirms it.
constexpr int kLeastSharedPoints = 8;
constexpr int kLeastPoints = 20;
constexpr double kDoubtfulSigmaM = 0.015;
constexpr double kDoubtfulSigmaRad = 0.006;
constexpr double kUnknownScaleSigma = 0.3;
/// Taken so: lenses in hands, on sticks and tripods stand from about 1 to 2 m high.
constexpr double kGuessedScaleSigma = 0.25;

/// The largest part, while it is placed.
struct Part {
    std::vector<int> photos; ///< Indices of the photos that are placed.
    std::vector<PhotoPrior> priors;
    std::vector<SeenPoint> things; ///< All that the photos see.
    Bundle bundle;
};

/// The largest part, adjusted, and what is said of the photos outside of it.
struct Adjusted {
    Part part;
    FreePlaces made;
};

/// Why a photo has no place that shares enough with no other one.
std::string whyAlone(std::size_t photos) {
    if (photos == 1) {
        return "It is the only photo, and nothing tells how far things are: take others half a metre from "
               "it.";
    }
    return photos < kChecked
               ? "The other photo shares too little with it: it seems to be of another place. Take photos "
                 "between them."
               : "No other photo shares enough with it that a third one confirms: it seems to be of another "
                 "place. Leave it out, or take photos between it and the others.";
}

/// What is said of photos outside of the largest part.
void nameParts(const PoseGraph& graph, std::span<const PhotoPrior> priors, FreePlaces& made) {
    made.parts = static_cast<int>(graph.components.size());
    for (FreePlace& place : made.photos) {
        place.part = -1;
        place.why = whyAlone(made.photos.size());
    }
    for (std::size_t part = 0; part < graph.components.size(); ++part) {
        for (const int photo : graph.components[part].photos) {
            FreePlace& place = made.photos[static_cast<std::size_t>(photo)];
            place.part = static_cast<int>(part);
            place.why =
                text("It belongs to part ", part + 1, " of ", made.parts,
                     ", which shares nothing certain with the largest part: take photos between the parts.");
        }
        if (part > 0) {
            made.warnings.push_back(
                text("The photos fall into ", made.parts, " parts that share nothing certain; part ",
                     part + 1, " is ", namesOf(graph.components[part].photos, priors),
                     ". Only the largest part is placed: take photos between the parts."));
        }
    }
}

/// The first poses of the largest part, level by what the photos say.
Part startOf(const Component& component, std::span<const PhotoPrior> priors, std::span<const PhotoPair> pairs,
             std::span<const PairEstimate> estimates, FreePlaces& made) {
    Part part;
    const auto places =
        averagedPlaces(legs(component, pairs, estimates), static_cast<int>(component.photos.size()));
    // Without a pair there is no vote for a heading, and the photos are turned upright alone.
    const Component unpaired{component.photos, {}, component.componentFromPhoto};
    const Eigen::Quaterniond upright = orientations(unpaired, priors, estimates).front().roomFromComponent;
    std::vector<int> placeOf(priors.size(), -1);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const int photo = component.photos[i];
        FreePlace& place = made.photos[static_cast<std::size_t>(photo)];
        if (!places[i]) {
            place.why =
                "How far it is from the others is not known: it shares too little with two of them at a "
                "time. Take another photo near it.";
            continue;
        }
        place.why.clear();
        placeOf[static_cast<std::size_t>(photo)] = static_cast<int>(part.photos.size());
        part.photos.push_back(photo);
        part.priors.push_back(priors[static_cast<std::size_t>(photo)]);
        part.bundle.photos.push_back(
            {(upright * component.componentFromPhoto[i]).normalized(), upright * *places[i]});
    }
    part.things = seenPoints(component, placeOf, pairs, estimates);
    return part;
}

/// How far what the photos say of up may err: nothing but a guess where hardly any says it.
Radians mostLean(const Part& part) {
    const auto said = std::ranges::count_if(part.priors, saysUp);
    return 2 * static_cast<std::size_t>(said) >= part.priors.size() ? Degrees(3) : Degrees(15);
}

/// Turns the part by its floor where the photos say little of what is level.
std::optional<FloorPlane> levelledFloor(Part& part, FreePlaces& made) {
    const Radians lean = mostLean(part);
    auto floor = floorBelow(part.bundle.positions(), part.bundle.seen, Eigen::Vector3d::UnitZ(), lean);
    if (floor && lean > Radians(Degrees(10))) {
        move(part.bundle, uprightFrom(floor->up), 1, Eigen::Vector3d::Zero());
        floor->up = Eigen::Vector3d::UnitZ();
        made.isLevelByFloor = true;
    }
    return floor;
}

/// The tags as the placed photos see them, in the unit of the positions.
RoomTags tagsOf(const Part& part, std::size_t photos, const FreeOptions& options) {
    std::vector<std::optional<PlacedPhoto>> placed(photos);
    for (std::size_t i = 0; i < part.photos.size(); ++i) {
        const PhotoState& state = part.bundle.photos[i];
        placed[static_cast<std::size_t>(part.photos[i])] = {
            {state.roomFromPhoto, state.positionM}, state.lenses, part.priors[i].name};
    }
    return roomTags(placed, options.tags, options.tagSizeM);
}

/// Metres in the unit of the positions.
double metresPerUnit(const Part& part, const std::optional<FloorPlane>& floor, const RoomTags& tags,
                     const FreeOptions& options, FreePlaces& made) {
    if (options.distance) {
        const auto placeOf = [&](int photo) {
            return std::ranges::find(part.photos, photo) - part.photos.begin();
        };
        const auto a = static_cast<std::size_t>(placeOf(options.distance->a));
        const auto b = static_cast<std::size_t>(placeOf(options.distance->b));
        if (a < part.photos.size() && b < part.photos.size()) {
            const double apart = (part.bundle.photos[a].positionM - part.bundle.photos[b].positionM).norm();
            constexpr double kTapeM = 0.003;
            made.scaleBy = ScaleBy::Distance;
            made.scaleSigma = kTapeM / options.distance->metres;
            return options.distance->metres / std::max(apart, 1e-9);
        }
    }
    if (tags.scale) {
        made.scaleBy = ScaleBy::Tags;
        made.scaleSigma = tags.scale->sigma / tags.scale->value;
        return 1 / tags.scale->value;
    }
    if (floor) {
        made.scaleBy = options.isLensHeightGuessed ? ScaleBy::Guess : ScaleBy::Floor;
        made.scaleSigma = options.isLensHeightGuessed
                              ? kGuessedScaleSigma
                              : std::hypot(options.lensHeightSigmaM / options.lensHeightM,
                                           floor->heightSigma / floor->lensHeight, kUnevenFloor);
        return options.lensHeightM / floor->lensHeight;
    }
    made.scaleBy = ScaleBy::Nothing;
    made.scaleSigma = kUnknownScaleSigma;
    double lowest = 0;
    for (const Eigen::Vector3d& point : part.bundle.seen) {
        lowest = std::min(lowest, point.z() - part.bundle.photos.front().positionM.z());
    }
    return lowest < 0 ? options.lensHeightM / -lowest : 1;
}

constexpr double kSigmas = 3;         ///< From so many standard deviations on, scales contradict each other.
constexpr double kLeastShare = 0.005; ///< Below it, tapes and rulers may differ.

/// Says it where what gives the scale contradicts the tags, or the tags the height of the lens.
void tellScales(double metres, const RoomTags& tags, const std::optional<FloorPlane>& floor,
                const FreeOptions& options, FreePlaces& made) {
    const auto tell = [&](double ratio, double sigma, std::string_view what, std::string_view cure) {
        if (std::abs(ratio - 1) > std::max(kLeastShare, kSigmas * sigma)) {
            made.warnings.push_back(text("By the printed size of the tags, ", what, " is ",
                                         fixed(100 * std::abs(ratio - 1), 1), " % too ",
                                         ratio > 1 ? "long" : "short", ". ", cure));
        }
    };
    if (tags.scale && made.scaleBy == ScaleBy::Distance) {
        tell(metres * tags.scale->value, std::hypot(made.scaleSigma, tags.scale->sigma / tags.scale->value),
             "the given distance", "Measure the printed tags and the distance again.");
    } else if (tags.scale && floor && !options.isLensHeightGuessed) {
        const double byFloor = options.lensHeightM / (metres * floor->lensHeight);
        tell(byFloor,
             std::hypot(made.scaleSigma, options.lensHeightSigmaM / options.lensHeightM, kUnevenFloor),
             "the height of the lens", "Measure the printed tags, and the height of the lens.");
    }
}

/// Says it where the known tags contradict the printed size. Two tags, one of which was moved, may fit well
/// in another scale.
void tellJoinedScale(const TagJoin& join, const Scale& printed, FreePlaces& made) {
    const double ratio = join.scale * printed.value;
    const double sigma = std::hypot(join.scaleSigma, printed.sigma / printed.value);
    if (std::abs(ratio - 1) > std::max(kLeastShare, kSigmas * sigma)) {
        made.warnings.push_back(
            text("By the printed size of the tags, lengths in the other survey's frame are ",
                 fixed(100 * std::abs(ratio - 1), 1), " % too ", ratio > 1 ? "long" : "short",
                 ". Perhaps a tag was moved between the surveys, or the size of their tags was given "
                 "differently."));
    }
}

/// Puts the part into the frame of known tags. False without any.
bool joinKnown(Part& part, const RoomTags& tags, const FreeOptions& options, FreePlaces& made) {
    if (options.knownTags.empty()) {
        return false;
    }
    made.join = joinByTags(tags.tags, options.knownTags);
    if (!made.join) {
        throw Error(ErrorKind::NotFound,
                    "The photos see none of the tags of the other survey from two places, so the surveys "
                    "cannot be joined: take photos near the tags.");
    }
    for (const int number : made.join->moved) {
        made.warnings.push_back(text("AprilTag ", number,
                                     " hangs elsewhere than in the other survey, and was not used to join "
                                     "them. Hang tags where nobody moves them."));
    }
    tellJoinedScale(*made.join, *tags.scale, made);
    made.scaleBy = ScaleBy::Tags;
    made.scaleSigma = made.join->scaleSigma;
    move(part.bundle, made.join->otherFromOwn.rotation, made.join->scale,
         made.join->otherFromOwn.translation);
    return true;
}

/// Puts the part into the room: metres, the floor at zero, the first photo above the origin, walls along the
/// axes.
void placeInRoom(Part& part, const FreeOptions& options, FreePlaces& made) {
    const std::optional<FloorPlane> floor = levelledFloor(part, made);
    const RoomTags tags = tagsOf(part, made.photos.size(), options);
    if (joinKnown(part, tags, options, made)) {
        return;
    }
    const double metres = metresPerUnit(part, floor, tags, options, made);
    tellScales(metres, tags, floor, options, made);
    move(part.bundle, Eigen::Quaterniond::Identity(), metres, Eigen::Vector3d::Zero());
    move(part.bundle, yawRotation(wallHeading(part.bundle.seen)), 1, Eigen::Vector3d::Zero());
    Eigen::Vector3d shift = -part.bundle.photos.front().positionM;
    shift.z() = floor ? -metres * floor->at : options.lensHeightM - part.bundle.positions().front().z();
    move(part.bundle, Eigen::Quaterniond::Identity(), 1, shift);
    if (made.scaleBy == ScaleBy::Nothing) {
        made.warnings.push_back(
            "The scale is not known: the photos show too little of the floor below them, and no distance was "
            "given. Give the distance between two photos.");
    } else if (made.scaleBy == ScaleBy::Guess) {
        made.warnings.push_back(
            text("Nobody said how high the lens stands over the floor: ", fixed(options.lensHeightM, 2),
                 " m is a guess, and all lengths may be wrong by a quarter and more. Give the height of the "
                 "lens, or the distance between two photos."));
    }
}

/// How many points each photo shares with each other one.
std::vector<std::map<int, int>> sharedPoints(const Bundle& bundle) {
    std::vector<std::map<int, int>> shared(bundle.photos.size());
    for (const SeenPoint& point : bundle.points) {
        for (const Ray& one : point.rays) {
            for (const Ray& other : point.rays) {
                ++shared[static_cast<std::size_t>(one.photo)][other.photo];
            }
        }
    }
    return shared;
}

std::string doubtOf(const FreePlace& place, int confirming, std::size_t photos) {
    if (place.points < kLeastPoints || (photos >= kChecked && confirming < 2)) {
        return text("Little confirms where it was taken: it shares ", place.points, " points with ",
                    confirming, " other photos. Take another photo near it.");
    }
    if (place.sigmaM > kDoubtfulSigmaM || place.sigmaRad > kDoubtfulSigmaRad) {
        return text("Where it was taken is known to ", fixed(100 * place.sigmaM, 1), " cm and ",
                    fixed(Degrees(Radians(place.sigmaRad)).value(), 2),
                    " deg only: take another photo near it.");
    }
    return {};
}

/// Whether a part is so small among all photos that it may be of several places that look alike: doors of a
/// corridor, each taken from before it, or rooms of one kind.
bool isSmall(std::size_t photos, std::size_t all) {
    constexpr std::size_t kFewPhotos = 8;
    return photos < kFewPhotos && 2 * photos < all;
}

void report(const Part& part, FreePlaces& made) {
    const std::vector<BundleSigma> sigmas = bundleSigmas(part.bundle);
    const auto shared = sharedPoints(part.bundle);
    for (std::size_t i = 0; i < part.photos.size(); ++i) {
        FreePlace& place = made.photos[static_cast<std::size_t>(part.photos[i])];
        const PhotoState& state = part.bundle.photos[i];
        place.roomFromPhoto = Rigid3{state.roomFromPhoto, state.positionM};
        place.lenses = state.lenses;
        place.sigmaM = sigmas[i].place;
        place.sigmaRad = sigmas[i].turnRad;
        int confirming = 0;
        for (const auto& [other, points] : shared[i]) {
            const bool isOwn = other == static_cast<int>(i);
            place.points = isOwn ? points : place.points;
            confirming += !isOwn && points >= kLeastSharedPoints ? 1 : 0;
        }
        place.doubt = doubtOf(place, confirming, part.photos.size());
        if (place.doubt.empty() && isSmall(part.photos.size(), made.photos.size())) {
            place.doubt =
                text("Only ", part.photos.size(), " of ", made.photos.size(),
                     " photos hang together, too few to tell their place from another that looks like it. "
                     "Take photos between them and the others.");
        }
    }
    made.pointsM = part.bundle.seen;
    made.outline = wallsAround(part.bundle.positions(), made.pointsM);
    made.ceilingM = ceilingAbove(part.bundle.positions(), made.pointsM);
}

/// Adjusts the largest part that the estimates join. It is empty if they join none.
Adjusted adjustedBy(std::span<const PairEstimate> estimates, std::span<const PhotoPrior> photos,
                    std::span<const PhotoPair> pairs, ProgressSink& progress, const std::stop_token& stop) {
    progress.progress(0, "Averaging rotations");
    Adjusted result;
    result.made.photos.resize(photos.size());
    const PoseGraph graph =
        poseGraph(static_cast<int>(photos.size()), estimates, photos.size() >= kChecked ? 1 : 0);
    nameParts(graph, photos, result.made);
    if (graph.components.empty()) {
        return result;
    }
    result.part = startOf(graph.components.front(), photos, pairs, estimates, result.made);
    if (!result.part.photos.empty()) {
        result.part.bundle.points = result.part.things;
        ProgressStep step(progress, 0.05, 1);
        Part& part = result.part;
        adjust(part.bundle, part.priors, step, stop);
        part.bundle.seen = meetingPoints(part.bundle, part.things, part.bundle.scale);
        if (isOnePlace(part.bundle, part.things.size())) {
            for (const int photo : part.photos) {
                result.made.photos[static_cast<std::size_t>(photo)].why =
                    "It was taken at one place with the others, so nothing tells how far things are: take "
                    "others half a metre from it.";
            }
            part = {};
        }
    }
    return result;
}

FreePlaces placesOf(Adjusted adjusted, const FreeOptions& options) {
    if (!adjusted.part.photos.empty()) {
        placeInRoom(adjusted.part, options, adjusted.made);
        report(adjusted.part, adjusted.made);
    }
    return std::move(adjusted.made);
}

void refine(Part& part, const FreeOptions& options, ProgressSink& progress, const std::stop_token& stop) {
    const auto picture = [&](int place, int width) {
        return options.picture(part.photos[static_cast<std::size_t>(place)], width);
    };
    ProgressStep compare(progress, 0, 0.5);
    refineRays(part.bundle, picture, options.threads, compare, stop);
    ProgressStep again(progress, 0.5, 1);
    const double scale = part.bundle.scale; // Of what features see.
    adjust(part.bundle, part.priors, again, stop);
    part.bundle.seen = meetingPoints(part.bundle, part.things, scale);
}

/// What is there twice, as furniture is, may join photos of two places, or bend a place.
FreePlaces placesThatAgree(std::span<const PairEstimate> estimates, std::span<const PhotoPrior> photos,
                           std::span<const PhotoPair> pairs, const FreeOptions& options,
                           ProgressSink& progress, const std::stop_token& stop) {
    Adjusted adjusted;
    double begin = 0;
    const auto placed = [&](std::span<const PairEstimate> some) {
        const double end = begin > 0 ? std::midpoint(begin, 0.6) : 0.3; // How many are tried is not known.
        ProgressStep step(progress, begin, end);
        adjusted = adjustedBy(some, photos, pairs, step, stop);
        begin = end;
        return PlaceAgreement(placesOf(adjusted, options), pairs);
    };
    const CertainPairs certain = certainPairs({estimates.begin(), estimates.end()}, placed);
    if (options.picture && !adjusted.part.photos.empty()) {
        ProgressStep step(progress, 0.6, 1);
        refine(adjusted.part, options, step, stop);
    }
    FreePlaces made = placesOf(std::move(adjusted), options);
    for (std::size_t i = 0; i < made.photos.size(); ++i) {
        if (certain.parts[i] > 0 && !made.photos[i].roomFromPhoto) {
            made.photos[i].why = "It shows some things that the largest part shows, but not what stands "
                                 "around them: it seems to be of another place that looks alike. Leave it "
                                 "out, or take photos between it and the others.";
        }
    }
    doubtLooseParts(made, PlaceAgreement(made, pairs), options.lensHeightM);
    return made;
}

} // namespace

void FreeOptions::validate(int photos) const {
    require(lensHeightM > 0.05 && lensHeightM <= 20, "free mode's", "lensHeightM",
            "above 0.05 and at most 20");
    require(lensHeightSigmaM >= 0 && lensHeightSigmaM <= 1, "free mode's", "lensHeightSigmaM", "from 0 to 1");
    require(threads >= 0, "free mode's", "threads", "0 or above");
    require((tagSizeM >= 0.01 && tagSizeM <= 10) || (tagSizeM == 0 && tags.empty()), "free mode's",
            "tagSizeM", "from 0.01 to 10, or 0 without tags");
    if (distance) {
        require(distance->a >= 0 && distance->b >= 0 && distance->a < photos && distance->b < photos &&
                    distance->a != distance->b && distance->metres > 0.01 && distance->metres < 1000,
                "free mode's", "distance", "between two photos, from 0.01 to 1000 m");
    }
}

FreePlaces freePlaces(std::span<const PhotoPrior> photos, std::span<const PhotoPair> pairs,
                      std::span<const PairEstimate> estimates, const FreeOptions& options,
                      ProgressSink& progress, const std::stop_token& stop) {
    options.validate(static_cast<int>(photos.size()));
    throwIfStopped(stop);
    FreePlaces made = placesThatAgree(estimates, photos, pairs, options, progress, stop);
    made.lensHeightM = options.lensHeightM;
    made.isLensHeightGuessed = options.isLensHeightGuessed;
    progress.progress(1, "Placed");
    return made;
}

} // namespace spherewalk::align
