// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid_study_words.h"

#include "spherewalk/base/text.h"

#include <algorithm>

namespace spherewalk::jobs {

namespace {

std::string cm(double metres) {
    return text(fixed(100 * metres, 0), " cm");
}

std::string costWords(const GridCost& cost) {
    return text(cost.photos, " photos, about ",
                humanDuration(std::chrono::duration<double>(60 * cost.minutes)));
}

Json costJson(const GridCost& cost) {
    return {{"step_m", cost.stepM}, {"photos", cost.photos}, {"minutes", cost.minutes}};
}

} // namespace

std::string gridStudyReason(const GridStudy& study) {
    const GridAnswer* best = nullptr;
    for (const GridAnswer& answer : study.answers) {
        if (answer.stepM && (best == nullptr || *answer.stepM > *best->stepM)) {
            best = &answer;
        }
    }
    const std::string wanted = text(fixed(study.tolerancePx, study.tolerancePx < 10 ? 1 : 0), " px");
    if (best == nullptr) {
        const auto least =
            std::min_element(study.rows.begin(), study.rows.end(), [](const GridRow& a, const GridRow& b) {
                return a.p95Px.value_or(1e9) < b.p95Px.value_or(1e9);
            });
        return text("None of the steps studied holds ", wanted, " in 95 of 100 places; the best, ",
                    cm(least->stepM), " with the scene model ", name(least->scene), ", reaches ",
                    orDash(least->p95Px), " px. Study a denser block, or allow more.");
    }
    return text("For ", wanted, " in 95 of 100 places a grid of ", cm(*best->stepM),
                " is enough with the scene model ", name(best->scene),
                best->isLargest ? " (no coarser one was studied)" : "",
                best->cost ? text(": ", costWords(*best->cost)) : "", ".");
}

sheet::Table gridTable(const GridStudy& study) {
    sheet::Table table{
        {"step", "scene model", "kept", "views", "PSNR dB", "median px", "95 % px", "photos", "time"}, {}, 2};
    double last = 0;
    for (const GridRow& row : study.rows) {
        const auto cost = std::find_if(study.costs.begin(), study.costs.end(),
                                       [&](const GridCost& c) { return c.stepM == row.stepM; });
        const bool isFirst = row.stepM != last;
        const bool hasCost = isFirst && cost != study.costs.end();
        last = row.stepM;
        table.rows.push_back(
            {isFirst ? cm(row.stepM) : "", std::string(name(row.scene)),
             isFirst ? std::to_string(row.keptPhotos) : "", std::to_string(row.views),
             fixed(row.meanPsnrDb, 2), orDash(row.medianPx), orDash(row.p95Px),
             hasCost ? std::to_string(cost->photos) : "",
             hasCost ? humanDuration(std::chrono::duration<double>(60 * cost->minutes)) : ""});
    }
    return table;
}

sheet::Table gridAnswerTable(const GridStudy& study) {
    sheet::Table table{{"scene model", "step", "photos", "time"}, {}, 1};
    for (const GridAnswer& answer : study.answers) {
        table.rows.push_back(
            {std::string(name(answer.scene)),
             answer.stepM ? text(answer.isLargest ? "at least " : "", cm(*answer.stepM)) : "none studied",
             answer.cost ? std::to_string(answer.cost->photos) : "",
             answer.cost ? humanDuration(std::chrono::duration<double>(60 * answer.cost->minutes)) : ""});
    }
    return table;
}

std::string gridStudyText(const GridStudy& study) {
    return text("Photos ", cm(study.gridStepM), " apart, ", study.photos,
                " of them; views from where photos were left out, rendered from the kept ones alone:\n",
                tableText(gridTable(study)), "\nThe coarsest grid that holds ", orDash(study.tolerancePx),
                " px:\n", tableText(gridAnswerTable(study)), "\n", study.reason);
}

Json toJson(const GridStudy& study) {
    Json rows = Json::array();
    for (const GridRow& row : study.rows) {
        rows.push_back({{"step_m", row.stepM},
                        {"scene", name(row.scene)},
                        {"kept_photos", row.keptPhotos},
                        {"views", row.views},
                        {"mean_psnr_db", row.meanPsnrDb},
                        {"median_px", orNull(row.medianPx)},
                        {"p95_px", orNull(row.p95Px)}});
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
