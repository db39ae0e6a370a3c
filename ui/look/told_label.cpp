// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/told_label.h"

#include <QDesktopServices>
#include <QFocusEvent>
#include <QUrl>

namespace spherewalk::ui {

ToldLabel::ToldLabel(QWidget* parent) : QLabel(parent) {
    setWordWrap(true);
    setTextFormat(Qt::PlainText);
    setTextInteractionFlags(Qt::TextSelectableByMouse);
    // The window follows its own links, whoever hands them to the desktop.
    connect(this, &QLabel::linkActivated, this,
            [](const QString& link) { QDesktopServices::openUrl(QUrl(link)); });
}

void ToldLabel::tell(const QList<Told>& lines) {
    QStringList plain;
    QStringList rich;
    bool hasLink = false;
    for (const Told& line : lines) {
        plain << line.text;
        rich << line.text.toHtmlEscaped().replace(QLatin1Char('\n'), QStringLiteral("<br>"));
        if (const QUrl link = linkTo(line.cure); !link.isEmpty()) {
            hasLink = true;
            rich.last() += QString(line.isEmpty() ? "<a href=\"%1\">%2</a>" : " <a href=\"%1\">%2</a>")
                               .arg(link.toString(), linkWords(line.cure).toHtmlEscaped());
        }
    }
    m_words = plain.join(QLatin1Char('\n'));
    const Qt::TextFormat format = hasLink ? Qt::RichText : Qt::PlainText;
    if (format != textFormat()) {
        constexpr Qt::TextInteractionFlags kLinks =
            Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard;
        setTextFormat(format);
        setTextInteractionFlags(hasLink ? Qt::TextSelectableByMouse | kLinks
                                        : Qt::TextInteractionFlags(Qt::TextSelectableByMouse));
    }
    setText(hasLink ? rich.join(QStringLiteral("<br>")) : m_words);
    if (hasLink && hasFocus()) { // of what it said before
        QLabel::focusNextPrevChild(true);
    }
}

/// Goes to the first link at once, or to the last one from behind. Else Tab would first stop at the label.
void ToldLabel::focusInEvent(QFocusEvent* event) {
    QLabel::focusInEvent(event);
    if (textFormat() == Qt::RichText &&
        (event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason)) {
        QLabel::focusNextPrevChild(event->reason() == Qt::TabFocusReason);
    }
}

} // namespace spherewalk::ui
