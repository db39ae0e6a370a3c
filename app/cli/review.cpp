// SPDX-License-Identifier: GPL-3.0-or-later
#include "command.h"
#include "photo_names.h"

#include "spherewalk/base/counted.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/judge_survey.h"
#include "spherewalk/jobs/retakes.h"

#include <map>
#include <memory>

namespace spherewalk::cli {

namespace {

struct Options {
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

void decide(store::SurveyStore& store, const Options& options, const std::vector<std::string>& names,
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

void change(const Options& options) {
    auto store = store::SurveyStore::open(options.survey, store::Access::Write);
    for (const std::string& name : options.chosen) {
        store.choosePhoto(photoNamed(store, name).id);
    }
    decide(store, options, options.accepted, store::Decision::Accepted);
    decide(store, options, options.rejected, store::Decision::Rejected);
    decide(store, options, options.opened, store::Decision::Open);
    decide(store, options, options.noted, std::nullopt);
}

Result list(const store::SurveyStore& store) {
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
                          {"verdict", verdict ? Json(name(verdict->result)) : Json()},
                          {"findings", verdict ? jobs::verdictOf(*verdict).sentence() : std::string()},
                          {"decision", name(review.decision)},
                          {"note", review.note}});
        if (found != reviews.end()) {
            lines += text("\n", photo.fileName, " (", station, "): ", name(review.decision),
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

Result review(const Options& options, Context& context) {
    if (options.judge != "none") {
        auto store = store::SurveyStore::open(options.survey, store::Access::Write);
        jobs::judgeSurvey(store, options.judge == "all", context.progress, context.stop);
    }
    if (options.isChange()) {
        change(options);
    }
    return list(store::SurveyStore::open(options.survey, store::Access::Read));
}

} // namespace

void addReview(Commands& commands) {
    const auto options = std::make_shared<Options>();
    CLI::App& command = commands.add("review", "Accept or reject photos, and list what was decided",
                                     [options](Context& context) { return review(*options, context); });
    command.add_option("survey", options->survey, "Folder of the survey")->required();
    command.add_option("--accept", options->accepted, "Photos, each by its file, station, or number");
    command.add_option("--reject", options->rejected,
                       "Photos that no dataset shall have, and whose stations are to be taken again");
    command.add_option("--reopen", options->opened, "Photos whose decision is withdrawn");
    command.add_option("--choose", options->chosen,
                       "Photos that shall stand for their station, in place of its other photos");
    command.add_option("--annotate", options->noted, "Photos that only get the note");
    command
        .add_option("--judge", options->judge,
                    "Check photos first: new ones that have no verdict yet, or all of them anew, now that "
                    "their neighbours are there")
        ->check(CLI::IsMember({"none", "new", "all"}))
        ->capture_default_str();
    command.add_option("--note", options->note, "One line that is kept with all photos of this call");
}

} // namespace spherewalk::cli
