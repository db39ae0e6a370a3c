// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/angle.h"

#include <QImage>
#include <QPointF>
#include <QString>

namespace spherewalk::ui {

/// What the YAML file of a robot's map says, as map_server and Nav2 write it. Frames: that of the map, which
/// becomes the room's. Source: wiki.ros.org/map_server, section "Map format".
struct RobotMapFile {
    enum class Mode { Trinary, Scale, Raw };

    QString image; ///< With its folder.
    double metresPerPixel = 0;
    QPointF origin; ///< Place of the lower left corner of the lower left pixel.
    Radians yaw;    ///< Of the picture around its origin, counter-clockwise.
    bool isNegated = false;
    double occupied = 0.65; ///< Pixels whose occupancy is greater are walls.
    double free = 0.196;    ///< Pixels whose occupancy is less are floor.
    Mode mode = Mode::Trinary;
};

/// Errors: NotFound, Io; Corrupt, with the entry that is missing or wrong.
RobotMapFile readRobotMap(const QString& yaml);

/// Returns the picture that people look at: walls black, floor white, and what is unknown grey. pixels: grey
/// values of the map's image.
QImage mapPicture(const RobotMapFile& map, const QImage& pixels);

} // namespace spherewalk::ui
