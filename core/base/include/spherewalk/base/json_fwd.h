// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>
#include <string_view>

/// For headers: names the JSON types at little cost. Sources that use Json values include json.h.

namespace spherewalk {

/// A JSON value. Objects keep the order of their keys, so that a file is written as it was read.
using Json = nlohmann::ordered_json;

struct JsonLimits {
    std::uint64_t maxBytes = 256ULL << 20;
    int maxDepth = 64;
};

/// The value that the content spells. `source` names the content in sentences ("the camera's answer", a
/// file's name). Errors: Corrupt, for text that is no JSON, is too large, or nests too deep.
Json parseJson(std::string_view content, std::string_view source, const JsonLimits& limits = {});

/// Reads the members of a JSON value from outside, and checks each. A member that is missing or has another
/// type is Corrupt. The sentence names the document, the place in it, and the expected type.
class JsonReader {
  public:
    /// `place` is a JSON pointer, which is empty for the whole document. Owner: the value must outlive the
    /// reader.
    JsonReader(const Json& value, std::string source, std::string place = {});

    /// True if the value is an object with this member.
    bool has(std::string_view key) const;
    /// True if the member is missing or null.
    bool isAbsent(std::string_view key) const;
    JsonReader member(std::string_view key) const;
    JsonReader element(std::size_t index) const;
    /// The length of a list. Errors: also Corrupt for more than maxSize elements.
    std::size_t arraySize(std::size_t maxSize = SIZE_MAX) const;

    std::string asString() const;
    /// A finite number.
    double asNumber() const;
    /// A whole number in [least, most].
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

    /// Throws Corrupt, with the document and the place in front: "dataset.json at /photos/3: ...".
    [[noreturn]] void fail(std::string_view what) const;

  private:
    const Json* m_value;
    std::string m_source;
    std::string m_place;
};

} // namespace spherewalk
