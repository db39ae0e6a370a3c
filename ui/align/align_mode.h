// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/align/heading_layer.h"
#include "ui/shell/mode.h"

#include <filesystem>
#include <vector>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTableView;

namespace spherewalk::ui {

class AlignPresenter;
class CoverageLegend;
class CoverageView;
class TaskList;

/// How the photos are turned is solved, watched, and judged.
class AlignMode : public Mode {
    Q_OBJECT

  public:
    explicit AlignMode(TaskList& tasks, QWidget* parent = nullptr);
    ~AlignMode() override;

    QString title() const override { return tr("Align"); }

    QIcon icon() const override;

    QString hint() const override {
        return tr("Solve how each photo is turned, and see how well it is known");
    }

    void setSession(SurveySession* session) override;
    void activated() override;

    bool showsPlan() const override { return true; }

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    QWidget* makeBar();
    QWidget* makeTable();
    QWidget* makePlan();
    void run();
    void chooseMask();
    void setMask(const std::filesystem::path& mask);
    void showFindings();
    void showTask();
    void showProgress();
    void showProposals();
    void selectStation();
    void sizeColumns();
    std::vector<std::int64_t> chosen() const;
    bool event(QEvent* event) override;

    AlignPresenter* m_presenter;
    SurveySession* m_session = nullptr;
    bool m_areColumnsSized = false;
    HeadingLayer m_headings;
    std::filesystem::path m_mask;
    QComboBox* m_effort = nullptr;
    QComboBox* m_model = nullptr;
    QDoubleSpinBox* m_positionSigma = nullptr;
    QPushButton* m_maskButton = nullptr;
    QPushButton* m_run = nullptr;
    QPushButton* m_stop = nullptr;
    QProgressBar* m_progress = nullptr;
    QLabel* m_summary = nullptr;
    QTableView* m_table = nullptr;
    QLabel* m_reason = nullptr;
    QPushButton* m_retag = nullptr;
    QPushButton* m_retagAll = nullptr;
    QPushButton* m_retake = nullptr;
    QPushButton* m_maskChosen = nullptr;
    CoverageView* m_plan = nullptr;
    CoverageLegend* m_legend = nullptr;
};

} // namespace spherewalk::ui
