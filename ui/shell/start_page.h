// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace spherewalk::ui {

class RecentSurveys;

/// The page of a window without a survey. It offers the practice room, a new survey and the recent surveys.
class StartPage : public QWidget {
    Q_OBJECT

  public:
    explicit StartPage(QWidget* parent = nullptr);

    /// Lists these folders, the latest first.
    void setRecent(const QStringList& folders);

  signals:
    void practiceRequested();
    void tourRequested();
    void newRequested();
    void chooseRequested();
    void openRequested(const QString& folder);

  private:
    QPushButton* m_practice;
    QPushButton* m_begin;
    QPushButton* m_open;
    QLabel* m_recentTitle;
    RecentSurveys* m_recent;
};

} // namespace spherewalk::ui
