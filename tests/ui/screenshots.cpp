// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of all pages of the window, to be looked at: DIR SUFFIX light|dark [language [WIDTHxHEIGHT
// [NAME]]]. NAME: the one picture that is made. Those of the guide, small: DIR "" guide. With
// QT_SCALE_FACTOR=2 they are those of a screen of twice the density.
#include "temporary_folder.h"
#include "ui/align/align_mode.h"
#include "ui/capture/camera_login.h"
#include "ui/capture/capture_mode.h"
#include "ui/export/export_mode.h"
#include "ui/fields/camera_box.h"
#include "ui/panorama/panorama_presenter.h"
#include "ui/panorama/panorama_view.h"
#include "ui/plan/plan_mode.h"
#include "ui/preview/preview_mode.h"
#include "ui/preview/preview_presenter.h"
#include "ui/remote/phone_remote.h"
#include "ui/remote/remote_form.h"
#include "ui/review/coverage_view.h"
#include "ui/review/region_bar.h"
#include "ui/review/review_mode.h"
#include "ui/shell/application.h"
#include "ui/shell/help_window.h"
#include "ui/shell/main_window.h"

#include "spherewalk/base/file.h"
#include "spherewalk/jobs/demo.h"
#include "spherewalk/practice/fault.h"
#include "spherewalk/render/camera_info.h"

#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QListView>
#include <QProcess>
#include <QPushButton>
#include <QScrollArea>
#include <QTableView>
#include <QToolButton>

#include <cstdio>
#include <functional>

using namespace spherewalk;
using namespace spherewalk::ui;

namespace {

constexpr std::size_t kPhotos = 12;
constexpr PracticeSettings kPractice{.width = 2048, .timeScale = 0.001, .keepsPhotos = false};

/// Which pictures the guide shows.
const QStringList kGuide{"start-first",   "plan",  "capture",       "capture-by-hand",
                         "review-slider", "align", "preview-split", "export"};

/// As documents can carry it: fewer pixels, and fewer colours, which are packed better.
QImage small(const QImage& picture) {
    constexpr int kWidth = 960;
    return picture.scaledToWidth(kWidth, Qt::SmoothTransformation).convertToFormat(QImage::Format_RGB16);
}

/// Runs the event loop until the condition holds. Errors: Timeout after two minutes.
void waitUntil(const std::function<bool()>& holds) {
    QElapsedTimer time;
    time.start();
    while (!holds()) {
        if (time.elapsed() > 120'000) {
            throw Error(ErrorKind::Timeout, "The window did not come to what was to be pictured.");
        }
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 20);
    }
}

/// Runs the event loop until the widget has looked the same for a second: pictures are coarse first.
void waitUntilSettled(QWidget& widget) {
    constexpr int kStillMs = 1000;
    QImage last;
    QElapsedTimer still;
    waitUntil([&] {
        const QImage now = widget.grab().toImage();
        if (now != last) {
            last = now;
            still.start();
        }
        return still.elapsed() > kStillMs;
    });
}

/// The window, led from page to page.
class Album {
  public:
    /// only: the names of the pictures; empty for all.
    Album(QString folder, QString suffix, const QString& look, const QSize& size, QStringList only)
        : m_folder(std::move(folder)),
          m_suffix(std::move(suffix)),
          m_isForGuide(look == "guide"),
          m_isDark(look == "dark"),
          m_only(m_isForGuide ? kGuide : std::move(only)) {
        m_window.resize(size);
        m_window.show();
    }

    void shootAll(const QString& place) {
        shoot("start-first");
        shootPlan(place);
        shootTour();
        shootWalk(place);
        jobs::newPracticeSurvey((place + "/practice room.spherewalk").toStdString(), 0.8);
        m_window.openSurvey(place + "/practice room.spherewalk");
        shootCapture();
        shootReview();
        shootAlign();
        shootRegions();
        shootSlider();
        shootPreview();
        shootExport();
        shootMeasured(place);
        m_window.showMode(nullptr);
        shoot("start");
        open<PlanMode>();
        shoot("plan-fixed");
        shootGridStudy(place);
        shootEnd();
    }

  private:
    void shoot(const QString& name) { shoot(name, m_window); }

    void shoot(const QString& name, QWidget& window) {
        if (!m_only.isEmpty() && !m_only.contains(name)) {
            return;
        }
        QElapsedTimer time;
        time.start();
        waitUntil([&] { return time.elapsed() > 300; }); // what is late comes: layouts, thumbnails
        const QString file = m_folder + "/" + name + m_suffix + ".png";
        const QImage picture = window.grab().toImage();
        if (!(m_isForGuide ? small(picture) : picture).save(file)) {
            throw Error(ErrorKind::Io, "Could not write " + file.toStdString() + ".");
        }
        std::printf("%s\n", qPrintable(file));
    }

    template <class Wanted>
    Wanted& open() {
        for (Mode* mode : m_window.modes()) {
            if (auto* found = qobject_cast<Wanted*>(mode)) {
                m_window.showMode(found);
                return *found;
            }
        }
        throw Error(ErrorKind::NotFound, "The window has no such page.");
    }

    void waitForTasks() {
        waitUntil([&] { return !m_window.tasks().hasRunning(); });
    }

    /// Photos by hand: the plan shows where they were taken so far.
    void shootWalk(const QString& place) {
        const QString folder = place + "/walk.spherewalk";
        store::SurveyStore::create(folder.toStdString(), "walk", survey::unknownRoom(),
                                   {.stepM = survey::kStepByHandM}, {});
        m_window.openSurvey(folder);
        CaptureDesk& desk = open<CaptureMode>().desk();
        desk.setPracticeSettings(kPractice);
        desk.connectToPractice();
        waitUntil([&] { return desk.state() == CaptureDesk::State::Ready; });
        desk.setAutomatic(false); // as the tour has left it
        desk.trigger();
        for (std::size_t photos = 1; photos <= kPhotos; ++photos) {
            waitUntil([&] { return desk.state() == CaptureDesk::State::AtStation; });
            desk.trigger();
            waitUntil([&] { return desk.places() && desk.places()->placed.size() == photos; });
        }
        waitUntil([&] { return desk.state() == CaptureDesk::State::AtStation; });
        shoot("capture-by-hand");
        desk.end();
        waitUntil([&] { return !desk.isRunning(); });
        shoot("capture-by-hand-done");
    }

    void shootPlan(const QString& place) {
        auto& plan = open<PlanMode>();
        PlanEditor& editor = plan.editor();
        editor.setOutline({{0, 0}, {6.2, 0}, {6.2, 3}, {3.6, 3}, {3.6, 5.1}, {0, 5.1}});
        editor.addObstacle({{1.2, 1.5}, {2.4, 1.5}, {2.4, 2.3}, {1.2, 2.3}});
        editor.addObstacle({{5.2, 0}, {6.2, 0}, {6.2, 0.6}, {5.2, 0.6}});
        waitUntil([&] { return editor.isSettled(); });
        plan.view().fitRoom();
        editor.select({PlanPart::kOutline, 3});
        shoot("plan-new");
        plan.storage().create(place + "/office.spherewalk");
        waitUntil([&] { return editor.isSettled(); });
        plan.view().fitRoom();
        shoot("plan");
        editor.nameRoom({1.8, 4.2}, "hall", std::nullopt);
        editor.nameRoom({4.9, 1.5}, "kitchen", std::nullopt);
        waitUntil([&] { return editor.isSettled(); });
        shoot("plan-names");
        shootRails(plan);
        m_window.closeSurvey();
    }

    /// Two rails by hand, one of them locked, and the rest around them.
    void shootRails(PlanMode& plan) {
        PlanEditor& editor = plan.editor();
        plan.view().setTool(PlanEditorView::Tool::Rails);
        editor.changeRails("lay", [](std::vector<survey::RailPlacement>& rails) {
            rails = {{{2.8, 0.6}, Radians(0.6), 5, 0.4, true}};
        });
        editor.layOthersAnew();
        waitUntil([&] { return editor.isSettled(); });
        editor.addRail({{0.7, 4.5}, Radians(-0.2), 6, 0.4});
        waitUntil([&] { return editor.isSettled(); });
        editor.select({.rail = 0, .stop = 2});
        shoot("plan-rails");
    }

    /// The first step of the tour.
    void shootTour() {
        m_window.runTour();
        shoot("tour");
        m_window.closeSurvey();
    }

    void shootCapture() {
        using State = CaptureDesk::State;
        CaptureDesk& desk = open<CaptureMode>().desk();
        shoot("capture-no-camera");
        shootLogin(desk);
        desk.setPracticeSettings(kPractice);
        desk.connectToPractice();
        waitUntil([&] { return desk.state() == State::Ready; });
        desk.trigger();
        for (std::size_t photos = 0; photos < kPhotos; ++photos) {
            waitUntil([&] { return desk.state() == State::AtStation; });
            desk.trigger();
            waitUntil([&] { return desk.state() != State::Shooting; });
        }
        waitUntil([&] { return desk.state() == State::AtStation; });
        shoot("capture");
        shootRemote();
        open<CaptureMode>().setWholeScreen(true);
        shoot("capture-cart");
        desk.setHideSeconds(5);
        desk.trigger();
        shoot("capture-cart-hide");
        open<CaptureMode>().setWholeScreen(false);
        shoot("capture-hide");
        desk.trigger();
        desk.setHideSeconds(0);
        desk.practice()->camera().arm(
            {practice::FaultKind::ServiceUnavailable, "camera.takePicture", 0, 50, 0});
        desk.trigger();
        waitUntil([&] { return desk.state() == State::AskAgain; });
        shoot("capture-failed");
        desk.stop();
        waitUntil([&] { return desk.state() == State::Ready; });
    }

    /// The form for a phone that is to be the remote.
    void shootRemote() {
        emit open<CaptureMode>().remoteWanted();
        auto* form = m_window.findChild<RemoteForm*>();
        shoot("capture-remote-off", *form);
        auto* remote = m_window.findChild<PhoneRemote*>();
        remote->turnOn(QHostAddress(QHostAddress::LocalHost));
        shoot("capture-remote", *form);
        shootPhone(*remote);
        remote->turnOff();
        form->close();
    }

    /// The page on a phone, which a browser of this computer stands for. Without one there are no such
    /// pictures.
    void shootPhone(const PhoneRemote& remote) {
        if (!m_only.isEmpty()) {
            return;
        }
        constexpr int kNoBrowser = 77;
        QProcess phone;
        phone.setProcessChannelMode(QProcess::ForwardedChannels);
        phone.start(SPHEREWALK_PHONE_PICTURES, {remote.url(), QString::fromStdString(remote.pairing().code()),
                                                m_folder, m_suffix, m_isDark ? "dark" : "light"});
        waitUntil([&] { return phone.state() == QProcess::NotRunning; });
        if (phone.exitCode() != 0 && phone.exitCode() != kNoBrowser) {
            throw Error(ErrorKind::Internal, "The page on the phone complains.");
        }
    }

    /// A camera in client mode asks for a password.
    void shootLogin(CaptureDesk& desk) {
        practice::PracticeCameraOptions options;
        options.digestUser = "THETAYL00123456";
        options.digestPassword = "00123456";
        practice::PracticeCamera camera(options);
        camera.start();
        desk.connectTo(QString("127.0.0.1:%1").arg(camera.port()));
        LoginForm* form = nullptr;
        waitUntil([&] { return (form = m_window.findChild<LoginForm*>()) != nullptr && form->isVisible(); });
        shoot("capture-login", *form);
        form->reject();
        waitUntil([&] { return desk.state() == CaptureDesk::State::NoCamera; });
    }

    void shootReview() {
        open<ReviewMode>();
        shoot("review");
    }

    /// A photo with a region of each kind, the tool that marks them, and what exports have of them.
    void shootRegions() {
        auto& review = open<ReviewMode>();
        auto& view = *review.findChild<PanoramaView*>();
        SurveySession& session = *m_window.session();
        const std::int64_t photo = session.store().chosenPhotos().at(0).id;
        session.selection()->setCurrent(session.store().chosenPhotos().at(0).station);
        session.write(SurveySession::Photos, [&](store::SurveyStore& store) {
            store.setFoundRegions(photo, {{Degrees(18), Degrees(4), Degrees(14), Degrees(16)}}, 1);
            store.markRegion(photo, {Degrees(-14), Degrees(-8), Degrees(26), Degrees(14)});
        });
        while (view.presenter().selectNextRegion(1)) { // to the last one, beside which the first is in view
        }
        waitUntil([&] { return view.presenter().remark().isEmpty(); });
        shoot("review-regions");
        review.findChild<QToolButton*>("hideRegion")->click();
        shoot("review-hiding");
        view.presenter().regions().setMarking(false);
        view.presenter().regions().select(std::nullopt);
        review.findChild<QCheckBox*>("asExported")->setChecked(true);
        waitUntil([&] { return view.presenter().remark().isEmpty(); });
        shoot("review-exported");
        review.findChild<QCheckBox*>("asExported")->setChecked(false);
    }

    /// Of aligned photos: only some others can be compared.
    void shootSlider() {
        auto& review = open<ReviewMode>();
        auto* list = review.findChild<QListView*>("stations");
        constexpr int kWithoutRegions = 4;
        list->setCurrentIndex(list->model()->index(kWithoutRegions, 0));
        review.findChild<QComboBox*>("comparison")->setCurrentIndex(static_cast<int>(Comparison::Slider));
        waitUntilSettled(*review.findChild<PanoramaView*>());
        shoot("review-slider");
        review.findChild<QComboBox*>("comparison")->setCurrentIndex(static_cast<int>(Comparison::Off));
        review.findChild<StoryLabel*>()->setWanted(true);
        shoot("review-story");
        review.findChild<StoryLabel*>()->setWanted(false);
        review.findChild<QToolButton*>("contactSheet")->click();
        shoot("review-sheet");
        review.findChild<QToolButton*>("contactSheet")->click();
    }

    void shootAlign() {
        auto& align = open<AlignMode>();
        auto* effort = align.findChild<QComboBox*>("effort");
        effort->setCurrentIndex(effort->findData(static_cast<int>(align::Effort::Draft)));
        align.findChild<QPushButton*>("run")->click();
        shoot("align-running");
        waitForTasks();
        align.findChild<QTableView*>("photos")->selectRow(2);
        shoot("align");
    }

    void shootPreview() {
        auto& preview = open<PreviewMode>();
        PreviewPresenter& presenter = preview.presenter();
        shoot("preview-none");
        preview.findChild<QCheckBox*>("withDepth")->setChecked(false); // pictures at once
        presenter.makeDataset();
        waitUntil([&] { return !presenter.views().empty(); });
        presenter.objects().lay(LaidObject::Shape::Box, presenter.beforeRobot());
        shoot("preview");
        presenter.objects().lay(LaidObject::Shape::Ball, presenter.beforeRobot());
        preview.findChild<QCheckBox*>("split")->setChecked(true);
        presenter.setRecording(true);
        presenter.drive({.forward = 1, .turnLeft = 0.3});
        waitUntil([&] { return presenter.path().size() > 20; });
        presenter.drive({});
        shoot("preview-split");
        presenter.setRecording(false);
    }

    void shootExport() {
        auto& exporting = open<ExportMode>();
        exporting.findChild<QCheckBox*>("opens")->setChecked(false);
        exporting.findChild<QComboBox*>("scene")->setCurrentIndex(0); // measuring takes minutes
        waitForTasks();
        shoot("export");
        exporting.findChild<QPushButton*>("export")->click();
        waitForTasks();
        shoot("export-done");
    }

    /// A small camera, so that measuring takes seconds.
    static void chooseCamera(CameraBox& box, const QString& place) {
        const QString file = place + "/small.yaml";
        const auto camera = CameraIntrinsics::pinhole(240, 180, 1);
        writeFile(file.toStdString(), bytesOf(render::cameraInfoYaml(camera, "small")));
        box.readCamera(file);
    }

    void shootMeasured(const QString& place) {
        auto& exporting = open<ExportMode>();
        chooseCamera(*exporting.findChild<CameraBox*>("measureCamera"), place);
        exporting.findChild<QPushButton*>("measureNow")->click();
        waitForTasks();
        shoot("export-measured");
        auto& review = open<ReviewMode>();
        auto* measure = review.findChild<QComboBox*>("measure");
        measure->setCurrentIndex(measure->findData(static_cast<int>(CoverageMeasure::Error)));
        shoot("review-errors");
    }

    void shootGridStudy(const QString& place) {
        auto& plan = open<PlanMode>();
        chooseCamera(*plan.findChild<CameraBox*>("gridCamera"), place);
        plan.findChild<QCheckBox*>("gridDepth")->setChecked(false);
        plan.findChild<QPushButton*>("gridStudy")->click();
        waitForTasks();
        plan.findChild<QScrollArea*>()->ensureWidgetVisible(plan.findChild<QTableView*>("gridTable"));
        shoot("plan-grid");
    }

    /// What comes after the last photo, and the guide.
    void shootEnd() {
        CaptureDesk& desk = open<CaptureMode>().desk();
        desk.connectToPractice();
        waitUntil([&] { return desk.state() == CaptureDesk::State::Ready; });
        desk.practice()->camera().disarm();
        desk.setAutomatic(true);
        desk.trigger();
        waitUntil([&] { return desk.isComplete(); });
        shoot("capture-done");
        HelpWindow help;
        help.showPage("capture");
        shoot("help", help);
    }

    QString m_folder;
    QString m_suffix;
    bool m_isForGuide;
    bool m_isDark;
    QStringList m_only;
    MainWindow m_window;
};

} // namespace

int main(int argc, char** argv) {
    const test::TemporaryFolder home;
    for (const char* place : {"HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME"}) {
        qputenv(place, home.path().c_str());
    }
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    if (argc > 4) {
        qputenv("LC_ALL", argv[4]);
    }
    Application app(argc, argv);
    const QStringList words = Application::arguments();
    if (words.size() < 4) {
        std::fprintf(
            stderr,
            "Usage: spherewalk-screenshots DIR SUFFIX light|dark|guide [language [WIDTHxHEIGHT [NAME]]]\n");
        return 2;
    }
    applyTheme(words[3] == "dark" ? Theme::Dark : Theme::Light);
    try {
        const QStringList sides = words.value(5, "1280x800").split('x');
        Album(words[1], words[2], words[3], {sides.value(0).toInt(), sides.value(1).toInt()}, words.mid(6, 1))
            .shootAll(QString::fromStdString(home.path().string()));
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.sentence().c_str());
        return 1;
    }
    return 0;
}
