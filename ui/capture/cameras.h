// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/told.h"
#include "ui/tasks/background_worker.h"
#include "ui/tasks/task.h"

#include "spherewalk/camera/discovery.h"
#include "spherewalk/camera/endpoint.h"
#include "spherewalk/camera/osc_client.h"
#include "spherewalk/practice/practice_camera.h"

#include <QObject>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <QTimer>

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace spherewalk::ui {

/// The status of a camera, as the operator reads it.
struct CameraStatus {
    enum class Heat { Normal, Warm, Hot };

    QString model;
    QString serialNumber;
    QString firmware;
    std::optional<double> batteryFraction;
    bool isCharging = false;
    std::optional<std::int64_t> remainingPhotos;
    Heat heat = Heat::Normal;
    QStringList troubles; ///< One sentence for each error that the camera reports.
};

/// Asks the camera for its model and its status. Errors: those of the client; Unsupported for a camera that
/// speaks only level 1 of the Open Spherical Camera API.
CameraStatus askCamera(camera::OscClient& client, const std::stop_token& stop);

/// Takes battery, heat and errors from a state that the camera reported.
void update(CameraStatus& status, const camera::CameraState& state);

/// Finds cameras on the network, as `spherewalk-cli camera --find` does. Threads: the GUI thread; a task uses
/// the network.
class CameraFinder : public QObject {
    Q_OBJECT

  public:
    explicit CameraFinder(TaskList& tasks, QObject* parent = nullptr) : QObject(parent), m_tasks(tasks) {}

    void setOptions(const camera::FindOptions& options) { m_options = options; }

    /// Starts a search, unless one is on. changed() follows when it begins and when it ends.
    void find();

    bool isLooking() const { return m_task && m_task->isRunning(); }

    const std::vector<camera::FoundCamera>& cameras() const { return m_report.cameras; }

    /// Says what the search found or why it failed; empty before the first search.
    QString sentence() const { return m_told.text; }

    /// Returns sentence(), with the place of its cure.
    const Told& told() const { return m_told; }

    /// "RICOH THETA V 00123456, 192.168.1.1:80 (its own WiFi)".
    static QString words(const camera::FoundCamera& camera);

  signals:
    void changed();

  private:
    void found(camera::FindReport report);

    TaskList& m_tasks;
    QPointer<Task> m_task;
    camera::FindOptions m_options;
    camera::FindReport m_report;
    Told m_told;
};

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

/// The practice camera of this program, and the plan of its room.
struct PracticeSettings {
    int width = 2688;        ///< Pixels: half the width of a Theta V, so that drawing takes less time.
    double timeScale = 0.05; ///< Factor on the times that a Theta V takes.
    double stepM = 0.6;      ///< Step of the plan: a coarse one ends within a minute.
    bool keepsPhotos = true; ///< Keeps photos for the next run of the program, which can end open shots.
};

/// A practice camera in this program, which answers over HTTP at a port of its own. Threads: any.
class PracticeHost {
  public:
    /// Returns when the camera answers. Errors: those of practice::PracticeCamera.
    explicit PracticeHost(const PracticeSettings& settings);

    camera::Endpoint endpoint() const { return {"127.0.0.1", m_camera->port()}; }

    practice::PracticeCamera& camera() { return *m_camera; }

  private:
    std::unique_ptr<practice::PracticeCamera> m_camera;
};

} // namespace spherewalk::ui
