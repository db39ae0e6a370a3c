// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/preview/preview_presenter.h"

#include "ui/fields/camera_box.h"
#include "ui/look/core_words.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/jobs/walk.h"
#include "spherewalk/render/camera_info.h"

#include <QStandardPaths>

#include <algorithm>
#include <cmath>
#include <utility>

namespace spherewalk::ui {

namespace {

constexpr std::chrono::milliseconds kTick{15};
constexpr double kLongestTickS = 0.1; ///< Limits a tick, so that a robot does not jump after a pause.
constexpr double kRecordIntervalS = 0.1;
constexpr std::size_t kMostRecorded = 20'000;
constexpr double kOwnPictureS = 0.5; ///< How long the player shows each picture of the robot's.

using SharedDataset = std::shared_ptr<const render::Dataset>;

SharedDataset opened(const std::filesystem::path& folder, ProgressSink& progress,
                     const std::stop_token& stop) {
    return std::make_shared<const render::Dataset>(
        render::Dataset::open(folder, render::Verify::Sizes, progress, stop));
}

/// Returns the place of the photo that is nearest to the middle of all photos.
RobotPlace middleOf(const render::DatasetInfo& info) {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const render::DatasetPhoto& photo : info.photos) {
        middle += photo.roomFromPhoto.translation.head<2>() / static_cast<double>(info.photos.size());
    }
    const auto nearest =
        std::min_element(info.photos.begin(), info.photos.end(),
                         [&](const render::DatasetPhoto& a, const render::DatasetPhoto& b) {
                             const auto distance = [&](const render::DatasetPhoto& photo) {
                                 return (photo.roomFromPhoto.translation.head<2>() - middle).norm();
                             };
                             return distance(a) < distance(b);
                         });
    return {nearest->roomFromPhoto.translation.head<2>(), Radians(0)};
}

} // namespace

PreviewPresenter::PreviewPresenter(TaskList& tasks, QObject* parent)
    : SurveyPresenter(parent),
      m_tasks(tasks),
      m_camera(cameraPresets().at(kUsualCamera).intrinsics),
      m_objects(tasks) {
    connect(&m_objects, &ObjectStage::changed, this, [this] {
        emit robotChanged();
        order();
    });
    m_ticking.setInterval(kTick);
    m_ticking.setTimerType(Qt::PreciseTimer);
    connect(&m_ticking, &QTimer::timeout, this, &PreviewPresenter::tick);
    m_clock.start();
}

PreviewPresenter::~PreviewPresenter() {
    blockSignals(true); // the page is going, too
    setRecording(false);
}

void PreviewPresenter::setSession(SurveySession* session) {
    stopDeepening();
    if (m_folder) { // the dataset was the closed survey's
        m_folder.reset();
        use(nullptr);
    }
    SurveyPresenter::setSession(session);
}

void PreviewPresenter::read() {
    m_isOutdated = m_folder != nullptr;
    emit datasetChanged();
}

bool PreviewPresenter::canMakeDataset() const {
    return session() != nullptr && !isPreparing() && session()->state().counts.stationsWithPhoto > 0;
}

void PreviewPresenter::openDataset(const QString& folder) {
    m_tasks.start(
        tr("Opening %1").arg(folder), this,
        [path = std::filesystem::path(folder.toStdString())](
            ProgressSink& progress, const std::stop_token& stop) { return opened(path, progress, stop); },
        [this](SharedDataset dataset) {
            stopDeepening();
            m_folder.reset();
            m_isOutdated = false;
            use(std::move(dataset));
        });
}

void PreviewPresenter::makeDataset() {
    if (!canMakeDataset()) {
        emit message({tr("There is no photo to preview yet; capture or import some first."), Cure::Capture});
        return;
    }

    stopDeepening();
    m_preparing = make(
        tr("Preparing the preview of %1").arg(session()->name()), std::nullopt, [this](const Made& made) {
            m_folder = made.folder;
            m_isOutdated = false;
            use(made.dataset);
            if (m_wantsDepth && !made.hasDepth && made.dataset->info().photos.size() <= kMostDeepened) {
                deepen();
            }
        });
    connect(m_preparing, &Task::ended, this, &PreviewPresenter::datasetChanged);
    emit datasetChanged();
}

/// Computes the depth, and goes on with it where the robot is by then.
void PreviewPresenter::deepen() {
    m_deepening = make(tr("Depth for the preview of %1").arg(session()->name()), render::SceneKind::Depth,
                       [this](const Made& made) {
                           if (!m_deepening) {
                               return; // another dataset is open meanwhile
                           }
                           m_folder = made.folder;
                           drawFrom(made.dataset);
                       });
    connect(m_deepening, &Task::ended, this, &PreviewPresenter::datasetChanged);
    emit datasetChanged();
}

void PreviewPresenter::stopDeepening() {
    if (m_deepening) {
        m_deepening->stop();
        m_deepening.clear();
    }
}

/// Exports the survey to a temporary folder. scene: nothing means the best that takes no time.
Task* PreviewPresenter::make(const QString& title, std::optional<render::SceneKind> scene,
                             std::function<void(const Made&)> done) {
    return m_tasks.start(
        title, this,
        [survey = session()->path(), scene](ProgressSink& progress, const std::stop_token& stop) {
            const auto store = store::SurveyStore::open(survey, store::Access::Read);
            auto folder = std::make_shared<TemporaryFolder>("spherewalk-preview");
            jobs::ExportOptions options;
            options.scene = scene.value_or(jobs::knownScene(store, options.depth));
            jobs::exportDataset(store, folder->path() / "dataset", options, progress, stop);
            return Made{folder, opened(folder->path() / "dataset", noProgress(), stop),
                        options.scene == render::SceneKind::Depth};
        },
        std::move(done));
}

const render::Dataset* PreviewPresenter::dataset() const {
    return m_renderer ? &m_renderer->dataset() : nullptr;
}

void PreviewPresenter::use(SharedDataset dataset) {
    setRecording(false);
    forgetPath();
    if (dataset) {
        const render::DatasetInfo& info = dataset->info();
        m_drive = Drive(info.outline, info.obstacles);
        m_robot = middleOf(info);
        m_mount.heightM = info.photos.front().roomFromPhoto.translation.z();
    }
    drawFrom(std::move(dataset));
}

/// Makes views of this dataset from now on. The robot and its path stay.
void PreviewPresenter::drawFrom(SharedDataset dataset) {
    m_worker.dropWaiting();
    m_maker.reset();
    m_renderer.reset();
    m_views.clear();
    if (dataset) {
        m_renderer.emplace(std::move(dataset),
                           render::RendererOptions{512ULL << 20, render::VerifyPhotos::InBackground});
    }
    emit datasetChanged();
    emit robotChanged();
    emit viewsChanged();
    rebuild();
}

/// Makes a new maker, as each camera has its own streams.
void PreviewPresenter::rebuild() {
    m_pace.forget();
    if (m_renderer) {
        m_maker = std::make_shared<ViewMaker>(*m_renderer, m_camera);
        order();
    }
}

void PreviewPresenter::setRobot(const RobotPlace& robot) {
    m_robot = robot;
    m_ownShown.reset();
    record();
    emit robotChanged();
    order();
}

void PreviewPresenter::setMount(const CameraMount& mount) {
    m_mount = mount;
    m_ownShown.reset();
    emit robotChanged();
    order();
}

void PreviewPresenter::setCamera(const CameraIntrinsics& camera) {
    if (camera == m_camera) {
        return;
    }
    m_camera = camera;
    emit robotChanged();
    rebuild();
}

void PreviewPresenter::setSides(const std::vector<ViewSide>& sides) {
    m_sides = sides;
    m_pace.forget();
    order();
}

Eigen::Vector3d PreviewPresenter::beforeRobot() const {
    constexpr double kDistanceM = 1.2;
    const Eigen::Vector2d place =
        m_robot.pInRoom + kDistanceM * Eigen::Vector2d(cos(m_robot.yaw), sin(m_robot.yaw));
    return {place.x(), place.y(), std::max(0.0, m_mount.heightM - LaidObject().sizeM)};
}

void PreviewPresenter::putObjectAt(const Eigen::Vector2d& pixel) {
    if (!m_renderer || !m_objects.object()) {
        return;
    }
    const CameraModel camera(m_sides.front().camera.value_or(m_camera));
    const Rigid3 pose =
        m_ownShown ? m_ownPictures.at(*m_ownShown).roomFromCamera : roomFromOptical(m_robot, m_mount);
    m_worker.post(QStringLiteral("surface"),
                  [this, renderer = *m_renderer, camera, pose, pixel]() -> BackgroundWorker::Deliver {
                      try {
                          render::ViewOptions options; // the best scene model, whichever is shown
                          options.wantsDepth = true;
                          const render::View view = renderer.render(camera, pose, options);
                          const auto spot =
                              spotAt(view.depth, camera, pose, pixel.array().round().matrix().cast<int>());
                          return [this, spot] {
                              spot ? m_objects.standOn(*spot)
                                   : emit message(
                                         tr("How far away that is is not known; click at another place."));
                          };
                      } catch (const Error& error) {
                          return [this, told = coreTold(error.sentence())] { emit message(told); };
                      }
                  });
}

void PreviewPresenter::setShowsError(bool isShown) {
    m_showsError = isShown;
    order();
}

void PreviewPresenter::goTo(std::size_t pose) {
    const Rigid3& there = m_path.at(pose).roomFromCamera;
    const Eigen::Vector3d ahead = there.rotation * Eigen::Vector3d::UnitZ();
    m_robot = {there.translation.head<2>(), Radians(std::atan2(ahead.y(), ahead.x()))};
    m_ownShown = hasRobotPictures() ? std::optional(pose) : std::nullopt;
    emit robotChanged();
    order();
}

void PreviewPresenter::openRobotPictures(const QString& file) {
    try {
        std::vector<jobs::RobotPicture> pictures = jobs::readRobotPictures(file.toStdString());
        setRecording(false);
        forgetPath();
        for (const jobs::RobotPicture& picture : pictures) {
            m_path.push_back({kOwnPictureS * static_cast<double>(m_path.size()), picture.roomFromCamera});
        }
        m_ownPictures = std::move(pictures);
    } catch (const Error& error) {
        emit message(coreTold(error.sentence()));
        return;
    }
    emit recordingChanged();
    if (!m_path.empty()) {
        goTo(0);
    }
}

void PreviewPresenter::forgetPath() {
    m_path.clear();
    m_ownPictures.clear();
    m_ownShown.reset();
}

void PreviewPresenter::order() {
    if (!m_maker) {
        return;
    }
    ViewOrder wish{roomFromOptical(m_robot, m_mount), 0.001 * static_cast<double>(m_clock.elapsed()), m_sides,
                   m_objects.object(), m_showsError};
    wish.share = m_wish.isNone() ? 1 : m_pace.share();
    if (m_ownShown) {
        wish.own = m_ownPictures.at(*m_ownShown);
        wish.roomFromCamera = wish.own->roomFromCamera; // with its height and tilt
    }
    m_worker.post(QStringLiteral("view"), [this, maker = m_maker, wish]() -> BackgroundWorker::Deliver {
        try {
            const Clock::TimePoint begun = systemClock().now();
            std::vector<MadeView> views = maker->make(wish);
            const std::chrono::duration<double> time = systemClock().now() - begun;
            return [this, maker, views = std::move(views), time] {
                if (maker == m_maker) { // otherwise the camera is another one meanwhile
                    show(views, time.count());
                }
            };
        } catch (const Error& error) {
            return [this, told = coreTold(error.sentence())] { emit message(told); };
        }
    });
}

void PreviewPresenter::show(std::vector<MadeView> views, double seconds) {
    m_views = std::move(views);
    if (!m_wish.isNone() && !m_views.empty()) {
        m_pace.took(m_views.front().share, seconds);
    }
    const double now = 0.001 * static_cast<double>(m_clock.elapsed());
    m_shownS.push_back(now);
    std::erase_if(m_shownS, [now](double shown) { return shown < now - 1; });
    const bool isLate = std::any_of(m_views.begin(), m_views.end(), [](const MadeView& view) {
        return view.report.origin != render::ViewOrigin::Photo;
    });
    emit viewsChanged();
    if (isLate && m_wish.isNone()) { // what was late is decoded meanwhile
        QTimer::singleShot(kTick, this, &PreviewPresenter::order);
    }
}

double PreviewPresenter::rate() const {
    return static_cast<double>(m_shownS.size());
}

void PreviewPresenter::drive(const DriveWish& wish) {
    m_wish = wish;
    if (wish.isNone()) {
        if (m_ticking.isActive()) {
            m_ticking.stop();
            order(); // in full size
        }
    } else if (!m_ticking.isActive()) {
        m_lastTickS = 0.001 * static_cast<double>(m_clock.elapsed());
        m_ticking.start();
    }
}

void PreviewPresenter::tick() {
    const double now = 0.001 * static_cast<double>(m_clock.elapsed());
    const double seconds = std::min(kLongestTickS, now - std::exchange(m_lastTickS, now));
    driveFor(seconds);
}

void PreviewPresenter::driveFor(double seconds) {
    setRobot(m_drive.after(m_robot, m_wish, seconds));
}

void PreviewPresenter::setRecording(bool isRecording) {
    const bool wasRecording = std::exchange(m_isRecording, isRecording && m_renderer.has_value());
    if (wasRecording && !m_isRecording) {
        keepPath();
    } else if (m_isRecording) {
        forgetPath();
        m_recordedFromS = 0.001 * static_cast<double>(m_clock.elapsed());
        record();
    }
    emit recordingChanged();
}

void PreviewPresenter::record() {
    if (!m_isRecording) {
        return;
    }
    const double time = 0.001 * static_cast<double>(m_clock.elapsed()) - m_recordedFromS;
    const bool isDue = m_path.empty() || time >= m_path.back().timeS + kRecordIntervalS;
    if (isDue && m_path.size() < kMostRecorded) {
        m_path.push_back({time, roomFromOptical(m_robot, m_mount)});
        emit recordingChanged();
    }
}

std::filesystem::path PreviewPresenter::keptPath() {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation);
    return std::filesystem::path(folder.toStdString()) / "recorded path.tum";
}

void PreviewPresenter::keepPath() {
    try {
        std::error_code none; // writing says best what is wrong with the folder
        std::filesystem::create_directories(keptPath().parent_path(), none);
        writeFile(keptPath(), bytesOf(tumText(m_path)));
    } catch (const Error& error) {
        emit message(coreTold(error.sentence()));
    }
}

void PreviewPresenter::saveFrames(const QString& folder) {
    if (!m_renderer || m_path.empty()) {
        emit message(tr("There is no path to save; record one first."));
        return;
    }
    jobs::WalkOptions options;
    options.view.scene = m_sides.front().scene;
    options.view.sampling = m_sides.front().sampling;
    if (const auto& object = m_objects.object(); object && object->shape == LaidObject::Shape::Ball) {
        options.balls = {object->ball()};
    } else if (object) {
        options.meshes = {object->placed()};
    }
    m_tasks.start(
        tr("Saving %n frame(s)", nullptr, static_cast<int>(m_path.size())), this,
        [path = std::filesystem::path(folder.toStdString()), renderer = *m_renderer, camera = m_camera,
         poses = m_path, options, kept = m_folder](ProgressSink& progress, const std::stop_token& stop) {
            std::error_code none; // writing says best what is wrong with the folder
            std::filesystem::create_directories(path, none);
            // First: whoever stops the frames can have them made later, by the command walk.
            writeFile(path / "path.tum", bytesOf(tumText(poses)));
            writeFile(path / "robot.yaml", bytesOf(render::cameraInfoYaml(camera, "robot")));
            return jobs::walk(renderer, CameraModel(camera), poses, options, path, progress, stop);
        },
        [this, folder](const jobs::WalkReport& report) {
            emit message(
                tr("Wrote %n frame(s) to %1.", nullptr, static_cast<int>(report.frames)).arg(folder));
        });
}

} // namespace spherewalk::ui
