// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>
#include <thread>

namespace spherewalk::program {

/// Turns the first SIGINT or SIGTERM into a request to stop, and the second into the end of the program. It
/// must be made before any other thread, which inherit the blocked signals from it.
class StopOnSignal {
  public:
    StopOnSignal();
    ~StopOnSignal();
    StopOnSignal(const StopOnSignal&) = delete;
    StopOnSignal& operator=(const StopOnSignal&) = delete;

    std::stop_token token() const { return m_stop.get_token(); }

  private:
    std::stop_source m_stop;
    std::jthread m_thread;
};

} // namespace spherewalk::program
