// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/command.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/judge_survey.h"
#include "spherewalk/store/survey_store.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>

namespace spherewalk::cli {

namespace {

struct PrivacyArguments {
    std::string survey;
    std::string find = "none";
    std::string photo;
    std::vector<double> atDeg;
    std::vector<double> sizeDeg;
    std::vector<int> removed;

    bool isChange() const { return !photo.empty() || !removed.empty(); }
};

/// Errors: InvalidInput if something is missing that says where the region is.
void mark(store::SurveyStore& store, const PrivacyArguments& options) {
    if (options.atDeg.size() != 2 || options.sizeDeg.size() != 2) {
        throw Error(ErrorKind::InvalidInput, "Say where the region of the photo is: --at 30,-5 --size 12,15 "
                                             "marks 12 degrees by 15, 30 degrees "
                                             "left of the photo's middle and 5 below.");
    }
    store.markRegion(photoNamed(store, options.photo).id,
                     {Degrees(options.atDeg[0]), Degrees(options.atDeg[1]), Degrees(options.sizeDeg[0]),
                      Degrees(options.sizeDeg[1])});
}

void changeRegions(const PrivacyArguments& options) {
    auto store = store::SurveyStore::open(options.survey, store::Access::Write);
    for (const int region : options.removed) {
        store.removeRegion(region);
    }
    if (!options.photo.empty()) {
        mark(store, options);
    }
}

/// A line of a table whose columns stand below each other. Names may be wider.
std::string tableLine(const std::array<std::string, 5>& cells) {
    constexpr std::array<std::size_t, 5> kWidths{8, 24, 18, 16, 8};
    std::string line = "\n";
    for (std::size_t i = 0; i < cells.size(); ++i) {
        line += cells[i];
        if (i + 1 < cells.size()) {
            line.append(cells[i].size() < kWidths[i] ? kWidths[i] - cells[i].size() : 1, ' ');
        }
    }
    return line;
}

std::string degreesText(Radians first, std::string_view between, Radians second) {
    return text(fixed(Degrees(first).value(), 1), between, fixed(Degrees(second).value(), 1));
}

Result listedRegions(const store::SurveyStore& store, const std::optional<jobs::FaceReport>& search) {
    std::map<std::int64_t, std::string> names;
    for (const store::PhotoRecord& photo : store.photos()) {
        names.emplace(photo.id, photo.fileName);
    }
    Json listed = Json::array();
    std::string lines;
    std::set<std::int64_t> photos;
    std::size_t regions = 0;
    for (const store::RegionRecord& record : store.regions()) {
        const survey::PrivateRegion& region = record.region;
        listed.push_back({{"region", record.id},
                          {"photo", names[record.photo]},
                          {"azimuth_deg", Degrees(region.azimuth).value()},
                          {"elevation_deg", Degrees(region.elevation).value()},
                          {"width_deg", Degrees(region.width).value()},
                          {"height_deg", Degrees(region.height).value()},
                          {"origin", name(record.origin)}});
        if (record.origin != store::RegionOrigin::Rejected) {
            ++regions;
            photos.insert(record.photo);
        }
        lines +=
            tableLine({text(static_cast<long long>(record.id)), names[record.photo],
                       degreesText(region.azimuth, ", ", region.elevation),
                       degreesText(region.width, " x ", region.height), std::string(name(record.origin))});
    }
    Json json = {{"regions", listed}};
    std::string words;
    if (search) {
        json["search"] = jobs::toJson(*search);
        words = text("Searched ", counted(search->photos, "photo", "photos"), " in ",
                     humanDuration(std::chrono::duration<double>(search->seconds)), " and found ",
                     counted(search->regions, "face", "faces"),
                     search->before > 0 ? text("; ", search->before, " were searched before") : "", ".\n");
    }
    words += text(counted(regions, "region", "regions"), " in ", counted(photos.size(), "photo", "photos"),
                  " will be blurred in all exports.");
    if (!lines.empty()) {
        words += tableLine({"region", "photo", "direction (deg)", "size (deg)", "origin"}) + lines;
    }
    return {json, words};
}

Result privacy(const PrivacyArguments& options, Context& context) {
    if (options.isChange()) {
        changeRegions(options);
    }
    std::optional<jobs::FaceReport> search;
    if (options.find != "none") {
        auto store = store::SurveyStore::open(options.survey, store::Access::Write);
        jobs::FaceOptions wanted;
        wanted.again = options.find == "all";
        search = jobs::searchFaces(store, wanted, context.progress, context.stop);
    }
    return listedRegions(store::SurveyStore::open(options.survey, store::Access::Read), search);
}

} // namespace

void addPrivacy(Commands& commands) {
    const auto options = std::make_shared<PrivacyArguments>();
    const program::Command command =
        commands.add("privacy", "Find faces and mark screens, which all exports show blurred, and list them",
                     [options](Context& context) { return privacy(*options, context); });
    command.option("survey", options->survey, "Folder of the survey").required();
    command
        .option("--find", options->find,
                "Look for faces: in new photos that were not searched yet, or in all of them anew. What was "
                "removed "
                "by hand stays removed")
        .among({"none", "new", "all"})
        .showDefault();
    command.option("--mark", options->photo, "Photo to mark a region in, by its file, station, or number");
    command
        .option(
            "--at", options->atDeg,
            "Direction to the middle of the region, degrees: to the left of the photo's middle, and above it")
        .separatedBy(',')
        .count(2);
    command
        .option("--size", options->sizeDeg, "Width and height of the region as the camera sees it, degrees")
        .separatedBy(',')
        .count(2);
    command.option("--remove", options->removed, "Regions that are none, each by its number");
}

} // namespace spherewalk::cli
