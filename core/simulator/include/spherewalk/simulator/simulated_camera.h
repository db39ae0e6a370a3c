// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/render/renderer.h"
#include "spherewalk/simulator/camera_options.h"
#include "spherewalk/simulator/frame.h"
#include "spherewalk/simulator/raw_picture.h"
#include "spherewalk/simulator/refusals.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace spherewalk::simulator {

/// What a camera has taken and given since it was made.
struct CameraCounters {
    std::uint64_t poses = 0; ///< that were taken, while somebody listened or not
    std::uint64_t frames = 0;
    std::uint64_t dropped = 0;  ///< frames that were due, and left out since a newer one was
    std::uint64_t restarts = 0; ///< simulation time went back
    std::uint64_t outside = 0;  ///< frames from outside of the dataset's room
    std::uint64_t overlaysLaid = 0;
    std::uint64_t overlaysMissing = 0; ///< frames rendered without the overlay that they should have
    std::uint64_t overlaysUnused = 0;  ///< that fitted no frame, or came in part
    render::StreamCounters stream;     ///< of the current camera model: photos that were late
    Refusals::Counts refused{};
};

/// A robot's camera in a simulator, whatever the middleware: poses and pictures of objects come in with
/// simulation stamps, frames go out with the stamps of the poses that they show.
///
/// What comes in is not believed: poses that are none and pictures that do not fit are counted, told of as
/// Refusals says, and change nothing. A pose far from the room is rendered, with trust 0.
///
/// An overlay is laid into the frame of exactly its stamp. A frame waits for it until a pose comes that is
/// OverlayOptions::wait later; then it is rendered without, and counted. So in lock-step nothing is rendered
/// without an overlay while the simulation stands still.
///
/// Threads: all functions may be called from any thread. Frames are rendered in a thread of its own, one
/// after the other, and handed over in it.
class SimulatedCamera {
  public:
    /// Called for each frame; the frame is valid during the call. An Error that it throws is counted as a
    /// frame that could not be rendered.
    using GiveFrame = std::function<void(const Frame&)>;

    /// tell: where sentences about refused input go. Owner: the camera shares what the renderer has. Errors:
    /// InvalidInput for options out of range, and for telling objects by depth in a dataset without outline.
    SimulatedCamera(const render::Renderer& renderer, const CameraModel& camera, const CameraOptions& options,
                    GiveFrame giveFrame, Refusals::Tell tell);
    /// Ends after the frame that is being rendered.
    ~SimulatedCamera();
    SimulatedCamera(const SimulatedCamera&) = delete;
    SimulatedCamera& operator=(const SimulatedCamera&) = delete;

    /// Whether somebody wants frames; false to begin with. Without, nothing is rendered and what waits is
    /// forgotten. Costs next to nothing if it does not change.
    void setListening(bool isListening);

    /// The link's pose, of which CameraOptions::mounting makes the camera's. Range: quaternions within 1 % of
    /// unit length are normalised.
    void takePose(Stamp stamp, const Rigid3& worldFromLink);

    /// A picture of the simulator's objects. Ignored without CameraOptions::overlay, and while nobody
    /// listens.
    void takeOverlay(OverlayPart part, Stamp stamp, const RawPicture& picture);

    /// Another camera for the frames from now on; overlays that wait are forgotten, for they are of the one
    /// before.
    void setCamera(const CameraModel& camera);

    /// Counts what only the middleware's side can see, and tells of it.
    void refuse(Refusal kind, const std::string& sentence);

    /// Returns when all that can be rendered of what has come is rendered and handed over.
    void waitUntilIdle();

    CameraCounters counters() const;

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace spherewalk::simulator
