// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/place/fusion.h"
#include "spherewalk/place/seen_depth.h"
#include "spherewalk/render/scene_depth.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <vector>

namespace spherewalk::place {

struct SurfaceVertex {
    Eigen::Vector3d pInRoom = Eigen::Vector3d::Zero();
    Eigen::Vector3f normal = Eigen::Vector3f::Zero(); ///< Unit length, towards the photos.
    std::array<std::uint8_t, 3> colour = {};          ///< Red, green, blue as the photos store them.
    std::uint8_t photos = 0;                          ///< How many photos show a surface here, at most 255.
    float confidence = 0; ///< Share of all photos' weight that these have; the others look through, [0, 1].

    /// Whether a photo shows the vertex: its depth is sure and says so within this distance or two standard
    /// deviations, and the surface faces the photo by more than 9 degrees. A depth whose standard deviation
    /// is more than three times this distance shows nothing. sight: the photo's of the vertex.
    bool isShownBy(const SeenDepth& photo, const Sight& sight, double withinM) const;
};

/// What was seen of a place, as triangles. Where nothing was seen there are none. Frames: room. Units:
/// metres.
struct Surface {
    using Triangle = std::array<std::uint32_t, 3>; ///< Numbers of vertices.

    std::vector<SurfaceVertex> vertices;
    std::vector<Triangle> triangles; ///< Counter-clockwise as seen from the side that was seen.

    Eigen::Vector3d middle(const Triangle& triangle) const;

    /// Along a triangle's normal, and as long as its area in square metres.
    Eigen::Vector3d areaVector(const Triangle& triangle) const;

    double areaM2() const;

    /// Whether some vertex is so far from the origin that floats would round it by more than 0.06 mm.
    bool isFarAway() const;

    /// The normal of each vertex from the triangles about it, weighted by their areas.
    void estimateNormals();

    /// Counts the photos that show each vertex, see SurfaceVertex::isShownBy(), and weighs them against those
    /// that look through. Stop: Stopped.
    void weigh(std::span<const SeenDepth> photos, double withinM, int threads = 0,
               const std::stop_token& stop = {});

    /// Takes out triangles, and vertices that no triangle needs. keeps: called with a triangle's number.
    void keepTriangles(const std::function<bool(std::size_t)>& keeps);

    /// Takes out parts of less area that hang together with nothing.
    void dropSmallParts(double leastAreaM2);
};

/// The surface where the volume's distances change their sign: a vertex for each cell of eight known voxels,
/// in the mean of the places where the cell's edges meet the surface. Vertices have no colour and no
/// evidence yet. Stop: Stopped. Cost: about 0.3 us a voxel. Source: Gibson 1998 (surface nets).
Surface surfaceOf(const Volume& volume, int threads = 0, const std::stop_token& stop = {});

/// Share of all directions about the photos, by solid angle, in which there is a surface. In the others there
/// are holes. cellM: how near to a vertex a ray must come, at least the distance between vertices. Range: at
/// least one photo. Stop: Stopped.
double seenShare(const Surface& surface, std::span<const SeenDepth> photos, double cellM, int threads = 0,
                 const std::stop_token& stop = {});

/// Gives a surface its colours, photo by photo. Owner: the surface must outlive the painter.
class SurfacePainter {
  public:
    /// withinM: as Surface::weigh() was told, so that each vertex has the colours of the photos it counts.
    SurfacePainter(Surface& surface, double withinM);

    /// Adds a photo's colours where it shows the surface. Near photos that look straight at it count most.
    /// picture: as bright as those of the other photos.
    void add(const SeenDepth& depth, const RgbImage& picture, int threads = 0);

    /// Writes the colours into the surface. A vertex that no photo shows is grey.
    void finish();

  private:
    Surface& m_surface;
    double m_withinM;
    std::vector<Eigen::Vector4f> m_sums; ///< Weighted red, green, blue and the weight.
};

/// Moves vertices that lie within this distance of a wall, the floor or the ceiling, and face as it does,
/// onto it. Planes are then planes.
void flatten(Surface& surface, const render::RoomShape& room, double withinM);

/// The surface with as few triangles as an error of this distance allows. The vertices are some of the
/// surface's, with their colours and evidence; normals are those of the new triangles. Cost: about a second
/// for a million triangles. Source: Garland and Heckbert 1997, by meshoptimizer.
Surface simplified(const Surface& surface, double errorM);

/// What stands in a room: the surface without what lies within this distance of its walls, its floor and its
/// ceiling, or beyond.
Surface furnitureOf(Surface surface, const render::RoomShape& room, double withinM);

} // namespace spherewalk::place
