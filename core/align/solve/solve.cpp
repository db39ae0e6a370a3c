// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/solve.h"

#include "component_solver.h"
#include "pose_graph.h"
#include "room_orientation.h"
#include "solution_report.h"
#include "solve_input.h"
#include "tracks.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::align {

namespace {

constexpr int kMostMatches = 250;
constexpr double kGoodHeadingShare = 0.7;
constexpr double kGoodAgreeingShare = 0.5;
constexpr int kHeadingsTried = 3;

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

ComponentState startOf(const Component& component, std::span<const PhotoPrior> priors,
                       const RoomOrientation& orientation) {
    std::vector<Eigen::Quaterniond> rotations;
    for (const Eigen::Quaterniond& rootFromPhoto : component.rootFromPhoto) {
        rotations.push_back((orientation.roomFromRoot * rootFromPhoto).normalized());
    }
    return {unknowns(component.photos, priors, rotations), {}, 1, 0};
}

struct Attempt {
    ComponentState state;
    ModelChoice choice;
    RoomOrientation orientation;
    SolutionQuality quality;
};

Attempt attempt(const Component& component, const ComponentInput& input,
                std::span<const PairEstimate> estimates, Model wanted, int rank, ProgressSink& progress,
                const std::stop_token& stop) {
    Attempt made;
    made.orientation = roomOrientation(component, input.priors, estimates, rank);
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
    return made;
}

// The heading that the positions speak for; if the matches then speak against it, the next ones.
Attempt bestAttempt(const Component& component, const ComponentInput& input,
                    std::span<const PairEstimate> estimates, Model wanted, ProgressSink& progress,
                    const std::stop_token& stop) {
    Attempt best;
    for (int rank = 0; rank < kHeadingsTried; ++rank) {
        Attempt made = attempt(component, input, estimates, wanted, rank, progress, stop);
        if (rank == 0 || made.quality.agreeingShare > best.quality.agreeingShare) {
            best = std::move(made);
        }
        if (best.quality.agreeingShare > kGoodAgreeingShare || !best.orientation.hasHeading) {
            break;
        }
    }
    return best;
}

std::string photosText(const Component& component, std::span<const PhotoPrior> priors) {
    std::string names;
    constexpr std::size_t kNamed = 5;
    for (std::size_t i = 0; i < std::min(component.photos.size(), kNamed); ++i) {
        names += text(i == 0 ? "" : ", ",
                      printable(priors[static_cast<std::size_t>(component.photos[i])].name, 40));
    }
    return component.photos.size() > kNamed ? text(names, " and ", component.photos.size() - kNamed, " more")
                                            : names;
}

void warn(Alignment& alignment, ProgressSink& progress, const std::string& sentence) {
    alignment.warnings.push_back(sentence);
    progress.warning(sentence);
}

void warnOfParts(Alignment& alignment, const PoseGraph& graph, std::span<const PhotoPrior> priors,
                 ProgressSink& progress) {
    for (std::size_t i = 1; i < graph.components.size(); ++i) {
        warn(alignment, progress,
             text("The survey falls into ", graph.components.size(), " parts that share no photo pair; part ",
                  i + 1, " is ", photosText(graph.components[i], priors),
                  ". Each part is aligned for itself, by its positions: take photos between them."));
    }
}

void warnOfQuality(Alignment& alignment, const Component& component, const Attempt& made,
                   std::span<const PhotoPrior> priors, ProgressSink& progress) {
    const std::string which = photosText(component, priors);
    if (!made.orientation.hasHeading) {
        warn(alignment, progress,
             text("Nothing fixes the common heading of ", which,
                  ": they stand at one place. Only how they are turned to each other is known."));
        return;
    }
    if (made.orientation.agreeingShare < kGoodHeadingShare) {
        warn(alignment, progress,
             text("The positions of ", which, " contradict what the photos show of them (",
                  static_cast<int>(100 * made.orientation.agreeingShare),
                  " % of the directions agree). Check the position tags."));
    }
    if (made.quality.agreeingShare < kGoodAgreeingShare) {
        warn(alignment, progress,
             text("The alignment of ", which, " is doubtful: only ",
                  static_cast<int>(100 * made.quality.agreeingShare),
                  " % of the matches that pairs agreed on fit it."));
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
    return held == 0 ? "No neighbour shares enough with it."
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
    const PoseGraph graph = poseGraph(static_cast<int>(photos.size()), estimates);
    alignment.cycleErrorRad = graph.cycleErrorRad;
    alignment.components = static_cast<int>(graph.components.size());
    const std::vector<std::vector<int>> trackOf = inlierTracks(pairs, estimates);
    const Candidates candidates{pairs, estimates, trackOf, {}, {}};
    alignment.model = options.model == Model::Auto ? Model::Yaw : options.model;
    alignment.reason = options.model == Model::Auto ? "There was nothing to solve." : "It was asked for.";
    warnOfParts(alignment, graph, photos, progress);
    double done = 0.02;
    for (std::size_t i = 0; i < graph.components.size(); ++i) {
        const Component& component = graph.components[i];
        const double share =
            0.98 * static_cast<double>(component.photos.size()) / static_cast<double>(photos.size());
        ProgressStep step(progress, done, done + 0.9 * share);
        done += share;
        const ComponentInput input = inputOf(component, photos, candidates, options);
        // The largest part chooses the model: small ones have too little to choose by.
        const Model wanted = i == 0 ? options.model : alignment.model;
        const Attempt made = bestAttempt(component, input, estimates, wanted, step, stop);
        if (i == 0) {
            alignment.model = made.choice.model;
            alignment.trials = made.choice.trials;
            alignment.reason = made.choice.reason.empty() ? alignment.reason : made.choice.reason;
        }
        warnOfQuality(alignment, component, made, photos, progress);
        report(input, made.choice.model, made.state, made.quality, made.orientation.hasHeading,
               static_cast<int>(i), alignment, stop);
    }
    progress.progress(1, "Solved");
    return alignment;
}

} // namespace spherewalk::align
