// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QListWidget;

namespace spherewalk::ui {

/// What the window shows while no survey is open: the practice room for those who come for the first time, a
/// new survey, and the recent ones.
class StartPage : public QWidget {
    Q_OBJECT

  public:
    explicit StartPage(QWidget* parent = nullptr);

    /// Folders, the latest first.
    void setRecent(const QStringList& folders);

  signals:
    void practiceRequested();
    void newRequested();
    void chooseRequested();
    void openRequested(const QString& folder);

  private:
    QLabel* m_recentTitle;
    QListWidget* m_recent;
};

} // namespace spherewalk::ui
