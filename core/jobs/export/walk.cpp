// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/walk.h"

#include "export/walk_frames.h"
#include "parts/cache_key.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/export_foreign.h"
#include "spherewalk/photo/picture_file.h"

#include <algorithm>
#include <cstddef>
#include <deque>
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
constexpr int kWalkMethod = 7; ///< grows when the same walk gives other frames

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
std::string walkKey(const render::DatasetInfo& info, const WalkCamera& camera, const WalkOptions& options) {
    std::string key =
        text("walk ", kWalkMethod, "\n", render::toJson(info).dump(), "\n", keyOf(camera.intrinsics));
    key += text("\n", options.view.scene ? name(*options.view.scene) : "auto", " ",
                name(options.view.sampling), " ", name(options.stream.late), " ", options.stream.passageM);
    for (const Ball& ball : options.balls) {
        const Eigen::Vector3d& at = ball.centreM;
        key += text(" ball ", at.x(), " ", at.y(), " ", at.z(), " ", ball.radiusM);
    }
    for (const PlacedMesh& mesh : options.meshes) {
        const Eigen::Vector3d& at = mesh.footM;
        key += text(" ", mesh.mesh->fingerprint(), " ", at.x(), " ", at.y(), " ", at.z(), " ", mesh.sizeM,
                    " ", mesh.yaw.value(), " ", int{mesh.colour[0]}, " ", int{mesh.colour[1]}, " ",
                    int{mesh.colour[2]});
    }
    key += options.lightsBalls ? " lit" : "";
    key += options.sensor ? text(" ", sensorYaml(*options.sensor)) : "";
    key += options.writesDepth ? " depth" : "";
    key += options.writesLabels ? " labels" : "";
    return sha256Hex(bytesOf(key + "\n" + tumText(camera.path)));
}

void writePoses(const std::vector<dataset::PoseFormat>& formats, const WalkCamera& camera,
                const std::filesystem::path& folder) {
    std::vector<dataset::PosedFrame> frames;
    for (std::size_t i = 0; i < camera.path.size(); ++i) {
        frames.push_back({frameName(i), camera.path[i].timeS, camera.path[i].roomFromCamera});
    }
    for (const dataset::PoseFormat format : formats) {
        writePoseFiles(format, camera.intrinsics, frames, folder);
    }
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

/// What a walk's frames have shown so far.
struct WalkTally {
    WalkReport report;
    std::set<std::size_t> photos;
    std::vector<double> renderMs;
    std::vector<double> decodeMs;

    void add(const render::ViewReport& frame) {
        photos.insert(frame.photo);
        renderMs.push_back(frame.renderMs);
        if (frame.decodeMs > 0) {
            decodeMs.push_back(frame.decodeMs);
        }
        report.worstOffsetM = std::max(report.worstOffsetM, frame.offsetM);
        report.leastTrust = std::min(report.leastTrust, frame.trust);
    }
};

/// One camera of a walk, with its files.
class CameraWalk {
  public:
    /// Owner: the renderer, the camera and the lights must outlive the walk. Errors: those of making folders.
    CameraWalk(const render::Renderer& renderer, const WalkCamera& camera, const WalkOptions& options,
               const std::vector<BallLight>& lights, const fs::path& folder)
        : m_renderer(renderer),
          m_camera(camera),
          m_model(camera.intrinsics),
          m_options(options),
          m_folder(folder),
          m_journal(madeFolder(options, folder), walkKey(renderer.dataset().info(), camera, options),
                    options.shard),
          m_frames(renderer, m_model, camera.path, m_options, lights) {}

    /// isOwn: whether the frame is of this part, or was before. Returns whether it was made.
    bool take(std::size_t frame, bool isOwn, WalkTally& tally);

    /// Whether the frames of all parts are there.
    bool isComplete() {
        m_journal.refresh(); // other parts may have been rendered meanwhile
        bool isComplete = true;
        for (std::size_t frame = 0; isComplete && frame < m_camera.path.size(); ++frame) {
            isComplete = isThere(frame);
        }
        return isComplete;
    }

    /// Writes what is written once all frames are there, but for bags.
    void finish() const;

    WalkPictures pictures() const {
        const std::size_t count = m_camera.path.size();
        return {frameFiles(count, m_folder),
                m_options.writesDepth ? frameFiles(count, m_folder / kDepthFolder) : std::vector<fs::path>(),
                m_options.writesLabels ? frameFiles(count, m_folder / kLabelsFolder)
                                       : std::vector<fs::path>()};
    }

    const render::StreamCounters& counters() const { return m_frames.counters(); }

  private:
    static const fs::path& madeFolder(const WalkOptions& options, const fs::path& folder) {
        for (const fs::path& pictures : pictureFoldersOf(options, folder)) {
            ensureFolder(pictures);
        }
        return folder;
    }

    bool isThere(std::size_t frame) const {
        const std::vector<fs::path> folders = pictureFoldersOf(m_options, m_folder);
        return m_journal.frames().contains(frame) &&
               std::all_of(folders.begin(), folders.end(),
                           [&](const fs::path& of) { return fs::exists(of / frameName(frame)); });
    }

    const render::Renderer& m_renderer;
    const WalkCamera& m_camera;
    CameraModel m_model;
    WalkOptions m_options;
    fs::path m_folder;
    WalkJournal m_journal;
    WalkFrames m_frames;
};

bool CameraWalk::take(std::size_t frame, bool isOwn, WalkTally& tally) {
    const TimedPose& pose = m_camera.path[frame];
    if (isOwn) {
        ++tally.report.frames;
        tally.report.outside += m_renderer.dataset().isOutside(pose.roomFromCamera.translation) ? 1 : 0;
    }
    if (!isOwn || isThere(frame)) {
        tally.report.reused += isOwn ? 1 : 0;
        m_frames.pass(frame); // a frame has the same photos in any part
        return false;
    }
    const render::View& view = m_frames.make(frame);
    photo::writePng(m_folder / frameName(frame), view.picture);
    if (m_options.writesDepth) {
        photo::writePng(m_folder / kDepthFolder / frameName(frame), render::depthMillimetres(view.depth));
    }
    if (m_options.writesLabels) {
        photo::writePng(m_folder / kLabelsFolder / frameName(frame), view.labels);
    }
    m_journal.add(frame, linesOf(pose, view.report, m_frames.sensorReport()));
    tally.add(view.report);
    return true;
}

void CameraWalk::finish() const {
    std::string index = text(kColumns, m_options.sensor ? kSensorColumns : "", "\n");
    std::string times = text(kTimeColumns, "\n");
    for (const auto& [frame, lines] : m_journal.frames()) {
        index += text(frameName(frame), ",", lines.what, "\n");
        times += text(frameName(frame), ",", lines.times, "\n");
    }
    writeFile(m_folder / "index.csv", bytesOf(index));
    writeFile(m_folder / "times.csv", bytesOf(times));
    writePoses(m_options.formats, m_camera, m_folder);
    if (m_options.writesLabels) {
        const Json json = annotations(m_model, m_camera.path, m_options, pictures().labels);
        writeFile(m_folder / "annotations.json", bytesOf(json.dump(1) + "\n"));
    }
    const std::size_t count = m_camera.path.size();
    const std::size_t sheetStep = std::max<std::size_t>(1, (count + kSheetCells - 1) / kSheetCells);
    std::vector<RgbImage> sheet;
    for (std::size_t i = 0; i < count; i += sheetStep) {
        sheet.push_back(photo::readPicture(m_folder / frameName(i)));
    }
    photo::writePng(m_folder / "contact-sheet.png",
                    photo::contactSheet(sheet, kSheetColumns, kSheetCellWidth));
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

void requirePossible(const std::vector<TimedPose>& path, const WalkOptions& options) {
    if (!options.bags.empty()) {
        requireRosTimes(path);
    }
    if (options.sensor) {
        requireAscendingTimes(path);
    }
    if (options.writesLabels && options.balls.empty() && options.meshes.empty()) {
        throw Error(ErrorKind::InvalidInput, "Labels tell which pixels show an object: lay one into the "
                                             "frames, by --ball or --object.");
    }
}

/// The light at each ball's place; none if balls are not lit.
std::vector<BallLight> lightsOf(const render::Renderer& renderer, const WalkOptions& options) {
    std::vector<BallLight> lights;
    for (const Ball& ball : options.balls) {
        if (options.lightsBalls) {
            lights.emplace_back(renderer, ball, options.view);
        }
    }
    return lights;
}

/// Of a rig's camera.
WalkOptions optionsOf(const WalkOptions& options, std::size_t camera) {
    WalkOptions own = options;
    if (own.sensor) {
        own.sensor = own.sensor->ofCamera(camera);
    }
    return own;
}

} // namespace

WalkReport walk(const render::Renderer& renderer, const std::vector<WalkCamera>& cameras,
                const WalkOptions& options, const std::filesystem::path& folder, ProgressSink& progress,
                const std::stop_token& stop) {
    const std::vector<TimedPose>& path = cameras.front().path;
    requirePossible(path, options);
    ensureFolder(folder);
    const std::vector<BallLight> lights = lightsOf(renderer, options);
    std::deque<CameraWalk> walks;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        walks.emplace_back(renderer, cameras[i], optionsOf(options, i), lights,
                           cameras[i].name.empty() ? folder : folder / cameras[i].name);
    }
    WalkTally tally;
    const auto [begin, end] = options.shard.range(path.size());
    for (std::size_t i = 0; i < end; ++i) {
        bool isMade = false;
        for (CameraWalk& camera : walks) {
            throwIfStopped(stop);
            isMade = camera.take(i, i >= begin, tally) || isMade;
        }
        if (isMade) {
            progress.progress(static_cast<double>(i + 1 - begin) / static_cast<double>(end - begin),
                              "Rendering the walk");
        }
    }
    WalkReport& report = tally.report;
    report.isComplete =
        std::all_of(walks.begin(), walks.end(), [](CameraWalk& camera) { return camera.isComplete(); });
    if (report.isComplete) {
        std::vector<WalkPictures> pictures;
        for (const CameraWalk& camera : walks) {
            camera.finish();
            pictures.push_back(camera.pictures());
        }
        for (const dataset::BagFormat format : options.bags) {
            writeWalkBag(format, options.bagPictures, cameras, pictures,
                         folder / text("walk.", extension(format)));
        }
    }
    for (const CameraWalk& camera : walks) {
        report.stream += camera.counters();
    }
    report.photosUsed = tally.photos.size();
    report.load = renderer.counters();
    report.medianRenderMs = median(tally.renderMs);
    report.medianDecodeMs = median(tally.decodeMs);
    return report;
}

} // namespace spherewalk::jobs
