// SPDX-License-Identifier: GPL-3.0-or-later
#include "photographed_survey.h"
#include "qt_application.h"
#include "ui/export/page_panel.h"
#include "ui/shell/application.h"

#include "spherewalk/base/json.h"
#include "spherewalk/web/page.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTranslator>

namespace spherewalk::ui {

namespace fs = std::filesystem;

namespace {

class PageTest : public testing::Test {
  protected:
    PageTest() {
        presenter.setSession(session.get());
        panel.show();
    }

    ~PageTest() override { presenter.setSession(nullptr); }

    template <class Widget>
    Widget& widget(const char* name) {
        return *panel.findChild<Widget*>(name);
    }

    void write() {
        QTest::mouseClick(&widget<QPushButton>("pageNow"), Qt::LeftButton);
        ASSERT_TRUE(QTest::qWaitFor([&] { return !tasks.hasRunning(); }, 100'000));
        QCoreApplication::processEvents();
    }

    test::PhotographedSurvey survey{2, 512};
    TaskList tasks;
    std::unique_ptr<SurveySession> session =
        SurveySession::open(QString::fromStdString(survey.path().string()));
    PagePresenter presenter{tasks};
    PagePanel panel{presenter};
};

} // namespace

TEST_F(PageTest, WritesAPageBesideTheSurveyAndOpensIt) {
    const QSignalSpy opened(&panel, &PagePanel::openRequested);
    EXPECT_FALSE(widget<QPushButton>("openPage").isVisible());
    write();
    const fs::path page = survey / "room.web/index.html";
    EXPECT_TRUE(fs::exists(page)) << widget<QLabel>("pageWords").text().toStdString();
    EXPECT_TRUE(widget<QLabel>("pageWords").text().contains("room.web: 2 ")) << "photos";
    QTest::mouseClick(&widget<QPushButton>("openPage"), Qt::LeftButton);
    ASSERT_EQ(opened.count(), 1);
    EXPECT_EQ(opened.first().first().toString().toStdString(), page.string());
    write();
    EXPECT_TRUE(fs::exists(survey / "room-2.web/index.html")) << "the first one stays";
}

TEST_F(PageTest, WritesNothingWithoutASurvey) {
    presenter.setSession(nullptr);
    EXPECT_FALSE(widget<QPushButton>("pageNow").isEnabled());
}

TEST(PageWords, AreAllTranslated) {
    const Json all = web::allWords({});
    for (const char* language : {"de", "pl"}) {
        QTranslator words;
        ASSERT_TRUE(loadWords(words, QLocale(language)));
        QCoreApplication::installTranslator(&words);
        for (const auto& [key, word] : all.items()) {
            const auto english = word.get<std::string>();
            EXPECT_FALSE(words.translate("spherewalk::ui::PageWords", english.c_str()).isEmpty()) << english;
        }
        EXPECT_NE(pageWord("Keys"), "Keys");
        EXPECT_EQ(pageWord("a name"), "a name") << "what is no word stays";
        QCoreApplication::removeTranslator(&words);
    }
}

} // namespace spherewalk::ui
