// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/render/renderer.h"
#include "spherewalk/simulator/camera_options.h"
#include "spherewalk/simulator/frame.h"
#include "spherewalk/simulator/raw_picture.h"
#include "spherewalk/simulator/refusals.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace spherewalk::simulator {

/// A camera of a rig in a simulator.
struct MountedCamera {
    CameraModel model;
    Rigid3 rigFromOptical; ///< Its optical frame in the rig's frame.
};

/// Counts since the camera was made. Those of a rig's frames count the times, not the pictures.
struct CameraCounters {
    std::uint64_t poses = 0; ///< Poses that were taken, whether or not somebody listened.
    std::uint64_t frames = 0;
    std::uint64_t dropped = 0;  ///< Due frames that were left out for a newer one, or as time went back.
    std::uint64_t restarts = 0; ///< How often simulation time went back.
    std::uint64_t outside = 0;  ///< Frames from outside of the dataset's room.
    std::uint64_t overlaysLaid = 0;
    std::uint64_t overlaysMissing = 0; ///< Frames rendered without the overlay that they wanted.
    std::uint64_t overlaysUnused = 0;  ///< Overlays that fitted no frame, or were not whole.
    render::StreamCounters stream;     ///< Photos that were late for the current camera model.
    Refusals::Counts refused{};
};

/// A robot's camera in a simulator, or its rig of cameras, for any middleware. Poses and pictures of objects
/// come in with simulation stamps; frames go out with the stamps of the poses that they show.
///
/// Input is not trusted: invalid poses and pictures that do not fit are counted and reported as Refusals
/// says, and change nothing. A pose far from the room is rendered, with trust 0.
///
/// An overlay is laid into the frame of exactly its stamp, whose pose may be one between two that came
/// (OverlayOptions::interpolatesPoses). A frame waits for it until a pose comes that is
/// OverlayOptions::wait later. Then the frame is rendered without an overlay, and counted. In lock-step, no
/// frame is rendered without its overlay while the simulation stands still.
///
/// A rig's cameras have one schedule: each due time gives a frame of every camera, with the same stamp. They
/// are rendered from the same photos in memory, and handed over when all are there. Where one cannot be
/// rendered, none is handed over. An overlay is one of each camera.
///
/// Threads: all functions may be called from any thread. The camera's own thread renders the frames
/// one after the other, and hands them over.
class SimulatedCamera {
  public:
    /// Called for each frame; the frame is valid during the call. An Error that it throws is counted as a
    /// frame that could not be rendered.
    using GiveFrame = std::function<void(const Frame&)>;

    /// tell: receives sentences about refused input. Owner: the camera shares the renderer's dataset and
    /// cache. Errors: InvalidInput for options out of range, and for ObjectsBy::Depth in a dataset without
    /// outline.
    SimulatedCamera(const render::Renderer& renderer, const CameraModel& camera, const CameraOptions& options,
                    GiveFrame giveFrame, Refusals::Tell tell);
    /// A rig. CameraOptions::mounting gives the pose of the rig's frame: CameraAxes::Optical leaves its axes
    /// as they are. The noise of CameraOptions::sensor differs from camera to camera.
    /// Errors: the same; InvalidInput without a camera.
    SimulatedCamera(const render::Renderer& renderer, const std::vector<MountedCamera>& cameras,
                    const CameraOptions& options, GiveFrame giveFrame, Refusals::Tell tell);
    /// Waits for the frame that is being rendered.
    ~SimulatedCamera();
    SimulatedCamera(const SimulatedCamera&) = delete;
    SimulatedCamera& operator=(const SimulatedCamera&) = delete;

    /// Tells whether somebody wants frames; at first, nobody does. While nobody listens, nothing is rendered,
    /// and waiting frames are dropped. Cost: next to nothing without a change.
    void setListening(bool isListening);

    /// Whether stamp and pose are valid; if not, they are refused.
    bool accepts(Stamp stamp, const Rigid3& pose);

    /// Whether a pose of this stamp would be that of a frame. A simulation in lock-step, with Pace::Every,
    /// waits before such a pose until the frames before are there: waitUntilIdle().
    bool isDue(Stamp stamp) const;

    /// Takes the pose of the link; CameraOptions::mounting gives the camera's pose. Range: quaternions within
    /// 1 % of unit length are normalised.
    void takePose(Stamp stamp, const Rigid3& worldFromLink);

    /// The same where each camera of a rig has a link of its own, as with tf: MountedCamera says where it
    /// sits on that link. worldFromLinks: of each camera in turn, at one time. Errors: InvalidInput for
    /// another number of poses.
    void takePoses(Stamp stamp, const std::vector<Rigid3>& worldFromLinks);

    /// Takes a picture of the simulator's objects, as a camera of the rig sees them. It is ignored without
    /// CameraOptions::overlay, and while nobody listens. Range: index of a camera.
    void takeOverlay(OverlayPart part, Stamp stamp, const RawPicture& picture, std::size_t index = 0);

    /// Sets a camera of the frames from now on. Waiting overlays are dropped, since the former camera took
    /// them. Range: index of a camera.
    void setCamera(const CameraModel& camera, std::size_t index = 0);

    /// Counts and reports a refusal that only the middleware's side can see.
    void refuse(Refusal kind, const std::string& sentence);

    /// Returns when every frame that can be rendered by now has been handed over.
    void waitUntilIdle();

    CameraCounters counters() const;

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace spherewalk::simulator
