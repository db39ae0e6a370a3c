// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "event_loop_gap.h"
#include "qt_application.h"
#include "ui/capture/capture_mode.h"
#include "ui/plan/plan_mode.h"
#include "ui/shell/main_window.h"

#include "spherewalk/base/error.h"

#include <QAction>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileDialog>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <QToolBar>
#include <QUrl>
#include <gtest/gtest.h>

#include <functional>

namespace spherewalk::ui {

/// Drags files over the window and lets go of them. Returns whether the window wants them.
inline bool drop(MainWindow& window, const QString& path) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, {});
    enter.setAccepted(false);
    QCoreApplication::sendEvent(&window, &enter);
    if (enter.isAccepted()) {
        QDropEvent event({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&window, &event);
        QCoreApplication::processEvents();
    }
    return enter.isAccepted();
}

/// Somebody at the window, who has nothing but what it shows, a mouse and a keyboard. Clicks and keys are
/// counted, except those that draw.
class Person {
  public:
    explicit Person(const PracticeSettings& practice = {
                        .width = 1024, .timeScale = 0.001, .keepsPhotos = false}) {
        m_window.resize(1280, 800);
        m_window.show();
        test::activate(m_window);
        page<CaptureMode>().desk().setPracticeSettings(practice);
    }

    MainWindow& window() { return m_window; }

    /// Clicks and keys so far.
    int actions() const { return m_actions; }

    template <class Wanted>
    Wanted& page() const {
        for (Mode* mode : m_window.modes()) {
            if (auto* found = qobject_cast<Wanted*>(mode)) {
                return *found;
            }
        }
        throw Error(ErrorKind::NotFound, "The window has no such page.");
    }

    /// Of the page in sight, or of the first page.
    template <class Wanted>
    Wanted& widget(const char* name) const {
        const QWidget* page = m_window.mode();
        auto* found = (page != nullptr ? page : &m_window)->findChild<Wanted*>(name);
        if (found == nullptr) {
            throw Error(ErrorKind::NotFound, std::string("The page has no ") + name + ".");
        }
        return *found;
    }

    void choose(const QString& mode) {
        for (QAction* action : m_window.findChild<QToolBar*>("modes")->actions()) {
            if (action->text() == mode && action->isEnabled()) {
                ++m_actions;
                return action->trigger();
            }
        }
        FAIL() << mode.toStdString();
    }

    void press(const char* button) {
        auto& found = widget<QAbstractButton>(button);
        waitUntil([&] { return found.isEnabled(); });
        ++m_actions;
        QTest::mouseClick(&found, Qt::LeftButton, {}, {8, found.height() / 2}); // a check box's box is there
    }

    void key(QWidget& receiver, Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        ++m_actions;
        QTest::keyClick(&receiver, key, modifiers);
    }

    /// Clicks a field and types over what it has.
    void type(const char* name, const QString& text) {
        auto& found = widget<QWidget>(name);
        test::activate(m_window); // a dialog may have been
        found.setFocus();
        ++m_actions;
        key(found, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(&found, text);
        m_actions += static_cast<int>(text.size());
        key(found, Qt::Key_Tab);
    }

    /// Answers the next question for a file or folder.
    void answer(const QString& file) {
        QTimer::singleShot(0, &m_window, [this, file] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            if (dialog == nullptr) { // not there yet
                return answer(file);
            }
            ++m_actions;
            dialog->selectFile(file);
            QMetaObject::invokeMethod(dialog, "accept", Qt::QueuedConnection);
        });
    }

    /// Agrees to the question that the window asks.
    void agree() {
        auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        ASSERT_NE(question, nullptr);
        for (QAbstractButton* button : question->buttons()) {
            if (question->buttonRole(button) == QMessageBox::AcceptRole) {
                ++m_actions;
                button->click();
                return test::activate(m_window);
            }
        }
        FAIL() << question->text().toStdString();
    }

    /// Where a place of the room is on a plan.
    static QPoint at(const PlanCanvas& plan, const Eigen::Vector2d& pInRoom) {
        return plan.widgetFromRoom().map(QPointF(pInRoom.x(), pInRoom.y())).toPoint();
    }

    static void click(PlanCanvas& plan, const Eigen::Vector2d& pInRoom) {
        QTest::mouseMove(&plan, at(plan, pInRoom));
        QTest::mouseClick(&plan, Qt::LeftButton, {}, at(plan, pInRoom));
    }

    /// Draws with the tool that this key chooses, corner after corner, and closes.
    void draw(Qt::Key tool, const Polygon& corners) {
        PlanEditorView& view = page<PlanMode>().view();
        view.setFocus();
        QTest::keyClick(&view, tool);
        for (std::size_t i = 0; i <= corners.size(); ++i) {
            click(view, corners[i % corners.size()]);
        }
    }

    void waitUntil(const std::function<bool()>& holds) {
        constexpr int kMostMs = 100'000;
        ASSERT_TRUE(QTest::qWaitFor(holds, kMostMs)) << page<CaptureMode>().desk().sentence().toStdString();
    }

    /// Lets the window work for so many beats of the gap's timer, so that what it does is measured.
    void rest(const test::EventLoopGap& gap, int beats = 20) {
        waitUntil([&, until = gap.beats() + beats] { return gap.beats() > until; });
    }

    void waitFor(CaptureDesk::State state) {
        waitUntil([&] { return page<CaptureMode>().desk().state() == state; });
    }

    /// Waits for what runs in the background, which may be long work.
    void waitForTasks() {
        constexpr int kMostMs = 600'000;
        ASSERT_TRUE(QTest::qWaitFor([&] { return !m_window.tasks().hasRunning(); }, kMostMs));
    }

  private:
    MainWindow m_window;
    int m_actions = 0;
};

} // namespace spherewalk::ui
