// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_parts.h"

#include "spherewalk/jobs/measure_report.h"

namespace spherewalk::jobs {

namespace {

Json listOf(const Eigen::Vector3d& v) {
    return Json::array({v.x(), v.y(), v.z()});
}

Json viewJson(const ViewLikeness& view) {
    return {{"subject", view.subject},
            {"photo", view.photo},
            {"left_out", view.leftOut ? Json(*view.leftOut) : Json()},
            {"position_m", listOf(view.at())},
            {"axis", listOf(view.axis())},
            {"offset_m", view.offset.norm()},
            {"psnr_db", view.psnrDb},
            {"ssim", view.ssim},
            {"median_px", orNull(view.medianPx)},
            {"p95_px", orNull(view.p95Px)},
            {"matches", view.matches},
            {"exact_median_px", orNull(view.exactMedianPx)},
            {"exact_p95_px", orNull(view.exactP95Px)}};
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
    return {{"scene", name(scene.scene)},
            {"sampling", name(scene.sampling)},
            {"mean_psnr_db", scene.meanPsnrDb},
            {"worst_psnr_db", scene.worstPsnrDb},
            {"mean_ssim", scene.meanSsim},
            {"median_px", orNull(scene.medianPx)},
            {"p95_px", orNull(scene.p95Px)},
            {"exact_median_px", orNull(scene.exactMedianPx)},
            {"exact_p95_px", orNull(scene.exactP95Px)},
            {"photos", photos},
            {"views", views}};
}

Json rungJson(const Rung& rung) {
    return {{"scene", name(rung.scene)},
            {"sampling", name(rung.sampling)},
            {"p95_px", orNull(rung.errorPx)},
            {"render_ms", rung.renderMs},
            {"bytes", rung.bytes}};
}

Json choiceJson(const MeasureReport& report, const Choice& choice) {
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
    Json predictions = Json::array();
    for (const Prediction& prediction : report.predictions) {
        predictions.push_back({{"scene", name(prediction.scene)},
                               {"foretold_px", prediction.foretoldPx},
                               {"found_px", prediction.foundPx},
                               {"rank_correlation", orNull(prediction.rankCorrelation)}});
    }
    return {{"dataset", report.dataset},
            {"leave_one_out", report.isLeaveOneOut},
            {"photos", report.photos},
            {"places", name(report.places)},
            {"directions", report.directions},
            {"reused_views", report.reusedViews},
            {"sphere_radius_m", orNull(report.sphereRadiusM)},
            {"camera_focal_px", report.focalPx},
            {"scenes", scenes},
            {"sampling_views", report.samplingViews},
            {"rungs", rungs},
            {"choice", choiceJson(report, report.choice)},
            {"choices", choices},
            {"left_out", report.leaveOneOut ? toJson(*report.leaveOneOut) : Json()},
            {"predictions", predictions},
            {"seconds", report.seconds}};
}

} // namespace spherewalk::jobs
