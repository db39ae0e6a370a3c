// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/main_window.h"

#include <QApplication>
#include <QCommandLineParser>

int main(int argc, char** argv) {
    QApplication app(argc, argv);
    QApplication::setApplicationName("spherewalk");
    QApplication::setApplicationVersion(SPHEREWALK_VERSION);
    QCommandLineParser parser;
    parser.setApplicationDescription(QApplication::translate("main", "Shows a survey."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument("survey", QApplication::translate("main", "Folder of a survey to open"),
                                 "[survey]");
    parser.process(app);
    spherewalk::ui::MainWindow window;
    if (!parser.positionalArguments().isEmpty()) {
        window.openSurvey(parser.positionalArguments().first());
    }
    window.show();
    return QApplication::exec();
}
