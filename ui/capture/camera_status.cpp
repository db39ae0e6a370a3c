// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/camera_status.h"

#include "spherewalk/base/error.h"

#include <algorithm>

namespace spherewalk::ui {

namespace {

bool anyOf(const std::vector<std::string>& errors, std::initializer_list<std::string_view> codes) {
    return std::any_of(errors.begin(), errors.end(), [&](const std::string& error) {
        return std::find(codes.begin(), codes.end(), error) != codes.end();
    });
}

} // namespace

void update(CameraStatus& status, const camera::CameraState& state) {
    using Heat = CameraStatus::Heat;
    status.batteryFraction = state.batteryFraction;
    status.isCharging = state.batteryState == "charging" || state.batteryState == "charged";
    status.heat = anyOf(state.errors, {"HIGH_TEMPERATURE"}) ? Heat::Hot
                  : anyOf(state.errors, {"HIGH_TEMPERATURE_WARNING", "BATTERY_HIGH_TEMPERATURE"})
                      ? Heat::Warm
                      : Heat::Normal;
    status.troubles.clear();
    for (const std::string& error : state.errors) {
        status.troubles << QString::fromStdString(camera::describeCameraError(error).sentence);
    }
}

CameraStatus askCamera(camera::OscClient& client, const std::stop_token& stop) {
    const camera::CameraInfo info = client.info(stop);
    constexpr int kApiLevel = 2;
    if (!info.hasApiLevel(kApiLevel)) {
        throw Error(ErrorKind::Unsupported,
                    "The camera speaks only level 1 of the Open Spherical Camera API; "
                    "Spherewalk needs level 2.");
    }
    CameraStatus status;
    status.model = QString::fromStdString(info.model);
    status.serialNumber = QString::fromStdString(info.serialNumber);
    status.firmware = QString::fromStdString(info.firmwareVersion);
    update(status, client.state(stop));
    if (const auto options = client.findOptions({"remainingPictures"}, stop)) {
        status.remainingPhotos = camera::wholeNumber(*options, "remainingPictures");
    }
    return status;
}

} // namespace spherewalk::ui
