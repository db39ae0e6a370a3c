// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/preview/drive_pace.h"
#include "ui/preview/laid_object.h"
#include "ui/preview/robot.h"
#include "ui/session/survey_session.h"
#include "ui/tasks/background_worker.h"
#include "ui/tasks/task.h"

#include "spherewalk/base/folder.h"
#include "spherewalk/geometry/trajectory.h"

#include <QElapsedTimer>
#include <QTimer>

namespace spherewalk::ui {

/// The logic of the preview page: a robot is driven over a dataset, and the views of its camera follow.
/// Threads: the GUI thread. A background thread makes the views and drops outdated orders.
class PreviewPresenter : public SurveyPresenter {
    Q_OBJECT

  public:
    explicit PreviewPresenter(TaskList& tasks, QObject* parent = nullptr);
    ~PreviewPresenter() override;

    /// Takes the open survey. A dataset of openDataset() stays open.
    void setSession(SurveySession* session) override;

    /// Opens an exported dataset; message() says why if that fails.
    void openDataset(const QString& folder);
    /// Exports the open survey in a task and opens the dataset. Its temporary folder ends with the program.
    /// What takes long follows: the depth of each pixel comes with a second dataset, unless it is there
    /// already, is not wanted, or the survey has more than kMostDeepened photos.
    void makeDataset();
    static constexpr int kMostDeepened = 60;

    void setWantsDepth(bool isWanted) { m_wantsDepth = isWanted; }

    /// Whether the depth of the preview is being computed.
    bool isDeepening() const { return m_deepening && m_deepening->isRunning(); }

    bool canMakeDataset() const;

    /// Whether the task of makeDataset() runs.
    bool isPreparing() const { return m_preparing && m_preparing->isRunning(); }

    /// Returns the open dataset; null without one.
    const render::Dataset* dataset() const;

    /// Whether the open dataset is one of openDataset(), and not the open survey's.
    bool isForeign() const { return m_renderer && !m_folder; }

    /// Whether the survey has changed after makeDataset().
    bool isOutdated() const { return m_isOutdated; }

    const RobotPlace& robot() const { return m_robot; }

    void setRobot(const RobotPlace& robot);

    const CameraMount& mount() const { return m_mount; }

    void setMount(const CameraMount& mount);

    const CameraIntrinsics& camera() const { return m_camera; }

    void setCamera(const CameraIntrinsics& camera);

    /// Sets one side, or two for a comparison.
    void setSides(const std::vector<ViewSide>& sides);

    /// The object that stands in the views.
    ObjectStage& objects() { return m_objects; }

    const ObjectStage& objects() const { return m_objects; }

    /// Returns the place before the robot, and in its sight, where a new object is laid.
    Eigen::Vector3d beforeRobot() const;
    /// Stands the object on the surface that this place of the first view shows. pixel: of the robot's
    /// camera. message() says why that cannot be, and without an object nothing happens.
    void putObjectAt(const Eigen::Vector2d& pixel);

    /// Drives until another wish comes.
    void drive(const DriveWish& wish);

    bool isDriving() const { return m_ticking.isActive(); }

    /// Drives for this time at once, for tests and single steps.
    void driveFor(double seconds);

    bool isRecording() const { return m_isRecording; }

    /// Begins or ends a recording of the path. Beginning forgets the path before; ending writes keptPath().
    void setRecording(bool isRecording);
    /// Returns the file of the latest recording on this computer.
    static std::filesystem::path keptPath();

    const std::vector<TimedPose>& path() const { return m_path; }

    /// Puts the robot where it was at this pose of path(), and shows its own picture of there, if it has one.
    void goTo(std::size_t pose);

    /// Takes the pictures of the robot's own camera, and their poses as the path. file: a positions file, as
    /// the command compare reads it. message() says why if that fails.
    void openRobotPictures(const QString& file);

    /// Whether path() is that of the robot's own pictures.
    bool hasRobotPictures() const { return !m_ownPictures.empty(); }

    /// Whether views show by how many pixels each thing is displaced.
    void setShowsError(bool isShown);

    bool showsError() const { return m_showsError; }

    /// Writes path.tum, robot.yaml and the frames, as `walk` does, in a task.
    void saveFrames(const QString& folder);

    /// Returns one view for each side; empty without a dataset.
    const std::vector<MadeView>& views() const { return m_views; }

    /// Returns the views per second over the last second.
    double rate() const;

  signals:
    void datasetChanged();
    void robotChanged();
    void viewsChanged();
    void recordingChanged();

  private:
    void read() override;

    /// A dataset that was made for the preview, with its folder.
    struct Made {
        std::shared_ptr<TemporaryFolder> folder;
        std::shared_ptr<const render::Dataset> dataset;
        bool hasDepth = false;
    };

    Task* make(const QString& title, std::optional<render::SceneKind> scene,
               std::function<void(const Made&)> done);
    void deepen();
    void stopDeepening();
    void use(std::shared_ptr<const render::Dataset> dataset);
    void drawFrom(std::shared_ptr<const render::Dataset> dataset);
    void rebuild();
    void order();
    void show(std::vector<MadeView> views, double seconds);
    void tick();
    void record();
    void keepPath();
    void forgetPath();

    TaskList& m_tasks;
    std::shared_ptr<TemporaryFolder> m_folder; ///< Folder of makeDataset().
    bool m_isOutdated = false;
    QPointer<Task> m_preparing;
    QPointer<Task> m_deepening;
    bool m_wantsDepth = true;
    std::optional<render::Renderer> m_renderer;
    std::shared_ptr<ViewMaker> m_maker; ///< Used on the thread of the worker.
    Drive m_drive;
    RobotPlace m_robot;
    CameraMount m_mount;
    CameraIntrinsics m_camera;
    std::vector<ViewSide> m_sides{ViewSide{}};
    ObjectStage m_objects;
    DrivePace m_pace;
    bool m_showsError = false;
    DriveWish m_wish;
    QTimer m_ticking;
    QElapsedTimer m_clock;
    double m_lastTickS = 0;
    bool m_isRecording = false;
    double m_recordedFromS = 0;
    std::vector<TimedPose> m_path;
    std::vector<jobs::RobotPicture> m_ownPictures; ///< One for each pose of the path, or none at all.
    std::optional<std::size_t> m_ownShown;         ///< Where the robot stands in them.
    std::vector<MadeView> m_views;
    std::vector<double> m_shownS; ///< Times of the views of the last second.
    BackgroundWorker m_worker;    ///< The last member, as its results use the others.
};

} // namespace spherewalk::ui
