// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/cameras.h"

#include "ui/look/core_words.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/error.h"

#include <QDir>
#include <QStandardPaths>

#include <algorithm>
#include <utility>

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

void CameraFinder::find() {
    if (isLooking()) {
        return;
    }
    m_report = {};
    m_told = tr("Looking for cameras...");
    m_task = m_tasks.start(
        tr("Looking for cameras"), this,
        [options = m_options](ProgressSink& /*progress*/, const std::stop_token& stop) {
            return camera::findCameras(options, stop);
        },
        [this](camera::FindReport report) { found(std::move(report)); });
    connect(m_task, &Task::ended, this, [this, task = m_task.data()] {
        if (task->state() != Task::State::Done) {
            m_told = task->told();
        }
        emit changed();
    });
    emit changed();
}

void CameraFinder::found(camera::FindReport report) {
    m_report = std::move(report);
    m_told =
        m_report.cameras.empty()
            ? Told(tr("No camera answers. Switch it on, connect this computer to its WiFi, and look again."),
                   Cure::Connecting)
            : Told(tr("%n camera(s) found", nullptr, static_cast<int>(m_report.cameras.size())));
    if (m_report.cameras.empty() && !m_report.note.empty()) {
        m_told.text += " " + QString::fromStdString(m_report.note);
    }
}

QString CameraFinder::words(const camera::FoundCamera& camera) {
    return QString("%1 %2, %3 (%4)")
        .arg(QString::fromStdString(camera.info.model), QString::fromStdString(camera.info.serialNumber),
             QString::fromStdString(camera.place.endpoint.name()), QString::fromStdString(camera.place.why));
}

CameraPulse::CameraPulse(QObject* parent) : QObject(parent) {
    m_timer.setInterval(kBeat);
    connect(&m_timer, &QTimer::timeout, this, &CameraPulse::beat);
}

CameraPulse::~CameraPulse() {
    m_stop.request_stop();
}

void CameraPulse::begin(const camera::Endpoint& endpoint, const camera::CredentialsSource& login) {
    end();
    m_endpoint = endpoint;
    m_options.attempts = 1; // the next beat tries again
    m_options.http.credentials = login;
    m_options.http.connectTimeout = kBeat;
    m_options.http.requestTimeout = 2 * kBeat;
    m_timer.start();
}

void CameraPulse::end() {
    ++m_begun;
    m_timer.stop();
    m_stop.request_stop();
    m_stop = std::stop_source();
    m_worker.dropWaiting();
}

void CameraPulse::beat() {
    m_worker.post(QStringLiteral("state"),
                  [this, number = m_begun, endpoint = m_endpoint, options = m_options,
                   stop = m_stop.get_token()]() -> BackgroundWorker::Deliver {
                      try {
                          camera::OscClient client(endpoint, options, systemClock());
                          return [this, number, state = client.state(stop)] {
                              if (number == m_begun) {
                                  emit answered(state);
                              }
                          };
                      } catch (const Error& error) {
                          return [this, number, told = coreTold(error.sentence())] {
                              if (number == m_begun) {
                                  emit silent(told);
                              }
                          };
                      }
                  });
}

PracticeHost::PracticeHost(const PracticeSettings& settings) {
    practice::PracticeCameraOptions options;
    options.width = settings.width;
    options.timeScale = settings.timeScale;
    if (settings.keepsPhotos) {
        const QString folder =
            QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/practice-camera";
        QDir().mkpath(folder);
        options.storageFolder = folder.toStdString();
    }
    m_camera = std::make_unique<practice::PracticeCamera>(options);
    m_camera->start();
}

} // namespace spherewalk::ui
