// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/words.h"
#include "ui/map/plan_canvas.h"
#include "ui/session/survey_session.h"

#include "spherewalk/survey/room.h"

#include <QPointer>

#include <cstdint>
#include <optional>
#include <vector>

namespace spherewalk::ui {

/// A station as the plan draws it.
struct StationMark {
    std::int64_t id = 0;
    Eigen::Vector2d positionM = Eigen::Vector2d::Zero();
    QString name;
    Standing standing = Standing::Missing;
    std::optional<double> heat =
        {};            ///< In [0, 1], where 1 is the worst. It replaces the colour of the standing.
    QString note = {}; ///< Second line of the tool tip.
};

/// The room from above with its stations. Each standing has its own form: a ring (missing), a disc (taken,
/// accepted), a triangle (doubtful), a square with a cross (failed), a ring struck through (rejected).
class PlanView : public PlanCanvas {
    Q_OBJECT

  public:
    explicit PlanView(QWidget* parent = nullptr);

    /// walls: dashed lines for a room that nobody has drawn.
    void setRoom(const survey::Room& room, Qt::PenStyle walls = Qt::SolidLine);

    const survey::Room& room() const { return m_room; }

    Qt::PenStyle walls() const { return m_walls; }

    void setStations(std::vector<StationMark> stations);

    const std::vector<StationMark>& stations() const { return m_stations; }

    /// Returns the sentence that stands in place of a room; empty where there is one.
    QString words() const;

    /// Draws a ring around this station; nothing: around none.
    void setCurrent(std::optional<std::int64_t> station);

    /// Returns the colour of a heat in [0, 1], from a scale that colour-blind people can read.
    static QColor heatColour(double heat);

  signals:
    void stationClicked(std::int64_t station);

  protected:
    void paintFloor(QPainter& painter, const QTransform& widgetFromRoom) override;
    bool showsGrid() const override;
    /// Returns what a plan without a room says.
    virtual QString emptyText() const;
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void showAll(); ///< The extent of walls and stations.
    double stationRadiusPx() const;
    /// Returns the mark at this point of the widget; null without one.
    const StationMark* markAt(const QPointF& at) const;
    void paintMark(QPainter& painter, const StationMark& mark, const QPointF& at) const;

    survey::Room m_room;
    Qt::PenStyle m_walls = Qt::SolidLine;
    std::vector<StationMark> m_stations;
    std::optional<std::int64_t> m_current;
    double m_spacingM = 0; ///< Distance between neighbouring stations.
};

/// The plan of the open survey with the current station. It follows every change of the survey. A subclass
/// can choose other marks.
class SurveyPlanView : public PlanView {
    Q_OBJECT

  public:
    explicit SurveyPlanView(QWidget* parent = nullptr);

    /// Null: no survey is open.
    void setSession(SurveySession* session);

    SurveySession* session() const { return m_session; }

    /// Draws the stations anew, as a subclass wants after a change of its own.
    void refresh();

  protected:
    /// Returns the marks of the stations. Here they tell the standing of each station's photo.
    virtual std::vector<StationMark> marks(const SurveyState& survey) const;
    /// Returns whether it is known where the station is. Others are not shown.
    virtual bool isPlaced(const store::StationRecord& station) const;
    QString emptyText() const override;

  private:
    void showRoom();

    QPointer<SurveySession> m_session;
};

} // namespace spherewalk::ui
