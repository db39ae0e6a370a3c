// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"

#include <chrono>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::cli {

/// Shows progress with the time left on standard error: one line that is rewritten on a terminal, a line
/// every few seconds elsewhere, and nothing at all for what ends within a second.
class TerminalProgress : public ProgressSink {
  public:
    TerminalProgress();
    ~TerminalProgress() override;

    void progress(double fraction, std::string_view activity) override;
    void warning(std::string_view sentence) override;

  private:
    void clearLine();

    std::mutex m_mutex;
    TimeLeft m_timeLeft;
    std::chrono::steady_clock::time_point m_nextShow;
    bool m_isTerminal;
    bool m_lineIsShown = false;
};

/// The next line of standard input, without its line feed. Returns nothing at the end of the input. Of a line
/// that is longer than any answer, only the beginning comes. Stop: throws Error{Stopped} within 100 ms.
std::optional<std::string> readLine(const std::stop_token& stop);

/// Takes the lines that have arrived on standard input and were not read. Without waiting.
std::vector<std::string> waitingLines();

enum class Echo { Off, On };

/// The answer of a person to the question. Returns nothing if standard input or standard error is no
/// terminal, or at the end of the input. Stop: throws Error{Stopped}.
std::optional<std::string> askAtTerminal(std::string_view question, Echo echo, const std::stop_token& stop);

} // namespace spherewalk::cli
