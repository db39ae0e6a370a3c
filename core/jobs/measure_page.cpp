// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/measure_page.h"

#include "grid_study_words.h"
#include "measure_plots.h"
#include "measure_words.h"
#include "report_folder.h"

#include "spherewalk/base/text.h"
#include "spherewalk/sheet/document.h"
#include "spherewalk/survey/plan_report.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::jobs {

using sheet::Document;
using sheet::Heading;
using sheet::Paragraph;

namespace {

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
    return text(info.photos.size(), " photos cover ", fixed(report.floorM2 - report.uncoveredM2, 2), " of ",
                fixed(report.floorM2, 2), " m2 of floor at a step of ", fixed(100 * info.stepM, 0), " cm.");
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
    document.blocks.emplace_back(sheet::Drawing{errorMap(info, scene, leftOut.choice.tolerancePx)});
    document.blocks.emplace_back(sheet::Drawing{directionMap(info, scene, leftOut)});
}

void addWorst(const MeasureReport& report, Document& document) {
    if (report.worst.empty()) {
        return;
    }
    document.blocks.emplace_back(Heading{"The views farthest from the truth"});
    document.blocks.emplace_back(Paragraph{
        "Truth, view, and difference (grey where they agree), with the scene model that was chosen."});
    for (const ShownView& shown : report.worst) {
        document.blocks.emplace_back(
            sheet::PictureRow{{shown.truth, shown.view, shown.difference},
                              {shown.subject, text("95 %: ", orDash(shown.errorPx), " px"),
                               text("PSNR ", fixed(shown.psnrDb, 1), " dB")}});
    }
}

void addMeasured(const ReportContents& contents, Document& document) {
    const MeasureReport& report = *contents.measured;
    document.blocks.emplace_back(Heading{"What to render with"});
    document.blocks.emplace_back(Paragraph{report.choice.reason});
    document.blocks.emplace_back(Paragraph{text("By tolerance", choiceBasis(report), ":")});
    document.blocks.emplace_back(choiceTable(report));
    document.blocks.emplace_back(sheet::Drawing{tradePlot(report)});
    document.blocks.emplace_back(Heading{"How right views are"});
    document.blocks.emplace_back(Paragraph{text("Compared: ", subjectWords(report), ".")});
    document.blocks.emplace_back(sceneTable(report));
    if (report.leaveOneOut) {
        document.blocks.emplace_back(Heading{"What leaving photos out foretold"});
        document.blocks.emplace_back(Paragraph{text("Compared: ", subjectWords(*report.leaveOneOut), ".")});
        document.blocks.emplace_back(sceneTable(*report.leaveOneOut));
        document.blocks.emplace_back(sheet::Drawing{predictionPlot(report)});
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
    document.blocks.emplace_back(sheet::Drawing{gridPlot(study)});
    document.blocks.emplace_back(gridAnswerTable(study));
    document.blocks.emplace_back(gridTable(study));
}

Document documentOf(const ReportContents& contents) {
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
    document.blocks.emplace_back(sheet::Drawing{coveragePlot(info)});
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

void writeReport(const ReportContents& contents, const std::filesystem::path& folder) {
    const Json figures = {{"dataset", datasetJson(*contents.dataset)},
                          {"measured", contents.measured != nullptr ? toJson(*contents.measured) : Json()},
                          {"grid_study", contents.grid != nullptr ? toJson(*contents.grid) : Json()}};
    writeReportFolder(documentOf(contents), figures, folder);
}

} // namespace spherewalk::jobs
