// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/error.h"

#include <cstdio>
#include <functional>
#include <stop_token>
#include <string>
#include <thread>

namespace spherewalk::program {

/// Each program ends with one of these exit statuses.
enum ExitStatus { kDone = 0, kFailed = 1, kUsage = 2, kStopped = 3 };

/// Runs the body and returns its exit status. An exception of the body becomes sentences on standard error
/// and kFailed or kStopped. onError may be empty; otherwise it gets the error before anything is printed.
int guarded(const std::function<int()>& body, const std::function<void(const Error&)>& onError = {});

/// Writes the line and a line feed.
void printLine(std::FILE* stream, const std::string& line);

/// Turns the first SIGINT or SIGTERM into a request to stop. The second one ends the program at once.
/// Threads: a program makes it before its first thread, so that all threads inherit the blocked signals.
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
