// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/walk.h"

#include "parts/cache_key.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/base/text.h"
#include "spherewalk/dataset/coco.h"
#include "spherewalk/jobs/export_foreign.h"
#include "spherewalk/photo/picture_file.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace spherewalk::jobs {

namespace fs = std::filesystem;

namespace {

constexpr char kBetween = '\t'; ///< in no file name that a dataset has
constexpr std::string_view kEnd = "end";

/// What is known of a frame that was rendered, as lines of CSV without its name.
struct FrameLines {
    std::string what;  ///< the same in every run
    std::string times; ///< how long it took, and what it was made of meanwhile
};

/// Frames of a walk that are there, told by files beside them, one of each part: so that a run that was
/// stopped goes on, and parts that were rendered by other processes count. Files of other walks, and lines
/// that were cut off, are left out.
class WalkJournal {
  public:
    /// key: of all that the frames depend on. Errors: those of reading files and of making the folder.
    WalkJournal(const std::filesystem::path& folder, const std::string& key, const Shard& shard);

    const std::map<std::size_t, FrameLines>& frames() const { return m_frames; }

    /// Reads what other processes have added since.
    void refresh();

    /// Errors: Io, Full.
    void add(std::size_t frame, const FrameLines& lines);

  private:
    void read(const std::filesystem::path& file);

    std::string m_prefix; ///< of the names of this walk's files
    std::filesystem::path m_file;
    std::ofstream m_out;
    std::map<std::size_t, FrameLines> m_frames;
};

WalkJournal::WalkJournal(const fs::path& folder, const std::string& key, const Shard& shard)
    : m_prefix(key.substr(0, 16)),
      m_file(folder / "parts" / text(m_prefix, ".", shard.index + 1, "-of-", shard.count, ".tsv")) {
    ensureFolder(m_file.parent_path());
    refresh();
    m_out.open(m_file, std::ios::app);
    m_out << '\n'; // after a line that was cut off
}

void WalkJournal::refresh() {
    for (const fs::directory_entry& entry : fs::directory_iterator(m_file.parent_path())) {
        if (entry.path().filename().string().starts_with(m_prefix)) {
            read(entry.path());
        }
    }
}

void WalkJournal::read(const fs::path& file) {
    std::istringstream all(readTextFile(file));
    for (std::string line; std::getline(all, line);) {
        std::vector<std::string> fields;
        std::istringstream rest(line);
        for (std::string field; std::getline(rest, field, kBetween);) {
            fields.push_back(field);
        }
        const auto frame = fields.size() == 4 && fields[3] == kEnd ? parseNumber(fields[0]) : std::nullopt;
        if (frame && *frame >= 0 && *frame < 1e15) {
            m_frames[static_cast<std::size_t>(*frame)] = {fields[1], fields[2]};
        }
    }
}

void WalkJournal::add(std::size_t frame, const FrameLines& lines) {
    m_out << frame << kBetween << lines.what << kBetween << lines.times << kBetween << kEnd << std::endl;
    if (!m_out) {
        throw Error(ErrorKind::Io, text("Could not write ", m_file.string(), "; is the disk full?"));
    }
    m_frames[frame] = lines;
}

void requireRosTimes(const std::vector<TimedPose>& path) {
    for (const TimedPose& pose : path) {
        dataset::rosStampNs(pose.timeS);
    }
}

constexpr std::size_t kSheetCells = 24;
constexpr int kSheetColumns = 6;
constexpr int kSheetCellWidth = 320;
constexpr const char* kDepthFolder = "depth";
constexpr const char* kLabelsFolder = "labels";
constexpr int kWalkMethod = 3; ///< grows when the same walk gives other frames

std::string frameName(std::size_t frame) {
    const std::string number = std::to_string(frame);
    return std::string(6 - std::min<std::size_t>(6, number.size()), '0') + number + ".png";
}

std::vector<std::filesystem::path> frameFiles(std::size_t frames, const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (std::size_t i = 0; i < frames; ++i) {
        files.push_back(folder / frameName(i));
    }
    return files;
}

constexpr std::string_view kColumns =
    "frame,time_s,x_m,y_m,z_m,qx,qy,qz,qw,photo,offset_m,scene,sampling,parallax_px,trust";
constexpr std::string_view kTimeColumns = "frame,decode_ms,render_ms,origin,late";

constexpr std::string_view kSensorColumns = ",exposure_time_s,gain_db";

FrameLines linesOf(const TimedPose& pose, const render::ViewReport& report,
                   const std::optional<render::SensorReport>& sensor) {
    const Eigen::Vector3d& t = pose.roomFromCamera.translation;
    const Eigen::Quaterniond& q = pose.roomFromCamera.rotation;
    return {text(pose.timeS, ",", t.x(), ",", t.y(), ",", t.z(), ",", q.x(), ",", q.y(), ",", q.z(), ",",
                 q.w(), ",", report.file, ",", report.offsetM, ",", name(report.scene), ",",
                 name(report.sampling), ",", fixed(report.parallaxPx, 3), ",", fixed(report.trust, 4),
                 sensor ? text(",", sensor->exposureTimeS, ",", fixed(sensor->gainDb, 3)) : ""),
            text(fixed(report.decodeMs, 3), ",", fixed(report.renderMs, 3), ",", name(report.origin), ",",
                 report.isLate ? 1 : 0)};
}

/// Of all that the frames depend on.
std::string walkKey(const render::DatasetInfo& info, const CameraModel& camera,
                    const std::vector<TimedPose>& path, const WalkOptions& options) {
    std::string key =
        text("walk ", kWalkMethod, "\n", render::toJson(info).dump(), "\n", keyOf(camera.intrinsics()));
    key += text("\n", options.view.scene ? name(*options.view.scene) : "auto", " ",
                name(options.view.sampling), " ", name(options.stream.late), " ", options.stream.passageM);
    for (const Ball& ball : options.balls) {
        const Eigen::Vector3d& at = ball.centreM;
        key += text(" ball ", at.x(), " ", at.y(), " ", at.z(), " ", ball.radiusM);
    }
    key += options.sensor ? text(" ", sensorYaml(*options.sensor)) : "";
    key += options.writesDepth ? " depth" : "";
    key += options.writesLabels ? " labels" : "";
    return sha256Hex(bytesOf(key + "\n" + tumText(path)));
}

void writePoses(const std::vector<dataset::PoseFormat>& formats, const CameraModel& camera,
                const std::vector<TimedPose>& path, const std::filesystem::path& folder) {
    std::vector<dataset::PosedFrame> frames;
    for (std::size_t i = 0; i < path.size(); ++i) {
        frames.push_back({frameName(i), path[i].timeS, path[i].roomFromCamera});
    }
    for (const dataset::PoseFormat format : formats) {
        writePoseFiles(format, camera.intrinsics(), frames, folder);
    }
}

/// The balls in all frames, of which the pictures of labels are there.
Json annotations(const CameraModel& camera, const std::vector<TimedPose>& path,
                 const std::vector<Ball>& balls, const std::filesystem::path& folder) {
    const std::vector<std::string> categories{"ball"};
    return dataset::cocoJson(categories, path.size(), [&](std::size_t i) {
        const std::string labels = text(kLabelsFolder, "/", frameName(i));
        dataset::LabelledFrame frame{frameName(i),
                                     labels,
                                     path[i].timeS,
                                     path[i].roomFromCamera,
                                     photo::readPng16(folder / labels),
                                     {}};
        for (std::size_t ball = 0; ball < balls.size(); ++ball) {
            const double widthM = 2 * balls[ball].radiusM;
            frame.objects.push_back({static_cast<std::uint16_t>(ball + 1),
                                     categories.front(),
                                     {Eigen::Quaterniond::Identity(), balls[ball].centreM},
                                     {widthM, widthM, widthM},
                                     ballMask(balls[ball], camera, path[i].roomFromCamera)});
        }
        return frame;
    });
}

/// What is written once all frames are there.
void finish(const WalkJournal& journal, const CameraModel& camera, const std::vector<TimedPose>& path,
            const WalkOptions& options, const std::filesystem::path& folder) {
    std::string index = text(kColumns, options.sensor ? kSensorColumns : "", "\n");
    std::string times = text(kTimeColumns, "\n");
    for (const auto& [frame, lines] : journal.frames()) {
        index += text(frameName(frame), ",", lines.what, "\n");
        times += text(frameName(frame), ",", lines.times, "\n");
    }
    writeFile(folder / "index.csv", bytesOf(index));
    writeFile(folder / "times.csv", bytesOf(times));
    writePoses(options.formats, camera, path, folder);
    if (options.writesLabels) {
        writeFile(folder / "annotations.json",
                  bytesOf(annotations(camera, path, options.balls, folder).dump(1) + "\n"));
    }
    const WalkPictures pictures{
        frameFiles(path.size(), folder),
        options.writesDepth ? frameFiles(path.size(), folder / kDepthFolder) : std::vector<fs::path>(),
        options.writesLabels ? frameFiles(path.size(), folder / kLabelsFolder) : std::vector<fs::path>()};
    for (const dataset::BagFormat format : options.bags) {
        writeWalkBag(format, options.bagPictures, camera.intrinsics(), path, pictures,
                     folder / text("walk.", extension(format)));
    }
    const std::size_t sheetStep = std::max<std::size_t>(1, (path.size() + kSheetCells - 1) / kSheetCells);
    std::vector<RgbImage> sheet;
    for (std::size_t i = 0; i < path.size(); i += sheetStep) {
        sheet.push_back(photo::readPicture(folder / frameName(i)));
    }
    photo::writePng(folder / "contact-sheet.png", photo::contactSheet(sheet, kSheetColumns, kSheetCellWidth));
}

/// Makes a walk's frames in the order of the path.
class WalkFrames {
  public:
    /// Owner: all arguments must outlive the frames.
    WalkFrames(const render::Renderer& renderer, const CameraModel& camera,
               const std::vector<TimedPose>& path, const WalkOptions& options);

    /// The next frames are the same as if this one had been made.
    void pass(std::size_t frame);
    const render::View& make(std::size_t frame);

    /// Of the frame that was made last.
    const std::optional<render::SensorReport>& sensorReport() const { return m_sensorReport; }

    const render::StreamCounters& counters() const { return m_stream.counters(); }

  private:
    void makeView(const Rigid3& roomFromCamera, double timeS, bool isMain, render::View& view);

    const CameraModel& m_camera;
    const std::vector<TimedPose>& m_path;
    const WalkOptions& m_options;
    render::ViewStream m_stream;
    std::optional<render::Sensor> m_sensor;
    std::optional<render::SensorReport> m_sensorReport;
    std::vector<render::Overlay> m_overlays;
    render::View m_view;
};

WalkFrames::WalkFrames(const render::Renderer& renderer, const CameraModel& camera,
                       const std::vector<TimedPose>& path, const WalkOptions& options)
    : m_camera(camera), m_path(path), m_options(options), m_stream(renderer, camera, options.stream) {
    if (options.sensor) {
        m_sensor.emplace(*options.sensor, camera, options.view.threads);
    }
}

void WalkFrames::makeView(const Rigid3& roomFromCamera, double timeS, bool isMain, render::View& view) {
    render::ViewOptions options = m_options.view;
    options.wantsDepth = isMain && (m_options.writesDepth || (m_sensor && m_sensor->needsDepth()));
    options.depthShowsOverlays = true;
    options.wantsLabels = isMain && m_options.writesLabels;
    m_overlays.clear();
    for (const Ball& ball : m_options.balls) {
        m_overlays.push_back(ballOverlay(ball, m_camera, roomFromCamera));
    }
    for (const PlacedMesh& mesh : m_options.meshes) {
        m_overlays.push_back(meshOverlay(mesh, m_camera, roomFromCamera));
    }
    options.overlays = m_overlays;
    m_stream.next(roomFromCamera, timeS, options, view);
    if ((options.wantsDepth || options.wantsLabels) && view.report.scene == render::SceneKind::None) {
        throw Error(ErrorKind::InvalidInput,
                    "The scene model \"none\" knows no depth: choose sphere, room or "
                    "depth by --scene, or export the dataset with one of them.");
    }
}

void WalkFrames::pass(std::size_t frame) {
    const TimedPose& pose = m_path[frame];
    if (!m_sensor) {
        m_stream.pass(pose.roomFromCamera, m_options.view);
    } else if (m_sensor->isAutomatic()) {
        make(frame);
    } else {
        const auto at = [this](double timeS) { return poseAt(m_path, timeS); };
        for (const double timeS : m_sensor->times(at, pose.timeS)) {
            m_stream.pass(at(timeS), m_options.view);
        }
    }
}

const render::View& WalkFrames::make(std::size_t frame) {
    const TimedPose& pose = m_path[frame];
    if (!m_sensor) {
        makeView(pose.roomFromCamera, pose.timeS, true, m_view);
        return m_view;
    }
    m_sensorReport =
        m_sensor->take([this](const Rigid3& roomFromCamera, double timeS, bool isMain,
                              render::View& view) { makeView(roomFromCamera, timeS, isMain, view); },
                       [this](double timeS) { return poseAt(m_path, timeS); }, pose.timeS, frame, m_view);
    m_sensor->measureDepth(frame, m_view.depth);
    return m_view;
}

/// The folders in which each frame has a picture.
std::vector<fs::path> pictureFoldersOf(const WalkOptions& options, const fs::path& folder) {
    std::vector<fs::path> folders{folder};
    if (options.writesDepth) {
        folders.push_back(folder / kDepthFolder);
    }
    if (options.writesLabels) {
        folders.push_back(folder / kLabelsFolder);
    }
    return folders;
}

/// A sensor asks for poses between those of the path.
void requireAscendingTimes(const std::vector<TimedPose>& path) {
    for (std::size_t i = 1; i < path.size(); ++i) {
        if (!(path[i - 1].timeS < path[i].timeS)) {
            throw Error(ErrorKind::InvalidInput,
                        text("A sensor cannot take frames along this path: the time ", path[i].timeS,
                             " of pose ", i + 1, " is not later than the one before, ", path[i - 1].timeS,
                             "."));
        }
    }
}

} // namespace

WalkReport walk(const render::Renderer& renderer, const CameraModel& camera,
                const std::vector<TimedPose>& path, const WalkOptions& options,
                const std::filesystem::path& folder, ProgressSink& progress, const std::stop_token& stop) {
    if (!options.bags.empty()) {
        requireRosTimes(path);
    }
    if (options.sensor) {
        requireAscendingTimes(path);
    }
    if (options.writesLabels && options.balls.empty()) {
        throw Error(ErrorKind::InvalidInput, "Labels tell which pixels show an object: lay one into the "
                                             "frames, by --ball.");
    }
    ensureFolder(folder);
    const std::vector<fs::path> pictureFolders = pictureFoldersOf(options, folder);
    for (const fs::path& pictures : pictureFolders) {
        ensureFolder(pictures);
    }
    WalkJournal journal(folder, walkKey(renderer.dataset().info(), camera, path, options), options.shard);
    const auto isThere = [&](std::size_t frame) {
        return journal.frames().contains(frame) &&
               std::all_of(pictureFolders.begin(), pictureFolders.end(),
                           [&](const fs::path& of) { return fs::exists(of / frameName(frame)); });
    };
    WalkFrames frames(renderer, camera, path, options);
    WalkReport report;
    std::set<std::size_t> photos;
    std::vector<double> renderMs;
    std::vector<double> decodeMs;
    const auto [begin, end] = options.shard.range(path.size());
    for (std::size_t i = 0; i < end; ++i) {
        throwIfStopped(stop);
        report.frames += i < begin ? 0 : 1;
        report.outside +=
            i >= begin && renderer.dataset().isOutside(path[i].roomFromCamera.translation) ? 1 : 0;
        if (i < begin || isThere(i)) {
            report.reused += i < begin ? 0 : 1;
            frames.pass(i); // a frame has the same photos in any part
            continue;
        }
        const render::View& view = frames.make(i);
        photo::writePng(folder / frameName(i), view.picture);
        if (options.writesDepth) {
            photo::writePng(folder / kDepthFolder / frameName(i), render::depthMillimetres(view.depth));
        }
        if (options.writesLabels) {
            photo::writePng(folder / kLabelsFolder / frameName(i), view.labels);
        }
        journal.add(i, linesOf(path[i], view.report, frames.sensorReport()));
        photos.insert(view.report.photo);
        renderMs.push_back(view.report.renderMs);
        if (view.report.decodeMs > 0) {
            decodeMs.push_back(view.report.decodeMs);
        }
        report.worstOffsetM = std::max(report.worstOffsetM, view.report.offsetM);
        report.leastTrust = std::min(report.leastTrust, view.report.trust);
        progress.progress(static_cast<double>(report.frames) / static_cast<double>(end - begin),
                          "Rendering the walk");
    }
    journal.refresh(); // other parts may have been rendered meanwhile
    report.isComplete = true;
    for (std::size_t i = 0; i < path.size() && report.isComplete; ++i) {
        report.isComplete = isThere(i);
    }
    if (report.isComplete) {
        finish(journal, camera, path, options, folder);
    }
    report.photosUsed = photos.size();
    report.stream = frames.counters();
    report.load = renderer.counters();
    report.medianRenderMs = median(renderMs);
    report.medianDecodeMs = median(decodeMs);
    return report;
}

} // namespace spherewalk::jobs
