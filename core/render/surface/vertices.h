// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "surface/pieces.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

/// The projection of a surface's vertices into a view. The bytes are the same on every processor.
namespace spherewalk::render::simd {

/// A pinhole camera as it sees a photo's surface.
struct SurfaceCamera {
    std::array<float, 9> rotation;    ///< Camera from photo, row after row.
    std::array<float, 3> translation; ///< Camera from photo.
    float fx, fy, cx, cy;
    float nearestM; ///< The least depth along the axis that is projected.
};

/// A block of a photo's surface. The cosines and sines of each column's azimuth and each row's elevation give
/// the directions. ProjectedBlock::kPitch values of each row are read, however many are used.
struct SurfaceBlock {
    const float* cosAzimuth;
    const float* sinAzimuth;
    const float* cosElevation;
    const float* sinElevation;
    const float* inverseM;
    std::ptrdiff_t pitch; ///< Values of inverseM from one row to the next.
    int rows;             ///< Range: at most ProjectedBlock::kRows.
};

/// Where a block's vertices are in the view, and their 1 / s as in InverseBuffer. The value is 0 if the
/// vertex is not in front of the camera, or so far aside that single precision would not tell its edges'
/// positions.
struct ProjectedBlock {
    static constexpr int kRows = 17;
    static constexpr int kPitch = 24;
    static constexpr float kFarthestPx = 1e5F;
    std::array<float, std::size_t{kRows} * kPitch> x, y, value;
};

void project(const SurfaceCamera& camera, const SurfaceBlock& block, ProjectedBlock& out);

/// The boxes in the view of a block's 4 x 4 sub-blocks, which have 5 x 5 vertices each. If no vertex has a
/// value, left is beyond right. If only some have, the box is everywhere.
struct BlockBoxes {
    static constexpr int kSubBlocks = 4;
    static constexpr int kSubBlock = 4; ///< Quads along an axis.
    static constexpr float kEverywherePx = 1e9F;
    std::array<float, std::size_t{kSubBlocks} * kSubBlocks> left, top, right, bottom;
};

/// Computes the boxes of a block with that many rows.
void boxes(const ProjectedBlock& block, int rows, BlockBoxes& out);

/// Patches of a photo. cosine, sine: those of the azimuth or elevation of each side, in turn from the left
/// one. inverseM: 1 / distance at each corner, in turn from the upper left one. Quads::kMore values are read
/// beyond the last.
struct SurfacePatches {
    std::array<const float*, 4> cosine;
    std::array<const float*, 4> sine;
    std::array<const float*, 4> inverseM;
    int count;

    /// So many of the patches, from `first` on.
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

/// Adds the patches as quads in the view. Values are as in ProjectedBlock. Range: there is room.
void project(const SurfaceCamera& camera, const SurfacePatches& patches, Quads& out);

} // namespace spherewalk::render::simd
