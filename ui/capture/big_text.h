// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace spherewalk::ui {

/// A line of text as large as its place allows, to be read from three metres.
class BigText : public QWidget {
    Q_OBJECT

  public:
    explicit BigText(QWidget* parent = nullptr);

    const QString& text() const { return m_text; }

    void setText(const QString& text);

    QSize sizeHint() const override { return {420, 110}; }

    QSize minimumSizeHint() const override { return {160, 56}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QString m_text;
};

} // namespace spherewalk::ui
