// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/measure_survey.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/sha256.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/render/dataset_format.h"

namespace spherewalk::jobs {

namespace fs = std::filesystem;

namespace {

constexpr int kMethod = 1; ///< grows when the same survey gives another dataset

std::string cornersText(const Polygon& polygon) {
    std::string result = " polygon";
    for (const Eigen::Vector2d& corner : polygon) {
        result += text(" ", corner.x(), " ", corner.y());
    }
    return result;
}

/// All that an export depends on.
std::string contentOf(const store::SurveyStore& store) {
    const survey::Room room = store.room();
    std::string content = text("measured dataset ", kMethod, " ", SPHEREWALK_VERSION, " ", store.info().uuid,
                               " ", store.planOptions().stepM, " ", room.ceilingM, cornersText(room.outline));
    for (const Polygon& obstacle : room.obstacles) {
        content += cornersText(obstacle);
    }
    for (const store::PhotoRecord& photo : store.keptPhotos()) {
        const Eigen::Vector3d& at = photo.positionM;
        content += text("\n", photo.id, " ", photo.fileSha256, " ", at.x(), " ", at.y(), " ", at.z());
    }
    if (const auto solution = store.activeSolution()) {
        for (const store::SolvedPhoto& photo : store.solvedPhotos(solution->id)) {
            const Eigen::Quaterniond& q = photo.roomFromPhoto;
            const Eigen::Vector3d& at = photo.positionM;
            content += text("\n", photo.photo, " ", at.x(), " ", at.y(), " ", at.z(), " ", q.w(), " ", q.x(),
                            " ", q.y(), " ", q.z());
        }
    }
    return content;
}

void removeOthers(const fs::path& cacheFolder, const std::string& prefix) {
    for (const fs::directory_entry& entry : fs::directory_iterator(cacheFolder)) {
        if (entry.path().filename().string().starts_with(prefix)) {
            fs::remove_all(entry.path());
        }
    }
}

} // namespace

bool isSurvey(const fs::path& folder) {
    return fs::exists(folder / "survey.sqlite");
}

fs::path measureCacheFolder(const fs::path& surveyOrDataset) {
    if (isSurvey(surveyOrDataset)) {
        return surveyOrDataset / "measure-cache";
    }
    const bool isSlashed = !surveyOrDataset.has_filename();
    return fs::path((isSlashed ? surveyOrDataset.parent_path() : surveyOrDataset).string() +
                    ".measure-cache");
}

fs::path surveyDataset(const store::SurveyStore& store, render::SceneKind richest,
                       const fs::path& cacheFolder, ProgressSink& progress, const std::stop_token& stop) {
    const std::string prefix = text(name(richest), "-");
    const std::string key = sha256Hex(bytesOf(contentOf(store))).substr(0, 16);
    const fs::path folder = cacheFolder / text(prefix, key, ".dataset");
    if (fs::exists(folder / render::kDatasetFile)) { // renamed into place: it is whole
        return folder;
    }
    try {
        fs::create_directories(cacheFolder);
        removeOthers(cacheFolder, prefix);
    } catch (const fs::filesystem_error& failure) {
        throw Error(ErrorKind::Io, text("Could not keep a dataset in ", cacheFolder.string(), ": ",
                                        failure.code().message(), "; name another folder."));
    }
    ExportOptions options;
    options.scene = richest;
    exportDataset(store, folder, options, progress, stop);
    return folder;
}

} // namespace spherewalk::jobs
