// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/folder.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/jobs/solution_findings.h"
#include "spherewalk/store/survey_store.h"
#include "spherewalk/survey/marking.h"

#include <algorithm>
#include <set>

namespace spherewalk::jobs {

namespace fs = std::filesystem;

namespace {

/// Of the nearest folder that is there already.
fs::path existingParent(fs::path folder) {
    std::error_code none;
    folder = fs::absolute(folder).lexically_normal();
    while (!fs::exists(folder, none) && folder.has_relative_path()) {
        folder = folder.parent_path();
    }
    return folder;
}

class Look {
  public:
    Look(const store::SurveyStore& store, const ExportOptions& options)
        : m_store(store),
          m_options(options),
          m_exported(photosToExport(store)),
          m_photos(withoutTests(m_exported.photos, options.testEvery)) {
        m_check.photos = m_photos.size();
    }

    ExportCheck run(const fs::path& folder, ProgressSink& progress, const std::stop_token& stop) {
        progress.progress(0, "Trying one photo");
        measure(stop);
        if (!m_photos.empty()) {
            progress.progress(0.3, "Trying one depth");
            addDepth(stop);
        }
        progress.progress(0.9, "Looking at the survey");
        countRegions();
        lookAtPlace(folder);
        lookAtStations();
        if (!m_photos.empty()) {
            m_check.doubts.insert(m_check.doubts.end(), m_exported.doubts.begin(), m_exported.doubts.end());
            lookAtRotations();
        }
        progress.progress(1, "Checked");
        return std::move(m_check);
    }

  private:
    /// On the photo of median size.
    void measure(const std::stop_token& stop) {
        if (m_photos.empty()) {
            m_check.obstacles.push_back(
                m_exported.failed.empty() ? "No photo is left to export; capture some first, or accept some."
                                          : m_exported.allDoubts());
            return;
        }
        std::vector<store::PhotoRecord> bySize = m_photos;
        const auto middle = bySize.begin() + static_cast<std::ptrdiff_t>(bySize.size() / 2);
        std::nth_element(bySize.begin(), middle, bySize.end(),
                         [](const auto& a, const auto& b) { return a.sizeBytes < b.sizeBytes; });
        const TemporaryFolder folder("spherewalk-export-check");
        const dataset::WriteReport one =
            exportOne(m_store, *middle, folder.path() / "one", m_options.write, stop);
        std::uint64_t sourceBytes = 0;
        for (const store::PhotoRecord& photo : m_photos) {
            sourceBytes += photo.sizeBytes;
        }
        const double share = static_cast<double>(sourceBytes) /
                             static_cast<double>(std::max<std::uint64_t>(1, one.sourceBytes));
        const int threads =
            std::min(m_options.write.threads > 0 ? m_options.write.threads : hardwareThreads(),
                     static_cast<int>(m_photos.size()));
        m_check.totalBytes = static_cast<std::uint64_t>(share * static_cast<double>(one.totalBytes));
        m_check.seconds = share * one.seconds / threads;
    }

    void addDepth(const std::stop_token& stop) {
        const DepthForecast depth = exportForecast(m_store, m_options, true, stop);
        m_check.seconds += depth.seconds();
        m_check.totalBytes += render::usesDepths(m_options.scene) ? depth.bytes : 0;
    }

    void countRegions() {
        for (const store::PhotoRecord& photo : m_photos) {
            const std::vector<store::RegionRecord> regions = m_store.regions(photo.id);
            const auto blurred = std::ranges::count_if(regions, [](const store::RegionRecord& region) {
                return region.origin != store::RegionOrigin::Rejected;
            });
            m_check.privateRegions += static_cast<std::size_t>(blurred);
            m_check.blurredPhotos += blurred > 0 ? 1 : 0;
        }
    }

    void lookAtPlace(const fs::path& folder) {
        std::error_code failure;
        if (fs::exists(folder, failure)) {
            m_check.obstacles.push_back(text("There is something by the name ", folder.string(),
                                             " already; choose another name, or remove it."));
        }
        const fs::space_info space = fs::space(existingParent(folder), failure);
        if (failure) {
            m_check.doubts.push_back(text("How much space is left at ", folder.string(), " cannot be told."));
            return;
        }
        m_check.freeBytes = space.available;
        if (m_check.freeBytes < m_check.totalBytes) {
            m_check.obstacles.push_back(text("The dataset needs about ", humanBytes(m_check.totalBytes),
                                             ", and ", humanBytes(m_check.freeBytes), " are free at ",
                                             folder.string(), "; make space, or choose another place."));
        }
    }

    void lookAtStations() {
        const store::Counts counts = m_store.counts();
        const int missing = counts.stations - counts.stationsWithPhoto - counts.rejectedPhotos;
        if (missing > 0) {
            m_check.doubts.push_back(text(counted(missing, "station has no photo", "stations have no photo"),
                                          ": near them, views come from farther away."));
        }
        if (counts.rejectedPhotos > 0) {
            m_check.doubts.push_back(text(counted(counts.rejectedPhotos, "photo was rejected and is left out",
                                                  "photos were rejected and are left out"),
                                          "."));
        }
    }

    void lookAtRotations() {
        const auto solution = m_store.activeSolution();
        if (!solution) {
            m_check.doubts.emplace_back(
                "The survey is not aligned: photos would be exported as if each looked along the room's x "
                "axis; align it first.");
            return;
        }
        std::set<std::int64_t> solved;
        std::set<std::int64_t> doubtful;
        for (const store::SolvedPhoto& photo : m_store.solvedPhotos(solution->id)) {
            solved.insert(photo.photo);
            if (photo.quality != survey::Quality::Good) {
                doubtful.insert(photo.photo);
            }
        }
        std::size_t unsolved = 0;
        std::size_t inDoubt = 0;
        for (const store::PhotoRecord& photo : m_photos) {
            unsolved += solved.contains(photo.id) ? 0 : 1;
            inDoubt += doubtful.contains(photo.id) ? 1 : 0;
        }
        if (unsolved > 0) {
            m_check.doubts.push_back(
                unsolved == 1
                    ? "1 photo has no known heading: it would be exported as if it looked along the "
                      "room's x axis; align again, or reject it."
                    : text(unsolved, " photos have no known heading: they would be exported as if they "
                                     "looked along the room's x axis; align again, or reject them."));
        }
        if (std::string elsewhere = placesInDoubt(m_store); !elsewhere.empty()) {
            m_check.doubts.push_back(std::move(elsewhere));
        }
        if (inDoubt > 0) {
            m_check.doubts.push_back(
                inDoubt == 1 ? "The alignment of 1 photo is doubtful; review it, or export it as it is."
                             : text("The alignment of ", inDoubt,
                                    " photos is doubtful; review them, or export them as they are."));
        }
    }

    const store::SurveyStore& m_store;
    const ExportOptions& m_options;
    const PhotosToExport m_exported;
    const std::vector<store::PhotoRecord> m_photos;
    ExportCheck m_check;
};

} // namespace

ExportCheck checkExport(const store::SurveyStore& store, const fs::path& folder, const ExportOptions& options,
                        ProgressSink& progress, const std::stop_token& stop) {
    options.validate();
    return Look(store, options).run(folder, progress, stop);
}

std::vector<std::string> roomDoubts(const scene::FittedRoom& found, const survey::Room& drawn) {
    if (found.contradictsOutline) {
        return {
            "Most of what the photos show stands more than half a metre beyond the drawn outline, which is "
            "too small or of another room: the dataset has the room that the photos show."};
    }
    std::string names;
    for (const std::size_t wall : found.wallsSeenThrough) {
        names += text(names.empty() ? "" : ", ", survey::wallName(drawn, static_cast<int>(wall)));
    }
    if (names.empty()) {
        return {};
    }
    return {text("Photos see more than half a metre farther than the drawn ",
                 found.wallsSeenThrough.size() == 1 ? "wall " : "walls ", names,
                 " in most directions. If there is no window, mirror or opening, correct the outline, and "
                 "export again.")};
}

Json toJson(const ExportCheck& check) {
    return {{"photos", check.photos},
            {"estimated_bytes", check.totalBytes},
            {"free_bytes", check.freeBytes},
            {"estimated_seconds", check.seconds},
            {"obstacles", check.obstacles},
            {"doubts", check.doubts},
            {"private_regions", check.privateRegions},
            {"photos_with_private_regions", check.blurredPhotos},
            {"possible", check.isPossible()}};
}

} // namespace spherewalk::jobs
