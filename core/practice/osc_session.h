// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "osc_error.h"

#include "spherewalk/base/clock.h"

#include <optional>
#include <string>

namespace spherewalk::practice {

/// The session that most commands of API level 1 need. There is one; a new one ends the one before. Threads:
/// one at a time.
class OscSession {
  public:
    /// timeScale: of the 180 s after which an unused session ends; 0: it does not.
    OscSession(Clock& clock, double timeScale) : m_clock(clock), m_timeScale(timeScale) {}

    /// "SID_0001".
    std::string start();

    void end() { m_id.reset(); }

    /// Uses the session that the parameters name. Errors: OscError for none, or one that has ended.
    void use(const Json& parameters);

    std::string id() const { return m_id.value_or(""); }

    static constexpr double kTimeoutS = 180;

  private:
    Clock& m_clock;
    double m_timeScale;
    int m_count = 0;
    std::optional<std::string> m_id;
    Clock::TimePoint m_usedAt;
};

} // namespace spherewalk::practice
