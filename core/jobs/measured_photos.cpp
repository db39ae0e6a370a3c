// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/measured_photos.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/render/view_choice.h"

namespace spherewalk::jobs {

namespace {

[[noreturn]] void failUnmeasured(const std::filesystem::path& file) {
    throw Error(ErrorKind::InvalidInput, text("The report ", file.string(),
                                              " says nothing about single photos: measure a dataset of two "
                                              "photos or more, and take that report."));
}

/// The entry of the scene model in "scenes".
JsonReader sceneOf(const JsonReader& measured, render::SceneKind scene) {
    const JsonReader scenes = measured.member("scenes");
    for (std::size_t i = 0; i < scenes.arraySize(); ++i) {
        if (render::sceneKind(scenes.element(i), "scene") == scene) {
            return scenes.element(i);
        }
    }
    scenes.fail("the scene model that was chosen is missing");
}

} // namespace

MeasuredPhotos readMeasuredPhotos(const std::filesystem::path& reportFile) {
    const Json json = parseJson(readTextFile(reportFile), reportFile.string());
    const JsonReader report(json, reportFile.string());
    JsonReader measured = report.member("measured");
    if (measured.value().is_object() && !measured.isAbsent("left_out")) {
        measured = measured.member("left_out"); // beside pictures of a robot
    }
    if (!measured.value().is_object() || !measured.boolean("leave_one_out") ||
        measured.member("choice").isAbsent("rung")) {
        failUnmeasured(reportFile);
    }
    MeasuredPhotos result;
    const JsonReader dataset = report.member("dataset");
    result.surveyId = dataset.string("survey_id");
    result.dataset = dataset.string("name");
    const JsonReader files = dataset.member("photos");
    for (std::size_t i = 0; i < files.arraySize(); ++i) {
        result.photos.push_back({files.element(i).asString(), {}});
    }
    const JsonReader choice = measured.member("choice");
    result.tolerancePx = choice.number("tolerance_px");
    result.focalPx = measured.number("camera_focal_px");
    result.scene = render::sceneKind(choice.member("rung"), "scene");
    const JsonReader errors = sceneOf(measured, result.scene).member("photos");
    for (std::size_t i = 0; i < errors.arraySize(); ++i) {
        const JsonReader error = errors.element(i);
        const auto photo = static_cast<std::size_t>(
            error.integer("photo", 0, static_cast<std::int64_t>(result.photos.size()) - 1));
        if (!error.isAbsent("p95_px")) {
            result.photos[photo].p95Px = error.number("p95_px");
        }
    }
    return result;
}

} // namespace spherewalk::jobs
