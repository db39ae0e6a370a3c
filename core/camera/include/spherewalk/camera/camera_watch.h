// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/camera/capture_options.h"
#include "spherewalk/camera/osc_messages.h"

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace spherewalk::camera {

/// Watches what ends a run sooner or later: battery, storage, heat, plug-ins. Threads: one at a time.
class CameraWatch {
  public:
    /// Owner: the options must outlive the object.
    explicit CameraWatch(const CaptureOptions& options) : m_options(options) {}

    /// The sentences that are new to the operator. Errors: Busy or Full if the camera can take no picture;
    /// the sentence says what to do.
    std::vector<std::string> look(const CameraState& state);
    /// The same for the storage. remaining: number of photos that still fit, if the camera says it.
    std::vector<std::string> lookAtStorage(std::optional<std::int64_t> remaining);

    /// Counts a picture that was taken.
    void notePhoto() { ++m_photos; }

    /// Makes look() repeat everything that is still true.
    void beginAnew() { m_said.clear(); }

    /// How many more photos the storage and the battery allow. The battery's part follows from how far its
    /// charge has fallen. Nothing if neither is known.
    std::optional<std::int64_t> photosLeft() const;

  private:
    struct Reading {
        double fraction = 0;
        int photos = 0; ///< Photos taken until the reading.
    };

    void say(std::vector<std::string>& sentences, const std::string& what, std::string sentence);
    void noteBattery(const CameraState& state);
    std::optional<double> photosByBattery() const;

    const CaptureOptions& m_options;
    std::set<std::string> m_said;
    int m_photos = 0;
    std::optional<std::int64_t> m_remaining;
    std::optional<Reading> m_first; ///< The first reading since the battery was charged.
    Reading m_last;
};

} // namespace spherewalk::camera
