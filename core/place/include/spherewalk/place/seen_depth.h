// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/geometry/lens_pair.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/scene_depth.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace spherewalk::place {

/// What a photo says about a point.
struct Sight {
    float pointM = 0;    ///< Distance from the lens to the point.
    float rangeM = 0;    ///< Distance to what the photo shows in the point's direction; 0 if it is outside.
    bool isSure = false; ///< Whether the range was measured; if not, it continues what lies beside.
    bool isEdge = false; ///< Whether the pixels there show different things; the nearest one counts.

    /// Whether the photo shows something outside of the room: in a mirror, or through a window. That tells
    /// nothing of the space before it.
    bool isOutside() const { return rangeM == 0; }
};

/// The distances that a photo shows. They take two bytes a pixel. Threads: const functions may run on
/// any number at a time.
class SeenDepth {
  public:
    /// baselineM: how far the photos stand from which the depth was estimated, see baselinesM(); +infinity
    /// for a depth without noise. room: what lies outside of it by more than 15 cm and two standard
    /// deviations is told by Sight::isOutside() alone. Nothing is outside without a room, or of a photo that
    /// stands outside.
    SeenDepth(const render::DepthMap& depth, const Rigid3& roomFromPhoto, const LensPair& lenses,
              double baselineM, const render::RoomShape* room = nullptr);

    int width() const { return m_steps.width(); }

    int height() const { return m_steps.height(); }

    const Rigid3& roomFromPhoto() const { return m_roomFromPhoto; }

    /// The direction in which the photo shows a point. Frames: the result is the photo's, not normalised.
    Eigen::Vector3d directionTo(const Eigen::Vector3d& pInRoom) const;

    /// What the photo says about a point. Between four pixels 1 / distance is interpolated. Where they differ
    /// by more than 8 %, the nearest one counts. The range is not sure where one of those that count is not.
    Sight sight(const Eigen::Vector3d& pInRoom) const;

    /// The range of a pixel in metres; 0 if it is not sure, or outside. Range: 0 <= x < width, 0 <= y <
    /// height.
    float rangeM(int x, int y) const;

    /// The point that a pixel shows at this range. Frames: room.
    Eigen::Vector3d point(int x, int y, double rangeM) const;

    /// The standard deviation of a range: half a pixel of parallax, and the steps of the file.
    float sigmaM(float rangeM) const { return kLeastSigmaM + m_sigmaPerM * rangeM * rangeM; }

  private:
    void dropOutside(const render::RoomShape& room);

    static constexpr float kLeastSigmaM = 0.004F;
    static constexpr std::uint16_t kSure = 0x8000;
    static_assert(render::DepthMap::kSteps < kSure);

    /// 1 / distance in steps of DepthMap::kStepPerM, and kSure where it was measured; 0 outside of the room.
    Image<std::uint16_t, 1> m_steps;
    Rigid3 m_roomFromPhoto;
    Rigid3 m_photoFromRoom;
    LensPair m_lenses;
    float m_sigmaPerM;
};

/// What all photos say of a point.
enum class Space { Unknown, Free, Occupied, Mirror };

/// A point is free if one photo surely shows something farther away, by more than the margin and two standard
/// deviations. Else those that are not sure are asked: it is free if more look through, by 15 cm, than show
/// something here, and else occupied if two show something here. It lies at or in a mirror, or at a window,
/// if three photos or more show something outside of the room in its direction, and no more are sure to look
/// through to something inside. mirroredFloorM: the height of a floor that, farther away than the point, is
/// outside, too: the floor's reflection begins at the mirror, and goes on beyond the wall. Frames: room.
Space spaceAt(std::span<const SeenDepth> photos, const Eigen::Vector3d& pInRoom, float marginM = 0.05F,
              std::optional<double> mirroredFloorM = {});

/// Whether one photo surely shows something farther away than a point, by more than two standard deviations.
/// Unlike for spaceAt(), borders of things count, as the nearest pixel shows them. Frames: room.
bool isSeenThrough(std::span<const SeenDepth> photos, const Eigen::Vector3d& pInRoom);

/// For each photo the mean distance of the six nearest others that stand at least 5 cm away, in metres: those
/// that depth is estimated from. It is 0 for a photo without such a neighbour.
std::vector<double> baselinesM(std::span<const Rigid3> roomFromPhotos);

} // namespace spherewalk::place
