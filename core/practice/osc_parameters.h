// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "osc_error.h"

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

namespace spherewalk::practice {

// What a command's parameters must be. Errors of all: OscError.

/// A parameter that must be there.
const Json& required(const Json& parameters, const char* name);
/// Spelled with or without a fraction of zero.
std::int64_t wholeNumber(const Json& value, std::int64_t least, std::int64_t most);
std::string word(const Json& value, std::initializer_list<std::string_view> known);
/// True or false; the fallback if it is not there.
bool flag(const Json& parameters, const char* name, bool fallback);

} // namespace spherewalk::practice
