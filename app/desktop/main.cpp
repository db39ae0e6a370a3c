// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/application.h"
#include "ui/shell/main_window.h"

#include <QCommandLineParser>
#include <QTimer>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <string_view>

namespace {

/// Whether the program is to print words and end. Words need no display.
bool printsOnly(int argc, char** argv) {
    return std::any_of(argv + 1, argv + argc, [](const std::string_view word) {
        return word == "-h" || word == "--help" || word == "--help-all" || word == "-v" ||
               word == "--version";
    });
}

bool hasDisplay() {
    return qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY") ||
           qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
}

} // namespace

int main(int argc, char** argv) {
    using namespace spherewalk::ui;
    ::signal(SIGPIPE, SIG_IGN); // a broken pipe is an error of the call
    if (printsOnly(argc, argv)) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    } else if (!hasDisplay()) { // Qt would abort
        std::fprintf(stderr, "There is no display for the window; use spherewalk-cli, or set DISPLAY.\n");
        return 1;
    }
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
