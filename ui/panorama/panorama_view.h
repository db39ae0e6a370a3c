// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/survey/private_region.h"

#include <QPointF>
#include <QWidget>

#include <optional>

namespace spherewalk::ui {

class PanoramaPresenter;

/// A panorama to look around in. Dragging or the arrow keys turn, the wheel or + and - change the field of
/// view, and 0 looks level again. The line between two compared photos is dragged, or moved with [ and ]. A
/// click or Tab selects a private region. While RegionTool::isMarking(), a box is dragged, or moved and sized
/// with the arrow keys.
class PanoramaView : public QWidget {
    Q_OBJECT

  public:
    explicit PanoramaView(QWidget* parent = nullptr);

    PanoramaPresenter& presenter() { return *m_presenter; }

    QSize sizeHint() const override { return {640, 480}; }

  signals:
    /// A person has put a box around what is to be a private region.
    void regionMarked(const survey::PrivateRegion& region);
    /// A person wants the selected private region to be removed.
    void removalWanted();

  protected:
    bool event(QEvent* event) override;
    bool focusNextPrevChild(bool isNext) override;
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
    void paintRegions(QPainter& painter) const;
    void paintBox(QPainter& painter) const;
    void paintLook(QPainter& painter) const;
    void showState();
    void mark();
    bool pressWhileMarking(const QKeyEvent& event);

    PanoramaPresenter* m_presenter;
    QPointF m_pressedAt;
    std::optional<QPointF> m_dragFrom;
    bool m_dragsLine = false;
    bool m_isClick = false; ///< The pointer has not moved since it was pressed.
};

} // namespace spherewalk::ui
