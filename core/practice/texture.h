// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace spherewalk::practice {

/// Linear light.
using Rgb = Eigen::Array3f;

/// A colour given as pictures store it, 0xRRGGBB.
Rgb linear(std::uint32_t stored);

enum class Texture {
    Plain,
    Planks,
    Rug,
    Wallpaper,
    Plaster,
    Wood,
    Fabric,
    Ribs,
    Curtain,
    Door,
    Outside,
    Art,
    Page,
    Book,
    Leaves,
    Globe,
    Stripes,
    Mosaic,
};

/// A disc, bar or ring on a painting. Units: metres from its lower left corner.
struct Blot {
    enum class Form { Disc, Bar, Ring };

    Form form = Form::Disc;
    float u = 0;
    float v = 0;
    float radius = 0;
    Rgb colour = Rgb::Zero();
};

/// Those of one painting of many.
std::vector<Blot> blots(std::uint32_t seed, float width, float height);

/// What a surface is made of.
struct Finish {
    Texture texture = Texture::Plain;
    Rgb first = Rgb::Constant(0.5F);
    Rgb second = Rgb::Constant(0.2F);
    std::uint32_t seed = 0;
    float mirror = 0; ///< share of the light that is mirrored, seen straight on
    float glow = 0;   ///< light of its own, as a multiple of the albedo
    std::vector<Blot> blots = {};
};

/// A place on a surface, in the surface's own coordinates. Units: metres.
struct SurfacePoint {
    float u = 0;      ///< to the right as seen from outside, from the lower left corner
    float v = 0;      ///< up
    float width = 1;  ///< of the face
    float height = 1; ///< of the face
    int face = 0;     ///< of the solid
    bool isRound = false;
    Eigen::Vector3f local = Eigen::Vector3f::Zero(); ///< in the solid's frame
    Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();
};

/// The share of light that the surface sends back, averaged over a footprint of this many metres.
Rgb albedo(const Finish& finish, const SurfacePoint& surface, float footprint);

} // namespace spherewalk::practice
