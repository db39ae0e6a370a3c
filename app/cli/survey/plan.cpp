// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/survey/plan.h"

#include "options/command.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/angle.h"
#include "spherewalk/photo/april_tag.h"
#include "spherewalk/report/printed_sheets.h"
#include "spherewalk/store/survey_store.h"
#include "spherewalk/survey/plan_report.h"
#include "spherewalk/survey/room.h"
#include "spherewalk/survey/room_parts.h"

#include <memory>
#include <numeric>
#include <optional>
#include <vector>

namespace spherewalk::cli {

namespace {

/// The uncovered areas that have one reason, in a line; "" if there are none.
std::string reasonLine(const survey::PlanReport& report, survey::UncoveredReason reason,
                       const survey::PlanOptions& options) {
    double areaM2 = 0;
    int count = 0;
    const survey::UncoveredArea* largest = nullptr;
    for (const survey::UncoveredArea& area : report.uncovered) { // largest first
        if (area.reason == reason) {
            largest = largest == nullptr ? &area : largest;
            areaM2 += area.areaM2;
            ++count;
        }
    }
    if (largest == nullptr) {
        return {};
    }
    const std::string where =
        text(count == 1 ? "around (" : text("in ", count, " areas, the largest around ("),
             fixed(largest->point.x(), 2), ", ", fixed(largest->point.y(), 2), ")");
    return text("\n  ", fixed(areaM2, 2), " m2 ", where, ": ", survey::reasonText(reason, options));
}

std::string planText(const survey::PlanReport& report, const survey::PlanOptions& options,
                     std::ptrdiff_t unknownPlaces = 0) {
    if (report.placements == 0) {
        return text(counted(report.stations, "place", "places"), ", on no rail",
                    unknownPlaces > 0 ? text("; ", counted(unknownPlaces, "is", "are"), " not known for sure")
                                      : "",
                    ". ",
                    report.floorM2 > 0 ? text("Floor ", fixed(report.floorM2, 2), " m2.")
                                       : "Nobody has drawn the room, and no photos have shown it.");
    }
    const double share = report.floorM2 > 0 ? 100 * report.uncoveredM2 / report.floorM2 : 0;
    std::string result =
        text(report.stations, " stations on ", report.placements, " rail placements, ",
             fixed(report.metresWalked, 0), " m to walk, about ",
             humanDuration(std::chrono::duration<double>(60 * report.minutes)), " at ",
             fixed(options.secondsPerPhoto, 0), " s a photo and ", fixed(options.secondsPerPlacement, 0),
             " s a placement.\n", "Floor ", fixed(report.floorM2, 2), " m2, not covered ",
             fixed(report.uncoveredM2, 2), " m2 (", fixed(share, 0), " %)");
    for (const auto reason : {survey::UncoveredReason::Clearance, survey::UncoveredReason::Enclosed,
                              survey::UncoveredReason::BetweenStops}) {
        result += reasonLine(report, reason, options);
    }
    return result;
}

Json planJson(const survey::PlanReport& report, const survey::PlanOptions& options) {
    Json uncovered = Json::array();
    for (const survey::UncoveredArea& area : report.uncovered) {
        uncovered.push_back({{"area_m2", area.areaM2},
                             {"point_m", {area.point.x(), area.point.y()}},
                             {"reason", survey::reasonText(area.reason, options)}});
    }
    return {{"stations", report.stations},
            {"placements", report.placements},
            {"metres_walked", report.metresWalked},
            {"minutes", report.minutes},
            {"floor_m2", report.floorM2 > 0 ? Json(report.floorM2) : Json()},
            {"uncovered_m2", report.floorM2 > 0 ? Json(report.uncoveredM2) : Json()},
            {"uncovered", uncovered}};
}

struct NewArguments {
    std::string survey;
    std::vector<double> rect;
    std::string outline;
    bool isByHand = false;
    double ceilingM = 0;
    survey::PlanOptions plan;
    std::optional<double> stepM;
    std::vector<double> heightsM;
    std::string profile = "auto";
};

survey::PlanOptions planGiven(const NewArguments& options, double stepM) {
    survey::PlanOptions plan = options.plan;
    plan.stepM = options.stepM.value_or(stepM);
    if (!options.heightsM.empty()) {
        plan.heightsM = options.heightsM;
    }
    return plan;
}

survey::Room roomGiven(const NewArguments& options) {
    survey::Room room;
    room.ceilingM = options.ceilingM;
    if (!options.rect.empty()) {
        const auto& r = options.rect;
        if (!(r[0] < r[2] && r[1] < r[3])) {
            throw Error(ErrorKind::InvalidInput,
                        "The rectangle needs x0 < x1 and y0 < y1: --rect x0,y0,x1,y1.");
        }
        if (options.ceilingM == 0) {
            throw Error(ErrorKind::InvalidInput, "The ceiling's height is missing: give --ceiling.");
        }
        room.outline = {{r[0], r[1]}, {r[2], r[1]}, {r[2], r[3]}, {r[0], r[3]}};
        return room;
    }
    constexpr std::uint64_t kLargest = 16ULL << 20;
    const Json json = parseJson(readTextFile(options.outline, kLargest), options.outline);
    survey::Outline outline = survey::parseOutline(json, options.outline);
    room.outline = std::move(outline.outline);
    room.obstacles = std::move(outline.obstacles);
    room.names = std::move(outline.names);
    if (options.ceilingM == 0 && !outline.ceilingM) {
        throw Error(ErrorKind::InvalidInput,
                    text("The ceiling's height is missing: give --ceiling, or \"ceiling_m\" in ",
                         options.outline, "."));
    }
    room.ceilingM = options.ceilingM == 0 ? *outline.ceilingM : options.ceilingM;
    return room;
}

/// A survey without a plan.
Result createByHand(const NewArguments& options) {
    const survey::Room room = survey::unknownRoom();
    survey::PlanOptions plan = planGiven(options, survey::kStepByHandM);
    plan.areHeightsGuessed = options.heightsM.empty();
    plan.validate(room);
    const std::filesystem::path folder = options.survey;
    auto store = store::SurveyStore::create(folder, folder.stem().string(), room, plan, {});
    store.setCaptureProfile(survey::parseProfile(options.profile));
    return {
        {{"survey", options.survey}, {"id", store.info().uuid}},
        text("Made the survey ", options.survey,
             ", without a plan. Capture or import the photos; align --positions free solves where they were "
             "taken, and the room around them.")};
}

Result create(const NewArguments& options) {
    if (options.isByHand) {
        return createByHand(options);
    }
    const survey::Room room = roomGiven(options);
    const survey::PlanOptions planOptions = planGiven(options, survey::PlanOptions().stepM);
    room.validate();
    planOptions.validate(room);
    const std::optional<survey::CaptureProfile> profile = survey::parseProfile(options.profile);
    const survey::Plan plan = survey::plan(room, planOptions);
    const survey::PlanReport report = survey::report(room, planOptions, plan);
    const std::filesystem::path folder = options.survey;
    auto store = store::SurveyStore::create(folder, folder.stem().string(), room, planOptions, plan);
    store.setCaptureProfile(profile);
    Json json = planJson(report, planOptions);
    json["survey"] = options.survey;
    json["profile"] = survey::profileText(profile);
    json["id"] = store.info().uuid;
    return {json, text("Made the survey ", options.survey, ".\n", planText(report, planOptions))};
}

struct PlanArguments {
    std::string survey;
    bool list = false;
    std::string sheet;
    int tags = 0;
    int firstTag = 0;
    double tagSizeM = 0.16;
    std::string tagSheet;
};

std::string railLine(std::size_t number, const survey::RailPlacement& rail) {
    const Eigen::Vector2d last = rail.stop(rail.stops - 1);
    return text("\nrail ", number, ": ", rail.stops, " stops from (", fixed(rail.origin.x(), 3), ", ",
                fixed(rail.origin.y(), 3), ") to (", fixed(last.x(), 3), ", ", fixed(last.y(), 3), ")");
}

Result shownPlan(const PlanArguments& options) {
    const auto store = store::SurveyStore::open(options.survey, store::Access::Read);
    const survey::PlanOptions planOptions = store.planOptions();
    const survey::Plan plan = store.plan();
    const survey::Room known = store.knownRoom();
    survey::PlanReport report;
    if (known.outline.empty()) {
        report.stations = static_cast<int>(plan.stations.size());
    } else {
        report = survey::report(known, planOptions, plan);
    }
    Json json = planJson(report, planOptions);
    const std::vector<store::StationRecord> stations = store.stations();
    const auto unknown = std::ranges::count(stations, false, &store::StationRecord::isPlaceKnown);
    std::string words = planText(report, planOptions, unknown);
    Json rails = Json::array();
    const survey::RoomParts parts(store.room());
    const std::vector<std::size_t> rooms = parts.ofRails(plan);
    for (std::size_t i = 0; i < plan.placements.size(); ++i) {
        const survey::RailPlacement& rail = plan.placements[i];
        const std::string room = rooms.empty() ? std::string() : parts.names()[rooms[i]];
        rails.push_back({{"x_m", rail.origin.x()},
                         {"y_m", rail.origin.y()},
                         {"heading_deg", Degrees(rail.heading).value()},
                         {"stops", rail.stops},
                         {"step_m", rail.stepM},
                         {"room", room}});
        words += options.list ? railLine(i + 1, rail) + (room.empty() ? "" : text(", ", room)) : "";
    }
    json["rails"] = rails;
    Json list = Json::array();
    for (const store::StationRecord& station : stations) {
        const Eigen::Vector3d& p = station.station.positionM;
        list.push_back({{"id", station.id},
                        {"name", station.name},
                        {"position_m", station.isPlaceKnown ? Json({p.x(), p.y(), p.z()}) : Json()}});
    }
    json["station_list"] = list;
    if (!options.sheet.empty()) {
        if (known.outline.empty()) {
            throw Error(
                ErrorKind::InvalidInput,
                text("The survey ", options.survey,
                     " has no room for a marking sheet: nobody has drawn it, and no photos have shown "
                     "it. Draw it on the Plan page, or take out --sheet."));
        }
        writeFile(options.sheet, report::markingSheet(store.info().name, known, planOptions, plan));
        json["sheet"] = options.sheet;
        words += text("\nWrote ", options.sheet, ": the plan to scale, and the tape distances of each rail.");
    }
    if (options.tags > 0) {
        const std::string file =
            options.tagSheet.empty() ? (store.folder() / "tags.pdf").string() : options.tagSheet;
        std::vector<int> numbers(static_cast<std::size_t>(options.tags));
        std::iota(numbers.begin(), numbers.end(), options.firstTag);
        writeFile(file, report::tagSheet(store.info().name, numbers, options.tagSizeM));
        json["tag_sheet"] = file;
        words += text("\nWrote ", file, ": AprilTags ", numbers.front(), " to ", numbers.back(), ", ",
                      fixed(100 * options.tagSizeM, 1), " cm wide, a page each. Print them at 100 %.");
    }
    return {json, words};
}

} // namespace

void addNew(Commands& commands) {
    const auto options = std::make_shared<NewArguments>();
    const program::Command command = commands.add(
        "new", "Plan a new survey", [options](Context& /*context*/) { return create(*options); });
    command.option("survey", options->survey, "Folder to make, <name>.spherewalk").required();
    const program::Command shape = command.oneOf("shape", "The room's outline");
    shape.option("--rect", options->rect, "Rectangular room: x0,y0,x1,y1 in metres")
        .separatedBy(',')
        .count(4);
    shape.option(
        "--outline", options->outline,
        R"(JSON file: [[x,y],...] or {"outline":...,"obstacles":...,"ceiling_m":...,"rooms":[{"name":...,"at":[x,y]},...]})");
    shape.flag("--by-hand", options->isByHand,
               "Not known: photos are taken by hand, and align --positions free solves it from them");
    command.option("--ceiling", options->ceilingM, "Height of the ceiling, metres");
    command.option("--step", options->stepM,
                   text("Distance of neighbouring stations, metres; without it ",
                        fixed(survey::PlanOptions().stepM, 1), ", and ", fixed(survey::kStepByHandM, 1),
                        " by hand"));
    command
        .option("--height", options->heightsM,
                text("Height of the lens above the floor, metres; several make layers; without it ",
                     fixed(survey::PlanOptions().heightsM.front(), 1), ", which is a guess by hand"))
        .separatedBy(',');
    command.option("--rail-stops", options->plan.railStops, "Stops of the cart on the rail").showDefault();
    command.option("--profile", options->profile, text("How the camera is set. ", kProfileHelp))
        .showDefault();
    command.option("--clearance", options->plan.clearanceM, "From a stop to walls and obstacles, metres")
        .showDefault();
}

void addPlan(Commands& commands) {
    const auto options = std::make_shared<PlanArguments>();
    const program::Command command = commands.add(
        "plan", "Show a survey's plan", [options](Context& /*context*/) { return shownPlan(*options); });
    command.option("survey", options->survey, "Folder of the survey").required();
    command.option("--sheet", options->sheet,
                   "PDF to write: the plan to scale, with tape distances for laying the rails");
    const program::Option tags =
        command.option("--tags", options->tags, "Number of AprilTags (36h11) to print, a page each")
            .range(1, photo::kTagNumbers);
    command.option("--tag-size", options->tagSizeM, "Side of the tags' black square, metres")
        .range(0.02, 0.6)
        .showDefault()
        .needs(tags);
    command.option("--first-tag", options->firstTag, "Number of the first tag: each hangs once in a survey")
        .range(0, photo::kTagNumbers - 1)
        .showDefault()
        .needs(tags);
    command.option("--tag-sheet", options->tagSheet, "PDF of the tags; by default tags.pdf in the survey")
        .needs(tags);
    command.flag("--list", options->list, "List the rail placements in walking order");
}

} // namespace spherewalk::cli
