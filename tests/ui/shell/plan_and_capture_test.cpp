// SPDX-License-Identifier: GPL-3.0-or-later
#include "qt_application.h"
#include "ui/capture/big_text.h"
#include "ui/capture/capture_mode.h"
#include "ui/plan/plan_mode.h"
#include "ui/shell/main_window.h"

#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolBar>
#include <gtest/gtest.h>

#include <functional>

namespace spherewalk::ui {

using Eigen::Vector2d;
using State = CaptureDesk::State;

namespace {

/// A person at the window, who has nothing but widgets.
class Person {
  public:
    Person() {
        m_window.resize(1280, 800);
        m_window.show();
        for (Mode* mode : m_window.modes()) {
            plan = plan != nullptr ? plan : qobject_cast<PlanMode*>(mode);
            capture = capture != nullptr ? capture : qobject_cast<CaptureMode*>(mode);
        }
        capture->desk().setPracticeSettings({.width = 1024, .timeScale = 0.001, .keepsPhotos = false});
    }

    void press(const QString& button) {
        auto* found = m_window.findChild<QPushButton*>(button);
        ASSERT_NE(found, nullptr) << button.toStdString();
        ASSERT_TRUE(found->isEnabled()) << button.toStdString();
        QTest::mouseClick(found, Qt::LeftButton);
    }

    void choose(const QString& mode) {
        for (QAction* action : m_window.findChild<QToolBar*>("modes")->actions()) {
            if (action->text() == mode) {
                return action->trigger();
            }
        }
        FAIL() << mode.toStdString();
    }

    /// Draws with the tool, corner after corner, and closes.
    void draw(PlanEditorView::Tool tool, const Polygon& corners) {
        PlanEditorView& view = plan->view();
        view.setTool(tool);
        for (std::size_t i = 0; i <= corners.size(); ++i) {
            const Vector2d& corner = corners[i % corners.size()];
            const QPoint at = view.widgetFromRoom().map(QPointF(corner.x(), corner.y())).toPoint();
            QTest::mouseMove(&view, at);
            QTest::mouseClick(&view, Qt::LeftButton, {}, at);
        }
    }

    void waitUntil(const std::function<bool()>& holds) {
        ASSERT_TRUE(QTest::qWaitFor(holds, 60'000)) << capture->desk().sentence().toStdString();
    }

    void waitFor(State state) {
        waitUntil([&] { return capture->desk().state() == state; });
    }

    MainWindow& window() { return m_window; }

    PlanMode* plan = nullptr;
    CaptureMode* capture = nullptr;

  private:
    MainWindow m_window;
};

} // namespace

TEST(PlanAndCapture, APersonGetsFromAnEmptyWindowToPhotosOnTheDisk) {
    Person person;
    person.press("newSurvey");
    const Polygon outline = {{0, 0}, {4.5, 0}, {4.5, 3.5}, {0, 3.5}};
    person.draw(PlanEditorView::Tool::Outline, outline);
    person.draw(PlanEditorView::Tool::Obstacle, {{1, 1}, {1.5, 1}, {1.5, 1.5}, {1, 1.5}});
    person.plan->findChild<QDoubleSpinBox*>("step")->setValue(1.2);
    person.waitUntil([&] { return person.plan->editor().isSettled(); });
    person.plan->findChild<QLineEdit*>("surveyName")->setText("hall");
    person.press("createSurvey");
    ASSERT_NE(person.window().session(), nullptr);
    const std::filesystem::path path = person.window().session()->path();

    person.choose("Capture");
    person.press("practiceCamera");
    person.waitFor(State::Ready);
    QTest::keyClick(person.capture, Qt::Key_Space); // starts
    CaptureDesk& desk = person.capture->desk();
    const int stations = desk.stations();
    for (int photo = 1; photo <= stations; ++photo) {
        person.waitFor(State::AtStation);
        const QString shown = person.capture->findChild<BigText*>("nextStation")->text();
        EXPECT_EQ(shown.toLower().toStdString(), desk.next()->name);
        QTest::keyClick(person.capture, Qt::Key_PageDown);
        person.waitUntil([&] { return desk.stationsLeft() == stations - photo; });
    }
    person.waitFor(State::Ready);
    person.window().close();

    const auto store = store::SurveyStore::open(path, store::Access::Read);
    EXPECT_EQ(store.info().name, "hall");
    EXPECT_EQ(store.room().outline, outline);
    EXPECT_EQ(store.room().obstacles.size(), 1U);
    EXPECT_EQ(store.counts().stationsWithPhoto, stations);
    EXPECT_EQ(store.counts().photos, stations);
    EXPECT_TRUE(store.check(noProgress(), {}).isSound());
    for (const store::PhotoRecord& photo : store.photos()) {
        EXPECT_LT((photo.positionM - store.station(photo.station).station.positionM).norm(), 1e-9);
        EXPECT_TRUE(std::filesystem::exists(store.photoFolder() / photo.fileName));
    }
}

} // namespace spherewalk::ui
