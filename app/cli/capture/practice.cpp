// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/command.h"
#include "program/render_options.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/demo.h"
#include "spherewalk/jobs/positions_csv.h"
#include "spherewalk/jobs/practice_pictures.h"
#include "spherewalk/practice/practice_camera.h"
#include "spherewalk/render/camera_info.h"

#include <memory>

namespace spherewalk::cli {

namespace {

/// The practice room that is photographed.
struct RoomArguments {
    std::string style = "lively";
    int tags = 0;
    double tagSizeM = practice::PracticeTag().sizeM;
    std::string tagsTruth;
};

struct PracticeArguments {
    practice::PracticeCameraOptions camera;
    std::string photos;
    std::string positions;
    std::uint64_t seed = 1;
    RoomArguments room;
    std::string model = "theta-v";
    bool isReal = false;
    double tiltDeg = Degrees(practice::PhotoErrors().tiltSigma).value();
};

constexpr EnumNames<practice::RoomStyle, 3> kRooms{{{practice::RoomStyle::Lively, "lively"},
                                                    {practice::RoomStyle::Bare, "bare"},
                                                    {practice::RoomStyle::Flat, "flat"}}};

constexpr EnumNames<practice::CameraModel, 3> kModels{{{practice::CameraModel::ThetaV, "theta-v"},
                                                       {practice::CameraModel::ThetaS, "theta-s"},
                                                       {practice::CameraModel::LevelOne, "level-one"}}};

/// Hangs tags on the walls, and writes where their corners are.
void hangTags(const RoomArguments& options, practice::PracticeRoomOptions& room) {
    room.tags = practice::tagsOnWalls(practice::PracticeRoom(room), options.tags, options.tagSizeM);
    if (room.tags.size() < static_cast<std::size_t>(options.tags)) {
        throw Error(ErrorKind::InvalidInput,
                    text("The practice room's walls have room for ", room.tags.size(), " such tags, not for ",
                         options.tags, "."));
    }
    if (!options.tagsTruth.empty()) {
        Json list = Json::array();
        for (const practice::PracticeTag& tag : room.tags) {
            Json corners = Json::array();
            for (const Eigen::Vector3d& corner : tag.cornersM()) {
                corners.push_back({corner.x(), corner.y(), corner.z()});
            }
            list.push_back({{"number", tag.number}, {"size_m", tag.sizeM}, {"corners_m", corners}});
        }
        writeFile(options.tagsTruth, bytesOf(list.dump(2) + "\n"));
    }
}

practice::PracticeRoomOptions roomOptions(const RoomArguments& options) {
    practice::PracticeRoomOptions room;
    room.style = valueOf(kRooms, "The practice room", options.style);
    if (room.style == practice::RoomStyle::Flat) {
        room.sizeM = {8, 6, 2.5};
    }
    if (options.tags > 0) {
        hangTags(options, room);
    }
    return room;
}

void declareRoom(const program::Command& command, RoomArguments& options) {
    command
        .option("--room", options.style,
                "What is photographed: lively, bare (white walls, glass), or flat (two rooms)")
        .showDefault();
    const program::Option tags =
        command.option("--tags", options.tags, "Number of AprilTags (36h11) that hang on the walls")
            .range(0, 100)
            .showDefault();
    command.option("--tag-size", options.tagSizeM, "Side of their black square, metres")
        .range(0.02, 1.0)
        .showDefault()
        .needs(tags);
    command.option("--tags-truth", options.tagsTruth, "JSON file for where the tags' corners are")
        .needs(tags);
}

practice::PracticeCameraOptions cameraOptions(const PracticeArguments& options) {
    practice::PracticeCameraOptions camera = options.camera;
    camera.seed = options.seed;
    camera.errors.seed = options.seed;
    camera.errors.tiltSigma = Degrees(options.tiltDeg);
    camera.model = valueOf(kModels, "The practice camera's model", options.model);
    camera.room = roomOptions(options.room);
    if (options.isReal) {
        camera.flaws = practice::PhotoFlaws::ofARealCamera(options.seed);
    }
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

Result servePractice(const PracticeArguments& options, Context& context) {
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

struct PicturesArguments {
    std::string out;
    std::string camera;
    std::string path;
    std::string frame = "optical";
    RoomArguments room;
};

Result drawPictures(const PicturesArguments& options, Context& context) {
    std::vector<TimedPose> path = readTum(options.path);
    for (TimedPose& pose : path) {
        pose.roomFromCamera = program::opticalPose(pose.roomFromCamera, options.frame);
    }
    const CameraModel camera(render::readCameraInfo(options.camera));
    jobs::drawPracticePictures(practice::PracticeRoom(roomOptions(options.room)), camera, path, options.out,
                               context.progress, context.stop);
    return {{{"pictures", path.size()}, {"table", options.out + "/pictures.csv"}},
            text("Drew ", path.size(), " pictures with their depths. Give ", options.out,
                 "/pictures.csv to measure or compare as --pictures.")};
}

struct DemoArguments {
    std::string out;
    std::string scene = "auto";
    jobs::DemoOptions demo;
};

Result runDemo(const DemoArguments& options, Context& context) {
    jobs::DemoOptions demo = options.demo;
    if (options.scene != "auto") {
        demo.scene = render::sceneKind(options.scene);
    }
    const jobs::DemoReport report = jobs::demo(options.out, demo, context.progress, context.stop);
    const auto seconds = [](double s) { return humanDuration(std::chrono::duration<double>(s)); };
    return {
        jobs::toJson(report),
        text(
            "A practice room was planned, photographed over HTTP, aligned, exported, and walked through.\n\n",
            "In ", options.out, ":\n", "  practice-room.spherewalk  the survey: ", report.capture.stations,
            " stations on ", report.placements, " rail placements, ", report.capture.taken, " photos in ",
            seconds(report.capture.seconds), "\n", "  dataset                   for simulators: ",
            humanBytes(report.exported.written.totalBytes), "\n", "  walk                      ",
            report.walk.frames, " views of a robot's camera, index.csv, contact-sheet.png; ",
            fixed(report.walk.medianRenderMs, 1), " ms a view\n",
            "  comparison.png            views beside exact pictures: ", fixed(report.atPhotosDb, 1),
            " dB at photos, ", fixed(report.betweenDb, 1), " dB between them with the scene model ",
            name(report.scene), " (", fixed(report.betweenWithSphereDb, 1), " with the sphere; medians)\n",
            "  robot.yaml, path.tum      the robot's camera and its path\n",
            "  truth.jsonl               where the practice camera really was\n\n",
            "The photos' rotations were solved from the pictures: ", report.alignmentError.photos, " of ",
            report.capture.stations, " photos, off by ", fixed(report.alignmentError.yawRmsDeg, 3),
            " deg in yaw and ", fixed(report.alignmentError.tiltRmsDeg, 3), " in tilt (root mean square).\n",
            report.choice ? report.choice->reason + "\n" : "", "Look around:  spherewalk-cli view ",
            options.out, "/dataset --camera ", options.out,
            "/robot.yaml --frame body --pose \"2.5 2 1.2 0 0 0 1\" --out view.png")};
}

} // namespace

void addPracticeCamera(Commands& commands) {
    const auto options = std::make_shared<PracticeArguments>();
    options->camera.port = 8080;
    options->camera.timeScale = 1;
    practice::PracticeCameraOptions& camera = options->camera;
    const program::Command command =
        commands.add("practice-camera", "Run an emulated Theta that photographs a practice room",
                     [options](Context& context) { return servePractice(*options, context); });
    command.option("--port", camera.port, "TCP port; 0: any that is free").showDefault();
    command.option("--time-scale", camera.timeScale, "Of the camera's own times; 0: as fast as possible")
        .range(0.0, 100.0)
        .showDefault();
    command.option("--width", camera.width, "Of the photos, pixels").showDefault();
    command.option("--seed", options->seed, "Of the errors in yaw, tilt, and position").showDefault();
    declareRoom(command, options->room);
    command
        .option("--model", options->model,
                "What it speaks: theta-v (API level 2), theta-s (1, then 2), or level-one (sessions only)")
        .among({"theta-v", "theta-s", "level-one"})
        .showDefault();
    command.flag("--real", options->isReal,
                 "Photos have the flaws of a real camera: exposure, colour, noise, a seam");
    command.option("--tilt", options->tiltDeg, "Standard deviation of pitch and roll, degrees")
        .range(0.0, 30.0)
        .showDefault();
    command.option("--storage", camera.storageFolder,
                   "Folder of the camera's memory; default: a temporary one");
    command.option("--truth", camera.truthFile, "File for the truth about every picture");
    command.option("--photos", options->photos,
                   "Serve these photos, by position, in place of the practice room");
    command.option("--positions", options->positions, "CSV of their positions, as for import");
}

void addPracticePictures(Commands& commands) {
    const auto options = std::make_shared<PicturesArguments>();
    const program::Command command =
        commands.add("practice-pictures", "Draw what a robot's camera really sees in a practice room",
                     [options](Context& context) { return drawPictures(*options, context); });
    command.option("out", options->out, "Folder to make").required();
    command.option("--camera", options->camera, "Camera: a ROS camera-info YAML").required();
    command.option("--path", options->path, "TUM file: lines of \"time x y z qx qy qz qw\"").required();
    program::declareFrame(command, options->frame);
    declareRoom(command, options->room);
}

void addDemo(Commands& commands) {
    const auto options = std::make_shared<DemoArguments>();
    const program::Command command =
        commands.add("demo", "Scan, export, and walk through a practice room",
                     [options](Context& context) { return runDemo(*options, context); });
    command.option("out", options->out, "Folder to make").required();
    command.option("--width", options->demo.photoWidth, "Of the photos, pixels")
        .range(1024, 16384)
        .showDefault();
    command.option("--step", options->demo.stepM, "Of the grid, metres").showDefault();
    command.option("--frames", options->demo.frames, "Of the walk").range(6, 100000).showDefault();
    command.option("--seed", options->demo.seed, "Of the camera's errors").showDefault();
    command
        .option("--scene", options->scene,
                "Richest scene model: sphere, room, depth, or auto to measure what is best")
        .among({"sphere", "room", "depth", "auto"})
        .showDefault();
}

} // namespace spherewalk::cli
