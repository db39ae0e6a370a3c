// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/camera/endpoint.h"
#include "spherewalk/camera/osc_messages.h"

#include <chrono>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::camera {

/// An address at which a camera may answer, and why: "its own WiFi", "announced as THETAYL00123456".
struct CameraPlace {
    Endpoint endpoint;
    std::string why;
};

/// Where cameras usually are: on their own WiFi, and a practice camera on this computer.
std::vector<CameraPlace> usualPlaces();

/// A camera that answered.
struct FoundCamera {
    CameraPlace place;
    CameraInfo info;
};

/// Where to look for cameras, and for how long.
struct FindOptions {
    std::vector<CameraPlace> places = usualPlaces();
    std::chrono::milliseconds answerTime{
        2'500}; ///< Time that each place has to answer; all are asked at the same time.
    std::chrono::milliseconds browseTime{1'500}; ///< Time to listen for announcements; 0 to ignore them.

    /// Errors: InvalidInput, with the option and its range.
    void validate() const;
};

/// What was found.
struct FindReport {
    std::vector<FoundCamera> cameras; ///< Each camera once, in the order of the places.
    std::vector<CameraPlace> silent;  ///< Places where no camera answered.
    std::string note; ///< Why announcements could not be heard, as a sentence; "" if they could.
};

/// Asks all places, and those that cameras in client mode announce on the network by DNS-SD (_osc._tcp,
/// through Avahi where it is there), who answers. Changes nothing on any camera. Errors: InvalidInput,
/// Stopped. Stop: within 200 ms. Threads: uses some of its own.
FindReport findCameras(const FindOptions& options, const std::stop_token& stop);

} // namespace spherewalk::camera
