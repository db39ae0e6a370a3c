// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/rail_tool.h"

#include "ui/map/plan_canvas.h"

#include <QKeyEvent>
#include <QLineF>

#include <algorithm>

namespace spherewalk::ui {

using Eigen::Vector2d;
using survey::RailEnd;
using survey::RailPlacement;

namespace {

constexpr double kReachPx = 9;

enum RunKey { kMoveRail = 1100, kPullRail, kTurnRail, kLengthenRail };

Vector2d directionOf(const RailPlacement& rail) {
    return {cos(rail.heading), sin(rail.heading)};
}

/// Returns the place on the rail's line that is nearest to this one.
Vector2d onLine(const RailPlacement& rail, const Vector2d& place) {
    return rail.origin + (place - rail.origin).dot(directionOf(rail)) * directionOf(rail);
}

} // namespace

QString RailTool::hint() {
    return tr(
        "Drag a rail to move it, its first or last stop to turn and lengthen it (Shift: without a turn), or "
        "free floor to lay a rail. Ctrl+arrows turn it or change its length; Delete removes a stop or a "
        "rail.");
}

PlanPart RailTool::partAt(const QPointF& at, const QTransform& widgetFromRoom) const {
    const std::vector<RailPlacement>& rails = m_editor.rails();
    PlanPart found;
    double leastPx = kReachPx;
    for (std::size_t i = 0; i < rails.size(); ++i) {
        for (int k = 0; k < rails[i].stops; ++k) {
            const double apartPx = QLineF(mapped(rails[i].stop(k), widgetFromRoom), at).length();
            if (apartPx < leastPx) {
                found = {.rail = static_cast<int>(i), .stop = k};
                leastPx = apartPx;
            }
        }
    }
    for (std::size_t i = 0; found.rail == PlanPart::kNone && i < rails.size(); ++i) {
        const QLineF line(mapped(rails[i].origin, widgetFromRoom),
                          mapped(rails[i].stop(rails[i].stops - 1), widgetFromRoom));
        if (distanceTo(at, line) < kReachPx) {
            found = {.rail = static_cast<int>(i)};
        }
    }
    return found;
}

void RailTool::press(const QPointF& at, const Vector2d& place, const QTransform& widgetFromRoom) {
    m_isDragging = true;
    m_last = place;
    m_dragged = partAt(at, widgetFromRoom);
    m_newFrom.reset();
    m_end.reset();
    m_editor.select(m_dragged);
    m_editor.endRun();
    if (m_dragged.rail == PlanPart::kNone) {
        m_newFrom = place;
        return;
    }
    const int last = m_editor.rails()[static_cast<std::size_t>(m_dragged.rail)].stops - 1;
    if (last > 0 && (m_dragged.stop == 0 || m_dragged.stop == last)) {
        m_end = m_dragged.stop == 0 ? RailEnd::First : RailEnd::Last;
    }
}

void RailTool::drag(const Vector2d& place, bool keepsHeading) {
    if (!m_isDragging || (place - m_last).norm() == 0) {
        return;
    }
    const double stepM = m_editor.draft().options.stepM;
    if (m_newFrom && m_dragged.rail == PlanPart::kNone) {
        if ((place - *m_newFrom).norm() >= 0.5 * stepM) {
            m_editor.addRail(survey::laid(*m_newFrom, place, stepM));
            m_dragged = m_editor.selected();
        }
        return;
    }
    const std::vector<RailPlacement>& rails = m_editor.rails();
    if (m_dragged.rail >= static_cast<int>(rails.size())) {
        return;
    }
    const RailPlacement rail = rails[static_cast<std::size_t>(m_dragged.rail)];
    if (m_newFrom || m_end) {
        const Vector2d to = keepsHeading ? onLine(rail, place) : place;
        const RailEnd end = m_end.value_or(RailEnd::Last);
        m_editor.select({.rail = m_dragged.rail}); // the stop that was pressed may go
        m_editor.changeRail(tr("Pull rail"), m_dragged.rail, survey::pulled(rail, end, to), kPullRail);
    } else {
        m_editor.changeRail(tr("Move rail"), m_dragged.rail, survey::moved(rail, place - m_last), kMoveRail);
    }
    m_last = place;
}

void RailTool::release() {
    m_isDragging = false;
}

bool RailTool::turnOrLengthen(const QKeyEvent& event, const RailPlacement& rail) {
    const int at = m_editor.selected().rail;
    const double turn = event.modifiers().testFlag(Qt::ShiftModifier) ? 15 : 1;
    const auto turnBy = [&](double degrees) {
        m_editor.changeRail(tr("Turn rail"), at, survey::turned(rail, Degrees(degrees)), kTurnRail);
    };
    const auto lengthenBy = [&](int stops) {
        const int most = std::clamp(rail.stops + stops, 1, survey::kMostRailStops);
        m_editor.select({.rail = at});
        m_editor.changeRail(tr("Change length"), at, survey::withStops(rail, most), kLengthenRail);
    };
    switch (event.key()) {
    case Qt::Key_Up:
        turnBy(turn);
        return true;
    case Qt::Key_Down:
        turnBy(-turn);
        return true;
    case Qt::Key_Right:
        lengthenBy(1);
        return true;
    case Qt::Key_Left:
        lengthenBy(-1);
        return true;
    default:
        return false;
    }
}

bool RailTool::key(const QKeyEvent& event, double stepM) {
    if (m_editor.selected().rail == PlanPart::kNone) {
        return false;
    }
    const int at = m_editor.selected().rail;
    const RailPlacement rail = m_editor.rails()[static_cast<std::size_t>(at)];
    if (event.modifiers().testFlag(Qt::ControlModifier)) {
        return turnOrLengthen(event, rail);
    }
    const auto moveBy = [&](const Vector2d& by) {
        m_editor.changeRail(tr("Move rail"), at, survey::moved(rail, by), kMoveRail);
        return true;
    };
    switch (event.key()) {
    case Qt::Key_Left:
        return moveBy({-stepM, 0});
    case Qt::Key_Right:
        return moveBy({stepM, 0});
    case Qt::Key_Up:
        return moveBy({0, stepM});
    case Qt::Key_Down:
        return moveBy({0, -stepM});
    default:
        return false;
    }
}

void RailTool::next(int step) {
    const int count = static_cast<int>(m_editor.rails().size());
    const int at = m_editor.selected().rail;
    if (count > 0) {
        m_editor.select({.rail = at == PlanPart::kNone ? 0 : (at + step + count) % count});
    }
}

} // namespace spherewalk::ui
