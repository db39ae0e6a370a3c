// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the start page, of planning and of capturing, to be looked at: DIR [light|dark] [language].
// With QT_SCALE_FACTOR=2 they are those of a screen of twice the density.
#include "temporary_folder.h"
#include "ui/capture/capture_mode.h"
#include "ui/look/theme.h"
#include "ui/plan/plan_mode.h"
#include "ui/shell/application.h"
#include "ui/shell/main_window.h"

#include "spherewalk/practice/fault.h"

#include <QElapsedTimer>
#include <QLineEdit>

#include <cstdio>
#include <functional>

using namespace spherewalk;
using namespace spherewalk::ui;

namespace {

class Album {
  public:
    Album(QString folder, QString suffix) : m_folder(std::move(folder)), m_suffix(std::move(suffix)) {}

    void shoot(QWidget& widget, const QString& name) const {
        QCoreApplication::processEvents();
        const QString file = m_folder + "/" + name + m_suffix + ".png";
        widget.grab().save(file);
        std::printf("%s\n", qPrintable(file));
    }

  private:
    QString m_folder;
    QString m_suffix;
};

/// Runs the event loop until the condition holds, at most half a minute.
void waitUntil(const std::function<bool()>& holds) {
    QElapsedTimer time;
    time.start();
    while (!holds() && time.elapsed() < 30'000) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 20);
    }
}

template <class Wanted>
Wanted* modeOf(const MainWindow& window) {
    for (Mode* mode : window.modes()) {
        if (auto* found = qobject_cast<Wanted*>(mode)) {
            return found;
        }
    }
    return nullptr;
}

void shootPlan(MainWindow& window, const Album& album, const QString& folder) {
    auto* plan = modeOf<PlanMode>(window);
    window.showMode(plan);
    PlanEditor& editor = plan->editor();
    editor.setOutline({{0, 0}, {6.2, 0}, {6.2, 3}, {3.6, 3}, {3.6, 5.1}, {0, 5.1}});
    editor.addObstacle({{1.2, 1.5}, {2.4, 1.5}, {2.4, 2.3}, {1.2, 2.3}});
    editor.addObstacle({{5.2, 0}, {6.2, 0}, {6.2, 0.6}, {5.2, 0.6}});
    waitUntil([&] { return editor.isSettled(); });
    plan->view().fitRoom();
    editor.select({PlanPart::kOutline, 3});
    album.shoot(window, "plan-new");
    plan->storage().create(folder + "/office.spherewalk");
    waitUntil([&] { return editor.isSettled(); });
    plan->view().fitRoom();
    album.shoot(window, "plan");
}

void shootCapture(MainWindow& window, const Album& album) {
    using State = CaptureDesk::State;
    auto* capture = modeOf<CaptureMode>(window);
    CaptureDesk& desk = capture->desk();
    window.showMode(capture);
    album.shoot(window, "capture-no-camera");
    desk.setPracticeSettings({.width = 1024, .timeScale = 0.001, .keepsPhotos = false});
    desk.connectToPractice();
    waitUntil([&] { return desk.state() == State::Ready; });
    desk.trigger();
    for (int photos = 0; photos < 9; ++photos) {
        waitUntil([&] { return desk.state() == State::AtStation; });
        desk.trigger();
        waitUntil([&] { return desk.state() != State::Shooting; });
    }
    waitUntil([&] { return desk.state() == State::AtStation; });
    album.shoot(window, "capture");
    desk.setHideSeconds(5);
    desk.trigger();
    album.shoot(window, "capture-hide");
    desk.trigger();
    desk.setHideSeconds(0);
    desk.practice()->camera().arm({practice::FaultKind::ServiceUnavailable, "camera.takePicture", 0, 50, 0});
    desk.trigger();
    waitUntil([&] { return desk.state() == State::AskAgain; });
    album.shoot(window, "capture-failed");
    desk.stop();
    waitUntil([&] { return desk.state() == State::Ready; });
}

} // namespace

int main(int argc, char** argv) {
    const test::TemporaryFolder home;
    for (const char* place : {"HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME"}) {
        qputenv(place, home.path().c_str());
    }
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    if (argc > 3) {
        qputenv("LC_ALL", argv[3]);
    }
    Application app(argc, argv);
    const QStringList words = Application::arguments();
    const bool isDark = words.value(2) == "dark";
    applyTheme(isDark ? Theme::Dark : Theme::Light);
    const Album album(words.value(1, "."),
                      (isDark ? "-dark" : "") + (words.size() > 3 ? "-" + words[3].left(2) : QString()));
    MainWindow window;
    window.resize(1280, 800);
    window.show();
    album.shoot(window, "start-first");
    shootPlan(window, album, QString::fromStdString(home.path().string()));
    shootCapture(window, album);
    window.showMode(nullptr);
    album.shoot(window, "start");
    window.showMode(modeOf<PlanMode>(window));
    album.shoot(window, "plan-fixed");
    return 0;
}
