// SPDX-License-Identifier: GPL-3.0-or-later
// Links from what the window says to where it is cured, followed as a person does.
#include "made_survey.h"
#include "person.h"
#include "photographed_survey.h"
#include "temporary_folder.h"
#include "ui/export/export_mode.h"
#include "ui/look/told_label.h"
#include "ui/preview/preview_mode.h"
#include "ui/shell/help_window.h"

#include <QComboBox>
#include <QDesktopServices>
#include <QLineEdit>
#include <QScrollBar>
#include <QStatusBar>
#include <QTextBrowser>

namespace spherewalk::ui {

namespace {

/// Follows a link of a label by the keyboard alone. link: 1 for the first.
void followByKeys(ToldLabel& label, int link = 1) {
    ASSERT_TRUE(label.hasLink()) << label.words().toStdString();
    label.setFocus(Qt::TabFocusReason);
    for (; link > 1; --link) {
        QTest::keyClick(&label, Qt::Key_Tab);
    }
    QTest::keyClick(&label, Qt::Key_Return);
}

class CuresTest : public testing::Test {
  protected:
    void openEmptySurvey() {
        const auto made = test::makeSurvey(folder / "kitchen.spherewalk");
        ASSERT_TRUE(person.window().openSurvey(QString::fromStdString(made.string())));
    }

    QString page() {
        return person.window().mode() != nullptr ? person.window().mode()->objectName() : "start";
    }

    ToldLabel& label(const char* name) { return person.widget<ToldLabel>(name); }

    const test::TemporaryFolder folder;
    Person person;
};

} // namespace

TEST_F(CuresTest, WithoutPhotosPreviewAndAlignLeadToCapture) {
    openEmptySurvey();
    for (const auto& [title, name] : {std::pair("Preview", "what"), std::pair("Align", "summary")}) {
        person.choose(title);
        followByKeys(label(name));
        EXPECT_EQ(page(), "capture") << title;
    }
}

TEST_F(CuresTest, WhatATaskLacksIsLinkedInTheStatusLineAndInItsRow) {
    openEmptySurvey();
    person.choose("Align");
    person.press("run");
    person.waitForTasks();
    auto* link = person.window().findChild<ToldLabel*>("cure");
    person.waitUntil([&] { return link->isVisible(); });
    EXPECT_TRUE(person.window().statusBar()->currentMessage().contains("nothing to align"));
    const QList<ToldLabel*> all = person.window().findChild<QWidget*>("tasks")->findChildren<ToldLabel*>();
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [](const ToldLabel* row) { return row->hasLink(); }));
    followByKeys(*link);
    EXPECT_EQ(page(), "capture");
    person.window().say(QString("Something else."));
    EXPECT_FALSE(link->isVisible());
}

TEST_F(CuresTest, WhatWillBeBlurredLeadsToThePhotosWithIt) {
    const test::PhotographedSurvey photographed(3);
    std::int64_t station = 0;
    {
        auto store = photographed.open(store::Access::Write);
        const store::PhotoRecord photo = store.photos().at(1);
        store.markRegion(photo.id, {Degrees(0), Degrees(0), Degrees(10), Degrees(10)});
        station = photo.station;
    }
    ASSERT_TRUE(person.window().openSurvey(QString::fromStdString(photographed.path().string())));
    person.choose("Export");
    person.waitForTasks();
    auto& findings = label("findings");
    person.waitUntil([&] { return findings.words().contains("will be blurred"); });
    EXPECT_TRUE(findings.text().contains(linkTo(Cure::Regions).toString()));
    QDesktopServices::openUrl(linkTo(Cure::Regions));
    EXPECT_EQ(page(), "review");
    EXPECT_EQ(person.widget<QComboBox>("filter").currentText(), "With private regions");
    EXPECT_EQ(person.window().session()->selection()->current(), station);
}

TEST_F(CuresTest, TheStatusLineDoesNotLinkToThePageInSight) {
    openEmptySurvey();
    person.choose("Capture");
    person.window().say({"No photo.", Cure::Capture});
    EXPECT_FALSE(person.window().findChild<ToldLabel*>("cure")->isVisible());
    person.window().say({"The address is wrong.", Cure::CameraAddress}); // a part of the page
    EXPECT_TRUE(person.window().findChild<ToldLabel*>("cure")->isVisible());
}

TEST_F(CuresTest, MissingRotationsLeadFromExportToAlignAndMissingDepthToItsChoice) {
    const test::PhotographedSurvey photos(4);
    const auto made = test::makeSurvey(folder / "kitchen.spherewalk");
    writeFile(folder / "p.csv", bytesOf("file,x_m,y_m,z_m\nR1001.JPG,0.5,0.5,1.2\nR1002.JPG,1,0.5,1.2\n"));
    {
        auto store = store::SurveyStore::open(made, store::Access::Write);
        jobs::importPhotos(store, {photos / "in", folder / "p.csv"}, noProgress(), {}); // without headings
    }
    ASSERT_TRUE(person.window().openSurvey(QString::fromStdString(made.string())));
    person.choose("Export");
    person.waitUntil([&] { return !label("findings").words().isEmpty(); });
    followByKeys(label("placeWords"));
    EXPECT_EQ(page(), "export");
    EXPECT_TRUE(person.widget<QComboBox>("scene").hasFocus());
    person.waitForTasks();
    EXPECT_TRUE(label("findings").words().contains("not aligned")) << label("findings").words().toStdString();
    followByKeys(label("findings"), 2); // the first is of stations without a photo
    EXPECT_EQ(page(), "align");
}

TEST_F(CuresTest, ASilentCameraLeadsToTheGuideAndABadAddressToItsField) {
    openEmptySurvey();
    person.choose("Capture");
    CaptureDesk& desk = person.page<CaptureMode>().desk();
    desk.connectTo("127.0.0.1:1"); // nobody listens there
    person.waitUntil([&] { return label("verdict").hasLink(); });
    followByKeys(label("verdict"));
    auto* help = person.window().findChild<HelpWindow*>();
    ASSERT_NE(help, nullptr);
    EXPECT_TRUE(help->isVisible());
    EXPECT_EQ(help->heading(), "The camera does not answer");
    help->close();
    test::activate(person.window());
    desk.connectTo("not an address at all");
    followByKeys(label("verdict"));
    EXPECT_TRUE(person.widget<QLineEdit>("cameraAddress").hasFocus());
}

TEST(Guide, ItsPicturesFitItsWindow) {
    HelpWindow help;
    for (const char* page : {"plan", "capture", "connecting", "review", "export"}) {
        help.showPage(page);
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&help));
        const auto* bar = help.findChild<QTextBrowser*>("helpText")->horizontalScrollBar();
        // Qt 6.8 lays the text out once more when the upright bar has come.
        EXPECT_TRUE(QTest::qWaitFor([&] { return bar->maximum() == 0; })) << page << bar->maximum();
    }
}

TEST_F(CuresTest, WithoutASurveyLinksLeadToTheStartPage) {
    person.window().showMode(&person.page<PreviewMode>());
    person.window().follow(linkTo(Cure::Align));
    EXPECT_EQ(page(), "start");
    person.window().showMode(&person.page<PreviewMode>());
    person.window().follow(QUrl("spherewalk:nowhere/at all"));
    EXPECT_EQ(page(), "start");
}

} // namespace spherewalk::ui
