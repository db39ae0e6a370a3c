// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/json.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <cmath>
#include <utility>

namespace spherewalk {

Json parseJson(std::string_view content, std::string_view source, const JsonLimits& limits) {
    if (content.size() > limits.maxBytes) {
        throw Error(ErrorKind::Corrupt,
                    text("Could not read ", source, ": ", humanBytes(content.size()),
                         " of JSON, more than the ", humanBytes(limits.maxBytes), " allowed."));
    }
    const auto checkDepth = [&](int depth, Json::parse_event_t event, Json& /*parsed*/) {
        const bool opens =
            event == Json::parse_event_t::object_start || event == Json::parse_event_t::array_start;
        if (opens && depth >= limits.maxDepth) {
            throw Error(ErrorKind::Corrupt, text("Could not read ", source, ": its JSON nests deeper than ",
                                                 limits.maxDepth, " levels."));
        }
        return true;
    };
    try {
        return Json::parse(content, checkDepth);
    } catch (const Json::exception& failure) {
        throw Error(ErrorKind::Corrupt, text("Could not read ", source, ": it is not valid JSON."),
                    printable(failure.what(), 300));
    }
}

JsonReader::JsonReader(const Json& value, std::string source, std::string place)
    : m_value(&value), m_source(std::move(source)), m_place(std::move(place)) {
}

bool JsonReader::has(std::string_view key) const {
    return m_value->is_object() && m_value->contains(std::string(key));
}

bool JsonReader::isAbsent(std::string_view key) const {
    return !has(key) || (*m_value)[std::string(key)].is_null();
}

JsonReader JsonReader::member(std::string_view key) const {
    if (!m_value->is_object()) {
        fail("expected an object");
    }
    const auto found = m_value->find(std::string(key));
    if (found == m_value->end()) {
        fail(text("the member \"", key, "\" is missing"));
    }
    return {*found, m_source, text(m_place, "/", key)};
}

JsonReader JsonReader::element(std::size_t index) const {
    if (index >= arraySize()) {
        fail(text("element ", index, " is missing"));
    }
    return {(*m_value)[index], m_source, text(m_place, "/", index)};
}

std::size_t JsonReader::arraySize(std::size_t maxSize) const {
    if (!m_value->is_array()) {
        fail("expected a list");
    }
    if (m_value->size() > maxSize) {
        fail(text("the list has ", m_value->size(), " elements, more than the ", maxSize, " allowed"));
    }
    return m_value->size();
}

std::string JsonReader::asString() const {
    if (!m_value->is_string()) {
        fail("expected a text");
    }
    return m_value->get<std::string>();
}

double JsonReader::asNumber() const {
    if (!m_value->is_number() || !std::isfinite(m_value->get<double>())) {
        fail("expected a number");
    }
    return m_value->get<double>();
}

std::int64_t JsonReader::asInteger(std::int64_t least, std::int64_t most) const {
    const bool tooLarge = m_value->is_number_unsigned() && m_value->get<std::uint64_t>() > INT64_MAX;
    if (!m_value->is_number_integer() || tooLarge) {
        fail("expected a whole number");
    }
    const auto number = m_value->get<std::int64_t>();
    if (number < least || number > most) {
        fail(text("expected a whole number from ", least, " to ", most));
    }
    return number;
}

bool JsonReader::asBool() const {
    if (!m_value->is_boolean()) {
        fail("expected true or false");
    }
    return m_value->get<bool>();
}

void JsonReader::fail(std::string_view what) const {
    throw Error(ErrorKind::Corrupt,
                text(m_source, " at ", m_place.empty() ? "its top" : printable(m_place), ": ", what, "."));
}

} // namespace spherewalk
