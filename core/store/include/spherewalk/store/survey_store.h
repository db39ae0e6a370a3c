// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"
#include "spherewalk/store/records.h"
#include "spherewalk/store/survey_check.h"
#include "spherewalk/survey/capture_profile.h"
#include "spherewalk/survey/plan.h"
#include "spherewalk/survey/room.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::store {

enum class Access { Read, Write };

/// What few callers need to say.
struct StoreOptions {
    std::chrono::milliseconds patience{5000}; ///< how long to wait for another program's transaction
    std::uint64_t maxDatabaseBytes = 0;       ///< growing beyond is refused as Full; 0: the disk decides
};

/// A survey on disk: the folder `<name>.spherewalk` with `survey.sqlite` and `photos/`. One program writes at
/// a time, others may read meanwhile. Each function that changes the survey does so in one transaction and
/// returns when it is on disk; if it throws, nothing has changed.
///
/// Threads: one at a time; a second thread opens its own for reading. Errors of all functions, besides those
/// named: Full, Io, Busy (another program holds the database longer than the patience), Corrupt (the database
/// is damaged, or says what no survey can), and InvalidInput for a change to a survey opened for reading.
class SurveyStore {
  public:
    /// Makes the folder, complete or not at all, and opens it for writing. Errors: Exists if there is
    /// anything by that name; NotFound if its parent is not there; InvalidInput for a room or options that
    /// cannot be.
    static SurveyStore create(const std::filesystem::path& folder, const std::string& name,
                              const survey::Room& room, const survey::PlanOptions& options,
                              const survey::Plan& plan, const StoreOptions& storeOptions = {});

    /// For writing, brings an older survey up to date and keeps a copy of its database. Errors: NotFound;
    /// InvalidInput for something that is no survey; Corrupt; Unsupported for a newer version's survey, or
    /// for reading one that is to be brought up to date first; Busy if another program has it open for
    /// writing.
    static SurveyStore open(const std::filesystem::path& folder, Access access,
                            const StoreOptions& storeOptions = {});

    ~SurveyStore();
    SurveyStore(SurveyStore&&) noexcept;
    SurveyStore& operator=(SurveyStore&&) noexcept;

    const std::filesystem::path& folder() const;
    std::filesystem::path photoFolder() const;
    /// For what is not complete yet; in the photos' file system.
    std::filesystem::path downloadFolder() const;

    /// Another number once another connection has changed the survey: for views that keep up with a program
    /// that writes. Cost: some microseconds.
    std::int64_t dataVersion() const;

    SurveyInfo info() const;
    Counts counts() const;

    survey::Room room() const;
    survey::PlanOptions planOptions() const;
    /// With the stations that were added since, at the end.
    survey::Plan plan() const;
    /// Errors: InvalidInput once there is a photo or a shot, which belong to stations of the present plan.
    void replacePlan(const survey::Room& room, const survey::PlanOptions& options, const survey::Plan& plan);

    /// How the camera is to be set for the photos: automatic in a new survey; nothing where it stays as it
    /// is, as in surveys from before there were profiles.
    std::optional<survey::CaptureProfile> captureProfile() const;
    /// Errors: InvalidInput for a profile that cannot be.
    void setCaptureProfile(const std::optional<survey::CaptureProfile>& profile);

    /// In walking order, as everywhere below.
    std::vector<StationRecord> stations() const;
    /// Errors: NotFound.
    StationRecord station(std::int64_t id) const;
    /// That have no photo, or whose chosen photo was rejected: where photos are still to be taken.
    std::vector<StationRecord> stationsWithoutPhoto() const;
    /// Adds a station where photos were taken outside the plan. An empty name becomes
    /// "unplanned position (x, y)".
    std::int64_t addStation(const Eigen::Vector3d& positionM, const std::string& name = {});

    std::vector<PhotoRecord> photos() const;
    std::vector<PhotoRecord> photosAt(std::int64_t station) const;
    /// One photo per station that has any.
    std::vector<PhotoRecord> chosenPhotos() const;
    /// The chosen photos but for those that were rejected: what becomes part of a dataset.
    std::vector<PhotoRecord> keptPhotos() const;
    std::optional<PhotoRecord> chosenPhoto(std::int64_t station) const;
    /// The photo whose bytes came from the camera with this SHA-256.
    std::optional<PhotoRecord> findPhoto(const std::string& cameraSha256) const;
    /// Errors: NotFound.
    PhotoRecord photo(std::int64_t id) const;
    /// Errors: Exists for a photo or file name that the survey has already; NotFound for an unknown station
    /// or a file that is not in the photo folder; InvalidInput for values that cannot be.
    std::int64_t addPhoto(const NewPhoto& photo);
    void choosePhoto(std::int64_t photoId);
    /// All or none. A station that loses its chosen photo chooses its newest. Errors: NotFound; those of
    /// addPhoto() for names and files.
    void movePhotos(const std::vector<MovedPhoto>& photos);
    /// A name in the photo folder that no photo has: the camera's own if free, else with the first digits of
    /// the hash. A file by that name that has exactly these bytes may be there (left when the program was
    /// killed before its row was recorded), and is to be overwritten.
    std::string freePhotoName(const std::string& cameraFileName, const std::string& fileSha256) const;

    /// Records that a photo is about to be taken. Errors: NotFound for an unknown station.
    ShotRecord beginShot(std::int64_t station, const std::string& cameraSerial,
                         const std::string& latestFileUrl, std::int64_t totalEntries);
    /// Errors of all marks: NotFound; InvalidInput if the shot's step does not allow it. Intended may become
    /// Started, Taken, NotTaken or Unclear; Started may become Taken, NotTaken or Unclear; Taken may become
    /// Downloaded or Unclear; Unclear may become Taken or NotTaken when a person has decided.
    void markStarted(std::int64_t shotId, const std::string& commandId);
    void markTaken(std::int64_t shotId, const std::string& fileUrl);
    void markNotTaken(std::int64_t shotId);
    void markUnclear(std::int64_t shotId, const std::string& why);
    /// Adds the photo and marks the shot Downloaded, both or neither. Errors: those of addPhoto; InvalidInput
    /// if the photo is of another station than the shot.
    std::int64_t recordDownload(std::int64_t shotId, const NewPhoto& photo);
    /// Intended, Started and Taken, oldest first.
    std::vector<ShotRecord> openShots() const;
    std::vector<ShotRecord> unclearShots() const;
    /// Errors: NotFound.
    ShotRecord shot(std::int64_t id) const;

    /// In place of an earlier one. Errors: NotFound; InvalidInput for findings that are no JSON array.
    void setVerdict(const PhotoVerdict& verdict);
    /// Of photos that were judged, by photo.
    std::vector<PhotoVerdict> verdicts() const;
    /// Nothing if it was not judged. Errors: NotFound for an unknown photo.
    std::optional<PhotoVerdict> verdict(std::int64_t photo) const;

    /// In place of what was decided before. Errors: NotFound; InvalidInput for a note that is not one line.
    void setReview(const Review& review);
    /// Of photos on which there is a decision or a note, by photo.
    std::vector<Review> reviews() const;
    /// Errors: NotFound.
    Review review(std::int64_t photo) const;

    /// isActive: in place of the one that is; the first solution is active in any case. Errors: NotFound for
    /// an unknown photo; InvalidInput for numbers that are not finite, a rotation that is none, or a photo
    /// solved twice.
    std::int64_t addSolution(const NewSolution& solution, bool isActive);
    void activateSolution(std::int64_t solution);
    /// Newest first.
    std::vector<SolutionRecord> solutions() const;
    std::optional<SolutionRecord> activeSolution() const;
    /// Errors: NotFound.
    std::vector<SolvedPhoto> solvedPhotos(std::int64_t solution) const;

    /// Reads every photo and the whole database, and reports what is not as recorded; see SurveyCheck.
    SurveyCheck check(ProgressSink& progress, const std::stop_token& stop) const;

  private:
    struct Parts;
    explicit SurveyStore(std::unique_ptr<Parts> parts);

    std::unique_ptr<Parts> m_parts;
};

} // namespace spherewalk::store
