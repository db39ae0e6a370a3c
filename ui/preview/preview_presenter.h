// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/preview/drive.h"
#include "ui/preview/view_maker.h"
#include "ui/session/survey_presenter.h"
#include "ui/tasks/background_worker.h"
#include "ui/tasks/task_list.h"

#include "spherewalk/base/temporary_folder.h"
#include "spherewalk/geometry/trajectory.h"

#include <QElapsedTimer>
#include <QTimer>

namespace spherewalk::ui {

/// What the preview page does: a robot is driven over a dataset, and its camera's view is made as fast as the
/// machine can. Threads: the GUI thread; views are made in the background, the latest wish first.
class PreviewPresenter : public SurveyPresenter {
    Q_OBJECT

  public:
    explicit PreviewPresenter(TaskList& tasks, QObject* parent = nullptr);
    ~PreviewPresenter() override;

    /// A dataset that was opened by itself stays.
    void setSession(SurveySession* session) override;

    void openDataset(const QString& folder);
    /// Of the open survey, in a temporary folder that goes with the program.
    void makeDataset();
    bool canMakeDataset() const;

    /// Whether makeDataset() is at work.
    bool isPreparing() const { return m_preparing && m_preparing->isRunning(); }

    /// Null without a dataset.
    const render::Dataset* dataset() const;

    /// Whether the survey has changed since its dataset was made here.
    bool isOutdated() const { return m_isOutdated; }

    const RobotPlace& robot() const { return m_robot; }

    void setRobot(const RobotPlace& robot);

    const CameraMount& mount() const { return m_mount; }

    void setMount(const CameraMount& mount);

    const CameraIntrinsics& camera() const { return m_camera; }

    void setCamera(const CameraIntrinsics& camera);

    /// The first side, and a second one while two are compared.
    void setSides(const std::vector<ViewSide>& sides);

    const std::optional<jobs::Ball>& ball() const { return m_ball; }

    void setBall(const std::optional<jobs::Ball>& ball);

    /// Goes on while the wish is not none.
    void drive(const DriveWish& wish);

    bool isDriving() const { return m_ticking.isActive(); }

    /// So far from where the robot is now, as if driven; for tests and single steps.
    void driveFor(double seconds);

    bool isRecording() const { return m_isRecording; }

    /// Beginning forgets what was recorded before. However it ends, the path is in keptPath().
    void setRecording(bool isRecording);
    /// Of the latest recording on this computer.
    static std::filesystem::path keptPath();

    const std::vector<TimedPose>& path() const { return m_path; }

    /// Writes path.tum, robot.yaml and the frames, as `walk` does, in a task.
    void saveFrames(const QString& folder);

    /// One a side; empty without a dataset.
    const std::vector<MadeView>& views() const { return m_views; }

    /// Views a second, over the last second.
    double rate() const;

  signals:
    void datasetChanged();
    void robotChanged();
    void viewsChanged();
    void recordingChanged();

  private:
    void read() override;
    void use(std::shared_ptr<const render::Dataset> dataset);
    void rebuild();
    void order();
    void show(std::vector<MadeView> views);
    void tick();
    void record();
    void keepPath();

    TaskList& m_tasks;
    std::shared_ptr<TemporaryFolder> m_folder; ///< of the survey's dataset
    bool m_isOutdated = false;
    QPointer<Task> m_preparing;
    std::optional<render::Renderer> m_renderer;
    std::shared_ptr<ViewMaker> m_maker; ///< used on the worker's thread
    Drive m_drive;
    RobotPlace m_robot;
    CameraMount m_mount;
    CameraIntrinsics m_camera;
    std::vector<ViewSide> m_sides{ViewSide{}};
    std::optional<jobs::Ball> m_ball;
    DriveWish m_wish;
    QTimer m_ticking;
    QElapsedTimer m_clock;
    double m_lastTickS = 0;
    bool m_isRecording = false;
    double m_recordedFromS = 0;
    std::vector<TimedPose> m_path;
    std::vector<MadeView> m_views;
    std::vector<double> m_shownS; ///< when, during the last second
    BackgroundWorker m_worker;    ///< last: what it delivers uses the rest
};

} // namespace spherewalk::ui
