// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json_fwd.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/dataset/writer.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/ladder.h"
#include "spherewalk/render/scene_depth.h"
#include "spherewalk/scene/depth_sweep.h"
#include "spherewalk/scene/exposure.h"
#include "spherewalk/scene/room_fit.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::store {
class SurveyStore;
struct PhotoRecord;
} // namespace spherewalk::store

namespace spherewalk::jobs {

/// Name of the folder in a survey that keeps depths, unless the options name another one.
constexpr const char* kDepthCacheFolder = "depth-cache";

struct DepthOptions {
    scene::SweepOptions sweep;
    int agreeing = 4; ///< Number of neighbours whose depths a photo's depth is compared with.
    /// Folder that keeps depths for later runs. If it is empty, exportDataset(), knownScene() and
    /// checkExport() take kDepthCacheFolder in the survey's folder; surveyDepth() and depthForecast() need
    /// one.
    std::filesystem::path cacheFolder = {};
    /// The room as a person drew it; may be empty. Exports take the survey's.
    scene::DrawnRoom drawn = {};
    /// Estimates the depths of up to a dozen photos only, spread evenly. That is enough for the same radius
    /// and room. Exports set it unless the scene model is Depth.
    bool onlyForScene = false;
    /// Called with a photo's index before its file is read; may be empty.
    std::function<void(std::size_t)> beforeReading = {};
};

/// A photo whose depth is to be estimated.
struct DepthInput {
    std::filesystem::path file; ///< A JPEG file.
    std::string sha256;         ///< Hash of the file, or of all that it is made of.
    Rigid3 roomFromPhoto;
    LensPair lenses = {};
    /// What must not be copied from it into other photos. Depths are estimated from all of it.
    std::vector<survey::PrivateRegion> regions = {};
    /// With them photos are about equally bright, as far as that is known beforehand; see tellGains().
    std::optional<scene::Gains> gains = {};
};

/// Finds the gains by the exposures that the photos' files state. Errors: those of reading the files.
void tellGains(std::span<DepthInput> photos);

struct DepthReport {
    std::size_t photos = 0; ///< Photos that have a depth.
    std::size_t reused = 0; ///< Photos among them whose depth an earlier run kept.
    double seconds = 0;
};

/// Depths of photos, as files in the cache that render::DepthMap reads.
struct SurveyDepth {
    /// One path a photo. It is empty where no other photo stands farther away than
    /// SweepOptions::leastBaselineM, or where no depth was wanted.
    std::vector<std::filesystem::path> files;
    /// What each photo's darker values are multiplied by to be as bright as the others. It is empty if depths
    /// are wanted for radius and room alone.
    std::vector<scene::Gains> gains;
    double highlightRolloff = 0;           ///< How softly values end at white, see render::exposedValue().
    std::optional<double> radiusM;         ///< Radius of the sphere that stands best for the depths.
    std::optional<scene::FittedRoom> room; ///< The room that scene::fittedRoom() finds in the depths.
    DepthReport report;
};

/// Estimates the depth of each photo from its neighbours, and has neighbours agree on it. Cost: about one
/// second a photo on two cores, and 600 MB. Errors: those of reading and decoding the photos, of
/// scene::sweptDepth(), and of reading and writing the cache's files; InvalidInput for options. Stop:
/// Stopped; the cache keeps the depths so far.
SurveyDepth surveyDepth(std::span<const DepthInput> photos, const DepthOptions& options,
                        ProgressSink& progress, const std::stop_token& stop);

/// What surveyDepth() would take.
struct DepthForecast {
    std::size_t photos = 0; ///< Photos whose depth is wanted.
    /// Depths yet to be estimated: those of these photos, and of the neighbours that must agree with them.
    std::size_t missing = 0;
    std::uint64_t bytes = 0; ///< Size of the depths of all these photos, kept or not.
    /// Time on this machine for one depth that is missing; nothing if none was tried.
    std::optional<double> secondsAPhoto;

    double seconds() const { return secondsAPhoto.value_or(0) * static_cast<double>(missing); }
};

/// Forecasts surveyDepth(). With a trial it estimates one depth that is missing, times that, and keeps the
/// depth in the cache. Errors: those of surveyDepth(). Stop: that of surveyDepth().
DepthForecast depthForecast(std::span<const DepthInput> photos, const DepthOptions& options, bool withTrial,
                            const std::stop_token& stop);

struct ExportOptions {
    dataset::WriteOptions write;
    /// The richest scene model of the dataset; the cheaper ones come with it. Room takes a minute or two,
    /// Depth some seconds a photo.
    render::SceneKind scene = render::SceneKind::Sphere;
    DepthOptions depth;
    /// Puts floor and walls in place of what the camera carries along, see scene::carriedThings(). It holds
    /// for Room and Depth.
    bool clearsCarried = true;
    /// Leaves out the photos that isTestPhoto() names, and all that they show. Range: 0 for none, or 2 or
    /// more.
    int testEvery = 0;

    /// Errors: InvalidInput for testEvery.
    void validate() const;
};

/// Whether a photo is left out for tests: of each `testEvery` photos in the order of the export, the one in
/// the middle. The first ones stand in the room's corners.
constexpr bool isTestPhoto(std::size_t index, int testEvery) {
    return testEvery > 0 &&
           index % static_cast<std::size_t>(testEvery) == static_cast<std::size_t>(testEvery) / 2;
}

/// How many photos are left out for tests. Errors: InvalidInput if there should be some, and the photos are
/// too few.
std::size_t countTests(std::size_t photos, int testEvery);

/// The photos that are not left out for tests, in their order.
template <class Photo>
std::vector<Photo> withoutTests(const std::vector<Photo>& photos, int testEvery) {
    std::vector<Photo> kept;
    for (std::size_t i = 0; i < photos.size(); ++i) {
        if (!isTestPhoto(i, testEvery)) {
            kept.push_back(photos[i]);
        }
    }
    return kept;
}

struct ExportReport {
    dataset::WriteReport written;
    int withoutPhoto = 0;     ///< Stations without a photo, even a rejected one.
    int rejected = 0;         ///< Photos that a person rejected. The dataset leaves them out.
    int failed = 0;           ///< Photos that the alignment found no pose for. The dataset leaves them out.
    int tests = 0;            ///< Photos that are left out for tests.
    int withoutRotation = 0;  ///< Photos whose heading is not known.
    double sphereRadiusM = 0; ///< 0 if neither depths nor the outline tell it.
    std::optional<render::RoomShape> roomShape;
    DepthReport depth;
    double carriedShare = 0; ///< Share of each photo that other photos' floor and walls replace.
};

/// Exports the chosen photo of every station, unless a person rejected it or it failed, with the poses of the
/// active solution. A warning names the photos that failed. A photo that the solution lacks gets the tilt
/// that the photo itself states, and the heading 0; the dataset says so. Errors: those of reading such a
/// photo and of dataset::writeDataset(); for Room and Depth also those of surveyDepth(). Stop: Stopped.
ExportReport exportDataset(const store::SurveyStore& store, const std::filesystem::path& folder,
                           const ExportOptions& options, ProgressSink& progress, const std::stop_token& stop);

/// Exports one photo without a scene model. Errors: those of exportDataset(). Stop: Stopped.
dataset::WriteReport exportOne(const store::SurveyStore& store, const store::PhotoRecord& photo,
                               const std::filesystem::path& folder, const dataset::WriteOptions& options,
                               const std::stop_token& stop);

/// Forecasts the depths of an export; nothing if its scene model needs none. withTrial: as of
/// depthForecast(). Errors: those of depthForecast().
DepthForecast exportForecast(const store::SurveyStore& store, const ExportOptions& options, bool withTrial,
                             const std::stop_token& stop);

/// The richest scene model that an export makes without sweeping depths. It is Depth if there are photos with
/// neighbours and the cache has all their sweeps for these options, else Sphere. Errors: those of
/// depthForecast().
render::SceneKind knownScene(const store::SurveyStore& store, const DepthOptions& options);

/// The files among those of surveyDepth() that are kept already; empty for the other photos.
std::vector<std::filesystem::path> keptDepths(std::span<const DepthInput> photos,
                                              const DepthOptions& options);

/// What an export would make, and what a person should know before.
struct ExportCheck {
    std::size_t photos = 0;
    std::uint64_t totalBytes = 0;       ///< Estimate from the photos and from what one of them grew by.
    std::uint64_t freeBytes = 0;        ///< Free space where the dataset is to be written.
    double seconds = 0;                 ///< Estimate from one photo, with all threads, and one depth.
    std::size_t privateRegions = 0;     ///< Regions of photos that are blurred.
    std::size_t blurredPhotos = 0;      ///< Photos that have such regions.
    std::vector<std::string> obstacles; ///< Sentences that say why the export cannot be done.
    std::vector<std::string> doubts;    ///< Sentences that say what the dataset would lack.

    bool isPossible() const { return obstacles.empty(); }
};

/// Looks before an export. Exports one photo to a temporary folder, and estimates one depth if depths are
/// wanted, to know what the photos of this survey cost on this machine. Errors: those of exportDataset().
/// A folder that exists, or that has too little space, is an obstacle and no error.
ExportCheck checkExport(const store::SurveyStore& store, const std::filesystem::path& folder,
                        const ExportOptions& options, ProgressSink& progress, const std::stop_token& stop);

/// Sentences that say where depths contradict the outline that somebody drew. found: the room by the depths.
std::vector<std::string> roomDoubts(const scene::FittedRoom& found, const survey::Room& drawn);

/// The depths that earlier exports kept of photos as they are now, by photo: files that render::DepthMap
/// reads. Cost: little, as nothing is estimated. Errors: those of exportForecast(). Stop: Stopped.
std::map<std::int64_t, std::filesystem::path>
keptDepths(const store::SurveyStore& store, const DepthOptions& options, const std::stop_token& stop);

Json toJson(const ExportReport& report);
Json toJson(const ExportCheck& check);

} // namespace spherewalk::jobs
