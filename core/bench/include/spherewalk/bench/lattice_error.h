// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/ladder.h"

#include <array>
#include <stop_token>
#include <string>
#include <string_view>

namespace spherewalk::bench {

/// How far the coordinates that views are made with lie from the exact ones. resources/docs/render.md bounds
/// this error; here it is measured. The reference follows the definitions in long double and shares no code
/// with the renderer.

/// One view of a photo of 5376 x 2688 pixels.
struct LatticeCase {
    CameraModel camera;
    Rigid3 roomFromCamera; ///< The pose of the optical frame.
    Rigid3 roomFromPhoto;
    render::SceneKind scene = render::SceneKind::None;
    double sphereRadiusM = 1;
    int samplesPerAxis = 1;     ///< Samples of each pixel along an axis, as footprints have them.
    double tolerancePx = 0.018; ///< The bound that the interpolation must keep; views are made with 0.018.
};

/// The error of one view or of many. Units: angles on the sphere, in pixels of the photo at its equator.
struct LatticeError {
    double worstPx = 0;          ///< It is infinity if a coordinate is no number.
    std::string where;           ///< The worst pixel, its camera, and how it was computed.
    double worstToBound = 0;     ///< The greatest ratio of an interpolation's error to its bound.
    std::array<long, 4> cells{}; ///< The numbers of cells that are coarse, fine, finest and exact.
    long samples = 0;            ///< The number of samples that were compared.
    bool isInRange = true;       ///< Whether all coordinates lie in the photo and its guard.

    /// Makes this the error of all views of both.
    void add(const LatticeError& other);
};

/// The error of every seventh sample of each cell of the view.
LatticeError latticeError(const LatticeCase& view);

/// The views among which the worst error is looked for. They are random, and the same on every run.
enum class LatticeSearch {
    AnyDirection, ///< Fields of view from 1 to 179 degrees, in any direction.
    PolesAndSeam, ///< The same fields, looking at or past the poles and the seam.
    Displaced, ///< Up to 0.95 of the sphere's radius from the photo, in rooms up to 10^6 m from the origin.
    EveryLens, ///< Displaced cameras with plumb_bob, rational_polynomial and equidistant lenses.
};

inline constexpr std::array kLatticeSearches{LatticeSearch::AnyDirection, LatticeSearch::PolesAndSeam,
                                             LatticeSearch::Displaced, LatticeSearch::EveryLens};

/// The name for people: "any direction".
std::string_view name(LatticeSearch search);

/// The worst error of a search. everyNth: every so many of its views are taken, 1 for all. Do not give a
/// multiple of 2 or 3, since these tell the kinds of views apart. Errors: Stopped. Cost: some seconds.
LatticeError searchLattice(LatticeSearch search, int everyNth = 1, ProgressSink& progress = noProgress(),
                           const std::stop_token& stop = {});

} // namespace spherewalk::bench
