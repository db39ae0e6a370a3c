// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera_options.h"
#include "command.h"
#include "single_shot.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/camera/capture.h"
#include "spherewalk/camera/discovery.h"
#include "spherewalk/jobs/capture_survey.h"

#include <memory>

namespace spherewalk::cli {

namespace {

struct Options {
    CameraOptions camera;
    int count = 20;
    std::string out;
};

Result info(const Options& options, Context& context) {
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

Result state(const Options& options, Context& context) {
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

Result list(const Options& options, Context& context) {
    camera::FileQuery query;
    query.entryCount = options.count;
    const camera::FileList files = options.camera.client(context.stop)->listFiles(query, context.stop);
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

Result shoot(const Options& options, Context& context) {
    const auto client = options.camera.client(context.stop);
    camera::CaptureOptions capture = options.camera.captureOptions();
    capture.download.check = jobs::photoCheck();
    SingleShot journal(options.out);
    camera::Capture workflow(*client, journal, systemClock(), capture);
    const camera::ShotOutcome outcome = workflow.shoot(0, context.stop);
    workflow.disconnect(context.stop);
    if (outcome.shot.step != camera::ShotStep::Downloaded) {
        throw Error(outcome.problem.value_or(ErrorKind::Io), outcome.sentence);
    }
    const camera::DownloadedPhoto& photo = outcome.photo.value();
    return {{{"out", options.out}, {"url", photo.fileUrl}, {"width", photo.width}, {"height", photo.height}},
            text("Wrote ", options.out, ": ", photo.width, " x ", photo.height, " pixels, ",
                 humanBytes(photo.sizeBytes), ".")};
}

Result find(Context& context) {
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
    CLI::App& group = commands.addGroup("camera", "Find or ask a camera, or take one picture with it");
    commands.addFlag(group, "--find",
                     "Look where cameras usually are, and for those that announce themselves", find);
    const auto options = std::make_shared<Options>();
    const auto add = [&](const std::string& name, const std::string& description, auto run) -> CLI::App& {
        CLI::App& command = commands.add(
            name, description, [options, run](Context& context) { return run(*options, context); }, &group);
        options->camera.declare(command);
        return command;
    };
    add("info", "Who the camera is", info);
    add("state", "How the camera is", state);
    add("list", "The newest photos on the camera", list)
        .add_option("--count", options->count, "How many")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    add("shoot", "Take one picture", shoot).add_option("--out", options->out, "File to write")->required();
}

} // namespace spherewalk::cli
