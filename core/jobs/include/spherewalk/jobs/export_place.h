// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json_fwd.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/place/fusion.h"
#include "spherewalk/place/occupancy.h"
#include "spherewalk/place/surface.h"
#include "spherewalk/render/dataset.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::jobs {

/// What a scanned place is written as.
enum class PlaceFormat {
    Ply,       ///< surface.ply: all vertices of the fused surface, with normals, colours and evidence.
    Gltf,      ///< surface.glb: the same in one file that viewers and game engines open.
    Obj,       ///< surface.obj: the same as text.
    Occupancy, ///< map.pgm and map.yaml: where a robot can drive, as map_server and Nav2 read it.
};

/// The words "ply", "gltf", "obj" and "occupancy". Another word is no format of a place.
std::string_view name(PlaceFormat format);
std::optional<PlaceFormat> placeFormat(std::string_view name);

struct PlaceOptions {
    std::set<PlaceFormat> formats = {PlaceFormat::Ply};
    place::FusionOptions fusion;
    int leastPhotos = 1; ///< Surfaces that fewer photos show are left out.
    /// Error by which triangles may be joined, in metres; 0 keeps all. What is near walls, floor and ceiling
    /// of the dataset's room is moved onto them before. Colours become coarser with the triangles.
    double simplifyM = 0;
    /// Of the map. Its floor is that of the dataset's room, or else the room's zero.
    place::OccupancyOptions occupancy = {};

    /// Errors: InvalidInput for no format, fusion and map, a number of photos below 1, an error that is
    /// negative or not finite, and a map whose cells are smaller than two voxels.
    void validate() const;
};

struct PlaceReport {
    std::size_t photos = 0; ///< Photos whose depth was fused.
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    double areaM2 = 0;
    double seenShare = 0;      ///< Share of all directions about the photos in which there is a surface.
    double seenTwiceShare = 0; ///< Share of the vertices that two photos or more show.
    double freeM2 = 0;         ///< Floor that a robot can drive on; 0 without a map.
    double occupiedM2 = 0;     ///< Floor on which things stand; 0 without a map.
    double depthSeconds = 0;   ///< For depths that were not known yet.
    double seconds = 0;        ///< For everything else.
};

/// Exports what was seen of a place into a new folder. source: a dataset with depths, or a survey, whose
/// depths are estimated first unless an earlier export kept them.
///
/// Errors: those of PlaceOptions::validate(), opening the source, exportDataset() and place::fused();
/// InvalidInput if fewer than two photos have a depth, if they see no surface, or if joining triangles leaves
/// none; Exists, Full, Io. After an error nothing is left. Stop: Stopped. Cost: about a second a photo of one
/// core.
PlaceReport exportPlace(const std::filesystem::path& source, const std::filesystem::path& folder,
                        const PlaceOptions& options, ProgressSink& progress, const std::stop_token& stop);

/// The surface that a dataset's photos show, with its colours: its vertices are points that learners begin
/// with. Errors: those of exportPlace(). Stop: Stopped.
place::Surface paintedSurfaceOf(const std::filesystem::path& dataset, const PlaceOptions& options,
                                ProgressSink& progress, const std::stop_token& stop);

/// Whether a folder is a dataset with depths of two photos or more. Errors: those of opening a dataset.
bool hasDepths(const std::filesystem::path& folder);

/// What stands in a room. Frames: room.
struct Furniture {
    place::Surface mesh; ///< Of few triangles, and closed from behind; see place::addBoxes().
    /// The same for collisions, of cells of two voxels; see place::solidBoxes().
    std::vector<Eigen::AlignedBox3d> boxes;
};

/// What a dataset shows to stand in a room, without the room's walls, its floor and its ceiling. Errors:
/// those of exportPlace() and of RoomShape::validate(). Stop: Stopped.
Furniture furnitureOf(const std::filesystem::path& dataset, const render::RoomShape& room,
                      const PlaceOptions& options, ProgressSink& progress, const std::stop_token& stop);

Json toJson(const PlaceReport& report);

/// How a page for browsers is written.
struct WebOptions {
    std::string language = "en"; ///< BCP 47.
    /// The translation of the page's English words and of core's sentences; empty: English.
    std::function<std::string(const std::string&)> translated = {};
    /// A report.json of readMeasuredPhotos() with errors for the page's map; empty: the page has no such map.
    std::filesystem::path measured = {};
};

struct WebReport {
    std::size_t photos = 0;
    std::size_t withDepth = 0; ///< Photos in which distances can be measured.
    std::size_t leftOut = 0;   ///< Stations of the plan without a photo on the page.
    std::uint64_t totalBytes = 0;
    double depthSeconds = 0; ///< For depths that were not known yet.
    double seconds = 0;      ///< For everything else.
};

/// Exports a page that any browser opens from a disk, into a new folder: plan, panoramas, walking from photo
/// to photo, measuring, maps of the floor, and what checks and people said of the photos. source: a dataset,
/// or a survey, whose depths are estimated first unless an earlier export kept them. A survey that was never
/// aligned gets no depths, and a photo whose heading is not known has none on the page. The page holds no
/// paths, no serial numbers of cameras and no metadata of photos.
///
/// Errors: those of opening the source, of exportDataset(), of readMeasuredPhotos() and of reading photos;
/// InvalidInput for a report of another survey; Exists, Full, Io. After an error nothing is left. Stop:
/// Stopped.
WebReport exportWeb(const std::filesystem::path& source, const std::filesystem::path& folder,
                    const WebOptions& options, ProgressSink& progress, const std::stop_token& stop);

Json toJson(const WebReport& report);

} // namespace spherewalk::jobs
