// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QFormLayout;
class QLabel;

namespace spherewalk::ui {

/// A titled part of a side panel.
class Section : public QFrame {
    Q_OBJECT

  public:
    explicit Section(const QString& title, QWidget* parent = nullptr);

    QLabel* title() const { return m_title; }

    /// A text that wraps and can be selected.
    QLabel* addWords();
    QFormLayout* addForm();
    /// A labelled field; the hint becomes its tool tip, the label its accessible name.
    void addRow(QFormLayout* form, const QString& label, QWidget* field, const QString& hint);

  private:
    QLabel* m_title;
};

} // namespace spherewalk::ui
