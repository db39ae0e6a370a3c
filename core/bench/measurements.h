// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bench_photo.h"

#include "spherewalk/base/progress.h"
#include "spherewalk/bench/bench_report.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/jpeg/region.h"

#include <array>
#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

/// The measurements that bench() makes one after the other. Each one checks its results before it times them.
/// Errors of all: those of reading, decoding and rendering; Internal if a check fails; Stopped.
namespace spherewalk::bench {

/// The samplings from the cheapest to the most exact, as render::Sampling lists them.
inline constexpr std::array kRungs{render::Sampling::Nearest, render::Sampling::Bilinear,
                                   render::Sampling::Reduced, render::Sampling::Footprint,
                                   render::Sampling::Bicubic};

// The names of peers.
constexpr const char* kLibjpegWhole = "libjpeg-turbo, whole photo";
constexpr const char* kWholeAndRender = "whole decode + render";
constexpr const char* kMapsAndRemap = "OpenCV maps + remap";    ///< The maps are made for each view.
constexpr const char* kRemap = "OpenCV remap";                  ///< Ready maps are used, others each time.
constexpr const char* kRemapSameMap = "OpenCV remap, same map"; ///< The camera stands still.
constexpr const char* kOneThread = "one thread";
constexpr const char* kViewAlone = "view alone";
constexpr const char* kSphereView = "sphere";

/// This machine and this build; peerVersion stays empty. Cost: 0.1 s, for twoThreadGain.
Machine thisMachine(const std::stop_token& stop);

/// The most memory that this process has had so far.
std::uint64_t peakResidentBytes();

/// Times what BenchReport names "decode...." with one thread and two: whole is the photo, region is what a
/// level view of 90 degrees shows, reduced is the region at half its size. A name with ".planes" stands for
/// samples as the JPEG stores them. A photo without restart markers has rows decode.whole and
/// decode.thumbnail only. Each part is first compared with the whole photo, byte by byte.
std::vector<BenchRow> measureDecoding(const BenchPhoto& photo, bool peers, int rounds, ProgressSink& progress,
                                      const std::stop_token& stop);

/// The smallest rectangle of whole MCUs (16 pixels) that holds all that a view straight ahead shows.
jpeg::PixelRect regionAhead(const CameraModel& camera, const EquirectSize& photo);

/// The name of a view's row, such as "view.bilinear" for a level view of 90 degrees. ".57" follows for
/// another field of view, and ".steep" for a pitched view.
std::string viewRowName(render::Sampling sampling, const ViewSetting& setting);

/// Times views of each sampling with one thread and two, from Renderer::render() to the picture. The camera
/// turns by 7.3 degrees and moves before each view; all of the photo is in memory. First, bilinear views are
/// compared with exact ones and with OpenCV's, and views of two threads with those of one.
std::vector<BenchRow> measureViews(const BenchPhoto& photo, const ViewSetting& setting, bool peers,
                                   int rounds, ProgressSink& progress, const std::stop_token& stop);

/// Times level views of 90 degrees, default sampling, one thread, with more than a picture: depth, trust, an
/// object that covers a quarter of the picture, and the same object taken by a wider camera with distortion.
/// The peer of these rows "view.with_..." is the view alone, so their ratios are below one. A dataset without
/// a sphere has no rows for depth and objects. Rows "view.with_sensor...." take frames by a sensor with one
/// effect, or all, while the camera turns by 60 degrees a second. Errors: Internal if the object is hidden,
/// and if a sensor changes nothing or depends on threads.
std::vector<BenchRow> measureExtras(const BenchPhoto& photo, int rounds, ProgressSink& progress,
                                    const std::stop_token& stop);

/// Times level views of 57 degrees from surfaces, bilinear and footprint, on one thread. The camera stands
/// beside the photo, half as far away as the next photo's cell begins. The peer of the rows
/// "scene.<model>.<sampling>" is the sphere's view, so their ratios are below one. The result is empty for a
/// dataset without surfaces or without a sphere.
std::vector<BenchRow> measureScenes(const BenchPhoto& photo, int rounds, ProgressSink& progress,
                                    const std::stop_token& stop);

struct ColdCells {
    std::vector<BenchRow> rows; ///< "cold_cell", "cold_cell.unverified", "cold_cell.disk"
    bool filesDropped = true;   ///< For "cold_cell.disk", each file was read from the disk indeed.
};

/// Times the first view of a photo that nothing decoded ahead: level, 90 degrees, default sampling, all
/// threads. The peer reads the file, decodes all of it by libjpeg-turbo on one thread, and renders a view.
/// Both verify the file by its hash, except for "cold_cell.unverified". The file is in the system's cache,
/// except for "cold_cell.disk". Photos are taken in turns; a new renderer begins when all have been seen.
ColdCells measureColdCells(const std::shared_ptr<const render::Dataset>& dataset, int views,
                           ProgressSink& progress, const std::stop_token& stop);

/// Asks the system to drop the file from its cache, and returns whether it did. File systems in memory
/// cannot, and others may refuse. Errors: NotFound, Io.
bool dropFromFileCache(const std::filesystem::path& file);

struct FidelityOptions {
    int directions = 40; ///< Pitches lie evenly in +-80 degrees; yaws advance by the golden angle.
    int pixelStep = 1;   ///< Every pixelStep-th pixel along each axis is compared.
};

/// Peak signal to noise ratio of each sampling against the mean of 8 x 8 samples a pixel. These samples are
/// bilinear, in double precision, of the photo as libjpeg-turbo decodes it. Cost: seconds a direction.
std::vector<RungFidelity> measureFidelity(const BenchPhoto& photo, double fieldDeg,
                                          const FidelityOptions& options, ProgressSink& progress,
                                          const std::stop_token& stop);

/// Peak signal to noise ratio in dB of values in [0, 255]; 100 for equal pictures. expected: the values of
/// every pixelStep-th pixel along each axis, from (0, 0), row after row.
double psnrDb(const std::vector<Eigen::Vector3d>& expected, const RgbImage& picture, int pixelStep);

struct WalkOptions {
    std::vector<double> speedsMS;
    int views = 90; ///< Views of each walk, 30 a second, after ten views that are counted apart.
};

/// Walks in real time along a serpentine through the photos' places and back, looking about slowly. There is
/// a row for each speed with each policy for late views, with prefetch, and for waiting without prefetch.
/// Each walk begins at full speed with nothing in memory. Views have 640 x 480 pixels and 90 degrees;
/// renderer and stream have their default options. Cost: views / 30 s for each row.
std::vector<WalkRow> measureWalks(const std::shared_ptr<const render::Dataset>& dataset,
                                  const WalkOptions& options, ProgressSink& progress,
                                  const std::stop_token& stop);

/// Looks all round at each of the first `mostPhotos` photos and returns their number. The program's memory is
/// at its peak thereafter.
std::size_t lookAllRound(const std::shared_ptr<const render::Dataset>& dataset, std::size_t mostPhotos,
                         ProgressSink& progress, const std::stop_token& stop);

} // namespace spherewalk::bench
