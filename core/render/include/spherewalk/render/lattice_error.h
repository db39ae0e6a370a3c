// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/progress.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/scene_model.h"

#include <array>
#include <stop_token>
#include <string>
#include <string_view>

namespace spherewalk::render {

/// How far the coordinates that views are made with lie from the exact ones: what resources/docs/render.md
/// bounds, measured. The reference follows the definitions in long double and shares no code with them.

/// One view of a photo of 5376 x 2688 pixels.
struct LatticeCase {
    CameraModel camera;
    Rigid3 roomFromCamera; ///< of the optical frame
    Rigid3 roomFromPhoto;
    SceneKind scene = SceneKind::None;
    double sphereRadiusM = 1;
    int samplesPerAxis = 1;     ///< of each pixel, as footprints have them
    double tolerancePx = 0.018; ///< that the interpolation is to keep; views are made with 0.018
};

/// Of one view or of many. Units: angles on the sphere, in pixels of the photo at its equator.
struct LatticeError {
    double worstPx = 0;          ///< infinity if a coordinate is none
    std::string where;           ///< of the worst: pixel, camera, how it was computed
    double worstToBound = 0;     ///< the greatest ratio of an interpolation's error to its bound
    std::array<long, 4> cells{}; ///< of 16 x 16 pixels: coarse, fine, finest, exact
    long samples = 0;            ///< compared
    bool isInRange = true;       ///< no coordinate leaves the photo and its guard

    void add(const LatticeError& other);
};

/// Compares every seventh sample of each cell of the view.
LatticeError latticeError(const LatticeCase& view);

/// Where the worst error is looked for. The views of each are random, and the same on every run.
enum class LatticeSearch {
    AnyDirection, ///< fields of view from 1 to 179 degrees, any direction
    PolesAndSeam, ///< the same fields, looking at or past the poles and the seam
    Displaced,    ///< up to 0.95 of the sphere's radius from the photo, in rooms up to 10^6 m from the origin
    EveryLens,    ///< plumb_bob, rational_polynomial and equidistant, displaced
};

inline constexpr std::array kLatticeSearches{LatticeSearch::AnyDirection, LatticeSearch::PolesAndSeam,
                                             LatticeSearch::Displaced, LatticeSearch::EveryLens};

/// For people: "any direction".
std::string_view name(LatticeSearch search);

/// everyNth: of the search's views, 1 for all; no multiple of 2 or 3, since these tell their kinds apart.
/// Errors: Stopped. Cost: some seconds.
LatticeError searchLattice(LatticeSearch search, int everyNth = 1, ProgressSink& progress = noProgress(),
                           const std::stop_token& stop = {});

} // namespace spherewalk::render
