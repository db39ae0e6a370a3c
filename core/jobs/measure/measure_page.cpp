// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/measure_page.h"

#include "measure/measure_plots.h"
#include "parts/report_parts.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/report/document.h"
#include "spherewalk/survey/plan_report.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

namespace spherewalk::jobs {

using report::Document;
using report::Heading;
using report::Paragraph;

namespace {

constexpr const char* kColumnWords =
    "False edges are edge pixels of the view that the truth does not have within 2 px; missed edges are the "
    "truth's that the view does not have. The bend is how far straight lines of the truth are from straight "
    "in "
    "the view. Features that the view does not show are missed; median and 95 % are of all features, and "
    "\"lost\" means that too many are missed. A view in the second table may be another for each column.";

std::string stepText(double metres) {
    return text(fixed(100 * metres, 0), " cm");
}

std::string percent(double share) {
    return fixed(100 * share, 1);
}

void append(std::vector<std::string>& cells, const std::vector<std::string>& more) {
    cells.insert(cells.end(), more.begin(), more.end());
}

report::Table gridTable(const GridStudy& study) {
    report::Table table{{"step", "scene model", "kept", "views"}, {}, 2};
    append(table.titles, looksTitles());
    append(table.titles, {"median px", "95 % px", "missed %", "photos", "time"});
    double last = 0;
    for (const GridRow& row : study.rows) {
        const auto cost = std::find_if(study.costs.begin(), study.costs.end(),
                                       [&](const GridCost& c) { return c.stepM == row.stepM; });
        const bool isFirst = row.stepM != last;
        const bool hasCost = isFirst && cost != study.costs.end();
        last = row.stepM;
        std::vector<std::string> cells{isFirst ? stepText(row.stepM) : "", std::string(name(row.scene)),
                                       isFirst ? std::to_string(row.keptPhotos) : "",
                                       std::to_string(row.views)};
        append(cells, looksCells(row.looks));
        append(cells, {orDash(row.medianPx), orDash(row.p95Px), percent(row.missedShare),
                       hasCost ? std::to_string(cost->photos) : "",
                       hasCost ? humanDuration(std::chrono::duration<double>(60 * cost->minutes)) : ""});
        table.rows.push_back(std::move(cells));
    }
    return table;
}

report::Table gridAnswerTable(const GridStudy& study) {
    report::Table table{{"scene model", "step", "photos", "time"}, {}, 1};
    for (const GridAnswer& answer : study.answers) {
        table.rows.push_back(
            {std::string(name(answer.scene)),
             answer.stepM ? text(answer.isLargest ? "at least " : "", stepText(*answer.stepM))
                          : "none studied",
             answer.cost ? std::to_string(answer.cost->photos) : "",
             answer.cost ? humanDuration(std::chrono::duration<double>(60 * answer.cost->minutes)) : ""});
    }
    return table;
}

std::size_t viewCount(const MeasureReport& report) {
    return report.scenes.empty() ? 0 : report.scenes.front().views.size();
}

std::string leftOutWords(const MeasureReport& report) {
    std::set<std::size_t> photos;
    for (const ViewLikeness& view : report.scenes.front().views) {
        photos.insert(view.leftOut.value_or(0));
    }
    return text(viewCount(report), " views of ", photos.size(), " of ", report.photos, " photos in ",
                report.directions, " directions, each rendered from the other photos");
}

/// What the pictures say of what leaving photos out chose.
std::vector<std::string> heldCells(const MeasureReport& pictures, const Rung& chosen, double tolerancePx) {
    const auto same = std::find_if(pictures.rungs.begin(), pictures.rungs.end(), [&](const Rung& rung) {
        return rung.scene == chosen.scene && rung.sampling == chosen.sampling;
    });
    if (same == pictures.rungs.end() || !same->errorPx) {
        return {"-", "-"};
    }
    return {orDash(same->errorPx), *same->errorPx <= tolerancePx ? "yes" : "no"};
}

std::string subjectWords(const MeasureReport& report) {
    const std::string what =
        report.isLeaveOneOut
            ? leftOutWords(report)
            : text(viewCount(report), " pictures of the robot's camera, each beside the view from its pose; ",
                   report.photos, " photos");
    const bool isOfPixels = report.places == Places::Pixels;
    return text(what, isOfPixels ? "; pixels are counted, not features" : "",
                report.sphereRadiusM ? text("; sphere of ", fixed(*report.sphereRadiusM, 2), " m") : "",
                report.reusedViews > 0 ? text("; ", report.reusedViews, " known from before") : "");
}

report::Table sceneTable(const MeasureReport& report) {
    report::Table table{{"scene model"}, {}};
    append(table.titles, looksTitles());
    append(table.titles, {"median px", "95 % px", "missed %", "exact px", "exact 95 %", "ms"});
    for (const SceneLikeness& scene : report.scenes) {
        double ms = 0;
        for (const Rung& rung : report.rungs) {
            ms = rung.scene == scene.scene && rung.sampling == scene.sampling ? rung.renderMs : ms;
        }
        std::vector<std::string> cells{std::string(name(scene.scene))};
        append(cells, looksCells(scene.looks.mean));
        append(cells, {orDash(scene.medianPx), orDash(scene.p95Px), percent(scene.missedShare),
                       orDash(scene.exactMedianPx), orDash(scene.exactP95Px), fixed(ms, 1)});
        table.rows.push_back(std::move(cells));
    }
    return table;
}

report::Table worstTable(const MeasureReport& report) {
    report::Table table{{"worst view"}, {}};
    append(table.titles, looksTitles());
    for (const SceneLikeness& scene : report.scenes) {
        std::vector<std::string> cells{std::string(name(scene.scene))};
        append(cells, looksCells(scene.looks.worst));
        table.rows.push_back(std::move(cells));
    }
    return table;
}

report::Table borderTable(const MeasureReport& report) {
    report::Table table{{"at a border", "PSNR", "worst", "median px", "95 % px", "missed %"}, {}};
    for (const BorderJump& jump : report.borders) {
        table.rows.push_back({std::string(name(jump.scene)), fixed(jump.psnrDb, 1),
                              fixed(jump.worstPsnrDb, 1), orDash(jump.medianPx), orDash(jump.p95Px),
                              percent(jump.missedShare)});
    }
    return table;
}

std::string borderWords(const MeasureReport& report) {
    return text("At ", counted(report.borders.front().borders, "border", "borders"),
                ", half way between two photos, what a view from the one shows beside a view from the "
                "other. A stream with depth spreads that over some centimetres of the way.");
}

report::Table rungTable(const MeasureReport& report) {
    report::Table table{{"scene model", "sampling", "cost", "ms", "95 % px"}, {}, 2};
    for (const Rung& rung : report.rungs) {
        table.rows.push_back({std::string(name(rung.scene)), std::string(name(rung.sampling)),
                              fixed(rung.cost(), 1), fixed(rung.renderMs, 2), orDash(rung.errorPx)});
    }
    return table;
}

std::string choiceBasis(const MeasureReport& report) {
    return report.leaveOneOut == nullptr ? "" : ", chosen by leaving photos out and tried on the pictures";
}

report::Table choiceTable(const MeasureReport& report) {
    const bool hasPictures = report.leaveOneOut != nullptr;
    const MeasureReport& choosing = hasPictures ? *report.leaveOneOut : report;
    report::Table table{{"tolerance px", "scene model", "sampling", "ms", "95 % px"}, {}, 3};
    if (hasPictures) {
        table.titles.insert(table.titles.end(), {"on pictures", "holds"});
    }
    for (const Choice& choice : choosing.choices) {
        std::vector<std::string> row{fixed(choice.tolerancePx, 0)};
        if (choice.rung && choice.isWithin) {
            const Rung& rung = choosing.rungs[*choice.rung];
            row.insert(row.end(), {std::string(name(rung.scene)), std::string(name(rung.sampling)),
                                   fixed(rung.renderMs, 1), orDash(rung.errorPx)});
            if (hasPictures) {
                const std::vector<std::string> held = heldCells(report, rung, choice.tolerancePx);
                row.insert(row.end(), held.begin(), held.end());
            }
        } else {
            row.push_back("none holds");
            row.resize(table.titles.size());
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::vector<std::string> predictionWords(const MeasureReport& report) {
    std::vector<std::string> result;
    for (const Prediction& prediction : report.predictions) {
        result.push_back(
            text("Scene model ", name(prediction.scene),
                 ": errors foretold by leaving photos out and errors found on ", prediction.foundPx.size(),
                 " pictures have a rank correlation of ",
                 prediction.rankCorrelation ? fixed(*prediction.rankCorrelation, 2) : "(not known)",
                 prediction.factor ? text("; the foretold error is ", fixed(*prediction.factor, 2),
                                          " times the found one, at the median")
                                   : "",
                 "."));
    }
    return result;
}

/// What the errors of photos that were left out mean for views between the photos; "" if that is not known.
std::string betweenWords(const MeasureReport& report) {
    std::string errors;
    for (const SceneLikeness& scene : report.scenes) {
        if (const std::optional<double> px = betweenPx(report, scene)) {
            errors += text(errors.empty() ? "" : ", ", name(scene.scene), " ", fixed(*px, 2), " px");
        }
    }
    if (!report.isLeaveOneOut || errors.empty()) {
        return {};
    }
    return text("A view of a photo that is left out is made from ", fixed(report.viewM, 2),
                " m away. A place between all photos is ", fixed(report.betweenM, 2), " m from one, ",
                fixed(report.viewM / report.betweenM, 1), " times nearer. These are medians. From there, ",
                "expect about this median error in views of the same directions: ", errors, ".");
}

std::string choicesText(const MeasureReport& report) {
    return text("What to render with, by tolerance", choiceBasis(report), ":\n", choiceTable(report).text());
}

/// How much of the floor is near a photo, in a sentence; "" if the room is not known.
std::string coverageWords(const render::DatasetInfo& info) {
    if (info.outline.empty() || defect(info.outline) || !(info.ceilingM > 0) || !(info.stepM > 0)) {
        return {};
    }
    survey::Plan plan;
    for (const render::DatasetPhoto& photo : info.photos) {
        plan.stations.push_back({-1, 0, photo.roomFromPhoto.translation});
    }
    survey::PlanOptions options;
    options.stepM = info.stepM;
    const survey::Room room{info.outline, info.obstacles, info.ceilingM};
    const survey::PlanReport report = survey::report(room, options, plan);
    return text(fixed(report.floorM2 - report.uncoveredM2, 2), " of ", fixed(report.floorM2, 2),
                " m2 of floor lie within ", fixed(100 * survey::coveringReachM(info.stepM), 0),
                " cm of one of ", counted(info.photos.size(), "photo", "photos"), ", and in its sight.");
}

const SceneLikeness& likenessOf(const MeasureReport& report, render::SceneKind scene) {
    return *std::find_if(report.scenes.begin(), report.scenes.end(),
                         [&](const SceneLikeness& of) { return of.scene == scene; });
}

void addMaps(const render::DatasetInfo& info, const MeasureReport& leftOut, Document& document) {
    if (!leftOut.choice.rung) {
        return;
    }
    const SceneLikeness& scene = likenessOf(leftOut, leftOut.rungs[*leftOut.choice.rung].scene);
    document.blocks.emplace_back(Heading{"Where it holds"});
    document.blocks.emplace_back(report::Drawing{errorMap(info, scene, leftOut.choice.tolerancePx)});
    document.blocks.emplace_back(report::Drawing{directionMap(info, scene, leftOut)});
}

void addWorst(const MeasureReport& report, Document& document) {
    if (report.worst.empty()) {
        return;
    }
    document.blocks.emplace_back(Heading{"The views farthest from the truth"});
    document.blocks.emplace_back(Paragraph{
        "Truth, view, and difference (grey where they agree), with the scene model that was chosen."});
    for (const ShownView& shown : report.worst) {
        document.blocks.emplace_back(report::PictureRow{
            {shown.truth, shown.view, shown.difference},
            {shown.subject, text("95 %: ", orDash(shown.errorPx), " px"),
             text("PSNR ", fixed(shown.looks.psnrDb, 1), " dB, SSIM ", fixed(shown.looks.ssim, 2),
                  ", false edges ", percent(shown.looks.falseEdges), " %")}});
    }
}

void addMeasured(const ReportContents& contents, Document& document) {
    const MeasureReport& report = *contents.measured;
    document.blocks.emplace_back(Heading{"What to render with"});
    document.blocks.emplace_back(Paragraph{report.choice.reason});
    document.blocks.emplace_back(Paragraph{text("By tolerance", choiceBasis(report), ":")});
    document.blocks.emplace_back(choiceTable(report));
    if (std::any_of(report.rungs.begin(), report.rungs.end(),
                    [](const Rung& rung) { return rung.errorPx && std::isfinite(*rung.errorPx); })) {
        document.blocks.emplace_back(report::Drawing{tradePlot(report)});
    }
    document.blocks.emplace_back(Heading{"How right views are"});
    document.blocks.emplace_back(Paragraph{text("Compared: ", subjectWords(report), ".")});
    document.blocks.emplace_back(sceneTable(report));
    document.blocks.emplace_back(worstTable(report));
    document.blocks.emplace_back(Paragraph{kColumnWords});
    if (!report.borders.empty()) {
        document.blocks.emplace_back(Paragraph{borderWords(report)});
        document.blocks.emplace_back(borderTable(report));
    }
    if (const std::string words = betweenWords(report); !words.empty()) {
        document.blocks.emplace_back(Paragraph{words});
    }
    if (report.leaveOneOut) {
        document.blocks.emplace_back(Heading{"What leaving photos out foretold"});
        document.blocks.emplace_back(Paragraph{text("Compared: ", subjectWords(*report.leaveOneOut), ".")});
        document.blocks.emplace_back(sceneTable(*report.leaveOneOut));
        if (const std::string words = betweenWords(*report.leaveOneOut); !words.empty()) {
            document.blocks.emplace_back(Paragraph{words});
        }
        for (const std::string& sentence : predictionWords(report)) {
            document.blocks.emplace_back(Paragraph{sentence});
        }
        document.blocks.emplace_back(report::Drawing{predictionPlot(report)});
    }
    addMaps(*contents.dataset, report.leaveOneOut ? *report.leaveOneOut : report, document);
    addWorst(report, document);
    document.blocks.emplace_back(Heading{"Every scene model with every sampling"});
    document.blocks.emplace_back(
        Paragraph{text("Samplings were compared on ", report.samplingViews, " of the views.")});
    document.blocks.emplace_back(rungTable(report));
}

void addGrid(const GridStudy& study, Document& document) {
    document.blocks.emplace_back(Heading{"How dense the grid must be"});
    document.blocks.emplace_back(Paragraph{study.reason});
    if (std::any_of(study.rows.begin(), study.rows.end(),
                    [](const GridRow& row) { return row.p95Px && std::isfinite(*row.p95Px); })) {
        document.blocks.emplace_back(report::Drawing{gridPlot(study)});
    }
    document.blocks.emplace_back(gridAnswerTable(study));
    document.blocks.emplace_back(gridTable(study));
}

Document measureDocument(const ReportContents& contents) {
    const render::DatasetInfo& info = *contents.dataset;
    Document document{text("Measured: ", info.name), {}};
    if (contents.measured != nullptr) {
        addMeasured(contents, document);
    }
    if (contents.grid != nullptr) {
        addGrid(*contents.grid, document);
    }
    document.blocks.emplace_back(Heading{"Where photos were taken"});
    if (const std::string words = coverageWords(info); !words.empty()) {
        document.blocks.emplace_back(Paragraph{words});
    }
    document.blocks.emplace_back(report::Drawing{coveragePlot(info)});
    document.blocks.emplace_back(
        Paragraph{text("Dataset ", info.id, ", made ", info.createdUtc, " by ", info.madeBy, ".")});
    return document;
}

/// What tells whose photos the numbers are of.
Json datasetJson(const render::DatasetInfo& info) {
    Json photos = Json::array();
    for (const render::DatasetPhoto& photo : info.photos) {
        photos.push_back(photo.file);
    }
    return {{"id", info.id}, {"survey_id", info.surveyId}, {"name", info.name}, {"photos", photos}};
}

} // namespace

std::string gridStudyText(const GridStudy& study) {
    return text("Photos ", stepText(study.gridStepM), " apart, ", study.photos,
                " of them; views from where photos were left out, rendered from the kept ones alone:\n",
                gridTable(study).text(), "\nThe coarsest grid that holds ", orDash(study.tolerancePx),
                " px:\n", gridAnswerTable(study).text(), "\n", study.reason);
}

std::string measureText(const MeasureReport& report) {
    std::string result =
        text(subjectWords(report), ":\n", sceneTable(report).text(), "\n", worstTable(report).text(), "\n",
             choicesText(report), "\n", report.choice.reason);
    if (!report.borders.empty()) {
        result += text("\n\n", borderWords(report), "\n", borderTable(report).text());
    }
    if (const std::string words = betweenWords(report); !words.empty()) {
        result += "\n\n" + words;
    }
    if (!report.predictions.empty()) {
        result += "\n\n" + betweenWords(*report.leaveOneOut);
        for (const std::string& sentence : predictionWords(report)) {
            result += "\n" + sentence;
        }
    }
    return result;
}

void writeReport(const ReportContents& contents, const std::filesystem::path& folder) {
    const Json figures = {{"dataset", datasetJson(*contents.dataset)},
                          {"measured", contents.measured != nullptr ? toJson(*contents.measured) : Json()},
                          {"grid_study", contents.grid != nullptr ? toJson(*contents.grid) : Json()}};
    report::writeReportFolder(measureDocument(contents), figures, folder);
}

} // namespace spherewalk::jobs
