// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/camera/osc_client.h"

#include <QString>
#include <QStringList>

#include <cstdint>
#include <optional>
#include <stop_token>

namespace spherewalk::ui {

/// How the camera is, as the operator sees it.
struct CameraStatus {
    enum class Heat { Normal, Warm, Hot };

    QString model;
    QString serialNumber;
    QString firmware;
    std::optional<double> batteryFraction;
    bool isCharging = false;
    std::optional<std::int64_t> remainingPhotos;
    Heat heat = Heat::Normal;
    QStringList troubles; ///< sentences
};

/// Asks who the camera is and how it is. Threads: the client's. Errors: those of the client.
CameraStatus askCamera(camera::OscClient& client, const std::stop_token& stop);

/// What the camera's state says, put into the status.
void update(CameraStatus& status, const camera::CameraState& state);

} // namespace spherewalk::ui
