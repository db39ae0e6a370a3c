// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/export_foreign.h"

#include "export/source_dataset.h"
#include "parts/csv.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/folder.h"
#include "spherewalk/base/text.h"
#include "spherewalk/dataset/world_file.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/jobs/solution_findings.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/place/surface_files.h"
#include "spherewalk/render/camera_info.h"
#include "spherewalk/render/dataset.h"
#include "spherewalk/render/renderer.h"
#include "spherewalk/store/survey_store.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

namespace spherewalk::jobs {

namespace fs = std::filesystem;
using dataset::PosedFrame;

namespace {

constexpr const char* kPicturesFolder = "images";
constexpr int kPictureQuality = 95;

/// A face of the cube about a photo, as a camera turned about the photo's axes.
struct Face {
    const char* name;
    double yawRad;   ///< to the left
    double pitchRad; ///< upwards
};

constexpr double kQuarter = std::numbers::pi / 2;
constexpr std::array kFaces{Face{"front", 0, 0},           Face{"left", kQuarter, 0},
                            Face{"back", 2 * kQuarter, 0}, Face{"right", -kQuarter, 0},
                            Face{"up", 0, kQuarter},       Face{"down", 0, -kQuarter}};

Eigen::Quaterniond photoFromOptical(const Face& face) {
    return (Eigen::AngleAxisd(face.yawRad, Eigen::Vector3d::UnitZ()) *
            Eigen::AngleAxisd(-face.pitchRad, Eigen::Vector3d::UnitY()) * bodyFromOptical())
        .normalized();
}

class ForeignExport {
  public:
    ForeignExport(const fs::path& dataset, const ForeignOptions& options, const std::stop_token& stop)
        : m_renderer(std::make_shared<const render::Dataset>(
              render::Dataset::open(dataset, render::Verify::Sizes, noProgress(), stop))),
          m_options(options),
          m_stop(stop) {
        for (const render::DatasetPhoto& photo : photos()) {
            if (photo.width != photos().front().width) {
                throw Error(ErrorKind::Unsupported,
                            text("Could not export for ", name(options.format), ": ", photo.file, " is ",
                                 photo.width, " pixels wide, and the others ", photos().front().width,
                                 "; its files describe one size. Reject the photos of the other size."));
            }
        }
    }

    /// surface: its vertices are the points.
    ForeignReport write(const place::Surface& surface, const fs::path& folder, ProgressSink& progress) {
        ensureFolder(folder / kPicturesFolder);
        const bool isCut = m_options.withFaces || m_options.format == dataset::PoseFormat::Colmap;
        ForeignReport report;
        report.tests = countTests(photos().size(), m_options.testEvery);
        for (std::size_t i = 0; i < photos().size(); ++i) {
            throwIfStopped(m_stop);
            isCut ? writeFaces(i, folder) : writeWhole(i, folder);
            ++report.photos;
            progress.progress(static_cast<double>(report.photos) / static_cast<double>(photos().size()),
                              text("Writing photo ", report.photos, " of ", photos().size()));
        }
        report.pictures = m_frames.size();
        const dataset::FrameCamera camera =
            isCut ? dataset::FrameCamera(face().intrinsics())
                  : dataset::FrameCamera(EquirectSize{photos().front().width, photos().front().width / 2});
        const std::vector<dataset::ColouredPoint> points = pointsOf(surface);
        report.points = points.size();
        writePoseFiles(m_options.format, camera, m_frames, folder, points);
        if (m_options.format == dataset::PoseFormat::Nerfstudio && !points.empty()) {
            writeFile(folder / dataset::kPointsFile, place::plyFile(surface));
        }
        if (isCut && report.tests > 0) {
            writeFile(folder / "test.csv", bytesOf(testCsv()));
            writeFile(folder / "camera.yaml", bytesOf(render::cameraInfoYaml(face().intrinsics(), "face")));
        }
        return report;
    }

  private:
    const std::vector<render::DatasetPhoto>& photos() const { return m_renderer.dataset().info().photos; }

    CameraModel face() const {
        const int size = std::max(1, photos().front().width / 4);
        return CameraModel(CameraIntrinsics::pinhole(size, size, kQuarter));
    }

    void add(std::size_t photo, const std::string& file, const Eigen::Quaterniond& photoFromOptical) {
        const Rigid3& roomFromPhoto = photos()[photo].roomFromPhoto;
        m_frames.push_back(
            {file,
             static_cast<double>(photo),
             {(roomFromPhoto.rotation * photoFromOptical).normalized(), roomFromPhoto.translation},
             isTestPhoto(photo, m_options.testEvery)});
    }

    static std::vector<dataset::ColouredPoint> pointsOf(const place::Surface& surface) {
        std::vector<dataset::ColouredPoint> points;
        points.reserve(surface.vertices.size());
        for (const place::SurfaceVertex& vertex : surface.vertices) {
            points.push_back({vertex.pInRoom, vertex.colour});
        }
        return points;
    }

    /// A positions file of the pictures that are tests.
    std::string testCsv() const {
        std::string csv = "file,x_m,y_m,z_m,qw,qx,qy,qz\n";
        for (const PosedFrame& frame : m_frames) {
            const Eigen::Vector3d& at = frame.roomFromCamera.translation;
            const Eigen::Quaterniond& q = frame.roomFromCamera.rotation;
            csv += frame.isTest ? text(csvField(frame.file), ",", at.x(), ",", at.y(), ",", at.z(), ",",
                                       q.w(), ",", q.x(), ",", q.y(), ",", q.z(), "\n")
                                : "";
        }
        return csv;
    }

    std::string stem(std::size_t photo) const { return fs::path(photos()[photo].file).stem().string(); }

    void writeWhole(std::size_t photo, const fs::path& folder) {
        const std::string file = text(kPicturesFolder, "/", stem(photo), ".jpg");
        fs::copy_file(m_renderer.dataset().folder() / photos()[photo].file, folder / file);
        add(photo, file, bodyFromOptical());
    }

    void writeFaces(std::size_t photo, const fs::path& folder) {
        render::ViewOptions view;
        view.scene = render::SceneKind::None; // from its own place a photo is right however far things are
        view.sampling = render::Sampling::Best;
        for (const Face& one : kFaces) {
            const std::string file = text(kPicturesFolder, "/", stem(photo), "_", one.name, ".jpg");
            add(photo, file, photoFromOptical(one));
            const RgbImage picture = m_renderer.render(face(), m_frames.back().roomFromCamera, view).picture;
            writeFile(folder / file, jpeg::encode(picture, kPictureQuality));
        }
    }

    render::Renderer m_renderer;
    const ForeignOptions& m_options;
    std::stop_token m_stop;
    std::vector<PosedFrame> m_frames;
};

} // namespace

void ForeignOptions::validate() const {
    ExportOptions split;
    split.testEvery = testEvery;
    split.validate();
    place.validate();
    if ((withPoints || testEvery > 0) && !dataset::knowsLearning(format)) {
        throw Error(ErrorKind::InvalidInput, text("The format ", name(format),
                                                  " knows no points and no pictures for tests: choose colmap "
                                                  "or nerfstudio."));
    }
}

void writePoseFiles(dataset::PoseFormat format, const dataset::FrameCamera& camera,
                    std::span<const PosedFrame> frames, const fs::path& folder,
                    std::span<const dataset::ColouredPoint> points) {
    for (const dataset::TextFile& file : dataset::poseFiles(format, camera, frames, points)) {
        ensureFolder((folder / file.path).parent_path());
        writeFile(folder / file.path, bytesOf(file.text));
    }
}

namespace {

/// Hands progress on, and no warnings: an export of the same photos has given them.
class WithoutWarnings : public ProgressSink {
  public:
    explicit WithoutWarnings(ProgressSink& sink) : m_sink(sink) {}

    void progress(double fraction, std::string_view activity) override {
        m_sink.progress(fraction, activity);
    }

    void warning(std::string_view /*sentence*/) override {}

  private:
    ProgressSink& m_sink;
};

/// What the photos that are no tests show.
place::Surface trainingSurface(const store::SurveyStore& store, const ForeignOptions& options,
                               ProgressSink& progress, const std::stop_token& stop) {
    ExportOptions wanted;
    wanted.scene = render::SceneKind::Depth;
    wanted.testEvery = options.testEvery;
    WithoutWarnings quiet(progress);
    ProgressStep estimating(quiet, 0, 0.7);
    const SourceDataset dataset(store, wanted, estimating, stop);
    ProgressStep fusing(quiet, 0.7, 1);
    return paintedSurfaceOf(dataset.path(), options.place, fusing, stop);
}

} // namespace

ForeignReport exportForeign(const store::SurveyStore& store, const fs::path& folder,
                            const ForeignOptions& options, ProgressSink& progress,
                            const std::stop_token& stop) {
    options.validate();
    requireAbsent(folder, "the export");
    const TemporaryFolder temporary("spherewalk-export");
    ProgressStep exporting(progress, 0, 0.2);
    exportDataset(store, temporary.path() / "dataset", {}, exporting, stop);
    place::Surface surface;
    if (options.withPoints) {
        ProgressStep seeing(progress, 0.2, 0.8);
        surface = trainingSurface(store, options, seeing, stop);
    }
    ProgressStep writing(progress, options.withPoints ? 0.8 : 0.2, 1);
    ForeignReport report;
    makeFolder(folder, "the export", [&](const fs::path& unfinished) {
        report =
            ForeignExport(temporary.path() / "dataset", options, stop).write(surface, unfinished, writing);
    });
    return report;
}

namespace {

Eigen::Vector3d mostCentral(const std::vector<Eigen::Vector3d>& places) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& place : places) {
        middle += place / static_cast<double>(places.size());
    }
    return *std::min_element(places.begin(), places.end(),
                             [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
                                 return (a - middle).squaredNorm() < (b - middle).squaredNorm();
                             });
}

/// A room before its start is chosen.
struct KnownRoom {
    std::string name;
    Polygon outline;
    double floorM = 0;
    double ceilingM = 0;
    std::vector<Polygon> obstacles;
    std::vector<Eigen::Vector3d> places; ///< Of photos, or of stations.
    double scaleSigma = 0;               ///< Of all lengths, as a share of them.
};

KnownRoom roomOfDataset(const std::filesystem::path& folder) {
    const render::Dataset opened = render::Dataset::open(folder);
    const render::DatasetInfo& info = opened.info();
    KnownRoom room{info.name, info.outline, 0, info.ceilingM, info.obstacles, {}, info.scaleSigma};
    if (info.roomShape) {
        room.outline = info.roomShape->outline;
        room.floorM = info.roomShape->floorM;
        room.ceilingM = info.roomShape->ceilingM;
    }
    for (const render::DatasetPhoto& photo : info.photos) {
        room.places.push_back(photo.roomFromPhoto.translation);
    }
    return room;
}

KnownRoom roomOfSurvey(const std::filesystem::path& folder, ProgressSink& progress) {
    const auto store = store::SurveyStore::open(folder, store::Access::Read);
    const survey::Room drawn = store.knownRoom();
    if (drawn.outline.empty()) {
        throw Error(ErrorKind::NotFound,
                    text("Could not make a world of the survey ", folder.string(),
                         ": nobody has drawn its room, and its photos have not shown it. Export it with "
                         "--scene depth and make the world of that dataset, or draw the room in Plan."));
    }
    if (store.plan().placements.empty() && store.roomOrigin() == store::RoomOrigin::Solved) {
        progress.warning("Nobody has drawn the room: its walls are a rectangle around what the photos show. "
                         "The world of a dataset with depth has walls as they stand.");
    }
    const PhotosToExport kept = photosToExport(store);
    KnownRoom room{store.info().name, drawn.outline, 0, drawn.ceilingM, drawn.obstacles, {}, kept.scaleSigma};
    for (const store::PhotoRecord& photo : kept.photos) {
        room.places.push_back(photo.positionM);
    }
    if (room.places.empty()) {
        for (const store::StationRecord& station : store.stations()) {
            if (station.isPlaceKnown) {
                room.places.push_back(station.station.positionM);
            }
        }
    }
    return room;
}

/// Whether the world's robot, which is 0.3 m wide, cannot stand here for this obstacle.
bool isInTheWay(const Polygon& obstacle, const Eigen::Vector3d& place) {
    constexpr double kRobotM = 0.2;
    return contains(obstacle, place.head<2>()) || distanceToEdge(obstacle, place.head<2>()) < kRobotM;
}

Eigen::Vector3d startIn(const KnownRoom& room) {
    std::vector<Eigen::Vector3d> free = room.places;
    std::erase_if(free, [&](const Eigen::Vector3d& place) {
        return std::any_of(room.obstacles.begin(), room.obstacles.end(),
                           [&](const Polygon& obstacle) { return isInTheWay(obstacle, place); });
    });
    return mostCentral(free.empty() ? room.places : free);
}

} // namespace

namespace {

constexpr EnumNames<WorldFormat, 3> kWorldFormats{
    {{WorldFormat::Sdf, "sdf"}, {WorldFormat::Mjcf, "mjcf"}, {WorldFormat::Urdf, "urdf"}}};

dataset::TextFile worldFile(const dataset::WorldRoom& room, const CameraIntrinsics& camera,
                            WorldFormat format) {
    switch (format) {
    case WorldFormat::Mjcf:
        return {"world.xml", dataset::mjcfWorld(room, camera)};
    case WorldFormat::Urdf:
        return {"room.urdf", dataset::urdfRoom(room)};
    case WorldFormat::Sdf:
        break;
    }
    return {"world.sdf", dataset::sdfWorld(room, camera)};
}

} // namespace

dataset::WorldRoom worldRoomOf(const std::filesystem::path& folder, double obstacleHeightM,
                               ProgressSink& progress) {
    const bool isDataset = std::filesystem::exists(folder / render::kDatasetFile);
    const KnownRoom known = isDataset ? roomOfDataset(folder) : roomOfSurvey(folder, progress);
    if (known.places.empty()) {
        throw Error(ErrorKind::InvalidInput,
                    text("No place for the robot's camera is known: ", folder.string(), " has no stations."));
    }
    tellScale(known.scaleSigma, progress);
    dataset::WorldRoom room{known.name, known.outline, known.floorM, known.ceilingM, startIn(known), {}};
    for (const Polygon& obstacle : known.obstacles) {
        if (!isInTheWay(obstacle, room.cameraAt)) {
            room.obstacles.push_back({obstacle, std::min(obstacleHeightM, known.ceilingM - known.floorM)});
        }
    }
    return room;
}

std::string_view name(WorldFormat format) {
    return nameOf(kWorldFormats, format);
}

std::optional<WorldFormat> worldFormat(std::string_view name) {
    const auto* const found = std::find_if(kWorldFormats.begin(), kWorldFormats.end(),
                                           [&](const auto& format) { return format.second == name; });
    return found == kWorldFormats.end() ? std::nullopt : std::optional(found->first);
}

std::string exportWorld(const dataset::WorldRoom& room, const CameraIntrinsics& camera, WorldFormat format,
                        const fs::path& folder) {
    const dataset::TextFile world = worldFile(room, camera, format);
    makeFolder(folder, "the world", [&](const fs::path& unfinished) {
        writeFile(unfinished / world.path, bytesOf(world.text));
        if (format == WorldFormat::Sdf && !room.furnitureMesh.empty()) {
            writeFile(unfinished / dataset::kFurnitureFile, bytesOf(room.furnitureMesh));
        }
        writeFile(unfinished / "camera.yaml", bytesOf(render::cameraInfoYaml(camera, "robot")));
    });
    return world.path;
}

SourceDataset::SourceDataset(const store::SurveyStore& survey, const ExportOptions& options,
                             ProgressSink& progress, const std::stop_token& stop)
    : m_temporary(std::in_place, "spherewalk-export"), m_path(m_temporary->path() / "dataset") {
    m_depthSeconds = exportDataset(survey, m_path, options, progress, stop).depth.seconds;
}

} // namespace spherewalk::jobs
