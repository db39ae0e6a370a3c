// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the modes on a survey, to be looked at, and how long they take: DIR SURVEY [dark].
#include "ui/align/align_mode.h"
#include "ui/export/export_mode.h"
#include "ui/look/theme.h"
#include "ui/panorama/panorama_presenter.h"
#include "ui/panorama/panorama_view.h"
#include "ui/preview/drive_view.h"
#include "ui/preview/preview_mode.h"
#include "ui/preview/preview_presenter.h"
#include "ui/review/review_mode.h"
#include "ui/session/survey_session.h"
#include "ui/tasks/task_list.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QListView>
#include <QPushButton>
#include <QScrollBar>
#include <QTableView>
#include <QTemporaryDir>

#include <cstdio>

using namespace spherewalk::ui;

namespace {

/// Runs the event loop so long, and says what the longest time was that it was not served.
qint64 settle(int ms) {
    QElapsedTimer timer;
    timer.start();
    QTimer tick;
    tick.setTimerType(Qt::PreciseTimer);
    qint64 last = 0;
    qint64 longest = 0;
    QObject::connect(&tick, &QTimer::timeout, [&] {
        longest = std::max(longest, timer.elapsed() - last);
        last = timer.elapsed();
    });
    tick.start(1);
    while (timer.elapsed() < ms) {
        QApplication::processEvents(QEventLoop::WaitForMoreEvents, 20);
    }
    return longest;
}

void shoot(QWidget& widget, const QString& file) {
    widget.grab().save(file);
    std::printf("%s\n", qPrintable(file));
}

template <class M>
void open(M& mode, SurveySession* session) {
    QElapsedTimer timer;
    timer.start();
    mode.resize(1200, 740);
    mode.setSession(session);
    mode.show();
    mode.activated();
    mode.grab();
    std::printf("%s opened and drawn after %lld ms\n", qPrintable(mode.title()), timer.elapsed());
}

} // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication app(argc, argv);
    const QString out = app.arguments().at(1);
    const QString kind = app.arguments().value(3);
    applyTheme(kind == "dark" ? Theme::Dark : Theme::Light);
    QElapsedTimer timer;
    timer.start();
    auto session = SurveySession::open(app.arguments().at(2));
    std::printf("session opened after %lld ms\n", timer.elapsed());
    QTemporaryDir cache;
    TaskList tasks;
    {
        ReviewMode review(cache.path().toStdString(), nullptr);
        open(review, session.get());
        auto* list = review.findChild<QListView*>("stations");
        qint64 longest = 0;
        for (int i = 0; i <= 60; ++i) { // all of the list in three seconds
            list->verticalScrollBar()->setValue(list->verticalScrollBar()->maximum() * i / 60);
            longest = std::max(longest, settle(50));
        }
        std::printf("longest gap while scrolling, thumbnails being made: %lld ms\n", longest);
        list->scrollToTop();
        settle(3000);
        shoot(review, out + "/review.png");
        auto& viewer = review.findChild<PanoramaView*>()->presenter();
        timer.restart();
        for (int i = 0; i < 20; ++i) {
            viewer.turn(spherewalk::Degrees(3), spherewalk::Radians(0));
            viewer.picture({620, 480});
        }
        std::printf("a view of 620 x 480 while turning: %.1f ms\n", timer.elapsed() / 20.0);
        timer.restart();
        for (int i = 0; i < 10; ++i) {
            viewer.zoom(0.95);
            viewer.picture({620, 480});
        }
        std::printf("while zooming: %.1f ms\n", timer.elapsed() / 10.0);
        timer.restart();
        session->noteChanged(SurveySession::Everything);
        std::printf("review refreshed in %lld ms\n", timer.elapsed());
        review.findChild<QComboBox*>("comparison")->setCurrentIndex(2);
        review.findChild<QComboBox*>("measure")->setCurrentIndex(1);
        settle(3000);
        shoot(review, out + "/review-slider.png");
        review.setSession(nullptr);
    }
    {
        AlignMode align(tasks, nullptr);
        open(align, session.get());
        align.findChild<QTableView*>("photos")->selectRow(2);
        settle(200);
        shoot(align, out + "/align.png");
        timer.restart();
        session->noteChanged(SurveySession::Everything);
        std::printf("align refreshed in %lld ms\n", timer.elapsed());
        align.setSession(nullptr);
    }
    {
        ExportMode exporting(tasks, nullptr);
        open(exporting, session.get());
        settle(2500);
        shoot(exporting, out + "/export.png");
        exporting.setSession(nullptr);
    }
    if (session->store().counts().photos < 100) {
        PreviewMode preview(tasks, nullptr);
        open(preview, session.get());
        preview.presenter().makeDataset();
        while (preview.presenter().views().empty()) {
            settle(100);
        }
        preview.findChild<QCheckBox*>("ball")->setChecked(true);
        settle(1000);
        shoot(preview, out + "/preview.png");
        preview.findChild<QCheckBox*>("split")->setChecked(true);
        preview.presenter().setRecording(true);
        preview.presenter().drive({.forward = 1, .turnLeft = 0.3});
        std::printf("longest gap while driving: %lld ms\n", settle(2500));
        std::printf("%.0f pairs of views a second\n", preview.presenter().rate());
        preview.presenter().drive({});
        settle(500);
        shoot(preview, out + "/preview-split.png");
        for (const MadeView& view : preview.presenter().views()) {
            std::printf("%s\n", qPrintable(DriveView::reportText(view.report)));
        }
        preview.setSession(nullptr);
    }
    return 0;
}
