// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "keyboard.h"
#include "program.h"

#include <chrono>
#include <functional>
#include <string>

namespace spherewalk::campaign {

/// A person at a terminal, who does what the program says, and presses Enter too often.
class TerminalPerson {
  public:
    struct Habits {
        std::function<void(const std::string& station)> bringCamera;
        std::function<int()> presses; ///< How often Enter is pressed for one answer.
        int patience = 4;             ///< So many tries of one picture, before Ctrl-C is pressed.
    };

    explicit TerminalPerson(Habits habits);

    std::string terminal() const { return m_keyboard.terminal(); }

    /// Answers what the program asks, for so long. Returns whether it has ended.
    bool attend(const test::Program& program, std::chrono::milliseconds time);

  private:
    void answer(const test::Program& program, const std::string& line);
    void press();

    Habits m_habits;
    test::Keyboard m_keyboard;
    std::size_t m_read = 0; ///< So much of the program's words is answered.
    int m_tries = 0;        ///< of the present picture
};

} // namespace spherewalk::campaign
