// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/measure_dataset.h"
#include "spherewalk/measure/svg.h"
#include "spherewalk/measure/text_table.h"

namespace spherewalk::jobs {

namespace {

std::string optionalPx(const std::optional<double>& value) {
    return value ? fixed(*value, 2) : "-";
}

std::vector<std::string> cellsOf(const SceneLikeness& scene) {
    return {std::string(name(scene.scene)),  fixed(scene.meanPsnrDb, 2),   fixed(scene.worstPsnrDb, 2),
            fixed(scene.meanSsim, 3),        optionalPx(scene.medianPx),   optionalPx(scene.p95Px),
            optionalPx(scene.exactMedianPx), optionalPx(scene.exactP95Px), fixed(scene.medianRenderMs, 1)};
}

const std::vector<std::string> kTitles{"scene model", "PSNR dB",  "worst",      "SSIM", "median px",
                                       "95 % px",     "exact px", "exact 95 %", "ms"};

std::string subjectWords(const MeasureReport& report) {
    const std::size_t views = report.scenes.empty() ? 0 : report.scenes.front().views.size();
    return report.isLeaveOneOut
               ? text(views, " views of photos, each rendered from the others")
               : text(views, " pictures of the robot's camera, each beside the view from its pose");
}

std::string row(const std::vector<std::string>& cells, const char* tag) {
    std::string html = "<tr>";
    for (const std::string& cell : cells) {
        html += text("<", tag, ">", measure::escaped(cell), "</", tag, ">");
    }
    return html + "</tr>\n";
}

} // namespace

std::string measureText(const MeasureReport& report) {
    measure::TextTable table;
    table.add(kTitles);
    for (const SceneLikeness& scene : report.scenes) {
        table.add(cellsOf(scene));
    }
    return text(subjectWords(report), ", ", report.photos, " photos",
                report.sphereRadiusM ? text(", sphere of ", fixed(*report.sphereRadiusM, 2), " m") : "",
                ":\n", table.text(), report.reason, "\n");
}

Json toJson(const MeasureReport& report) {
    const auto optional = [](const std::optional<double>& value) { return value ? Json(*value) : Json(); };
    Json scenes = Json::array();
    for (const SceneLikeness& scene : report.scenes) {
        Json views = Json::array();
        for (const ViewLikeness& view : scene.views) {
            views.push_back({{"subject", view.subject},
                             {"photo", view.photo},
                             {"offset_m", view.offsetM},
                             {"psnr_db", view.psnrDb},
                             {"ssim", view.ssim},
                             {"median_px", optional(view.medianPx)},
                             {"p95_px", optional(view.p95Px)},
                             {"matches", view.matches},
                             {"exact_median_px", optional(view.exactMedianPx)},
                             {"exact_p95_px", optional(view.exactP95Px)},
                             {"render_ms", view.renderMs}});
        }
        scenes.push_back({{"scene", name(scene.scene)},
                          {"mean_psnr_db", scene.meanPsnrDb},
                          {"worst_psnr_db", scene.worstPsnrDb},
                          {"mean_ssim", scene.meanSsim},
                          {"median_px", optional(scene.medianPx)},
                          {"p95_px", optional(scene.p95Px)},
                          {"exact_median_px", optional(scene.exactMedianPx)},
                          {"exact_p95_px", optional(scene.exactP95Px)},
                          {"median_render_ms", scene.medianRenderMs},
                          {"views", views}});
    }
    return {{"leave_one_out", report.isLeaveOneOut},
            {"photos", report.photos},
            {"sphere_radius_m", optional(report.sphereRadiusM)},
            {"tolerance_px", report.tolerancePx},
            {"choice", report.choice ? Json(name(*report.choice)) : Json()},
            {"reason", report.reason},
            {"seconds", report.seconds},
            {"scenes", scenes}};
}

void writeMeasurePage(const MeasureReport& report, const std::filesystem::path& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure) {
        throw Error(ErrorKind::Io,
                    text("Could not make the folder ", folder.string(), ": ", failure.message(), "."));
    }
    std::string html =
        text("<!DOCTYPE html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>Measured scene "
             "models</title>\n<style>body{font:16px sans-serif;max-width:60em;margin:2em auto}"
             "td,th{padding:.2em .8em;text-align:right}th:first-child,td:first-child{text-align:"
             "left}</style>\n<h1>Measured scene models</h1>\n<p>",
             measure::escaped(subjectWords(report)), ".</p>\n<table>\n", row(kTitles, "th"));
    for (const SceneLikeness& scene : report.scenes) {
        html += row(cellsOf(scene), "td");
    }
    html += text("</table>\n<p>", measure::escaped(report.reason), "</p>\n");
    for (const SceneLikeness& scene : report.scenes) {
        html += text("<h2>", std::string(name(scene.scene)), "</h2>\n<table>\n",
                     row({"view", "from", "cm away", "PSNR dB", "SSIM", "median px", "95 % px"}, "th"));
        for (const ViewLikeness& view : scene.views) {
            html += row({view.subject, view.photo, fixed(100 * view.offsetM, 1), fixed(view.psnrDb, 2),
                         fixed(view.ssim, 3), optionalPx(view.medianPx), optionalPx(view.p95Px)},
                        "td");
        }
        html += "</table>\n";
    }
    writeFile(folder / "report.html", bytesOf(html + "</html>\n"));
    writeFile(folder / "report.json", bytesOf(toJson(report).dump(1) + "\n"));
}

} // namespace spherewalk::jobs
