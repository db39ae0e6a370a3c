// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plan/survey_plan_view.h"

namespace spherewalk::ui {

class CaptureDesk;

/// The plan with the next station as a large target, and the rail that it is on.
class CapturePlanView : public SurveyPlanView {
    Q_OBJECT

  public:
    explicit CapturePlanView(const CaptureDesk& desk, QWidget* parent = nullptr);

  protected:
    std::vector<StationMark> marks(const SurveyState& survey) const override;
    void paintFloor(QPainter& painter, const QTransform& widgetFromRoom) override;

  private:
    void paintCorners(QPainter& painter, const QTransform& widgetFromRoom) const;

    const CaptureDesk& m_desk;
};

} // namespace spherewalk::ui
