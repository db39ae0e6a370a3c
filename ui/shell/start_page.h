// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QListWidget;

namespace spherewalk::ui {

/// What the window shows while no survey is open.
class StartPage : public QWidget {
    Q_OBJECT

  public:
    explicit StartPage(QWidget* parent = nullptr);

    /// Folders, the latest first.
    void setRecent(const QStringList& folders);

  signals:
    void openRequested(const QString& folder);
    void chooseRequested();

  private:
    QListWidget* m_recent;
};

} // namespace spherewalk::ui
