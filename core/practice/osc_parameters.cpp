// SPDX-License-Identifier: GPL-3.0-or-later
#include "osc_parameters.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::practice {

const Json& required(const Json& parameters, const char* name) {
    if (!parameters.contains(name)) {
        throw OscError(OscCode::MissingParameter);
    }
    return parameters[name];
}

std::int64_t wholeNumber(const Json& value, std::int64_t least, std::int64_t most) {
    const bool isWhole = value.is_number_integer() ||
                         (value.is_number() && value.get<double>() == std::floor(value.get<double>()) &&
                          std::abs(value.get<double>()) < 1e15);
    const std::int64_t number = isWhole ? value.get<std::int64_t>() : least - 1;
    if (number < least || number > most) {
        throw OscError(OscCode::InvalidParameterValue);
    }
    return number;
}

std::string word(const Json& value, std::initializer_list<std::string_view> known) {
    const std::string spelled = value.is_string() ? value.get<std::string>() : std::string();
    if (std::find(known.begin(), known.end(), spelled) == known.end()) {
        throw OscError(OscCode::InvalidParameterValue);
    }
    return spelled;
}

bool flag(const Json& parameters, const char* name, bool fallback) {
    if (!parameters.contains(name)) {
        return fallback;
    }
    if (!parameters[name].is_boolean()) {
        throw OscError(OscCode::InvalidParameterValue);
    }
    return parameters[name].get<bool>();
}

} // namespace spherewalk::practice
