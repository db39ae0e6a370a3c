// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/solve.h"

#include "graph/pose_graph.h"
#include "solve/component_solver.h"
#include "solve/match_selection.h"
#include "solve/solution_report.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace spherewalk::align {

namespace {

constexpr EnumNames<Model, 5> kModelNames{{{Model::Auto, "auto"},
                                           {Model::Yaw, "yaw"},
                                           {Model::Tilt, "tilt"},
                                           {Model::Placement, "placement"},
                                           {Model::Position, "position"}}};

} // namespace

std::string_view name(Model model) {
    return nameOf(kModelNames, model);
}

Model modelNamed(std::string_view name) {
    return valueOf(kModelNames, "The alignment model", name);
}

namespace {

constexpr double kFarthestM = 1e8;

[[noreturn]] void refuse(const std::string& sentence) {
    throw Error(ErrorKind::InvalidInput, sentence);
}

void checkPhoto(const PhotoPrior& photo) {
    const std::string whose = text("Photo '", printable(photo.name), "' cannot be aligned: ");
    if (!photo.positionM.allFinite() || photo.positionM.cwiseAbs().maxCoeff() > kFarthestM) {
        refuse(text(whose, "its position is no number within ", kFarthestM, " m. Correct its station."));
    }
    if (!(photo.positionSigmaM >= 0 && photo.positionSigmaM < 10 && photo.heightSigmaM >= 0 &&
          photo.heightSigmaM < 10)) {
        refuse(text(whose, "the uncertainty of its position must be between 0 and 10 m."));
    }
    if (!(photo.tiltSigma.value() >= 0 && photo.tiltSigma.value() < 4)) {
        refuse(text(whose, "the uncertainty of its tilt must be between 0 and 180 degrees."));
    }
    if (photo.levelFromPhoto &&
        !(photo.levelFromPhoto->norm() > 0.99 && photo.levelFromPhoto->norm() < 1.01)) {
        refuse(text(whose, "the tilt that it states is no rotation. Clear its tilt and try again."));
    }
}

void checkEstimate(const PairEstimate& estimate, const PhotoPair& pair, const std::string& which) {
    if (estimate.a != pair.a || estimate.b != pair.b) {
        refuse(text("The estimates do not belong to the pairs: ", which, " differs."));
    }
    if (estimate.verdict != PairVerdict::Constraint) {
        return;
    }
    const double length = estimate.aFromB.norm();
    const bool hasBaseline = !estimate.baselineInA || std::abs(estimate.baselineInA->norm() - 1) < 0.01;
    if (estimate.isInlier.size() != pair.matches.size() || !(length > 0.99 && length < 1.01) ||
        !hasBaseline || !std::isfinite(estimate.baselineSigmaRad) || !std::isfinite(estimate.parallaxRad)) {
        refuse(text("The estimate of ", which, " is damaged. Estimate it again."));
    }
}

// Refuses input that cannot be solved, naming the photo or the pair.
void checkInput(std::span<const PhotoPrior> photos, std::span<const PhotoPair> pairs,
                std::span<const PairEstimate> estimates) {
    if (pairs.size() != estimates.size()) {
        refuse(text("There are ", pairs.size(), " pairs but ", estimates.size(), " estimates."));
    }
    for (const PhotoPrior& photo : photos) {
        checkPhoto(photo);
    }
    const int count = static_cast<int>(photos.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const PhotoPair& pair = pairs[i];
        const std::string which = text("the pair of photos ", pair.a, " and ", pair.b);
        if (pair.a < 0 || pair.b <= pair.a || pair.b >= count) {
            refuse(text("There is no such pair of ", count, " photos: ", which, "."));
        }
        checkEstimate(estimates[i], pair, which);
    }
}

} // namespace

void SolveOptions::validate() const {
    if (!(placementSigmaM >= 0 && placementSigmaM <= 10)) {
        refuse(
            text("The uncertainty of a rail's place must be between 0 and 10 m, not ", placementSigmaM, "."));
    }
    if (!(placementSigma.value() >= 0 && placementSigma.value() <= 3.15)) {
        refuse("The uncertainty of a rail's heading must be between 0 and 180 degrees.");
    }
    if (!(heldOutShare > 0 && heldOutShare <= 0.5)) {
        refuse(
            text("The share of held-out matches must be above 0 and at most 0.5, not ", heldOutShare, "."));
    }
    if (threads < 0 || threads > 1024) {
        refuse(text("The number of threads must be between 0 and 1024, not ", threads, "."));
    }
}

namespace {

constexpr int kMostMatches = 250;
constexpr double kGoodHeadingShare = 0.7;
constexpr double kGoodAgreeingShare = 0.5;

std::vector<std::vector<int>> inlierTracks(std::span<const PhotoPair> pairs,
                                           std::span<const PairEstimate> estimates) {
    std::vector<std::vector<bool>> isUsed;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const bool holds = estimates[i].verdict == PairVerdict::Constraint;
        isUsed.push_back(holds ? estimates[i].isInlier : std::vector<bool>(pairs[i].matches.size(), false));
    }
    return tracks(pairs, isUsed);
}

ComponentInput inputOf(const Component& component, std::span<const PhotoPrior> priors,
                       const Candidates& candidates, const SolveOptions& options) {
    ComponentInput input;
    input.priors = priors;
    input.candidates = candidates;
    input.options = &options;
    input.selection.mostAPair = kMostMatches;
    input.selection.threads = options.threads;
    input.candidates.indexOf.assign(priors.size(), -1);
    for (std::size_t i = 0; i < component.photos.size(); ++i) {
        input.candidates.indexOf[static_cast<std::size_t>(component.photos[i])] = static_cast<int>(i);
    }
    for (const GraphEdge& edge : component.edges) {
        input.candidates.chosen.push_back(edge.pair);
    }
    return input;
}

/// Whether the tags are too rough to say how most neighbours lie from each other. Then places are solved
/// along: a model without them would explain the matches by turns.
bool areRough(const Component& component, std::span<const PhotoPrior> priors,
              std::span<const PairEstimate> estimates) {
    constexpr double kRoughRad = 0.1;
    constexpr double kLeastParallaxRad = 0.02; // The lenses of one camera make half of it.
    std::vector<double> sigmas;
    for (const GraphEdge& edge : component.edges) {
        const PairEstimate& estimate = estimates[static_cast<std::size_t>(edge.pair)];
        const PhotoPrior& a = priors[static_cast<std::size_t>(estimate.a)];
        const PhotoPrior& b = priors[static_cast<std::size_t>(estimate.b)];
        const double apart = (b.positionM - a.positionM).norm();
        if (estimate.baselineInA && estimate.parallaxRad > kLeastParallaxRad && apart > 0) {
            sigmas.push_back(waySigmaM(a, b) / apart);
        }
    }
    return !sigmas.empty() && median(std::move(sigmas)) > kRoughRad;
}

ComponentState startOf(const Component& component, std::span<const PhotoPrior> priors,
                       const RoomOrientation& orientation) {
    std::vector<Eigen::Quaterniond> rotations;
    for (const Eigen::Quaterniond& componentFromPhoto : component.componentFromPhoto) {
        rotations.push_back((orientation.roomFromComponent * componentFromPhoto).normalized());
    }
    return {unknowns(component.photos, priors, rotations), {}, 1, 0};
}

struct SolveAttempt {
    ComponentState state;
    ModelChoice choice;
    RoomOrientation orientation;
    SolutionQuality quality;
    std::vector<PairSides> sides;
    TravelSign travel = TravelSign::Unclear;
};

// Turns back what is half a turn off, as long as more matches then agree.
void turnBackHalves(const ComponentInput& input, SolveAttempt& made, ProgressSink& progress,
                    const std::stop_token& stop) {
    constexpr int kMostRounds = 3;
    for (int round = 0; round < kMostRounds; ++round) {
        ComponentState turned = made.state;
        if (turnHalves(input, turned) == 0) {
            return;
        }
        solveModel(input, made.choice.model, true, turned, progress, stop);
        SolutionQuality better = quality(input, turned);
        if (better.agreeingShare <= made.quality.agreeingShare) {
            return;
        }
        made.state = std::move(turned);
        made.quality = std::move(better);
    }
}

SolveAttempt attempt(const Component& component, const ComponentInput& input,
                     const RoomOrientation& orientation, Model wanted, ProgressSink& progress,
                     const std::stop_token& stop) {
    SolveAttempt made;
    made.orientation = orientation;
    made.state = startOf(component, input.priors, made.orientation);
    made.choice.model = wanted;
    ProgressStep choosing(progress, 0, wanted == Model::Auto ? 0.5 : 0);
    ProgressStep solving(progress, wanted == Model::Auto ? 0.5 : 0, 1);
    if (wanted == Model::Auto) {
        made.choice = chooseModel(input, made.state, choosing, stop);
    }
    solveModel(input, made.choice.model, wanted == Model::Auto, made.state, solving, stop);
    if (turnStrays(input, made.choice.model, made.state) > 0) {
        solveModel(input, made.choice.model, true, made.state, solving, stop);
    }
    made.quality = quality(input, made.state);
    turnBackHalves(input, made, solving, stop);
    made.sides = pairSides(input, made.state);
    made.travel = travelSign(made.sides);
    return made;
}

/// Whether more matches agree with one solution than with the other. Where places are solved along, any
/// heading has places with which the matches agree; of two such solutions the one nearer to the tags wins.
bool isBetter(const ComponentInput& input, const SolveAttempt& one, const SolveAttempt& other) {
    constexpr double kAlike = 0.3;
    const double more = one.quality.agreeingShare - other.quality.agreeingShare;
    if (input.candidates.solvesPlaces && std::abs(more) < kAlike) {
        return tagMisfit(one.state.unknowns, input.priors) < tagMisfit(other.state.unknowns, input.priors);
    }
    return more > 0;
}

// The solution at the likeliest heading or, if the matches speak against it, at the next ones.
SolveAttempt bestAttempt(const Component& component, const ComponentInput& input,
                         std::span<const PairEstimate> estimates, Model wanted, ProgressSink& progress,
                         const std::stop_token& stop) {
    const bool solvesPlaces = input.candidates.solvesPlaces;
    std::optional<SolveAttempt> best;
    for (const RoomOrientation& orientation : orientations(component, input.priors, estimates)) {
        SolveAttempt made = attempt(component, input, orientation, wanted, progress, stop);
        if (!best || isBetter(input, made, *best)) {
            best = std::move(made);
        }
        if ((best->quality.agreeingShare > kGoodAgreeingShare && !solvesPlaces) ||
            !best->orientation.hasHeading) {
            break;
        }
    }
    if (best->orientation.hasHeading && (best->travel != TravelSign::Right || solvesPlaces)) {
        RoomOrientation reversed = best->orientation;
        reversed.roomFromComponent = yawRotation(Degrees(180)) * reversed.roomFromComponent;
        reversed.agreeingShare = 1 - reversed.agreeingShare;
        SolveAttempt made = attempt(component, input, reversed, wanted, progress, stop);
        if (made.travel == TravelSign::Right && isBetter(input, made, *best)) {
            best = std::move(made);
        }
    }
    return std::move(*best);
}

/// Believes the priors as far as the solved places bear them out, and no match that nothing confirms, and
/// solves again. options: those of the input, as are the priors.
void reconsider(std::vector<PhotoPrior>& priors, SolveOptions& options, const ComponentInput& input,
                SolveAttempt& made, ProgressSink& progress, const std::stop_token& stop) {
    const bool isWider = widenPriors(priors, input, made.choice.model, made.state, progress, stop);
    const bool isNarrower =
        options.areTagged && !input.candidates.solvesPlaces &&
        narrowPriors(priors, options, input, made.choice.model, made.state, progress, stop);
    const bool isDropped = dropSelfWilled(input, made.choice.model, made.state, progress, stop);
    if (isWider || isNarrower || isDropped) {
        made.quality = quality(input, made.state);
        made.sides = pairSides(input, made.state);
        made.travel = travelSign(made.sides);
    }
}

void warnOfComponents(Alignment& alignment, const PoseGraph& graph, std::span<const PhotoPrior> priors) {
    for (std::size_t i = 1; i < graph.components.size(); ++i) {
        alignment.warnings.push_back(
            text("The survey falls into ", graph.components.size(), " parts that share no photo pair; part ",
                 i + 1, " is ", namesOf(graph.components[i].photos, priors),
                 ". Each part is aligned for itself, by its positions: take photos between them."));
    }
}

void warnOfQuality(Alignment& alignment, const Component& component, const SolveAttempt& made,
                   std::span<const PhotoPrior> priors) {
    const std::string which = namesOf(component.photos, priors);
    if (!made.orientation.hasHeading) {
        alignment.warnings.push_back(
            text("Nothing fixes the common heading of ", which,
                 ": they stand at one place. Only how they are turned to each other is known."));
        return;
    }
    if (made.orientation.agreeingShare < kGoodHeadingShare) {
        alignment.warnings.push_back(text("The positions of ", which,
                                          " contradict what the photos show of them (",
                                          static_cast<int>(100 * made.orientation.agreeingShare),
                                          " % of the directions agree). They seem to be off by about ",
                                          fixed(made.orientation.positionErrorM, 2),
                                          " m. Check the position tags, or state how rough they are."));
    }
    if (made.quality.agreeingShare < kGoodAgreeingShare) {
        alignment.warnings.push_back(text("The alignment of ", which, " is doubtful: only ",
                                          static_cast<int>(100 * made.quality.agreeingShare),
                                          " % of the matches that pairs agreed on fit it."));
    }
}

/// Positions that most baselines contradict, and that the matches do not correct, are off by as much as these
/// say.
void widenPlaces(const Component& component, const RoomOrientation& orientation, Alignment& alignment) {
    if (!orientation.hasHeading || orientation.agreeingShare >= kGoodHeadingShare) {
        return;
    }
    for (const int photo : component.photos) {
        SolvedPose& pose = alignment.photos[static_cast<std::size_t>(photo)];
        pose.sigmaPositionM = std::hypot(pose.sigmaPositionM, orientation.positionErrorM);
        pose.sigmaOwnPositionM = std::hypot(pose.sigmaOwnPositionM, orientation.positionErrorM);
    }
}

std::string whyUnsolved(std::span<const PhotoPrior> photos, std::span<const PairEstimate> estimates,
                        int photo) {
    if (photos.size() == 1) {
        return "There is no other photo to compare it with.";
    }
    int pairs = 0;
    int held = 0;
    for (const PairEstimate& estimate : estimates) {
        if (estimate.a == photo || estimate.b == photo) {
            ++pairs;
            held += estimate.verdict == PairVerdict::Constraint ? 1 : 0;
        }
    }
    if (pairs == 0) {
        return "It was compared with no other photo.";
    }
    if (held == 0) {
        return "No neighbour shares enough with it.";
    }
    return 2 * held < pairs ? text("Compared with ", pairs, " photos, it shares enough with ", held,
                                   ", and nothing confirms that.")
                            : "What its neighbours say of it contradicts what they say of each other.";
}

} // namespace

Alignment solve(std::span<const PhotoPrior> photos, std::span<const PhotoPair> pairs,
                std::span<const PairEstimate> estimates, const SolveOptions& options, ProgressSink& progress,
                const std::stop_token& stop) {
    options.validate();
    checkInput(photos, pairs, estimates);
    throwIfStopped(stop);
    progress.progress(0, "Averaging rotations");
    Alignment alignment;
    alignment.photos.resize(photos.size());
    for (std::size_t i = 0; i < photos.size(); ++i) {
        alignment.photos[i].roomFromPhoto.translation = photos[i].positionM;
        alignment.photos[i].why = whyUnsolved(photos, estimates, static_cast<int>(i));
    }
    const int count = static_cast<int>(photos.size());
    PoseGraph graph = poseGraph(count, estimates);
    const std::vector<bool> confirmed =
        options.areTagged ? confirmedByTags(graph, photos, estimates) : std::vector<bool>();
    if (std::ranges::find(confirmed, true) != confirmed.end()) {
        graph = poseGraph(count, estimates, 0, confirmed);
    }
    alignment.cycleErrorRad = graph.cycleErrorRad;
    alignment.components = static_cast<int>(graph.components.size());
    const std::vector<std::vector<int>> trackOf = inlierTracks(pairs, estimates);
    const std::vector<double> noise = photoNoise(photos.size(), pairs, estimates);
    const Candidates candidates{pairs, estimates, trackOf, {}, {}, noise};
    alignment.model = options.model == Model::Auto ? Model::Yaw : options.model;
    alignment.reason = options.model == Model::Auto ? "There was nothing to solve." : "It was asked for.";
    warnOfComponents(alignment, graph, photos);
    std::vector<PhotoPrior> priors(photos.begin(), photos.end());
    double done = 0.02;
    for (std::size_t i = 0; i < graph.components.size(); ++i) {
        const Component& component = graph.components[i];
        const double share =
            0.98 * static_cast<double>(component.photos.size()) / static_cast<double>(photos.size());
        ProgressStep step(progress, done, done + 0.9 * share);
        done += share;
        SolveOptions own = options;
        ComponentInput input = inputOf(component, priors, candidates, own);
        // The largest component chooses the model: small ones have too little to choose by.
        Model wanted = i == 0 ? options.model : alignment.model;
        const bool isRough = areRough(component, priors, estimates);
        if (wanted == Model::Auto && isRough) {
            wanted = Model::Position;
            alignment.reason = "The position tags are stated to be too rough for any other.";
        }
        input.candidates.solvesPlaces = isRough && solvesPosition(wanted);
        SolveAttempt made = bestAttempt(component, input, estimates, wanted, step, stop);
        reconsider(priors, own, input, made, step, stop);
        if (input.candidates.solvesPlaces && made.orientation.agreeingShare < 0.5) {
            made.travel = TravelSign::Unclear; // Most directions speak against the way that it looks.
        }
        if (i == 0) {
            alignment.model = made.choice.model;
            alignment.trials = made.choice.trials;
            alignment.reason = made.choice.reason.empty() ? alignment.reason : made.choice.reason;
        }
        warnOfQuality(alignment, component, made, photos);
        const double commonLeanRad =
            report(input, made.choice.model, made.state, made.quality, made.orientation.hasHeading,
                   static_cast<int>(i), alignment, stop);
        for (const std::string& sentence :
             leanWarnings(alignment, input, made.state, commonLeanRad, namesOf(component.photos, photos))) {
            alignment.warnings.push_back(sentence);
        }
        doubtPhotos(input, made.state, made.sides, made.travel, alignment);
        if (!input.candidates.solvesPlaces) {
            widenPlaces(component, made.orientation, alignment);
        }
    }
    progress.progress(1, "Solved");
    return alignment;
}

} // namespace spherewalk::align
