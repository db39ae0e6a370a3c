// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/json_fwd.h"
#include "spherewalk/geometry/camera_model.h"

#include <string>
#include <string_view>

namespace spherewalk::render {

/// The ladder: what a view is computed with, from cheap to exact. It has two sides, the scene model and the
/// sampling. A dataset may hold the choice that was measured to be enough.

/// What the scene is taken to be when a camera stands beside the photo, cheap to exact.
enum class SceneKind {
    None,   ///< Everything is infinitely far: the nearest photo is only turned.
    Sphere, ///< Everything lies on a sphere about the photo. Source: Chachula and Stefanczyk.
    Room,   ///< There are walls, a floor and a ceiling, and nothing else.
    Depth,  ///< The distance of each of the photo's pixels was measured.
    Blend,  ///< The distances are those of Depth, and photos that agree are mixed.
};

/// Whether a model of this kind gives each photo a surface, so that things hide each other.
constexpr bool hasSurfaces(SceneKind kind) {
    return kind == SceneKind::Room || kind == SceneKind::Depth || kind == SceneKind::Blend;
}

/// Whether a model of this kind is made of the distances that were measured for each of the photo's pixels.
constexpr bool usesDepths(SceneKind kind) {
    return kind == SceneKind::Depth || kind == SceneKind::Blend;
}

/// The word that options and files use: "none", "sphere", "room", "depth", "blend".
std::string_view name(SceneKind kind);

/// The scene model of that word. Errors: InvalidInput, with all the words.
SceneKind sceneKind(std::string_view name);

/// How a view's pixel is made from the photo's pixels, cheap to exact. resources/docs/render.md tells what
/// each costs and how large its error is.
enum class Sampling {
    Nearest,  ///< It takes the nearest pixel.
    Bilinear, ///< It interpolates four pixels. It is right where view and photo have equal pixels per degree.
              ///< Where the view has fewer, details flicker.
    Reduced, ///< It is bilinear on the photo at half its size. It is softer, and details do not flicker up to
             ///< a minification of about two.
    Footprint, ///< It takes the mean of n x n bilinear samples over the view's pixel, n from 2 to 8. At the
               ///< picture's centre samples are at most 1.5 photo pixels apart, up to a minification of 12.
               ///< It is right when minifying.
    Bicubic,   ///< It interpolates sixteen pixels. It is right where the view has more pixels per degree.
    Best,      ///< It is Bicubic where the photo is magnified, and Footprint elsewhere.
    Auto,      ///< It is the choice of chosenSampling() from Reduced, Bilinear and Footprint.
};

/// The word that options and files use: "nearest", "bilinear", "reduced", "footprint", "bicubic", "best",
/// "auto".
std::string_view name(Sampling sampling);

/// The sampling of that word. Errors: InvalidInput, with all the words.
Sampling sampling(std::string_view name);

/// How many photo pixels one view pixel spans at the middle of the picture, along the view's axis with the
/// larger span. It is 0 if the lens sees nothing there.
double minification(const CameraModel& camera, int photoWidth);

/// How many samples each pixel has along an axis: 2 to 8 for Footprint, else 1. sampling: neither Best nor
/// Auto.
int samplesPerAxis(Sampling sampling, double minification);

/// How near a sampling comes, at worst, to the mean over each pixel's area. It was measured on pictures full
/// of detail and promises nothing for others. Below a minification of 0.47 and above 3.82 the value at that
/// end holds. Units: decibels (peak signal to noise ratio). sampling: neither Best nor Auto.
double expectedDb(Sampling sampling, double minification);

/// The sampling that a view takes. Best stands for Bicubic below a minification of 1, else for Footprint.
/// Auto stands for the cheapest of Reduced and Bilinear that is expected to reach the tolerance, and for
/// Footprint if neither is. All others stand for themselves.
Sampling chosenSampling(Sampling sampling, double minification, double toleranceDb);

/// The choice that "auto" stands for, as it was measured on the dataset itself against a tolerance. A photo
/// may name another scene model of its own.
struct ViewChoice {
    SceneKind scene = SceneKind::None;
    Sampling sampling = Sampling::Footprint; ///< This is neither Best nor Auto.
    double tolerancePx = 0;                  ///< The user asked for this tolerance.
    double errorPx = 0; ///< The measured error: in 95 of 100 spots of a view the displacement is no larger.
    double focalPx = 0; ///< The longer of fx and fy of the camera that the error was measured for.
    std::string reason; ///< Sentences tell people why.

    bool operator==(const ViewChoice&) const = default;

    bool isWithin() const { return errorPx <= tolerancePx; }

    /// Whether the choice holds for this camera: its fx and fy are at most 5 % longer than focalPx. With a
    /// longer focal length the same error is more pixels. Lens and size do not matter.
    bool isFor(const CameraIntrinsics& camera) const;
};

/// The scene model that a member names. Errors: Corrupt, with the member's path.
SceneKind sceneKind(const JsonReader& reader, std::string_view key);

/// The choice as dataset.json holds it.
Json toJson(const ViewChoice& choice);

/// The choice that toJson() wrote. Errors: Corrupt, with the member's path, for unknown names and impossible
/// numbers.
ViewChoice parseViewChoice(const JsonReader& reader);

} // namespace spherewalk::render
