// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/command.h"
#include "options/measured_dataset.h"

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/jobs/compare_robot.h"
#include "spherewalk/jobs/measured_dataset.h"

#include <memory>

namespace spherewalk::cli {

namespace {

constexpr std::size_t kShown = 12;

struct CompareArguments {
    program::RenderOptions dataset;
    std::string pictures;
    std::string report;
    std::string poses;
    std::string sensor;
    std::string against;
    bool refinesPoses = false;
    bool fitsColour = false;
    bool stores = false;
};

/// What was asked for and could not be had is a failure, though the report tells the rest.
bool succeeded(const jobs::CompareReport& report, const CompareArguments& options) {
    return (!options.refinesPoses || report.refined > 0) && (!options.fitsColour || report.fit->correction) &&
           (!report.sensor || report.sensor->why.empty());
}

/// Another program's renderings of the same pictures, beside ours.
Result compareAgainst(const CompareArguments& options, Context& context) {
    if (options.refinesPoses || options.fitsColour || !options.sensor.empty() || !options.poses.empty() ||
        !options.report.empty()) {
        throw Error(ErrorKind::InvalidInput,
                    "Renderings are of the given poses and in the photos' colours: with --against leave "
                    "--refine-poses, --fit-colour, --fit-sensor, --poses and --report out.");
    }
    const std::vector<jobs::RobotPicture> pictures = robotPictures(options.dataset, options.pictures);
    const render::Renderer renderer = options.dataset.renderer(context.progress, context.stop);
    const jobs::RenderingsReport report = compareRenderings(
        renderer, options.dataset.cameraModel(), pictures, options.against,
        options.dataset.pictureOptions(renderer.dataset().info()), context.progress, context.stop);
    return {toJson(report), renderingsText(report)};
}

Result compareViews(const CompareArguments& options, Context& context) {
    jobs::CompareOptions wanted;
    wanted.pictures = robotPictures(options.dataset, options.pictures, true);
    wanted.refinesPoses = options.refinesPoses;
    wanted.fitsColour = options.fitsColour;
    wanted.fitsSensor = !options.sensor.empty();
    wanted.view = options.dataset.viewOptions();
    wanted.shown = options.report.empty() ? 0 : kShown;
    const render::Renderer renderer = options.dataset.renderer(context.progress, context.stop);
    const jobs::CompareReport report =
        compareRobot(renderer, options.dataset.cameraModel(), wanted, context.progress, context.stop);
    if (!options.report.empty()) {
        writeComparison(report, options.report);
    }
    if (!options.poses.empty()) {
        writePoses(report, options.poses);
    }
    if (report.sensor) {
        writeFile(options.sensor, bytesOf(render::sensorYaml(report.sensor->sensor)));
    }
    Result result{toJson(report), compareText(report), succeeded(report, options)};
    const bool isStored = options.stores && report.fit->correction;
    if (isStored) {
        jobs::storeColour(renderer.dataset().folder(), *report.fit->correction);
        result.text += "Stored the colour correction in the dataset; views are corrected from now on.\n";
    }
    result.json["stored"] = isStored;
    return result;
}

} // namespace

void addCompare(Commands& commands) {
    const auto options = std::make_shared<CompareArguments>();
    const program::Command command =
        commands.add("compare", "Compare a dataset's views with a robot camera's own pictures",
                     [options](Context& context) {
                         return options->against.empty() ? compareViews(*options, context)
                                                         : compareAgainst(*options, context);
                     });
    options->dataset.declare(command);
    options->dataset.declareFrame(command);
    command
        .option("--pictures", options->pictures,
                "CSV of the robot camera's pictures with their poses: file,x_m,y_m,z_m,qw,qx,qy,qz; lines "
                "with the file alone are registered by the AprilTags that the picture shows")
        .required();
    command.option(
        "--against", options->against,
        "Folder of another program's renderings of the same pictures, with the same names: compare "
        "them with the pictures, beside the dataset's views");
    command.flag("--refine-poses", options->refinesPoses,
                 "The poses are approximate (some 10 cm and 5 degrees): find out the true ones");
    const program::Option fit =
        command.flag("--fit-colour", options->fitsColour,
                     "Fit what makes the photos' colours those of the robot's camera");
    command.flag("--store", options->stores, "Keep the fitted correction in the dataset, for all views")
        .needs(fit);
    command.option(
        "--fit-sensor", options->sensor,
        "YAML to write a sensor to whose frames are as bright, as warm and as noisy as the pictures");
    command.option("--poses", options->poses,
                   "CSV to write the refined poses to, in the form of --pictures, beside the pictures");
    command.option("--report", options->report,
                   "Folder to write a page into, with pictures and views side by side (HTML, PDF and JSON)");
}

} // namespace spherewalk::cli
