// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/terminal.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

namespace spherewalk::cli {

namespace {

using namespace std::chrono_literals;

void print(const std::string& text) {
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
}

} // namespace

TerminalProgress::TerminalProgress()
    : m_timeLeft(std::chrono::steady_clock::now()),
      m_nextShow(std::chrono::steady_clock::now() + 1s),
      m_isTerminal(::isatty(STDERR_FILENO) == 1) {
}

TerminalProgress::~TerminalProgress() {
    clearLine();
}

void TerminalProgress::clearLine() {
    if (m_lineIsShown) {
        print("\r\x1b[K");
        m_lineIsShown = false;
    }
}

void TerminalProgress::progress(double fraction, std::string_view activity) {
    const std::scoped_lock lock(m_mutex);
    const auto now = std::chrono::steady_clock::now();
    const auto left = m_timeLeft.at(now, fraction);
    if (now < m_nextShow) {
        return;
    }
    m_nextShow = now + (m_isTerminal ? 200ms : 5000ms);
    const std::string line = text(activity, ": ", static_cast<int>(std::floor(100 * fraction)), " %",
                                  left ? text(", ", humanDuration(*left), " left") : "");
    clearLine();
    print(m_isTerminal ? line : line + "\n");
    m_lineIsShown = m_isTerminal;
}

void TerminalProgress::warning(std::string_view sentence) {
    const std::scoped_lock lock(m_mutex);
    clearLine();
    print(text(sentence, "\n"));
}

std::optional<std::string> readLine(const std::stop_token& stop) {
    static std::string buffer;
    for (;;) {
        if (const std::size_t end = buffer.find('\n'); end != std::string::npos) {
            std::string line = buffer.substr(0, end);
            buffer.erase(0, end + 1);
            return line;
        }
        throwIfStopped(stop);
        pollfd input{STDIN_FILENO, POLLIN, 0};
        if (::poll(&input, 1, 100) <= 0) {
            continue;
        }
        std::array<char, 4096> piece{};
        const ssize_t count = ::read(STDIN_FILENO, piece.data(), piece.size());
        if (count <= 0) {
            return std::nullopt;
        }
        buffer.append(piece.data(), static_cast<std::size_t>(count));
    }
}

namespace {

/// The terminal shows nothing of what is typed, until the end of the scope.
class Silence {
  public:
    Silence() {
        if (::tcgetattr(STDIN_FILENO, &m_before) == 0) {
            termios silent = m_before;
            silent.c_lflag &= ~static_cast<tcflag_t>(ECHO);
            m_isSet = ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &silent) == 0;
        }
    }

    ~Silence() {
        if (m_isSet) {
            ::tcsetattr(STDIN_FILENO, TCSANOW, &m_before);
            print("\n");
        }
    }

    Silence(const Silence&) = delete;
    Silence& operator=(const Silence&) = delete;

  private:
    termios m_before{};
    bool m_isSet = false;
};

} // namespace

std::optional<std::string> askAtTerminal(std::string_view question, Echo echo, const std::stop_token& stop) {
    if (::isatty(STDIN_FILENO) != 1 || ::isatty(STDERR_FILENO) != 1) {
        return std::nullopt;
    }
    print(std::string(question));
    std::optional<Silence> silence;
    if (echo == Echo::Off) {
        silence.emplace();
    }
    return readLine(stop);
}

} // namespace spherewalk::cli
