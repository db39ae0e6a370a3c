// SPDX-License-Identifier: GPL-3.0-or-later
// Every page in every language at the smallest size: nothing is cut off, and each letter opens one thing.
#include "photographed_survey.h"
#include "qt_application.h"
#include "ui/frame/mode.h"
#include "ui/frame/settings.h"
#include "ui/look/core_words.h"
#include "ui/shell/application.h"
#include "ui/shell/main_window.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/camera/endpoint.h"
#include "spherewalk/camera/osc_error.h"
#include "spherewalk/photo/metadata.h"
#include "spherewalk/photo/verdict.h"

#include <QAbstractButton>
#include <QAccessible>
#include <QAction>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSet>
#include <QTest>
#include <QToolButton>
#include <QTranslator>
#include <gtest/gtest.h>

#include <functional>
#include <map>

namespace spherewalk::ui {

namespace {

constexpr QSize kSmallest(1024, 700);

class LanguagesTest : public testing::TestWithParam<const char*> {
  protected:
    LanguagesTest() {
        EXPECT_TRUE(loadWords(m_words, QLocale(GetParam())));
        QCoreApplication::installTranslator(&m_words);
    }

    ~LanguagesTest() override { QCoreApplication::removeTranslator(&m_words); }

    /// Shows each page in turn, and the start page first.
    template <class Law>
    void onPages(Law&& law) {
        const test::PhotographedSurvey survey(6, 512);
        MainWindow window;
        window.resize(kSmallest);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
        law(window, QStringLiteral("start"));
        ASSERT_TRUE(window.openSurvey(QString::fromStdString(survey.path().string())));
        for (Mode* mode : window.modes()) {
            window.showMode(mode);
            QTest::qWait(0);
            ASSERT_TRUE(QTest::qWaitFor([&] { return !window.tasks().hasRunning(); }, 100'000));
            law(window, mode->objectName());
        }
    }

  private:
    QTranslator m_words;
};

QString textOf(const QWidget& widget) {
    const auto* label = qobject_cast<const QLabel*>(&widget);
    const auto* button = qobject_cast<const QAbstractButton*>(&widget);
    return label != nullptr ? label->text() : button != nullptr ? button->text() : QString();
}

bool isCutOff(const QWidget& widget) {
    const QRect seen = widget.visibleRegion().boundingRect();
    if (!seen.isEmpty() && seen.width() < widget.width()) { // its column is narrower than it
        return !textOf(widget).isEmpty();
    }
    if (const auto* label = qobject_cast<const QLabel*>(&widget); label != nullptr) {
        if (label->text().isEmpty()) {
            return false;
        }
        return label->wordWrap() ? label->heightForWidth(label->width()) > label->height() + 1
                                 : label->sizeHint().width() > label->width() + 1;
    }
    return qobject_cast<const QAbstractButton*>(&widget) != nullptr &&
           widget.sizeHint().width() > widget.width() + 1;
}

/// The texts that are cut off now, with what their widgets need.
QStringList cutOff(const QWidget& window) {
    QStringList found;
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        const bool isOfQt = widget->objectName().startsWith("qt_"); // buttons of a dock's title
        if (widget->isVisible() && !isOfQt && isCutOff(*widget)) {
            found << QString("%1 \"%2\" has %3 x %4 of %5 x %6")
                         .arg(widget->objectName(), textOf(*widget))
                         .arg(widget->width())
                         .arg(widget->height())
                         .arg(widget->sizeHint().width())
                         .arg(widget->sizeHint().height());
        }
    }
    return found;
}

/// Where a mnemonic of a label goes, or the button itself; null for others.
const QWidget* mnemonicTarget(const QWidget& widget) {
    const auto* label = qobject_cast<const QLabel*>(&widget);
    return label != nullptr ? label->buddy() : qobject_cast<const QAbstractButton*>(&widget);
}

} // namespace

TEST_P(LanguagesTest, NoTextIsCutOffInASmallWindow) {
    onPages([](const MainWindow& window, const QString& page) {
        for (const Mode* mode : window.modes()) {
            EXPECT_LE(mode->minimumSizeHint().width(), kSmallest.width() - 100)
                << mode->objectName().toStdString();
            EXPECT_LE(mode->minimumSizeHint().height(), kSmallest.height() - 50)
                << mode->objectName().toStdString();
        }
        EXPECT_EQ(window.size(), kSmallest) << page.toStdString();
        EXPECT_TRUE(QTest::qWaitFor([&] { return cutOff(window).isEmpty(); }, 3000)) // the layout takes turns
            << page.toStdString() << ": " << cutOff(window).join("; ").toStdString();
    });
}

TEST_P(LanguagesTest, EachPageFitsAScreenThatIsShownAtTwiceItsSize) {
    constexpr QSize kHalfOfFullHd(960, 540);
    onPages([&](MainWindow& window, const QString& page) {
        const auto fits = [&] {
            window.resize(kHalfOfFullHd); // once more when the layout has settled
            return window.size() == kHalfOfFullHd;
        };
        EXPECT_TRUE(QTest::qWaitFor(fits, 1000))
            << page.toStdString() << " needs " << window.minimumSizeHint().width() << " x "
            << window.minimumSizeHint().height();
    });
}

TEST_P(LanguagesTest, EachLetterOpensOneThing) {
    onPages([](const MainWindow& window, const QString& page) {
        std::map<QString, QString> taken; // by letter
        const auto take = [&](const QString& text) {
            const QString letter = QKeySequence::mnemonic(text).toString();
            if (!letter.isEmpty()) {
                EXPECT_TRUE(taken.emplace(letter, text).second)
                    << page.toStdString() << ": " << text.toStdString() << " and "
                    << taken[letter].toStdString();
            }
        };
        for (const QAction* action : window.menuBar()->actions()) {
            take(action->text());
        }
        for (const QWidget* widget : window.findChildren<QWidget*>()) {
            const QWidget* target = mnemonicTarget(*widget);
            if (target != nullptr && widget->isVisible()) {
                take(textOf(*widget));
            }
        }
    });
}

/// What AT-SPI hands on to a screen reader.
TEST_P(LanguagesTest, WhatTakesTheFocusHasANameAndARole) {
    onPages([](const MainWindow& window, const QString& page) {
        for (QWidget* widget : window.findChildren<QWidget*>()) {
            if (!widget->isVisible() || (widget->focusPolicy() & Qt::TabFocus) == 0 ||
                widget->focusProxy() != nullptr) {
                continue;
            }
            const QString what =
                QString("%1: %2 %3").arg(page, widget->metaObject()->className(), widget->objectName());
            QAccessibleInterface* interface = QAccessible::queryAccessibleInterface(widget);
            ASSERT_NE(interface, nullptr) << what.toStdString();
            EXPECT_FALSE(interface->text(QAccessible::Name).isEmpty()) << what.toStdString();
            EXPECT_NE(interface->role(), QAccessible::NoRole) << what.toStdString();
            EXPECT_NE(interface->role(), QAccessible::Client) << what.toStdString();
        }
    });
}

TEST_P(LanguagesTest, AltAndItsLetterOpensEachMenuOnEachPage) {
    const test::PhotographedSurvey survey(3, 512);
    for (int page = 0; page < 6; ++page) {
        MainWindow window; // one for each page: a menu that was left keeps the menu bar waiting
        window.show();
        ASSERT_TRUE(window.openSurvey(QString::fromStdString(survey.path().string())));
        window.showMode(window.modes().at(page));
        for (const QAction* action : window.menuBar()->actions()) {
            test::activate(window);
            const int key = QKeySequence::mnemonic(action->text())[0].key();
            QTest::keyClick(&window, static_cast<Qt::Key>(key), Qt::AltModifier);
            EXPECT_EQ(QApplication::activePopupWidget(), action->menu())
                << page << ": " << action->text().toStdString();
            action->menu()->close();
        }
    }
}

TEST_P(LanguagesTest, NoLetterOfAMenuOpensSomethingThatAPageMayShow) {
    onPages([](const MainWindow& window, const QString& page) {
        QSet<QKeySequence> menus;
        for (const QAction* action : window.menuBar()->actions()) {
            menus.insert(QKeySequence::mnemonic(action->text()));
        }
        EXPECT_FALSE(menus.contains(QKeySequence()));
        for (const QWidget* widget : window.findChildren<QWidget*>()) { // hidden ones, too
            const QWidget* target = mnemonicTarget(*widget);
            EXPECT_FALSE(target != nullptr && menus.contains(QKeySequence::mnemonic(textOf(*widget))))
                << page.toStdString() << ": " << textOf(*widget).toStdString();
        }
    });
}

/// What the checks of photos say, in the words of the core.
std::vector<std::string> sentencesOfTheCore() {
    std::vector<std::string> sentences;
    photo::Sketch dark;
    dark.width = 1024;
    dark.brightness = 0;
    photo::ExpectedSettings expected;
    expected.width = 2048;
    expected.iso = 100;
    expected.exposureS = 0.01;
    expected.hasFixedWhiteBalance = true;
    photo::PhotoMetadata metadata;
    metadata.iso = 400;
    metadata.exposureS = 0.1;
    metadata.hasFixedWhiteBalance = false;
    for (const photo::Finding& finding : photo::judge(dark, metadata, expected, {}).findings) {
        sentences.push_back(finding.sentence);
    }
    return sentences;
}

/// What stops people on their first day, in the words of the core.
std::vector<std::string> errorsOfTheCore() {
    const test::TemporaryFolder folder;
    const survey::Room bow{{{0, 0}, {4, 3}, {4, 0}, {0, 3}}, {}, 2.5};
    const std::vector<std::function<void()>> mistakes = {
        [&] { store::SurveyStore::open(folder / "nothing.spherewalk", store::Access::Read); },
        [&] { store::SurveyStore::open(folder.path(), store::Access::Read); },
        [&] { readFile(folder / "nothing.jpg"); },
        [&] { bow.validate(); },
        [&] { camera::parseEndpoint("http://"); },
        [&] {
            survey::plan({{{0, 0}, {4, 0}, {4, 3}}, {}, 2.5}, {.heightsM = {3}});
        },
        [&] { throw camera::refusal("take the photo", camera::OscErrorCode::StorageFull, ""); },
    };
    std::vector<std::string> sentences;
    for (const auto& mistake : mistakes) {
        try {
            mistake();
            ADD_FAILURE() << sentences.size() << " is no mistake";
        } catch (const Error& error) {
            sentences.push_back(error.sentence());
        }
    }
    return sentences;
}

TEST_P(LanguagesTest, TheCoreSpeaksItToo) {
    const std::vector<std::string> sentences = sentencesOfTheCore();
    EXPECT_GE(sentences.size(), 5U);
    for (const std::string& sentence : sentences) {
        const bool isEnglish = std::string(GetParam()) == "en";
        EXPECT_EQ(coreWords(sentence) == QString::fromStdString(sentence), isEnglish) << sentence;
    }
}

TEST_P(LanguagesTest, ErrorsOfTheCoreAreToldInIt) {
    const bool isEnglish = std::string(GetParam()) == "en";
    for (const std::string& sentence : errorsOfTheCore()) {
        const QString told = coreWords(sentence);
        EXPECT_EQ(told == QString::fromStdString(sentence), isEnglish) << sentence;
        static const QRegularExpression english("\\b(the|cannot|could|there)\\b");
        EXPECT_FALSE(!isEnglish && told.contains(english)) << told.toStdString();
    }
}

INSTANTIATE_TEST_SUITE_P(All, LanguagesTest, testing::Values("en", "de", "pl"),
                         [](const auto& language) { return std::string(language.param); });

TEST(Languages, AreChosenInTheMenu) {
    MainWindow window;
    auto* german = window.findChild<QAction*>("language-de");
    ASSERT_NE(german, nullptr);
    german->trigger();
    EXPECT_EQ(Settings().language(), "de");
    EXPECT_TRUE(german->isChecked());
    window.findChild<QAction*>("language-")->trigger();
    EXPECT_EQ(Settings().language(), QString());
}

} // namespace spherewalk::ui
