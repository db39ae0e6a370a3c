// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "depth_pieces.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

/// What a view from surfaces does for many pixels at once. The same bytes on every processor.
namespace spherewalk::render::simd {

/// A pinhole camera as it sees a photo's surface.
struct SurfaceCamera {
    std::array<float, 9> rotation;    ///< camera from photo, row after row
    std::array<float, 3> translation; ///< likewise
    float fx, fy, cx, cy;
    float nearestM; ///< along the axis
};

/// A part of a photo's surface: directions by the cosines and sines of each column's azimuth and each row's
/// elevation, and 1 / distance. kPitch values of each row are read, whatever is used of them.
struct SurfacePart {
    const float* cosAzimuth;
    const float* sinAzimuth;
    const float* cosElevation;
    const float* sinElevation;
    const float* inverseM;
    std::ptrdiff_t pitch; ///< of inverseM
    int rows;             ///< at most ProjectedPart::kRows
};

/// Where a part's vertices are in the view, and 1 / s there (InverseBuffer); 0 where it is not in front of
/// the camera, or so far aside that single precision would not place its edges.
struct ProjectedPart {
    static constexpr int kRows = 17;
    static constexpr int kPitch = 24;
    static constexpr float kFarthestPx = 1e5F;
    std::array<float, std::size_t{kRows} * kPitch> x, y, value;
};

void project(const SurfaceCamera& camera, const SurfacePart& part, ProjectedPart& out);

/// A part's 4 x 4 squares of 5 x 5 vertices each: between which pixels they lie in the view. Where none of
/// its vertices is placed, left is beyond right; where only some are, it is everywhere.
struct PartBoxes {
    static constexpr int kSquares = 4;
    static constexpr int kSquare = 4; ///< quads along an edge
    static constexpr float kEverywherePx = 1e9F;
    std::array<float, std::size_t{kSquares} * kSquares> left, top, right, bottom;
};

/// Range: of a part with that many rows.
void boxes(const ProjectedPart& part, int rows, PartBoxes& out);

/// Rectangles of a photo. Of their sides, in turn from the left one: cosine and sine of the azimuth or the
/// elevation; of their corners, in turn from the upper left: 1 / distance. Quads::kMore values are read
/// beyond the last.
struct SurfacePatches {
    std::array<const float*, 4> cosine;
    std::array<const float*, 4> sine;
    std::array<const float*, 4> inverseM;
    int count;

    /// So many of them, from there on.
    SurfacePatches part(int first, int many) const {
        SurfacePatches part = *this;
        for (std::size_t i = 0; i < 4; ++i) {
            part.cosine[i] += first;
            part.sine[i] += first;
            part.inverseM[i] += first;
        }
        part.count = many;
        return part;
    }
};

/// Adds where they are in the view. Values are as ProjectedPart's. Range: there is room.
void project(const SurfaceCamera& camera, const SurfacePatches& patches, Quads& out);

} // namespace spherewalk::render::simd
