// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/polygon.h"
#include "spherewalk/geometry/rigid3.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <memory>
#include <stop_token>
#include <vector>

namespace spherewalk::practice {

/// An object in the practice room, for tests of overlays. It is lit like furniture. It has no mirror image
/// and, unless asked to, casts no shadow, so that it changes no pixels but its own.
struct PracticeObject {
    enum class Shape { Sphere, Box };

    Shape shape = Shape::Sphere;
    Eigen::Vector3d centreM = Eigen::Vector3d::Zero();         ///< Room frame, metres.
    Eigen::Vector3d halfSizeM = Eigen::Vector3d::Constant(.1); ///< A sphere's radius is the first number.
    Radians yaw;
    std::array<std::uint8_t, 3> colour = {200, 30, 30};
    /// Whether it takes its light from all that the room radiates towards it, once reflected, and hides that
    /// from what is near. So it casts a soft shadow, in all pictures. Only spheres can.
    bool castsShadow = false;
};

/// A printed AprilTag that hangs in the room, upright, on a sheet with a white rim.
struct PracticeTag {
    int number = 0;
    Eigen::Vector3d centreM = Eigen::Vector3d::Zero(); ///< Middle of the tag, room frame.
    Radians facing;                                    ///< Heading of the direction that it looks in.
    double sizeM = 0.16;                               ///< Side of the black square.

    /// The black square's corners in the room: upper left, upper right, lower right, lower left, as who reads
    /// the tag sees them.
    std::array<Eigen::Vector3d, 4> cornersM() const;
};

/// How the practice room is built and furnished.
enum class RoomStyle {
    Lively, ///< One room with textured walls in an even light, in which depth is easily found.
    Bare,   ///< One room with white walls and ceiling, a burnt-out window, glaring lamps, a glossy floor, a
            ///< mirror, panes of glass, and things close to where a camera stands.
    Flat,   ///< Two rooms and a corridor, between walls of 10 cm with open doorways.
};

struct PracticeRoomOptions {
    Eigen::Vector3d originM = Eigen::Vector3d::Zero(); ///< South-west corner of the floor, metres.
    Eigen::Vector3d sizeM = {5, 4, 2.6};               ///< Along x (east), y (north) and z (up), metres.
    std::vector<PracticeObject> objects;
    std::vector<PracticeTag> tags;
    RoomStyle style = RoomStyle::Lively;

    /// Errors: InvalidInput for sizes outside 4 x 3.5 x 2.3 to 12 x 12 x 5 m (a flat is at least 7 x 5.5 m
    /// large), an origin farther than 10^8 m, objects that have no size, lie outside the room, or
    /// are boxes that cast shadows, and tags
    /// with an unknown number, a size outside 2 cm to 1 m, or a place outside the room.
    void validate() const;
};

/// The plan that an operator would draw of the room. Frames: room. Units: metres.
struct RoomPlan {
    Polygon outline;
    std::vector<Polygon> obstacles; ///< Outlines of the furniture that stands on the floor.
    double ceilingM = 0;
};

/// What one ray meets.
struct Sample {
    std::array<float, 3> colour = {}; ///< Red, green, blue as pictures store them, [0, 255].
    double rangeM = 0;                ///< Along the ray; +infinity where it meets nothing.
};

/// The content of a picture.
enum class Content {
    Room,           ///< The room without the objects.
    RoomAndObjects, ///< Everything.
    Objects,        ///< The objects alone, before black.
};

struct PictureOptions {
    Content content = Content::RoomAndObjects;
    int threads = 0; ///< 0: all that the machine has. Pictures are equal for any number.
};

/// A furnished, lit room that exists only as formulas, so that its pictures and depths are exact from any
/// position. It has a wood floor, a rug, a wall with a repeated pattern, plain plaster, paintings, books, a
/// window, a mirroring ball and a glossy cabinet. RoomStyle names rooms that are harder. A pane of glass
/// reflects, and its distance is that of what lies behind it.
///
/// Pictures: a pixel is the average of the scene over the pixel's area, in the values that pictures store
/// (not in linear light), so that resampling one picture gives another. Textures fade where a pixel cannot
/// hold them; edges are supersampled. Frames: roomFromPhoto takes the panorama frame (x forward, y left, z
/// up), roomFromCamera the optical frame (z forward, x right, y down) to the room frame. The walls are seen
/// from inside only. Errors: InvalidInput for spherical pictures with sides outside [1, 32768]. Threads:
/// const, any number. Stop: Error{Stopped}. Cost: about 0.4 us a pixel and core.
class PracticeRoom {
  public:
    /// Errors: those of PracticeRoomOptions::validate().
    explicit PracticeRoom(PracticeRoomOptions options = {});
    ~PracticeRoom();
    PracticeRoom(PracticeRoom&&) noexcept;
    PracticeRoom& operator=(PracticeRoom&&) noexcept;

    const PracticeRoomOptions& options() const;
    RoomPlan plan() const;

    /// What the ray from originM meets first. Frames: room. direction: any length but zero. footprint: the
    /// angle of the sample, radians; finer details are averaged.
    Sample cast(const Eigen::Vector3d& originM, const Eigen::Vector3d& direction, double footprint,
                Content content = Content::RoomAndObjects) const;

    /// Distance from a point to the nearest wall, floor, ceiling or piece of furniture, in metres. Frames:
    /// room. Range: a point inside of the room, or near it.
    double surfaceDistanceM(const Eigen::Vector3d& pInRoom) const;

    /// The equirectangular picture of a camera with this pose. Range: size.width and height in [1, 32768].
    RgbImage spherical(const Rigid3& roomFromPhoto, const EquirectSize& size,
                       const PictureOptions& options = {}, ProgressSink& progress = noProgress(),
                       const std::stop_token& stop = {}) const;
    /// The picture of a camera with this lens and pose.
    RgbImage view(const CameraModel& camera, const Rigid3& roomFromCamera, const PictureOptions& options = {},
                  ProgressSink& progress = noProgress(), const std::stop_token& stop = {}) const;

    /// Distances along the rays through the pixel centres, metres; +infinity where there is nothing.
    DepthImage sphericalRange(const Rigid3& roomFromPhoto, const EquirectSize& size,
                              const PictureOptions& options = {}) const;
    /// Distances along the optical axis (z-depth) at the pixel centres, metres.
    DepthImage viewDepth(const CameraModel& camera, const Rigid3& roomFromCamera,
                         const PictureOptions& options = {}) const;

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

/// Where a person stands who walks once through the room with the camera on a stick: a step apart, clear of
/// walls and furniture, from one door to the next as far as the rooms are joined. Range: stepM above 0.
std::vector<Eigen::Vector3d> walkThrough(const PracticeRoom& room, double stepM, double lensHeightM);

/// Free places on the walls for tags 0 to count - 1, spread around the room at about the height of a lens.
/// Nothing stands in front of them for a metre. Fewer if the walls have no more free places.
std::vector<PracticeTag> tagsOnWalls(const PracticeRoom& room, int count, double sizeM);

} // namespace spherewalk::practice
