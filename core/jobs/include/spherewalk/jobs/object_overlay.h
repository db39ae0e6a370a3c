// SPDX-License-Identifier: GPL-3.0-or-later
// Objects that stand for those which a simulator would render into a view.
#pragma once

#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/light_probe.h"
#include "spherewalk/render/overlay.h"
#include "spherewalk/render/renderer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::jobs {

/// A ball in the room. It stands for an object that a simulator would render into a view.
struct Ball {
    Eigen::Vector3d centreM = Eigen::Vector3d::Zero(); ///< Room frame.
    double radiusM = 0.2;
    std::array<std::uint8_t, 3> colour = {215, 60, 30}; ///< Red, green, blue.

    /// Errors: InvalidInput for numbers that are not finite, and for a radius of zero or less.
    void validate() const;
};

/// The ball that "x y z radius" spells, in metres. Errors: InvalidInput.
Ball parseBall(std::string_view text);

/// Colour and depth of the ball as a simulator would render it from the view's own pose, lit from above. The
/// pictures are empty where the camera stands in the ball or does not see it.
///
/// Errors: those of Ball::validate().
/// Cost: about 0.1 microseconds for each pixel of the box around the ball.
render::Overlay ballOverlay(const Ball& ball, const CameraModel& camera, const Rigid3& roomFromCamera);

/// The light at a ball's place: what shades it, and what its shadow is made of.
struct BallLight {
    /// probe: at the ball's centre.
    explicit BallLight(const render::LightProbe& probe);
    /// As the scene model of these views shows it. Errors: those of render::lightProbe(). Cost: that of a
    /// probe; frames of one ball share it.
    BallLight(const render::Renderer& renderer, const Ball& ball, const render::ViewOptions& views);

    render::LightHarmonics harmonics;
    std::vector<render::DirectionalLight> lights;
};

/// The same ball in the light of a place, as a simulator would light it, and its shadow on the room.
/// light: at the ball's centre. roomDepth: that of the view without the ball, as View::depth; it
/// may be empty, and the ball then casts no shadow.
///
/// Errors: those of Ball::validate(); InvalidInput for a depth of another size than the camera's.
/// Cost: some microseconds for each pixel that the shadow may reach.
render::Overlay litBallOverlay(const Ball& ball, const CameraModel& camera, const Rigid3& roomFromCamera,
                               const BallLight& light, const DepthImage& roomDepth);

/// 255 in each pixel at whose centre the ball would be seen if nothing hid it, else 0: the pixels of
/// ballOverlay().
MaskImage ballMask(const Ball& ball, const CameraModel& camera, const Rigid3& roomFromCamera);

/// The surface of an object: triangles, brought to one size. The object stands on the origin, z is up, and
/// the longest side of its bounds is 1. Threads: const functions, any number at a time.
class ObjectMesh {
  public:
    using Triangle = std::array<std::uint32_t, 3>; ///< Indices of vertices.

    /// Errors: InvalidInput for no triangle, an index beyond the vertices, a vertex that is not finite, and
    /// for points that are all the same.
    ObjectMesh(std::vector<Eigen::Vector3f> vertices, std::vector<Triangle> triangles);

    /// Returns a cube.
    static ObjectMesh cube();

    /// The longest side of the bounds that the vertices had, in their unit.
    double longestSide() const { return m_longestSide; }

    std::size_t triangles() const { return m_triangles.size(); }

    /// The sides of the bounds, of which the longest is 1.
    Eigen::Vector3f sides() const { return m_greatest - m_least; }

    /// A hash of all triangles.
    std::string fingerprint() const;

    bool contains(const Eigen::Vector3d& point) const;

    /// Where a ray first meets a triangle, from either side.
    struct Hit {
        double along = 0;       ///< In lengths of the ray's direction.
        Eigen::Vector3f normal; ///< A unit vector towards where the ray comes from.
    };

    /// Returns false where the ray meets nothing. hit: set where it does.
    bool meets(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, Hit& hit) const;

  private:
    /// A box around triangles, or around two boxes. The first of both follows at once.
    struct Node {
        Eigen::Vector3f least;
        Eigen::Vector3f greatest;
        std::uint32_t begin = 0; ///< The first triangle of a leaf, or the second box.
        std::uint32_t count = 0; ///< 0 for a node with two boxes.
    };

    void fit();
    void build(std::uint32_t begin, std::uint32_t end, std::vector<Eigen::Vector3f>& centres);

    std::vector<Eigen::Vector3f> m_vertices;
    std::vector<Triangle> m_triangles;
    std::vector<Node> m_nodes;
    Eigen::Vector3f m_least = Eigen::Vector3f::Zero();
    Eigen::Vector3f m_greatest = Eigen::Vector3f::Zero();
    double m_longestSide = 0;
};

/// Reads vertices and faces of a Wavefront OBJ file, with z up. Faces of more than three corners become fans.
/// All else in the file counts for nothing. Errors: those of readFile(); Corrupt for what is no such file,
/// and for more than kMostObjTriangles.
ObjectMesh readObj(const std::filesystem::path& file);
inline constexpr std::size_t kMostObjTriangles = 1'000'000;

/// An object in the room. It stands for one that a simulator would render into a view.
struct PlacedMesh {
    std::shared_ptr<const ObjectMesh> mesh;              ///< Not null.
    Eigen::Vector3d footM = Eigen::Vector3d::Zero();     ///< Where its origin stands in the room.
    double sizeM = 0.4;                                  ///< Its longest side.
    Radians yaw;                                         ///< Counter-clockwise from above.
    std::array<std::uint8_t, 3> colour = {30, 110, 190}; ///< Red, green, blue.
    std::string category = "mesh";                       ///< In labels.

    /// The pose of the middle of the box about the object, and the box's size along its own axes.
    Rigid3 roomFromBox() const;
    Eigen::Vector3d boxSizeM() const;

    /// Errors: InvalidInput for numbers that are not finite, and for a size of zero or less.
    void validate() const;
};

/// The object that "FILE x y z size yaw" spells: an OBJ file or "cube", the place of its foot and its longest
/// side in metres, and its heading in degrees, which may be left out. Its category is "cube" or the file's
/// name without ".obj". Errors: InvalidInput, and those of readObj().
PlacedMesh parseObject(std::string_view text);

/// Colour and depth of the object as a simulator would render it from the view's own pose, lit from above.
/// The pictures are empty where the camera stands in the object's bounds or does not see it.
///
/// Errors: those of PlacedMesh::validate().
/// Cost: about a microsecond for each pixel of the box around the object, shared by the machine's threads.
render::Overlay meshOverlay(const PlacedMesh& object, const CameraModel& camera,
                            const Rigid3& roomFromCamera);

/// 255 in each pixel at whose centre the object would be seen if nothing hid it, else 0.
MaskImage meshMask(const PlacedMesh& object, const CameraModel& camera, const Rigid3& roomFromCamera);

} // namespace spherewalk::jobs
