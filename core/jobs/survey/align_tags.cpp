// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/align_survey.h"
#include "spherewalk/photo/metadata.h"
#include "spherewalk/store/survey_store.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

namespace spherewalk::jobs {

namespace {

constexpr double kToldStretch = 0.015; ///< Puts photos 1 m apart 1.5 cm off.
constexpr double kToldStretchSigmas = 5;
constexpr double kToldScale = 0.025; ///< A lens whose height is off by 3 cm says as much.
constexpr double kToldScaleSigmas = 2.5;

bool isOff(const std::optional<align::Scale>& scale, double told, double sigmas) {
    return scale && std::abs(scale->value - 1) > std::max(told, sigmas * scale->sigma);
}

std::string scaleText(const align::Scale& scale) {
    return text(fixed(scale.value, 3), " +- ", fixed(scale.sigma, 3));
}

/// Of a photo whose tag is wrong, about the place where its neighbours' directions meet. It must stay well
/// below the distance to the neighbours: a pair that may share one place tells only how it is turned.
constexpr double kFreeSigmaM = 0.05;
constexpr double kFreeSigmaShare = 0.25; ///< Of the distance to the nearest photo at another place.
constexpr double kOnePlaceM = 0.02;

/// Half the greatest distance of two photos.
double reachM(const AlignReport& report) {
    double farthestM = 0;
    for (const AlignedPhoto& a : report.photos) {
        for (const AlignedPhoto& b : report.photos) {
            const double apartM =
                (a.pose.roomFromPhoto.translation - b.pose.roomFromPhoto.translation).norm();
            farthestM = std::max(farthestM, a.pose.isSolved && b.pose.isSolved ? apartM : 0);
        }
    }
    return farthestM / 2;
}

void tell(const std::string& sentence, AlignReport& report) {
    report.tagWarnings.push_back(sentence);
    report.alignment.warnings.push_back(sentence);
}

/// A photo that was moved farther from its tag than this was not where its tag says.
constexpr double kMovedSigmas = 5;
/// Of fewer photos, nobody can say which of them move together.
constexpr std::size_t kLeastTogether = 5;

/// Where photos are tagged and where they were solved, along the floor.
struct Places {
    std::vector<Eigen::Vector2d> tagged;
    std::vector<Eigen::Vector2d> solved;
};

std::vector<double> offsets(const Places& places, const FloorMotion& motion) {
    std::vector<double> metres;
    for (std::size_t i = 0; i < places.tagged.size(); ++i) {
        metres.push_back((places.solved[i] - motion * places.tagged[i]).norm());
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

/// What more than half of the photos have in common. A wrong tag pulls at all photos together, and that must
/// not hide it.
FloorMotion likeliestMotion(const Places& places) {
    FloorMotion best;
    const std::size_t count = places.tagged.size();
    if (count < kLeastTogether) {
        return best;
    }
    double bestMedian = median(offsets(places, best));
    constexpr std::size_t kMostPairs = 2000;
    const std::size_t step = std::max<std::size_t>(1, count * (count - 1) / 2 / kMostPairs);
    for (std::size_t pair = 0, a = 0; a < count; ++a) {
        for (std::size_t b = a + 1; b < count; ++b, ++pair) {
            const auto motion = pair % step == 0 ? motionOfTwo(places, a, b) : std::nullopt;
            const double usual = motion ? median(offsets(places, *motion)) : bestMedian;
            if (usual < bestMedian) {
                bestMedian = usual;
                best = *motion;
            }
        }
    }
    return best;
}

Eigen::Vector2d middleOf(const std::vector<Eigen::Vector2d>& points) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& point : points) {
        sum += point;
    }
    return sum / static_cast<double>(points.size());
}

/// The best motion of all places. Source: the closed form of least squares in the plane.
FloorMotion bestMotion(const Places& places) {
    const Eigen::Vector2d tagged = middleOf(places.tagged);
    const Eigen::Vector2d solved = middleOf(places.solved);
    double sine = 0;
    double cosine = 0;
    for (std::size_t i = 0; i < places.tagged.size(); ++i) {
        const Eigen::Vector2d a = places.tagged[i] - tagged;
        const Eigen::Vector2d b = places.solved[i] - solved;
        sine += a.x() * b.y() - a.y() * b.x();
        cosine += a.dot(b);
    }
    FloorMotion motion;
    motion.turn = Eigen::Rotation2Dd(std::atan2(sine, cosine)); // 0 where all are one
    motion.shift = solved - motion.turn * tagged;
    return motion;
}

/// The standard deviation that the place of a photo with a wrong tag is solved with, about pM.
double freeSigmaM(std::span<const align::PhotoPrior> photos, const Eigen::Vector3d& pM) {
    double sigmaM = kFreeSigmaM;
    for (const align::PhotoPrior& photo : photos) {
        const double apartM = (photo.positionM - pM).norm();
        sigmaM = apartM < kOnePlaceM ? sigmaM : std::min(sigmaM, kFreeSigmaShare * apartM);
    }
    return sigmaM;
}

/// Lets a photo with a wrong tag stand anywhere about the place.
void freePlace(std::size_t photo, const Eigen::Vector3d& nearM, double positionSigmaM,
               std::span<align::PhotoPrior> priors, AlignReport& report) {
    align::PhotoPrior& prior = priors[photo];
    prior.positionM.head<2>() = nearM.head<2>();
    prior.positionSigmaM = std::max(freeSigmaM(priors, prior.positionM), positionSigmaM);
    prior.placement = -1;
    report.photos.at(photo).freeSigmaM = prior.positionSigmaM;
}

} // namespace

void refineStretch(std::span<const align::PhotoPrior> tagged, AlignReport& report) {
    std::vector<Eigen::Vector2d> tags;
    std::vector<Eigen::Vector2d> places;
    for (std::size_t i = 0; i < tagged.size(); ++i) {
        const align::SolvedPose& pose = report.alignment.photos[i];
        if (pose.isSolved && pose.component == 0) {
            tags.emplace_back(tagged[i].positionM.head<2>());
            places.emplace_back(pose.roomFromPhoto.translation.head<2>());
        }
    }
    const bool isSolved = report.alignment.model == align::Model::Position && !report.tagFrame.isMirrored;
    const std::optional<align::Scale> solved = isSolved ? align::yOverX(tags, places) : std::nullopt;
    std::optional<align::Scale>& known = report.tagFrame.yOverX;
    if (solved && (!known || solved->sigma < known->sigma)) {
        known = solved;
    }
}

void tellTagFrame(AlignReport& report) {
    if (report.tagFrame.isMirrored) {
        tell("The position tags are mirrored: one axis points the wrong way, or x and y are exchanged. No "
             "photo "
             "is aligned; correct the axis in all positions, and align again.",
             report);
        for (AlignedPhoto& photo : report.photos) {
            photo.quality = survey::Quality::Failed;
            photo.cure = Cure::None;
            photo.flags.clear();
        }
        return;
    }
    double off = 0;
    if (isOff(report.tagFrame.yOverX, kToldStretch, kToldStretchSigmas)) {
        tell(text("The scale of the tags differs along the axes: against x, the tags are ",
                  scaleText(*report.tagFrame.yOverX),
                  " times as long along y as the photos show. Measure the steps along the rails and between "
                  "them, correct the positions, and align again."),
             report);
        off = std::abs(report.tagFrame.yOverX->value - 1);
    }
    if (isOff(report.scale, kToldScale, kToldScaleSigmas)) {
        tell(
            text("The scale of the tags is wrong, or the height of the lens: by the floor that the photos "
                 "show, the tags lie ",
                 scaleText(*report.scale),
                 " times as far apart as the photos. Measure the rail's steps and the lens's height, correct "
                 "what is wrong, and align again."),
            report);
        off = std::max(off, std::abs(report.scale->value - 1));
    }
    // Nothing tells which point of the room the wrong scale leaves in its place.
    const double offM = off * reachM(report);
    for (AlignedPhoto& photo : report.photos) {
        photo.pose.sigmaPositionM = std::hypot(photo.pose.sigmaPositionM, offM);
        photo.pose.sigmaOwnPositionM = std::hypot(photo.pose.sigmaOwnPositionM, offM);
    }
}

void correctPositions(std::span<const align::PairEstimate> estimates,
                      std::span<const align::PlannedPosition> planned, double positionSigmaM,
                      std::span<align::PhotoPrior> priors, AlignReport& report) {
    for (const align::WrongPosition& wrong : align::wrongPositions(priors, estimates, planned)) {
        const auto at = static_cast<std::size_t>(wrong.photo);
        AlignedPhoto& photo = report.photos.at(at);
        photo.flags.push_back(wrong.reason);
        photo.cure = wrong.fits < 0 ? Cure::Retake : Cure::Retag;
        if (wrong.fits < 0) {
            freePlace(at, wrong.takenM, positionSigmaM, priors, report);
            continue;
        }
        const align::PlannedPosition& fits = planned[static_cast<std::size_t>(wrong.fits)];
        photo.fits = fits.name;
        priors[at].positionM = fits.positionM;
        priors[at].placement = fits.placement;
        priors[at].stop = fits.stop;
    }
}

double scaleSigmaOf(std::span<const align::PhotoPrior> tagged, const align::Alignment& solved) {
    std::vector<double> weights;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < tagged.size(); ++i) {
        const double sigmaM = std::max(tagged[i].positionSigmaM, solved.photos.at(i).sigmaOwnPositionM);
        weights.push_back(std::pow(sigmaM, -2));
        sum += weights.back() * tagged[i].positionM.head<2>();
    }
    const Eigen::Vector2d middleM = sum / std::accumulate(weights.begin(), weights.end(), 0.);
    double information = 0;
    for (std::size_t i = 0; i < tagged.size(); ++i) {
        information += weights[i] * (tagged[i].positionM.head<2>() - middleM).squaredNorm();
    }
    return information > 0 ? std::min(1 / std::sqrt(information), 1.) : 0;
}

bool freeMoved(std::span<const align::PhotoPrior> tagged, double positionSigmaM,
               std::span<align::PhotoPrior> priors, AlignReport& report) {
    const std::vector<PhotoMove> moved = movedPhotos(tagged, report.alignment);
    const bool isNew = std::ranges::any_of(
        moved, [&](const PhotoMove& one) { return report.photos[one.photo].freeSigmaM == 0; });
    if (!isNew || 2 * moved.size() > priors.size()) {
        return false;
    }
    for (const PhotoMove& one : moved) {
        freePlace(one.photo, report.alignment.photos[one.photo].roomFromPhoto.translation, positionSigmaM,
                  priors, report);
    }
    return true;
}

void tellOnePlace(std::span<const align::OnePlace> found, AlignReport& report) {
    for (const align::OnePlace& one : found) {
        for (const auto& [own, other] : {std::pair(one.a, one.b), std::pair(one.b, one.a)}) {
            report.photos.at(static_cast<std::size_t>(own))
                .flags.push_back(text("It was taken at one place with ",
                                      report.photos.at(static_cast<std::size_t>(other)).file,
                                      ", though their tags lie ", fixed(one.tagsApartM, 2),
                                      " m apart: the camera was not moved between them. Retake the one whose "
                                      "tag is wrong."));
        }
    }
}

void tellLeftOut(const store::SurveyStore& store, ProgressSink& progress) {
    for (const store::PhotoRecord& photo : store.photos()) {
        if (!photo.choose && !store.shotOf(photo.id)) {
            progress.warning(text(photo.fileName,
                                  " is left out: ", store.chosenPhoto(photo.station)->fileName,
                                  " stands for ", store.station(photo.station).name, "."));
        }
    }
}

std::optional<FloorMotion> commonMotion(std::span<const Eigen::Vector2d> from,
                                        std::span<const Eigen::Vector2d> to) {
    Places all{{from.begin(), from.end()}, {to.begin(), to.end()}};
    const auto isTogether = [](const std::vector<Eigen::Vector2d>& points) {
        constexpr double kTogetherM = 0.1;
        return std::ranges::all_of(points, [&](const Eigen::Vector2d& point) {
            return (point - points.front()).norm() < kTogetherM;
        });
    };
    if (isTogether(all.tagged) || isTogether(all.solved)) {
        return std::nullopt;
    }
    if (all.tagged.size() < kLeastTogether) {
        return bestMotion(all);
    }
    const std::vector<double> offM = offsets(all, likeliestMotion(all));
    constexpr double kFarTimes = 3;
    const double mostM = kFarTimes * std::max(median(offM), 0.001);
    Places fitting;
    for (std::size_t i = 0; i < offM.size(); ++i) {
        if (offM[i] <= mostM) {
            fitting.tagged.push_back(all.tagged[i]);
            fitting.solved.push_back(all.solved[i]);
        }
    }
    return isTogether(fitting.tagged) ? bestMotion(all) : bestMotion(fitting);
}

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
        const std::vector<double> own = offsets(places, likeliestMotion(places));
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

align::PhotoPrior priorOf(const store::SurveyStore& store, const store::PhotoRecord& photo,
                          const store::StationRecord& station, double positionSigmaM,
                          ProgressSink& progress) {
    // What cameras say of their own tilt agrees with their pictures to about a degree.
    constexpr Degrees kStatedTiltSigma(1);
    constexpr Degrees kLevelledTiltSigma(0.5);
    align::PhotoPrior prior;
    prior.name = store::photoAtStation(photo.fileName, station.name);
    prior.positionM = photo.positionM;
    prior.positionSigmaM = positionSigmaM;
    prior.placement = station.station.placement;
    prior.stop = station.station.stop;
    const std::filesystem::path file = store.photoFolder() / photo.fileName;
    try {
        const photo::PhotoMetadata metadata = photo::readMetadata(readFile(file), file.string());
        prior.levelFromPhoto = photo::levelFromPhoto(metadata);
        prior.tiltSigma = photo::isLevel(metadata) ? kLevelledTiltSigma : kStatedTiltSigma;
    } catch (const Error& error) {
        progress.warning(error.sentence());
    }
    return prior;
}

} // namespace spherewalk::jobs
