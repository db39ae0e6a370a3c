// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/align_survey.h"
#include "spherewalk/store/survey_store.h"

#include <algorithm>
#include <cmath>

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

double freeSigmaM(std::span<const align::PhotoPrior> photos, const Eigen::Vector3d& pM) {
    double sigmaM = kFreeSigmaM;
    for (const align::PhotoPrior& photo : photos) {
        const double apartM = (photo.positionM - pM).norm();
        sigmaM = apartM < kOnePlaceM ? sigmaM : std::min(sigmaM, kFreeSigmaShare * apartM);
    }
    return sigmaM;
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

} // namespace spherewalk::jobs
