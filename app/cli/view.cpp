// SPDX-License-Identifier: GPL-3.0-or-later
#include "command.h"
#include "dataset_options.h"

#include "spherewalk/base/text.h"
#include "spherewalk/geometry/trajectory.h"
#include "spherewalk/jobs/ball_overlay.h"
#include "spherewalk/jobs/walk.h"
#include "spherewalk/photo/picture_file.h"

#include <memory>
#include <vector>

namespace spherewalk::cli {

namespace {

struct Options {
    DatasetOptions dataset;
    std::string pose;
    std::string out;
    std::string ball;
};

Result view(const Options& options, Context& context) {
    const Rigid3 pose = options.dataset.opticalPose(parsePose(options.pose));
    const CameraModel camera = options.dataset.cameraModel();
    const render::Renderer renderer = options.dataset.renderer(context);
    render::ViewOptions viewOptions = options.dataset.viewOptions();
    std::vector<render::Overlay> overlays;
    if (!options.ball.empty()) {
        overlays.push_back(jobs::ballOverlay(jobs::parseBall(options.ball), camera, pose));
        viewOptions.overlays = overlays;
    }
    const render::View view = renderer.render(camera, pose, viewOptions);
    photo::writePng(options.out, view.picture);
    Json json = jobs::toJson(view.report);
    json["out"] = options.out;
    return {json, text("Wrote ", options.out, ": ", view.picture.width(), " x ", view.picture.height(),
                       " pixels from ", view.report.file, ", ", fixed(100 * view.report.offsetM, 1),
                       " cm away, trust ", fixed(view.report.trust, 2), ", rendered in ",
                       fixed(view.report.renderMs, 1), " ms.")};
}

} // namespace

void addView(Commands& commands) {
    const auto options = std::make_shared<Options>();
    CLI::App& command = commands.add("view", "Render one view of a robot's camera from a dataset",
                                     [options](Context& context) { return view(*options, context); });
    options->dataset.declare(command);
    command.add_option("--pose", options->pose, "Pose of the camera: \"x y z qx qy qz qw\", metres")
        ->required();
    command.add_option("--out", options->out, "PNG file to write")->required();
    command.add_option("--ball", options->ball,
                       "A ball to lay into the view, \"x y z radius\", metres, as an object of a simulator");
}

} // namespace spherewalk::cli
