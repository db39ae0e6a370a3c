// SPDX-License-Identifier: GPL-3.0-or-later
#include "parts/report_parts.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/grid_study.h"
#include "spherewalk/jobs/measure_page.h"
#include "spherewalk/jobs/measure_report.h"
#include "spherewalk/render/ladder.h"

#include <limits>

namespace spherewalk::jobs {

namespace {

Json listOf(const Eigen::Vector3d& v) {
    return Json::array({v.x(), v.y(), v.z()});
}

Json viewJson(const ViewLikeness& view) {
    Json json = {{"subject", view.subject},
                 {"photo", view.photo},
                 {"left_out", view.leftOut ? Json(*view.leftOut) : Json()},
                 {"position_m", listOf(view.at())},
                 {"axis", listOf(view.axis())},
                 {"offset_m", view.offset.norm()},
                 {"median_px", orNull(view.medianPx)},
                 {"p95_px", orNull(view.p95Px)},
                 {"matches", view.matches},
                 {"missed", view.missed},
                 {"exact_median_px", orNull(view.exactMedianPx)},
                 {"exact_p95_px", orNull(view.exactP95Px)}};
    putLooks(json, "", view.looks);
    return json;
}

Json sceneJson(const SceneLikeness& scene) {
    Json views = Json::array();
    for (const ViewLikeness& view : scene.views) {
        views.push_back(viewJson(view));
    }
    Json photos = Json::array();
    for (const PhotoError& photo : scene.photos) {
        photos.push_back({{"photo", photo.photo}, {"p95_px", orNull(photo.p95Px)}, {"places", photo.places}});
    }
    Json json = {{"scene", name(scene.scene)},
                 {"sampling", name(scene.sampling)},
                 {"median_px", orNull(scene.medianPx)},
                 {"p95_px", orNull(scene.p95Px)},
                 {"missed_share", scene.missedShare},
                 {"exact_median_px", orNull(scene.exactMedianPx)},
                 {"exact_p95_px", orNull(scene.exactP95Px)},
                 {"photos", photos},
                 {"views", views}};
    putLooks(json, "mean_", scene.looks.mean);
    putLooks(json, "worst_", scene.looks.worst);
    return json;
}

Json rungJson(const Rung& rung) {
    return {{"scene", name(rung.scene)}, {"sampling", name(rung.sampling)}, {"p95_px", orNull(rung.errorPx)},
            {"cost", rung.cost()},       {"render_ms", rung.renderMs},      {"bytes", rung.bytes}};
}

Json passedOverJson(const PassedOver& passed) {
    const auto json = [](const PairedDifference& of) {
        return Json{{"mean", of.mean}, {"margin", of.margin}};
    };
    return {{"scene", name(passed.scene)},
            {"than", name(passed.than)},
            {"views", passed.looks.views},
            {"ssim_lower_by", json(passed.looks.ssim)},
            {"false_edges_higher_by", json(passed.looks.falseEdges)}};
}

Json borderJson(const BorderJump& jump) {
    return {{"scene", name(jump.scene)},
            {"borders", jump.borders},
            {"psnr_db", jump.psnrDb},
            {"worst_psnr_db", jump.worstPsnrDb},
            {"median_px", orNull(jump.medianPx)},
            {"p95_px", orNull(jump.p95Px)},
            {"missed_share", jump.missedShare}};
}

Json choiceJson(const MeasureReport& report, const Choice& choice) {
    Json passed = Json::array();
    for (const PassedOver& one : choice.passedOver) {
        passed.push_back(passedOverJson(one));
    }
    Json photos = Json::object();
    for (std::size_t i = 0; i < choice.photoScenes.size(); ++i) {
        if (choice.photoScenes[i]) {
            photos[std::to_string(i)] = name(*choice.photoScenes[i]);
        }
    }
    return {{"tolerance_px", choice.tolerancePx},
            {"within", choice.isWithin},
            {"rung", choice.rung ? rungJson(report.rungs[*choice.rung]) : Json()},
            {"cheaper_photos", photos},
            {"mean_render_ms", choice.meanRenderMs},
            {"passed_over", passed},
            {"reason", choice.reason}};
}

} // namespace

Json toJson(const MeasureReport& report) {
    Json scenes = Json::array();
    for (const SceneLikeness& scene : report.scenes) {
        scenes.push_back(sceneJson(scene));
    }
    Json rungs = Json::array();
    for (const Rung& rung : report.rungs) {
        rungs.push_back(rungJson(rung));
    }
    Json choices = Json::array();
    for (const Choice& choice : report.choices) {
        choices.push_back(choiceJson(report, choice));
    }
    Json borders = Json::array();
    for (const BorderJump& jump : report.borders) {
        borders.push_back(borderJson(jump));
    }
    Json predictions = Json::array();
    for (const Prediction& prediction : report.predictions) {
        predictions.push_back({{"scene", name(prediction.scene)},
                               {"foretold_px", prediction.foretoldPx},
                               {"found_px", prediction.foundPx},
                               {"rank_correlation", orNull(prediction.rankCorrelation)},
                               {"foretold_by_found", orNull(prediction.factor)}});
    }
    return {{"dataset", report.dataset},
            {"leave_one_out", report.isLeaveOneOut},
            {"photos", report.photos},
            {"places", name(report.places)},
            {"directions", report.directions},
            {"reused_views", report.reusedViews},
            {"sphere_radius_m", orNull(report.sphereRadiusM)},
            {"view_distance_m", report.viewM},
            {"between_distance_m", report.betweenM},
            {"camera_focal_px", report.focalPx},
            {"scenes", scenes},
            {"sampling_views", report.samplingViews},
            {"rungs", rungs},
            {"choice", choiceJson(report, report.choice)},
            {"choices", choices},
            {"borders", borders},
            {"left_out", report.leaveOneOut ? toJson(*report.leaveOneOut) : Json()},
            {"predictions", predictions},
            {"seconds", report.seconds}};
}

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

Json costJson(const GridCost& cost) {
    return {{"step_m", cost.stepM}, {"photos", cost.photos}, {"minutes", cost.minutes}};
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
        } else if (error.number("places") > 0) { // too many of them were not found
            result.photos[photo].p95Px = std::numeric_limits<double>::infinity();
        }
    }
    return result;
}

Json toJson(const GridStudy& study) {
    Json rows = Json::array();
    for (const GridRow& row : study.rows) {
        rows.push_back({{"step_m", row.stepM},
                        {"scene", name(row.scene)},
                        {"kept_photos", row.keptPhotos},
                        {"views", row.views},
                        {"missed_share", row.missedShare},
                        {"median_px", orNull(row.medianPx)},
                        {"p95_px", orNull(row.p95Px)}});
        putLooks(rows.back(), "mean_", row.looks);
    }
    Json costs = Json::array();
    for (const GridCost& cost : study.costs) {
        costs.push_back(costJson(cost));
    }
    Json answers = Json::array();
    for (const GridAnswer& answer : study.answers) {
        answers.push_back({{"scene", name(answer.scene)},
                           {"step_m", orNull(answer.stepM)},
                           {"is_largest_studied", answer.isLargest},
                           {"cost", answer.cost ? costJson(*answer.cost) : Json()}});
    }
    return {{"grid_step_m", study.gridStepM},
            {"photos", study.photos},
            {"tolerance_px", study.tolerancePx},
            {"rows", rows},
            {"costs", costs},
            {"answers", answers},
            {"reason", study.reason},
            {"seconds", study.seconds}};
}

} // namespace spherewalk::jobs
