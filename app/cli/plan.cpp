// SPDX-License-Identifier: GPL-3.0-or-later
#include "command.h"
#include "plan_text.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/angle.h"
#include "spherewalk/sheet/marking_sheet.h"
#include "spherewalk/store/survey_store.h"

#include <memory>

namespace spherewalk::cli {

namespace {

struct Options {
    std::string survey;
    bool list = false;
    std::string sheet;
};

std::string railLine(std::size_t number, const survey::RailPlacement& rail) {
    const Eigen::Vector2d last = rail.stop(rail.stops - 1);
    return text("\nrail ", number, ": ", rail.stops, " stops from (", fixed(rail.origin.x(), 3), ", ",
                fixed(rail.origin.y(), 3), ") to (", fixed(last.x(), 3), ", ", fixed(last.y(), 3), ")");
}

Result show(const Options& options) {
    const auto store = store::SurveyStore::open(options.survey, store::Access::Read);
    const survey::PlanOptions planOptions = store.planOptions();
    const survey::Plan plan = store.plan();
    const survey::PlanReport report = survey::report(store.room(), planOptions, plan);
    Json json = planJson(report, planOptions);
    std::string words = planText(report, planOptions);
    Json rails = Json::array();
    for (std::size_t i = 0; i < plan.placements.size(); ++i) {
        const survey::RailPlacement& rail = plan.placements[i];
        rails.push_back({{"x_m", rail.origin.x()},
                         {"y_m", rail.origin.y()},
                         {"heading_deg", Degrees(rail.heading).value()},
                         {"stops", rail.stops},
                         {"step_m", rail.stepM}});
        words += options.list ? railLine(i + 1, rail) : "";
    }
    json["rails"] = rails;
    Json stations = Json::array();
    for (const store::StationRecord& station : store.stations()) {
        const Eigen::Vector3d& p = station.station.positionM;
        stations.push_back(
            {{"id", station.id}, {"name", station.name}, {"position_m", {p.x(), p.y(), p.z()}}});
    }
    json["station_list"] = stations;
    if (!options.sheet.empty()) {
        writeFile(options.sheet, sheet::markingSheet(store.info().name, store.room(), planOptions, plan));
        json["sheet"] = options.sheet;
        words += text("\nWrote ", options.sheet, ": the plan to scale, and the tape distances of each rail.");
    }
    return {json, words};
}

} // namespace

void addPlan(Commands& commands) {
    const auto options = std::make_shared<Options>();
    CLI::App& command = commands.add("plan", "Show a survey's plan",
                                     [options](Context& /*context*/) { return show(*options); });
    command.add_option("survey", options->survey, "Folder of the survey")->required();
    command.add_option("--sheet", options->sheet,
                       "PDF to write: the plan to scale, with tape distances for laying the rails");
    command.add_flag("--list", options->list, "List the rail placements in walking order");
}

} // namespace spherewalk::cli
