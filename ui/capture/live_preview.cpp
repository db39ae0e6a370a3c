// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/live_preview.h"

#include "ui/look/core_words.h"
#include "ui/look/theme.h"
#include "ui/panorama/photo_pictures.h"

#include "spherewalk/base/error.h"
#include "spherewalk/jpeg/jpeg.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
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

Brightness brightnessOf(const QImage& picture) {
    constexpr int kBlackest = 3;    // of 255
    constexpr int kWhitest = 252;   // of 255
    constexpr int kMostAside = 320; // so many pixels beside each other tell enough
    Brightness result;
    const QImage small = picture.width() > kMostAside ? picture.scaledToWidth(kMostAside) : picture;
    const QImage grey =
        small.convertToFormat(QImage::Format_RGB32).convertToFormat(QImage::Format_Grayscale8);
    const double each = 1.0 / std::max(1, grey.width() * grey.height());
    for (int y = 0; y < grey.height(); ++y) {
        const uchar* line = grey.constScanLine(y);
        for (int x = 0; x < grey.width(); ++x) {
            result.shares[line[x] / (256 / result.shares.size())] += each;
            result.black += line[x] <= kBlackest ? each : 0;
            result.white += line[x] >= kWhitest ? each : 0;
        }
    }
    return result;
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
    m_brightness = m_feed.picture().isNull() ? Brightness() : brightnessOf(m_feed.picture());
    setAccessibleDescription(exposureWords());
    update();
}

QString PreviewView::exposureWords() const {
    constexpr double kWorthSaying = 0.01;
    QStringList words;
    if (m_brightness.white >= kWorthSaying) {
        words << tr("%L1 % white").arg(100 * m_brightness.white, 0, 'f', 0);
    }
    if (m_brightness.black >= kWorthSaying) {
        words << tr("%L1 % black").arg(100 * m_brightness.black, 0, 'f', 0);
    }
    return words.join(QStringLiteral(", "));
}

/// Draws the histogram into the corner at the right and below, where a sphere shows the floor.
void PreviewView::paintHistogram(QPainter& painter) const {
    constexpr int kHighPx = 40;
    constexpr int kBarPx = 2;
    constexpr int kGapPx = 6;
    const auto bars = static_cast<int>(m_brightness.shares.size());
    const QRect box(width() - bars * kBarPx - 2 * kGapPx, height() - kHighPx - 2 * kGapPx, bars * kBarPx,
                    kHighPx);
    const QString words = exposureWords();
    const int wordsPx = words.isEmpty() ? 0 : painter.fontMetrics().height();
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 170));
    painter.drawRoundedRect(box.adjusted(-kGapPx, -kGapPx - wordsPx, kGapPx, kGapPx), 4, 4);
    const double most = *std::max_element(m_brightness.shares.begin(), m_brightness.shares.end());
    for (int i = 0; i < bars; ++i) {
        const double share = m_brightness.shares[static_cast<std::size_t>(i)];
        const int high = qRound(kHighPx * std::sqrt(share / most)); // small shares are seen, too
        painter.fillRect(QRect(box.left() + i * kBarPx, box.bottom() + 1 - high, kBarPx, high), Qt::white);
    }
    painter.setPen(doubtfulColour());
    painter.drawText(QRect(box.left(), box.top() - wordsPx, box.width(), wordsPx), Qt::AlignCenter, words);
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
        if (m_feed.state() == PreviewFeed::State::Showing) {
            paintHistogram(painter);
        }
    }
    constexpr int kMarginPx = 8;
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(rect().marginsRemoved({kMarginPx, kMarginPx, kMarginPx, kMarginPx}),
                     Qt::AlignCenter | Qt::TextWordWrap, words());
}

} // namespace spherewalk::ui
