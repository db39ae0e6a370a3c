// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/preview/view_maker.h"

#include <QSet>
#include <QWidget>

namespace spherewalk::ui {

struct DriveWish;
class PreviewPresenter;

/// What the robot's camera sees, one view or two beside each other, each with its report. With the keyboard
/// here, W A S D or the arrow keys drive, Q and E go sideways. Dragging turns the robot.
class DriveView : public QWidget {
    Q_OBJECT

  public:
    explicit DriveView(PreviewPresenter& presenter, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {800, 600}; }

    /// The report as people read it.
    static QString reportText(const render::ViewReport& report);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

  private:
    static bool isDriving(int key);
    DriveWish wish() const;
    QRect boxOf(std::size_t view) const;
    void paintView(QPainter& painter, const QRect& box, const MadeView& view) const;

    PreviewPresenter& m_presenter;
    QSet<int> m_held;
    QPointF m_dragFrom;
};

} // namespace spherewalk::ui
