// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace spherewalk::camera {

/// What the camera held before a shot: what is newer afterwards came from the shot.
struct Baseline {
    std::string latestFileUrl; ///< marked, see new_files.h; "" if none
    std::int64_t totalEntries = 0;
    bool operator==(const Baseline&) const = default;
};

/// How far one shot has come. The steps are recorded in this order; each is on disk before the next begins.
enum class ShotStep {
    Intended,   ///< recorded, camera perhaps triggered
    Started,    ///< the camera gave a command id
    Taken,      ///< the file on the camera is known
    Downloaded, ///< the photo is complete, verified, and in the survey
    NotTaken,   ///< proved that the camera took no picture
    Unclear,    ///< a person must decide (more than one new file, another camera, counter reset)
};

struct Shot {
    std::int64_t id = 0;
    std::int64_t station = 0;
    ShotStep step = ShotStep::Intended;
    std::chrono::system_clock::time_point intendedAt;
    std::string cameraSerial;
    Baseline baseline;
    std::string commandId; ///< "" until Started
    std::string fileUrl;   ///< "" until Taken; marked, see new_files.h, if the camera listed it
    std::string note;      ///< why Unclear
};

/// A photo that has been downloaded and verified, not yet in the survey.
struct DownloadedPhoto {
    std::filesystem::path temporaryFile; ///< in the survey's own file system
    std::string fileUrl;
    std::string cameraFileName;
    std::string cameraSha256;
    std::uint64_t sizeBytes = 0;
    int width = 0;
    int height = 0;
};

/// Where the capture workflow records what it does, so that it can be killed at any instant: each function
/// has made its record durable when it returns. Implemented over the survey's store. Errors: whatever the
/// store throws; the workflow then stops before the next step.
class CaptureJournal {
  public:
    virtual ~CaptureJournal() = default;

    virtual Shot begin(std::int64_t station, const std::string& cameraSerial, const Baseline& baseline) = 0;
    virtual void started(std::int64_t shot, const std::string& commandId) = 0;
    virtual void taken(std::int64_t shot, const std::string& fileUrl) = 0;
    virtual void notTaken(std::int64_t shot) = 0;
    /// Also of a shot that is Taken.
    virtual void unclear(std::int64_t shot, const std::string& why) = 0;
    /// Tags the photo with its station, moves it into the survey, and records it, in one durable step.
    virtual void downloaded(std::int64_t shot, const DownloadedPhoto& photo) = 0;

    /// Shots that are Intended, Started or Taken, oldest first: what a resumed run settles before anything
    /// new.
    virtual std::vector<Shot> openShots() const = 0;
    /// Where downloads may be put while incomplete.
    virtual std::filesystem::path downloadFolder() const = 0;
};

} // namespace spherewalk::camera
