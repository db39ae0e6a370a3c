// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/export_foreign.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/folder.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/jpeg/jpeg.h"
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

    ForeignReport write(const fs::path& folder, ProgressSink& progress) {
        ensureFolder(folder / kPicturesFolder);
        const bool isCut = m_options.withFaces || m_options.format == dataset::PoseFormat::Colmap;
        ForeignReport report;
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
        writePoseFiles(m_options.format, camera, m_frames, folder);
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
             {(roomFromPhoto.rotation * photoFromOptical).normalized(), roomFromPhoto.translation}});
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

void writePoseFiles(dataset::PoseFormat format, const dataset::FrameCamera& camera,
                    std::span<const PosedFrame> frames, const fs::path& folder) {
    for (const dataset::TextFile& file : dataset::poseFiles(format, camera, frames)) {
        ensureFolder((folder / file.path).parent_path());
        writeFile(folder / file.path, bytesOf(file.text));
    }
}

ForeignReport exportForeign(const store::SurveyStore& store, const fs::path& folder,
                            const ForeignOptions& options, ProgressSink& progress,
                            const std::stop_token& stop) {
    requireAbsent(folder, "the export");
    const TemporaryFolder temporary("spherewalk-export");
    ProgressStep exporting(progress, 0, 0.4);
    exportDataset(store, temporary.path() / "dataset", {}, exporting, stop);
    ProgressStep writing(progress, 0.4, 1);
    ForeignReport report;
    makeFolder(folder, "the export", [&](const fs::path& unfinished) {
        report = ForeignExport(temporary.path() / "dataset", options, stop).write(unfinished, writing);
    });
    return report;
}

namespace {

Eigen::Vector3d mostCentral(const std::vector<Eigen::Vector3d>& places, const std::filesystem::path& folder) {
    if (places.empty()) {
        throw Error(ErrorKind::InvalidInput,
                    text("No place for the robot's camera is known: ", folder.string(), " has no stations."));
    }
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& place : places) {
        middle += place / static_cast<double>(places.size());
    }
    return *std::min_element(places.begin(), places.end(),
                             [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
                                 return (a - middle).squaredNorm() < (b - middle).squaredNorm();
                             });
}

dataset::WorldRoom roomOfDataset(const std::filesystem::path& folder) {
    const render::Dataset opened = render::Dataset::open(folder);
    const render::DatasetInfo& info = opened.info();
    std::vector<Eigen::Vector3d> places;
    for (const render::DatasetPhoto& photo : info.photos) {
        places.push_back(photo.roomFromPhoto.translation);
    }
    const Eigen::Vector3d start = mostCentral(places, folder);
    if (info.roomShape) {
        return {info.name, info.roomShape->outline, info.roomShape->floorM, info.roomShape->ceilingM, start};
    }
    return {info.name, info.outline, 0, info.ceilingM, start};
}

dataset::WorldRoom roomOfSurvey(const std::filesystem::path& folder) {
    const auto store = store::SurveyStore::open(folder, store::Access::Read);
    const survey::Room room = store.room();
    std::vector<Eigen::Vector3d> places;
    for (const store::PhotoRecord& photo : store.keptPhotos()) {
        places.push_back(photo.positionM);
    }
    if (places.empty()) {
        for (const store::StationRecord& station : store.stations()) {
            places.push_back(station.station.positionM);
        }
    }
    return {store.info().name, room.outline, 0, room.ceilingM, mostCentral(places, folder)};
}

} // namespace

dataset::WorldRoom worldRoomOf(const std::filesystem::path& folder) {
    return std::filesystem::exists(folder / render::kDatasetFile) ? roomOfDataset(folder)
                                                                  : roomOfSurvey(folder);
}

void exportWorld(const dataset::WorldRoom& room, const CameraIntrinsics& camera,
                 const std::filesystem::path& folder) {
    const std::string world = dataset::sdfWorld(room, camera);
    makeFolder(folder, "the world", [&](const std::filesystem::path& unfinished) {
        writeFile(unfinished / "world.sdf", bytesOf(world));
        writeFile(unfinished / "camera.yaml", bytesOf(render::cameraInfoYaml(camera, "robot")));
    });
}

} // namespace spherewalk::jobs
