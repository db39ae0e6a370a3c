// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/align_survey.h"
#include "spherewalk/store/survey_store.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::jobs {

namespace {

constexpr std::size_t kMostTags = 1000;
constexpr double kLeastM = 0.001; ///< Of a tag's side.
constexpr double kMostM = 100;
constexpr double kFarthestM = 1e8;
constexpr double kSigmas = 3;
constexpr double kLeastShare = 0.005; ///< Below this, tapes and printers may differ.

double numberIn(const JsonReader& json, std::string_view key, double least, double most) {
    const double value = json.number(key);
    if (!(value >= least && value <= most)) {
        json.member(key).fail(text("expected a number from ", least, " to ", most));
    }
    return value;
}

/// The place of a tag that JSON states, as aprilTagsJson() writes it.
align::RoomTag tagOf(const JsonReader& json) {
    align::RoomTag tag;
    tag.number = static_cast<int>(json.integer("number", 0, photo::kTagNumbers - 1));
    tag.size = numberIn(json, "size_m", kLeastM, kMostM);
    tag.sizeSigma = numberIn(json, "size_sigma_m", 0, kMostM);
    tag.sigma = numberIn(json, "sigma_m", 0, kMostM);
    tag.photos = static_cast<int>(json.integer("photos", 0, 1 << 30));
    const JsonReader corners = json.member("corners_m");
    if (corners.arraySize(tag.corners.size()) != tag.corners.size()) {
        corners.fail("expected four corners");
    }
    for (std::size_t i = 0; i < tag.corners.size(); ++i) {
        const JsonReader corner = corners.element(i);
        if (corner.arraySize(3) != 3) {
            corner.fail("expected three numbers");
        }
        tag.corners[i] = {corner.element(0).asNumber(), corner.element(1).asNumber(),
                          corner.element(2).asNumber()};
        if (!(tag.corners[i].cwiseAbs().maxCoeff() <= kFarthestM)) {
            corner.fail(text("expected numbers within ", kFarthestM));
        }
    }
    return tag;
}

} // namespace

Json aprilTagsJson(const align::RoomTags& tags) {
    Json list = Json::array();
    for (const align::RoomTag& tag : tags.tags) {
        Json corners = Json::array();
        for (const Eigen::Vector3d& corner : tag.corners) {
            corners.push_back({corner.x(), corner.y(), corner.z()});
        }
        list.push_back({{"number", tag.number},
                        {"size_m", tag.size},
                        {"size_sigma_m", tag.sizeSigma},
                        {"sigma_m", tag.sigma},
                        {"photos", tag.photos},
                        {"corners_m", corners}});
    }
    return list;
}

std::vector<align::RoomTag> aprilTagsOf(const store::SurveyStore& store) {
    const std::optional<store::SolutionRecord> solution = store.activeSolution();
    if (!solution) {
        return {};
    }
    const std::string source = text("the report of the active solution of ", store.folder().string());
    const Json report = parseJson(solution->report, source);
    const JsonReader reader(report, source);
    std::vector<align::RoomTag> tags;
    if (!reader.isAbsent("april_tags")) {
        const JsonReader list = reader.member("april_tags");
        for (std::size_t i = 0; i < list.arraySize(kMostTags); ++i) {
            tags.push_back(tagOf(list.element(i)));
            if (std::ranges::count(tags, tags.back().number, &align::RoomTag::number) > 1) {
                list.element(i).fail(text("tag ", tags.back().number, " is listed twice"));
            }
        }
    }
    return tags;
}

void placeAprilTags(std::span<const align::TagSighting> sightings, double sizeM, AlignReport& report) {
    if (!(sizeM > 0)) {
        return;
    }
    std::vector<std::optional<align::PlacedPhoto>> photos;
    for (std::size_t i = 0; i < report.photos.size(); ++i) {
        const align::SolvedPose& pose = report.alignment.photos[i];
        const bool isPlaced = pose.isSolved && report.photos[i].quality != survey::Quality::Failed;
        photos.push_back(isPlaced ? std::optional<align::PlacedPhoto>(
                                        {pose.roomFromPhoto, pose.lenses, report.photos[i].file})
                                  : std::nullopt);
    }
    report.aprilTags = align::roomTags(photos, sightings, sizeM);
    std::vector<std::string>& warnings = report.alignment.warnings;
    std::ranges::copy(report.aprilTags.warnings, std::back_inserter(warnings));
    if (report.aprilTags.tags.empty()) {
        warnings.push_back("No AprilTag was found that two photos see: hang tags where photos see them from "
                           "up to 4 m away, or leave out --tag-size.");
        return;
    }
    const align::Scale& scale = *report.aprilTags.scale;
    // A free solution has its scale from the tags, and says itself what contradicts it.
    if (!report.places && std::abs(scale.value - 1) > std::max(kLeastShare, kSigmas * scale.sigma)) {
        warnings.push_back(
            text("By the printed size of the tags, all tapes are ", fixed(100 * std::abs(scale.value - 1), 1),
                 " % too ", scale.value > 1 ? "long" : "short", " (known to ", fixed(100 * scale.sigma, 1),
                 " %). Measure a printed tag with a ruler, then the tapes."));
    }
}

} // namespace spherewalk::jobs
