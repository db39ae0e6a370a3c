// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/start_page.h"

#include "ui/look/icon.h"
#include "ui/look/side_panel.h"
#include "ui/shell/recent_surveys.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace spherewalk::ui {

namespace {

constexpr int kColumnPx = 560;

QPushButton* makeButton(const QString& objectName, const QString& iconName, const QString& text,
                        const QString& hint, QWidget* parent) {
    auto* button = new QPushButton(ui::icon(iconName), text, parent);
    button->setObjectName(objectName);
    button->setToolTip(hint);
    button->setMinimumHeight(40);
    return button;
}

/// Makes a button the main one of the page, or one of the others.
void setMain(QPushButton& button, bool isMain, const QString& iconName) {
    button.setMinimumHeight(isMain ? 64 : 40);
    button.setIcon(isMain ? QIcon() : ui::icon(iconName));
    button.setStyleSheet({});
    QFont font;
    font.setPointSizeF((isMain ? 1.4 : 1) * font.pointSizeF());
    button.setFont(font);
    if (isMain) {
        makePrimary(&button);
    }
}

} // namespace

StartPage::StartPage(QWidget* parent)
    : QWidget(parent),
      m_recentTitle(new QLabel(tr("Recent surveys"), this)),
      m_recent(new RecentSurveys(this)) {
    auto* column = new QVBoxLayout;
    column->addStretch(1);
    auto* head = new QHBoxLayout;
    auto* picture = new QLabel(this);
    picture->setPixmap(ui::icon("spherewalk").pixmap(96, 96));
    head->addWidget(picture);
    auto* words = new QVBoxLayout;
    auto* name = new QLabel(tr("Spherewalk"), this);
    QFont large = name->font();
    large.setPointSizeF(2.4 * large.pointSizeF());
    large.setBold(true);
    name->setFont(large);
    auto* what = new QLabel(tr("Scan a room with a spherical camera, and let robots see it."), this);
    what->setWordWrap(true);
    words->addWidget(name, 0, Qt::AlignBottom);
    words->addWidget(what, 0, Qt::AlignTop);
    head->addLayout(words, 1);
    column->addLayout(head);
    column->addSpacing(12);

    m_practice =
        makeButton("practiceRoom", "play", tr("&Try the practice room"),
                   tr("Makes a survey of a room that exists only in the program, and photographs it."), this);
    auto* about =
        new QLabel(tr("No camera is needed: the program has one inside, which photographs a furnished room "
                      "while you watch. It takes about a minute."),
                   this);
    about->setWordWrap(true);
    auto* tour = makeButton("tourButton", "play", tr("Take the tour, in five steps"),
                            tr("Leads through all pages with the practice room."), this);
    column->addWidget(m_practice);
    column->addWidget(about);
    column->addWidget(tour);
    column->addSpacing(12);

    m_begin =
        makeButton("newSurvey", "new", tr("&New survey"), tr("Draw a room and lay out its stations."), this);
    m_open = makeButton("openSurvey", "open", tr("&Open a survey..."),
                        tr("A folder whose name ends in .spherewalk."), this);
    auto* row = new QHBoxLayout;
    row->addWidget(m_begin);
    row->addWidget(m_open);
    column->addLayout(row);
    column->addSpacing(12);

    QFont title = m_recentTitle->font();
    title.setBold(true);
    m_recentTitle->setFont(title);
    m_recent->setAccessibleName(tr("Recent surveys"));
    m_recent->setObjectName("recentSurveys");
    column->addWidget(m_recentTitle);
    column->addWidget(m_recent, 12);
    column->addStretch(1);

    auto* frame = new QWidget(this);
    frame->setLayout(column);
    frame->setMaximumWidth(kColumnPx);
    auto* page = new QHBoxLayout(this);
    page->setContentsMargins(24, 32, 24, 24);
    page->addStretch(1);
    page->addWidget(frame, 100);
    page->addStretch(1);
    connect(m_practice, &QPushButton::clicked, this, &StartPage::practiceRequested);
    connect(tour, &QPushButton::clicked, this, &StartPage::tourRequested);
    connect(m_begin, &QPushButton::clicked, this, &StartPage::newRequested);
    connect(m_open, &QPushButton::clicked, this, &StartPage::chooseRequested);
    connect(m_recent, &QListWidget::itemActivated, this,
            [this](const QListWidgetItem* item) { emit openRequested(item->data(Qt::UserRole).toString()); });
}

void StartPage::setRecent(const QStringList& folders) {
    m_recent->list(folders);
    m_recent->setVisible(!folders.isEmpty());
    m_recentTitle->setVisible(!folders.isEmpty());
    setMain(*m_practice, folders.isEmpty(), "play"); // who has surveys knows the practice room
    setMain(*m_begin, !folders.isEmpty(), "new");
    m_open->setMinimumHeight(m_begin->minimumHeight()); // it stands beside
}

} // namespace spherewalk::ui
