// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/image.h"
#include "spherewalk/geometry/lens_pair.h"
#include "spherewalk/geometry/polygon.h"
#include "spherewalk/geometry/rigid3.h"

#include <filesystem>
#include <string_view>

namespace spherewalk::render {

class DepthSteps;

/// How far away each pixel of a photo is. It mostly has fewer pixels than the photo. Frames: the photo's own,
/// equirectangular as in geometry/equirect.h. Threads: const functions may run on any number at a time.
class DepthMap {
  public:
    /// Inverse distances are whole multiples of this step. Units: 1/m.
    static constexpr double kStepPerM = 1.0 / 1600;
    /// The greatest inverse distance has so many steps: it is 4.9 cm.
    static constexpr int kSteps = 32767;

    /// inverseM: 1 / distance along the pixel's ray in 1/m; it is rounded to steps, from 1 (1600 m) to
    /// kSteps. sure: other than 0 where the depth was measured, 0 where it was filled in; if empty, all was
    /// measured. Errors: InvalidInput for a size that is not 2:1 or not 16 to 8192 wide, sizes that differ,
    /// and NaN.
    explicit DepthMap(Image<float, 1> inverseM, MaskImage sure = {});

    /// The map of what a file has.
    explicit DepthMap(const DepthSteps& steps);

    /// The map that serialised() wrote. source: a name for sentences. Errors: Corrupt.
    static DepthMap parse(ByteView bytes, std::string_view source);

    /// The map in a file. Errors: those of readFile() and parse().
    static DepthMap read(const std::filesystem::path& file);

    /// The map as a binary PGM of 16 bits. A value is twice the number of steps, plus 1 where it is sure.
    Bytes serialised() const;

    int width() const { return m_inverseM.width(); }

    int height() const { return m_inverseM.height(); }

    const Image<float, 1>& inverseM() const { return m_inverseM; }

    const MaskImage& sure() const { return m_sure; }

  private:
    Image<float, 1> m_inverseM;
    MaskImage m_sure;
};

/// A room as upright walls between a level floor and a level ceiling. Frames: the room's. Units: metres.
struct RoomShape {
    Polygon outline;
    double floorM = 0;
    double ceilingM = 0;

    bool operator==(const RoomShape&) const = default;

    /// Errors: InvalidInput for an outline with fewer than three corners, values that are not finite, and a
    /// ceiling that is not above the floor.
    void validate() const;
};

/// 1 / distance, in 1/m, from a point along a direction to the first wall, floor or ceiling. It is 0 where
/// the direction meets none. The direction may have any length. A point outside of the room sees walls from
/// behind.
double inverseDistance(const RoomShape& room, const Eigen::Vector3d& pInRoom,
                       const Eigen::Vector3d& direction);

/// The depth of the room as a photo's lenses see it. width: pixels, a multiple of 16. Errors: as
/// RoomShape::validate().
DepthMap roomDepth(const RoomShape& room, const Rigid3& roomFromPhoto, int width,
                   const LensPair& lenses = {});

} // namespace spherewalk::render
