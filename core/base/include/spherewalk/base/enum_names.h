// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace spherewalk {

/// The values of an enumeration with the names that files and people use.
template <class Enum, std::size_t kCount>
using EnumNames = std::array<std::pair<Enum, std::string_view>, kCount>;

/// The value's name, or "unknown" if the list has none.
template <class Enum, std::size_t kCount>
std::string_view nameOf(const EnumNames<Enum, kCount>& names, Enum value) {
    for (const auto& [known, name] : names) {
        if (known == value) {
            return name;
        }
    }
    return "unknown";
}

/// The value with this name. `what` begins the sentence of an error, for example "The sampling".
/// Errors: InvalidInput, with a list of the names.
template <class Enum, std::size_t kCount>
Enum valueOf(const EnumNames<Enum, kCount>& names, std::string_view what, std::string_view name) {
    std::string list;
    for (std::size_t i = 0; i < kCount; ++i) {
        if (names[i].second == name) {
            return names[i].first;
        }
        list += (i == 0 ? "" : i + 1 < kCount ? ", " : " and ") + std::string(names[i].second);
    }
    throw Error(ErrorKind::InvalidInput,
                text(what, " \"", printable(name), "\" is unknown; there are ", list, "."));
}

} // namespace spherewalk
