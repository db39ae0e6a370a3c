// SPDX-License-Identifier: GPL-3.0-or-later
// What can befall the device.
#include "fault_plan.h"
#include "osc_device.h"

#include "spherewalk/base/error.h"

#include <algorithm>
#include <utility>

namespace spherewalk::practice {

void OscDevice::meet(const Fault& fault) {
    if (fault.kind == FaultKind::ExtraPhoto) {
        return takeExtraPhoto();
    }
    const std::scoped_lock lock(m_mutex);
    changed();
    switch (fault.kind) {
    case FaultKind::Battery:
        return loseCharge(fault.amount);
    case FaultKind::StorageFull:
        m_condition.isFull = true;
        break;
    case FaultKind::Hot:
        m_condition.isHot = true;
        break;
    case FaultKind::ResetSettings:
        m_settings.forgetExposure();
        break;
    case FaultKind::ClockUnset:
        m_condition.isClockUnset = true;
        m_clockOffset = std::chrono::system_clock::from_time_t(0) - m_clock.utc();
        break;
    case FaultKind::OtherSerial:
        ++m_condition.serialShift;
        break;
    case FaultKind::LevelOne:
        m_level = m_options.model == CameraModel::ThetaV ? 2 : 1;
        m_session.end();
        break;
    case FaultKind::Plugin:
        m_condition.hasPlugin = true;
        break;
    case FaultKind::RestartCounter:
        m_storage.restartNames();
        break;
    case FaultKind::UnknownValues:
        m_condition.saysUnknownThings = true;
        break;
    case FaultKind::Slow:
        m_condition.slowness = fault.amount;
        break;
    case FaultKind::NoMoreTrouble:
        m_condition = {};
        break;
    default:
        m_outage(fault);
    }
}

void OscDevice::loseCharge(double fraction) {
    m_condition.battery = std::max(0.0, m_condition.battery.value_or(1.0) - fraction);
    if (*m_condition.battery <= 0) {
        m_condition.battery = 1.0; // somebody changes it
        m_outage({FaultKind::Reboot, "", 0, 1, 0, 3});
    }
}

/// What happens to the camera at this point of an exposure. False if it is off now.
bool OscDevice::survives(std::string_view phase) {
    const std::vector<Fault> faults = m_faults.takeOfCamera(phase);
    for (const Fault& fault : faults) {
        meet(fault);
    }
    return std::none_of(faults.begin(), faults.end(),
                        [](const Fault& fault) { return fault.kind == FaultKind::Reboot; });
}

void OscDevice::takeExtraPhoto() {
    ExposureSettings settings;
    {
        const std::scoped_lock lock(m_mutex);
        settings = settingsNow(m_storage.takeShotNumber());
    }
    ExposedPhoto photo = m_exposer.expose(settings, m_stop.get_token());
    photo.truth.byButton = true;
    const std::scoped_lock lock(m_mutex);
    store(photo, settings);
}

void OscDevice::restart() {
    std::jthread worker;
    {
        const std::scoped_lock lock(m_mutex);
        m_countdown.request_stop();
        worker = std::move(m_worker);
    }
    worker = {}; // ends, and is waited for
    const std::scoped_lock lock(m_mutex);
    m_captures.clear();
    m_phase.reset();
    m_condition.hasPlugin = false;
    m_boot = m_clock.now();
    forget();
}

void OscDevice::fallAsleep() {
    const std::scoped_lock lock(m_mutex);
    forget();
}

/// What neither a sleep nor a restart leaves.
void OscDevice::forget() {
    m_settings.forgetExposure();
    m_level = m_options.model == CameraModel::ThetaV ? 2 : 1;
    m_session.end();
    m_preview.end();
    changed();
}

} // namespace spherewalk::practice
