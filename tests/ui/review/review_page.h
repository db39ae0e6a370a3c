// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "photographed_survey.h"
#include "qt_application.h"
#include "ui/review/review_mode.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>

namespace spherewalk::ui {

/// The page Review with a survey of three photos, through the widgets that people use.
class ReviewPage : public testing::Test {
  protected:
    ReviewPage() {
        mode.resize(1100, 700);
        mode.setSession(session.get());
        mode.show();
        test::activate(mode);
        mode.activated();
    }

    ~ReviewPage() override { mode.setSession(nullptr); }

    template <class Widget>
    Widget& widget(const char* name) {
        return *mode.findChild<Widget*>(name);
    }

    std::int64_t photo(std::size_t station) const {
        return session->store().chosenPhoto(session->store().stations().at(station).id)->id;
    }

    test::PhotographedSurvey survey{3};
    std::unique_ptr<SurveySession> session =
        SurveySession::open(QString::fromStdString(survey.path().string()));
    TaskList tasks;
    ReviewMode mode{tasks, survey / "cache", nullptr};
};

} // namespace spherewalk::ui
