// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/command.h"

#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/check_places.h"
#include "spherewalk/jobs/solution_findings.h"
#include "spherewalk/render/dataset.h"
#include "spherewalk/store/survey_store.h"

#include <algorithm>
#include <memory>

namespace spherewalk::cli {

namespace {

/// Taken pictures that are not in the survey, of stations that have another photo.
std::size_t picturesNotNeeded(const store::SurveyStore& store) {
    const std::vector<survey::Shot> shots = store.openShots();
    return static_cast<std::size_t>(std::ranges::count_if(shots, [&](const survey::Shot& shot) {
        return shot.step == survey::ShotStep::Taken && store.chosenPhoto(shot.station);
    }));
}

/// How many photos the active solution calls "good", "doubtful" and "failed", and how many came after it.
struct SolvedCounts {
    explicit SolvedCounts(const jobs::SolutionFindings& findings) {
        for (const auto quality :
             {survey::Quality::Good, survey::Quality::Doubtful, survey::Quality::Failed}) {
            add(std::ranges::count(findings.photos, quality, &jobs::PhotoFinding::quality), name(quality),
                name(quality));
        }
        const auto isLater = [](const jobs::PhotoFinding& photo) { return !photo.quality; };
        add(std::ranges::count_if(findings.photos, isLater), "not_aligned", "not aligned yet");
    }

    void add(std::ptrdiff_t count, std::string_view key, std::string_view what) {
        json[std::string(key)] = count;
        words += count > 0 ? text(words.empty() ? "" : ", ", count, " ", what) : "";
    }

    Json json;
    std::string words;
};

Result status(const std::string& survey) {
    const auto store = store::SurveyStore::open(survey, store::Access::Read);
    const store::Counts counts = store.counts();
    const auto solution = jobs::activeFindings(store);
    const auto aligned = solution ? std::optional<SolvedCounts>(*solution) : std::nullopt;
    const auto missing = store.stationsWithoutPhoto();
    std::string words = text(store.info().name, ": ", counts.stationsWithPhoto, " of ", counts.stations,
                             " stations have a photo (", counted(counts.photos, "photo", "photos"), ").");
    words += missing.empty() ? "" : text("\nNext: ", missing.front().name, ".");
    words += counts.rejectedPhotos == 0 ? ""
                                        : text("\n",
                                               counted(counts.rejectedPhotos, "photo was rejected and is",
                                                       "photos were rejected and are"),
                                               " to be taken again.");
    const std::size_t notNeeded = picturesNotNeeded(store);
    if (const auto interrupted = static_cast<std::size_t>(counts.openShots) - notNeeded; interrupted > 0) {
        words += text(
            "\n", counted(interrupted, "shot was interrupted; capture settles it first, and shots lists it.",
                          "shots were interrupted; capture settles them first, and shots lists them."));
    }
    if (notNeeded > 0) {
        words += text(
            "\n", counted(notNeeded,
                          "picture was never fetched, and its station has another photo: shots lists it, "
                          "and closes it with --give-up.",
                          "pictures were never fetched, and their stations have other photos: shots lists "
                          "them, and closes them with --give-up."));
    }
    words += counts.unclearShots == 0 ? ""
                                      : text("\n", counted(counts.unclearShots, "shot needs", "shots need"),
                                             " a person's decision, which shots takes:");
    Json unclear = Json::array();
    for (const survey::Shot& shot : store.unclearShots()) {
        const std::string name = store.station(shot.station).name;
        words += text("\n  ", name, ": ", shot.note);
        unclear.push_back({{"station", name}, {"note", shot.note}});
    }
    words += solution ? text("\nRotations: ", solution->solution.source, " (", solution->solution.model,
                             "): ", aligned->words, ".")
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
             {"pictures_not_needed", notNeeded},
             {"unclear_shots", unclear},
             {"solution", solution ? Json(solution->solution.source) : Json()},
             {"aligned", aligned ? aligned->json : Json()}},
            words};
}

Result checkDataset(const std::string& path, Context& context) {
    const render::Dataset dataset =
        render::Dataset::open(path, render::Verify::Hashes, context.progress, context.stop);
    const std::vector<std::string> findings = jobs::checkPlaces(dataset, context.progress, context.stop);
    const std::size_t photos = dataset.info().photos.size();
    if (findings.empty()) {
        return {{{"kind", "dataset"}, {"photos", photos}, {"sound", true}},
                text("The dataset ", path, " is sound: ", photos, " photos with the right hashes.")};
    }
    std::string words = text("Checked ", photos, " photos of the dataset ", path, ": ",
                             counted(findings.size(), "finding", "findings"), ".");
    for (const std::string& sentence : findings) {
        words += text("\n  ", sentence);
    }
    return {
        {{"kind", "dataset"}, {"photos", photos}, {"sound", false}, {"findings", findings}}, words, false};
}

Result checkSurvey(const std::string& path, Context& context) {
    const auto store = store::SurveyStore::open(path, store::Access::Read);
    const store::SurveyCheck check = store.check(context.progress, context.stop);
    const std::vector<std::string> places = check.isSound()
                                                ? jobs::checkPlaces(store, context.progress, context.stop)
                                                : std::vector<std::string>();
    const bool isSound = check.isSound() && places.empty();
    Json findings = Json::array();
    std::string words = text("Checked ", check.photosChecked, " photos and the database of ", path, ": ");
    words += isSound ? "all is as it was recorded."
                     : text(counted(check.photos.size() + check.database.size() + places.size(), "finding",
                                    "findings"),
                            ".");
    const auto add = [&](const std::string& sentence) {
        findings.push_back(sentence);
        words += text("\n  ", sentence);
    };
    for (const store::PhotoFinding& finding : check.photos) {
        add(finding.sentence);
    }
    for (const std::string& sentence : check.database) {
        add(sentence);
    }
    for (const std::string& sentence : places) {
        add(sentence);
    }
    for (const std::string& file : check.filesWithoutPhoto) {
        words += text("\n  photos/", file, " belongs to no photo of the survey (harmless)");
    }
    return {{{"kind", "survey"},
             {"photos", check.photosChecked},
             {"sound", isSound},
             {"findings", findings},
             {"files_without_photo", check.filesWithoutPhoto}},
            words,
            isSound};
}

Result checkPath(const std::string& path, Context& context) {
    const bool isDataset = std::filesystem::exists(std::filesystem::path(path) / render::kDatasetFile);
    return isDataset ? checkDataset(path, context) : checkSurvey(path, context);
}

} // namespace

void addStatus(Commands& commands) {
    const auto survey = std::make_shared<std::string>();
    const program::Command command = commands.add("status", "How far a survey is",
                                                  [survey](Context& /*context*/) { return status(*survey); });
    command.option("survey", *survey, "Folder of the survey").required();
}

void addCheck(Commands& commands) {
    const auto path = std::make_shared<std::string>();
    const program::Command command =
        commands.add("check", "Check every file of a survey or a dataset",
                     [path](Context& context) { return checkPath(*path, context); });
    command.option("path", *path, "Folder of the survey or dataset").required();
}

} // namespace spherewalk::cli
