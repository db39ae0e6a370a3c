// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"

#include "spherewalk/base/json.h"

namespace spherewalk {

using test::expectError;

TEST(Json, RefusesNestingBeyondTheLimitWhateverItsDepth) {
    for (const std::size_t depth : {65UL, 1'000'000UL}) {
        expectError(ErrorKind::Corrupt, "nests deeper than 64",
                    [&] { parseJson(std::string(depth, '['), "x"); });
        std::string objects;
        for (std::size_t i = 0; i < depth; ++i) {
            objects += "{\"a\":";
        }
        expectError(ErrorKind::Corrupt, "nests deeper than 64", [&] { parseJson(objects, "x"); });
    }
    EXPECT_NO_THROW(parseJson(std::string(60, '[') + std::string(60, ']'), "x"));
}

TEST(Json, RefusesWhatIsNoJsonOrTooLarge) {
    for (const char* bad : {"", "{", "<html>", "{\"a\":1}x", "[1,]", "nan", "\"\xff\""}) {
        expectError(ErrorKind::Corrupt, "the answer", [&] { parseJson(bad, "the answer"); });
    }
    expectError(ErrorKind::Corrupt, "more than the 3 bytes", [] { parseJson("[1,2]", "x", {3, 64}); });
}

TEST(JsonReader, NamesThePlaceOfWhatIsWrong) {
    const Json json =
        parseJson(R"({"photos":[{"x":1},{"x":"one","n":1.5,"i":18446744073709551615}]})", "d.json");
    const JsonReader reader(json, "d.json");
    EXPECT_EQ(reader.member("photos").element(0).number("x"), 1);
    const JsonReader second = reader.member("photos").element(1);
    expectError(ErrorKind::Corrupt, "d.json at /photos/1/x: expected a number", [&] { second.number("x"); });
    expectError(ErrorKind::Corrupt, "d.json at /photos/1/n: expected a whole number",
                [&] { second.integer("n"); });
    expectError(ErrorKind::Corrupt, "expected a whole number", [&] { second.integer("i"); });
    expectError(ErrorKind::Corrupt, "\"y\" is missing", [&] { second.number("y"); });
    expectError(ErrorKind::Corrupt, "element 2 is missing", [&] { reader.member("photos").element(2); });
    expectError(ErrorKind::Corrupt, "from 2 to 3",
                [&] { reader.member("photos").element(0).integer("x", 2, 3); });
    expectError(ErrorKind::Corrupt, "at its top: expected a list", [&] { reader.arraySize(); });
}

} // namespace spherewalk
