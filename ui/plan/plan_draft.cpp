// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/plan_draft.h"

#include "spherewalk/base/error.h"

#include <cmath>

namespace spherewalk::ui {

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

PlanOutcome outcomeOf(const PlanDraft& draft) {
    try {
        draft.room.validate();
        draft.options.validate(draft.room);
        PlanOutcome outcome;
        outcome.plan = survey::plan(draft.room, draft.options);
        outcome.report = survey::report(draft.room, draft.options, outcome.plan);
        return outcome;
    } catch (const Error& error) {
        return {{}, {}, QString::fromStdString(error.sentence())};
    } catch (const std::exception& defect) {
        return {{}, {}, QString::fromUtf8(defect.what())};
    }
}

} // namespace spherewalk::ui
