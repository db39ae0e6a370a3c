// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shared_store.h"
#include "store_journal.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/camera/capture.h"

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <thread>

namespace spherewalk::jobs {

/// Downloads what the camera has taken, on a thread of its own, while the cart moves on. Its queue
/// is the survey's open shots, so it survives any end of the program. A photo that cannot be fetched now is
/// tried again later, and once more at the end.
class PhotoFetcher {
  public:
    struct Events {
        /// A photo is in the survey; or why not. Called on the fetcher's thread.
        std::function<void(const camera::ShotOutcome&)> ended;
        /// The survey cannot take photos any more. Called on the fetcher's thread; finish() throws why.
        std::function<void()> failed;
    };

    /// Owner: all must outlive the object; the client is for it alone.
    PhotoFetcher(SharedStore& store, camera::OscClient& client, Clock& clock, camera::CaptureOptions options,
                 Events events);
    /// Stops at once; what is not fetched stays in the queue.
    ~PhotoFetcher();
    PhotoFetcher(const PhotoFetcher&) = delete;
    PhotoFetcher& operator=(const PhotoFetcher&) = delete;

    /// There may be something to fetch.
    void wake();

    /// Returns when all is fetched, or has been tried in vain. Errors: what ended it before; Stopped.
    void finish(const std::stop_token& stop);

    /// Asks it to stop, without waiting.
    void stopSoon() { m_thread.request_stop(); }

    /// If something has ended it. Errors: that.
    void throwIfFailed();

  private:
    void run(const std::stop_token& stop);
    bool isRoundDue(const std::stop_token& stop);
    void round(bool isLast, const std::stop_token& stop);
    camera::ShotOutcome fetch(const camera::Shot& shot, const std::stop_token& stop);
    void tell(const camera::ShotOutcome& outcome);

    Events m_events;
    StoreJournal m_journal;
    camera::Capture m_capture;
    std::chrono::milliseconds m_retryPause;
    mutable std::mutex m_mutex;
    std::condition_variable_any m_changed;
    bool m_isWoken = false;
    bool m_isFinishing = false;
    bool m_hasEnded = false;
    std::exception_ptr m_failure;
    std::set<std::int64_t> m_failed; ///< shots that were tried in vain; the fetcher's thread only
    std::jthread m_thread;
};

} // namespace spherewalk::jobs
