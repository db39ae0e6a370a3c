// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/stop_on_signal.h"

#include "program/program.h"

#include <csignal>
#include <ctime>
#include <unistd.h>

namespace spherewalk::program {

namespace {

sigset_t stopSignals() {
    sigset_t signals;
    ::sigemptyset(&signals);
    ::sigaddset(&signals, SIGINT);
    ::sigaddset(&signals, SIGTERM);
    return signals;
}

} // namespace

StopOnSignal::StopOnSignal() {
    const sigset_t signals = stopSignals();
    ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    ::signal(SIGPIPE, SIG_IGN); // a broken pipe and a file size limit are errors of the call
    ::signal(SIGXFSZ, SIG_IGN);
    m_thread = std::jthread([this](const std::stop_token& end) {
        const sigset_t waitedFor = stopSignals();
        const timespec interval{0, 100'000'000};
        int count = 0;
        while (!end.stop_requested()) {
            if (::sigtimedwait(&waitedFor, nullptr, &interval) > 0 && ++count == 1) {
                printLine(stderr, "\nStopping; press Ctrl-C again to end at once.");
                m_stop.request_stop();
            } else if (count > 1) {
                ::_exit(kStopped);
            }
        }
    });
}

StopOnSignal::~StopOnSignal() = default;

} // namespace spherewalk::program
