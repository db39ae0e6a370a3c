// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/text.h"

#include <concepts>
#include <string>
#include <string_view>

namespace spherewalk {

/// A number and what there are so many of: "1 photo was", "2 photos were".
template <std::integral Count>
std::string counted(Count count, std::string_view one, std::string_view many) {
    return text(count, " ", count == 1 ? one : many);
}

} // namespace spherewalk
