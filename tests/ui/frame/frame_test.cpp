// SPDX-License-Identifier: GPL-3.0-or-later
#include "qt_application.h"
#include "temporary_folder.h"
#include "ui/frame/mode.h"
#include "ui/frame/settings.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"

#include <QSettings>
#include <QSignalSpy>
#include <gtest/gtest.h>

namespace spherewalk::ui {

namespace {

/// The least that a page can be.
class EmptyMode : public Mode {
  public:
    EmptyMode() : Mode("capture", "Capture", "Take the photos", nullptr) {}

    void setSession(SurveySession* /*session*/) override {}
};

class SettingsTest : public testing::Test {
  protected:
    SettingsTest() { QSettings().clear(); }

    /// A folder that looks like a survey.
    QString surveyFolder(const std::string& name) {
        std::filesystem::create_directories(folder / name);
        writeFile(folder / name / "survey.sqlite", bytesOf("made"));
        return QString::fromStdString((folder / name).string());
    }

    test::TemporaryFolder folder;
    Settings settings;
};

} // namespace

TEST_F(SettingsTest, TheLatestSurveyIsFirstAndNamedOnce) {
    const QString a = surveyFolder("a");
    const QString b = surveyFolder("b");
    for (const QString& opened : {a, b, a}) {
        settings.addRecentSurvey(opened);
    }
    EXPECT_EQ(settings.recentSurveys(), QStringList({a, b}));
}

TEST_F(SettingsTest, ForgetsTheOldestSurveys) {
    for (int i = 0; i <= Settings::kMostRecent; ++i) {
        settings.addRecentSurvey(surveyFolder(text("s", i)));
    }
    EXPECT_EQ(settings.recentSurveys().size(), Settings::kMostRecent);
    EXPECT_FALSE(settings.recentSurveys().contains(QString::fromStdString((folder / "s0").string())));
}

TEST_F(SettingsTest, LeavesOutSurveysThatAreGone) {
    const QString gone = surveyFolder("gone");
    settings.addRecentSurvey(gone);
    std::filesystem::remove_all(gone.toStdString());
    EXPECT_TRUE(settings.recentSurveys().isEmpty());
}

TEST_F(SettingsTest, RemembersTheTheme) {
    EXPECT_EQ(settings.theme(), Theme::System);
    for (const Theme theme : {Theme::Dark, Theme::Light, Theme::System}) {
        settings.setTheme(theme);
        EXPECT_EQ(Settings().theme(), theme);
    }
}

TEST_F(SettingsTest, KnowsTheReportOfASurveyWhileThereIsOne) {
    const QString report = surveyFolder("a") + "/survey.sqlite";
    settings.setMeasuredReport("uuid", report);
    EXPECT_EQ(settings.measuredReport("uuid"), report);
    EXPECT_TRUE(settings.measuredReport("another").isEmpty());
    settings.setMeasuredReport("uuid", QString());
    EXPECT_TRUE(settings.measuredReport("uuid").isEmpty());
}

TEST(Mode, TellsWhenItIsShownAndHidden) {
    EmptyMode mode;
    QSignalSpy shown(&mode, &Mode::shownChanged);
    mode.show();
    mode.hide();
    ASSERT_EQ(shown.size(), 2);
    EXPECT_TRUE(shown[0][0].toBool());
    EXPECT_FALSE(shown[1][0].toBool());
}

TEST(Mode, HasTheIconOfItsName) {
    EXPECT_FALSE(EmptyMode().icon().isNull());
}

} // namespace spherewalk::ui
