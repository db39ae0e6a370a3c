// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace spherewalk::ui {

/// Who may use the remote: the one device that gave the code which the window shows. A code pairs one device
/// and is then spent. After kTries wrong codes it is void, so that guessing gets no further than kTries in a
/// million for each code that a person makes. All comparisons take the same time wherever the texts differ.
class Pairing {
  public:
    enum class Answer {
        Paired,
        Wrong,
        Void,  ///< There is no valid code: a person must make one in the window.
        Taken, ///< A device is paired already.
    };

    static constexpr int kTries = 5;

    Pairing() { renew(); }

    /// Lets go of the paired device and makes another code.
    void renew();

    Answer pair(std::string_view code);

    bool isPaired() const { return !m_session.empty(); }

    /// Returns six digits; empty while no code is valid.
    const std::string& code() const { return m_code; }

    /// Returns the secret of the paired device's cookie; empty without one.
    const std::string& session() const { return m_session; }

    /// Returns what goes with every request that changes something, which other web sites cannot know.
    const std::string& token() const { return m_token; }

    bool isSession(std::string_view given) const;
    bool isToken(std::string_view given) const;

  private:
    std::string m_code;
    int m_triesLeft = kTries;
    std::string m_session;
    std::string m_token;
};

} // namespace spherewalk::ui
