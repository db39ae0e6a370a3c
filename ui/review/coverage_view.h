// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plan/survey_plan_view.h"
#include "ui/review/review_rows.h"

namespace spherewalk::ui {

/// What the plan's marks tell.
enum class CoverageMeasure {
    Standing, ///< taken, missing, doubtful, failed, rejected
    Residual, ///< how far the matches of each photo miss, as heat
    Sigma,    ///< how exactly each photo's heading is known, as heat
    Error,    ///< how far views in place of each photo were measured to be off, as heat
};

/// How far a survey is, on its plan.
class CoverageView : public SurveyPlanView {
    Q_OBJECT

  public:
    explicit CoverageView(QWidget* parent = nullptr);

    void setRows(const std::vector<ReviewRow>& rows);
    void setMeasure(CoverageMeasure measure);

    /// The measure that is at heat 1, as people read it ("0.15°", "4.2 px"); empty without heat.
    QString hottest() const;

  protected:
    std::vector<StationMark> marks(const SurveyState& survey) const override;

  private:
    /// In the unit that people read.
    std::optional<double> measured(const ReviewRow& row) const;
    double greatest() const;
    QString valueText(double value) const;

    std::vector<ReviewRow> m_rows;
    CoverageMeasure m_measure = CoverageMeasure::Standing;
};

/// The legend of a CoverageView: the signs that there are, or the scale of the heat.
class CoverageLegend : public QWidget {
    Q_OBJECT

  public:
    explicit CoverageLegend(QWidget* parent = nullptr);

    /// Empty: the signs of the standings.
    void setHottest(const QString& hottest);

    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QString m_hottest;
};

} // namespace spherewalk::ui
