// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/error.h"

#include <utility>

namespace spherewalk {

std::string_view name(ErrorKind kind) {
    switch (kind) {
    case ErrorKind::InvalidInput:
        return "invalid_input";
    case ErrorKind::NotFound:
        return "not_found";
    case ErrorKind::Exists:
        return "exists";
    case ErrorKind::Io:
        return "io";
    case ErrorKind::Network:
        return "network";
    case ErrorKind::Timeout:
        return "timeout";
    case ErrorKind::Stopped:
        return "stopped";
    case ErrorKind::Corrupt:
        return "corrupt";
    case ErrorKind::Unsupported:
        return "unsupported";
    case ErrorKind::Busy:
        return "busy";
    case ErrorKind::Full:
        return "full";
    case ErrorKind::Internal:
        break;
    }
    return "internal";
}

Error::Error(ErrorKind kind, std::string sentence, std::string context)
    : m_kind(kind), m_sentence(std::move(sentence)), m_context(std::move(context)) {
}

} // namespace spherewalk
