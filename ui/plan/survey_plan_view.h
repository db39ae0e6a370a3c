// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plan/plan_view.h"
#include "ui/session/survey_session.h"

#include <QPointer>

namespace spherewalk::ui {

/// The plan of the open survey, kept up to date, with the station that all views share. A subclass may show
/// the stations its own way.
class SurveyPlanView : public PlanView {
    Q_OBJECT

  public:
    explicit SurveyPlanView(QWidget* parent = nullptr);

    /// Null: none is open.
    void setSession(SurveySession* session);

    SurveySession* session() const { return m_session; }

    /// Shows the stations as they are now.
    void refresh();

  protected:
    /// By default whether each station has a photo.
    virtual std::vector<StationMark> marks(const SurveyState& survey) const;

  private:
    void showRoom();

    QPointer<SurveySession> m_session;
};

} // namespace spherewalk::ui
