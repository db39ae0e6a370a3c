// SPDX-License-Identifier: GPL-3.0-or-later
#include "qt_application.h"
#include "ui/look/core_words.h"
#include "ui/look/told_label.h"

#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>
#include <gtest/gtest.h>

namespace spherewalk::ui {

TEST(Told, EachCuredSentenceIsOneThatTheWindowKnows) {
    for (const CuredSentence& cured : curedSentences()) {
        const QString sentence = QString::fromUtf8(cured.sentence);
        bool isKnown = false;
        coreWords(sentence, [&](const char* known) { isKnown = isKnown || sentence == known; });
        EXPECT_TRUE(isKnown) << cured.sentence;
        EXPECT_FALSE(linkTo(cured.cure).isEmpty()) << cured.sentence;
        EXPECT_FALSE(linkWords(cured.cure).isEmpty()) << cured.sentence;
    }
}

TEST(Told, TheCureIsThatOfTheFirstSentenceThatHasOne) {
    const Told told =
        coreTold(std::string("It is too dark; check the lens and the exposure. 3 stations have no "
                             "photo: near them, views come from farther away. Nobody knows this."));
    EXPECT_EQ(told.cure, Cure::Capture);
    EXPECT_TRUE(told.text.endsWith("Nobody knows this."));
    EXPECT_EQ(coreTold(std::string("Nobody knows this.")).cure, Cure::None);
}

TEST(Told, ValuesOfASentenceAreNoLinks) {
    ToldLabel label;
    label.tell({"<b>1</b> & <a href=\"http://elsewhere\">more</a>", Cure::Align});
    EXPECT_TRUE(label.hasLink());
    EXPECT_EQ(label.text().count("<a "), 1) << label.text().toStdString();
    EXPECT_FALSE(label.text().contains("<b>"));
    EXPECT_TRUE(label.text().contains("spherewalk:align"));
}

TEST(Told, ALabelWithoutACureIsPlainAndTakesNoFocus) {
    ToldLabel label;
    label.tell({"1 < 2", Cure::None});
    EXPECT_EQ(label.text(), "1 < 2");
    EXPECT_FALSE(label.focusPolicy() & Qt::TabFocus);
    label.tell({"There is no photo.", Cure::Capture});
    EXPECT_TRUE(label.focusPolicy() & Qt::TabFocus);
    EXPECT_EQ(label.words(), "There is no photo.");
    label.tell({"1 < 2", Cure::None});
    EXPECT_FALSE(label.focusPolicy() & Qt::TabFocus);
}

TEST(Told, TabAndReturnFollowEachLink) {
    QWidget page;
    QVBoxLayout column(&page);
    QWidget before(&page);
    before.setFocusPolicy(Qt::TabFocus);
    ToldLabel label(&page);
    column.addWidget(&before);
    column.addWidget(&label);
    label.tell(
        QList<Told>{{"No photo.", Cure::Capture}, {"Fine.", Cure::None}, {"Not aligned.", Cure::Align}});
    QSignalSpy links(&label, &QLabel::linkActivated);
    page.show();
    test::activate(page);
    before.setFocus();
    QTest::keyClick(&before, Qt::Key_Tab);
    ASSERT_TRUE(label.hasFocus());
    QTest::keyClick(&label, Qt::Key_Return);
    QTest::keyClick(&label, Qt::Key_Tab);
    QTest::keyClick(&label, Qt::Key_Return);
    ASSERT_EQ(links.size(), 2);
    EXPECT_EQ(links[0][0].toString(), linkTo(Cure::Capture).toString());
    EXPECT_EQ(links[1][0].toString(), linkTo(Cure::Align).toString());
}

} // namespace spherewalk::ui
