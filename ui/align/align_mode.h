// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/frame/mode.h"
#include "ui/map/plan_canvas.h"

#include "spherewalk/jobs/solution_findings.h"

#include <filesystem>
#include <vector>

class QComboBox;
class QDoubleSpinBox;
class QPushButton;
class QTableView;

namespace spherewalk::ui {

class AlignPresenter;
class CoverageLegend;
class CoverageView;
class TaskBar;
class TaskList;
class ToldLabel;

/// Draws the solved pose of each photo on the plan: a line along its heading, and a fan of three standard
/// deviations, which is magnified to be visible.
class HeadingLayer : public PlanLayer {
  public:
    static constexpr double kMagnified = 50; ///< Factor on the angle of the fans.

    void setPhotos(const std::vector<jobs::PhotoFinding>& photos) { m_photos = photos; }

    void paint(QPainter& painter, const QTransform& widgetFromRoom) override;

  private:
    std::vector<jobs::PhotoFinding> m_photos;
};

/// The page that aligns the photos and shows the findings.
class AlignMode : public Mode {
    Q_OBJECT

  public:
    explicit AlignMode(TaskList& tasks, QWidget* parent = nullptr);
    ~AlignMode() override;

    void setSession(SurveySession* session) override;
    void activated() override;

  private:
    QWidget* makeBar();
    QWidget* makeTable();
    QWidget* makePlan();
    void run();
    void chooseFree();
    void showFree();
    bool isFree() const;
    void chooseMask();
    void setMask(const std::filesystem::path& mask);
    void showFindings();
    void showTask();
    void showProposals();
    void selectStation();
    void sizeColumns();
    std::vector<std::int64_t> chosen() const;

    AlignPresenter* m_presenter;
    bool m_areColumnsSized = false;
    HeadingLayer m_headings;
    std::filesystem::path m_mask;
    bool m_isByHand = false;
    QComboBox* m_places = nullptr;
    QComboBox* m_effort = nullptr;
    QComboBox* m_model = nullptr;
    QDoubleSpinBox* m_positionSigma = nullptr;
    QDoubleSpinBox* m_lensHeight = nullptr;
    QList<QWidget*> m_ofTagged; ///< What has a meaning for tagged places.
    QList<QWidget*> m_ofFree;   ///< What has one for places that are solved from the pictures alone.
    QPushButton* m_maskButton = nullptr;
    QPushButton* m_run = nullptr;
    TaskBar* m_progress = nullptr;
    ToldLabel* m_summary = nullptr;
    QTableView* m_table = nullptr;
    ToldLabel* m_reason = nullptr;
    QPushButton* m_retag = nullptr;
    QPushButton* m_retagAll = nullptr;
    QPushButton* m_retake = nullptr;
    CoverageView* m_plan = nullptr;
    CoverageLegend* m_legend = nullptr;
};

} // namespace spherewalk::ui
