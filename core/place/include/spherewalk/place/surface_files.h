// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/place/surface.h"

#include <string>

namespace spherewalk::place {

/// The surface as PLY, binary and little-endian: for each vertex x, y, z, nx, ny, nz, red, green, blue,
/// confidence and photos, and a face for each triangle. Positions are floats, or doubles if the room lies
/// more than a kilometre from its origin. Frames: room.
Bytes plyFile(const Surface& surface);

/// The surface as Wavefront OBJ: positions with colours from 0 to 1 behind them, normals, and triangles.
/// Frames: room.
std::string objFile(const Surface& surface);

/// The surface as binary glTF 2.0 in one file, with normals and colours and without light of its own. Frames:
/// glTF's, y up and metres; the root node turns the room's z axis up. name: of the node. Errors: InvalidInput
/// for a surface without vertices, Unsupported for a file of more than 4 GB.
Bytes glbFile(const Surface& surface, const std::string& name);

} // namespace spherewalk::place
