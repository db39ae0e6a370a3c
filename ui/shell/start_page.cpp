// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/start_page.h"

#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

namespace spherewalk::ui {

StartPage::StartPage(QWidget* parent) : QWidget(parent), m_recent(new QListWidget(this)) {
    auto* layout = new QVBoxLayout(this);
    auto* open = new QPushButton(tr("Open a survey..."), this);
    open->setObjectName("openSurvey");
    layout->addWidget(open);
    layout->addWidget(new QLabel(tr("Recent surveys"), this));
    layout->addWidget(m_recent);
    m_recent->setAccessibleName(tr("Recent surveys"));
    connect(open, &QPushButton::clicked, this, &StartPage::chooseRequested);
    connect(m_recent, &QListWidget::itemActivated, this,
            [this](const QListWidgetItem* item) { emit openRequested(item->data(Qt::UserRole).toString()); });
}

void StartPage::setRecent(const QStringList& folders) {
    m_recent->clear();
    for (const QString& folder : folders) {
        auto* item = new QListWidgetItem(QFileInfo(folder).completeBaseName(), m_recent);
        item->setData(Qt::UserRole, folder);
        item->setToolTip(QDir::toNativeSeparators(folder));
    }
}

} // namespace spherewalk::ui
