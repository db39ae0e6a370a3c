// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <fcntl.h>
#include <stdexcept>
#include <string>
#include <unistd.h>

namespace spherewalk::test {

/// A terminal at which a test is the person. Its name is the standard input of a Program.
class Keyboard {
  public:
    Keyboard() : m_keys(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
        if (m_keys < 0 || ::grantpt(m_keys) != 0 || ::unlockpt(m_keys) != 0) {
            throw std::runtime_error("there is no terminal");
        }
    }

    ~Keyboard() { ::close(m_keys); }

    Keyboard(const Keyboard&) = delete;
    Keyboard& operator=(const Keyboard&) = delete;

    std::string terminal() const {
        char name[64] = {};
        return ::ptsname_r(m_keys, name, sizeof name) == 0 ? name : throw std::runtime_error("no terminal");
    }

    void press(const std::string& keys) const {
        if (::write(m_keys, keys.data(), keys.size()) != static_cast<ssize_t>(keys.size())) {
            throw std::runtime_error("the terminal takes no key");
        }
    }

  private:
    int m_keys;
};

} // namespace spherewalk::test
