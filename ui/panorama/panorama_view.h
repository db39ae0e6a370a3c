// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QWidget>

#include <optional>

namespace spherewalk::ui {

class PanoramaPresenter;

/// A panorama to look around in. Dragging or the arrow keys turn, the wheel or + and - change the field of
/// view, and 0 looks level again. The line between two compared photos is dragged, or moved with [ and ].
class PanoramaView : public QWidget {
    Q_OBJECT

  public:
    explicit PanoramaView(QWidget* parent = nullptr);

    PanoramaPresenter& presenter() { return *m_presenter; }

    QSize sizeHint() const override { return {640, 480}; }

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    bool isOnLine(const QPointF& at) const;
    void paintLine(QPainter& painter) const;
    void paintNames(QPainter& painter) const;
    void paintAreas(QPainter& painter) const;
    void paintLook(QPainter& painter) const;

    PanoramaPresenter* m_presenter;
    std::optional<QPointF> m_dragFrom;
    bool m_dragsLine = false;
};

} // namespace spherewalk::ui
