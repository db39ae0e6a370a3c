// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/camera/live_preview.h"

#include <QImage>
#include <QObject>

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

namespace spherewalk::ui {

/// The camera's live preview: pictures come and are decoded on a thread of its own, and the newest is shown.
/// Threads: the GUI thread, but for endAndWait().
class PreviewFeed : public QObject {
    Q_OBJECT

  public:
    enum class State {
        Off,
        Starting,
        Showing,
        Ended, ///< by the camera, or by an error
    };
    Q_ENUM(State)

    explicit PreviewFeed(QObject* parent = nullptr);
    /// Waits for what runs, which is asked to stop.
    ~PreviewFeed() override;

    /// In place of what runs. timeScale: of a practice camera's times.
    void start(const camera::Endpoint& endpoint, double timeScale, const camera::PreviewOptions& options = {},
               camera::CredentialsSource credentials = {});
    /// Returns at once; no picture comes after it.
    void stop();
    /// Ends the preview and returns when nothing more is asked of the camera; whether there was any. To be
    /// called on another thread.
    bool endAndWait();

    State state() const { return m_state; }

    /// The newest; null before the first.
    const QImage& picture() const { return m_picture; }

    /// Why it has ended; empty if there is nothing wrong.
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
    int m_number = 0; ///< of the preview that counts

    std::mutex m_mutex; ///< guards all below
    std::condition_variable_any m_changed;
    std::optional<Request> m_waiting;
    std::stop_source m_current;
    bool m_isBusy = false;
    QImage m_newest;       ///< null once it has been shown
    std::jthread m_thread; ///< last: it ends before what it uses
};

} // namespace spherewalk::ui
