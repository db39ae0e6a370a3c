// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/align_survey.h"
#include "spherewalk/store/survey_store.h"

#include <algorithm>

namespace spherewalk::jobs {

void propose(Cure cure, AlignedPhoto& photo) {
    if (photo.cure == Cure::None || cure < photo.cure) { // in the order of the list
        photo.cure = cure;
    }
}

namespace {

/// A rotation worse than this is told: three of it are about what a robot's camera of 640 pixels can see.
constexpr Radians kDoubtfulSigma = Degrees(0.15);
/// Of the matches that agreed between two photos alone. Things that move and mirrors are some.
constexpr double kMostOutliers = 0.5;
/// Of the deviation that a place was sought with: above it the matches told nothing of it.
constexpr double kUnknownPlaceShare = 0.5;
/// A photo whose neighbours contradict more than this is not of this place.
constexpr double kNothingFits = 0.9;

/// Names photos that the solution moved farther from their tags than tags err in this survey.
void tellMoved(std::span<const align::PhotoPrior> tagged, AlignReport& report) {
    for (const PhotoMove& moved : movedPhotos(tagged, report.alignment)) {
        if (report.alignment.photos[moved.photo].hasSigmas()) {
            propose(Cure::Retake, report.photos[moved.photo]);
            report.photos[moved.photo].flags.push_back(text(
                "It seems to stand ", fixed(100 * moved.byM, 1),
                " cm from where it is tagged, farther off than the others: correct its position, or retake "
                "it at its station."));
        }
    }
}

/// Says that a photo's own turn against the others is not well known, and what helps.
void tellTurn(Radians sigma, align::Model model, AlignedPhoto& photo) {
    const std::string knownDeg = fixed(Degrees(sigma).value(), 3);
    if (model == align::Model::Yaw) { // Then no photo's tilt was solved, however much it shares.
        photo.flags.push_back(text("The model yaw does not solve its tilt, so its rotation against its "
                                   "neighbours is known to ",
                                   knownDeg, " deg only: take more photos near it."));
        return;
    }
    propose(Cure::Retake, photo);
    photo.flags.push_back(text("Its rotation against its neighbours is known to ", knownDeg,
                               " deg only: it shares too little with them; retake it with more light, or "
                               "with more to see."));
}

/// Fills in the pose, the status, and the flags for what the pose itself makes doubtful.
void giveVerdict(const align::SolvedPose& pose, const align::PhotoPrior& prior,
                 const align::Alignment& alignment, AlignedPhoto& photo) {
    photo.pose = pose;
    if (!pose.isSolved) {
        photo.quality = survey::Quality::Failed;
        photo.flags.push_back(pose.why);
        propose(Cure::Retake, photo);
        return;
    }
    if (!pose.doubt.empty()) {
        photo.flags.push_back(pose.doubt);
    } else if (pose.sigmaOwn > kDoubtfulSigma) {
        tellTurn(pose.sigmaOwn, alignment.model, photo);
    }
    if (pose.outlierShare > kMostOutliers) {
        propose(Cure::Mask, photo);
        photo.flags.push_back(text("Its neighbours contradict ", fixed(100 * pose.outlierShare, 0),
                                   " % of what it shows; look at the picture, and retake it if it is not of "
                                   "this place."));
    }
    if (pose.component > 0) {
        photo.flags.push_back(text("It belongs to a part of the survey that nothing connects with the rest (",
                                   alignment.components,
                                   " parts): headings are right within the part, and the part's own rests on "
                                   "its positions alone; take photos between the parts."));
    }
    photo.quality = photo.flags.empty() ? survey::Quality::Good : survey::Quality::Doubtful;
    if (photo.freeSigmaM > 0 && pose.sigmaPositionM > kUnknownPlaceShare * photo.freeSigmaM) {
        photo.quality = survey::Quality::Failed;
        propose(Cure::Retake, photo);
        photo.flags.push_back(text("Where it was taken is known to ", fixed(100 * pose.sigmaPositionM, 0),
                                   " cm only: correct its position, or retake it at its station."));
    }
    if (pose.outlierShare > kNothingFits) {
        photo.quality = survey::Quality::Failed;
    }
    // Its own accelerometer is the better witness: such a pose is not handed on.
    if (prior.levelFromPhoto && pose.leanFromStated > align::kContradictingLean) {
        photo.quality = survey::Quality::Failed;
        propose(Cure::Retake, photo);
    }
}

} // namespace

void giveVerdicts(std::span<const align::PhotoPrior> tagged, AlignReport& report) {
    tellMoved(tagged, report);
    for (std::size_t i = 0; i < tagged.size(); ++i) {
        giveVerdict(report.alignment.photos[i], tagged[i], report.alignment, report.photos[i]);
    }
}

void tellDamaged(std::span<const int> photos, AlignReport& report) {
    for (const int photo : photos) {
        AlignedPhoto& damaged = report.photos.at(static_cast<std::size_t>(photo));
        damaged.quality = survey::Quality::Failed;
        damaged.cure = Cure::Retake;
        damaged.flags = {text("The file ", damaged.file, " cannot be read; retake the photo.")};
    }
}

store::NewSolution recordOf(const AlignReport& report) {
    store::NewSolution solution;
    solution.source = "align";
    solution.model = align::name(report.alignment.model);
    for (const AlignedPhoto& photo : report.photos) {
        if (!photo.isHandedOn()) {
            continue;
        }
        store::SolvedPhoto solved;
        solved.photo = photo.photo;
        solved.roomFromPhoto = photo.pose.roomFromPhoto.rotation;
        solved.positionM = photo.pose.roomFromPhoto.translation;
        if (photo.pose.hasSigmas()) {
            solved.sigmaYawRad = photo.pose.sigmaYaw.value();
            solved.sigmaPitchRad = photo.pose.sigmaPitch.value();
            solved.sigmaRollRad = photo.pose.sigmaRoll.value();
        }
        solved.sigmaPositionM = photo.pose.sigmaPositionM;
        solved.quality = photo.quality;
        solved.flags = Json(photo.flags).dump();
        solution.photos.push_back(std::move(solved));
    }
    return solution;
}

void recordSolution(store::SurveyStore& store, const AlignOptions& options, AlignReport& report,
                    ProgressSink& progress) {
    store::NewSolution solution = recordOf(report);
    // A mirrored survey is recorded: nothing of it shall be exported at places that are wrong.
    if (solution.photos.empty() && !report.tagFrame.isMirrored) {
        progress.warning("No photo could be aligned, so no solution was recorded; see what is said of "
                         "each photo.");
        return;
    }
    solution.report = toJson(report).dump();
    report.solution = store.addSolution(solution, options.isActivated);
    if (options.isFree && options.isActivated) {
        moveStations(store, report);
        keepLensHeight(store, *report.places);
    }
}

} // namespace spherewalk::jobs
