// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/terminal.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <deque>
#include <poll.h>
#include <termios.h>
#include <unistd.h>
#include <utility>

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

namespace {

/// Standard input, line by line.
class LinesOfInput {
  public:
    /// Nothing if no whole line has arrived.
    std::optional<std::string> next() {
        if (m_lines.empty()) {
            return std::nullopt;
        }
        std::string line = std::move(m_lines.front());
        m_lines.pop_front();
        return line;
    }

    /// Waits up to this time and reads what has arrived. Returns false at the end of the input.
    bool read(std::chrono::milliseconds patience) {
        pollfd input{STDIN_FILENO, POLLIN, 0};
        m_hasMore = ::poll(&input, 1, static_cast<int>(patience.count())) > 0;
        if (!m_hasMore) {
            return true;
        }
        std::array<char, 4096> piece{};
        const ssize_t count = ::read(STDIN_FILENO, piece.data(), piece.size());
        m_hasMore = count > 0;
        for (ssize_t i = 0; i < count; ++i) {
            add(piece[static_cast<std::size_t>(i)]);
        }
        return count > 0;
    }

    /// Whether the last read() found anything.
    bool hasMore() const { return m_hasMore; }

  private:
    void add(char letter) {
        constexpr std::size_t kLongestLine = 8192;
        if (letter == '\n') {
            m_lines.push_back(std::exchange(m_begun, {}));
        } else if (m_begun.size() < kLongestLine) {
            m_begun += letter;
        }
    }

    std::deque<std::string> m_lines;
    std::string m_begun; ///< The line that has no end yet.
    bool m_hasMore = false;
};

LinesOfInput& linesOfInput() {
    static LinesOfInput lines;
    return lines;
}

} // namespace

std::optional<std::string> readLine(const std::stop_token& stop) {
    for (;;) {
        if (auto line = linesOfInput().next()) {
            return line;
        }
        throwIfStopped(stop);
        if (!linesOfInput().read(100ms)) {
            return std::nullopt;
        }
    }
}

std::vector<std::string> waitingLines() {
    constexpr int kMostPieces = 256; // who never stops sending is not waited for
    for (int i = 0; i < kMostPieces; ++i) {
        linesOfInput().read(0ms);
        if (!linesOfInput().hasMore()) {
            break;
        }
    }
    std::vector<std::string> lines;
    while (auto line = linesOfInput().next()) {
        lines.push_back(*std::move(line));
    }
    return lines;
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
    waitingLines(); // answers to nothing
    print(std::string(question));
    std::optional<Silence> silence;
    if (echo == Echo::Off) {
        silence.emplace();
    }
    return readLine(stop);
}

} // namespace spherewalk::cli
