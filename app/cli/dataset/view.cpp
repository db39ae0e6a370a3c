// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/command.h"
#include "program/render_options.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/trajectory.h"
#include "spherewalk/jobs/object_overlay.h"
#include "spherewalk/jobs/walk.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/render/light_probe.h"
#include "spherewalk/render/sensor.h"

#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace spherewalk::cli {

namespace {

struct ViewArguments {
    program::RenderOptions dataset;
    std::string pose;
    std::string out;
    std::string ball;
    std::string sensor;
    bool isLit = false;
};

constexpr const char* kSensorHelp = "Sensor: a YAML with noise, exposure, shutter and other effects; the "
                                    "entry sensor of the camera's file, too";

constexpr const char* kLightHelp =
    "Light the ball as the photos show the light at its place, and let it cast a shadow";

/// What a person must know before the picture is used, as sentences that go on. what: "camera" or "light".
std::string doubtOf(const render::ViewReport& report, std::string_view what = "camera") {
    if (report.isOutside) {
        return text(" The ", what,
                    " is outside of what was scanned; nothing in the picture can be relied on.");
    }
    if (!report.seesPlace) {
        return text(" No photo sees the ", what, "'s place; the picture may show what lies behind a wall.");
    }
    return "";
}

/// The ball in the light at its place, with its shadow.
render::Overlay litBall(const jobs::Ball& ball, const render::Renderer& renderer, const CameraModel& camera,
                        const Rigid3& pose, render::ViewOptions options) {
    const jobs::BallLight light(renderer, ball, options);
    options.wantsDepth = true;
    return jobs::litBallOverlay(ball, camera, pose, light, renderer.render(camera, pose, options).depth);
}

Result renderView(const ViewArguments& options, Context& context) {
    const Rigid3 pose = options.dataset.opticalPose(parsePose(options.pose));
    const CameraModel camera = options.dataset.cameraModel();
    const render::Renderer renderer = options.dataset.renderer(context.progress, context.stop);
    render::ViewOptions viewOptions = options.dataset.pictureOptions(renderer.dataset().info());
    std::vector<render::Overlay> overlays;
    if (!options.ball.empty()) {
        const jobs::Ball ball = jobs::parseBall(options.ball);
        overlays.push_back(options.isLit ? litBall(ball, renderer, camera, pose, viewOptions)
                                         : jobs::ballOverlay(ball, camera, pose));
        viewOptions.overlays = overlays;
    }
    render::View view;
    if (options.sensor.empty()) {
        renderer.render(camera, pose, viewOptions, view);
    } else {
        render::Sensor sensor(render::readSensor(options.sensor), camera, viewOptions.threads);
        viewOptions.wantsDepth = sensor.needsDepth();
        viewOptions.depthShowsOverlays = true;
        renderer.render(camera, pose, viewOptions, view);
        sensor.take(0, view);
    }
    photo::writePng(options.out, view.picture);
    Json json = jobs::toJson(view.report);
    json["out"] = options.out;
    return {json, text("Wrote ", options.out, ": ", view.picture.width(), " x ", view.picture.height(),
                       " pixels from ", view.report.file, ", ", fixed(100 * view.report.offsetM, 1),
                       " cm away, trust ", fixed(view.report.trust, 2), ", rendered in ",
                       fixed(view.report.renderMs, 1), " ms.", doubtOf(view.report))};
}

struct WalkArguments {
    program::RenderOptions dataset;
    std::string path;
    std::string out;
    program::StreamOptions stream;
    std::vector<std::string> balls;
    std::vector<std::string> objects;
    std::vector<std::string> formats;
    std::string bagPictures = "raw";
    std::string sensor;
    bool writesDepth = false;
    bool writesLabels = false;
    bool isLit = false;
    std::string shard = "1/1";
};

std::vector<TimedPose> opticalPath(const WalkArguments& options) {
    std::vector<TimedPose> path = readTum(options.path);
    for (TimedPose& pose : path) {
        pose.roomFromCamera = options.dataset.opticalPose(pose.roomFromCamera);
    }
    return path;
}

/// The camera, or those of the rig.
std::vector<jobs::WalkCamera> walkCameras(const WalkArguments& options) {
    if (const std::vector<render::RigCamera> rig = options.dataset.rig(); !rig.empty()) {
        return jobs::walkCameras(rig, readTum(options.path), options.dataset.rigFile());
    }
    jobs::WalkCamera camera;
    camera.intrinsics = options.dataset.cameraModel().intrinsics();
    camera.path = opticalPath(options);
    return {camera};
}

jobs::WalkOptions walkOptionsOf(const WalkArguments& options, const render::DatasetInfo& dataset) {
    jobs::WalkOptions walkOptions{options.dataset.pictureOptions(dataset), options.stream.options()};
    for (const std::string& ball : options.balls) {
        walkOptions.balls.push_back(jobs::parseBall(ball));
    }
    for (const std::string& object : options.objects) {
        walkOptions.meshes.push_back(jobs::parseObject(object));
    }
    walkOptions.shard = jobs::Shard::parse(options.shard);
    for (const std::string& format : options.formats) {
        if (format == "rosbag" || format == "mcap") {
            walkOptions.bags.push_back(dataset::bagFormat(format));
        } else {
            walkOptions.formats.push_back(dataset::poseFormat(format));
        }
    }
    if (!options.sensor.empty()) {
        walkOptions.sensor = render::readSensor(options.sensor);
    }
    walkOptions.writesDepth = options.writesDepth;
    walkOptions.writesLabels = options.writesLabels;
    walkOptions.lightsBalls = options.isLit;
    walkOptions.bagPictures = jobs::bagPictures(options.bagPictures);
    return walkOptions;
}

Result renderWalk(const WalkArguments& options, Context& context) {
    const std::vector<jobs::WalkCamera> cameras = walkCameras(options);
    const render::Renderer renderer = options.dataset.renderer(context.progress, context.stop);
    const jobs::WalkReport report =
        jobs::walk(renderer, cameras, walkOptionsOf(options, renderer.dataset().info()), options.out,
                   context.progress, context.stop);
    const std::string known =
        report.reused > 0 ? text(", ", report.reused, " of them were there before") : "";
    const std::string of = cameras.size() > 1 ? text(" of ", cameras.size(), " cameras") : "";
    const std::string outside =
        report.outside > 0 ? text(" ", report.outside, " frames are from outside of what was scanned.") : "";
    return {jobs::toJson(report),
            report.isComplete
                ? text("Wrote ", report.frames, " frames", of, known,
                       ", index.csv, and contact-sheet.png to ", options.out, " (median ",
                       fixed(report.medianRenderMs, 1), " ms to render, ", report.photosUsed,
                       " photos used, ", report.stream.late, " frames not decoded in time).", outside)
                : text("Wrote ", report.frames, " frames", of, known, " to ", options.out,
                       ". Other parts are still to come; the last one to end writes index.csv.")};
}

struct ProbeArguments {
    program::RenderOptions dataset;
    std::string at;
    std::string out;
    int width = render::ProbeOptions().width;
};

/// The place that "x y z" spells, in metres. Errors: InvalidInput.
Eigen::Vector3d parsePlace(const std::string& words) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    std::istringstream stream(words);
    std::vector<double> numbers;
    for (std::string word; stream >> word;) {
        numbers.push_back(parseNumber(word).value_or(kNone));
    }
    numbers.resize(numbers.size() == 3 ? 3 : 0);
    if (numbers.empty() || !Eigen::Vector3d(numbers.data()).allFinite()) {
        throw Error(ErrorKind::InvalidInput,
                    text("--at wants a place in the room as \"x y z\", metres, not \"", words, "\"."));
    }
    return Eigen::Vector3d(numbers.data());
}

Json listOf(const Eigen::Vector3d& values) {
    return {values.x(), values.y(), values.z()};
}

Json lightJson(const render::LightProbe& probe, const render::LightHarmonics& harmonics,
               const render::DominantLight& light) {
    Json json{{"photo", probe.report.file},
              {"is_outside", probe.report.isOutside},
              {"sees_place", probe.report.seesPlace},
              {"clipped_share", probe.clippedShare},
              {"recovered_share", probe.recoveredShare},
              {"towards", listOf(light.towards)},
              {"irradiance", listOf(light.irradiance)},
              {"ambient", listOf(light.ambient)},
              {"share", light.share}};
    for (const Eigen::Vector3d& coefficient : harmonics.coefficients) {
        json["harmonics"].push_back(listOf(coefficient));
    }
    return json;
}

std::string lightText(const render::LightProbe& probe, const render::DominantLight& light) {
    const SphericalDirection towards = sphericalDirection(light.towards);
    const std::string strongest =
        light.share > 0
            ? text(" The strongest light comes from azimuth ", fixed(Degrees(towards.azimuth).value(), 0),
                   " and elevation ", fixed(Degrees(towards.elevation).value(), 0), " degrees, and is ",
                   fixed(100 * light.share, 0), " % of what falls on a surface that faces it.")
            : " Light comes evenly from all sides.";
    return text(" ", fixed(100 * probe.clippedShare, 2),
                " % of all directions are too bright for the photos; ", fixed(100 * probe.recoveredShare, 2),
                " % come from darker photos.", strongest);
}

Result renderProbe(const ProbeArguments& options, Context& context) {
    const Eigen::Vector3d place = parsePlace(options.at);
    const render::ViewOptions view = options.dataset.viewOptions();
    render::ProbeOptions wanted;
    wanted.width = options.width;
    wanted.scene = view.scene;
    wanted.threads = view.threads;
    wanted.validate();
    const render::Renderer renderer = options.dataset.renderer(context.progress, context.stop);
    const render::LightProbe probe = render::lightProbe(renderer, place, wanted);
    writeFile(options.out, render::radianceFile(probe.radiance));
    const render::LightHarmonics harmonics = render::lightHarmonics(probe.radiance);
    const render::DominantLight light = render::dominantLight(harmonics);
    Json json = lightJson(probe, harmonics, light);
    json["out"] = options.out;
    return {json, text("Wrote ", options.out, ": the light at ", options.at, ", ", probe.radiance.width(),
                       " x ", probe.radiance.height(), " pixels, where 1 is the white of ", probe.report.file,
                       ".", lightText(probe, light), doubtOf(probe.report, "light"))};
}

} // namespace

void addView(Commands& commands) {
    const auto options = std::make_shared<ViewArguments>();
    const program::Command command =
        commands.add("view", "Render one view of a robot's camera from a dataset",
                     [options](Context& context) { return renderView(*options, context); });
    options->dataset.declare(command);
    options->dataset.declareFrame(command);
    command.option("--pose", options->pose, "Pose of the camera: \"x y z qx qy qz qw\", metres").required();
    command.option("--out", options->out, "PNG file to write").required();
    const program::Option ball =
        command.option("--ball", options->ball,
                       "A ball to lay into the view, \"x y z radius\", metres, as an object of a simulator");
    command.flag("--light", options->isLit, kLightHelp).needs(ball);
    command.option("--sensor", options->sensor, kSensorHelp);
}

void addProbe(Commands& commands) {
    const auto options = std::make_shared<ProbeArguments>();
    const program::Command command =
        commands.add("probe", "Write the light at a place, to light a simulator's objects with",
                     [options](Context& context) { return renderProbe(*options, context); });
    options->dataset.declareWithoutCamera(command);
    command.option("--at", options->at, "The place in the room: \"x y z\", metres").required();
    command
        .option("--out", options->out,
                "Radiance file (.hdr) to write: equirectangular, the centre along the room's x")
        .required();
    command.option("--width", options->width, "Pixels; the picture is half as high").showDefault();
}

void addWalk(Commands& commands) {
    const auto options = std::make_shared<WalkArguments>();
    const program::Command command =
        commands.add("walk", "Render a view at each pose of a path",
                     [options](Context& context) { return renderWalk(*options, context); });
    options->dataset.declare(command, "Folder of the dataset", true);
    options->dataset.declareFrame(command);
    command.option("--path", options->path, "TUM file: lines of \"time x y z qx qy qz qw\"").required();
    command.option("--out", options->out, "Folder to write frames, index.csv, and contact-sheet.png to")
        .required();
    options->stream.declare(command);
    command
        .option("--format", options->formats,
                "Write the poses as another program reads them, besides: tum, kitti, euroc, colmap, or "
                "nerfstudio; or frames and poses as ROS messages: rosbag or mcap; can be repeated")
        .among({"tum", "kitti", "euroc", "colmap", "nerfstudio", "rosbag", "mcap"});
    command
        .option("--bag-pictures", options->bagPictures,
                "Frames in a bag: raw (sensor_msgs/Image) or png (CompressedImage, smaller)")
        .among({"raw", "png"})
        .showDefault();
    command
        .option("--shard", options->shard,
                "Render only the i-th of n parts of the frames, \"i/n\"; several processes may do so at once")
        .showDefault();
    const program::Option ball =
        command
            .option(
                "--ball", options->balls,
                "A ball to lay into each frame, \"x y z radius\", metres, as an object of a simulator; can "
                "be repeated")
            .oneAUse();
    command.option("--sensor", options->sensor, kSensorHelp);
    command.flag("--depth", options->writesDepth,
                 "Write depth frames, too: PNG of 16 bits in millimetres along the optical axis, 0 for none");
    command
        .option(
            "--object", options->objects,
            "An object to lay into each frame, \"FILE x y z size yaw\": an OBJ file or cube, its foot and "
            "its longest side in metres, its heading in degrees; can be repeated")
        .oneAUse();
    command.flag("--labels", options->writesLabels,
                 "Write which pixels show which ball or object, too: PNG of 16 bits, 0 for the room, and "
                 "masks, boxes and visible shares as COCO has them (annotations.json)");
    command.flag("--light", options->isLit, kLightHelp).needs(ball);
}

} // namespace spherewalk::cli
