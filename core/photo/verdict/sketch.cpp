// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/photo/sketch.h"

#include "brightness.h"
#include "edge_widths.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/levelling.h"
#include "spherewalk/photo/picture_file.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spherewalk::photo {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kMostWidth = 2752;
constexpr int kBlack = 6;
constexpr int kBurnt = 250;

int denominatorFor(int width) {
    int denominator = 1;
    while (denominator < 8 && width > kMostWidth * denominator) {
        denominator *= 2;
    }
    return denominator;
}

/// As a level camera with the same heading would see it.
RgbImage levelled(const RgbImage& picture, const PhotoMetadata& metadata) {
    const Radians kHarmless = Degrees(1);
    const auto levelFromPhoto = photo::levelFromPhoto(metadata);
    if (!levelFromPhoto || Eigen::AngleAxisd(*levelFromPhoto).angle() < kHarmless.value()) {
        return resized(picture, kSketchWidth, kSketchHeight);
    }
    constexpr int kFiner = 4;
    const RgbImage source = resized(picture, kFiner * kSketchWidth, kFiner * kSketchHeight);
    const EquirectSize from{source.width(), source.height()};
    const EquirectSize to{kSketchWidth, kSketchHeight};
    const Eigen::Quaterniond photoFromLevel = levelFromPhoto->conjugate();
    RgbImage result(to.width, to.height);
    for (int v = 0; v < to.height; ++v) {
        for (int u = 0; u < to.width; ++u) {
            const Eigen::Vector2d at = pixel(from, photoFromLevel * direction(to, Eigen::Vector2d(u, v)));
            const int x = std::clamp(static_cast<int>(std::lround(at.x())), 0, from.width - 1);
            const int y = std::clamp(static_cast<int>(std::lround(at.y())), 0, from.height - 1);
            std::copy_n(source.at(x, y), RgbImage::kChannels, result.at(u, v));
        }
    }
    return result;
}

/// Means over the sphere of the small picture.
void measureLight(Sketch& sketch) {
    double area = 0;
    for (int v = 0; v < kSketchHeight; ++v) {
        const double weight = std::cos(kPi / 2 - kPi * (v + 0.5) / kSketchHeight);
        for (int u = 0; u < kSketchWidth; ++u) {
            const std::uint8_t* p = sketch.picture.at(u, v);
            const int most = std::max({p[0], p[1], p[2]});
            const int least = std::min({p[0], p[1], p[2]});
            area += weight;
            sketch.brightness += weight * static_cast<double>(brightness(p));
            sketch.blackPart += most <= kBlack ? weight : 0;
            sketch.burntPart += least >= kBurnt ? weight : 0;
        }
    }
    sketch.brightness /= area;
    sketch.blackPart /= area;
    sketch.burntPart /= area;
}

} // namespace

Sketch sketch(ByteView jpeg, const PhotoMetadata& metadata, std::string_view source) {
    const jpeg::Info info = jpeg::readInfo(jpeg, source);
    if (info.width != 2 * info.height) {
        throw Error(ErrorKind::Corrupt, text("The photo ", source, " is not spherical: its ", info.width,
                                             " x ", info.height, " pixels are not twice as wide as high."));
    }
    const RgbImage picture = jpeg::decode(jpeg, source, denominatorFor(info.width));
    Sketch result;
    result.width = info.width;
    result.height = info.height;
    result.picture = levelled(picture, metadata);
    result.edges = edgeWidths(picture);
    measureLight(result);
    return result;
}

} // namespace spherewalk::photo
