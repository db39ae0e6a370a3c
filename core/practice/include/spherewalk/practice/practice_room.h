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

/// Something laid into the practice room, for tests of overlays. It is lit like furniture but neither darkens
/// nor is mirrored by anything, so that it changes no pixel besides its own.
struct PracticeObject {
    enum class Shape { Sphere, Box };

    Shape shape = Shape::Sphere;
    Eigen::Vector3d centreM = Eigen::Vector3d::Zero();         ///< room frame
    Eigen::Vector3d halfSizeM = Eigen::Vector3d::Constant(.1); ///< a sphere's radius is the first
    Radians yaw;
    std::array<std::uint8_t, 3> colour = {200, 30, 30};
};

struct PracticeRoomOptions {
    Eigen::Vector3d originM = Eigen::Vector3d::Zero(); ///< the south-west corner of the floor
    Eigen::Vector3d sizeM = {5, 4, 2.6};               ///< along x (east), y (north), z (up)
    std::vector<PracticeObject> objects;

    /// Errors: InvalidInput for sizes outside 4 x 3.5 x 2.3 to 12 x 12 x 5 m, an origin farther than 10^8 m,
    /// and objects that have no size or lie outside the room.
    void validate() const;
};

/// The room as an operator would draw it. Units: metres, in the room frame.
struct RoomPlan {
    Polygon outline;
    std::vector<Polygon> obstacles; ///< furniture that stands on the floor
    double ceilingM = 0;
};

/// What one ray sees.
struct Sample {
    std::array<float, 3> colour = {}; ///< red, green, blue as pictures store them, [0, 255]
    double rangeM = 0;                ///< along the ray; +infinity where there is nothing
};

/// What a picture shows.
enum class Content {
    Room,           ///< without the objects
    RoomAndObjects, ///< all
    Objects,        ///< the objects alone, black where there are none
};

struct PictureOptions {
    Content content = Content::RoomAndObjects;
    int threads = 0; ///< 0: all that the machine has; the pictures are the same for any number
};

/// A furnished, lit room that exists only as formulas: every picture and every depth of it is exact, from any
/// position. Wood floor, rug, one wall with a repeated pattern, plain plaster, pictures, books, a window, a
/// mirroring ball and a glossy cabinet.
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

    /// originM, direction: room frame, any length but zero. footprint: the angle that the sample stands for,
    /// radians; details too fine for it are left out.
    Sample cast(const Eigen::Vector3d& originM, const Eigen::Vector3d& direction, double footprint,
                Content content = Content::RoomAndObjects) const;

    RgbImage spherical(const Rigid3& roomFromPhoto, const EquirectSize& size,
                       const PictureOptions& options = {}, ProgressSink& progress = noProgress(),
                       const std::stop_token& stop = {}) const;
    RgbImage view(const CameraModel& camera, const Rigid3& roomFromCamera, const PictureOptions& options = {},
                  ProgressSink& progress = noProgress(), const std::stop_token& stop = {}) const;

    /// Distances along the rays through the pixel centres.
    DepthImage sphericalRange(const Rigid3& roomFromPhoto, const EquirectSize& size,
                              const PictureOptions& options = {}) const;
    /// Distances along the optical axis (z-depth) at the pixel centres.
    DepthImage viewDepth(const CameraModel& camera, const Rigid3& roomFromCamera,
                         const PictureOptions& options = {}) const;

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace spherewalk::practice
