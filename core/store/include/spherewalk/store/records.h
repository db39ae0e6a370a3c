// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/survey/plan.h"

#include <Eigen/Geometry>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::store {

/// A moment in UTC; kept to the millisecond.
using Moment = std::chrono::system_clock::time_point;

struct SurveyInfo {
    std::string uuid;
    std::string name; ///< as people call the survey
    Moment createdAt;
};

/// A station with its identity, which never changes.
struct StationRecord {
    std::int64_t id = 0;
    std::string name; ///< "rail 3, stop 5"
    survey::Station station;
};

/// A photo that is to become part of the survey. Its file is already complete in the photo folder.
struct NewPhoto {
    std::int64_t station = 0;
    std::string fileName; ///< in the photo folder; see SurveyStore::freePhotoName
    std::string cameraFileName;
    std::string cameraSerial;    ///< "" if unknown
    std::string fileUrl;         ///< on the camera; "" for imported photos
    std::string cameraSha256;    ///< of the bytes as the camera gave them: the photo's identity
    std::string fileSha256;      ///< of the file in the photo folder, which carries a position tag besides
    std::uint64_t sizeBytes = 0; ///< of the file in the photo folder
    int width = 0;
    int height = 0;
    std::optional<Moment> takenAt; ///< if the photo says
    Eigen::Vector3d positionM =
        Eigen::Vector3d::Zero(); ///< of the lens, room frame; may differ from the station's
    std::string note;
    bool choose = true; ///< in place of the station's photo that was chosen so far, if there is one
};

struct PhotoRecord : NewPhoto { // choose says whether it is the station's chosen photo
    std::int64_t id = 0;
    Moment addedAt;
};

/// What the checks say of a photo, from good to bad.
enum class CheckResult { Good, Doubtful, Failed };

/// As reports spell it: "good", "doubtful", "failed".
std::string_view name(CheckResult result);

/// The verdict on a photo.
struct PhotoVerdict {
    std::int64_t photo = 0;
    CheckResult result = CheckResult::Good;
    std::string findings = "[]"; ///< JSON: array of objects with "flaw", "quality" and "sentence"

    bool operator==(const PhotoVerdict&) const = default;
};

/// What a person decided on a photo, in place of what the checks say.
enum class Decision { Open, Accepted, Rejected };

/// As options and reports spell it: "open", "accepted", "rejected".
std::string_view name(Decision decision);

/// Errors: InvalidInput, listing the names.
Decision decisionNamed(std::string_view name);

struct Review {
    std::int64_t photo = 0;
    Decision decision = Decision::Open;
    std::string note; ///< one line

    bool operator==(const Review&) const = default;
};

/// A photo that is to belong to another station, with the file that says so.
struct MovedPhoto {
    std::int64_t photo = 0;
    std::int64_t station = 0;
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero(); ///< of the lens, room frame
    std::string fileName;                                ///< complete in the photo folder
    std::string fileSha256;
    std::uint64_t sizeBytes = 0;
    bool choose = true; ///< in place of the photo that the station has chosen
};

/// How far one shot has come; the same steps as the capture workflow's.
enum class ShotStep { Intended, Started, Taken, Downloaded, NotTaken, Unclear };

struct ShotRecord {
    std::int64_t id = 0;
    std::int64_t station = 0;
    ShotStep step = ShotStep::Intended;
    Moment intendedAt;
    std::string cameraSerial;
    std::string latestFileUrl;         ///< on the camera before the shot; "" if none
    std::int64_t totalEntries = 0;     ///< on the camera before the shot
    std::string commandId;             ///< "" until Started
    std::string fileUrl;               ///< "" until Taken
    std::string note;                  ///< why Unclear
    std::optional<std::int64_t> photo; ///< once Downloaded
};

/// What a solution says of one photo.
struct SolvedPhoto {
    std::int64_t photo = 0;
    Eigen::Quaterniond roomFromPhoto = Eigen::Quaterniond::Identity();
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero();
    std::optional<double> sigmaYawRad; ///< standard deviations, where known
    std::optional<double> sigmaPitchRad;
    std::optional<double> sigmaRollRad;
    std::optional<double> sigmaPositionM;
    std::string status;       ///< verdict: "good", "doubtful" or "failed"
    std::string flags = "[]"; ///< JSON: why
};

struct NewSolution {
    std::string source;        ///< "imported", "align"
    std::string model;         ///< the alignment model, "yaw" for example
    std::string report = "{}"; ///< JSON: how it was made
    std::vector<SolvedPhoto> photos;
};

struct SolutionRecord {
    std::int64_t id = 0;
    std::string source;
    std::string model;
    std::string report;
    Moment createdAt;
    bool isActive = false;
};

struct Counts {
    int stations = 0;
    int stationsWithPhoto = 0; ///< that is chosen and not rejected
    int photos = 0;
    int rejectedPhotos = 0; ///< of the chosen ones
    int openShots = 0;      ///< Intended, Started or Taken
    int unclearShots = 0;
    int solutions = 0;
};

} // namespace spherewalk::store
