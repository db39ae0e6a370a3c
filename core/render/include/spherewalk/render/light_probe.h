// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/image.h"
#include "spherewalk/render/renderer.h"

#include <Eigen/Core>

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace spherewalk::render {

/// Linear red, green and blue light. Units: 1 is what the photo stores as white.
using RadianceImage = Image<float, 3>;

struct ProbeOptions {
    int width = 512;                ///< Pixels; the probe is half as high. Range: even, 16 to 8192.
    std::optional<SceneKind> scene; ///< As in ViewOptions.
    int threads = 0;                ///< The most to use, 0 for all. The values are the same for any number.
    bool correctsColour = true;     ///< Whether the dataset's colour correction is applied, as to views.

    /// Errors: InvalidInput for a width out of range.
    void validate() const;
};

/// The light that comes to a place from all directions, as the photos show it.
struct LightProbe {
    /// The sphere of directions as geometry/equirect.h has it, in the room's frame: the centre looks along
    /// the room's x. Values are decoded from sRGB. Above 1 they come from darker photos.
    RadianceImage radiance;
    /// Where 255, the light was too bright for all photos: there is more of it. Shape: that of `radiance`.
    MaskImage clipped;
    double clippedShare = 0;   ///< The share of all directions in which the light was too bright.
    double recoveredShare = 0; ///< The share of directions whose light a darker photo showed.
    ViewReport report;         ///< Of the view along the room's x that the probe is made with.
};

/// The light at a place of the room. The view of the sphere is made there as views are. What is clipped in it
/// is looked up in photos that were taken darker: those with a greater exposureGain whose place sees this
/// one. Without such photos nothing is above 1. The camera's foot is in the light from below, as in photos.
///
/// Errors: as Renderer::render(); InvalidInput for a width out of range. Cost: six views of width x width
/// pixels, and a whole decode of up to eight darker photos.
LightProbe lightProbe(const Renderer& renderer, const Eigen::Vector3d& pInRoom,
                      const ProbeOptions& options = {});

/// The picture as a Radiance file (.hdr): 8 bits of red, green, blue and a common exponent. Source: Ward,
/// Real Pixels, Graphics Gems II. Errors: InvalidInput for an empty picture.
Bytes radianceFile(const RadianceImage& picture);

/// Light as real spherical harmonics up to order 2, which give what falls on a matt surface to about 1 %.
/// Source: Ramamoorthi and Hanrahan, An Efficient Representation for Irradiance Environment Maps, 2001.
struct LightHarmonics {
    /// The sums of radiance times harmonic over the sphere, in the order (l, m) = (0, 0), (1, -1), (1, 0),
    /// (1, 1), (2, -2) ... (2, 2). Frames: room.
    std::array<Eigen::Vector3d, 9> coefficients{};

    /// The light that falls on a surface, pi times the radiance of an even sky. A matt surface of an albedo
    /// shows albedo / pi of it. It may be a little below 0 on the dark side of one strong light. normal: a
    /// unit vector.
    Eigen::Vector3d irradiance(const Eigen::Vector3d& normal) const;
};

/// The harmonics of an equirectangular picture of light.
LightHarmonics lightHarmonics(const RadianceImage& radiance);

/// One light from afar and an even light from everywhere, as simulators have them.
struct DominantLight {
    Eigen::Vector3d towards = Eigen::Vector3d::UnitZ();   ///< The unit vector to where the light comes from.
    Eigen::Vector3d irradiance = Eigen::Vector3d::Zero(); ///< What it throws on a surface that faces it.
    Eigen::Vector3d ambient = Eigen::Vector3d::Zero();    ///< The radiance that comes from everywhere.
    /// The dominant light's part of what falls on a surface that faces it, 0 to 1.
    double share = 0;
};

/// The dominant light whose irradiance, with the ambient light's, comes nearest to that of the harmonics over
/// all normals, in least squares. It comes from the direction of the mean luminance. Where light comes evenly
/// from all sides, there is none, and its direction is up. resources/docs/render.md has the formula.
DominantLight dominantLight(const LightHarmonics& harmonics);

/// A light from afar.
struct DirectionalLight {
    Eigen::Vector3d towards = Eigen::Vector3d::UnitZ();
    Eigen::Vector3d irradiance = Eigen::Vector3d::Zero(); ///< What it throws on a surface that faces it.
};

/// Lights from afar that stand for all light of the picture, of about equal luminance. Fewer if the picture
/// has fewer bright pixels. Source: Debevec, A Median Cut Algorithm for Light Probe Sampling, 2005. Errors:
/// InvalidInput for a count outside of 1 to 65536.
std::vector<DirectionalLight> directionalLights(const RadianceImage& radiance, int count);

/// The share of the lights' luminance that a matt surface keeps where objects hide some of the lights, for
/// Overlay::shadow. It is 1 where no light reaches the surface. normal: a unit vector. isHidden: whether an
/// object is in the way towards a light.
float lightLeft(std::span<const DirectionalLight> lights, const Eigen::Vector3d& normal,
                const std::function<bool(const Eigen::Vector3d& towards)>& isHidden);

} // namespace spherewalk::render
