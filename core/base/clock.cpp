// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/clock.h"

#include <condition_variable>
#include <mutex>

namespace spherewalk {

namespace {

class SystemClock : public Clock {
  public:
    TimePoint now() const override { return std::chrono::steady_clock::now(); }

    std::chrono::system_clock::time_point utc() const override { return std::chrono::system_clock::now(); }

    bool sleep(Duration duration, const std::stop_token& stop) override {
        std::mutex mutex;
        std::condition_variable_any wakeUp;
        std::unique_lock lock(mutex);
        wakeUp.wait_for(lock, stop, duration, [] { return false; });
        return !stop.stop_requested();
    }
};

} // namespace

Clock& systemClock() {
    static SystemClock clock;
    return clock;
}

} // namespace spherewalk
