// SPDX-License-Identifier: GPL-3.0-or-later
#include "command.h"
#include "plan_text.h"
#include "profile_help.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/store/survey_store.h"
#include "spherewalk/survey/outline.h"
#include "spherewalk/survey/plan.h"

#include <memory>

namespace spherewalk::cli {

namespace {

struct Options {
    std::string survey;
    std::vector<double> rect;
    std::string outline;
    double ceilingM = 0;
    survey::PlanOptions plan;
    std::string profile = "auto";
};

survey::Room roomOf(const Options& options) {
    survey::Room room;
    room.ceilingM = options.ceilingM;
    if (!options.rect.empty()) {
        const auto& r = options.rect;
        if (!(r[0] < r[2] && r[1] < r[3])) {
            throw Error(ErrorKind::InvalidInput,
                        "The rectangle needs x0 < x1 and y0 < y1: --rect x0,y0,x1,y1.");
        }
        room.outline = {{r[0], r[1]}, {r[2], r[1]}, {r[2], r[3]}, {r[0], r[3]}};
        return room;
    }
    constexpr std::uint64_t kLargest = 16ULL << 20;
    const Json json = parseJson(readTextFile(options.outline, kLargest), options.outline);
    survey::Outline outline = survey::parseOutline(json, options.outline);
    room.outline = std::move(outline.outline);
    room.obstacles = std::move(outline.obstacles);
    if (options.ceilingM == 0 && !outline.ceilingM) {
        throw Error(ErrorKind::InvalidInput,
                    text("The ceiling's height is missing: give --ceiling, or \"ceiling_m\" in ",
                         options.outline, "."));
    }
    room.ceilingM = options.ceilingM == 0 ? *outline.ceilingM : options.ceilingM;
    return room;
}

Result create(const Options& options) {
    const survey::Room room = roomOf(options);
    room.validate();
    options.plan.validate(room);
    const std::optional<survey::CaptureProfile> profile = survey::parseProfile(options.profile);
    const survey::Plan plan = survey::plan(room, options.plan);
    const survey::PlanReport report = survey::report(room, options.plan, plan);
    const std::filesystem::path folder = options.survey;
    auto store = store::SurveyStore::create(folder, folder.stem().string(), room, options.plan, plan);
    store.setCaptureProfile(profile);
    Json json = planJson(report, options.plan);
    json["survey"] = options.survey;
    json["profile"] = survey::profileText(profile);
    json["id"] = store.info().uuid;
    return {json, text("Made the survey ", options.survey, ".\n", planText(report, options.plan))};
}

} // namespace

void addNew(Commands& commands) {
    const auto options = std::make_shared<Options>();
    CLI::App& command = commands.add("new", "Plan a new survey",
                                     [options](Context& /*context*/) { return create(*options); });
    command.add_option("survey", options->survey, "Folder to make, <name>.spherewalk")->required();
    auto* shape = command.add_option_group("shape", "The room's outline")->require_option(1);
    shape->add_option("--rect", options->rect, "Rectangular room: x0,y0,x1,y1 in metres")
        ->delimiter(',')
        ->expected(4);
    shape->add_option("--outline", options->outline,
                      R"(JSON file: [[x,y],...] or {"outline":...,"obstacles":...,"ceiling_m":...})");
    command.add_option("--ceiling", options->ceilingM, "Height of the ceiling, metres");
    command.add_option("--step", options->plan.stepM, "Distance of neighbouring stations, metres")
        ->capture_default_str();
    command
        .add_option("--height", options->plan.heightsM,
                    "Height of the lens above the floor, metres; several make layers")
        ->delimiter(',')
        ->capture_default_str();
    command.add_option("--rail-stops", options->plan.railStops, "Stops of the cart on the rail")
        ->capture_default_str();
    command.add_option("--profile", options->profile, text("How the camera is set. ", kProfileHelp))
        ->capture_default_str();
    command.add_option("--clearance", options->plan.clearanceM, "From a stop to walls and obstacles, metres")
        ->capture_default_str();
}

} // namespace spherewalk::cli
