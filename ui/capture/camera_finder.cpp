// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/camera_finder.h"

#include <utility>

namespace spherewalk::ui {

void CameraFinder::find() {
    if (isLooking()) {
        return;
    }
    m_report = {};
    m_sentence = tr("Looking for cameras...");
    m_task = m_tasks.start(
        tr("Looking for cameras"), this,
        [options = m_options](ProgressSink& /*progress*/, const std::stop_token& stop) {
            return camera::findCameras(options, stop);
        },
        [this](camera::FindReport report) { found(std::move(report)); });
    connect(m_task, &Task::ended, this, [this, task = m_task.data()] {
        if (task->state() != Task::State::Done) {
            m_sentence = task->sentence();
        }
        emit changed();
    });
    emit changed();
}

void CameraFinder::found(camera::FindReport report) {
    m_report = std::move(report);
    m_sentence =
        m_report.cameras.empty()
            ? tr("No camera answers. Switch it on, connect this computer to its WiFi, and look again.")
            : tr("%n camera(s) found", nullptr, static_cast<int>(m_report.cameras.size()));
    if (m_report.cameras.empty() && !m_report.note.empty()) {
        m_sentence += " " + QString::fromStdString(m_report.note);
    }
}

QString CameraFinder::words(const camera::FoundCamera& camera) {
    return QString("%1 %2, %3 (%4)")
        .arg(QString::fromStdString(camera.info.model), QString::fromStdString(camera.info.serialNumber),
             QString::fromStdString(camera.place.endpoint.name()), QString::fromStdString(camera.place.why));
}

} // namespace spherewalk::ui
