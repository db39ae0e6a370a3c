// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/noise.h"
#include "room/shape.h"

#include <array>

namespace spherewalk::practice {

namespace {

Rgb mix(const Rgb& a, const Rgb& b, float share) {
    return a + (b - a) * share;
}

/// A colour of many, by number.
Rgb hashedColour(std::uint32_t h, float least = 0.05F, float most = 0.75F) {
    const auto channel = [&](std::uint32_t salt) {
        const float value = unit(mixed(h + salt));
        return lerp(least, most, value * value);
    };
    return {channel(11), channel(23), channel(37)};
}

std::uint32_t faceSeed(const Finish& finish, const SurfacePoint& s) {
    return finish.seed * 31U + static_cast<std::uint32_t>(s.face);
}

/// Grain that runs along `along`.
float grain(float along, float across, std::uint32_t seed, float footprint) {
    const float bend = 0.004F * valueNoise(along * 3, across * 9, seed + 5);
    return fractalNoise(along * 0.12F, across + bend, 0.012F, 4, 0.62F, seed, footprint);
}

Rgb planks(const Finish& finish, const SurfacePoint& s, float w) {
    constexpr float kWidth = 0.13F;
    constexpr float kLength = 1.35F;
    const int row = floorInt(s.v / kWidth);
    const float shift = kLength * unit(hash(row, 7, finish.seed));
    const int piece = floorInt((s.u + shift) / kLength);
    const float along = s.u + shift - kLength * static_cast<float>(piece);
    const float across = s.v - kWidth * static_cast<float>(row);
    const std::uint32_t plank = hash(piece, row, finish.seed);
    const float tone = 0.62F + 0.5F * unit(plank);
    const float streaks = grain(s.u + 9 * unit(plank + 1), across, plank, w);
    const float knots = fractalNoise(s.u, s.v * 2, 0.16F, 4, 0.6F, plank + 3, w);
    const Rgb wood =
        mix(finish.first, finish.second, clamp01(0.45F + 0.30F * streaks + 0.25F * knots)) * tone;
    const float gap = std::max(
        boxPulse(-0.0015F, 0.0015F, across, w) + boxPulse(kWidth - 0.0015F, kWidth + 0.0015F, across, w),
        boxPulse(-0.0015F, 0.0015F, along, w) + boxPulse(kLength - 0.0015F, kLength + 0.0015F, along, w));
    return wood * (1 - 0.75F * std::min(1.0F, gap));
}

Rgb rug(const Finish& finish, const SurfacePoint& s, float w) {
    const float fromEdge = std::min(std::min(s.u, s.width - s.u), std::min(s.v, s.height - s.v));
    const float border = boxPulse(0.05F, 0.08F, fromEdge, w) + boxPulse(0.20F, 0.215F, fromEdge, w);
    const float band = boxStep(0.21F, fromEdge, w);
    // A woven field: coarse blocks in three colours, broken by a diamond lattice.
    const float blocks = squares(s.u, s.v, 0.031F, 0.45F, finish.seed, w);
    const float diamonds =
        0.5F * (boxLines(0.22F, 0.045F, s.u + s.v, w * 1.4F) + boxLines(0.22F, 0.045F, s.u - s.v, w * 1.4F));
    const Rgb woven = mix(finish.first, finish.second, 0.6F * blocks);
    const Rgb field = mix(woven, linear(0xD8C9A0), 0.75F * std::min(1.0F, 2 * diamonds));
    const Rgb edge =
        mix(finish.second, linear(0xD8C9A0), squares(s.u, s.v, 0.021F, 0.4F, finish.seed + 9, w));
    const Rgb base = mix(edge, field, band);
    const float weave = 0.09F * fractalNoise(s.u, s.v, 0.014F, 4, 0.75F, finish.seed + 3, w);
    return mix(base, linear(0x1E1A2A), std::min(1.0F, border) * 0.8F) * (1 + weave);
}

/// Exactly periodic, with nothing besides: what feature matching finds hard.
Rgb wallpaper(const Finish& finish, const SurfacePoint& s, float w) {
    constexpr float kTile = 0.32F;
    const float fade = survival(kTile / 6, w);
    const auto motif = [&](float u, float v) {
        const float x = u - kTile * static_cast<float>(floorInt(u / kTile + 0.5F));
        const float y = v - kTile * static_cast<float>(floorInt(v / kTile + 0.5F));
        const float r = std::sqrt(x * x + y * y);
        const float petal = r > 1e-5F ? (x * x - y * y) * (x * x - y * y) / (r * r * r * r) : 0;
        const float flower = boxStep(0, 0.050F + 0.045F * petal - r, w);
        const float heart = boxStep(0, 0.018F - r, w);
        const float ring = boxPulse(0.112F, 0.119F, r, w);
        return 0.75F * flower - 0.55F * heart + 0.5F * ring;
    };
    const float pattern = std::max(motif(s.u, s.v), motif(s.u + kTile / 2, s.v + kTile / 2));
    const float stripe = boxLines(kTile / 2, 0.012F, s.u + kTile / 4, w);
    const float share = lerp(0.2F, pattern, fade) + 0.12F * stripe;
    return mix(finish.first, finish.second, clamp01(share));
}

Rgb plaster(const Finish& finish, const SurfacePoint& s, float w) {
    const float clouds = fractalNoise(s.u, s.v, 0.9F, 3, 0.5F, finish.seed, w);
    const float dabs = fractalNoise(s.u, s.v, 0.045F, 4, 0.7F, finish.seed + 40, w);
    return finish.first * (1 + 0.02F * clouds + 0.022F * dabs);
}

Rgb wood(const Finish& finish, const SurfacePoint& s, float w) {
    const std::uint32_t seed = faceSeed(finish, s);
    const bool alongU = s.width >= s.height;
    const float along = alongU ? s.u : s.v;
    const float across = alongU ? s.v : s.u;
    const float lines = grain(along, across, seed, w);
    const float rings = fractalNoise(along * 0.35F, across, 0.10F, 4, 0.55F, seed + 8, w);
    return mix(finish.first, finish.second, clamp01(0.42F + 0.25F * lines + 0.30F * rings));
}

Rgb fabric(const Finish& finish, const SurfacePoint& s, float w) {
    const std::uint32_t seed = faceSeed(finish, s);
    const float threads = fractalNoise(s.u * 0.5F, s.v, 0.010F, 3, 0.8F, seed, w) +
                          fractalNoise(s.u, s.v * 0.5F, 0.010F, 3, 0.8F, seed + 4, w);
    const float flecks = squares(s.u, s.v, 0.013F, 0.16F, seed + 9, w);
    return mix(finish.first, finish.second, 0.8F * flecks) * (1 + 0.16F * threads);
}

Rgb ribs(const Finish& finish, const SurfacePoint& s, float w) {
    return mix(finish.first, finish.second, boxLines(0.06F, 0.018F, s.u, w));
}

Rgb curtain(const Finish& finish, const SurfacePoint& s, float w) {
    const float sway = 0.025F * valueNoise(s.v * 1.2F, 0.5F, finish.seed);
    const float folds = fractalNoise(s.u + sway, s.v * 0.05F, 0.055F, 2, 0.4F, finish.seed + 1, w);
    const float sprigs = squares(s.u + 0.4F * sway, s.v, 0.028F, 0.10F, finish.seed + 2, w);
    return mix(finish.first, finish.second, 0.7F * sprigs) * (0.85F + 0.32F * folds);
}

Rgb door(const Finish& finish, const SurfacePoint& s, float w) {
    const auto panel = [&](float low, float high) {
        const float x = std::min(s.u - 0.13F, s.width - 0.13F - s.u);
        const float y = std::min(s.v - low, high - s.v);
        const float inside = std::min(x, y);
        return boxPulse(0, 0.018F, inside, w) * (x < y && s.u > s.width / 2 ? 0.9F : 0.6F);
    };
    const float groove = std::max(panel(0.18F, 0.85F), panel(1.02F, s.height - 0.16F));
    return mix(wood(finish, s, w), finish.second * 0.35F, groove);
}

/// Sky, hills, trees and a house, as through a window.
Rgb outside(const Finish& finish, const SurfacePoint& s, float w) {
    const float x = s.u / s.height;
    const float y = s.v / s.height;
    const float clouds = fractalNoise(s.u * 0.6F, s.v, 0.28F, 6, 0.55F, finish.seed, w);
    Rgb colour = mix(linear(0xBFD9F2), linear(0x5E97D8), y);
    colour = mix(colour, linear(0xFFFFFF), smoothStep(0.0F, 0.7F, clouds));
    const float blur = w / s.height;
    const float farHill = 0.46F + 0.10F * valueNoise(x * 2.1F, 3.5F, finish.seed + 1);
    const float nearHill = 0.32F + 0.07F * valueNoise(x * 3.3F, 8.5F, finish.seed + 2);
    const float trees = nearHill + 0.13F * fractalNoise(s.u, 0.5F, 0.13F, 5, 0.6F, finish.seed + 3, w);
    const float leaves = fractalNoise(s.u, s.v, 0.06F, 6, 0.75F, finish.seed + 4, w);
    const float meadow = fractalNoise(s.u * 0.5F, s.v, 0.05F, 6, 0.75F, finish.seed + 5, w);
    colour = mix(colour, linear(0x7E9C86) * (1 + 0.15F * leaves), boxStep(y, farHill, blur));
    colour = mix(colour, linear(0x3E5F33) * (1 + 0.6F * leaves), boxStep(y, trees, blur));
    colour = mix(colour, linear(0x88A552) * (1 + 0.35F * meadow), boxStep(y, nearHill - 0.06F, blur));
    const float wall = boxPulse(0.62F, 0.80F, x, blur) * boxPulse(0.20F, 0.36F, y, blur);
    const float roof =
        boxPulse(0.36F, 0.46F, y, blur) * boxStep(std::abs(x - 0.71F), 0.115F * (0.46F - y) / 0.10F, blur);
    const float panes = boxPulse(0.01F, 0.05F, x - 0.06F * static_cast<float>(floorInt(x / 0.06F)), blur) *
                        boxPulse(0.27F, 0.33F, y, blur);
    colour = mix(colour, mix(linear(0xE9DFC8), linear(0x39424E), panes), wall);
    return mix(colour, linear(0xA5482F) * (1 + 0.2F * meadow), roof);
}

float cover(const Blot& blot, float dx, float dy, float w) {
    const float r = blot.radius;
    switch (blot.form) {
    case Blot::Form::Disc:
        return boxStep(std::sqrt(dx * dx + dy * dy), r, w);
    case Blot::Form::Bar:
        return boxPulse(-r, r, dx, w) * boxPulse(-0.5F * r, 0.5F * r, dy, w);
    case Blot::Form::Ring:
        return boxPulse(0.6F * r, r, std::sqrt(dx * dx + dy * dy), w);
    }
    return 0;
}

/// One painting of many: clouds of colour under discs, bars and strokes; no two parts look alike.
Rgb art(const Finish& finish, const SurfacePoint& s, float w) {
    const float frame = std::min(std::min(s.u, s.width - s.u), std::min(s.v, s.height - s.v));
    const float warp = 0.08F * fractalNoise(s.u, s.v, 0.2F, 2, 0.5F, finish.seed + 1, w);
    const float shared = fractalNoise(s.u - warp, s.v + warp, 0.10F, 7, 0.78F, finish.seed + 5, w);
    Rgb colour;
    for (int channel = 0; channel < 3; ++channel) {
        const auto salt = static_cast<std::uint32_t>(20 + 16 * channel);
        const float clouds = fractalNoise(s.u + warp, s.v - warp, 0.18F, 3, 0.7F, finish.seed + salt, w);
        colour[channel] = clamp01(0.26F + 0.20F * clouds + 0.12F * shared);
    }
    for (const Blot& blot : finish.blots) {
        const float dx = s.u - blot.u;
        const float dy = s.v - blot.v;
        const float reach = blot.radius + w;
        if (std::max(std::abs(dx), std::abs(dy)) < reach) {
            colour = mix(colour, blot.colour, 0.85F * cover(blot, dx, dy, w));
        }
    }
    const Rgb mounted = mix(linear(0xF3EFE4), colour, boxStep(0.055F, frame, w));
    return mix(finish.first, mounted, boxStep(0.022F, frame, w));
}

/// A printed sheet: a heading, columns of words, a picture.
Rgb page(const Finish& finish, const SurfacePoint& s, float w) {
    const float margin = std::min(std::min(s.u, s.width - s.u), std::min(s.v, s.height - s.v));
    const float size = std::min(s.width, s.height);
    const float line = size / 26;
    const float words =
        squares(s.u, s.v, line * 0.28F, 0.5F, finish.seed, w) * (1 - boxLines(line, line * 0.42F, s.v, w));
    const float heading = squares(s.u, s.v, line * 0.8F, 0.55F, finish.seed + 1, w);
    const float y = s.v / s.height;
    Rgb ink = mix(linear(0xF4F1E6), linear(0x22252B), 0.9F * (y > 0.84F ? heading : words));
    if (y > 0.30F && y < 0.58F) {
        const float tone = fractalNoise(s.u, s.v, 0.11F, 6, 0.65F, finish.seed + 2, w);
        ink = mix(finish.first, finish.second, clamp01(0.5F + 0.5F * tone));
    }
    return mix(linear(0xF4F1E6), ink, boxStep(size * 0.07F, margin, w));
}

Rgb book(const Finish& finish, const SurfacePoint& s, float w) {
    const Rgb cover = finish.first * (1 + 0.12F * fractalNoise(s.u, s.v, 0.02F, 4, 0.7F, finish.seed, w));
    const float y = s.v / s.height;
    const float title = boxPulse(0.36F, 0.80F, y, w / s.height) *
                        boxPulse(0.28F * s.width, 0.72F * s.width, s.u, w) *
                        squares(s.u, s.v, 0.0065F, 0.55F, finish.seed + 1, w);
    const float bands = boxPulse(0.10F, 0.13F, y, w / s.height) + boxPulse(0.87F, 0.90F, y, w / s.height) +
                        boxPulse(0.16F, 0.17F, y, w / s.height);
    return mix(cover, finish.second, clamp01(title + bands));
}

Rgb leaves(const Finish& finish, const SurfacePoint& s, float w) {
    const Eigen::Vector3f& p = s.local;
    const float tone = fractalNoise(p.x(), p.y(), p.z(), 0.05F, 4, 0.75F, finish.seed, w);
    return mix(finish.first, finish.second, clamp01(0.5F + 0.6F * tone)) *
           (1 + 0.35F * clamp01(3 * std::abs(tone) - 0.7F));
}

Rgb globe(const Finish& finish, const SurfacePoint& s, float w) {
    const Eigen::Vector3f& p = s.local;
    const float land = fractalNoise(p.x(), p.y(), p.z(), 0.07F, 5, 0.6F, finish.seed, w);
    const float relief = fractalNoise(p.x(), p.y(), p.z(), 0.02F, 3, 0.7F, finish.seed + 9, w);
    const Rgb ground = mix(linear(0x6E8B3D), linear(0xC9A45C), clamp01(0.5F + 0.8F * relief));
    const float parallels = boxLines(s.height / 8, 0.002F, s.v, w);
    return mix(mix(linear(0x2F6EA8), ground, smoothStep(-0.02F, 0.06F, land)), linear(0xE8E8E8),
               0.5F * parallels);
}

Rgb stripes(const Finish& finish, const SurfacePoint& s, float w) {
    return mix(finish.first, finish.second, boxLines(0.034F, 0.014F, s.v, w));
}

Rgb mosaic(const Finish& finish, const SurfacePoint& s, float w) {
    const float cell = s.isRound ? 0.016F : 0.024F;
    const float light = squares(s.u, s.v, cell, 0.5F, faceSeed(finish, s), w);
    const float red = squares(s.u, s.v, cell * 2, 0.4F, faceSeed(finish, s) + 7, w);
    return mix(mix(finish.first, finish.second, light), linear(0xC8553D), 0.55F * red);
}

/// The part of the footprint that is white, on the face that looks along +y. Exact for a square footprint.
Rgb tag(const Finish& finish, const SurfacePoint& s, float w) {
    constexpr int kCells = 8;
    constexpr int kFront = 3;
    if (s.face != kFront) {
        return finish.second;
    }
    const float perMetre = (kCells + 2) / s.width; // A rim of one cell is white.
    const float half = std::max(0.5F * w * perMetre, 1e-4F);
    const float x = s.u * perMetre - 1;
    const float y = (s.height - s.v) * perMetre - 1;
    float black = 0;
    for (int row = 0; row < kCells; ++row) {
        for (int column = 0; column < kCells; ++column) {
            const auto overlap = [&](float middle, int cell) {
                const auto first = static_cast<float>(cell);
                return std::max(0.0F, std::min(first + 1, middle + half) - std::max(first, middle - half));
            };
            black += finish.cells[static_cast<std::size_t>(row) * kCells + static_cast<std::size_t>(column)]
                         ? 0
                         : overlap(x, column) * overlap(y, row);
        }
    }
    return mix(finish.second, finish.first, black / (4 * half * half));
}

} // namespace

Rgb linear(std::uint32_t stored) {
    const auto channel = [&](int shift) {
        const float value = static_cast<float>((stored >> shift) & 0xFFU) / 255.0F;
        return value * value;
    };
    return {channel(16), channel(8), channel(0)};
}

std::vector<Blot> blots(std::uint32_t seed, float width, float height) {
    std::vector<Blot> made;
    for (std::uint32_t i = 0; i < 22; ++i) {
        const std::uint32_t h = mixed(seed * 131U + i);
        Blot blot;
        blot.form = static_cast<Blot::Form>(h % 3U);
        blot.u = width * unit(h);
        blot.v = height * unit(mixed(h + 1));
        const float spread = unit(mixed(h + 2)) * unit(mixed(h + 7));
        blot.radius = std::min(width, height) * (0.02F + 0.13F * spread);
        blot.colour = hashedColour(h + 3, 0.02F, 0.9F);
        made.push_back(blot);
    }
    return made;
}

Rgb albedo(const Finish& finish, const SurfacePoint& s, float w) {
    switch (finish.texture) {
    case Texture::Plain:
        return finish.first;
    case Texture::Planks:
        return planks(finish, s, w);
    case Texture::Rug:
        return rug(finish, s, w);
    case Texture::Wallpaper:
        return wallpaper(finish, s, w);
    case Texture::Plaster:
        return plaster(finish, s, w);
    case Texture::Wood:
        return wood(finish, s, w);
    case Texture::Fabric:
        return fabric(finish, s, w);
    case Texture::Ribs:
        return ribs(finish, s, w);
    case Texture::Curtain:
        return curtain(finish, s, w);
    case Texture::Door:
        return door(finish, s, w);
    case Texture::Outside:
        return outside(finish, s, w);
    case Texture::Art:
        return art(finish, s, w);
    case Texture::Page:
        return page(finish, s, w);
    case Texture::Book:
        return book(finish, s, w);
    case Texture::Leaves:
        return leaves(finish, s, w);
    case Texture::Globe:
        return globe(finish, s, w);
    case Texture::Stripes:
        return stripes(finish, s, w);
    case Texture::Mosaic:
        return mosaic(finish, s, w);
    case Texture::Tag:
        return tag(finish, s, w);
    }
    return finish.first;
}

} // namespace spherewalk::practice
