// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/walk.h"

#include "parts/cache_key.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/base/text.h"
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

constexpr EnumNames<BagPictures, 2> kBagPictures{{{BagPictures::Raw, "raw"}, {BagPictures::Png, "png"}}};
constexpr const char* kRoomFrame = "map"; // REP 105
constexpr const char* kCameraFrame = "camera_optical";

void requireRosTimes(const std::vector<TimedPose>& path) {
    for (const TimedPose& pose : path) {
        dataset::rosStampNs(pose.timeS);
    }
}

void writeWalkBag(dataset::BagFormat format, BagPictures pictures, const CameraIntrinsics& camera,
                  const std::vector<TimedPose>& path, const std::vector<std::filesystem::path>& frames,
                  const std::filesystem::path& file) {
    using dataset::RosType;
    const dataset::Ros ros = messagesOf(format);
    const bool isRaw = pictures == BagPictures::Raw;
    const Calibration calibrated = calibration(camera);
    const std::unique_ptr<dataset::Bag> bag = makeBag(format, file);
    const std::size_t picture = isRaw
                                    ? bag->addTopic("/camera/image_raw", RosType::Image)
                                    : bag->addTopic("/camera/image_raw/compressed", RosType::CompressedImage);
    const std::size_t cameraInfo = bag->addTopic("/camera/camera_info", RosType::CameraInfo);
    const std::size_t pose = bag->addTopic("/camera/pose", RosType::PoseStamped);
    const std::size_t tf = bag->addTopic("/tf", RosType::TfMessage);
    for (std::size_t i = 0; i < path.size(); ++i) {
        const std::int64_t stampNs = dataset::rosStampNs(path[i].timeS);
        const dataset::RosHeader inCamera{static_cast<std::uint32_t>(i), stampNs, kCameraFrame};
        const dataset::RosHeader inRoom{static_cast<std::uint32_t>(i), stampNs, kRoomFrame};
        const Rigid3& roomFromCamera = path[i].roomFromCamera;
        bag->write(tf, stampNs, tfMessage(ros, inRoom, kCameraFrame, roomFromCamera));
        bag->write(pose, stampNs, poseMessage(ros, inRoom, roomFromCamera));
        bag->write(cameraInfo, stampNs, cameraInfoMessage(ros, inCamera, calibrated));
        bag->write(picture, stampNs,
                   isRaw ? imageMessage(ros, inCamera, photo::readPicture(frames[i]))
                         : pngMessage(ros, inCamera, readFile(frames[i])));
    }
    bag->finish();
}

constexpr std::size_t kSheetCells = 24;
constexpr int kSheetColumns = 6;
constexpr int kSheetCellWidth = 320;
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

FrameLines linesOf(const TimedPose& pose, const render::ViewReport& report) {
    const Eigen::Vector3d& t = pose.roomFromCamera.translation;
    const Eigen::Quaterniond& q = pose.roomFromCamera.rotation;
    return {text(pose.timeS, ",", t.x(), ",", t.y(), ",", t.z(), ",", q.x(), ",", q.y(), ",", q.z(), ",",
                 q.w(), ",", report.file, ",", report.offsetM, ",", name(report.scene), ",",
                 name(report.sampling), ",", fixed(report.parallaxPx, 3), ",", fixed(report.trust, 4)),
            text(fixed(report.decodeMs, 3), ",", fixed(report.renderMs, 3), ",", name(report.origin), ",",
                 report.isLate ? 1 : 0)};
}

/// Of all that the frames depend on.
std::string walkKey(const render::DatasetInfo& info, const CameraModel& camera,
                    const std::vector<TimedPose>& path, const WalkOptions& options) {
    std::string key =
        text("walk ", kWalkMethod, "\n", render::toJson(info).dump(), "\n", keyOf(camera.intrinsics()));
    key += text("\n", options.view.scene ? name(*options.view.scene) : "auto", " ",
                name(options.view.sampling), " ", name(options.stream.late));
    if (options.ball) {
        const Eigen::Vector3d& at = options.ball->centreM;
        key += text(" ball ", at.x(), " ", at.y(), " ", at.z(), " ", options.ball->radiusM);
    }
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

/// What is written once all frames are there.
void finish(const WalkJournal& journal, const CameraModel& camera, const std::vector<TimedPose>& path,
            const WalkOptions& options, const std::filesystem::path& folder) {
    std::string index = text(kColumns, "\n");
    std::string times = text(kTimeColumns, "\n");
    for (const auto& [frame, lines] : journal.frames()) {
        index += text(frameName(frame), ",", lines.what, "\n");
        times += text(frameName(frame), ",", lines.times, "\n");
    }
    writeFile(folder / "index.csv", bytesOf(index));
    writeFile(folder / "times.csv", bytesOf(times));
    writePoses(options.formats, camera, path, folder);
    for (const dataset::BagFormat format : options.bags) {
        writeWalkBag(format, options.bagPictures, camera.intrinsics(), path, frameFiles(path.size(), folder),
                     folder / text("walk.", extension(format)));
    }
    const std::size_t sheetStep = std::max<std::size_t>(1, (path.size() + kSheetCells - 1) / kSheetCells);
    std::vector<RgbImage> sheet;
    for (std::size_t i = 0; i < path.size(); i += sheetStep) {
        sheet.push_back(photo::readPicture(folder / frameName(i)));
    }
    photo::writePng(folder / "contact-sheet.png", photo::contactSheet(sheet, kSheetColumns, kSheetCellWidth));
}

} // namespace

BagPictures bagPictures(std::string_view name) {
    return valueOf(kBagPictures, "The kind of a bag's pictures", name);
}

WalkReport walk(const render::Renderer& renderer, const CameraModel& camera,
                const std::vector<TimedPose>& path, const WalkOptions& options,
                const std::filesystem::path& folder, ProgressSink& progress, const std::stop_token& stop) {
    if (!options.bags.empty()) {
        requireRosTimes(path);
    }
    ensureFolder(folder);
    WalkJournal journal(folder, walkKey(renderer.dataset().info(), camera, path, options), options.shard);
    const auto isThere = [&](std::size_t frame) {
        return journal.frames().contains(frame) && std::filesystem::exists(folder / frameName(frame));
    };
    render::ViewStream stream(renderer, camera, options.stream);
    render::ViewOptions frame = options.view;
    std::vector<render::Overlay> overlays; ///< that the frame's options point to
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
            stream.pass(path[i].roomFromCamera, frame); // a frame has the same photos in any part
            continue;
        }
        if (options.ball) {
            overlays = {ballOverlay(*options.ball, camera, path[i].roomFromCamera)};
            frame.overlays = overlays;
        }
        const render::View view = stream.next(path[i].roomFromCamera, path[i].timeS, frame);
        photo::writePng(folder / frameName(i), view.picture);
        journal.add(i, linesOf(path[i], view.report));
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
    report.stream = stream.counters();
    report.load = renderer.counters();
    report.medianRenderMs = median(renderMs);
    report.medianDecodeMs = median(decodeMs);
    return report;
}

Json toJson(const render::ViewReport& report) {
    return {{"photo", report.file},
            {"offset_m", report.offsetM},
            {"scene", name(report.scene)},
            {"sampling", name(report.sampling)},
            {"origin", name(report.origin)},
            {"late", report.isLate},
            {"trust", report.trust},
            {"outside", report.isOutside},
            {"sees_place", report.seesPlace},
            {"seen_share", report.seenShare},
            {"filled_share", report.filledShare},
            {"parallax_px", report.parallaxPx},
            {"blur_px", report.blurPx},
            {"decode_ms", report.decodeMs},
            {"decoded_tiles", report.decodedTiles},
            {"whole_decode", report.isWholeDecode},
            {"verified", report.isVerified},
            {"render_ms", report.renderMs}};
}

Json toJson(const render::LoadCounters& counters) {
    return {{"hits", counters.hits},
            {"late", counters.late},
            {"waits", counters.waits},
            {"decoded_tiles", counters.decodedTiles},
            {"prefetched_tiles", counters.prefetchedTiles},
            {"dropped_tiles", counters.droppedTiles},
            {"whole_decodes", counters.wholeDecodes},
            {"prefetch_errors", counters.prefetchErrors},
            {"decode_ms", counters.decodeMs},
            {"prefetch_ms", counters.prefetchMs},
            {"resident_bytes", counters.residentBytes}};
}

Json toJson(const WalkReport& report) {
    return {{"frames", report.frames},
            {"reused_frames", report.reused},
            {"complete", report.isComplete},
            {"photos_used", report.photosUsed},
            {"median_render_ms", report.medianRenderMs},
            {"median_decode_ms", report.medianDecodeMs},
            {"worst_offset_m", report.worstOffsetM},
            {"least_trust", report.leastTrust},
            {"outside", report.outside},
            {"late", report.stream.late},
            {"waited", report.stream.waited},
            {"coarse", report.stream.coarse},
            {"previous", report.stream.previous},
            {"load", toJson(report.load)}};
}

} // namespace spherewalk::jobs
