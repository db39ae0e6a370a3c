// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plan/plan_editor.h"

#include "spherewalk/survey/laid_rails.h"

#include <QCoreApplication>
#include <QTransform>

#include <optional>

class QKeyEvent;

namespace spherewalk::ui {

/// What pointer and keys do while rails are laid by hand. A drag moves a rail, or turns and lengthens it by
/// one of its ends, or lays a new one on free floor. It holds no widget.
class RailTool {
    Q_DECLARE_TR_FUNCTIONS(spherewalk::ui::RailTool)

  public:
    explicit RailTool(PlanEditor& editor) : m_editor(editor) {}

    /// Returns a sentence about pointer and keys.
    static QString hint();

    /// Begins a drag. at: on the widget. place: the same place in the room, as it snaps.
    void press(const QPointF& at, const Eigen::Vector2d& place, const QTransform& widgetFromRoom);
    /// Goes on to this place. keepsHeading: a rail that is pulled does not turn.
    void drag(const Eigen::Vector2d& place, bool keepsHeading);
    void release();

    /// Returns whether the key means something. stepM: of the arrows.
    bool key(const QKeyEvent& event, double stepM);
    /// Selects the next rail, or for -1 the one before.
    void next(int step);

  private:
    /// Returns the stop, or else the rail at this point of the widget.
    PlanPart partAt(const QPointF& at, const QTransform& widgetFromRoom) const;
    bool turnOrLengthen(const QKeyEvent& event, const survey::RailPlacement& rail);

    PlanEditor& m_editor;
    bool m_isDragging = false;
    PlanPart m_dragged;
    std::optional<survey::RailEnd> m_end; ///< The end that is pulled.
    std::optional<Eigen::Vector2d> m_newFrom;
    Eigen::Vector2d m_last = Eigen::Vector2d::Zero();
};

} // namespace spherewalk::ui
