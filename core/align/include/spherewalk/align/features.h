// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/image.h"
#include "spherewalk/geometry/angle.h"

#include <Eigen/Core>

#include <cstdint>
#include <stop_token>
#include <string_view>
#include <vector>

namespace spherewalk::align {

enum class Detector { Sift, Akaze, Orb };

/// As options and reports spell it: "sift", "akaze", "orb".
std::string_view name(Detector detector);

struct FeatureOptions {
    Detector detector = Detector::Sift;
    int width = 1280;                       ///< working pixels per turn, a multiple of 32 in [256, 8192]
    int most = 2000;                        ///< features a photo, [1, 50000]
    double leastContrast = 0.03;            ///< of SIFT, share of black to white between neighbouring scales
    Radians lowestElevation = Degrees(-50); ///< below are the rail and the operator's legs
    bool usesZenith = true;                 ///< also what stands higher than 53 degrees
    /// Descriptors hold the direction "up" instead of the strongest gradient's: they tell more things apart,
    /// but only between photos that stand upright within some 15 degrees.
    bool isUpright = false;

    bool operator==(const FeatureOptions&) const = default;

    /// Errors: InvalidInput, naming the option and its range.
    void validate() const;
};

/// What can be found again of one photo. One entry a feature in all the vectors; first the strongest of each
/// part of the sphere, then the second of each: the first n are the best even selection of n.
struct Features {
    Detector detector = Detector::Sift;
    int descriptorBytes = 0;               ///< of each feature, a multiple of 32; 0 if there are none
    std::vector<Eigen::Vector3f> bearings; ///< unit vectors in the photo's panorama frame
    std::vector<float> sigmasRad;          ///< of the bearing, along any direction across it
    std::vector<float> responses;          ///< the detector's measure of strength
    /// SIFT: 128 values, the roots of the histogram's shares times 512 (RootSIFT: their distance is that of
    /// Hellinger); else bits.
    std::vector<std::uint8_t> descriptors;

    int count() const { return static_cast<int>(bearings.size()); }

    const std::uint8_t* descriptor(int feature) const {
        return descriptors.data() +
               static_cast<std::size_t>(feature) * static_cast<std::size_t>(descriptorBytes);
    }

    bool operator==(const Features&) const = default;
};

/// Features of an equirectangular photo, found on views of the sphere that distort no angles (Mercator around
/// the horizon, stereographic around the zenith), spread evenly. mask: equirectangular of any size, 0 where
/// nothing is to be looked at; empty: the whole photo counts. A photo without texture has no features, which
/// is no error. Errors: InvalidInput for a picture less than 64 x 32. Stop: Error{Stopped}. Threads: any; one
/// photo uses one thread besides those of OpenCV. Cost: 0.4 s for the defaults. Source: Lowe 2004 (SIFT);
/// Arandjelovic and Zisserman 2012 (RootSIFT).
Features detectFeatures(const RgbImage& photo, const FeatureOptions& options, const MaskImage& mask = {},
                        const std::stop_token& stop = {});

/// The same of a JPEG's bytes, decoded no larger than the working width needs. source: what the bytes are,
/// for sentences. Errors: those of jpeg::decode besides.
Features detectFeatures(ByteView jpeg, std::string_view source, const FeatureOptions& options,
                        const MaskImage& mask = {}, const std::stop_token& stop = {});

} // namespace spherewalk::align
