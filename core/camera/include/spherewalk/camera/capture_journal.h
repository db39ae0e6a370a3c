// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/survey/shot.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace spherewalk::camera {

/// A photo that has been downloaded and verified, but is not in the survey yet.
struct DownloadedPhoto {
    std::filesystem::path temporaryFile; ///< File in the file system of the survey.
    std::string fileUrl;
    std::string cameraFileName;
    std::string cameraSha256;
    std::uint64_t sizeBytes = 0;
    int width = 0;
    int height = 0;
};

/// Where the capture workflow records what it does, so that it can be killed at any instant. Each function
/// has made its record durable when it returns. The survey's store implements the journal. Errors: those of
/// the store; the workflow then stops before the next step.
class CaptureJournal {
  public:
    virtual ~CaptureJournal() = default;

    /// Records a new shot as Intended.
    virtual survey::Shot begin(std::int64_t station, const std::string& cameraSerial,
                               const survey::Baseline& baseline) = 0;
    virtual void started(std::int64_t shot, const std::string& commandId) = 0;
    virtual void taken(std::int64_t shot, const std::string& fileUrl) = 0;
    virtual void notTaken(std::int64_t shot) = 0;
    /// Allowed for a shot that is Taken, too. fileUrl: the picture that may be the shot's, for a person to
    /// decide on; "" if there is none.
    virtual void unclear(std::int64_t shot, const std::string& why, const std::string& fileUrl) = 0;
    /// Tags the photo with its station, moves it into the survey, and records it, in one durable step.
    /// Returns the shot as it is recorded: Downloaded, or Unclear with the reason if the survey has these
    /// bytes at another place.
    virtual survey::Shot downloaded(std::int64_t shot, const DownloadedPhoto& photo) = 0;

    /// The shots that are Intended, Started or Taken, oldest first. A resumed run settles them before it
    /// takes anything new.
    virtual std::vector<survey::Shot> openShots() const = 0;
    /// The folder for incomplete downloads.
    virtual std::filesystem::path downloadFolder() const = 0;
};

} // namespace spherewalk::camera
