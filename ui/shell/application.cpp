// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/application.h"

#include "ui/frame/settings.h"
#include "ui/look/core_words.h"
#include "ui/look/icon.h"
#include "ui/look/theme.h"

#include "spherewalk/base/error.h"

#include <QLibraryInfo>
#include <QLocale>

/// The linker keeps the resources of a static library only if they are asked for; in no namespace, as Qt
/// wants it.
static void keepTranslations() {
    Q_INIT_RESOURCE(translations);
}

namespace spherewalk::ui {

bool loadWords(QTranslator& translator, const QLocale& locale) {
    keepTranslations();
    return translator.load(locale, "spherewalk", "_", ":/translations") ||
           translator.load(":/translations/spherewalk_en.qm");
}

Application::Application(int& argc, char** argv) : QApplication(argc, argv) {
    setOrganizationName("spherewalk");
    setApplicationName("spherewalk");
    setApplicationDisplayName("Spherewalk");
    setDesktopFileName("spherewalk");
    setWindowIcon(ui::icon("spherewalk"));
    translate();
    applyTheme(Settings().theme());
}

void Application::translate() {
    const QString chosen = Settings().language();
    const QLocale locale = chosen.isEmpty() ? QLocale() : QLocale(chosen);
    QLocale::setDefault(locale);
    if (m_qt.load(locale, "qtbase", "_", QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
        installTranslator(&m_qt);
    }
    if (loadWords(m_own, locale)) {
        installTranslator(&m_own);
    }
}

bool Application::notify(QObject* receiver, QEvent* event) {
    try {
        return QApplication::notify(receiver, event);
    } catch (const Error& error) {
        emit problem(coreWords(error.sentence()));
    } catch (const std::exception& defect) { // whatever no module translated
        emit problem(tr("Spherewalk met a defect of its own: %1.").arg(QString::fromUtf8(defect.what())));
    }
    return false;
}

} // namespace spherewalk::ui
