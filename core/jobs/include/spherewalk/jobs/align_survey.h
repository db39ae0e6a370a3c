// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/foreign_check.h"
#include "spherewalk/align/free_places.h"
#include "spherewalk/align/match_pairs.h"
#include "spherewalk/align/position_check.h"
#include "spherewalk/align/room_tags.h"
#include "spherewalk/align/solve.h"
#include "spherewalk/align/tag_check.h"
#include "spherewalk/base/json_fwd.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/survey/shot.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::store {
struct NewSolution;
struct PhotoRecord;
struct StationRecord;
class SurveyStore;
} // namespace spherewalk::store

namespace spherewalk::jobs {

/// A distance that somebody measured between the lenses at two photos, which their file names stand for.
struct MeasuredDistance {
    std::string a;
    std::string b;
    double metres = 0;
};

struct AlignOptions {
    /// Empty: fine where the pictures place photos (isFree, hasRoughTags()), which takes more; else normal.
    std::optional<align::Effort> effort;
    align::Model model = align::Model::Auto;
    /// A grey picture of any size, twice as wide as high. Photos are not looked at where it is black. Empty
    /// means that photos are looked at everywhere.
    std::filesystem::path mask;
    /// Standard deviation of the photos' places about their position tags, along x and along y. Range: above
    /// 0.
    double positionSigmaM = 0.005;
    /// Whether to look for wrong position tags. The solution then uses the positions that fit.
    bool checksPositions = true;
    /// Whether the places of all photos are solved from the pictures alone. What the survey says of them is
    /// not used. If the solution becomes the active one, the photos' stations move to the solved places.
    bool isFree = false;
    /// Usual height of the lens above the floor, which gives a free solution its scale, and which a survey
    /// without rails keeps. 0: that of the plan, or that which imported photos were said to have.
    double lensHeightM = 0;
    std::optional<MeasuredDistance> distance; ///< Gives a free solution its scale in place of the floor.
    /// Printed side of the AprilTags that hang in the room, in metres; 0: photos are not searched for any.
    double tagSizeM = 0;
    /// Where tags hang in another survey's frame, which a free solution then takes over: see aprilTagsOf().
    std::vector<align::RoomTag> knownTags;
    /// Folder that keeps features and matches for later runs. Empty means `align-cache` in the survey.
    std::filesystem::path cacheFolder;
    bool isRecorded = true;  ///< Whether the store gets the solution.
    bool isActivated = true; ///< Whether the recorded solution becomes the active one.
    int threads = 0;         ///< Range: 0 or above; 0 means all that the machine has.

    /// Whether the pictures know better than the tags how photos stand to each other: these err by a
    /// centimetre or more.
    bool hasRoughTags() const {
        constexpr double kRoughM = 0.01;
        return !isFree && positionSigmaM >= kRoughM;
    }

    align::Effort chosenEffort() const {
        return effort.value_or(isFree ? align::Effort::Fine : align::Effort::Normal);
    }
};

/// What a person can do about a photo that is doubtful or failed.
enum class Cure {
    None,
    Retag,  ///< Move the photo to another station, which AlignedPhoto::fits names.
    Retake, ///< Take another photo at the same station.
    Mask,   ///< Mask what misleads: mirrors, screens, moving things.
};

/// The word for the cure in reports: "none", "retag", "retake" or "mask".
std::string_view name(Cure cure);

/// Errors: InvalidInput, whose sentence lists the names.
Cure cureNamed(std::string_view name);

/// The result for one photo.
struct AlignedPhoto {
    std::int64_t photo = 0; ///< Number of the photo in the store.
    std::string file;
    std::string station;
    survey::Quality quality = survey::Quality::Good;
    align::SolvedPose pose;
    std::vector<std::string> flags; ///< Sentences that say why the photo is not good.
    std::string fits;               ///< Station that the position tag should name; empty if the tag is right.
    Cure cure = Cure::None;
    /// Standard deviation that the place of a photo with a wrong tag is solved with, about where its
    /// neighbours see it; 0 if the tag holds.
    double freeSigmaM = 0;

    /// Whether its pose is recorded, so that others get it.
    bool isHandedOn() const { return pose.isSolved && quality != survey::Quality::Failed; }
};

struct AlignReport {
    std::int64_t solution = 0; ///< Number of the solution in the store; 0 if it was not recorded.
    align::Effort effort = align::Effort::Normal;
    double positionSigmaM = 0;  ///< What the tags were said to err by; 0 if they were not used.
    align::Alignment alignment; ///< Its photos have the order of `photos`.
    std::vector<AlignedPhoto> photos;
    std::optional<align::FreePlaces> places; ///< What a free solution found.
    double scaleSigma = 0;                   ///< Of all lengths, as a share of them.
    align::TagFrame tagFrame;                ///< Empty unless positions were checked, as the next two.
    std::optional<align::Scale> scale;       ///< Length of the solved positions over their true length.
    std::vector<std::string> tagWarnings;    ///< Sentences on all tags at once; the alignment's warnings too.
    align::RoomTags aprilTags;               ///< The printed tags that photos see, in the room.
    std::size_t features = 0;                ///< Sum over all photos.
    int fromCache = 0;                       ///< Number of photos whose features an earlier run has found.
    std::size_t pairs = 0;                   ///< Number of pairs that were compared.
    std::size_t holdingPairs = 0;            ///< Number of pairs that constrain the solution.
    /// Number of comparisons with more effort than was asked for, because parts were not joined.
    std::size_t pairsTriedAgain = 0;
    /// Number of placed photos that were not searched for persons: their pose, or that of all photos near
    /// them, is not known well enough.
    std::size_t notSearched = 0;
    double featureSeconds = 0;
    double matchSeconds = 0; ///< Time for matching, and for the estimate of each pair.
    double solveSeconds = 0; ///< Time for the solver, and for the checks.
    double seconds = 0;
};

/// Solves the rotations of all chosen photos, and records them. The cache folder keeps features and matches:
/// a run after a stop, or with another model, does not find them again.
///
/// Errors: InvalidInput for a survey without photos, or with photos of unknown places unless the solution is
/// free; NotFound for a measured distance to a photo that the survey lacks; those of reading the mask. Photos
/// that cannot be read fail by themselves, with a flag that names the file. Stop: Stopped, with the survey
/// unchanged; the cache keeps what was found.
AlignReport alignSurvey(store::SurveyStore& store, const AlignOptions& options, ProgressSink& progress,
                        const std::stop_token& stop);

/// Where the photos of a survey seem to have been taken, before anything is checked.
struct PlacesSoFar {
    std::vector<std::int64_t> photos; ///< Numbers in the store.
    align::FreePlaces places;         ///< Its photos have the same order.
};

/// Solves where all chosen photos were taken from the pictures alone, and records nothing: a look at a survey
/// that still grows. options: those of a free solution. Errors, Stop: as alignSurvey().
PlacesSoFar placesSoFar(const store::SurveyStore& store, const AlignOptions& options, ProgressSink& progress,
                        const std::stop_token& stop);

/// Notes what helps the photo, unless something that should be tried first is noted already.
void propose(Cure cure, AlignedPhoto& photo);

/// Flags the photos of the report that show a person or another thing where other photos look through, and
/// counts those that nothing could be compared with. Only photos whose pose is well known take part, and
/// those that can be read. folder: of the photos. Stop: Error{Stopped}.
void tellForeignThings(const std::filesystem::path& folder, const align::ForeignCheckOptions& options,
                       AlignReport& report, ProgressSink& progress, const std::stop_token& stop);

/// What is known of a photo before its picture is looked at: its tag, which is right along x and y to
/// positionSigmaM, and how its metadata say that it leans. A photo that cannot be read is warned of alone:
/// what looks for features in it names it.
align::PhotoPrior priorOf(const store::SurveyStore& store, const store::PhotoRecord& photo,
                          const store::StationRecord& station, double positionSigmaM, ProgressSink& progress);

/// Names the imported photos for which another stands: perhaps two were given one place by mistake.
void tellLeftOut(const store::SurveyStore& store, ProgressSink& progress);

/// A photo that the alignment moved farther from its tag than tags err in this survey.
struct PhotoMove {
    std::size_t photo = 0; ///< Its index.
    double byM = 0;        ///< How far along the floor, besides what most photos of its part have in common.
};

/// The moved photos, in order. Shape: tagged has one entry a photo.
std::vector<PhotoMove> movedPhotos(std::span<const align::PhotoPrior> tagged,
                                   const align::Alignment& alignment);

/// A mask from a picture: white where photos are looked at; empty for an empty name. Errors: those of
/// reading; InvalidInput for a picture that is not twice as wide as high.
MaskImage readMask(const std::filesystem::path& file);

/// Records the solution, and moves the stations of a free one: see moveStations(). A solution without any
/// photo is not recorded, with a warning.
void recordSolution(store::SurveyStore& store, const AlignOptions& options, AlignReport& report,
                    ProgressSink& progress);

/// Errors: InvalidInput, naming a photo, if nobody knows where photos were taken.
void refuseUnknownPlaces(const store::SurveyStore& store);

/// The photos that have a pose, as the store keeps them.
store::NewSolution recordOf(const AlignReport& report);

/// The options of a free solution for the survey's camera. Errors: NotFound for a photo of the distance.
align::FreeOptions freeOptions(const store::SurveyStore& store, const AlignOptions& options,
                               std::span<const AlignedPhoto> photos);

/// Makes the found places those that photos are aligned with. Pairs with a photo that has none hold nothing.
void usePlaces(const align::FreePlaces& places, std::span<align::PhotoPrior> priors,
               std::span<align::PairEstimate> estimates);

/// What is left open of the frame of photos that stand to each other as the pictures say: standard
/// deviations.
struct FrameSigma {
    double placeM = 0; ///< Of their middle, along either axis.
    Radians heading;
    double scale = 0; ///< Of all lengths, as a share of them.

    /// Sentences on what gave the places, and how well they know the scale.
    std::string text() const;
};

/// Makes places that the pictures gave those that photos are aligned with, as one placement. A turn, a shift
/// and, unless the pictures know it better, a scale bring them to the tags. Four and more photos whose place
/// is doubtful are a placement of their own, since they hang together, but not with the others. Photos
/// without a place, or with one that is more than four standard deviations from the tag, keep the tag. Empty,
/// with nothing changed, if fewer than six photos, or two thirds of all, fit. priors: one a photo, with the
/// tags.
std::optional<FrameSigma> usePlacesByTags(const align::FreePlaces& places,
                                          std::span<align::PhotoPrior> priors);

/// How well the tags' places know all lengths: a standard deviation, as a share of them; 0 for one place.
/// Tags that the solution does not believe tell less. Shape: one photo a tag.
double scaleSigmaOf(std::span<const align::PhotoPrior> tagged, const align::Alignment& solved);

/// A turn about the vertical and then a shift along the floor.
struct FloorMotion {
    Eigen::Rotation2Dd turn{0};
    Eigen::Vector2d shift = Eigen::Vector2d::Zero();

    Eigen::Vector2d operator*(const Eigen::Vector2d& p) const { return turn * p + shift; }
};

/// What brings the first places to the second ones. Of five and more, the half may be wrong. Nothing if they
/// all lie together, or there are none. Shape: as many of both.
std::optional<FloorMotion> commonMotion(std::span<const Eigen::Vector2d> from,
                                        std::span<const Eigen::Vector2d> to);

/// Brings found places into the frame of those that the survey knows already, so that what was drawn or
/// measured in it stays true. A frame that known tags gave stays. photos: one a place.
void keepFrame(const store::SurveyStore& store, std::span<const store::PhotoRecord> photos,
               align::FreePlaces& places);

/// Lets no turn be stated better than the pictures alone know it: the solver takes errors of places for
/// independent, but a room bends against another as a whole. Shape: places has one entry a photo.
void widenTurns(const align::FreePlaces& places, AlignReport& report);

/// A sentence on what gave the scale, and how well.
std::string scaleText(const align::FreePlaces& places);

/// Writes the found places into the report's alignment, with what makes them doubtful. priors: one a photo.
void takePlaces(const align::FreePlaces& places, std::span<const align::PhotoPrior> priors,
                AlignReport& report);

/// Makes what photos by hand show the survey's room: the outline of the walls, and a ceiling that is higher
/// than its own. Does nothing if they make no room. Errors: those of SurveyStore::replaceRoom().
void takeRoom(store::SurveyStore& store, const Polygon& outline, double ceilingM);

/// Lets a survey without rails keep the height of the lens, if somebody said it and it is below the ceiling.
/// Errors: those of the store.
void keepLensHeight(store::SurveyStore& store, const align::FreePlaces& places);

/// Gives each photo that has a place a station there: its own moves, unless it belongs to the plan or to
/// other photos, too. A survey without rails takes over the outline, and a ceiling that is higher than its
/// own, if they make a room. Errors: those of the store.
void moveStations(store::SurveyStore& store, AlignReport& report);

/// Takes the stretch of the tags from where the photos were found to be, if they were solved for and that is
/// better known. Shape: tagged has one entry a photo.
void refineStretch(std::span<const align::PhotoPrior> tagged, AlignReport& report);

/// Places the AprilTags by the solved photos, and says what is wrong with them or with the photos' places.
void placeAprilTags(std::span<const align::TagSighting> sightings, double sizeM, AlignReport& report);

/// The tags as JSON, in reports and in datasets: resources/docs/formats.md describes them.
Json aprilTagsJson(const align::RoomTags& tags);

/// The AprilTags of the survey's active solution, in its room frame. Empty if it saw none. Errors: Corrupt
/// for a report that cannot be read.
std::vector<align::RoomTag> aprilTagsOf(const store::SurveyStore& store);

/// Says what is wrong with all tags at once. Mirrored tags make all photos fail; a wrong scale widens the
/// standard deviations of all places.
void tellTagFrame(AlignReport& report);

/// Takes the positions that fit for those that do not. A photo without any is freed to stand where its
/// neighbours see it. Shape: priors has one entry a photo.
void correctPositions(std::span<const align::PairEstimate> estimates,
                      std::span<const align::PlannedPosition> planned, double positionSigmaM,
                      std::span<align::PhotoPrior> priors, AlignReport& report);

/// Frees the photos that were moved far from their tags, so that a wrong tag does not pull at the place, and
/// tells whether there are new ones. Shape: tagged and priors have one entry a photo.
bool freeMoved(std::span<const align::PhotoPrior> tagged, double positionSigmaM,
               std::span<align::PhotoPrior> priors, AlignReport& report);

/// Names both photos of each pair that was taken at one place.
void tellOnePlace(std::span<const align::OnePlace> found, AlignReport& report);

/// Fills in the pose, the status and the flags of all photos from the report's alignment. A photo is judged
/// by its own turn against the others. What all photos share is said once, by the alignment's warnings. A
/// photo fails if its tag is wrong and its neighbours do not tell its place. Shape: tagged has one entry a
/// photo.
void giveVerdicts(std::span<const align::PhotoPrior> tagged, AlignReport& report);

/// Makes photos fail whose files cannot be read.
void tellDamaged(std::span<const int> photos, AlignReport& report);

/// The report as resources/docs/formats.md describes it.
Json toJson(const AlignReport& report);

/// The report for people: what was solved, what is doubtful, and what to do about it.
std::string alignText(const AlignReport& report);

} // namespace spherewalk::jobs
