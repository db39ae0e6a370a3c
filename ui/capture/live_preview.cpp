// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/live_preview.h"

#include "ui/look/core_words.h"
#include "ui/panorama/photo_pictures.h"

#include "spherewalk/base/error.h"
#include "spherewalk/jpeg/jpeg.h"

#include <QPainter>

#include <utility>

namespace spherewalk::ui {

PreviewFeed::PreviewFeed(QObject* parent)
    : QObject(parent), m_thread([this](const std::stop_token& end) { run(end); }) {
}

PreviewFeed::~PreviewFeed() {
    stop();
    m_thread.request_stop();
    m_thread.join();
}

void PreviewFeed::setState(State state) {
    m_state = state;
    emit changed();
}

void PreviewFeed::start(const camera::Endpoint& endpoint, double timeScale,
                        const camera::PreviewOptions& options, camera::CredentialsSource credentials) {
    ++m_number;
    m_sentence.clear();
    m_picture = {};
    {
        const std::scoped_lock lock(m_mutex);
        m_waiting = Request{endpoint, timeScale, options, std::move(credentials), m_number};
        m_current.request_stop();
    }
    m_changed.notify_all();
    setState(State::Starting);
}

void PreviewFeed::stop() {
    ++m_number; // what is still on its way counts for nothing
    {
        const std::scoped_lock lock(m_mutex);
        m_waiting.reset();
        m_current.request_stop();
    }
    if (m_state != State::Off) {
        setState(State::Off);
    }
}

bool PreviewFeed::endAndWait() {
    std::unique_lock lock(m_mutex);
    const bool wasBusy = m_isBusy;
    m_waiting.reset();
    m_current.request_stop();
    m_changed.wait(lock, [this] { return !m_isBusy; });
    return wasBusy;
}

void PreviewFeed::run(const std::stop_token& end) {
    std::unique_lock lock(m_mutex);
    while (m_changed.wait(lock, end, [this] { return m_waiting.has_value(); })) {
        const Request request = *std::exchange(m_waiting, std::nullopt);
        m_current = std::stop_source();
        const std::stop_token stop = m_current.get_token();
        m_isBusy = true;
        m_newest = {};
        lock.unlock();
        const QString sentence = show(request, stop);
        QMetaObject::invokeMethod(
            this, [this, number = request.number, sentence] { ended(number, sentence); },
            Qt::QueuedConnection);
        lock.lock();
        m_isBusy = false;
        m_changed.notify_all();
    }
}

/// Shows a preview until it ends. Returns why it failed; empty if it did not.
QString PreviewFeed::show(const Request& request, const std::stop_token& stop) {
    try {
        camera::OscOptions options = camera::OscOptions{}.scaled(request.timeScale);
        options.http.credentials = request.credentials;
        camera::OscClient client(request.endpoint, options, systemClock());
        const auto pictures = camera::showLivePreview(
            client, systemClock(), request.options.scaled(request.timeScale),
            [&](const camera::PreviewFrame& frame) { publish(request.number, frame); }, stop);
        return pictures > 0 ? QString() : tr("The camera sent no picture; start the preview again.");
    } catch (const Error& error) {
        return error.kind() == ErrorKind::Stopped ? QString() : coreWords(error.sentence());
    }
}

void PreviewFeed::publish(int number, const camera::PreviewFrame& frame) {
    QImage picture;
    try {
        picture = qtImage(jpeg::decode(frame.jpeg, "the preview"));
    } catch (const Error&) { // damaged on its way; the next comes at once
        return;
    }
    const std::scoped_lock lock(m_mutex);
    const bool isToBeTold = m_newest.isNull(); // else the window has not yet taken the one before
    m_newest = std::move(picture);
    if (isToBeTold) {
        QMetaObject::invokeMethod(
            this, [this, number] { showNewest(number); }, Qt::QueuedConnection);
    }
}

void PreviewFeed::showNewest(int number) {
    QImage picture;
    {
        const std::scoped_lock lock(m_mutex);
        picture = std::exchange(m_newest, {});
    }
    if (number == m_number && !picture.isNull()) {
        m_picture = std::move(picture);
        setState(State::Showing);
    }
}

void PreviewFeed::ended(int number, const QString& sentence) {
    if (number == m_number) {
        m_sentence = sentence;
        setState(State::Ended);
    }
}

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
