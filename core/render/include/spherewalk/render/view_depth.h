// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/worker_pool.h"
#include "spherewalk/render/view_geometry.h"

namespace spherewalk::render {

/// How far away a view's scene model takes each pixel to be: z along the camera's optical axis, in metres, at
/// the pixel's centre. With SceneKind::Sphere it is the sphere about the photo, seen from where
/// directionOnSphere() takes the camera to stand (never farther out than kLargestDisplacement). It is the
/// depth of a model of the room, not of the room: a table in the sphere has the depth of the sphere.
///
/// Shape: that of the view; empty with SceneKind::None, which knows no depth. Range: > 0; +infinity where the
/// lens sees nothing, and where a ray lies 90 degrees or more off the axis, since no z tells how far it goes.
/// threads: at most, 0 for all of the pool; the values are the same for any number. Errors: those of
/// ViewGeometry::validate().
DepthImage viewDepth(const ViewGeometry& view, WorkerPool& pool, int threads = 0);

} // namespace spherewalk::render
