// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/measured_dataset.h"

#include "parts/report_parts.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/folder.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/render/colour_correction.h"
#include "spherewalk/render/dataset_format.h"
#include "spherewalk/render/renderer.h"
#include "spherewalk/store/survey_store.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace spherewalk::jobs {

namespace fs = std::filesystem;

namespace {

constexpr int kDatasetMethod = 2; ///< grows when the same survey gives another dataset

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
    std::string content =
        text("measured dataset ", kDatasetMethod, " ", SPHEREWALK_VERSION, " ", store.info().uuid, " ",
             store.planOptions().stepM, " ", room.ceilingM, cornersText(room.outline));
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

namespace {

/// Of the time, most is for depths.
constexpr double kExported = 0.6;
constexpr double kMeasured = 0.9;

/// Changes a dataset's description. What is not understood in it is kept.
void changeDescription(const std::filesystem::path& dataset, const std::function<void(Json&)>& change) {
    const std::filesystem::path file = dataset / render::kDatasetFile;
    Json description = parseJson(readTextFile(file), file.string());
    render::parseDatasetInfo(description, file.string());
    change(description);
    render::parseDatasetInfo(description, file.string());
    writeFile(file, bytesOf(description.dump(1) + "\n"));
}

} // namespace

ChosenExport exportChosen(const store::SurveyStore& store, const fs::path& folder, const CameraModel& camera,
                          const MeasureOptions& measure, ExportOptions options, ProgressSink& progress,
                          const std::stop_token& stop) {
    measure.validate();
    requireAbsent(folder, "the dataset");
    const fs::path cache = measureCacheFolder(store.folder());
    EachWarningOnce once(progress);
    ProgressStep exporting(once, 0, kExported);
    const fs::path all = surveyDataset(store, render::SceneKind::Depth, cache, exporting, stop);
    const render::Renderer renderer(std::make_shared<const render::Dataset>(
        render::Dataset::open(all, render::Verify::Sizes, noProgress(), stop)));
    ProgressStep measuring(once, kExported, kMeasured);
    ChosenExport result;
    MeasureOptions kept = measure;
    kept.cacheFolder = cache / "results";
    result.measured = measureDataset(renderer, camera, kept, measuring, stop);
    if (result.measured.choice.rung) {
        result.scene = std::max(result.scene, result.measured.rungs[*result.measured.choice.rung].scene);
    }
    ProgressStep writing(once, kMeasured, 1);
    options.scene = result.scene;
    result.exported = exportDataset(store, folder, options, writing, stop);
    if (result.measured.choice.rung) {
        storeChoice(folder, result.measured);
    }
    return result;
}

void storeChoice(const std::filesystem::path& dataset, const MeasureReport& report) {
    const std::optional<render::ViewChoice> choice = viewChoice(report);
    if (!choice) {
        throw Error(ErrorKind::InvalidInput,
                    text("There is no choice to store in ", dataset.string(), ": ", report.choice.reason));
    }
    std::map<render::SceneKind, double> errors;
    for (const SceneLikeness& scene : report.scenes) {
        const auto errorPx = scene.errorPx(report.places);
        if (errorPx && std::isfinite(*errorPx)) {
            errors[scene.scene] = *errorPx;
        }
    }
    changeDescription(dataset, [&](Json& description) {
        render::putMeasured(description, *choice, errors, report.choice.photoScenes);
    });
}

void storeColour(const std::filesystem::path& dataset, const render::ColourCorrection& correction) {
    correction.validate();
    changeDescription(
        dataset, [&](Json& description) { description["colour_correction"] = render::toJson(correction); });
}

} // namespace spherewalk::jobs
