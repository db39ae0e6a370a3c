// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QScrollArea>

class QFormLayout;
class QLabel;
class QPushButton;

namespace spherewalk::ui {

/// A titled group of controls in a side panel.
class Section : public QFrame {
    Q_OBJECT

  public:
    explicit Section(const QString& title, QWidget* parent = nullptr);

    QLabel* title() const { return m_title; }

    /// Adds a text that wraps and can be selected.
    QLabel* addWords();
    /// Adds a form for addRow().
    QFormLayout* addForm();
    /// Adds a labelled field. The hint becomes its tool tip, and the label its accessible name.
    void addRow(QFormLayout* form, const QString& label, QWidget* field, const QString& hint);

  private:
    QLabel* m_title;
};

/// A column of controls that scrolls vertically. Its least width is the one of its controls.
class ColumnScrollArea : public QScrollArea {
  public:
    explicit ColumnScrollArea(QWidget* column, QWidget* parent = nullptr);

    QSize minimumSizeHint() const override;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

/// Gives the button the look of the one to press next. The icon stays as it is.
void makePrimary(QPushButton* button);

/// Gives the label the look of a warning that cannot be overlooked, in either theme.
void makeWarning(QLabel* label);

} // namespace spherewalk::ui
