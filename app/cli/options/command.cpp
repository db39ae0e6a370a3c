// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/command.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/store/survey_store.h"

#include <utility>

namespace spherewalk::cli {

void Commands::declareJson(const program::Command& command) {
    command.flag("--json", m_json, "Print one JSON object on standard output");
}

program::Command Commands::add(const program::Command& group, const std::string& name,
                               const std::string& help, Run run) {
    const program::Command command = group.command(name, help);
    declareJson(command);
    command.onGiven([this, run = std::move(run)] { m_chosen = run; });
    return command;
}

program::Command Commands::addGroup(const std::string& name, const std::string& help) {
    const program::Command group = m_program.command(name, help);
    group.requireCommand();
    return group;
}

void Commands::addFlag(const program::Command& group, const std::string& flag, const std::string& help,
                       Run run) {
    group.onFlag(flag, help, [this, run = std::move(run)] { m_chosen = run; });
    declareJson(group);
}

void declareTolerance(const program::Command& command, double& tolerancePx) {
    command
        .option("--tolerance", tolerancePx,
                "Pixels of the robot's camera that 95 of 100 places may be displaced by")
        .range(0.01, 1000.0)
        .showDefault();
}

void checkPlot(const std::filesystem::path& plot) {
    if (!plot.empty() && plot.extension() != ".svg") {
        throw Error(ErrorKind::InvalidInput,
                    text("The plot is an SVG picture: give --plot a name that ends in .svg, not ",
                         printable(plot.string()), "."));
    }
    const std::filesystem::path folder = plot.has_parent_path() ? plot.parent_path() : ".";
    if (!std::filesystem::is_directory(folder)) {
        throw Error(ErrorKind::NotFound, text("The plot cannot be written: there is no folder ",
                                              printable(folder.string()), "; make it first."));
    }
}

void writePlot(const std::string& plot, const std::string& svg, Result& result) {
    writeFile(plot, bytesOf(svg));
    result.json["plot"] = plot;
    result.text += text("\nWrote ", plot, ".");
}

store::PhotoRecord photoNamed(const store::SurveyStore& store, const std::string& name) {
    for (store::PhotoRecord& photo : store.photos()) {
        if (photo.fileName == name || text(static_cast<long long>(photo.id)) == name) {
            return std::move(photo);
        }
    }
    for (store::PhotoRecord& photo : store.chosenPhotos()) {
        if (store.station(photo.station).name == name) {
            return std::move(photo);
        }
    }
    throw Error(ErrorKind::NotFound, text("There is no photo ", printable(name), " in the survey ",
                                          store.folder().string(), "; review lists them."));
}

} // namespace spherewalk::cli
