// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/told.h"
#include "ui/tasks/background_worker.h"

#include "spherewalk/camera/endpoint.h"
#include "spherewalk/camera/osc_client.h"

#include <QObject>
#include <QTimer>

#include <chrono>
#include <stop_token>

namespace spherewalk::ui {

/// Asks a camera again and again how it is, so that the window sees when the camera is switched off. Threads:
/// the GUI thread; a thread of its own uses the network.
class CameraPulse : public QObject {
    Q_OBJECT

  public:
    static constexpr std::chrono::milliseconds kBeat{2000};

    explicit CameraPulse(QObject* parent = nullptr);
    ~CameraPulse() override;

    /// Begins to ask this camera.
    void begin(const camera::Endpoint& endpoint, const camera::CredentialsSource& login);
    /// Asks no more; what is still on its way is dropped.
    void end();

  signals:
    void answered(const spherewalk::camera::CameraState& state);
    /// The camera gave no answer; the sentence says why.
    void silent(const spherewalk::ui::Told& told);

  private:
    void beat();

    QTimer m_timer;
    std::stop_source m_stop;
    camera::Endpoint m_endpoint;
    camera::OscOptions m_options;
    int m_begun = 0;           ///< Number of the present camera; answers of earlier ones are dropped.
    BackgroundWorker m_worker; ///< The last member, as its results use the others.
};

} // namespace spherewalk::ui
