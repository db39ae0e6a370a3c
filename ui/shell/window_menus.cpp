// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/frame/mode.h"
#include "ui/frame/settings.h"
#include "ui/plan/plan_storage.h"
#include "ui/shell/dropped_files.h"
#include "ui/shell/help_window.h"
#include "ui/shell/main_window.h"

#include "spherewalk/base/error.h"
#include "spherewalk/jobs/import_photos.h"
#include "spherewalk/store/survey_store.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QDir>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenuBar>
#include <QMimeData>
#include <QUndoGroup>
#include <QUrl>

namespace spherewalk::ui {

namespace {

/// The files and folders of this computer that a drag carries.
QStringList filesIn(const QMimeData& data) {
    QStringList files;
    for (const QUrl& url : data.urls()) {
        if (url.isLocalFile()) {
            files << url.toLocalFile();
        }
    }
    return files;
}

} // namespace

void MainWindow::makeMenus() {
    QMenu* file = menuBar()->addMenu(tr("&File"));
    const auto add = [this](QMenu* menu, const QString& text, const QKeySequence& key, auto slot) {
        QAction* action = menu->addAction(text, this, slot);
        action->setShortcut(key);
        addAction(action); // its key works while the menus are hidden
        return action;
    };
    add(file, tr("&New survey"), QKeySequence::New, &MainWindow::beginSurvey);
    add(file, tr("New survey by &hand"), {}, &MainWindow::beginByHand)->setObjectName("newByHand");
    add(file, tr("&Open survey..."), QKeySequence::Open, &MainWindow::chooseSurvey);
    makeRecent(file->addMenu(tr("&Recent surveys")), file);
    add(file, tr("&Practice room"), {}, &MainWindow::runPractice);
    add(file, tr("&Close survey"), QKeySequence::Close, &MainWindow::closeSurvey);
    m_import = add(file, tr("&Import photos..."), {}, &MainWindow::chooseImport);
    m_import->setObjectName("importPhotos");
    add(file, tr("Import photos &without positions..."), {}, &MainWindow::chooseFreeImport);
    file->addSeparator();
    add(file, tr("&Quit"), QKeySequence::Quit, &QWidget::close);
    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    QAction* undo = m_undo->createUndoAction(this, tr("&Undo"));
    undo->setShortcut(QKeySequence::Undo);
    QAction* redo = m_undo->createRedoAction(this, tr("&Redo"));
    redo->setShortcut(QKeySequence::Redo);
    edit->addActions({undo, redo});
    addActions({undo, redo});
    makeView(menuBar()->addMenu(tr("&View")));
    QMenu* help = menuBar()->addMenu(tr("&Help"));
    add(help, tr("&Guide to this page"), Qt::Key_F1, &MainWindow::showGuide);
    add(help, tr("&Tour in five steps"), {}, &MainWindow::runTour);
    add(help, tr("&Keys"), QKeySequence("Ctrl+/"), &MainWindow::showKeys);
    add(help, tr("&About Spherewalk"), {}, &MainWindow::showAbout);
}

/// Lists the surveys that were open, each time that the menu around it is opened.
void MainWindow::makeRecent(QMenu* recent, QMenu* around) {
    recent->setObjectName("recentMenu");
    recent->setToolTipsVisible(true);
    connect(around, &QMenu::aboutToShow, this, [this, recent] {
        recent->clear();
        const QStringList folders = Settings().recentSurveys().mid(0, 9); // by one digit each
        for (const QString& folder : folders) {
            const QString name = QFileInfo(folder).completeBaseName().replace('&', "&&");
            const QString number = QString::number(recent->actions().size() + 1);
            QAction* action = recent->addAction(QString("&%1  %2").arg(number, name), this,
                                                [this, folder] { openSurvey(folder); });
            action->setToolTip(QDir::toNativeSeparators(folder));
        }
        recent->setEnabled(!folders.isEmpty());
    });
}

void MainWindow::makeView(QMenu* view) {
    QAction* full = view->addAction(tr("&Full screen"));
    full->setShortcut(Qt::Key_F11);
    full->setCheckable(true);
    addAction(full);
    connect(full, &QAction::toggled, this, [this](bool isFull) {
        isFull ? showFullScreen() : showNormal();
        showBars();
    });
    view->addAction(m_planDock->toggleViewAction());
    QAction* tasks = m_tasksDock->toggleViewAction();
    tasks->setShortcut(QKeySequence("Ctrl+T"));
    view->addAction(tasks);
    addAction(tasks);
    QMenu* looks = view->addMenu(tr("&Appearance"));
    addTheme(looks, Theme::System, tr("As the &desktop"));
    addTheme(looks, Theme::Light, tr("&Light"));
    addTheme(looks, Theme::Dark, tr("Da&rk"));
    QMenu* languages = view->addMenu(tr("Lan&guage"));
    addLanguage(languages, {}, tr("As the &system"));
    addLanguage(languages, "en", QStringLiteral("English"));
    addLanguage(languages, "de", QStringLiteral("Deutsch"));
    addLanguage(languages, "pl", QStringLiteral("Polski"));
}

/// The words of a page are made with it, so that another language needs a new start.
void MainWindow::addLanguage(QMenu* menu, const QString& language, const QString& name) {
    auto* group = menu->findChild<QActionGroup*>();
    group = group != nullptr ? group : new QActionGroup(menu);
    QAction* action = menu->addAction(name);
    action->setObjectName("language-" + language);
    action->setCheckable(true);
    action->setChecked(Settings().language() == language);
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, language] {
        Settings().setLanguage(language);
        say(tr("The language changes when the program is started the next time."));
    });
}

void MainWindow::addTheme(QMenu* menu, Theme theme, const QString& text) {
    auto* group = menu->findChild<QActionGroup*>();
    group = group != nullptr ? group : new QActionGroup(menu);
    QAction* action = menu->addAction(text);
    action->setCheckable(true);
    action->setChecked(Settings().theme() == theme);
    group->addAction(action);
    connect(action, &QAction::triggered, this, [theme] {
        Settings().setTheme(theme);
        applyTheme(theme);
    });
}

void MainWindow::showAbout() {
    say(tr("Spherewalk %1, free software under the GNU General Public License, version 3 or later.")
            .arg(QCoreApplication::applicationVersion()));
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (droppedAs(filesIn(*event->mimeData())).kind != Dropped::Kind::Nothing) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    const Dropped dropped = droppedAs(filesIn(*event->mimeData()));
    event->acceptProposedAction();
    // The program from which the files come waits for the end of this event.
    QMetaObject::invokeMethod(
        this, [this, dropped] { take(dropped); }, Qt::QueuedConnection);
}

void MainWindow::take(const Dropped& dropped) {
    using Kind = Dropped::Kind;
    switch (dropped.kind) {
    case Kind::Survey:
        openSurvey(dropped.path);
        break;
    case Kind::Dataset:
        showPage("preview", dropped.path);
        break;
    case Kind::Photos:
        importFree(dropped.photos);
        break;
    case Kind::Positions:
        m_session ? importPhotos(dropped.path, dropped.photos)
                  : say({tr("Open a survey first; the photos become part of it."), Cure::Start});
        break;
    case Kind::FloorPicture:
        showPage("plan", dropped.path);
        break;
    case Kind::Nothing:
        break;
    }
}

HelpWindow& MainWindow::help() {
    if (m_help == nullptr) {
        m_help = new HelpWindow(this);
    }
    return *m_help;
}

void MainWindow::showGuide() {
    help().showPage(mode() != nullptr ? mode()->objectName() : QString());
}

/// Lists the keys of the menus, and those of each page.
void MainWindow::showKeys() {
    QString text = "# " + tr("Keys") + "\n";
    const auto addPart = [&](const QString& title, const QList<Mode::Key>& keys) {
        if (!keys.isEmpty()) {
            text += "\n## " + title + "\n\n| " + tr("Key") + " | " + tr("What it does") + " |\n|---|---|\n";
        }
        for (const Mode::Key& key : keys) {
            text += "| " + key.name + " | " + key.what + " |\n";
        }
    };
    const auto keysOf = [](const QList<QAction*>& actions) {
        QList<Mode::Key> keys;
        for (const QAction* action : actions) {
            QStringList names;
            for (const QKeySequence& key : action->shortcuts()) {
                names << key.toString(QKeySequence::NativeText);
            }
            if (!names.isEmpty()) {
                keys << Mode::Key{names.join(", "), QString(action->text()).remove('&')};
            }
        }
        return keys;
    };
    addPart(tr("Everywhere"), keysOf(actions()));
    for (const Mode* mode : std::as_const(m_modes)) {
        addPart(mode->title(), mode->keys() + keysOf(mode->findChildren<QAction*>()));
    }
    help().showText(text);
}

/// Asks for a list of positions and the folder of its photos, and takes the photos into the survey.
void MainWindow::chooseImport() {
    const QString positions =
        QFileDialog::getOpenFileName(this, tr("Positions of the photos"), {}, tr("Positions (*.csv)"));
    if (positions.isEmpty()) {
        return;
    }
    const QString photos = QFileDialog::getExistingDirectory(this, tr("Folder of the photos"),
                                                             QFileInfo(positions).absolutePath());
    if (!photos.isEmpty()) {
        importPhotos(positions, photos);
    }
}

/// Asks for a folder of photos of which nobody wrote down where they were taken.
void MainWindow::chooseFreeImport() {
    const QString photos = QFileDialog::getExistingDirectory(this, tr("Folder of the photos"));
    if (!photos.isEmpty()) {
        importFree(photos);
    }
}

/// Opens a new survey without a plan, whose folder begins with these words. Returns whether it did.
bool MainWindow::openNewByHand(const QString& base) {
    const QString folder = freeFolder(base, ".spherewalk");
    try {
        store::SurveyStore::create(folder.toStdString(), QFileInfo(folder).completeBaseName().toStdString(),
                                   survey::unknownRoom(),
                                   {.stepM = survey::kStepByHandM, .areHeightsGuessed = true}, {});
    } catch (const Error& error) {
        say(coreTold(error.sentence()));
        return false;
    }
    return openSurvey(folder);
}

/// Makes a survey in surveysPlace() whose photos are taken by hand, and goes to where they are taken.
void MainWindow::beginByHand() {
    if (openNewByHand(surveysPlace() + "/" + tr("walk"))) {
        showPage("capture", {});
    }
}

/// Takes photos into the open survey; without one, into a survey of their folder's name.
void MainWindow::importFree(const QString& photos) {
    if (m_session || openNewByHand(surveysPlace() + "/" + QDir(photos).dirName())) {
        importPhotos({}, photos);
    }
}

void MainWindow::importPhotos(const QString& positions, const QString& photos) {
    if (!m_session) {
        return;
    }
    jobs::ImportOptions options;
    options.photos = photos.toStdString();
    options.positions = positions.toStdString();
    const Task* task = m_tasks.start(
        tr("Importing photos"), this,
        [folder = m_session->path(), options](ProgressSink& progress, const std::stop_token& stop) {
            auto store = store::SurveyStore::open(folder, store::Access::Write);
            return jobs::importPhotos(store, options, progress, stop);
        },
        [this](const jobs::ImportReport& report) {
            const QString imported =
                tr("%n photo(s) imported, %1 were there already.", nullptr, report.imported)
                    .arg(report.alreadyThere);
            if (report.unknownPlaces > 0) {
                say({imported + " " + tr("Align solves where they were taken."), Cure::Align});
            } else {
                say({imported + " " + tr("Check them in Review."), Cure::Review});
            }
        });
    connect(task, &Task::ended, m_session.get(),
            [session = m_session.get()] { session->noteChanged(SurveySession::Everything); });
}

} // namespace spherewalk::ui
