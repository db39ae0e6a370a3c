// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/solution_report.h"

#include "spherewalk/base/text.h"

#include <algorithm>

namespace spherewalk::align {

namespace {

constexpr double kSaidLeanRad = Radians(Degrees(3)).value();
constexpr double kSaidCommonLeanRad = Radians(Degrees(0.15)).value();

// Whether the photos stand along one line, to a tenth of its length.
bool isOnOneLine(const ComponentState& state) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    std::vector<Eigen::Vector3d> positionsM;
    for (const PhotoState& photo : state.unknowns.states()) {
        positionsM.push_back(photo.positionM);
        middle += photo.positionM;
    }
    middle /= static_cast<double>(positionsM.size());
    const Eigen::Vector3d along = *std::ranges::max_element(positionsM, {}, [&](const auto& at) {
        return (at - middle).norm();
    }) - middle;
    constexpr double kOnePlaceM = 0.02;
    return along.norm() > kOnePlaceM && std::ranges::all_of(positionsM, [&](const auto& at) {
               return (at - middle).cross(along).norm() < 0.1 * along.squaredNorm();
           });
}

std::string leanDoubt(const SolvedPose& pose, const PhotoPrior& prior) {
    return text("It would lean by ", fixed(Degrees(pose.leanFromStated).value(), 0), " deg from ",
                prior.levelFromPhoto ? "what its camera states of its tilt"
                                     : "upright, though it states no tilt",
                ". Its rotation is therefore not known: check its position, and retake it if that is right.");
}

} // namespace

std::vector<std::string> leanWarnings(const Alignment& alignment, const ComponentInput& input,
                                      const ComponentState& state, double commonLeanRad,
                                      const std::string& which) {
    std::vector<std::string> said;
    if (commonLeanRad > kSaidCommonLeanRad && isOnOneLine(state)) {
        said.push_back(text("All photos of ", which,
                            " lie on one line. Nothing but the tilts that they state holds the turn about "
                            "that line, which is known to ",
                            fixed(Degrees(Radians(commonLeanRad)).value(), 2),
                            " deg (one standard deviation). Add a second rail, or one photo, beside the "
                            "line."));
    }
    const std::vector<int>& photos = state.unknowns.photo;
    const auto leanOfPhoto = [&](int photo) {
        return alignment.photos[static_cast<std::size_t>(photo)].leanFromStated.value();
    };
    const auto leaning =
        std::ranges::count_if(photos, [&](int photo) { return leanOfPhoto(photo) > kSaidLeanRad; });
    if (leaning > 0) {
        const int worst = *std::ranges::max_element(photos, {}, leanOfPhoto);
        said.push_back(
            text(leaning, " of ", photos.size(),
                 " photos lean by more than 3 degrees from what they state, or from upright if they "
                 "state nothing. Most leans ",
                 printable(input.priors[static_cast<std::size_t>(worst)].name, 40), ": by ",
                 fixed(Degrees(Radians(leanOfPhoto(worst))).value(), 1),
                 " deg. If the camera stood level, look at these photos, and at their positions."));
    }
    return said;
}

namespace {

/// Photos that were solved much nearer to a neighbour than rough tags allow. Matches do not tell how long a
/// way is, so a direction that contradicts the tags draws photos together.
std::vector<bool> squeezedPhotos(const ComponentInput& input, const ComponentState& state) {
    std::vector<bool> isSqueezed(state.unknowns.photo.size(), false);
    if (!input.candidates.solvesPlaces) {
        return isSqueezed;
    }
    for (const int at : input.candidates.chosen) {
        const PairEstimate& estimate = input.candidates.estimates[static_cast<std::size_t>(at)];
        const auto a =
            static_cast<std::size_t>(input.candidates.indexOf[static_cast<std::size_t>(estimate.a)]);
        const auto b =
            static_cast<std::size_t>(input.candidates.indexOf[static_cast<std::size_t>(estimate.b)]);
        const double plannedM = (state.unknowns.plannedM[b] - state.unknowns.plannedM[a]).norm();
        const double solvedM = (state.unknowns.state(b).positionM - state.unknowns.state(a).positionM).norm();
        const double sigmaM = waySigmaM(input.priors[static_cast<std::size_t>(estimate.a)],
                                        input.priors[static_cast<std::size_t>(estimate.b)]);
        if (estimate.baselineInA && solvedM < std::max(plannedM - 3 * sigmaM, 0.1 * plannedM)) {
            isSqueezed[a] = isSqueezed[b] = true;
        }
    }
    return isSqueezed;
}

} // namespace

void doubtPhotos(const ComponentInput& input, const ComponentState& state, std::span<const PairSides> sides,
                 TravelSign travel, Alignment& alignment) {
    const std::vector<bool> isUnclear = unclearSides(state, sides);
    const std::vector<bool> isBent = bentPhotos(input, state);
    const std::vector<bool> isSqueezed = squeezedPhotos(input, state);
    // Photos of one place have no way of travel to mistake.
    const bool isSignUnclear = travel != TravelSign::Right &&
                               std::ranges::any_of(sides, [](const auto& pair) { return !pair.isTurn; });
    for (std::size_t i = 0; i < isBent.size(); ++i) {
        const auto at = static_cast<std::size_t>(state.unknowns.photo[i]);
        SolvedPose& pose = alignment.photos[at];
        if (!pose.isSolved) {
            continue;
        }
        if (pose.leanFromStated > kContradictingLean) {
            pose.doubt = leanDoubt(pose, input.priors[at]);
        } else if (isUnclear[i]) {
            pose.doubt = "Half a turn about the line to its neighbours explains what it shows about as well. "
                         "Its rotation is therefore not known: take another photo beside it.";
        } else if (isSignUnclear) {
            pose.doubt = "Which way it looks is not known: too little of what it shares with its neighbours "
                         "lies clearly in front of them, so half a turn explains it as well. Take a photo "
                         "between them, or nearer to things.";
        } else if (isBent[i]) {
            pose.doubt = "How it is turned against the others is not known: its position asks for another "
                         "turn than what it shows in common with its neighbours. Check the positions.";
        } else if (isSqueezed[i]) {
            pose.doubt = "Its place contradicts how far the position tags put it from a neighbour: what both "
                         "show alike may be of two places. Check the positions.";
        }
        if (!pose.doubt.empty()) {
            pose.sigmaYaw = pose.sigmaPitch = pose.sigmaRoll = pose.sigmaOwn = Degrees(180);
        }
    }
}

} // namespace spherewalk::align
