// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/camera/live_preview.h"

#include <QImage>
#include <QObject>
#include <QWidget>

#include <array>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

namespace spherewalk::ui {

/// The camera's live preview. A thread of its own receives and decodes the pictures, and the newest one is
/// kept. Threads: the GUI thread, except for endAndWait().
class PreviewFeed : public QObject {
    Q_OBJECT

  public:
    enum class State {
        Off,
        Starting,
        Showing,
        Ended, ///< The camera or an error ended the preview.
    };
    Q_ENUM(State)

    explicit PreviewFeed(QObject* parent = nullptr);
    /// Stops the preview and waits for its end.
    ~PreviewFeed() override;

    /// Starts a preview in place of the one that is on. timeScale: factor on the times of a practice camera.
    void start(const camera::Endpoint& endpoint, double timeScale, const camera::PreviewOptions& options = {},
               camera::CredentialsSource credentials = {});
    /// Ends the preview. Returns at once; no picture follows.
    void stop();
    /// Ends the preview and waits until the camera gets no more requests. Returns whether a preview was on.
    /// Threads: any but the GUI thread.
    bool endAndWait();

    State state() const { return m_state; }

    /// Returns the newest picture; null before the first one.
    const QImage& picture() const { return m_picture; }

    /// Says why the preview has ended; empty if nothing went wrong.
    const QString& sentence() const { return m_sentence; }

  signals:
    void changed();

  private:
    struct Request {
        camera::Endpoint endpoint;
        double timeScale = 1;
        camera::PreviewOptions options;
        camera::CredentialsSource credentials;
        int number = 0;
    };

    void run(const std::stop_token& end);
    QString show(const Request& request, const std::stop_token& stop);
    void publish(int number, const camera::PreviewFrame& frame);
    void showNewest(int number);
    void ended(int number, const QString& sentence);
    void setState(State state);

    State m_state = State::Off;
    QImage m_picture;
    QString m_sentence;
    int m_number = 0; ///< Number of the latest preview; others are ignored.

    std::mutex m_mutex; ///< Guards all members below.
    std::condition_variable_any m_changed;
    std::optional<Request> m_waiting;
    std::stop_source m_current;
    bool m_isBusy = false;
    QImage m_newest;       ///< Null once it has been shown.
    std::jthread m_thread; ///< The last member, as it uses the others until it ends.
};

/// How bright a picture is.
struct Brightness {
    std::array<double, 64> shares{}; ///< Of the pixels, in equal steps from black to white.
    double black = 0;                ///< Share of pixels in which the dark has no detail left.
    double white = 0;                ///< Share of pixels in which the light has no detail left.
};

/// Returns the brightness of a picture; all 0 for an empty one. Source: ITU-R BT.601 for the weights of
/// colours.
Brightness brightnessOf(const QImage& picture);

/// Shows the newest picture of a live preview with its histogram, or a sentence in its place.
class PreviewView : public QWidget {
    Q_OBJECT

  public:
    explicit PreviewView(const PreviewFeed& feed, QWidget* parent = nullptr);

    QSize sizeHint() const override;

    bool hasHeightForWidth() const override { return true; }

    int heightForWidth(int width) const override { return width / 2; }

    /// Returns the sentence that stands in place of a picture; empty while pictures come.
    QString words() const;

    /// Returns what the histogram shows.
    const Brightness& brightness() const { return m_brightness; }

    /// Says how much of the picture is too dark or too bright; empty if little is.
    QString exposureWords() const;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void follow();
    void paintHistogram(QPainter& painter) const;

    const PreviewFeed& m_feed;
    Brightness m_brightness;
};

} // namespace spherewalk::ui
