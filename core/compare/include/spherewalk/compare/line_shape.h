// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace spherewalk::compare {

/// Where a picture should show a line that is straight in the room: points about a pixel apart, in order. A
/// lens with distortion bends them. Units: pixels.
using PictureLine = std::vector<Eigen::Vector2d>;

/// The straight line between two pixels. Errors: InvalidInput for points that are not finite.
PictureLine pictureLine(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

/// The line between two points of the room as this camera sees it. Points that it does not see are left out.
/// Units: metres. Frames: roomFromCamera is optical. Errors: InvalidInput for points that are not finite.
PictureLine pictureLine(const CameraModel& camera, const Rigid3& roomFromCamera,
                        const Eigen::Vector3d& fromInRoom, const Eigen::Vector3d& toInRoom);

/// The long straight lines that a picture shows: those of at least `leastPx` pixels. Units: pixels. Errors:
/// InvalidInput for an empty picture. Source: von Gioi 2010 (LSD).
std::vector<PictureLine> straightLines(const RgbImage& picture, double leastPx = 80);

/// How a view shows a line that is straight in truth. Units: pixels.
struct LineShape {
    double rmsPx = 0;       ///< Root mean square distance of the edge points from the straight line that
                            ///< fits them best.
    double worstPx = 0;     ///< The largest of these distances.
    double offPx = 0;       ///< Mean distance of the edge points from where they should be.
    std::size_t points = 0; ///< Number of edge points.
    double foundShare = 0;  ///< Share of the line's points that have an edge point.
};

/// The shape of the line in the view. At each of the line's points the strongest slope of brightness across
/// the line, at most `reachPx` away, is an edge point, to a tenth of a pixel. Slopes count from 4 grey levels
/// a pixel on, and of one sign only: the sign that more of the line has or, for a thin line, the straighter
/// one. A line that is moved or turned as a whole is still straight. Nothing if fewer than half of the
/// points, or fewer than 8, have an edge point. Range: reachPx in [1, 100]. Errors: InvalidInput for an empty
/// view or another reach.
std::optional<LineShape> lineShape(const RgbImage& view, const PictureLine& line, double reachPx = 6);

/// The shapes of several lines together.
struct Straightness {
    std::optional<double> rmsPx;   ///< Over all edge points; nothing without a line that was found.
    std::optional<double> worstPx; ///< The worst line's rmsPx, since single points may be another thing's.
    std::size_t found = 0;         ///< Number of lines that have a shape.
    std::size_t lines = 0;         ///< Number of lines that were sought.
};

/// Errors: those of lineShape().
Straightness straightness(const RgbImage& view, const std::vector<PictureLine>& lines, double reachPx = 6);

} // namespace spherewalk::compare
