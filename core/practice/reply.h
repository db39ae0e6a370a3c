// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "osc_error.h"

#include <httplib.h>

namespace spherewalk::practice {

/// Writes the answer as the camera does.
inline void reply(httplib::Response& response, const OscReply& answer) {
    response.status = answer.status;
    response.set_header("X-Content-Type-Options", "nosniff");
    response.set_content(answer.body.dump(-1, ' ', false, Json::error_handler_t::replace),
                         "application/json; charset=utf-8");
}

} // namespace spherewalk::practice
