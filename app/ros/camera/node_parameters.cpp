// SPDX-License-Identifier: GPL-3.0-or-later
#include "node_parameters.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <limits>

namespace spherewalk::ros {

namespace {

[[noreturn]] void refuse(const std::string& name, const char* kind) {
    throw Error(ErrorKind::InvalidInput, text("The parameter ", name, " must be ", kind, "."));
}

int smallNumber(const std::string& name, std::int64_t given) {
    if (given < std::numeric_limits<int>::min() || given > std::numeric_limits<int>::max()) {
        throw Error(ErrorKind::InvalidInput, text("The parameter ", name, " cannot be ", given, "."));
    }
    return static_cast<int>(given);
}

} // namespace

void assign(const std::string& name, const GivenValue& given, std::string& value) {
    const auto* text = std::get_if<std::string>(&given);
    if (text == nullptr) {
        refuse(name, "a text");
    }
    value = *text;
}

void assign(const std::string& name, const GivenValue& given, double& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&given)) {
        value = static_cast<double>(*whole);
    } else if (const auto* number = std::get_if<double>(&given)) {
        value = *number;
    } else {
        refuse(name, "a number");
    }
}

void assign(const std::string& name, const GivenValue& given, int& value) {
    const auto* whole = std::get_if<std::int64_t>(&given);
    if (whole == nullptr) {
        refuse(name, "a whole number");
    }
    value = smallNumber(name, *whole);
}

void assign(const std::string& name, const GivenValue& given, std::vector<int>& value) {
    const auto* many = std::get_if<std::vector<std::int64_t>>(&given);
    if (many == nullptr) {
        refuse(name, "a list of whole numbers");
    }
    value.clear();
    for (const std::int64_t one : *many) {
        value.push_back(smallNumber(name, one));
    }
}

} // namespace spherewalk::ros
