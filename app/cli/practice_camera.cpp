// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/practice/practice_camera.h"

#include "command.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/positions_csv.h"

#include <memory>

namespace spherewalk::cli {

namespace {

struct Options {
    practice::PracticeCameraOptions camera;
    std::string photos;
    std::string positions;
    std::uint64_t seed = 1;
};

practice::PracticeCameraOptions cameraOptions(const Options& options) {
    practice::PracticeCameraOptions camera = options.camera;
    camera.seed = options.seed;
    camera.errors.seed = options.seed;
    if (options.photos.empty() != options.positions.empty()) {
        throw Error(ErrorKind::InvalidInput, "To serve photos, give both --photos and --positions.");
    }
    if (!options.photos.empty()) {
        camera.photoFolder = options.photos;
        for (const jobs::PhotoPosition& position : jobs::readPositions(options.positions)) {
            camera.photos.push_back({position.file, position.positionM, position.roomFromPhoto});
        }
    }
    return camera;
}

Result serve(const Options& options, Context& context) {
    practice::PracticeCamera camera(cameraOptions(options));
    camera.start();
    context.progress.warning(text("The practice camera listens at ", camera.url(),
                                  "; Ctrl-C ends it. Its truth is in ", camera.truthFile().string(), "."));
    while (systemClock().sleep(std::chrono::hours(1), context.stop)) {
    }
    camera.stop();
    const practice::PracticeCameraStats stats = camera.stats();
    return {{{"exposures", stats.exposures}, {"commands", stats.commands}},
            text("The practice camera took ", stats.exposures, " pictures.")};
}

} // namespace

void addPracticeCamera(Commands& commands) {
    const auto options = std::make_shared<Options>();
    options->camera.port = 8080;
    options->camera.timeScale = 1;
    practice::PracticeCameraOptions& camera = options->camera;
    CLI::App& command =
        commands.add("practice-camera", "Run an emulated Theta V that photographs a practice room",
                     [options](Context& context) { return serve(*options, context); });
    command.add_option("--port", camera.port, "TCP port; 0: any that is free")->capture_default_str();
    command.add_option("--time-scale", camera.timeScale, "Of the camera's own times; 0: as fast as possible")
        ->check(CLI::Range(0.0, 100.0))
        ->capture_default_str();
    command.add_option("--width", camera.width, "Of the photos, pixels")->capture_default_str();
    command.add_option("--seed", options->seed, "Of the errors in yaw, tilt, and position")
        ->capture_default_str();
    command.add_option("--storage", camera.storageFolder,
                       "Folder of the camera's memory; default: a temporary one");
    command.add_option("--truth", camera.truthFile, "File for the truth about every picture");
    command.add_option("--photos", options->photos,
                       "Serve these photos, by position, in place of the practice room");
    command.add_option("--positions", options->positions, "CSV of their positions, as for import");
}

} // namespace spherewalk::cli
