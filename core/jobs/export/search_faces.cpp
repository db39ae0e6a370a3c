// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/judge_survey.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/face_search.h"
#include "spherewalk/store/survey_store.h"

#include <algorithm>
#include <chrono>
#include <set>
#include <vector>

namespace spherewalk::jobs {

namespace {

/// Grows when the same photos are searched in another way.
constexpr int kSearchMethod = 1;

std::set<std::int64_t> searchedPhotos(const store::SurveyStore& store) {
    const std::vector<std::int64_t> known = store.searchedPhotos(kSearchMethod);
    return {known.begin(), known.end()};
}

} // namespace

FaceReport searchFaces(store::SurveyStore& store, const FaceOptions& options, ProgressSink& progress,
                       const std::stop_token& stop) {
    const photo::FaceSearch search(options.cascades);
    const auto begin = std::chrono::steady_clock::now();
    const std::set<std::int64_t> searched = searchedPhotos(store);
    FaceReport report;
    std::vector<store::PhotoRecord> photos;
    for (store::PhotoRecord& photo : store.photos()) {
        if (options.again || !searched.contains(photo.id)) {
            photos.push_back(std::move(photo));
        } else {
            ++report.before;
        }
    }
    for (const store::PhotoRecord& photo : photos) {
        throwIfStopped(stop);
        progress.progress(static_cast<double>(report.photos) / static_cast<double>(photos.size()),
                          text("Looking for faces in photo ", report.photos + 1, " of ", photos.size()));
        const std::filesystem::path file = store.photoFolder() / photo.fileName;
        const RgbImage picture = jpeg::decode(readFile(file), file.string());
        throwIfStopped(stop);
        const std::size_t added =
            store.setFoundRegions(photo.id, search.faces(picture, options.threads, stop), kSearchMethod);
        report.regions += added;
        report.photosWithRegions += added > 0 ? 1 : 0;
        ++report.photos;
    }
    report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return report;
}

std::size_t unsearchedPhotos(const store::SurveyStore& store) {
    const std::set<std::int64_t> searched = searchedPhotos(store);
    const std::vector<store::PhotoRecord> photos = store.photos();
    return static_cast<std::size_t>(
        std::ranges::count_if(photos, [&](const auto& photo) { return !searched.contains(photo.id); }));
}

Json toJson(const FaceReport& report) {
    return {{"photos_searched", report.photos},
            {"photos_searched_before", report.before},
            {"regions_found", report.regions},
            {"photos_with_found_regions", report.photosWithRegions},
            {"seconds", report.seconds}};
}

} // namespace spherewalk::jobs
