// SPDX-License-Identifier: GPL-3.0-or-later
#include "command.h"
#include "photo_names.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/solution_findings.h"

#include <memory>

namespace spherewalk::cli {

namespace {

struct Options {
    std::string survey;
    std::vector<std::string> photos;
    std::vector<std::string> stations;
    bool isProposed = false;
};

std::vector<jobs::PhotoPlace> placesOf(const store::SurveyStore& store, const Options& options) {
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

Result retag(const Options& options, Context& context) {
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

void addRetag(Commands& commands) {
    const auto options = std::make_shared<Options>();
    CLI::App& command = commands.add("retag", "Say at which station photos were really taken",
                                     [options](Context& context) { return retag(*options, context); });
    command.add_option("survey", options->survey, "Folder of the survey")->required();
    command.add_option("--photo", options->photos, "Photo, by its file, station, or number; may be repeated");
    command.add_option("--station", options->stations,
                       "Station of the photo in the same place of the list, by its name or number");
    command.add_flag("--proposed", options->isProposed, "All that the active solution proposes");
}

} // namespace spherewalk::cli
