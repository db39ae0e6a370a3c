// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/camera_options.h"
#include "options/command.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/camera/capture.h"
#include "spherewalk/camera/capture_journal.h"
#include "spherewalk/camera/discovery.h"
#include "spherewalk/jobs/capture_survey.h"

#include <filesystem>
#include <memory>

namespace spherewalk::cli {

namespace {

/// The journal of one picture that belongs to no survey: the steps are kept in memory only, and the picture
/// is put where the user wants it.
class SingleShot : public camera::CaptureJournal {
  public:
    explicit SingleShot(std::filesystem::path out) : m_out(std::move(out)) {}

    survey::Shot begin(std::int64_t station, const std::string& cameraSerial,
                       const survey::Baseline& baseline) override;
    void started(std::int64_t shot, const std::string& commandId) override;
    void taken(std::int64_t shot, const std::string& fileUrl) override;
    void notTaken(std::int64_t shot) override;
    void unclear(std::int64_t shot, const std::string& why, const std::string& fileUrl) override;
    survey::Shot downloaded(std::int64_t shot, const camera::DownloadedPhoto& photo) override;
    std::vector<survey::Shot> openShots() const override;
    std::filesystem::path downloadFolder() const override;

  private:
    std::filesystem::path m_out;
    survey::Shot m_shot;
};

using survey::ShotStep;

survey::Shot SingleShot::begin(std::int64_t station, const std::string& cameraSerial,
                               const survey::Baseline& baseline) {
    m_shot = {};
    m_shot.id = 1;
    m_shot.station = station;
    m_shot.intendedAt = std::chrono::system_clock::now();
    m_shot.cameraSerial = cameraSerial;
    m_shot.baseline = baseline;
    return m_shot;
}

void SingleShot::started(std::int64_t /*shot*/, const std::string& commandId) {
    m_shot.step = ShotStep::Started;
    m_shot.commandId = commandId;
}

void SingleShot::taken(std::int64_t /*shot*/, const std::string& fileUrl) {
    m_shot.step = ShotStep::Taken;
    m_shot.fileUrl = fileUrl;
}

void SingleShot::notTaken(std::int64_t /*shot*/) {
    m_shot.step = ShotStep::NotTaken;
}

void SingleShot::unclear(std::int64_t /*shot*/, const std::string& why, const std::string& /*fileUrl*/) {
    m_shot.step = ShotStep::Unclear;
    m_shot.note = why;
}

survey::Shot SingleShot::downloaded(std::int64_t /*shot*/, const camera::DownloadedPhoto& photo) {
    std::filesystem::rename(photo.temporaryFile, m_out);
    m_shot.step = ShotStep::Downloaded;
    return m_shot;
}

std::vector<survey::Shot> SingleShot::openShots() const {
    const bool isOpen = m_shot.id != 0 && m_shot.step <= ShotStep::Taken;
    return isOpen ? std::vector<survey::Shot>{m_shot} : std::vector<survey::Shot>{};
}

std::filesystem::path SingleShot::downloadFolder() const {
    return m_out.has_parent_path() ? m_out.parent_path() : std::filesystem::path(".");
}

struct CameraArguments {
    CameraOptions camera;
    int count = 20;
    std::string out;
};

Result cameraInfo(const CameraArguments& options, Context& context) {
    const camera::CameraInfo info = options.camera.client(context.stop)->info(context.stop);
    const std::string levels = Json(info.apiLevels).dump();
    return {{{"manufacturer", info.manufacturer},
             {"model", info.model},
             {"serial_number", info.serialNumber},
             {"firmware_version", info.firmwareVersion},
             {"api_levels", info.apiLevels},
             {"uptime_s", info.uptimeS ? Json(*info.uptimeS) : Json()}},
            text(info.model, ", serial number ", info.serialNumber, ", firmware ", info.firmwareVersion,
                 ", API levels ", levels)};
}

Result cameraState(const CameraArguments& options, Context& context) {
    const camera::CameraState state = options.camera.client(context.stop)->state(context.stop);
    const std::string battery =
        state.batteryFraction ? text(fixed(100 * *state.batteryFraction, 0), " %") : "unknown";
    std::string words = text("battery ", battery, ", ", state.isIdle() ? "idle" : state.captureStatus);
    for (const std::string& error : state.errors) {
        words += text("; ", camera::describeCameraError(error).sentence);
    }
    return {{{"battery", state.batteryFraction ? Json(*state.batteryFraction) : Json()},
             {"capture_status", state.captureStatus},
             {"latest_file_url", state.latestFileUrl},
             {"errors", state.errors}},
            words};
}

Result photosOnCamera(const CameraArguments& options, Context& context) {
    camera::FileQuery query;
    query.entryCount = options.count;
    const std::unique_ptr<camera::OscClient> client = options.camera.client(context.stop);
    client->info(context.stop); // which says how it lists
    const camera::FileList files = client->listFiles(query, context.stop);
    Json entries = Json::array();
    std::string lines = text(files.totalEntries, " photos on the camera");
    for (const camera::FileEntry& entry : files.entries) {
        entries.push_back({{"name", entry.name},
                           {"url", entry.fileUrl},
                           {"size_bytes", entry.sizeBytes ? Json(*entry.sizeBytes) : Json()},
                           {"taken", entry.dateTime}});
        lines += text("\n", entry.name, "  ", entry.sizeBytes ? humanBytes(*entry.sizeBytes) : "", "  ",
                      entry.dateTime);
    }
    return {{{"total", files.totalEntries}, {"files", entries}}, lines};
}

Result shootOnce(const CameraArguments& options, Context& context) {
    const auto client = options.camera.client(context.stop);
    camera::CaptureOptions capture = options.camera.captureOptions();
    capture.download.check = jobs::photoCheck();
    SingleShot journal(options.out);
    camera::Capture workflow(*client, journal, systemClock(), capture);
    const camera::ShotOutcome outcome = workflow.shoot(0, context.stop);
    for (const std::string& sentence : workflow.disconnect(context.stop)) {
        context.progress.warning(sentence);
    }
    if (outcome.shot.step != survey::ShotStep::Downloaded) {
        throw Error(outcome.problem.value_or(ErrorKind::Io), outcome.sentence);
    }
    const camera::DownloadedPhoto& photo = outcome.photo.value();
    return {{{"out", options.out}, {"url", photo.fileUrl}, {"width", photo.width}, {"height", photo.height}},
            text("Wrote ", options.out, ": ", photo.width, " x ", photo.height, " pixels, ",
                 humanBytes(photo.sizeBytes), ".")};
}

Result findCameras(Context& context) {
    const camera::FindReport report = camera::findCameras({}, context.stop);
    Json cameras = Json::array();
    std::string words;
    for (const camera::FoundCamera& found : report.cameras) {
        const std::string address = found.place.endpoint.name();
        cameras.push_back({{"address", address},
                           {"why", found.place.why},
                           {"model", found.info.model},
                           {"serial_number", found.info.serialNumber}});
        words += text(words.empty() ? "" : "\n", address, "  ", printable(found.info.model),
                      ", serial number ", printable(found.info.serialNumber), " (", found.place.why, ")");
    }
    if (report.cameras.empty()) {
        words = "No camera answers at";
        for (const camera::CameraPlace& place : report.silent) {
            words += text(&place == report.silent.data() ? " " : " or ", place.endpoint.name());
        }
        words += ". Switch the camera on, connect this computer to its WiFi, and look again.";
    }
    if (!report.note.empty()) {
        context.progress.warning(report.note);
    }
    return {{{"cameras", cameras}, {"note", report.note}}, words, !report.cameras.empty()};
}

} // namespace

void addCamera(Commands& commands) {
    const program::Command group =
        commands.addGroup("camera", "Find or ask a camera, or take one picture with it");
    commands.addFlag(group, "--find",
                     "Look where cameras usually are, and for those that announce themselves", findCameras);
    const auto options = std::make_shared<CameraArguments>();
    const auto add = [&](const std::string& name, const std::string& help, auto run) {
        const program::Command command = commands.add(
            group, name, help, [options, run](Context& context) { return run(*options, context); });
        options->camera.declare(command);
        return command;
    };
    add("info", "Who the camera is", cameraInfo);
    add("state", "How the camera is", cameraState);
    add("list", "The newest photos on the camera", photosOnCamera)
        .option("--count", options->count, "How many")
        .range(1, 1000)
        .showDefault();
    add("shoot", "Take one picture", shootOnce).option("--out", options->out, "File to write").required();
}

} // namespace spherewalk::cli
