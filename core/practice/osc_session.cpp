// SPDX-License-Identifier: GPL-3.0-or-later
#include "osc_session.h"

#include "osc_parameters.h"

namespace spherewalk::practice {

std::string OscSession::start() {
    std::string digits = std::to_string(++m_count);
    digits.insert(0, digits.size() < 4 ? 4 - digits.size() : 0, '0');
    m_id = "SID_" + digits;
    m_usedAt = m_clock.now();
    return *m_id;
}

void OscSession::use(const Json& parameters) {
    const Json& given = required(parameters, "sessionId");
    const std::chrono::duration<double> unused = m_clock.now() - m_usedAt;
    const bool isOver = m_timeScale > 0 && unused.count() > kTimeoutS * m_timeScale;
    if (!m_id || isOver || given != *m_id) {
        throw OscError(OscCode::InvalidSessionId);
    }
    m_usedAt = m_clock.now();
}

} // namespace spherewalk::practice
