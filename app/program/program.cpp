// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/program.h"

#include "spherewalk/base/text.h"

#include <csignal>
#include <ctime>
#include <exception>
#include <unistd.h>

namespace spherewalk::program {

namespace {

int fail(const Error& error, const std::function<void(const Error&)>& onError) {
    if (onError) {
        onError(error);
    }
    printLine(stderr, error.sentence());
    if (!error.context().empty()) {
        printLine(stderr, text("  (", error.context(), ")"));
    }
    return error.kind() == ErrorKind::Stopped ? kStopped : kFailed;
}

sigset_t stopSignals() {
    sigset_t signals;
    ::sigemptyset(&signals);
    ::sigaddset(&signals, SIGINT);
    ::sigaddset(&signals, SIGTERM);
    return signals;
}

} // namespace

void printLine(std::FILE* stream, const std::string& line) {
    std::fputs((line + "\n").c_str(), stream);
}

int guarded(const std::function<int()>& body, const std::function<void(const Error&)>& onError) {
    try {
        return body();
    } catch (const Error& error) {
        return fail(error, onError);
    } catch (const std::exception& defect) { // whatever no module translated
        return fail(
            Error(ErrorKind::Internal, text("Spherewalk met a defect of its own: ", defect.what(), ".")),
            onError);
    }
}

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
