// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/theme.h"

#include <QApplication>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleOption>

namespace spherewalk::ui {

namespace {

/// The colours of one theme.
struct Colours {
    QColor window;
    QColor base;
    QColor raised;
    QColor text;
    QColor faint;
    QColor line;
    QColor highlight;
    QColor highlightedText;
};

QPalette paletteOf(const Colours& colours) {
    QPalette palette(colours.raised, colours.window);
    palette.setColor(QPalette::Window, colours.window);
    palette.setColor(QPalette::WindowText, colours.text);
    palette.setColor(QPalette::Base, colours.base);
    palette.setColor(QPalette::AlternateBase, colours.raised);
    palette.setColor(QPalette::Text, colours.text);
    palette.setColor(QPalette::Button, colours.raised);
    palette.setColor(QPalette::ButtonText, colours.text);
    palette.setColor(QPalette::BrightText, colours.highlightedText);
    palette.setColor(QPalette::ToolTipBase, colours.raised);
    palette.setColor(QPalette::ToolTipText, colours.text);
    palette.setColor(QPalette::PlaceholderText, colours.faint);
    palette.setColor(QPalette::Mid, colours.line);
    palette.setColor(QPalette::Highlight, colours.highlight);
    palette.setColor(QPalette::HighlightedText, colours.highlightedText);
    palette.setColor(QPalette::Link, colours.highlight);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        palette.setColor(QPalette::Disabled, role, colours.faint);
    }
    palette.setColor(QPalette::Disabled, QPalette::Highlight, colours.line);
    return palette;
}

QPalette lightPalette() {
    return paletteOf({.window = "#f3f4f6",
                      .base = "#ffffff",
                      .raised = "#e9ebef",
                      .text = "#1c2430",
                      .faint = "#7c8594",
                      .line = "#b4bac4",
                      .highlight = "#0b62b3",
                      .highlightedText = "#ffffff"});
}

QPalette darkPalette() {
    return paletteOf({.window = "#1e2329",
                      .base = "#151a1f",
                      .raised = "#2b323a",
                      .text = "#e6eaf0",
                      .faint = "#8a94a2",
                      .line = "#59626e",
                      .highlight = "#56a8ea",
                      .highlightedText = "#0c1116"});
}

bool desktopIsDark() {
    static const bool isDark =
        QApplication::palette().color(QPalette::Window).lightness() < 128; // before ours
    return isDark;
}

/// Fusion with frames of check boxes and radio buttons that are seen in the dark as well.
class FramedStyle : public QProxyStyle {
  public:
    FramedStyle() : QProxyStyle("Fusion") {}

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        if (element != PE_IndicatorCheckBox && element != PE_IndicatorRadioButton) {
            return;
        }
        painter->save();
        painter->setPen(option->palette.color(QPalette::PlaceholderText));
        painter->setBrush(Qt::NoBrush);
        if (element == PE_IndicatorCheckBox) {
            painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
        } else {
            painter->setRenderHint(QPainter::Antialiasing);
            painter->drawEllipse(QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5));
        }
        painter->restore();
    }
};

} // namespace

void applyTheme(Theme theme) {
    const bool isDark = theme == Theme::Dark || (theme == Theme::System && desktopIsDark());
    QApplication::setStyle(new FramedStyle);
    QApplication::setPalette(isDark ? darkPalette() : lightPalette());
    for (QWidget* widget : QApplication::allWidgets()) {
        if (const QString sheet = widget->styleSheet(); !sheet.isEmpty()) {
            widget->setStyleSheet({}); // a style sheet keeps the colours of the palette that it met first
            widget->setStyleSheet(sheet);
        }
    }
}

QColor goodColour() {
    return {0, 158, 115};
}

QColor doubtfulColour() {
    return {230, 159, 0};
}

QColor failedColour() {
    return {213, 94, 0};
}

QRectF paintPlate(QPainter& painter, const QRectF& within, Qt::Alignment alignment, const QString& text) {
    constexpr double kNarrowestPx = 40;
    const QRectF inside = within.adjusted(16, 10, -16, -10);
    if (text.isEmpty() || inside.width() < kNarrowestPx) {
        return {};
    }
    const int flags = static_cast<int>(alignment) | Qt::TextWordWrap;
    painter.setPen(Qt::white); // before measuring: without a pen, text has no size
    const QRectF box = painter.boundingRect(inside, flags, text);
    const QRectF plate = box.adjusted(-8, -4, 8, 4);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 170));
    painter.drawRoundedRect(plate, 5, 5);
    painter.setPen(Qt::white);
    painter.drawText(box, flags, text);
    return plate;
}

} // namespace spherewalk::ui
