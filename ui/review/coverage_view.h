// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/map/plan_view.h"
#include "ui/review/review_model.h"

namespace spherewalk::ui {

/// What the marks on the plan tell.
enum class CoverageMeasure {
    Standing, ///< State of the station: taken, missing, doubtful, failed, rejected.
    Residual, ///< Residual of the matches of each photo, as heat.
    Sigma,    ///< Standard deviation of the heading of each photo, as heat.
    Error,    ///< Measured error of views at the place of each photo, as heat.
};

/// The plan of a survey, whose marks tell a measure of each photo.
class CoverageView : public SurveyPlanView {
    Q_OBJECT

  public:
    explicit CoverageView(QWidget* parent = nullptr);

    void setRows(const std::vector<ReviewRow>& rows);
    void setMeasure(CoverageMeasure measure);

    /// Returns the value of heat 1 with its unit ("0.15°", "4.2 px"); empty without heat.
    QString hottest() const;

  protected:
    std::vector<StationMark> marks(const SurveyState& survey) const override;

  private:
    /// Returns the measure of a row in degrees or pixels.
    std::optional<double> measured(const ReviewRow& row) const;
    double greatest() const;
    QString valueText(double value) const;

    std::vector<ReviewRow> m_rows;
    CoverageMeasure m_measure = CoverageMeasure::Standing;
};

/// The legend of a CoverageView: the signs of the standings, or the scale of the heat.
class CoverageLegend : public QWidget {
    Q_OBJECT

  public:
    explicit CoverageLegend(QWidget* parent = nullptr);

    /// Shows the scale up to this value; empty: the signs of the standings.
    void setHottest(const QString& hottest);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

    bool hasHeightForWidth() const override { return true; }

    int heightForWidth(int width) const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QString m_hottest;
};

} // namespace spherewalk::ui
