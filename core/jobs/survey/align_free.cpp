// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/align_survey.h"
#include "spherewalk/jobs/import_photos.h"
#include "spherewalk/jobs/solution_findings.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/store/survey_store.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>

namespace spherewalk::jobs {

namespace {

/// Two ways of solving may differ by this much: more names the photo.
constexpr Radians kSameTurn = Degrees(0.3);
/// How well a solved floor tells what is level: floors slope, and what lies on them stands out.
constexpr Radians kFloorLean = Degrees(0.3);
/// No place is known better, whatever the points say.
constexpr double kLeastPlaceSigmaM = 0.0005;
/// The same where tags that are rough must not be bent by them.
constexpr double kLeastTaggedSigmaM = 0.001;
/// What SolveOptions take for the place of a placement, at most.
constexpr double kLoosestPlaceM = 10;

int photoNamed(const std::string& file, std::span<const AlignedPhoto> photos) {
    const auto found = std::ranges::find(photos, file, &AlignedPhoto::file);
    if (found == photos.end()) {
        throw Error(ErrorKind::NotFound,
                    text("The survey has no chosen photo ", printable(file),
                         ", to which the distance was measured: give --distance with two "
                         "of its photos."));
    }
    return static_cast<int>(found - photos.begin());
}

Eigen::Vector3d middleOf(const align::FreePlaces& places) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    int count = 0;
    for (const align::FreePlace& place : places.photos) {
        sum += place.roomFromPhoto ? place.roomFromPhoto->translation : Eigen::Vector3d::Zero();
        count += place.roomFromPhoto ? 1 : 0;
    }
    return sum / std::max(count, 1);
}

/// The standard deviation of the lean that all photos share. What is known of each photo's lean scatters
/// about the solution, and the mean errs less by the root of their number. How upright things stand they may
/// have in common.
Radians commonLeanSigma(const align::FreePlaces& places, std::span<const align::PhotoPrior> priors,
                        const AlignReport& report) {
    constexpr double kBuiltRad = 3e-4;
    double squares = 0;
    int count = 0;
    for (std::size_t i = 0; i < priors.size(); ++i) {
        const align::SolvedPose& pose = report.alignment.photos[i];
        if (pose.isSolved) {
            const Eigen::Vector3d up = pose.roomFromPhoto.rotation * align::knownUp(priors[i]).upInPhoto;
            squares += std::pow(angleBetween(up, Eigen::Vector3d::UnitZ()).value(), 2);
            ++count;
        }
    }
    return places.isLevelByFloor || count == 0 ? kFloorLean
                                               : Radians(std::hypot(std::sqrt(squares) / count, kBuiltRad));
}

/// The solver took the heights for known, which a free solution does not know better than its lean.
void widen(Radians commonLean, AlignReport& report) {
    report.alignment.sigmaCommonLean = commonLean;
    for (align::SolvedPose& pose : report.alignment.photos) {
        if (pose.hasSigmas()) {
            pose.sigmaPitch = Radians(std::hypot(pose.sigmaPitch.value(), commonLean.value()));
            pose.sigmaRoll = Radians(std::hypot(pose.sigmaRoll.value(), commonLean.value()));
        }
    }
}

/// A similarity along the floor that brings solved places to their tags, and the photos that it fits.
struct TagFit {
    double scale = 1;
    FloorMotion motion;
    std::vector<std::size_t> photos;
    double sigmaM = 0; ///< Of a tag along either axis, as stated or as found.
};

/// Root of the summed squares of the tags' distances to their middle.
double radiusM(std::span<const std::size_t> photos, std::span<const align::PhotoPrior> priors) {
    Eigen::Vector2d middleM = Eigen::Vector2d::Zero();
    for (const std::size_t i : photos) {
        middleM += priors[i].positionM.head<2>() / static_cast<double>(photos.size());
    }
    double squares = 0;
    for (const std::size_t i : photos) {
        squares += (priors[i].positionM.head<2>() - middleM).squaredNorm();
    }
    return std::sqrt(squares);
}

/// Tagged over solved lengths: the median over the half of the pairs that stand farther apart.
double usualScale(std::span<const Eigen::Vector2d> solved, std::span<const Eigen::Vector2d> tagged) {
    std::vector<std::pair<double, double>> lengths;
    for (std::size_t a = 0; a < solved.size(); ++a) {
        for (std::size_t b = a + 1; b < solved.size(); ++b) {
            lengths.emplace_back((solved[a] - solved[b]).norm(), (tagged[a] - tagged[b]).norm());
        }
    }
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    std::vector<double> ratios;
    for (auto pair = middle; pair != lengths.end(); ++pair) {
        ratios.push_back(pair->first > 0 ? pair->second / pair->first : 0);
    }
    return ratios.empty() ? 0 : median(std::move(ratios));
}

/// scale: 0 for that of the tags. Nothing if the places or the tags lie all together.
std::optional<TagFit> fitToTags(const align::FreePlaces& places, std::span<const align::PhotoPrior> priors,
                                double scale) {
    constexpr double kFittingSigmas = 4;
    std::vector<std::size_t> photos;
    std::vector<Eigen::Vector2d> solved;
    std::vector<Eigen::Vector2d> tagged;
    for (std::size_t i = 0; i < priors.size(); ++i) {
        if (places.photos[i].roomFromPhoto) {
            photos.push_back(i);
            solved.emplace_back(places.photos[i].roomFromPhoto->translation.head<2>());
            tagged.emplace_back(priors[i].positionM.head<2>());
        }
    }
    TagFit fit;
    fit.scale = scale > 0 ? scale : usualScale(solved, tagged);
    std::ranges::for_each(solved, [&fit](Eigen::Vector2d& place) { place *= fit.scale; });
    const std::optional<FloorMotion> motion = commonMotion(solved, tagged);
    if (!motion) {
        return std::nullopt;
    }
    fit.motion = *motion;
    double squares = 0;
    for (std::size_t i = 0; i < photos.size(); ++i) {
        const double offM = (fit.motion * solved[i] - tagged[i]).norm();
        if (offM < kFittingSigmas * priors[photos[i]].positionSigmaM) {
            fit.photos.push_back(photos[i]);
            fit.sigmaM = std::max(fit.sigmaM, priors[photos[i]].positionSigmaM);
            squares += offM * offM;
        }
    }
    const auto count = static_cast<double>(std::max<std::size_t>(fit.photos.size(), 1));
    fit.sigmaM = std::max(fit.sigmaM, std::sqrt(squares / (2 * count)));
    return fit;
}

} // namespace

void refuseUnknownPlaces(const store::SurveyStore& store) {
    int unknown = 0;
    std::string first;
    for (const store::PhotoRecord& photo : store.chosenPhotos()) {
        if (!store.station(photo.station).isPlaceKnown) {
            first = unknown++ == 0 ? photo.fileName : first;
        }
    }
    if (unknown > 0) {
        throw Error(ErrorKind::InvalidInput,
                    text("Nobody knows where ", counted(unknown, "photo was", "photos were"), " taken, ",
                         first,
                         " among them: align with --positions free, or import them with a positions file."));
    }
}

namespace {

/// The usual height that photos were said to have when they were imported; that which the pictures gave an
/// earlier solution was said by nobody.
std::optional<double> importedHeightM(const store::SurveyStore& store) {
    const auto findings = activeFindings(store);
    std::vector<double> heightsM;
    for (const store::PhotoRecord& photo : store.chosenPhotos()) {
        if (store.station(photo.station).isPlaceKnown && !(findings && findings->isFree)) {
            heightsM.push_back(photo.positionM.z());
        }
    }
    return heightsM.empty() ? std::nullopt : std::optional(median(std::move(heightsM)));
}

void takeLensHeight(const store::SurveyStore& store, double givenM, align::FreeOptions& options) {
    const survey::PlanOptions plan = store.planOptions();
    const bool isGuess = givenM == 0 && plan.areHeightsGuessed && store.plan().placements.empty();
    const std::optional<double> importedM = isGuess ? importedHeightM(store) : std::nullopt;
    options.lensHeightM = givenM > 0 ? givenM : importedM.value_or(plan.heightsM.front());
    options.isLensHeightGuessed = isGuess && !importedM;
}

} // namespace

align::FreeOptions freeOptions(const store::SurveyStore& store, const AlignOptions& options,
                               std::span<const AlignedPhoto> photos) {
    align::FreeOptions made;
    takeLensHeight(store, options.lensHeightM, made);
    made.threads = options.threads;
    if (options.distance) {
        made.distance = {photoNamed(options.distance->a, photos), photoNamed(options.distance->b, photos),
                         options.distance->metres};
    }
    made.tagSizeM = options.tagSizeM;
    made.knownTags = options.knownTags;
    std::vector<std::string> files;
    std::ranges::transform(photos, std::back_inserter(files), &AlignedPhoto::file);
    made.picture = [folder = store.photoFolder(), files = std::move(files)](int photo, int width) {
        const std::string& file = files[static_cast<std::size_t>(photo)];
        return jpeg::decodeAtLeast(readFile(folder / file), file, width);
    };
    return made;
}

void usePlaces(const align::FreePlaces& places, std::span<align::PhotoPrior> priors,
               std::span<align::PairEstimate> estimates) {
    for (std::size_t i = 0; i < priors.size(); ++i) {
        const align::FreePlace& place = places.photos[i];
        priors[i].placement = -1;
        priors[i].positionM =
            place.roomFromPhoto ? place.roomFromPhoto->translation : Eigen::Vector3d::Zero();
        priors[i].positionSigmaM = std::clamp(place.sigmaM, kLeastPlaceSigmaM, 1.);
        priors[i].heightSigmaM = priors[i].positionSigmaM;
    }
    for (align::PairEstimate& estimate : estimates) {
        if (!places.photos[static_cast<std::size_t>(estimate.a)].roomFromPhoto ||
            !places.photos[static_cast<std::size_t>(estimate.b)].roomFromPhoto) {
            estimate.verdict = align::PairVerdict::NoAgreement;
        }
    }
}

std::optional<FrameSigma> usePlacesByTags(const align::FreePlaces& places,
                                          std::span<align::PhotoPrior> priors) {
    constexpr std::size_t kLeastPhotos = 6;
    constexpr std::size_t kLeastDoubtful = 4;
    std::optional<TagFit> fit = fitToTags(places, priors, 0);
    const double spreadM = fit ? radiusM(fit->photos, priors) : 0;
    FrameSigma frame;
    frame.scale = spreadM > 0 ? std::min(fit->sigmaM / spreadM, 1.) : 0;
    if (spreadM > 0 && places.scaleBy != align::ScaleBy::Nothing && places.scaleSigma < frame.scale) {
        fit = fitToTags(places, priors, 1); // The pictures know it better.
        frame.scale = places.scaleSigma;
    }
    if (!fit || fit->photos.size() < kLeastPhotos || 3 * fit->photos.size() < 2 * priors.size()) {
        return std::nullopt;
    }
    std::vector<double> rises;
    std::array<std::vector<std::size_t>, 2> placements; // without a doubt, and with one
    for (const std::size_t i : fit->photos) {
        rises.push_back(priors[i].positionM.z() -
                        fit->scale * places.photos[i].roomFromPhoto->translation.z());
        placements[places.photos[i].doubt.empty() ? 0 : 1].push_back(i);
    }
    const double riseM = median(std::move(rises));
    for (std::size_t placement = 0; placement < placements.size(); ++placement) {
        const std::vector<std::size_t>& photos = placements[placement];
        const double aroundM = radiusM(photos, priors);
        if (photos.size() < kLeastDoubtful || !(aroundM > 0)) {
            continue;
        }
        const double ownM = fit->sigmaM / std::sqrt(static_cast<double>(photos.size()));
        frame.placeM = std::max(frame.placeM, std::min(ownM, kLoosestPlaceM));
        frame.heading = std::max(frame.heading, Radians(std::min(fit->sigmaM / aroundM, std::numbers::pi)));
        for (const std::size_t i : photos) {
            const Eigen::Vector3d place = fit->scale * places.photos[i].roomFromPhoto->translation;
            align::PhotoPrior& prior = priors[i];
            prior.positionM << fit->motion * Eigen::Vector2d(place.head<2>()), riseM + place.z();
            prior.positionSigmaM =
                std::clamp(fit->scale * places.photos[i].sigmaM, kLeastTaggedSigmaM, prior.positionSigmaM);
            prior.heightSigmaM = prior.positionSigmaM;
            prior.placement = static_cast<int>(placement);
        }
    }
    return frame.placeM > 0 ? std::optional(frame) : std::nullopt;
}

void keepFrame(const store::SurveyStore& store, std::span<const store::PhotoRecord> photos,
               align::FreePlaces& places) {
    std::vector<Eigen::Vector2d> found;
    std::vector<Eigen::Vector2d> known;
    for (std::size_t i = 0; i < photos.size(); ++i) {
        if (places.photos[i].roomFromPhoto && store.station(photos[i].station).isPlaceKnown) {
            found.emplace_back(places.photos[i].roomFromPhoto->translation.head<2>());
            known.emplace_back(photos[i].positionM.head<2>());
        }
    }
    const std::optional<FloorMotion> motion = places.join ? std::nullopt : commonMotion(found, known);
    if (!motion) {
        return;
    }
    const Eigen::Quaterniond turn = yawRotation(Radians(motion->turn.angle()));
    for (align::FreePlace& place : places.photos) {
        if (place.roomFromPhoto) {
            place.roomFromPhoto->rotation = turn * place.roomFromPhoto->rotation;
            place.roomFromPhoto->translation.head<2>() = *motion * place.roomFromPhoto->translation.head<2>();
        }
    }
    for (Eigen::Vector3d& point : places.pointsM) {
        point.head<2>() = *motion * point.head<2>();
    }
    for (Eigen::Vector2d& corner : places.outline) {
        corner = *motion * corner;
    }
}

void widenTurns(const align::FreePlaces& places, AlignReport& report) {
    for (std::size_t i = 0; i < places.photos.size(); ++i) {
        align::SolvedPose& pose = report.alignment.photos[i];
        if (places.photos[i].roomFromPhoto && pose.hasSigmas()) {
            for (Radians* sigma : {&pose.sigmaYaw, &pose.sigmaPitch, &pose.sigmaRoll, &pose.sigmaOwn}) {
                *sigma = std::max(*sigma, Radians(places.photos[i].sigmaRad));
            }
        }
    }
}

void takePlaces(const align::FreePlaces& places, std::span<const align::PhotoPrior> priors,
                AlignReport& report) {
    const Eigen::Vector3d middle = middleOf(places);
    for (std::size_t i = 0; i < report.photos.size(); ++i) {
        const align::FreePlace& place = places.photos[i];
        align::SolvedPose& pose = report.alignment.photos[i];
        if (!place.roomFromPhoto || !pose.isSolved) {
            pose.isSolved = false;
            pose.why = place.why.empty() ? pose.why : place.why;
            continue;
        }
        const Radians apart = angleBetween(pose.roomFromPhoto.rotation, place.roomFromPhoto->rotation);
        if (apart > kSameTurn) {
            report.photos[i].flags.push_back(text("Two ways of solving turn it ",
                                                  fixed(Degrees(apart).value(), 2),
                                                  " deg apart: take another photo near it."));
        }
        if (!place.doubt.empty()) {
            report.photos[i].flags.push_back(place.doubt);
        }
        pose.roomFromPhoto = *place.roomFromPhoto;
        pose.lenses = place.lenses;
        const double byScaleM = places.scaleSigma * (pose.roomFromPhoto.translation - middle).norm();
        pose.sigmaOwnPositionM = std::max(place.sigmaM, kLeastPlaceSigmaM);
        pose.sigmaPositionM = std::hypot(pose.sigmaOwnPositionM, byScaleM);
    }
    widenTurns(places, report);
    widen(commonLeanSigma(places, priors, report), report);
    report.scaleSigma = places.scaleSigma;
    report.alignment.reason = text("The places were solved from the pictures. ", scaleText(places));
    if (std::ranges::none_of(report.alignment.photos, &align::SolvedPose::isSolved)) {
        return; // Nothing has a length.
    }
    for (const std::string& warning : places.warnings) {
        report.alignment.warnings.push_back(warning);
        if (places.scaleBy == align::ScaleBy::Nothing || places.scaleBy == align::ScaleBy::Guess) {
            report.tagWarnings.push_back(warning);
        }
    }
}

void keepLensHeight(store::SurveyStore& store, const align::FreePlaces& places) {
    if (!places.isLensHeightGuessed && places.lensHeightM < store.room().ceilingM &&
        store.plan().placements.empty()) {
        store.setLensHeight(places.lensHeightM);
    }
}

void takeRoom(store::SurveyStore& store, const Polygon& outline, double ceilingM) {
    if (store.roomOrigin() == store::RoomOrigin::Drawn) {
        return;
    }
    survey::Room room = store.room();
    room.outline = outline;
    room.obstacles.clear();
    room.names.clear();
    room.ceilingM = std::max(room.ceilingM, ceilingM); // A bare ceiling shows no points.
    try {
        room.validate();
    } catch (const Error&) {
        return; // Too few points make no room. The survey keeps the one that it has.
    }
    store.replaceRoom(room, store::RoomOrigin::Solved);
}

void moveStations(store::SurveyStore& store, AlignReport& report) {
    std::vector<PhotoPlace> moved;
    std::vector<store::PlacedStation> places;
    for (AlignedPhoto& aligned : report.photos) {
        if (!aligned.isHandedOn()) {
            continue;
        }
        const store::PhotoRecord photo = store.photo(aligned.photo);
        const store::StationRecord before = store.station(photo.station);
        const Eigen::Vector3d& positionM = aligned.pose.roomFromPhoto.translation;
        aligned.station = text("place of ", photo.cameraFileName);
        if (before.station.placement < 0 && store.photosAt(before.id).size() == 1) {
            places.push_back({before.id, positionM, aligned.station, before.isPlaceKnown});
            moved.push_back({photo.id, before.id, positionM, true});
        } else {
            moved.push_back({photo.id, store.addStation(positionM, aligned.station), positionM, true});
        }
    }
    store.placeStations(places);
    retagPhotos(store, moved, noProgress(), {});
    for (store::PlacedStation& place : places) { // Known once its photo says so, too.
        place.isPlaceKnown = true;
    }
    store.placeStations(places);
    for (AlignedPhoto& aligned : report.photos) {
        aligned.file = store.photo(aligned.photo).fileName;
    }
    if (report.places && store.plan().placements.empty()) {
        takeRoom(store, report.places->outline, report.places->ceilingM);
    }
}

} // namespace spherewalk::jobs
