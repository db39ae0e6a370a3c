// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/export_place.h"

#include "export/source_dataset.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/folder.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/place/solid_boxes.h"
#include "spherewalk/place/surface.h"
#include "spherewalk/place/surface_files.h"
#include "spherewalk/render/colour_correction.h"
#include "spherewalk/store/survey_store.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

namespace spherewalk::jobs {

namespace fs = std::filesystem;

namespace {

constexpr EnumNames<PlaceFormat, 4> kFormats{{{PlaceFormat::Ply, "ply"},
                                              {PlaceFormat::Gltf, "gltf"},
                                              {PlaceFormat::Obj, "obj"},
                                              {PlaceFormat::Occupancy, "occupancy"}}};

constexpr float kLeastConfidence = 0.5F; ///< as many photos look through as show a surface
constexpr double kOfTheRoomM = 0.05;     ///< what is nearer to a wall, the floor or the ceiling belongs to it
constexpr double kHangsM = 0.07;         ///< what reaches no farther into the room hangs on a wall
constexpr double kFurnitureErrorM = 0.004;
constexpr double kVoxelsACell = 2;    ///< of furniture; the fused surface is rougher than a voxel
constexpr double kLeastPartM2 = 0.01; ///< smaller parts that hang in the air are mistakes of single photos

class PlaceExport {
  public:
    PlaceExport(const fs::path& dataset, const PlaceOptions& options, const std::stop_token& stop)
        : m_dataset(render::Dataset::open(dataset, render::Verify::Sizes, noProgress(), stop)),
          m_options(options),
          m_stop(stop) {}

    double scaleSigma() const { return m_dataset.info().scaleSigma; }

    PlaceReport run(const fs::path& folder, ProgressSink& progress) {
        ProgressStep finding(progress, 0, 0.8);
        find(finding);
        ProgressStep writing(progress, 0.8, 1);
        write(folder, writing);
        return m_report;
    }

    place::Surface painted(ProgressSink& progress) {
        ProgressStep finding(progress, 0, 0.8);
        find(finding);
        ProgressStep painting(progress, 0.8, 1);
        paint(painting);
        return std::move(m_surface);
    }

    Furniture furniture(const render::RoomShape& room, ProgressSink& progress) {
        ProgressStep finding(progress, 0, 0.9);
        find(finding, &room);
        place::Surface things = place::furnitureOf(std::move(m_surface), room, kOfTheRoomM);
        things.dropSmallParts(kLeastPartM2);
        progress.progress(0.95, "Making boxes of furniture");
        const place::FusionOptions& fusion = m_options.fusion;
        const place::BoxOptions coarse{kVoxelsACell * fusion.voxelM, room.floorM, fusion.threads};
        const place::BoxOptions fine{fusion.voxelM, room.floorM, fusion.threads};
        place::Surface mesh = place::simplified(things, kFurnitureErrorM);
        const place::Surface standing = place::furnitureOf(things, room, kHangsM);
        place::addBoxes(mesh, place::closingBoxes(standing, m_depths, fine, m_stop));
        return {std::move(mesh), place::solidBoxes(things, m_depths, coarse, m_stop)};
    }

  private:
    const std::vector<render::DatasetPhoto>& photos() const { return m_dataset.info().photos; }

    bool wants(PlaceFormat format) const { return m_options.formats.contains(format); }

    /// The surface, without colours. room: without what photos show outside of it.
    void find(ProgressSink& progress, const render::RoomShape* room = nullptr) {
        ProgressStep reading(progress, 0, 0.1);
        readDepths(room, reading);
        ProgressStep fusing(progress, 0.1, 0.8);
        const place::Volume volume = place::fused(m_depths, m_options.fusion, fusing, m_stop);
        progress.progress(0.8, "Finding surfaces");
        findSurface(volume);
    }

    void readDepths(const render::RoomShape* room, ProgressSink& progress) {
        std::vector<Rigid3> poses;
        for (const render::DatasetPhoto& photo : photos()) {
            poses.push_back(photo.roomFromPhoto);
        }
        const std::vector<double> baselines = place::baselinesM(poses);
        for (std::size_t i = 0; i < photos().size(); ++i) {
            throwIfStopped(m_stop);
            if (!photos()[i].depth.empty() && baselines[i] > 0) {
                m_depths.emplace_back(render::DepthMap::read(m_dataset.folder() / photos()[i].depth),
                                      poses[i], photos()[i].lenses, baselines[i], room);
                m_withDepth.push_back(i);
            }
            progress.progress(static_cast<double>(i + 1) / static_cast<double>(photos().size()),
                              text("Reading depth ", i + 1, " of ", photos().size()));
        }
        if (m_depths.size() < 2) {
            throw Error(ErrorKind::InvalidInput,
                        text("Could not export the surfaces of ", m_dataset.folder().string(), ": ",
                             counted(m_depths.size(), "photo has a depth", "photos have a depth"),
                             ", and surfaces are seen by two or more. Export the survey with --scene depth, "
                             "of photos that stand at least 5 cm apart."));
        }
        m_report.photos = m_depths.size();
    }

    void findSurface(const place::Volume& volume) {
        const place::FusionOptions& fusion = m_options.fusion;
        m_surface = place::surfaceOf(volume, fusion.threads, m_stop);
        m_surface.weigh(m_depths, fusion.voxelM, fusion.threads, m_stop);
        const std::vector<place::SurfaceVertex>& vertices = m_surface.vertices;
        m_surface.keepTriangles([&](std::size_t i) {
            const auto& triangle = m_surface.triangles[i];
            return std::all_of(triangle.begin(), triangle.end(), [&](std::uint32_t corner) {
                return vertices[corner].photos >= m_options.leastPhotos &&
                       vertices[corner].confidence >= kLeastConfidence;
            });
        });
        m_surface.dropSmallParts(kLeastPartM2);
        throwIfStopped(m_stop);
        requireSurface("its depths agree on no surface. See what align and review say of the photos.");
        m_report.seenShare = place::seenShare(m_surface, m_depths, 2 * fusion.voxelM, fusion.threads, m_stop);
        const auto twice =
            std::count_if(vertices.begin(), vertices.end(),
                          [](const place::SurfaceVertex& vertex) { return vertex.photos > 1; });
        m_report.seenTwiceShare = static_cast<double>(twice) / static_cast<double>(vertices.size());
    }

    void requireSurface(std::string_view what) const {
        if (m_surface.triangles.empty()) {
            throw Error(ErrorKind::InvalidInput,
                        text("Could not export the surfaces of ", m_dataset.folder().string(), ": ", what));
        }
    }

    void paint(ProgressSink& progress) {
        place::SurfacePainter painter(m_surface, m_options.fusion.voxelM);
        for (std::size_t i = 0; i < m_depths.size(); ++i) {
            throwIfStopped(m_stop);
            const render::DatasetPhoto& photo = photos()[m_withDepth[i]];
            RgbImage picture =
                jpeg::decodeAtLeast(m_dataset.readPhoto(m_withDepth[i]), photo.file, m_depths[i].width());
            render::expose(picture, photo.exposureGain.value_or(Eigen::Vector3d::Ones()),
                           m_dataset.info().highlightRolloff);
            painter.add(m_depths[i], picture, m_options.fusion.threads);
            progress.progress(static_cast<double>(i + 1) / static_cast<double>(m_depths.size()),
                              text("Painting surfaces, photo ", i + 1, " of ", m_depths.size()));
        }
        painter.finish();
    }

    void write(const fs::path& folder, ProgressSink& progress) {
        if (wants(PlaceFormat::Occupancy)) {
            writeMap(folder);
        }
        if (wants(PlaceFormat::Ply) || wants(PlaceFormat::Gltf) || wants(PlaceFormat::Obj)) {
            paint(progress);
            simplify();
        }
        m_report.vertices = m_surface.vertices.size();
        m_report.triangles = m_surface.triangles.size();
        m_report.areaM2 = m_surface.areaM2();
        if (wants(PlaceFormat::Ply)) {
            writeFile(folder / "surface.ply", place::plyFile(m_surface));
        }
        if (wants(PlaceFormat::Gltf)) {
            writeFile(folder / "surface.glb", place::glbFile(m_surface, m_dataset.info().name));
        }
        if (wants(PlaceFormat::Obj)) {
            writeFile(folder / "surface.obj", bytesOf(place::objFile(m_surface)));
        }
        writeFile(folder / "report.json", bytesOf(toJson(m_report).dump(1) + "\n"));
    }

    void simplify() {
        if (m_options.simplifyM > 0) {
            if (const auto& room = m_dataset.info().roomShape) {
                place::flatten(m_surface, *room, kOfTheRoomM);
            }
            m_surface = place::simplified(m_surface, m_options.simplifyM);
            requireSurface("no triangle is left when they are joined by so much. Take less.");
        }
    }

    void writeMap(const fs::path& folder) {
        place::OccupancyOptions options = m_options.occupancy;
        if (const auto& room = m_dataset.info().roomShape) {
            options.floorM = room->floorM;
            options.outline = room->outline;
        }
        const place::OccupancyGrid grid = place::occupancyOf(m_surface, m_depths, options, m_stop);
        writeFile(folder / "map.pgm", place::pgmFile(grid));
        writeFile(folder / "map.yaml", bytesOf(place::mapYaml(grid, "map.pgm")));
        const auto cells = grid.cells.values();
        const auto areaOf = [&](std::uint8_t value) {
            return static_cast<double>(std::count(cells.begin(), cells.end(), value)) * grid.cellM *
                   grid.cellM;
        };
        m_report.freeM2 = areaOf(place::kFree);
        m_report.occupiedM2 = areaOf(place::kOccupied);
    }

    render::Dataset m_dataset;
    const PlaceOptions& m_options;
    std::stop_token m_stop;
    std::vector<place::SeenDepth> m_depths;
    std::vector<std::size_t> m_withDepth; ///< The photos that they are of.
    place::Surface m_surface;
    PlaceReport m_report;
};

SourceDataset sourceOf(const fs::path& source, ProgressSink& progress, const std::stop_token& stop) {
    if (fs::exists(source / render::kDatasetFile)) {
        return SourceDataset(source);
    }
    const auto survey = store::SurveyStore::open(source, store::Access::Read);
    ExportOptions options;
    options.scene = render::SceneKind::Depth;
    return {survey, options, progress, stop};
}

} // namespace

std::string_view name(PlaceFormat format) {
    return nameOf(kFormats, format);
}

std::optional<PlaceFormat> placeFormat(std::string_view name) {
    const auto* const found = std::find_if(kFormats.begin(), kFormats.end(),
                                           [&](const auto& format) { return format.second == name; });
    return found == kFormats.end() ? std::nullopt : std::optional(found->first);
}

void PlaceOptions::validate() const {
    fusion.validate();
    occupancy.validate();
    if (leastPhotos < 1) {
        throw Error(ErrorKind::InvalidInput,
                    text("Could not export surfaces that ", leastPhotos, " photos show: one is the least."));
    }
    if (!(simplifyM >= 0 && std::isfinite(simplifyM))) {
        throw Error(ErrorKind::InvalidInput,
                    text("Could not join triangles by an error of ", simplifyM, " m: it must be 0 or more."));
    }
    if (formats.empty()) {
        throw Error(ErrorKind::InvalidInput, "Could not export a place: no format was chosen.");
    }
    if (formats.contains(PlaceFormat::Occupancy) && occupancy.cellM < 2 * fusion.voxelM) {
        throw Error(ErrorKind::InvalidInput,
                    text("Could not make a map with cells of ", occupancy.cellM, " m from voxels of ",
                         fusion.voxelM, " m: a cell must be at least two voxels large."));
    }
}

void tellScale(double sigma, ProgressSink& progress) {
    constexpr double kToldSigma = 0.05;
    if (sigma >= kToldSigma) {
        progress.warning(text("All lengths are known to ", fixed(100 * sigma, 0),
                              " % alone (one standard deviation): align the survey with a known height of "
                              "the lens, or a known distance, and export again."));
    }
}

PlaceReport exportPlace(const fs::path& source, const fs::path& folder, const PlaceOptions& options,
                        ProgressSink& progress, const std::stop_token& stop) {
    options.validate();
    requireAbsent(folder, "the export");
    const auto begin = std::chrono::steady_clock::now();
    ProgressStep exporting(progress, 0, 0.6);
    const SourceDataset dataset = sourceOf(source, exporting, stop);
    ProgressStep placing(progress, dataset.path() == source ? 0 : 0.6, 1);
    PlaceExport place(dataset.path(), options, stop);
    if (dataset.path() == source) { // a survey's own export says why
        tellScale(place.scaleSigma(), placing);
    }
    PlaceReport report;
    makeFolder(folder, "the export",
               [&](const fs::path& unfinished) { report = place.run(unfinished, placing); });
    report.depthSeconds = dataset.depthSeconds();
    report.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() - report.depthSeconds;
    return report;
}

place::Surface paintedSurfaceOf(const fs::path& dataset, const PlaceOptions& options, ProgressSink& progress,
                                const std::stop_token& stop) {
    options.validate();
    return PlaceExport(dataset, options, stop).painted(progress);
}

bool hasDepths(const fs::path& folder) {
    if (!fs::exists(folder / render::kDatasetFile)) {
        return false;
    }
    const render::Dataset dataset = render::Dataset::open(folder);
    const auto& photos = dataset.info().photos;
    return std::count_if(photos.begin(), photos.end(),
                         [](const render::DatasetPhoto& photo) { return !photo.depth.empty(); }) > 1;
}

Furniture furnitureOf(const fs::path& dataset, const render::RoomShape& room, const PlaceOptions& options,
                      ProgressSink& progress, const std::stop_token& stop) {
    room.validate();
    options.validate();
    PlaceExport place(dataset, options, stop);
    return place.furniture(room, progress);
}

Json toJson(const PlaceReport& report) {
    return {{"photos", report.photos},        {"vertices", report.vertices},
            {"triangles", report.triangles},  {"area_m2", report.areaM2},
            {"seen_share", report.seenShare}, {"seen_twice_share", report.seenTwiceShare},
            {"free_m2", report.freeM2},       {"occupied_m2", report.occupiedM2}};
}

} // namespace spherewalk::jobs
