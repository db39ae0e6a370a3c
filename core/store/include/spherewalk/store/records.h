// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/survey/plan.h"
#include "spherewalk/survey/private_region.h"
#include "spherewalk/survey/shot.h"

#include <Eigen/Geometry>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::store {

/// A moment in UTC. The database keeps it to the millisecond.
using Moment = std::chrono::system_clock::time_point;

/// What identifies a survey.
struct SurveyInfo {
    std::string uuid; ///< Identity for programs, given when the survey was created.
    std::string name; ///< Name that people gave the survey.
    Moment createdAt;
};

/// A station with its identity, which never changes.
struct StationRecord {
    std::int64_t id = 0;
    std::string name; ///< Name that people read, "rail 3, stop 5" for example.
    survey::Station station;
    /// If not, its position tells nothing for sure: a photo came without one. It may be where the photo seems
    /// to have been taken, as far as it is solved.
    bool isPlaceKnown = true;
};

/// What sentences call a photo: "R0010001.JPG (rail 3, stop 5)"; the file alone if its station is named after
/// it, or after its position.
std::string photoAtStation(std::string_view fileName, std::string_view station);

/// Who says what the room of a survey without rails is.
enum class RoomOrigin {
    Solved, ///< The photos, as far as they are solved.
    Drawn,  ///< A person, whose room no solution replaces.
};

/// Where a station outside the plan turns out to be.
struct PlacedStation {
    std::int64_t station = 0;
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero();
    std::string name = {}; ///< Empty: it keeps its name.
    bool isPlaceKnown = true;
};

/// A photo that is to become part of the survey. Its file is already complete in the photo folder.
struct NewPhoto {
    std::int64_t station = 0;
    std::string fileName; ///< Name in the photo folder; SurveyStore::freePhotoName() finds one.
    std::string cameraFileName;
    std::string cameraSerial; ///< Serial number of the camera; "" if it is unknown.
    std::string fileUrl;      ///< URL on the camera; "" for an imported photo.
    /// SHA-256 of the bytes that the camera gave, which is the photo's identity.
    std::string cameraSha256;
    /// SHA-256 of the file in the photo folder, which also holds a position tag.
    std::string fileSha256;
    std::uint64_t sizeBytes = 0;   ///< Size of the file in the photo folder.
    int width = 0;                 ///< Pixels.
    int height = 0;                ///< Pixels.
    std::optional<Moment> takenAt; ///< When the photo was taken, if it says so.
    /// Position of the lens in the room frame. It may differ from the station's.
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero();
    std::string note;
    bool choose = true; ///< Whether the photo replaces the one that the station has chosen so far.
};

/// A photo of the survey. `choose` says whether the station has chosen it.
struct PhotoRecord : NewPhoto {
    std::int64_t id = 0;
    Moment addedAt;
};

/// What the checks of a photo found.
struct PhotoVerdict {
    std::int64_t photo = 0;
    survey::Quality quality = survey::Quality::Good;
    std::string findings = "[]"; ///< JSON array of objects with "flaw", "quality" and "sentence".

    bool operator==(const PhotoVerdict&) const = default;
};

/// What a person decided on a photo. The decision overrules the checks.
enum class Decision { Open, Accepted, Rejected };

/// "open", "accepted" or "rejected", as options and reports spell the decision.
std::string_view name(Decision decision);

/// Errors: InvalidInput for an unknown name; the sentence lists all names.
Decision decisionNamed(std::string_view name);

/// The decision and the note of a person on one photo.
struct Review {
    std::int64_t photo = 0;
    Decision decision = Decision::Open;
    std::string note; ///< One line of text.

    bool operator==(const Review&) const = default;
};

/// Who says that a region of a photo is private.
enum class RegionOrigin {
    Found,    ///< A search for faces.
    Marked,   ///< A person.
    Rejected, ///< Nobody any more: a person has removed what a search found. It is kept from later searches.
};

/// "found", "marked" or "rejected", as reports spell the origin.
std::string_view name(RegionOrigin origin);

/// A part of a photo that datasets show blurred, unless it was rejected.
struct RegionRecord {
    std::int64_t id = 0;
    std::int64_t photo = 0;
    survey::PrivateRegion region;
    RegionOrigin origin = RegionOrigin::Marked;

    bool operator==(const RegionRecord&) const = default;
};

/// A photo that is to belong to another station. Its new file carries the new position tag.
struct MovedPhoto {
    std::int64_t photo = 0;
    std::int64_t station = 0;
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero(); ///< Position of the lens in the room frame.
    std::string fileName;                                ///< Name of a complete file in the photo folder.
    std::string fileSha256;
    std::uint64_t sizeBytes = 0;
    bool choose = true; ///< Whether the photo replaces the one that the new station has chosen.
};

/// What a solution says of one photo. Frames: room. Units: metres; standard deviations in radians.
struct SolvedPhoto {
    std::int64_t photo = 0;
    Eigen::Quaterniond roomFromPhoto = Eigen::Quaterniond::Identity();
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero();
    std::optional<double> sigmaYawRad; ///< Standard deviation, like those below; nothing where it is unknown.
    std::optional<double> sigmaPitchRad;
    std::optional<double> sigmaRollRad;
    std::optional<double> sigmaPositionM;
    survey::Quality quality = survey::Quality::Good;
    std::string flags = "[]"; ///< JSON array of sentences that explain the quality.
};

/// An alignment that is to be recorded.
struct NewSolution {
    std::string source;        ///< "imported" or "align".
    std::string model;         ///< Name of the alignment model, "yaw" for example.
    std::string report = "{}"; ///< JSON object that tells how the solution was made.
    std::vector<SolvedPhoto> photos;
};

/// A recorded alignment. One solution of a survey is active; datasets are made with it.
struct SolutionRecord {
    std::int64_t id = 0;
    std::string source;
    std::string model;
    std::string report;
    Moment createdAt;
    bool isActive = false;
};

/// How much a survey holds.
struct Counts {
    int stations = 0;          ///< Stations of the plan, and others that have a photo.
    int stationsWithPhoto = 0; ///< Stations whose chosen photo was not rejected.
    int photos = 0;
    int rejectedPhotos = 0; ///< Chosen photos that a person rejected.
    int openShots = 0;      ///< Shots that are Intended, Started or Taken.
    int unclearShots = 0;
    int solutions = 0;
};

/// A photo whose file is not what was recorded.
struct PhotoFinding {
    enum class Kind { Missing, Unreadable, SizeDiffers, BytesDiffer };

    std::int64_t photo = 0;
    std::string fileName;
    Kind kind = Kind::Missing;
    std::string sentence;
};

/// What a check of the whole survey found. Findings are reported, not thrown.
struct SurveyCheck {
    int photosChecked = 0;
    std::vector<PhotoFinding> photos;
    std::vector<std::string> filesWithoutPhoto; ///< Names in the photo folder that no photo has.
    std::vector<std::string> database;          ///< Findings of SQLite and broken rules, as sentences.

    /// Files without a photo do no harm, and do not count.
    bool isSound() const { return photos.empty() && database.empty(); }
};

} // namespace spherewalk::store
