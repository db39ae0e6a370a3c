// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/survey_state.h"

namespace spherewalk::ui {

SurveyState readState(const store::SurveyStore& store) {
    SurveyState state;
    state.room = store.room();
    state.options = store.planOptions();
    state.profile = store.captureProfile();
    state.plan = store.plan();
    state.stations = store.stations();
    for (const store::StationRecord& station : store.stationsWithoutPhoto()) {
        state.missing.insert(station.id);
    }
    state.counts = store.counts();
    return state;
}

} // namespace spherewalk::ui
