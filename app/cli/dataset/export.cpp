// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/command.h"
#include "options/measured_dataset.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/folder.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/export_foreign.h"
#include "spherewalk/jobs/export_place.h"
#include "spherewalk/jobs/measured_dataset.h"
#include "spherewalk/place/surface_files.h"
#include "spherewalk/render/camera_info.h"
#include "spherewalk/render/dataset_format.h"
#include "spherewalk/store/survey_store.h"

#include <filesystem>
#include <iterator>
#include <memory>

namespace spherewalk::cli {

namespace {

struct ExportArguments {
    std::string survey;
    std::string dataset;
    jobs::ExportOptions write;
    std::string scene; ///< Empty: as sceneOf() proposes.
    bool keepsCarried = false;
    std::string camera;
    jobs::MeasureOptions measure;
    std::string format = "spherewalk";
    double obstacleHeightM = jobs::kObstacleHeightM;
    bool withFaces = false;
    bool withPoints = false;
    bool isCheck = false;
    bool withPlugin = false;
    jobs::PlaceOptions place;
    std::string measured;
};

constexpr const char* kMeasured = "auto";

/// To measure, unless a scene model is named, where there is enough to compare.
std::string sceneOf(const ExportArguments& options, const store::SurveyStore& store) {
    if (!options.scene.empty()) {
        return options.scene;
    }
    const auto solution = store.activeSolution();
    const bool isEnough = solution && std::ssize(store.solvedPhotos(solution->id)) >= jobs::kEnoughToMeasure;
    return isEnough && options.write.testEvery == 0 ? kMeasured : "sphere";
}

jobs::ExportOptions exportOptions(const ExportArguments& options, const std::string& scene) {
    jobs::ExportOptions wanted = options.write;
    wanted.clearsCarried = !options.keepsCarried;
    wanted.scene = scene == kMeasured ? render::SceneKind::Depth : render::sceneKind(scene);
    return wanted;
}

CameraIntrinsics cameraOf(const ExportArguments& options) {
    return options.camera.empty() ? CameraIntrinsics::pinhole(640, 480, 1.2)
                                  : render::readCameraInfo(options.camera);
}

Result checkedExport(const ExportArguments& options, Context& context) {
    const auto store = store::SurveyStore::open(options.survey, store::Access::Read);
    const jobs::ExportCheck check =
        jobs::checkExport(store, options.dataset, exportOptions(options, sceneOf(options, store)),
                          context.progress, context.stop);
    std::string words = text(check.photos, " photos, about ", humanBytes(check.totalBytes), " and ",
                             humanDuration(std::chrono::duration<double>(check.seconds)), "; ",
                             humanBytes(check.freeBytes), " are free.");
    for (const auto& sentences : {check.obstacles, check.doubts}) {
        for (const std::string& sentence : sentences) {
            words += "\n" + sentence;
        }
    }
    if (check.privateRegions > 0) {
        words += text("\n", counted(check.privateRegions, "private region", "private regions"), " in ",
                      counted(check.blurredPhotos, "photo", "photos"), " will be blurred.");
    }
    return {jobs::toJson(check), words, check.isPossible()};
}

Result resultOf(const jobs::ExportReport& report, const std::string& dataset) {
    Json json = jobs::toJson(report);
    json["dataset"] = dataset;
    const dataset::WriteReport& written = report.written;
    const double growth =
        100 * (static_cast<double>(written.photoBytes) / static_cast<double>(written.sourceBytes) - 1);
    std::string words =
        text("Exported ", counted(written.photos, "photo", "photos"), " to ", dataset, ": ",
             humanBytes(written.totalBytes), " (the photos take ", fixed(growth, 2),
             " % more than in the survey), in ",
             humanDuration(std::chrono::duration<double>(report.depth.seconds + written.seconds)), ".");
    const auto tellLeftOut = [&](int count, const char* one, const char* several) {
        words += count == 0 ? "" : text("\n", counted(count, one, several), " left out.");
    };
    tellLeftOut(report.withoutPhoto, "station has no photo and is", "stations have no photo and are");
    tellLeftOut(report.rejected, "photo was rejected and is", "photos were rejected and are");
    tellLeftOut(report.tests, "photo is a test and is", "photos are tests and are");
    tellLeftOut(report.failed, "photo has no pose that holds and is",
                "photos have no pose that holds and are");
    words += written.blurredRegions == 0
                 ? ""
                 : text("\n", counted(written.blurredRegions, "face or screen was", "faces and screens were"),
                        " blurred in ", counted(written.blurredPhotos, "photo", "photos"), ".");
    words += report.carriedShare == 0
                 ? ""
                 : text("\nWhat the camera carries along covers ", fixed(100 * report.carriedShare, 1),
                        " % of each photo. The dataset shows floor and walls there, as other photos see "
                        "them; --keep-carried leaves the photos as they are.");
    return {json, words};
}

/// With the scene model that measuring finds to be enough for the camera.
Result exportChosen(const ExportArguments& options, const store::SurveyStore& store, Context& context) {
    const jobs::ChosenExport chosen =
        jobs::exportChosen(store, options.dataset, CameraModel(cameraOf(options)), options.measure,
                           exportOptions(options, kMeasured), context.progress, context.stop);
    Result result = resultOf(chosen.exported, options.dataset);
    result.json["scene"] = render::name(chosen.scene);
    result.json["measured"] = jobs::toJson(chosen.measured);
    result.text += "\n" + chosen.measured.choice.reason;
    if (options.camera.empty()) {
        result.text +=
            "\nThis holds for a camera of 640 x 480 pixels and 69 degrees; --camera names the robot's.";
    }
    return result;
}

Result exportForeign(const ExportArguments& options, const store::SurveyStore& store, Context& context) {
    const jobs::ForeignOptions wanted{dataset::poseFormat(options.format), options.withFaces,
                                      options.withPoints, options.place, options.write.testEvery};
    const jobs::ForeignReport report =
        jobs::exportForeign(store, options.dataset, wanted, context.progress, context.stop);
    return {{{"photos", report.photos},
             {"pictures", report.pictures},
             {"test_photos", report.tests},
             {"points", report.points},
             {"folder", options.dataset}},
            text("Exported ", report.photos, " photos as ", report.pictures, " pictures with poses for ",
                 options.format, " to ", options.dataset, ".",
                 report.tests > 0 ? text("\n", counted(report.tests, "photo is a test.", "photos are tests."))
                                  : "",
                 report.points > 0 ? text("\n", report.points, " points were seen.") : "")};
}

Result exportWorld(const ExportArguments& options, jobs::WorldFormat format, Context& context) {
    const CameraIntrinsics camera = cameraOf(options);
    dataset::WorldRoom room = jobs::worldRoomOf(options.survey, options.obstacleHeightM, context.progress);
    room.validate();
    if (options.withPlugin) {
        room.pluginDataset = std::filesystem::relative(options.survey, options.dataset).string();
    }
    if (jobs::hasDepths(options.survey)) {
        requireAbsent(options.dataset, "the world");
        jobs::Furniture furniture =
            jobs::furnitureOf(options.survey, {room.outline, room.floorM, room.ceilingM}, options.place,
                              context.progress, context.stop);
        if (!furniture.mesh.triangles.empty()) {
            room.furnitureMesh = place::objFile(furniture.mesh);
        }
        room.furniture = std::move(furniture.boxes);
    }
    const std::string file = jobs::exportWorld(room, camera, format, options.dataset);
    const std::size_t obstacles = room.hasFurniture() ? 0 : room.obstacles.size();
    const std::string things = !room.hasFurniture() ? counted(obstacles, "obstacle", "obstacles")
                               : format == jobs::WorldFormat::Sdf
                                   ? "furniture as a mesh"
                                   : text("furniture of ", counted(room.furniture.size(), "box", "boxes"));
    return {{{"folder", options.dataset},
             {"file", file},
             {"walls", room.outline.size()},
             {"obstacles", obstacles},
             {"furniture_boxes", room.furniture.size()}},
            text("Wrote ", options.dataset, "/", file, ", a room of ", room.outline.size(), " walls and ",
                 things, ", and camera.yaml.")};
}

Result exportPlace(const ExportArguments& options, jobs::PlaceFormat format, Context& context) {
    jobs::PlaceOptions place = options.place;
    place.formats = {format};
    const jobs::PlaceReport report =
        jobs::exportPlace(options.survey, options.dataset, place, context.progress, context.stop);
    Json json = jobs::toJson(report);
    json["folder"] = options.dataset;
    const std::string map = format == jobs::PlaceFormat::Occupancy
                                ? text("\nOf the map ", fixed(report.freeM2, 1), " m2 are free and ",
                                       fixed(report.occupiedM2, 1), " m2 occupied.")
                                : "";
    return {json, text("Wrote the surfaces that ", counted(report.photos, "photo sees", "photos see"), " to ",
                       options.dataset, ": ", fixed(report.areaM2, 1), " m2 in ", report.vertices,
                       " vertices and ", report.triangles, " triangles, in ",
                       humanDuration(std::chrono::duration<double>(report.depthSeconds + report.seconds)),
                       ".\nSeen from the photos there is a surface in ", fixed(100 * report.seenShare, 1),
                       " % of all directions; the rest are holes. Two photos or more show ",
                       fixed(100 * report.seenTwiceShare, 1), " % of the vertices.", map)};
}

Result exportWeb(const ExportArguments& options, Context& context) {
    jobs::WebOptions page;
    page.measured = options.measured;
    const jobs::WebReport report =
        jobs::exportWeb(options.survey, options.dataset, page, context.progress, context.stop);
    Json json = jobs::toJson(report);
    json["folder"] = options.dataset;
    return {json, text("Wrote a page of ", counted(report.photos, "photo", "photos"), " to ", options.dataset,
                       ": ", humanBytes(report.totalBytes), " in ",
                       humanDuration(std::chrono::duration<double>(report.depthSeconds + report.seconds)),
                       ". Open index.html in a browser.\nDistances can be measured in ", report.withDepth,
                       " of them.",
                       report.leftOut > 0 ? text(" ", counted(report.leftOut, "station has", "stations have"),
                                                 " no photo on it.")
                                          : "")};
}

/// Errors: InvalidInput where no world gets a plugin, or its source is no dataset, which the plugin shows.
void checkPlugin(const ExportArguments& options) {
    if (!options.withPlugin) {
        return;
    }
    if (options.format != "sdf") {
        throw Error(ErrorKind::InvalidInput,
                    "Gazebo's worlds alone have plugins: --plugin goes with --format sdf.");
    }
    if (!std::filesystem::exists(std::filesystem::path(options.survey) / render::kDatasetFile)) {
        throw Error(ErrorKind::InvalidInput,
                    text("The plugin shows a dataset, and ", options.survey,
                         " is none: export the survey first, and make the world of its dataset."));
    }
}

/// Errors: InvalidInput for what learners want, in an export that is not for them.
void checkLearning(const ExportArguments& options) {
    const bool isForLearners = options.format == "colmap" || options.format == "nerfstudio";
    if (options.withPoints && !isForLearners) {
        throw Error(ErrorKind::InvalidInput,
                    "Points go with --format colmap and nerfstudio; --format ply writes them alone.");
    }
    if (options.write.testEvery > 0 &&
        ((!isForLearners && options.format != "spherewalk") || options.scene == kMeasured)) {
        throw Error(ErrorKind::InvalidInput, "Photos are left out for tests with --format colmap, nerfstudio "
                                             "and spherewalk, and with a scene model other than auto.");
    }
}

Result exportSurvey(const ExportArguments& options, Context& context) {
    checkLearning(options);
    checkPlugin(options);
    if (options.format == "web") {
        return exportWeb(options, context);
    }
    if (const auto format = jobs::worldFormat(options.format)) {
        return exportWorld(options, *format, context);
    }
    if (const auto format = jobs::placeFormat(options.format)) {
        return exportPlace(options, *format, context);
    }
    const auto store = store::SurveyStore::open(options.survey, store::Access::Read);
    if (options.format != "spherewalk") {
        return exportForeign(options, store, context);
    }
    const std::string scene = sceneOf(options, store);
    if (scene == kMeasured) {
        return exportChosen(options, store, context);
    }
    return resultOf(jobs::exportDataset(store, options.dataset, exportOptions(options, scene),
                                        context.progress, context.stop),
                    options.dataset);
}

} // namespace

void addExport(Commands& commands) {
    const auto options = std::make_shared<ExportArguments>();
    const program::Command command =
        commands.add("export", "Export a survey as a dataset for simulators", [options](Context& context) {
            return options->isCheck ? checkedExport(*options, context) : exportSurvey(*options, context);
        });
    command
        .option(
            "survey", options->survey,
            "Folder of the survey; with sdf, mjcf, urdf, ply, gltf, obj, occupancy or web, or of a dataset")
        .required();
    command.option("dataset", options->dataset, "Folder to make").required();
    command
        .option("--restart-every", options->write.write.mcusPerInterval,
                "JPEG blocks (MCUs) between restart markers; the nearest number that divides a row is "
                "taken")
        .range(1, 65535)
        .showDefault();
    command
        .option(
            "--format", options->format,
            "What for: spherewalk's own simulators, pictures with poses as colmap, nerfstudio, tum, kitti or "
            "euroc read them, the room as a world for Gazebo (sdf) or MuJoCo (mjcf) or as a robot's model "
            "(urdf), the surfaces that were seen (ply, gltf, obj), a map of where a robot can drive "
            "(occupancy), or a page for a browser to look around in (web)")
        .among({"spherewalk", "colmap", "nerfstudio", "tum", "kitti", "euroc", "sdf", "mjcf", "urdf", "ply",
                "gltf", "obj", "occupancy", "web"})
        .showDefault();
    command
        .option("--obstacle-height", options->obstacleHeightM,
                "With sdf, mjcf or urdf, height of the plan's obstacles, metres")
        .range(0.01, 10.0)
        .showDefault();
    command.flag(
        "--plugin", options->withPlugin,
        "With sdf, and a dataset in place of the survey: the robot's camera is a plugin of Gazebo, and needs "
        "no process beside it");
    command
        .option("--voxel", options->place.fusion.voxelM,
                "With a world, ply, gltf, obj, occupancy or --points, edge of the voxels that depths are "
                "fused in, "
                "metres")
        .range(0.005, 0.2)
        .showDefault();
    command
        .option("--simplify", options->place.simplifyM,
                "With ply, gltf or obj, error by which triangles may be joined, metres; 0 keeps all")
        .range(0.0, 1.0)
        .showDefault();
    command
        .option("--cell", options->place.occupancy.cellM, "With occupancy, edge of the map's cells, metres")
        .range(0.01, 1.0)
        .showDefault();
    command
        .option("--lowest", options->place.occupancy.leastHeightM,
                "With occupancy, height above the floor from which on things are obstacles, metres")
        .range(0.0, 10.0)
        .showDefault();
    command
        .option("--highest", options->place.occupancy.mostHeightM,
                "With occupancy, height above the floor up to which things are obstacles, metres")
        .range(0.0, 10.0)
        .showDefault();
    command
        .option(
            "--least-photos", options->place.leastPhotos,
            "With a world, ply, gltf, obj, occupancy or --points, leave out surfaces that fewer photos show")
        .range(1, 255)
        .showDefault();
    command.option("--measured", options->measured,
                   "With web, the report.json of measure --report, for a map of errors");
    command.flag("--faces", options->withFaces,
                 "With another format, the six faces of a cube instead of each photo");
    command.flag("--points", options->withPoints,
                 "With colmap or nerfstudio, points of the surfaces that the photos show, with colours");
    command
        .option(
            "--test-every", options->write.testEvery,
            "Keep one of so many photos for tests: colmap and nerfstudio say which pictures that are, and "
            "a dataset is made without them")
        .range(2, 1000);
    command.flag("--check", options->isCheck,
                 "Only say how large it would become, how long it would take, and what it would lack");
    command
        .option(
            "--scene", options->scene,
            "Richest scene model to export: sphere, room, depth, or auto for the cheapest that holds "
            "the tolerance; the cheaper ones come with it. Default: auto for eight aligned photos or more, "
            "else sphere")
        .among({"sphere", "room", "depth", "auto"});
    command.flag("--keep-carried", options->keepsCarried,
                 "With room or depth, leave cart, robot or operator below the camera in the photos");
    command.option(
        "--camera", options->camera,
        "Camera that a scene model is chosen for, or that a world's robot has: a ROS camera-info YAML; "
        "default: 640 x 480 pixels, 69 degrees");
    declareTolerance(command, options->measure.tolerancePx);
}

} // namespace spherewalk::cli
