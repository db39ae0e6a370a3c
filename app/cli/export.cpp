// SPDX-License-Identifier: GPL-3.0-or-later
#include "command.h"

#include "spherewalk/base/text.h"
#include "spherewalk/jobs/export_dataset.h"

#include <memory>

namespace spherewalk::cli {

namespace {

struct Options {
    std::string survey;
    std::string dataset;
    jobs::ExportOptions write;
    std::string scene = "sphere";
    bool isCheck = false;
};

jobs::ExportOptions exportOptions(const Options& options) {
    jobs::ExportOptions wanted = options.write;
    wanted.scene = render::sceneKind(options.scene);
    return wanted;
}

Result check(const Options& options, Context& context) {
    const auto store = store::SurveyStore::open(options.survey, store::Access::Read);
    const jobs::ExportCheck check =
        jobs::checkExport(store, options.dataset, exportOptions(options), context.progress, context.stop);
    std::string words = text(check.photos, " photos, about ", humanBytes(check.totalBytes), " and ",
                             humanDuration(std::chrono::duration<double>(check.seconds)), "; ",
                             humanBytes(check.freeBytes), " are free.");
    for (const auto& sentences : {check.obstacles, check.doubts}) {
        for (const std::string& sentence : sentences) {
            words += "\n" + sentence;
        }
    }
    return {jobs::toJson(check), words, check.isPossible()};
}

Result exportSurvey(const Options& options, Context& context) {
    const auto store = store::SurveyStore::open(options.survey, store::Access::Read);
    const jobs::ExportReport report =
        jobs::exportDataset(store, options.dataset, exportOptions(options), context.progress, context.stop);
    Json json = jobs::toJson(report);
    json["dataset"] = options.dataset;
    const dataset::WriteReport& written = report.written;
    const double growth =
        100 * (static_cast<double>(written.photoBytes) / static_cast<double>(written.sourceBytes) - 1);
    std::string words = text(
        "Exported ", written.photos, " photos to ", options.dataset, ": ", humanBytes(written.totalBytes),
        " (the photos take ", fixed(growth, 2), " % more than in the survey), in ",
        humanDuration(std::chrono::duration<double>(report.depth.seconds + written.seconds)), ".");
    words += report.withoutPhoto == 0
                 ? ""
                 : text("\n", report.withoutPhoto, " stations have no photo and are left out.");
    words +=
        report.rejected == 0 ? "" : text("\n", report.rejected, " photos were rejected and are left out.");
    return {json, words};
}

} // namespace

void addExport(Commands& commands) {
    const auto options = std::make_shared<Options>();
    CLI::App& command =
        commands.add("export", "Export a survey as a dataset for simulators", [options](Context& context) {
            return options->isCheck ? check(*options, context) : exportSurvey(*options, context);
        });
    command.add_option("survey", options->survey, "Folder of the survey")->required();
    command.add_option("dataset", options->dataset, "Folder to make")->required();
    command
        .add_option("--restart-every", options->write.write.mcusPerInterval,
                    "JPEG blocks (MCUs) between restart markers; the nearest number that divides a row is "
                    "taken")
        ->check(CLI::Range(1, 65535))
        ->capture_default_str();
    command.add_flag("--check", options->isCheck,
                     "Only say how large it would become, how long it would take, and what it would lack");
    command
        .add_option("--scene", options->scene,
                    "Richest scene model to export: sphere, room, or depth; the cheaper ones come with it")
        ->check(CLI::IsMember({"sphere", "room", "depth"}))
        ->capture_default_str();
}

} // namespace spherewalk::cli
