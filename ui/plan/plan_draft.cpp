// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/plan_draft.h"

#include "ui/look/core_words.h"
#include "ui/look/words.h"

#include "spherewalk/base/error.h"
#include "spherewalk/survey/laid_rails.h"
#include "spherewalk/survey/marking.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <cmath>

namespace spherewalk::ui {

using report::SheetWords;

namespace {

/// The words of this file, for translators.
struct PlanWords {
    Q_DECLARE_TR_FUNCTIONS(spherewalk::ui::PlanWords)
};

/// Returns a sentence on the outline with the letters of its corners, as table and sheet have them, for their
/// numbers.
QString withLetters(const QString& sentence) {
    if (!sentence.startsWith("The outline")) {
        return sentence; // obstacles have numbers
    }
    static const QRegularExpression corner("(?:(?<=corner )|(?<=corners )|(?<=\\d and ))(\\d+)");
    QString result;
    qsizetype from = 0;
    for (const QRegularExpressionMatch& found : corner.globalMatch(sentence)) {
        result += sentence.mid(from, found.capturedStart(1) - from);
        result += QString::fromStdString(survey::cornerName(found.captured(1).toInt() - 1));
        from = found.capturedEnd(1);
    }
    return result + sentence.mid(from);
}

QString reasonWords(survey::UncoveredReason reason, const survey::PlanOptions& options) {
    switch (reason) {
    case survey::UncoveredReason::Clearance:
        return PlanWords::tr("closer than %L1 m to a wall or an obstacle").arg(options.clearanceM, 0, 'f', 2);
    case survey::UncoveredReason::Enclosed:
        return PlanWords::tr("cut off by obstacles");
    case survey::UncoveredReason::BetweenStops:
        return PlanWords::tr("no stop falls near enough");
    }
    return {};
}

} // namespace

PlanDraft firstDraft() {
    PlanDraft draft;
    draft.room.outline = {{0, 0}, {5, 0}, {5, 4}, {0, 4}};
    draft.room.ceilingM = 2.6;
    draft.options.stepM = 0.4;
    return draft;
}

int railStops(double lengthM, double stepM) {
    constexpr double kRounding = 1e-6;
    return 1 + static_cast<int>(std::floor(lengthM / stepM + kRounding));
}

double railLengthM(int stops, double stepM) {
    return (stops - 1) * stepM;
}

void changeStep(PlanDraft& draft, double stepM) {
    draft.options.railStops = railStops(railLengthM(draft.options.railStops, draft.options.stepM), stepM);
    draft.options.stepM = stepM;
}

void keepLocked(PlanDraft& draft) {
    std::erase_if(draft.rails, [](const survey::RailPlacement& rail) { return !rail.isLocked; });
    draft.laysRest = !draft.rails.empty();
}

survey::Plan planOf(const PlanDraft& draft) {
    if (!draft.hasRails) {
        return {.placements = {}, .stations = draft.byHand};
    }
    return draft.rails.empty() || draft.laysRest ? survey::plan(draft.room, draft.options, draft.rails)
                                                 : survey::planOfLaid(draft.room, draft.options, draft.rails);
}

PlanOutcome outcomeOf(const PlanDraft& draft) {
    try {
        PlanOutcome outcome;
        outcome.plan = planOf(draft);
        if (draft.isRoomKnown) {
            outcome.report = survey::report(draft.room, draft.options, outcome.plan);
        } else {
            outcome.report.stations = static_cast<int>(outcome.plan.stations.size());
        }
        return outcome;
    } catch (const Error& error) {
        return {{}, {}, coreWords(withLetters(QString::fromStdString(error.sentence())))};
    } catch (const std::exception& defect) {
        return {{}, {}, QString::fromUtf8(defect.what())};
    }
}

QString countsText(const survey::PlanReport& report) {
    if (report.placements == 0 && report.stations > 0) {
        return PlanWords::tr("%n photo(s) by hand", nullptr, report.stations);
    }
    return PlanWords::tr("%n station(s)", nullptr, report.stations) + PlanWords::tr(" on ") +
           PlanWords::tr("%n rail(s)", nullptr, report.placements);
}

QString walkText(const survey::PlanReport& report) {
    return PlanWords::tr("%L1 m to walk, about %2")
        .arg(report.metresWalked, 0, 'f', 0)
        .arg(durationText(std::chrono::duration<double>(60 * report.minutes)));
}

QString floorText(const survey::PlanReport& report) {
    const double share = report.floorM2 > 0 ? 100 * report.uncoveredM2 / report.floorM2 : 0;
    return PlanWords::tr("%L1 m² of floor, %L2 m² not covered (%3 %)")
        .arg(report.floorM2, 0, 'f', 1)
        .arg(report.uncoveredM2, 0, 'f', 1)
        .arg(share, 0, 'f', 0);
}

QStringList uncoveredText(const survey::PlanReport& report, const survey::PlanOptions& options) {
    QStringList lines;
    using Reason = survey::UncoveredReason;
    for (const Reason reason : {Reason::Clearance, Reason::Enclosed, Reason::BetweenStops}) {
        double areaM2 = 0;
        for (const survey::UncoveredArea& area : report.uncovered) {
            areaM2 += area.reason == reason ? area.areaM2 : 0;
        }
        constexpr double kWorthSayingM2 = 0.005;
        if (areaM2 >= kWorthSayingM2) {
            lines << PlanWords::tr("%L1 m²: %2").arg(areaM2, 0, 'f', 2).arg(reasonWords(reason, options));
        }
    }
    return lines;
}

SheetWords sheetWords() {
    const auto words = [](const QString& text) { return text.toStdString(); };
    SheetWords result;
    result.title = words(PlanWords::tr("Marking out: %1"));
    result.summary = words(PlanWords::tr("%1 stations on %2 rails; step %3 cm; rail of %4 stops, %5 m"));
    result.scale = words(PlanWords::tr("Scale 1:%1. Print at 100 %: this bar is 10 cm long."));
    result.tableTitle = words(PlanWords::tr("Where the rails lie: metres by tape"));
    result.errorMeans = words(
        PlanWords::tr("Error: how far a place is off at most if each tape is read wrong by 5 mm. Below: "
                      "check and laser."));
    result.rail = words(PlanWords::tr("Rail"));
    result.stops = words(PlanWords::tr("Stops"));
    result.firstStop = words(PlanWords::tr("First stop (ring)"));
    result.lastStop = words(PlanWords::tr("Last stop (arrow)"));
    result.error = words(PlanWords::tr("Error"));
    result.noTapes = words(PlanWords::tr("nothing in sight to measure from"));
    result.check = words(PlanWords::tr("check %1"));
    result.place = words(PlanWords::tr("x %1, y %2"));
    result.ring = words(PlanWords::tr("ring %1"));
    result.arrow = words(PlanWords::tr("arrow %1"));
    result.page = words(PlanWords::tr("Page %1"));
    return result;
}

} // namespace spherewalk::ui
