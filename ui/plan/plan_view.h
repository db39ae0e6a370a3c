// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/survey/room.h"

#include <QTransform>
#include <QWidget>

#include <vector>

namespace spherewalk::ui {

/// A station as the plan shows it.
struct StationMark {
    Eigen::Vector2d positionM = Eigen::Vector2d::Zero();
    QString name;
    bool hasPhoto = false;
};

/// The room seen from above with its stations: filled where there is a photo, a ring where there is none, so
/// that the difference does not hang on colour. Always scaled to fit. Units: metres, room frame, y up.
class PlanView : public QWidget {
    Q_OBJECT

  public:
    explicit PlanView(QWidget* parent = nullptr);

    void setRoom(const survey::Room& room);
    void setStations(std::vector<StationMark> stations);

    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

  private:
    /// Takes room coordinates to the widget's.
    QTransform widgetFromRoom() const;
    double stationRadiusPx(const QTransform& widgetFromRoom) const;

    survey::Room m_room;
    std::vector<StationMark> m_stations;
};

} // namespace spherewalk::ui
