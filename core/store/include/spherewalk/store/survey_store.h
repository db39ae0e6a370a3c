// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"
#include "spherewalk/store/records.h"
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

/// What a survey is opened for.
enum class Access { Read, Write };

/// Options that few callers change.
struct StoreOptions {
    std::chrono::milliseconds patience{5000}; ///< How long to wait for another program's transaction.
    std::uint64_t maxDatabaseBytes = 0;       ///< A larger database is refused as Full; 0 sets no limit.
    /// Whether the folder lies on a network share, where the journal must not need the memory of one machine.
    /// Nothing means that the file system is asked.
    std::optional<bool> isOnShare = {};
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
    /// Creates the folder, complete or not at all, and opens it for writing. Errors: Exists if something has
    /// that name; NotFound if the parent folder is missing; InvalidInput for an invalid room or options.
    static SurveyStore create(const std::filesystem::path& folder, const std::string& name,
                              const survey::Room& room, const survey::PlanOptions& options,
                              const survey::Plan& plan, const StoreOptions& storeOptions = {});

    /// Opens a survey. An older format is first brought up to date, and a copy of its database is kept.
    /// Errors: NotFound; InvalidInput for a folder that is no survey; Corrupt; Unsupported for the format of
    /// a newer version, or for an older one that cannot be brought up to date; Busy if another program has
    /// the survey open for writing.
    static SurveyStore open(const std::filesystem::path& folder, Access access,
                            const StoreOptions& storeOptions = {});

    ~SurveyStore();
    SurveyStore(SurveyStore&&) noexcept;
    SurveyStore& operator=(SurveyStore&&) noexcept;

    const std::filesystem::path& folder() const;
    std::filesystem::path photoFolder() const;
    /// The folder for incomplete files, in the file system of the photos.
    std::filesystem::path downloadFolder() const;

    /// A number that changes when another connection has changed the survey. Views use it to keep up with a
    /// program that writes. Cost: some microseconds.
    std::int64_t dataVersion() const;

    SurveyInfo info() const;
    Counts counts() const;

    survey::Room room() const;
    /// The same, but empty where room() is survey::unknownRoom(), since nobody drew one and no photos show
    /// it.
    survey::Room knownRoom() const;
    survey::PlanOptions planOptions() const;
    /// The plan. Stations that were added since stand at its end.
    survey::Plan plan() const;
    /// Replaces room, options and plan. Errors: InvalidInput if the survey has a photo or a shot, since these
    /// belong to stations of the present plan.
    void replacePlan(const survey::Room& room, const survey::PlanOptions& options, const survey::Plan& plan);
    /// Keeps how high the lens usually is in a survey by hand, as somebody said it. Errors: InvalidInput for
    /// a plan with rails, whose cart has its own heights; those of PlanOptions::validate().
    void setLensHeight(double heightM);
    /// Replaces the room of a survey by hand. Errors: InvalidInput for a plan with rails, which belong to the
    /// present room; those of Room::validate().
    void replaceRoom(const survey::Room& room, RoomOrigin origin);
    /// Who has given the present room of a survey by hand.
    RoomOrigin roomOrigin() const;

    /// How the camera is set for the photos. A new survey has the automatic profile. Nothing means that the
    /// camera's settings stay as they are, as in surveys that are older than profiles.
    std::optional<survey::CaptureProfile> captureProfile() const;
    /// Errors: InvalidInput for an invalid profile.
    void setCaptureProfile(const std::optional<survey::CaptureProfile>& profile);

    /// All stations in walking order. Other lists of stations or photos have the same order.
    std::vector<StationRecord> stations() const;
    /// Errors: NotFound.
    StationRecord station(std::int64_t id) const;
    /// The stations where a photo is still to be taken: they have none, or their chosen photo was rejected. A
    /// station outside the plan whose photos were all moved to others is not one.
    std::vector<StationRecord> stationsWithoutPhoto() const;
    /// Adds a station where photos were taken outside the plan. An empty name becomes
    /// "unplanned position (x, y)".
    std::int64_t addStation(const Eigen::Vector3d& positionM, const std::string& name = {},
                            bool isPlaceKnown = true);
    /// Moves stations that were added, all or none. Their photos stay where they are: movePhotos(). Errors:
    /// NotFound; InvalidInput for a station of the plan, or values that cannot be.
    void placeStations(const std::vector<PlacedStation>& places);
    /// Removes a station that was added and is not used. Errors: NotFound; InvalidInput for a station of the
    /// plan, or with a photo or a shot.
    void removeStation(std::int64_t id);

    std::vector<PhotoRecord> photos() const;
    std::vector<PhotoRecord> photosAt(std::int64_t station) const;
    /// One photo per station that has any.
    std::vector<PhotoRecord> chosenPhotos() const;
    /// The chosen photos that were not rejected. A dataset is made of these.
    std::vector<PhotoRecord> keptPhotos() const;
    std::optional<PhotoRecord> chosenPhoto(std::int64_t station) const;
    /// The kept photo of the shot's station if it is newer than the shot: a later shot brought it, or a
    /// person imported it after the shot.
    std::optional<PhotoRecord> photoAfter(const survey::Shot& shot) const;
    /// The photo whose bytes came from the camera with this SHA-256.
    std::optional<PhotoRecord> findPhoto(const std::string& cameraSha256) const;
    /// Errors: NotFound.
    PhotoRecord photo(std::int64_t id) const;
    /// Errors: Exists for a photo or file name that the survey has already; NotFound for an unknown station
    /// or a file that is not in the photo folder; InvalidInput for values that cannot be.
    std::int64_t addPhoto(const NewPhoto& photo);
    void choosePhoto(std::int64_t photoId);
    /// All or none. A station that loses its chosen photo chooses its newest. A photo whose position changes
    /// leaves the active solution, unless that has found the new place already. Returns the photos that left
    /// it. Errors: NotFound; those of addPhoto() for names and files.
    std::vector<std::int64_t> movePhotos(const std::vector<MovedPhoto>& photos);
    /// A name in the photo folder that no photo has. It is the camera's name if that is free; otherwise the
    /// first digits of the hash are added. A file with that name and exactly these bytes may exist, because
    /// a program was killed before it recorded the photo; the caller overwrites that file.
    std::string freePhotoName(const std::string& cameraFileName, const std::string& fileSha256) const;

    /// Records that a photo is about to be taken. Errors: NotFound for an unknown station.
    survey::Shot beginShot(std::int64_t station, const std::string& cameraSerial,
                           const survey::Baseline& baseline);
    /// Errors of all marks: NotFound; InvalidInput if the shot's step does not allow it. Intended may become
    /// Started, Taken, NotTaken or Unclear; Started may become Taken, NotTaken or Unclear; Taken may become
    /// Downloaded or Unclear; Unclear may become Taken or NotTaken when a person has decided.
    void markStarted(std::int64_t shotId, const std::string& commandId);
    void markTaken(std::int64_t shotId, const std::string& fileUrl);
    void markNotTaken(std::int64_t shotId);
    /// fileUrl: the picture on the camera that may be the shot's; "" if there is none.
    void markUnclear(std::int64_t shotId, const std::string& why, const std::string& fileUrl = {});
    /// Marks a shot NotTaken that is open or Unclear, because a person does not wait for its photo.
    void giveUp(std::int64_t shotId);
    /// Adds the photo and marks the shot Downloaded, both or neither. The station does not choose the photo
    /// if it has a newer one, see photoAfter(). Errors: those of addPhoto; InvalidInput if the photo is of
    /// another station than the shot.
    std::int64_t recordDownload(std::int64_t shotId, const NewPhoto& photo);
    /// Marks the shot Downloaded with a photo that the survey has already. Errors: NotFound; InvalidInput if
    /// the photo is of another station, or of another shot.
    void recordDownload(std::int64_t shotId, std::int64_t photoId);
    /// The shot that brought the photo; nothing for an imported photo.
    std::optional<survey::Shot> shotOf(std::int64_t photo) const;
    /// The shots that are Intended, Started or Taken, oldest first.
    std::vector<survey::Shot> openShots() const;
    std::vector<survey::Shot> unclearShots() const;
    /// Errors: NotFound.
    survey::Shot shot(std::int64_t id) const;

    /// Records a verdict in place of an earlier one. Errors: NotFound; InvalidInput if the findings are no
    /// JSON array.
    void setVerdict(const PhotoVerdict& verdict);
    /// The verdicts on all photos that were judged, ordered by photo.
    std::vector<PhotoVerdict> verdicts() const;
    /// The verdict on one photo; nothing if it was not judged. Errors: NotFound for an unknown photo.
    std::optional<PhotoVerdict> verdict(std::int64_t photo) const;

    /// Records a review in place of an earlier one. Errors: NotFound; InvalidInput for a note that is not one
    /// line.
    void setReview(const Review& review);
    /// The reviews of all photos that have a decision or a note, ordered by photo.
    std::vector<Review> reviews() const;
    /// Errors: NotFound.
    Review review(std::int64_t photo) const;

    /// All regions, those that were rejected among them, by photo and in the order of their identities.
    std::vector<RegionRecord> regions() const;
    /// Those of one photo. Errors: NotFound for an unknown photo.
    std::vector<RegionRecord> regions(std::int64_t photo) const;
    /// Records what a person has marked, and returns its identity. Errors: NotFound; those of
    /// PrivateRegion::validate().
    std::int64_t markRegion(std::int64_t photo, const survey::PrivateRegion& region);
    /// Removes a region. One that a search has found stays as rejected. Errors: NotFound, also for one that
    /// is rejected.
    void removeRegion(std::int64_t region);
    /// Makes a region again what it was before it was marked or removed: as recorded, with its identity.
    /// Errors: NotFound for an unknown photo; those of PrivateRegion::validate().
    void restoreRegion(const RegionRecord& region);
    /// Records what a search of a photo has found, in place of what earlier ones did. What is marked or
    /// rejected already is not added once more. method: the number of the way in which it was searched.
    /// Returns how many were added. Errors: NotFound; those of PrivateRegion::validate().
    std::size_t setFoundRegions(std::int64_t photo, const std::vector<survey::PrivateRegion>& found,
                                int method);
    /// The photos that were searched in this way.
    std::vector<std::int64_t> searchedPhotos(int method) const;

    /// Records a solution and returns its identity. isActive: the solution becomes the active one; the first
    /// solution is active in any case. Errors: NotFound for an unknown photo; InvalidInput for numbers that
    /// are not finite, an invalid rotation, or a photo that is solved twice.
    std::int64_t addSolution(const NewSolution& solution, bool isActive);
    /// All solutions, newest first.
    std::vector<SolutionRecord> solutions() const;
    std::optional<SolutionRecord> activeSolution() const;
    /// Errors: NotFound.
    std::vector<SolvedPhoto> solvedPhotos(std::int64_t solution) const;

    /// Reads every photo and the whole database, and reports each difference from the records.
    /// Errors: Stopped; Io.
    SurveyCheck check(ProgressSink& progress, const std::stop_token& stop) const;

  private:
    struct Parts;
    explicit SurveyStore(std::unique_ptr<Parts> parts);

    std::unique_ptr<Parts> m_parts;
};

} // namespace spherewalk::store
