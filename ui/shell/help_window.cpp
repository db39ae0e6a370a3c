// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/help_window.h"

#include <QAbstractTextDocumentLayout>
#include <QDesktopServices>
#include <QFile>
#include <QMap>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>

/// The linker keeps the resources of a static library only if they are asked for; in no namespace, as Qt
/// wants it.
static void keepGuide() {
    Q_INIT_RESOURCE(guide);
}

namespace spherewalk::ui {

namespace {

constexpr auto kFolder = ":/guide/";

/// A file of the guide and a heading in it.
struct Place {
    QString file;
    QString heading;
};

Place placeOf(const QString& page) {
    static const QMap<QString, Place> kPlaces = {
        {"plan", {"plan-and-capture.md", "Plan"}},
        {"capture", {"plan-and-capture.md", "Capture"}},
        {"review", {"after-capture.md", "Review"}},
        {"align", {"after-capture.md", "Align"}},
        {"connecting", {"plan-and-capture.md", "The camera does not answer"}},
        {"preview", {"after-capture.md", "Preview"}},
        {"export", {"after-capture.md", "Export"}},
    };
    return kPlaces.value(page, {"plan-and-capture.md", {}});
}

} // namespace

HelpWindow::HelpWindow(QWidget* parent) : QDialog(parent), m_text(new QTextBrowser(this)) {
    keepGuide();
    setObjectName("help");
    setWindowTitle(tr("Guide"));
    resize(1020, 760); // its pictures are 960 wide
    m_text->setObjectName("helpText");
    m_text->setAccessibleName(tr("Guide"));
    m_text->setOpenLinks(false);
    m_text->setSearchPaths({kFolder});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_text);
    connect(m_text, &QTextBrowser::anchorClicked, this, &HelpWindow::follow);
}

void HelpWindow::showPage(const QString& page) {
    const Place place = placeOf(page);
    showFile(place.file);
    show();
    raise();
    activateWindow();
    goTo(place.heading);
}

void HelpWindow::showText(const QString& markdown) {
    m_file.clear();
    m_text->setMarkdown(markdown);
    show();
    raise();
    activateWindow();
    goTo({});
}

bool HelpWindow::showFile(const QString& name) {
    QFile file(kFolder + name);
    if (!file.open(QIODevice::ReadOnly)) {
        return false;
    }
    if (name != m_file) {
        m_file = name;
        m_text->setMarkdown(QString::fromUtf8(file.readAll()));
    }
    return true;
}

/// Scrolls so that this heading stands at the top; empty: the beginning.
void HelpWindow::goTo(const QString& heading) {
    const QTextDocument& document = *m_text->document();
    m_heading.clear();
    double at = 0;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        const bool isWanted = heading.isEmpty() || block.text() == heading;
        if (block.blockFormat().headingLevel() > 0 && isWanted) {
            m_heading = block.text();
            at = document.documentLayout()->blockBoundingRect(block).top();
            break;
        }
    }
    m_text->verticalScrollBar()->setValue(static_cast<int>(at));
}

/// Follows a link inside of the guide; the browser of the system opens any other.
void HelpWindow::follow(const QUrl& link) {
    if (link.isRelative() && showFile(link.fileName())) {
        return goTo({});
    }
    if (!link.isRelative()) { // or the window, where it is one of its pages
        QDesktopServices::openUrl(link);
    }
}

} // namespace spherewalk::ui
