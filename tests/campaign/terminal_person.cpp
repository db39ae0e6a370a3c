// SPDX-License-Identifier: GPL-3.0-or-later
#include "terminal_person.h"

#include <algorithm>
#include <csignal>
#include <utility>

namespace spherewalk::campaign {

using namespace std::chrono_literals;

TerminalPerson::TerminalPerson(Habits habits) : m_habits(std::move(habits)) {
    press(); // before anything was asked
}

void TerminalPerson::press() {
    m_keyboard.press(std::string(static_cast<std::size_t>(m_habits.presses()), '\n'));
}

bool TerminalPerson::attend(const test::Program& program, std::chrono::milliseconds time) {
    const auto end = std::chrono::steady_clock::now() + time;
    for (;;) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
        if (program.endsWithin(std::clamp(left, 0ms, 10ms))) {
            return true;
        }
        const std::string words = program.errors();
        for (std::size_t stop = words.find('\n', m_read); stop != std::string::npos;
             stop = words.find('\n', m_read)) {
            answer(program, words.substr(m_read, stop - m_read));
            m_read = stop + 1;
        }
        if (left <= 0ms) {
            return false;
        }
    }
}

void TerminalPerson::answer(const test::Program& program, const std::string& line) {
    const std::string bring = "Bring the camera to ";
    const std::size_t begin = line.find(bring);
    const std::size_t place = line.rfind(" (x ");
    if (begin != std::string::npos && place != std::string::npos) {
        const std::size_t name = begin + bring.size();
        m_habits.bringCamera(line.substr(name, place - name));
        m_tries = 0;
        press();
    } else if (line.find("Press Enter") != std::string::npos) {
        if (++m_tries < m_habits.patience) {
            press();
        } else {
            program.signal(SIGINT);
        }
    }
}

} // namespace spherewalk::campaign
