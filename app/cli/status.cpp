// SPDX-License-Identifier: GPL-3.0-or-later
#include "command.h"

#include "spherewalk/base/text.h"
#include "spherewalk/store/survey_store.h"

#include <memory>

namespace spherewalk::cli {

namespace {

Result status(const std::string& survey) {
    const auto store = store::SurveyStore::open(survey, store::Access::Read);
    const store::Counts counts = store.counts();
    const auto solution = store.activeSolution();
    const auto missing = store.stationsWithoutPhoto();
    std::string words = text(store.info().name, ": ", counts.stationsWithPhoto, " of ", counts.stations,
                             " stations have a photo (", counts.photos, " photos).");
    words += missing.empty() ? "" : text("\nNext: ", missing.front().name, ".");
    words += counts.rejectedPhotos == 0
                 ? ""
                 : text("\n", counts.rejectedPhotos, " photos were rejected and are to be taken again.");
    words += counts.openShots == 0
                 ? ""
                 : text("\n", counts.openShots, " shots were interrupted; capture settles them first.");
    words +=
        counts.unclearShots == 0 ? "" : text("\n", counts.unclearShots, " shots need a person's decision:");
    Json unclear = Json::array();
    for (const store::ShotRecord& shot : store.unclearShots()) {
        const std::string name = store.station(shot.station).name;
        words += text("\n  ", name, ": ", shot.note);
        unclear.push_back({{"station", name}, {"note", shot.note}});
    }
    words += solution ? text("\nRotations: ", solution->source, " (", solution->model, ").")
                      : "\nRotations: none yet.";
    const std::string profile = survey::profileText(store.captureProfile());
    words += text("\nThe camera is set: ", profile, ".");
    return {{{"name", store.info().name},
             {"id", store.info().uuid},
             {"profile", profile},
             {"stations", counts.stations},
             {"stations_with_photo", counts.stationsWithPhoto},
             {"photos", counts.photos},
             {"rejected_photos", counts.rejectedPhotos},
             {"next", missing.empty() ? Json() : Json(missing.front().name)},
             {"open_shots", counts.openShots},
             {"unclear_shots", unclear},
             {"solution", solution ? Json(solution->source) : Json()}},
            words};
}

} // namespace

void addStatus(Commands& commands) {
    const auto survey = std::make_shared<std::string>();
    CLI::App& command = commands.add("status", "How far a survey is",
                                     [survey](Context& /*context*/) { return status(*survey); });
    command.add_option("survey", *survey, "Folder of the survey")->required();
}

} // namespace spherewalk::cli
