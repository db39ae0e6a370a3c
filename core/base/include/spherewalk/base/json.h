// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace spherewalk {

/// JSON values keep the order of their keys, so that what we write reads as we wrote it.
using Json = nlohmann::ordered_json;

struct JsonLimits {
    std::uint64_t maxBytes = 256ULL << 20;
    int maxDepth = 64;
};

/// The value that the content spells. source: what the content is, for the sentence ("the camera's answer", a
/// file's name). Errors: Corrupt, for text that is no JSON, is too large, or nests too deep.
Json parseJson(std::string_view content, std::string_view source, const JsonLimits& limits = {});

/// A JSON value from outside, with its place in the document, whose members are read with a check. A member
/// that is missing or of another type is Corrupt, with a sentence that names the document, the place and what
/// was expected.
class JsonReader {
  public:
    /// Owner: the value must outlive the reader. place: JSON pointer, empty for the whole document.
    JsonReader(const Json& value, std::string source, std::string place = {});

    bool has(std::string_view key) const;
    /// True if the member is missing or null.
    bool isAbsent(std::string_view key) const;
    JsonReader member(std::string_view key) const;
    JsonReader element(std::size_t index) const;
    std::size_t arraySize(std::size_t maxSize = SIZE_MAX) const;

    std::string asString() const;
    /// Finite numbers only, as JSON has no others.
    double asNumber() const;
    std::int64_t asInteger(std::int64_t least = INT64_MIN, std::int64_t most = INT64_MAX) const;
    bool asBool() const;

    std::string string(std::string_view key) const { return member(key).asString(); }

    double number(std::string_view key) const { return member(key).asNumber(); }

    std::int64_t integer(std::string_view key, std::int64_t least = INT64_MIN,
                         std::int64_t most = INT64_MAX) const {
        return member(key).asInteger(least, most);
    }

    bool boolean(std::string_view key) const { return member(key).asBool(); }

    const Json& value() const { return *m_value; }

    /// Corrupt, with the document and the place in front: "dataset.json at /photos/3: ...".
    [[noreturn]] void fail(std::string_view what) const;

  private:
    const Json* m_value;
    std::string m_source;
    std::string m_place;
};

} // namespace spherewalk
