// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/image.h"
#include "spherewalk/geometry/angle.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string_view>
#include <vector>

namespace spherewalk::align {

enum class Detector { Sift, Akaze, Orb };

/// The detector as options and reports spell it: "sift", "akaze", "orb".
std::string_view name(Detector detector);

struct FeatureOptions {
    Detector detector = Detector::Sift;
    int width = 1280;                       ///< Working pixels per turn, a multiple of 32 in [256, 8192].
    int most = 2000;                        ///< Features a photo, [1, 50000].
    double leastContrast = 0.03;            ///< For SIFT: share of the range from black to white.
    Radians lowestElevation = Degrees(-50); ///< The rail and the operator's legs lie below.
    bool usesZenith = true;                 ///< Whether the part above 53 degrees is used too.
    /// Flat things are described as they look from aslant, too: on views squeezed 1.6 and 2.5 times, across
    /// and upright, each with `most` features. Photos metres apart then share two or three times as much.
    /// Three times the work. Source: Morel and Yu, ASIFT, 2009.
    bool isWide = false;

    bool operator==(const FeatureOptions&) const = default;

    /// Errors: InvalidInput, naming the option and its range.
    void validate() const;
};

/// Whether features in this direction of the panorama frame are kept whose descriptors reach `around`;
/// usesZenith is not asked. mask: see detectFeatures().
bool isSearched(const FeatureOptions& options, const MaskImage& mask, const Eigen::Vector3d& bearing,
                Radians around);

/// The direction of a photo that is up.
struct Vertical {
    Eigen::Vector3d upInPhoto = Eigen::Vector3d::UnitZ(); ///< A unit vector in the photo's panorama frame.
    double sigmaRad = 0;                                  ///< Standard deviation along any direction across.

    bool operator==(const Vertical&) const = default;
};

/// The features of one photo. All vectors have one entry a feature, if any. The strongest feature of each
/// region of the sphere comes first, then the second of each, so the first n are the best even selection of
/// n. Those of squeezed views come last.
struct Features {
    Detector detector = Detector::Sift;
    int descriptorBytes = 0;               ///< Per feature, a multiple of 32; 0 if there are no features.
    std::vector<Eigen::Vector3f> bearings; ///< Unit vectors in the photo's panorama frame.
    std::vector<float> sigmasRad;          ///< Standard deviation of the bearing, in any direction across it.
    std::vector<float> responses;          ///< The detector's measure of strength.
    /// For SIFT 128 values, the roots of the histogram's shares times 512 (RootSIFT, whose distance is
    /// Hellinger's); for the others bits.
    std::vector<std::uint8_t> descriptors;
    /// For each feature the first one of the same thing, if squeezed views show things several times. Empty
    /// where each feature is of another thing.
    std::vector<int> firstOf;
    std::optional<Vertical> vertical; ///< See findVertical().

    /// The index by which the thing is known that this feature shows.
    int thing(int feature) const {
        return firstOf.empty() ? feature : firstOf[static_cast<std::size_t>(feature)];
    }

    int count() const { return static_cast<int>(bearings.size()); }

    const std::uint8_t* descriptor(int feature) const {
        return descriptors.data() +
               static_cast<std::size_t>(feature) * static_cast<std::size_t>(descriptorBytes);
    }

    bool operator==(const Features&) const = default;
};

/// Features of an equirectangular photo, spread evenly over the sphere. They are found on views that distort
/// no angles: Mercator around the horizon, stereographic around the zenith. mask: equirectangular of any
/// size, 0 where no feature is wanted; an empty mask allows the whole photo. A photo without texture has no
/// features, which is no error. Errors: InvalidInput for a picture smaller than 64 x 32. Stop:
/// Error{Stopped}. Threads: any; one photo uses one thread besides those of OpenCV. Cost: 0.4 s for the
/// defaults. Source: Lowe 2004 (SIFT); Arandjelovic and Zisserman 2012 (RootSIFT).
Features detectFeatures(const RgbImage& photo, const FeatureOptions& options, const MaskImage& mask = {},
                        const std::stop_token& stop = {});

/// Up, by the edges of walls, doors and furniture that stand upright: what the planes through them and the
/// lens have in common. Empty where few edges agree, or where they speak for two directions. sigmaRad is of
/// the picture; how upright the things themselves stand is not in it. Range: the photo leans by 20 degrees at
/// most, else something level may be taken for upright. Of the options the elevation counts alone. Threads:
/// any. Cost: 0.15 s for 1280 pixels per turn. Source: von Gioi, Jakubowicz, Morel, Randall 2010 (line
/// segments, as OpenCV has them).
std::optional<Vertical> findVertical(const Image<std::uint8_t, 1>& photo, const FeatureOptions& options,
                                     const MaskImage& mask = {});

/// detectFeatures() of a JPEG's bytes, decoded no larger than the working width needs. source: names the
/// bytes in error sentences. Errors: also those of jpeg::decode().
Features detectFeatures(ByteView jpeg, std::string_view source, const FeatureOptions& options,
                        const MaskImage& mask = {}, const std::stop_token& stop = {});

} // namespace spherewalk::align
