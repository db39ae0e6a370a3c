// SPDX-License-Identifier: GPL-3.0-or-later
#include "qt_application.h"
#include "ui/look/core_words.h"
#include "ui/look/icon.h"
#include "ui/look/side_panel.h"
#include "ui/look/theme.h"
#include "ui/look/words.h"

#include <QApplication>
#include <QCheckBox>
#include <QDir>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPalette>
#include <QPushButton>
#include <QToolBar>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace spherewalk::ui {

namespace {

/// Relative luminance. Source: WCAG 2.1.
double luminance(const QColor& colour) {
    const auto linear = [](double value) {
        return value <= 0.03928 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

/// Contrast ratio in [1, 21]. Source: WCAG 2.1.
double contrast(const QColor& a, const QColor& b) {
    const auto [dark, light] = std::minmax({luminance(a), luminance(b)});
    return (light + 0.05) / (dark + 0.05);
}

QImage drawn(const QIcon& icon, QIcon::Mode mode, QIcon::State state = QIcon::Off) {
    return icon.pixmap(QSize(32, 32), mode, state).toImage();
}

QRectF plateAt(Qt::Alignment alignment, const QString& text, const QSize& size = {300, 200}) {
    QImage canvas(size, QImage::Format_RGB32);
    QPainter painter(&canvas);
    return paintPlate(painter, QRectF(canvas.rect()), alignment, text);
}

std::string inWords(double seconds) {
    return durationText(std::chrono::duration<double>(seconds)).toStdString();
}

constexpr Standing kStandings[] = {Standing::Missing,  Standing::Taken,  Standing::Accepted,
                                   Standing::Doubtful, Standing::Failed, Standing::Rejected};

} // namespace

TEST(Icon, EveryDrawingOfTheProgramCanBeShown) {
    ASSERT_FALSE(icon("capture").isNull()); // registers the resources
    const QStringList names = QDir(":/icons").entryList({"*.svg"});
    ASSERT_FALSE(names.isEmpty());
    for (const QString& name : names) {
        const QImage picture = drawn(icon(name.chopped(4)), QIcon::Normal);
        QImage empty(picture.size(), picture.format());
        empty.fill(Qt::transparent);
        EXPECT_NE(picture, empty) << name.toStdString();
    }
}

TEST(Icon, AnUnknownNameGivesAnEmptyIcon) {
    EXPECT_TRUE(icon("no such icon").isNull());
}

TEST(Icon, TellsDisabledAndSwitchedOnByColour) {
    const QIcon stop = icon("stop");
    const QImage normal = drawn(stop, QIcon::Normal);
    EXPECT_NE(drawn(stop, QIcon::Disabled), normal);
    EXPECT_NE(drawn(stop, QIcon::Normal, QIcon::On), normal);
}

TEST(Icon, AColouredIconHasNoOtherColour) {
    const QImage picture = colouredIcon("good", Qt::red, 36).toImage();
    int solid = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const QColor pixel = picture.pixelColor(x, y);
            if (pixel.alpha() == 255) {
                EXPECT_EQ(pixel, QColor(Qt::red));
                ++solid;
            }
        }
    }
    EXPECT_GT(solid, 0);
}

TEST(IconLabel, AnEmptyNameShowsNothing) {
    IconLabel label("good", 24);
    const QImage shown = label.grab().toImage();
    label.setIcon(QString());
    EXPECT_NE(label.grab().toImage(), shown);
    EXPECT_EQ(label.size(), QSize(24, 24));
}

TEST(Theme, TextIsReadableInLightAndDark) {
    for (const Theme theme : {Theme::Light, Theme::Dark}) {
        applyTheme(theme);
        const QPalette palette = QApplication::palette();
        using Role = QPalette::ColorRole;
        for (const auto& [text, ground] : {std::pair{Role::WindowText, Role::Window},
                                           {Role::Text, Role::Base},
                                           {Role::ButtonText, Role::Button},
                                           {Role::HighlightedText, Role::Highlight}}) {
            constexpr double kLeastForText = 4.5;
            EXPECT_GE(contrast(palette.color(text), palette.color(ground)), kLeastForText) << int(text);
        }
    }
    applyTheme(Theme::System);
}

TEST(Theme, ADarkWindowIsDarkerThanItsText) {
    applyTheme(Theme::Dark);
    const QPalette dark = QApplication::palette();
    applyTheme(Theme::Light);
    EXPECT_LT(luminance(dark.color(QPalette::Window)), luminance(dark.color(QPalette::WindowText)));
    EXPECT_GT(luminance(QApplication::palette().color(QPalette::Window)),
              luminance(dark.color(QPalette::Window)));
    applyTheme(Theme::System);
}

TEST(Theme, OpenWidgetsWithAStyleSheetChangeWithIt) {
    applyTheme(Theme::Light);
    QPushButton button("Go");
    button.resize(120, 40);
    makePrimary(&button);
    QToolBar bar;
    bar.setStyleSheet("QToolBar { background: palette(window); border: none; }");
    bar.resize(60, 60);
    button.grab();
    bar.grab();
    applyTheme(Theme::Dark);
    const QPalette dark = QApplication::palette();
    EXPECT_EQ(button.grab().toImage().pixelColor(12, 20), dark.color(QPalette::Highlight));
    EXPECT_EQ(bar.grab().toImage().pixelColor(50, 50), dark.color(QPalette::Window));
    applyTheme(Theme::System);
}

TEST(Theme, ACheckBoxHasAFrameInTheDark) {
    applyTheme(Theme::Dark);
    QCheckBox box("Shoot by itself");
    box.resize(box.sizeHint());
    const QImage shown = box.grab().toImage();
    double best = 1;
    for (int x = 0; x < 8; ++x) {
        best = std::max(best, contrast(shown.pixelColor(x, shown.height() / 2),
                                       QApplication::palette().color(QPalette::Window)));
    }
    constexpr double kLeastForControls = 3;
    EXPECT_GE(best, kLeastForControls);
    applyTheme(Theme::System);
}

TEST(Plate, IsEmptyWithoutATextOrWithoutRoom) {
    EXPECT_TRUE(plateAt(Qt::AlignCenter, "").isEmpty());
    EXPECT_TRUE(plateAt(Qt::AlignCenter, "words", {60, 200}).isEmpty());
}

TEST(Plate, LiesAtItsSideAndWithinTheArea) {
    const QRectF area(0, 0, 300, 200);
    for (const auto side : {Qt::AlignLeft, Qt::AlignRight, Qt::AlignHCenter}) {
        EXPECT_TRUE(area.contains(plateAt(side | Qt::AlignTop, "some words"))) << int(side);
    }
    EXPECT_LT(plateAt(Qt::AlignLeft | Qt::AlignTop, "some words").right(),
              plateAt(Qt::AlignRight | Qt::AlignTop, "some words").left());
    EXPECT_LT(plateAt(Qt::AlignLeft | Qt::AlignTop, "some words").bottom(),
              plateAt(Qt::AlignLeft | Qt::AlignBottom, "some words").top());
}

TEST(Section, ARowIsNamedAndExplainedToScreenReaders) {
    Section section("Camera");
    QLineEdit field;
    section.addRow(section.addForm(), "&Address", &field, "With a port.");
    EXPECT_EQ(section.title()->text(), "Camera");
    EXPECT_EQ(field.accessibleName(), "Address");
    EXPECT_EQ(field.accessibleDescription(), "With a port.");
    EXPECT_EQ(field.toolTip(), "With a port.");
}

TEST(Section, ItsWordsCanBeSelected) {
    Section section("Camera");
    EXPECT_TRUE(section.addWords()->textInteractionFlags().testFlag(Qt::TextSelectableByMouse));
}

TEST(ColumnScrollArea, IsNeverNarrowerThanItsControls) {
    auto* column = new QWidget;
    ColumnScrollArea area(column);
    column->setMinimumWidth(150);
    const int before = area.minimumSizeHint().width();
    EXPECT_GT(before, 0);
    auto* layout = new QHBoxLayout(column);
    auto* wide = new QLabel(column);
    wide->setMinimumWidth(400);
    layout->addWidget(wide);
    EXPECT_GE(area.minimumSizeHint().width(), 400);
}

TEST(PrimaryButton, HasTheColourOfTheHighlight) {
    QPushButton button("Go");
    button.resize(120, 40);
    makePrimary(&button);
    EXPECT_EQ(button.grab().toImage().pixelColor(12, 20), button.palette().color(QPalette::Highlight));
}

TEST(Words, DurationsHaveTheUnitOfTheirLength) {
    EXPECT_EQ(inWords(-3), "0 s");
    EXPECT_EQ(inWords(45.4), "45 s");
    EXPECT_EQ(inWords(119), "119 s");
    EXPECT_EQ(inWords(120), "2 min");
    EXPECT_EQ(inWords(18 * 60), "18 min");
    EXPECT_EQ(inWords(2 * 3600 + 17 * 60), "2 h 17 min");
}

TEST(Words, BytesArePowersOfTen) {
    QLocale::setDefault(QLocale::c());
    EXPECT_EQ(bytesText(512), "512 bytes");
    EXPECT_EQ(bytesText(4'200'000), "4.2 MB");
}

TEST(Words, EachStandingHasAWordAndASignOfItsOwn) {
    std::set<QString> words;
    std::set<QString> signs;
    for (const Standing standing : kStandings) {
        words.insert(standingText(standing));
        signs.insert(standingSign(standing));
    }
    EXPECT_EQ(words.size(), std::size(kStandings));
    EXPECT_EQ(signs.size(), std::size(kStandings));
}

TEST(CoreWords, KeepTheSentenceWhereThereIsNoTranslation) {
    QLocale::setDefault(QLocale::c());
    for (const char* sentence :
         {"It is too dark; check the lens and the exposure.",
          "It is 1.8 stops darker than its neighbours; check the exposure and the lamps.",
          "4.7 % of it is black; check that nothing covers a lens. It is too bright; check the exposure.",
          "Nobody knows this sentence. Nor this one, 1.5 m away."}) {
        EXPECT_EQ(coreWords(std::string(sentence)), QString(sentence));
    }
}

} // namespace spherewalk::ui
