// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/sensor.h"
#include "spherewalk/render/view_stream.h"
#include "spherewalk/simulator/frame.h"

#include <chrono>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace spherewalk::simulator {

/// The axes of a camera's frame.
enum class CameraAxes {
    Body,    ///< x forward, y left, z up, as links of simulators have them.
    Optical, ///< z forward, x right, y down, as frames have them whose names end in _optical.
};

/// Turns a simulator's pose into the camera's pose in the room.
struct Mounting {
    Rigid3 roomFromWorld;               ///< Identity where the simulator's world is the dataset's room.
    Rigid3 linkFromCamera;              ///< The camera's frame on the link whose poses come in.
    CameraAxes axes = CameraAxes::Body; ///< The axes of the camera's frame.

    /// The pose of the camera's optical frame.
    Rigid3 roomFromOptical(const Rigid3& worldFromLink) const;

    /// Errors: InvalidInput for transforms that are not finite, or whose quaternions have not unit length.
    void validate() const;
};

/// How objects are told from the simulator's model of the room, which its depth camera may see too.
enum class ObjectsBy {
    Labels, ///< A segmentation camera says which pixels show the room. What has no label and is black is no
            ///< object.
    Depth,  ///< Objects are nearer than the room of the dataset's outline, and not black.
    Alone,  ///< The depth camera sees objects only.
};

/// In View::labels, an object that the simulator gives no label.
inline constexpr std::uint16_t kUnlabelled = 65535;

/// The words "labels", "depth", "alone". Errors: objectsBy() throws InvalidInput for another word.
std::string_view name(ObjectsBy by);
ObjectsBy objectsBy(std::string_view name);

/// How pictures of the simulator's objects are laid into frames. The cameras that take these pictures stand
/// at the simulated camera's place.
struct OverlayOptions {
    ObjectsBy by = ObjectsBy::Labels;
    /// With ObjectsBy::Labels, pixels with these labels show the photo: the room's own model, and 0 where
    /// the room has no label. All other labels are objects.
    std::vector<std::uint8_t> roomLabels = {0, 1};
    /// With ObjectsBy::Depth, an object is nearer than the room by at least nearerM metres, and by at least
    /// this share of the room's depth.
    double nearerM = 0.02;
    double nearerShare = 0.01;
    /// A frame without its overlay is rendered when a pose comes that is later by this simulation time; with
    /// Pace::Every, also when 16 later frames have their overlays.
    Stamp wait = std::chrono::milliseconds(500);
    /// An overlay between two poses is laid into a frame of the interpolated pose. Otherwise an overlay fits
    /// the pose of exactly its stamp only.
    bool interpolatesPoses = false;
    std::optional<CameraIntrinsics> camera; ///< The pictures' camera; without it, the simulated camera.

    /// Errors: InvalidInput for wait outside of 0 to 10 s, and for negative distances.
    void validate() const;
};

enum class OverlayPart { Colour, Depth, Labels };

/// The pictures of one pose; those that have not come are empty. Shape: the same for all.
struct OverlayParts {
    RgbImage colour;
    DepthImage depth; ///< z along the optical axis, metres
    MaskImage labels;

    /// Takes the pictures that the other has, in place of its own.
    void take(OverlayParts&& other);

    bool isWhole(ObjectsBy by) const {
        return !colour.empty() && !depth.empty() && (by != ObjectsBy::Labels || !labels.empty());
    }
};

/// What becomes of a frame that is due while an earlier one is still being rendered.
enum class Pace {
    Newest, ///< Late frames are left out; this suits a simulation that runs by itself.
    Every,  ///< All are rendered in turn, for lock-step and recordings; of more than 256 the oldest is left
            ///< out. At most 34 overlays wait; what comes beyond them costs its own frame the overlay.
};

/// The words "newest", "every". Errors: pace() throws InvalidInput for another word.
std::string_view name(Pace pace);
Pace pace(std::string_view name);

struct CameraOptions {
    render::ViewOptions view; ///< Its overlays and its wish for depth are not used.
    render::StreamOptions stream;
    Mounting mounting;
    /// Frames a second of simulation time. A frame is taken at the first pose at or after each multiple of
    /// 1/rateHz; a pose up to a microsecond earlier counts as at the multiple. 0 stands for a frame at each
    /// pose. Range: up to 1000.
    double rateHz = 30;
    Pace pace = Pace::Newest;
    std::optional<OverlayOptions> overlay; ///< Without it, frames show the photos alone.
    /// The sensor that takes the frames; without it, frames are the views. During a frame's exposure the
    /// camera goes on as between the frame's pose and the one before. Laid-in objects are not blurred by
    /// motion: their pictures are of one pose.
    std::optional<render::SensorModel> sensor;
    /// Whether View::depth is made, with the laid-in objects and the errors of the sensor: the depth image of
    /// an RGB-D camera, at the frame's stamp. View::depth is empty where the scene model knows none.
    bool wantsDepth = false;
    /// Whether View::labels is made of the laid-in objects: the simulator's labels, or kUnlabelled; 0 is the
    /// room.
    bool wantsLabels = false;

    /// Errors: InvalidInput.
    void validate() const;
};

} // namespace spherewalk::simulator
