// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <vector>

class QLabel;
class QPushButton;

namespace spherewalk::ui {

/// Leads a newcomer through the pages in five steps, with the practice room: a strip above the page says what
/// it is for and what to try. It is hidden until begin().
class Tour : public QWidget {
    Q_OBJECT

  public:
    explicit Tour(QWidget* parent = nullptr);

    /// Shows the first step. The window must have opened the practice survey.
    void begin();
    void end();

    /// Returns the number of the present step, from 0.
    int step() const { return m_step; }

    int steps() const { return static_cast<int>(m_steps.size()); }

  signals:
    /// Asks the window to show the page of this name.
    void pageWanted(const QString& page);
    /// Asks the practice camera to take the photos, while its page is shown.
    void photosWanted();

  private:
    struct Step {
        QString page;
        QString words;
    };

    void show(int step);

    std::vector<Step> m_steps;
    int m_step = 0;
    QLabel* m_words;
    QPushButton* m_back;
    QPushButton* m_next;
};

} // namespace spherewalk::ui
