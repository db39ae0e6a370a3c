// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/command.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/judge_survey.h"
#include "spherewalk/jobs/solution_findings.h"
#include "spherewalk/store/survey_store.h"

#include <map>
#include <memory>

namespace spherewalk::cli {

namespace {

store::StationRecord stationNamed(const store::SurveyStore& store, const std::string& name) {
    for (store::StationRecord& station : store.stations()) {
        if (station.name == name || text(static_cast<long long>(station.id)) == name) {
            return std::move(station);
        }
    }
    throw Error(ErrorKind::NotFound, text("There is no station ", printable(name), " in the survey ",
                                          store.folder().string(), "; plan --json lists them."));
}

struct ReviewArguments {
    std::string survey;
    std::vector<std::string> accepted;
    std::vector<std::string> rejected;
    std::vector<std::string> opened;
    std::vector<std::string> noted;
    std::vector<std::string> chosen;
    std::string note;
    std::string judge = "none";

    bool isChange() const {
        return !(accepted.empty() && rejected.empty() && opened.empty() && noted.empty() && chosen.empty());
    }
};

void decide(store::SurveyStore& store, const ReviewArguments& options, const std::vector<std::string>& names,
            std::optional<store::Decision> decision) {
    for (const std::string& name : names) {
        store::Review review = store.review(photoNamed(store, name).id);
        review.decision = decision.value_or(review.decision);
        if (!options.note.empty() || !decision) {
            review.note = options.note;
        }
        store.setReview(review);
    }
}

void changeReviews(const ReviewArguments& options) {
    auto store = store::SurveyStore::open(options.survey, store::Access::Write);
    for (const std::string& name : options.chosen) {
        store.choosePhoto(photoNamed(store, name).id);
    }
    decide(store, options, options.accepted, store::Decision::Accepted);
    decide(store, options, options.rejected, store::Decision::Rejected);
    decide(store, options, options.opened, store::Decision::Open);
    decide(store, options, options.noted, std::nullopt);
}

Result listedPhotos(const store::SurveyStore& store) {
    std::map<std::int64_t, store::Review> reviews;
    for (const store::Review& review : store.reviews()) {
        reviews.emplace(review.photo, review);
    }
    Json photos = Json::array();
    std::string lines;
    const std::vector<jobs::Retake> retakes = jobs::retakes(store);
    for (const jobs::Retake& retake : retakes) {
        lines +=
            text("\n", retake.station.name, " is ", retake.isFailed ? "failed" : "doubtful",
                 retake.isSurrounded ? ", and its neighbours can stand in for it" : ", and leaves a hole",
                 ": ", retake.sentence);
    }
    std::map<store::Decision, int> counts;
    for (const store::PhotoRecord& photo : store.photos()) {
        const auto found = reviews.find(photo.id);
        const store::Review review =
            found == reviews.end() ? store::Review{photo.id, store::Decision::Open, {}} : found->second;
        const std::string station = store.station(photo.station).name;
        ++counts[review.decision];
        const auto verdict = store.verdict(photo.id);
        photos.push_back({{"id", photo.id},
                          {"file", photo.fileName},
                          {"station", station},
                          {"chosen", photo.choose},
                          {"verdict", verdict ? Json(name(verdict->quality)) : Json()},
                          {"findings", verdict ? jobs::verdictOf(*verdict).sentence() : std::string()},
                          {"decision", name(review.decision)},
                          {"note", review.note}});
        if (found != reviews.end()) {
            lines += text("\n", store::photoAtStation(photo.fileName, station), ": ", name(review.decision),
                          review.note.empty() ? "" : ", ", review.note);
        }
    }
    return {{{"photos", photos},
             {"to_take", store.stationsWithoutPhoto().size()},
             {"retakes", jobs::toJson(retakes)}},
            text(counted(counts[store::Decision::Accepted], "photo", "photos"), " accepted, ",
                 counts[store::Decision::Rejected], " rejected, ", counts[store::Decision::Open], " open; ",
                 counted(store.stationsWithoutPhoto().size(), "station still needs", "stations still need"),
                 " a photo.", lines)};
}

Result review(const ReviewArguments& options, Context& context) {
    if (options.judge != "none") {
        auto store = store::SurveyStore::open(options.survey, store::Access::Write);
        const jobs::JudgeReport judged =
            jobs::judgeSurvey(store, options.judge == "all", context.progress, context.stop);
        const std::string notCompared =
            jobs::notComparedText(judged.judged, judged.notCompared, judged.contentNotCompared);
        if (!notCompared.empty()) {
            context.progress.warning(notCompared);
        }
    }
    if (options.isChange()) {
        changeReviews(options);
    }
    return listedPhotos(store::SurveyStore::open(options.survey, store::Access::Read));
}

struct RetagArguments {
    std::string survey;
    std::vector<std::string> photos;
    std::vector<std::string> stations;
    bool isProposed = false;
};

std::vector<jobs::PhotoPlace> placesOf(const store::SurveyStore& store, const RetagArguments& options) {
    if (options.photos.size() != options.stations.size()) {
        throw Error(ErrorKind::InvalidInput,
                    text(options.photos.size(), " photos and ", options.stations.size(),
                         " stations were given; give a --station for each --photo."));
    }
    std::vector<jobs::PhotoPlace> places;
    if (options.isProposed) {
        const auto findings = jobs::activeFindings(store);
        places = findings ? findings->retags() : places;
    }
    for (std::size_t i = 0; i < options.photos.size(); ++i) {
        places.push_back(
            {photoNamed(store, options.photos[i]).id, stationNamed(store, options.stations[i]).id});
    }
    return places;
}

Result retag(const RetagArguments& options, Context& context) {
    auto store = store::SurveyStore::open(options.survey, store::Access::Write);
    const std::vector<jobs::PhotoPlace> places = placesOf(store, options);
    Json moved = Json::array();
    std::string words = text("Moved ", places.size(), " photos to other stations.");
    jobs::retagPhotos(store, places, context.progress, context.stop);
    for (const jobs::PhotoPlace& place : places) {
        const store::PhotoRecord photo = store.photo(place.photo);
        const std::string station = store.station(place.station).name;
        moved.push_back({{"photo", photo.fileName}, {"station", station}});
        words += text("\n", photo.fileName, ": ", station);
    }
    return {{{"moved", moved}}, words};
}

} // namespace

void addReview(Commands& commands) {
    const auto options = std::make_shared<ReviewArguments>();
    const program::Command command =
        commands.add("review", "Accept or reject photos, and list what was decided",
                     [options](Context& context) { return review(*options, context); });
    command.option("survey", options->survey, "Folder of the survey").required();
    command.option("--accept", options->accepted, "Photos, each by its file, station, or number");
    command.option("--reject", options->rejected,
                   "Photos that no dataset shall have, and whose stations are to be taken again");
    command.option("--reopen", options->opened, "Photos whose decision is withdrawn");
    command.option("--choose", options->chosen,
                   "Photos that shall stand for their station, in place of its other photos");
    command.option("--annotate", options->noted, "Photos that only get the note");
    command
        .option("--judge", options->judge,
                "Check photos first: new ones that have no verdict yet, or all of them anew, now that "
                "their neighbours are there")
        .among({"none", "new", "all"})
        .showDefault();
    command.option("--note", options->note, "One line that is kept with all photos of this call");
}

void addRetag(Commands& commands) {
    const auto options = std::make_shared<RetagArguments>();
    const program::Command command =
        commands.add("retag", "Say at which station photos were really taken",
                     [options](Context& context) { return retag(*options, context); });
    command.option("survey", options->survey, "Folder of the survey").required();
    command.option("--photo", options->photos, "Photo, by its file, station, or number; may be repeated");
    command.option("--station", options->stations,
                   "Station of the photo in the same place of the list, by its name or number");
    command.flag("--proposed", options->isProposed, "All that the active solution proposes");
}

} // namespace spherewalk::cli
