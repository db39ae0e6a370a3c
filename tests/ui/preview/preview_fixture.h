// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "photographed_survey.h"
#include "qt_application.h"
#include "ui/preview/preview_mode.h"
#include "ui/preview/preview_presenter.h"

#include <QCheckBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>

namespace spherewalk::ui {

namespace fs = std::filesystem;

/// The preview page with a survey of four photos.
class PreviewTest : public testing::Test {
  protected:
    PreviewTest() {
        mode.resize(1100, 700);
        mode.setSession(session.get());
        mode.show();
        test::activate(mode);
        mode.activated();
        widget<QCheckBox>("withDepth").setChecked(false); // it takes its time
    }

    ~PreviewTest() override { mode.setSession(nullptr); }

    PreviewPresenter& presenter() { return mode.presenter(); }

    template <class Widget>
    Widget& widget(const char* name) {
        return *mode.findChild<Widget*>(name);
    }

    /// Makes a dataset of the survey and waits for a view of it.
    void preview() {
        QTest::mouseClick(&widget<QPushButton>("make"), Qt::LeftButton);
        ASSERT_TRUE(QTest::qWaitFor([&] { return hasSharpViews(1); }, 100'000));
    }

    bool hasSharpViews(std::size_t count) {
        const auto& views = presenter().views();
        return views.size() == count && std::all_of(views.begin(), views.end(), [](const MadeView& view) {
                   return view.report.origin == render::ViewOrigin::Photo;
               });
    }

    /// Waits for a view that was made after this call.
    void waitForView() {
        QSignalSpy views(&presenter(), &PreviewPresenter::viewsChanged);
        presenter().setRobot(presenter().robot());
        ASSERT_TRUE(views.wait());
        ASSERT_TRUE(QTest::qWaitFor([&] { return hasSharpViews(presenter().views().size()); }));
    }

    test::PhotographedSurvey survey{4};
    TaskList tasks;
    std::unique_ptr<SurveySession> session =
        SurveySession::open(QString::fromStdString(survey.path().string()));
    PreviewMode mode{tasks};
};

} // namespace spherewalk::ui
