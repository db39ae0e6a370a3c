// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/standing.h"
#include "ui/plan/plan_canvas.h"

#include "spherewalk/survey/room.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace spherewalk::ui {

/// A station as the plan shows it.
struct StationMark {
    std::int64_t id = 0;
    Eigen::Vector2d positionM = Eigen::Vector2d::Zero();
    QString name;
    Standing standing = Standing::Missing;
    std::optional<double> heat = {}; ///< in [0, 1], 1 the worst: shown as colour in place of the standing's
    QString note = {};               ///< second line of the tool tip
};

/// The room seen from above with its stations. Each standing has its own form, so that nothing hangs on
/// colour: a ring (missing), a disc (taken, accepted), a triangle (doubtful), a square with a cross (failed),
/// a ring struck through (rejected).
class PlanView : public PlanCanvas {
    Q_OBJECT

  public:
    explicit PlanView(QWidget* parent = nullptr);

    void setRoom(const survey::Room& room);

    const survey::Room& room() const { return m_room; }

    void setStations(std::vector<StationMark> stations);

    const std::vector<StationMark>& stations() const { return m_stations; }

    /// Shown with a ring around it; nothing: none.
    void setCurrent(std::optional<std::int64_t> station);

    /// The colour of a heat in [0, 1]: a scale that the colour-blind can read.
    static QColor heatColour(double heat);

  signals:
    void stationClicked(std::int64_t station);

  protected:
    void paintFloor(QPainter& painter, const QTransform& widgetFromRoom) override;
    bool showsGrid() const override;
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    double stationRadiusPx() const;
    /// The one at this point of the widget.
    const StationMark* markAt(const QPointF& at) const;
    void paintMark(QPainter& painter, const StationMark& mark, const QPointF& at) const;

    survey::Room m_room;
    std::vector<StationMark> m_stations;
    std::optional<std::int64_t> m_current;
    double m_spacingM = 0; ///< between neighbouring stations
};

} // namespace spherewalk::ui
