// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>

class QLabel;

namespace spherewalk::ui {

class PlanView;

/// The program's window: for now, it shows the plan of a survey and how far it is.
class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    explicit MainWindow(QWidget* parent = nullptr);

    /// Opens the survey for reading and shows it; if it cannot be opened, says why in the status line and
    /// keeps what is shown. Returns whether it was opened.
    bool openSurvey(const QString& folder);

  private:
    void chooseSurvey();

    PlanView* m_plan;
    QLabel* m_counts;
};

} // namespace spherewalk::ui
