// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/features.h"
#include "spherewalk/geometry/angle.h"

#include <Eigen/Geometry>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::align {

/// What is known of a photo before its picture is looked at.
/// Frames: positions in the room frame; a photo's own frame is its panorama frame (x forward, y left, z up).
struct PhotoPrior {
    std::string name; ///< The name that sentences for people use.
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero();
    double positionSigmaM = 0.005; ///< Standard deviation along x and along y.
    /// Standard deviation of the height against the other photos' heights. A cart keeps its height far better
    /// than its place on the floor, and the heights tell what is level.
    double heightSigmaM = 0.001;
    int placement = -1; ///< Index of the rail; -1 for a photo that stands on none.
    int stop = 0;       ///< Index along the rail.
    /// Turns the photo upright, as the photo's own metadata say; empty if they do not say.
    std::optional<Eigen::Quaterniond> levelFromPhoto;
    Radians tiltSigma = Degrees(0.5); ///< Standard deviation of pitch and of roll after levelFromPhoto.
    std::optional<Vertical> seenVertical = {}; ///< What the photo itself shows, as findVertical() says.
};

/// The direction that is up by what the photo's metadata say. For a photo that says nothing it is z, with
/// 0.17 rad, since cameras make photos upright.
Vertical statedUp(const PhotoPrior& prior);

/// The direction that is up by all that is known: by the photo's upright edges, which are believed to 0.1
/// degrees, unless they contradict its metadata by more than five standard deviations; else by its metadata.
Vertical knownUp(const PhotoPrior& prior);

/// Whether knownUp() is more than the guess that cameras make photos upright.
bool saysUp(const PhotoPrior& prior);

/// Turns knownUp() up by the smallest rotation from what the metadata say.
Eigen::Quaterniond levelFromPhoto(const PhotoPrior& prior);

/// One thing that two photos see: a unit vector in each photo's frame.
struct Correspondence {
    Eigen::Vector3d inA = Eigen::Vector3d::UnitX();
    Eigen::Vector3d inB = Eigen::Vector3d::UnitX();
    double sigmaRad = 0; ///< Standard deviation of either bearing, along any direction across it.
    int featureA = -1;   ///< Index among a's features, the same in all pairs of a; -1 if unknown.
    int featureB = -1;   ///< Index among b's features; -1 if unknown.
};

/// All matches of two photos. Many of them may be wrong.
struct PhotoPair {
    int a = 0; ///< Index among the photos, less than b.
    int b = 0;
    std::vector<Correspondence> matches;
    /// Number of the look that found the matches. What one look finds in a photo, another may miss.
    int look = 0;
};

enum class PairVerdict {
    Constraint,  ///< The matches agree on one rotation.
    TooFew,      ///< There are too few matches, or too few that agree.
    TooNarrow,   ///< The matches that agree lie in one direction and leave the rotation open.
    NoAgreement, ///< No rotation explains a sufficient share.
};

/// The verdict as reports spell it: "constraint", "too_few", "too_narrow", "no_agreement".
std::string_view name(PairVerdict verdict);

/// How two photos are turned to each other, from their matches alone. Positions and tilts are not used.
struct PairEstimate {
    int a = 0;
    int b = 0;
    PairVerdict verdict = PairVerdict::TooFew;
    int inliers = 0;
    double inlierShare = 0;     ///< Share of the matches that are inliers.
    double spread = 0;          ///< Least eigenvalue of the mean of (I - b b^T) over the inliers, [0, 2/3].
    std::vector<bool> isInlier; ///< One entry a match.
    Eigen::Quaterniond aFromB = Eigen::Quaterniond::Identity();   ///< Has a meaning for Constraint alone.
    Eigen::Matrix3d rotationCovariance = Eigen::Matrix3d::Zero(); ///< Of a small turn in a's frame, rad^2.
    /// The direction from a to b in a's frame; it points to where the inliers lie in front of both photos.
    /// Empty where the parallax is too small to tell.
    std::optional<Eigen::Vector3d> baselineInA;
    double baselineSigmaRad = 0; ///< Standard deviation of baselineInA.
    double parallaxRad = 0;      ///< Median angle by which inliers moved, beyond the rotation.
    double forwardShare = 0;     ///< Share of the inliers with measurable parallax that lie in front.
};

struct PairOptions {
    int leastInliers = 15;
    double leastShare = 0.15; ///< A mirror image reaches a share of 0.14 by chance.
    int threads = 0;          ///< 0 means all that the machine has.
    /// How far a thing may move between two photos that are turned alike, below a right angle. The floor 1.2
    /// m below moves by 0.6 seen from 0.8 m farther.
    Radians reach = Radians(0.6);
    /// Bearings nearer to the baseline are not asked, by the sine of the angle. Along a corridor most things
    /// lie there; but a wrong match among them turns the baseline. Range: large against the bearings' errors.
    double leastSine = 0.12;
    /// Which way is up in each photo, as far as that is known; empty if nothing is. It shows where to look
    /// for the rotation, and decides between rotations that explain nearly as many matches.
    std::vector<Vertical> ups = {};
};

/// The rotation and the baseline that most matches of the pair agree on. The same input gives the same
/// result. Threads: any. Cost: about a millisecond for some hundred matches.
PairEstimate estimatePair(const PhotoPair& pair, const PairOptions& options = {});

/// estimatePair() of each pair, in their order, on PairOptions::threads threads.
std::vector<PairEstimate> estimatePairs(std::span<const PhotoPair> pairs, const PairOptions& options = {});

} // namespace spherewalk::align
