// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure_words.h"

#include "spherewalk/base/text.h"

#include <algorithm>
#include <set>

namespace spherewalk::jobs {

namespace {

std::size_t viewsOf(const MeasureReport& report) {
    return report.scenes.empty() ? 0 : report.scenes.front().views.size();
}

std::string leftOutWords(const MeasureReport& report) {
    std::set<std::size_t> photos;
    for (const ViewLikeness& view : report.scenes.front().views) {
        photos.insert(view.leftOut.value_or(0));
    }
    return text(viewsOf(report), " views of ", photos.size(), " of ", report.photos, " photos in ",
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

} // namespace

std::string subjectWords(const MeasureReport& report) {
    const std::string what =
        report.isLeaveOneOut
            ? leftOutWords(report)
            : text(viewsOf(report), " pictures of the robot's camera, each beside the view from its pose; ",
                   report.photos, " photos");
    const bool isOfPixels = report.places == Places::Pixels;
    return text(what, isOfPixels ? "; pixels are counted, not features" : "",
                report.sphereRadiusM ? text("; sphere of ", fixed(*report.sphereRadiusM, 2), " m") : "",
                report.reusedViews > 0 ? text("; ", report.reusedViews, " known from before") : "");
}

sheet::Table sceneTable(const MeasureReport& report) {
    sheet::Table table{
        {"scene model", "PSNR dB", "worst", "SSIM", "median px", "95 % px", "exact px", "exact 95 %", "ms"},
        {}};
    for (const SceneLikeness& scene : report.scenes) {
        double ms = 0;
        for (const Rung& rung : report.rungs) {
            ms = rung.scene == scene.scene && rung.sampling == scene.sampling ? rung.renderMs : ms;
        }
        table.rows.push_back({std::string(name(scene.scene)), fixed(scene.meanPsnrDb, 2),
                              fixed(scene.worstPsnrDb, 2), fixed(scene.meanSsim, 3), orDash(scene.medianPx),
                              orDash(scene.p95Px), orDash(scene.exactMedianPx), orDash(scene.exactP95Px),
                              fixed(ms, 1)});
    }
    return table;
}

sheet::Table rungTable(const MeasureReport& report) {
    sheet::Table table{{"scene model", "sampling", "ms", "95 % px"}, {}, 2};
    for (const Rung& rung : report.rungs) {
        table.rows.push_back({std::string(name(rung.scene)), std::string(name(rung.sampling)),
                              fixed(rung.renderMs, 2), orDash(rung.errorPx)});
    }
    return table;
}

std::string choiceBasis(const MeasureReport& report) {
    return report.leaveOneOut == nullptr ? "" : ", chosen by leaving photos out and tried on the pictures";
}

sheet::Table choiceTable(const MeasureReport& report) {
    const bool hasPictures = report.leaveOneOut != nullptr;
    const MeasureReport& choosing = hasPictures ? *report.leaveOneOut : report;
    sheet::Table table{{"tolerance px", "scene model", "sampling", "ms", "95 % px"}, {}, 3};
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
                 prediction.rankCorrelation ? fixed(*prediction.rankCorrelation, 2) : "(not known)", "."));
    }
    return result;
}

} // namespace spherewalk::jobs
