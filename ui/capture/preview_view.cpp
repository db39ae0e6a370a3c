// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/preview_view.h"

#include <QPainter>

namespace spherewalk::ui {

PreviewView::PreviewView(const PreviewFeed& feed, QWidget* parent) : QWidget(parent), m_feed(feed) {
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    setMinimumHeight(80);
    connect(&m_feed, &PreviewFeed::changed, this, &PreviewView::follow);
    follow();
}

QSize PreviewView::sizeHint() const {
    return {320, 160};
}

QString PreviewView::words() const {
    switch (m_feed.state()) {
    case PreviewFeed::State::Off:
        return tr("The preview rests while a picture is taken.");
    case PreviewFeed::State::Starting:
        return tr("Waiting for the camera's first picture...");
    case PreviewFeed::State::Showing:
        return {};
    case PreviewFeed::State::Ended:
        return m_feed.sentence().isEmpty() ? tr("The camera has ended its preview.") : m_feed.sentence();
    }
    return {};
}

void PreviewView::follow() {
    setAccessibleName(m_feed.state() == PreviewFeed::State::Showing ? tr("What the camera sees") : words());
    update();
}

void PreviewView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    const QImage& picture = m_feed.picture();
    if (!picture.isNull()) {
        const QSize size = picture.size().scaled(this->size(), Qt::KeepAspectRatio);
        const QRect place(QPoint((width() - size.width()) / 2, (height() - size.height()) / 2), size);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.setOpacity(m_feed.state() == PreviewFeed::State::Showing ? 1 : 0.4);
        painter.drawImage(place, picture);
        painter.setOpacity(1);
    }
    constexpr int kMarginPx = 8;
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(rect().marginsRemoved({kMarginPx, kMarginPx, kMarginPx, kMarginPx}),
                     Qt::AlignCenter | Qt::TextWordWrap, words());
}

} // namespace spherewalk::ui
