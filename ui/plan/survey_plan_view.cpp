// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/survey_plan_view.h"

#include "ui/plan/station_words.h"

namespace spherewalk::ui {

SurveyPlanView::SurveyPlanView(QWidget* parent) : PlanView(parent) {
    connect(this, &PlanView::stationClicked, this, [this](std::int64_t station) {
        if (m_session) {
            m_session->selection()->setCurrent(station);
        }
    });
}

void SurveyPlanView::setSession(SurveySession* session) {
    if (m_session) {
        m_session->disconnect(this);
        m_session->selection()->disconnect(this);
    }
    m_session = session;
    if (session != nullptr) {
        connect(session, &SurveySession::changed, this, [this](SurveySession::Changes what) {
            if (what.testFlag(SurveySession::Plan)) {
                showRoom();
            }
            refresh();
        });
        connect(session->selection(), &StationSelection::currentChanged, this, &PlanView::setCurrent);
    }
    setCurrent(session != nullptr ? session->selection()->current() : std::nullopt);
    showRoom();
    refresh();
}

void SurveyPlanView::showRoom() {
    setRoom(m_session ? m_session->state().room : survey::Room());
    fit();
}

void SurveyPlanView::refresh() {
    setStations(m_session ? marks(m_session->state()) : std::vector<StationMark>());
}

std::vector<StationMark> SurveyPlanView::marks(const SurveyState& survey) const {
    std::vector<StationMark> result;
    for (const store::StationRecord& station : survey.stations) {
        const bool isMissing = survey.missing.contains(station.id);
        StationMark mark;
        mark.id = station.id;
        mark.positionM = station.station.positionM.head<2>();
        mark.name = stationWords(station.name);
        mark.standing = isMissing ? Standing::Missing : Standing::Taken;
        mark.note = isMissing ? tr("no photo yet") : tr("has a photo");
        result.push_back(mark);
    }
    return result;
}

} // namespace spherewalk::ui
