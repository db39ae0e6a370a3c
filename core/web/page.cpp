// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/web/page.h"

#include "page_files.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/report/svg.h"

#include <algorithm>

namespace spherewalk::web {

namespace {

Json english() {
    return parseJson(pageFile("words.json"), "words.json");
}

} // namespace

std::string word(std::string_view key) {
    return english().at(std::string(key)).get<std::string>();
}

Json allWords(const PageWords& words) {
    Json result = english();
    for (auto& [key, value] : result.items()) {
        value = words(value.get<std::string>());
    }
    return result;
}

namespace {

Json pointOf(const Eigen::Vector2d& point) {
    return {point.x(), point.y()};
}

Json polygonOf(const Polygon& polygon) {
    Json result = Json::array();
    for (const Eigen::Vector2d& corner : polygon) {
        result.push_back(pointOf(corner));
    }
    return result;
}

Json sentencesOf(const std::vector<std::string>& sentences, const PageWords& words) {
    Json result = Json::array();
    for (const std::string& sentence : sentences) {
        result.push_back(words(sentence));
    }
    return result;
}

Json photoOf(const Photo& photo, std::size_t number, const PageWords& words) {
    const Eigen::Vector3d& at = photo.roomFromPhoto.translation;
    const Eigen::Quaterniond& turned = photo.roomFromPhoto.rotation;
    Json depth;
    if (photo.depth) {
        depth = {{"sigma_m", photo.depth->leastM}, {"sigma_per_m", photo.depth->perM}};
    }
    return {{"station", photo.station},
            {"script", scriptName(number)},
            {"position", {at.x(), at.y(), at.z()}},
            {"rotation", {turned.w(), turned.x(), turned.y(), turned.z()}},
            {"lens_ahead_m", photo.lenses.aheadM},
            {"heading_known", photo.isHeadingKnown},
            {"depth", depth},
            {"sigma_position_m", photo.sigmaPositionM},
            {"sigma_turn", photo.sigmaTurn.value()},
            {"state", photo.state},
            {"decision", photo.decision},
            {"note", photo.note},
            {"findings", sentencesOf(photo.findings, words)},
            {"error_px", photo.errorPx ? Json(*photo.errorPx) : Json()},
            {"neighbours", photo.neighbours}};
}

Json floorOf(const Floor& floor) {
    Json runs = Json::array();
    for (const FloorRun& run : floor.runs) {
        runs.push_back({run.row, run.begin, run.end, run.photo});
    }
    return {{"origin", pointOf(floor.origin)}, {"cell_m", floor.cellM}, {"runs", runs}};
}

Json mapOf(const FloorMap& map, const PageWords& words) {
    Json legend = Json::array();
    for (const LegendEntry& entry : map.legend) {
        legend.push_back({{"colour", entry.colour},
                          {"words", words(entry.words)},
                          {"value", entry.value ? Json(*entry.value) : Json()}});
    }
    return {{"name", words(map.name)},
            {"about", words(map.about)},
            {"colours", map.colours},
            {"legend", legend},
            {"floor", map.floor ? floorOf(*map.floor) : Json()}};
}

Json placeOf(const Page& page, const PageWords& words) {
    Json photos = Json::array();
    for (std::size_t i = 0; i < page.photos.size(); ++i) {
        photos.push_back(photoOf(page.photos[i], i, words));
    }
    Json place{{"name", page.name},
               {"made_by", page.madeBy},
               {"scale_sigma", page.scaleSigma},
               {"created_utc", page.createdUtc},
               {"language", words.language},
               {"floor_m", page.floorM},
               {"step_m", page.stepM},
               {"radius_m", page.radiusM},
               {"has_review", page.hasReview},
               {"begin", page.begin},
               {"outline", polygonOf(page.room.outline)},
               {"obstacles", Json::array()},
               {"rooms", Json::array()},
               {"photos", photos},
               {"without_photo", Json::array()},
               {"floor", floorOf(page.floor)},
               {"maps", Json::array()},
               {"words", allWords(words)}};
    for (const Polygon& obstacle : page.room.obstacles) {
        place["obstacles"].push_back(polygonOf(obstacle));
    }
    for (const survey::RoomName& room : page.room.names) {
        place["rooms"].push_back({{"name", room.name}, {"at", pointOf(room.at)}});
    }
    for (const EmptyStation& one : page.without) {
        place["without_photo"].push_back(
            {{"station", one.station}, {"at", pointOf(one.at)}, {"why", one.why}});
    }
    for (const FloorMap& map : page.maps) {
        place["maps"].push_back(mapOf(map, words));
    }
    return place;
}

/// Letters from outside become escapes, and so does what is no UTF-8.
std::string asciiJson(const Json& json) {
    return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

void replaceAll(std::string& html, std::string_view placeholder, std::string_view words) {
    const std::string escaped = report::escaped(printable(words, words.size()));
    for (std::size_t at = html.find(placeholder); at != std::string::npos; at = html.find(placeholder, at)) {
        html.replace(at, placeholder.size(), escaped);
        at += escaped.size();
    }
}

} // namespace

std::string_view pageFile(std::string_view name) {
    const auto files = pageFiles();
    const auto found = std::ranges::find(files, name, &EmbeddedFile::name);
    if (found == files.end()) {
        throw Error(ErrorKind::Internal, text("This program was built without the page's file ", name, "."));
    }
    return found->content;
}

void writePage(const Page& page, const PageWords& words, const std::filesystem::path& folder) {
    if (page.photos.empty()) {
        throw Error(ErrorKind::InvalidInput, text("Could not make a page of ", printable(page.name),
                                                  ": it has no photo that could be shown."));
    }
    for (const char* subject : {"page", "data", "photos"}) {
        ensureFolder(folder / subject);
    }
    for (const EmbeddedFile& file : pageFiles()) {
        if (file.name.starts_with("page/")) {
            writeFile(folder / file.name, bytesOf(file.content));
        }
    }
    writeFile(folder / "data/place.js",
              bytesOf(text("spherewalk.place = ", asciiJson(placeOf(page, words)), ";\n")));
    std::string html(pageFile("index.html"));
    replaceAll(html, "{{language}}", words.language);
    replaceAll(html, "{{noScript}}", words(word("noScript")));
    replaceAll(html, "{{title}}", page.name); // last, so that no name is a placeholder
    writeFile(folder / "index.html", bytesOf(html));
}

} // namespace spherewalk::web
