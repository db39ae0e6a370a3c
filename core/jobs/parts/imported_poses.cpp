// SPDX-License-Identifier: GPL-3.0-or-later
#include "imported_poses.h"

#include "spherewalk/base/json.h"

namespace spherewalk::jobs {

namespace {

constexpr const char* kSubject = "the report of a solution";
constexpr const char* kImported = "imported";

std::set<std::int64_t> importedIn(const Json& report) {
    std::set<std::int64_t> photos;
    const JsonReader reader(report, kSubject);
    if (!reader.isAbsent(kImported)) {
        const JsonReader array = reader.member(kImported);
        for (std::size_t i = 0; i < array.arraySize(); ++i) {
            photos.insert(array.element(i).asInteger());
        }
    }
    return photos;
}

} // namespace

ImportedPoses::ImportedPoses(const store::SolutionRecord& solution)
    : m_areAll(solution.source != "align"), m_photos(importedIn(parseJson(solution.report, kSubject))) {
}

void takeOver(const store::SolutionRecord& alignment, const std::set<std::int64_t>& imported,
              store::NewSolution& solution) {
    Json report = parseJson(alignment.report, kSubject);
    std::set<std::int64_t> all = importedIn(report);
    all.insert(imported.begin(), imported.end());
    report[kImported] = all;
    const JsonReader reader(report, kSubject);
    if (!reader.isAbsent("photos")) {
        Json others = Json::array();
        const JsonReader photos = reader.member("photos");
        for (std::size_t i = 0; i < photos.arraySize(); ++i) {
            const JsonReader photo = photos.element(i);
            // Earlier versions named the file only.
            if (photo.isAbsent("photo") || !all.contains(photo.integer("photo"))) {
                others.push_back(report["photos"][i]);
            }
        }
        report["photos"] = std::move(others);
    }
    solution.source = alignment.source;
    solution.model = alignment.model;
    solution.report = report.dump();
}

} // namespace spherewalk::jobs
