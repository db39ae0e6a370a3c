// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/main_window.h"

#include "ui/plan/plan_view.h"

#include "spherewalk/base/error.h"
#include "spherewalk/store/survey_store.h"

#include <QAction>
#include <QFileDialog>
#include <QLabel>
#include <QMenuBar>
#include <QStatusBar>

#include <set>

namespace spherewalk::ui {

namespace {

std::vector<StationMark> marksOf(const store::SurveyStore& store) {
    std::set<std::int64_t> missing;
    for (const store::StationRecord& station : store.stationsWithoutPhoto()) {
        missing.insert(station.id);
    }
    std::vector<StationMark> marks;
    for (const store::StationRecord& station : store.stations()) {
        marks.push_back({station.station.positionM.head<2>(), QString::fromStdString(station.name),
                         !missing.contains(station.id)});
    }
    return marks;
}

} // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent), m_plan(new PlanView(this)), m_counts(new QLabel(this)) {
    setWindowTitle(tr("Spherewalk"));
    setCentralWidget(m_plan);
    statusBar()->addPermanentWidget(m_counts);
    QMenu* file = menuBar()->addMenu(tr("&File"));
    QAction* open = file->addAction(tr("&Open survey..."), this, &MainWindow::chooseSurvey);
    open->setShortcut(QKeySequence::Open);
    QAction* quit = file->addAction(tr("&Quit"), this, &QWidget::close);
    quit->setShortcut(QKeySequence::Quit);
}

bool MainWindow::openSurvey(const QString& folder) {
    try {
        const auto store = store::SurveyStore::open(folder.toStdString(), store::Access::Read);
        m_plan->setRoom(store.room());
        m_plan->setStations(marksOf(store));
        const store::Counts counts = store.counts();
        m_counts->setText(
            tr("%1 of %2 stations have a photo").arg(counts.stationsWithPhoto).arg(counts.stations));
        setWindowTitle(tr("%1 - Spherewalk").arg(QString::fromStdString(store.info().name)));
        setWindowFilePath(folder);
        return true;
    } catch (const Error& error) {
        statusBar()->showMessage(QString::fromStdString(error.sentence()));
        return false;
    }
}

void MainWindow::chooseSurvey() {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Open survey"));
    if (!folder.isEmpty()) {
        openSurvey(folder);
    }
}

} // namespace spherewalk::ui
