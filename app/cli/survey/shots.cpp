// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/command.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/camera/endpoint.h"
#include "spherewalk/store/survey_store.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace spherewalk::cli {

namespace {

struct ShotsArguments {
    std::string survey;
    std::vector<std::string> confirmed;
    std::vector<std::string> givenUp;
};

/// The shots that have no end yet, oldest first.
std::vector<survey::Shot> shotsWithoutEnd(const store::SurveyStore& store) {
    std::vector<survey::Shot> shots = store.openShots();
    for (survey::Shot& shot : store.unclearShots()) {
        shots.push_back(std::move(shot));
    }
    std::ranges::sort(shots, {}, &survey::Shot::id);
    return shots;
}

/// Those of the station, or the one with the number. Errors: NotFound.
std::vector<survey::Shot> shotsNamed(const store::SurveyStore& store, const std::string& name) {
    std::vector<survey::Shot> shots = shotsWithoutEnd(store);
    std::erase_if(shots, [&](const survey::Shot& shot) {
        return name != "all" && name != text(static_cast<long long>(shot.id)) &&
               name != store.station(shot.station).name;
    });
    if (shots.empty()) {
        throw Error(ErrorKind::NotFound,
                    text("No shot without an end is named ", printable(name), " in the survey ",
                         store.folder().string(), "; shots lists their numbers and stations."));
    }
    return shots;
}

void confirm(store::SurveyStore& store, const survey::Shot& shot) {
    if (shot.step != survey::ShotStep::Unclear || shot.fileUrl.empty()) {
        throw Error(ErrorKind::InvalidInput,
                    text("Shot ", static_cast<long long>(shot.id), " at ", store.station(shot.station).name,
                         " has no picture to confirm; give it up, and take the station again."));
    }
    store.markTaken(shot.id, shot.fileUrl);
}

void decide(const ShotsArguments& options) {
    auto store = store::SurveyStore::open(options.survey, store::Access::Write);
    for (const std::string& name : options.confirmed) {
        for (const survey::Shot& shot : shotsNamed(store, name)) {
            confirm(store, shot);
        }
    }
    for (const std::string& name : options.givenUp) {
        for (const survey::Shot& shot : shotsNamed(store, name)) {
            store.giveUp(shot.id);
        }
    }
}

std::string pictureOf(const survey::Shot& shot) {
    return shot.fileUrl.empty() ? "" : camera::fileNameOfUrl(shot.fileUrl.substr(0, shot.fileUrl.find('#')));
}

std::string sentenceOn(const survey::Shot& shot) {
    switch (shot.step) {
    case survey::ShotStep::Unclear:
        return shot.note;
    case survey::ShotStep::Taken:
        return text("The photo ", pictureOf(shot), " lies on the camera ", shot.cameraSerial,
                    "; capture downloads it.");
    default:
        return "It was interrupted; capture settles it.";
    }
}

/// The options that end the shot.
std::string waysOut(const survey::Shot& shot) {
    const bool canConfirm = shot.step == survey::ShotStep::Unclear && !shot.fileUrl.empty();
    const std::string number = text(static_cast<long long>(shot.id));
    return text(canConfirm ? text(" If ", pictureOf(shot), " is its picture: --confirm ", number, ".") : "",
                " To wait for no picture: --give-up ", number, ".");
}

Result listedShots(const store::SurveyStore& store) {
    Json json = Json::array();
    std::string lines;
    for (const survey::Shot& shot : shotsWithoutEnd(store)) {
        const std::string station = store.station(shot.station).name;
        const std::string sentence = sentenceOn(shot);
        json.push_back({{"shot", shot.id},
                        {"station", station},
                        {"step", name(shot.step)},
                        {"picture", pictureOf(shot)},
                        {"sentence", sentence}});
        lines += text("\n", static_cast<long long>(shot.id), " at ", station, ": ", sentence, waysOut(shot));
    }
    const std::string count = counted(json.size(), "shot has", "shots have");
    return {{{"shots", json}}, text(count, " no end yet.", lines)};
}

Result shots(const ShotsArguments& options) {
    if (!options.confirmed.empty() || !options.givenUp.empty()) {
        decide(options);
    }
    return listedShots(store::SurveyStore::open(options.survey, store::Access::Read));
}

} // namespace

void addShots(Commands& commands) {
    const auto options = std::make_shared<ShotsArguments>();
    const program::Command command =
        commands.add("shots", "List the shots without an end, and decide on them",
                     [options](Context& /*context*/) { return shots(*options); });
    command.option("survey", options->survey, "Folder of the survey").required();
    command.option("--confirm", options->confirmed,
                   "Shots whose doubtful picture is of their station, each by its number or station; capture "
                   "downloads them");
    command.option("--give-up", options->givenUp,
                   "Shots whose picture nobody waits for any more, each by its number or station, or all");
}

} // namespace spherewalk::cli
