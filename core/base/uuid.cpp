// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/uuid.h"

#include <random>
#include <string_view>

namespace spherewalk {

std::string randomUuid() {
    std::random_device entropy;
    std::string uuid = "xxxxxxxx-xxxx-4xxx-yxxx-xxxxxxxxxxxx";
    constexpr std::string_view kDigits = "0123456789abcdef";
    for (char& digit : uuid) {
        if (digit == 'x') {
            digit = kDigits[entropy() & 15U];
        } else if (digit == 'y') {
            digit = kDigits[8U | (entropy() & 3U)];
        }
    }
    return uuid;
}

} // namespace spherewalk
