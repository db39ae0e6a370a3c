// SPDX-License-Identifier: GPL-3.0-or-later
#include "qt_application.h"
#include "ui/look/core_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>
#include <gtest/gtest.h>

#include <set>

namespace spherewalk::ui {

namespace {

/// A language that puts what it knows in brackets.
class Bracketed : public QTranslator {
  public:
    bool isEmpty() const override { return false; }

    QString translate(const char* context, const char* source, const char* /*disambiguation*/,
                      int /*n*/) const override {
        const QString words = QString::fromUtf8(source);
        return QString(context) == "spherewalk::ui::CoreWords" ? "[" + words + "]" : QString();
    }
};

class CoreWordsTest : public testing::Test {
  protected:
    CoreWordsTest() {
        QLocale::setDefault(QLocale::c());
        QCoreApplication::installTranslator(&m_language);
    }

    ~CoreWordsTest() override { QCoreApplication::removeTranslator(&m_language); }

    static QString filled(QString sentence, const QString& value) {
        for (int i = 1; i <= 9; ++i) {
            sentence.replace(QString("%%1").arg(i), value + QString::number(i));
        }
        return sentence;
    }

  private:
    Bracketed m_language;
};

} // namespace

TEST_F(CoreWordsTest, EachErrorIsKnownWithAnyValues) {
    for (const char* error : coreErrors()) {
        const QString sentence = filled(QString::fromUtf8(error), "kitchen-");
        EXPECT_EQ(coreWords(sentence), "[" + sentence + "]");
    }
}

TEST_F(CoreWordsTest, EachSentenceOfAnAlignmentIsKnownWithAnyValues) {
    for (const char* said : alignmentSentences()) {
        const QString sentence = filled(QString::fromUtf8(said), "kitchen-");
        EXPECT_EQ(coreWords(sentence), "[" + sentence + "]");
    }
}

TEST_F(CoreWordsTest, EachErrorIsThereOnce) {
    std::set<std::string> all;
    for (const char* error : coreErrors()) {
        EXPECT_TRUE(all.insert(error).second) << error;
    }
}

TEST_F(CoreWordsTest, AValueIsOnlyAValueWhateverItLooksLike) {
    for (const char* value : {"%2", "%1", ".*", "(a|b)", "\\1", "$&"}) {
        const QString sentence = QString("It was exposed for ") + value + " s instead of 7 s; take it again.";
        EXPECT_EQ(coreWords(sentence), "[" + sentence + "]");
    }
}

TEST_F(CoreWordsTest, SentencesAreToldOneByOneAndUnknownOnesStay) {
    EXPECT_EQ(coreWords(QString("It is too dark; check the lens and the exposure. Nobody knows this.")),
              "[It is too dark; check the lens and the exposure.] Nobody knows this.");
}

} // namespace spherewalk::ui
