// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/frame/mode.h"
#include "ui/map/plan_view.h"
#include "ui/preview/robot.h"

#include <QSet>
#include <QWidget>

#include <memory>
#include <optional>

namespace spherewalk::ui {

class PreviewPresenter;
struct DriveWish;

/// Shows what the robot's camera sees: one view, or two side by side, each with its report, and the robot's
/// own picture beside them. W A S D or the arrow keys drive, Q and E go sideways, and dragging turns the
/// robot.
class DriveView : public QWidget {
    Q_OBJECT

  public:
    explicit DriveView(PreviewPresenter& presenter, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {800, 600}; }

    /// Returns the report of a view in words. share: see MadeView.
    static QString reportText(const render::ViewReport& report, double share = 1);
    /// Says by how many pixels of the camera things are displaced, or why nobody knows.
    static QString errorText(const render::ViewReport& report);
    /// Returns the keys of the view, for the list of all keys.
    static QList<Mode::Key> keys();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

  private:
    static bool isDriving(int key);
    bool changeObject(const QKeyEvent& event);
    std::optional<Eigen::Vector2d> pixelAt(const QPointF& place) const;
    DriveWish wish() const;
    QRect boxOf(std::size_t view) const;
    static void paintView(QPainter& painter, const QRect& box, const MadeView& view);
    void paintErrorLegend(QPainter& painter) const;

    PreviewPresenter& m_presenter;
    QSet<int> m_held;
    QPointF m_dragFrom;
};

/// The plan of the presenter's dataset with its photos. The robot, its field of view, the photo of the view,
/// the recorded path and the ball are drawn above it.
class RobotMap : public PlanView {
    Q_OBJECT

  public:
    explicit RobotMap(const PreviewPresenter& presenter, QWidget* parent = nullptr);
    ~RobotMap() override;

  protected:
    QString emptyText() const override;

  private:
    class Layer;

    void showDataset();

    const PreviewPresenter& m_presenter;
    std::unique_ptr<Layer> m_layer;
};

} // namespace spherewalk::ui
