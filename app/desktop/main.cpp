// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/application.h"
#include "ui/shell/main_window.h"

#include <QCommandLineParser>
#include <QTimer>

#include <csignal>

int main(int argc, char** argv) {
    using namespace spherewalk::ui;
    ::signal(SIGPIPE, SIG_IGN); // a broken pipe is an error of the call
    Application app(argc, argv);
    Application::setApplicationVersion(SPHEREWALK_VERSION);
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QApplication::translate("main", "Scans a room with a spherical camera."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument("survey", QApplication::translate("main", "Folder of a survey to open"),
                                 "[survey]");
    const QCommandLineOption practice(
        "practice", QApplication::translate("main", "Photograph the practice room with the practice camera"));
    parser.addOption(practice);
    parser.process(app);
    MainWindow window;
    QObject::connect(&app, &Application::problem, &window, &MainWindow::say);
    window.show();
    if (parser.isSet(practice)) {
        QTimer::singleShot(0, &window, [&window] { window.runPractice(); });
    } else if (!parser.positionalArguments().isEmpty()) {
        window.openSurvey(parser.positionalArguments().first());
    }
    return Application::exec();
}
