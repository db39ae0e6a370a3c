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

TEST(JsonReader, ReadsEachTypeAndRefusesEachOther) {
    const Json json =
        parseJson(R"({"s":"text","n":-2.5,"i":7,"b":true,"l":[1,2],"o":{"x":1},"z":null})", "d.json");
    const JsonReader reader(json, "d.json");
    EXPECT_EQ(reader.string("s"), "text");
    EXPECT_EQ(reader.number("n"), -2.5);
    EXPECT_EQ(reader.number("i"), 7);
    EXPECT_EQ(reader.integer("i"), 7);
    EXPECT_TRUE(reader.boolean("b"));
    EXPECT_EQ(reader.member("l").arraySize(), 2U);
    for (const char* key : {"n", "i", "b", "l", "o", "z"}) {
        expectError(ErrorKind::Corrupt, "expected a text", [&] { reader.string(key); });
    }
    for (const char* key : {"s", "b", "l", "o", "z"}) {
        expectError(ErrorKind::Corrupt, "expected a number", [&] { reader.number(key); });
    }
    for (const char* key : {"s", "n", "b", "l", "o", "z"}) {
        expectError(ErrorKind::Corrupt, "expected a whole number", [&] { reader.integer(key); });
    }
    for (const char* key : {"s", "n", "i", "l", "o", "z"}) {
        expectError(ErrorKind::Corrupt, "expected true or false", [&] { reader.boolean(key); });
    }
    expectError(ErrorKind::Corrupt, "expected an object", [&] { reader.member("l").member("x"); });
    expectError(ErrorKind::Corrupt, "more than the 1 allowed", [&] { reader.member("l").arraySize(1); });
}

TEST(JsonReader, TellsWhatIsAbsentFromWhatIsNull) {
    const Json json = parseJson(R"({"null":null,"zero":0})", "x");
    const JsonReader reader(json, "x");
    EXPECT_TRUE(reader.has("null"));
    EXPECT_TRUE(reader.isAbsent("null"));
    EXPECT_FALSE(reader.has("none"));
    EXPECT_TRUE(reader.isAbsent("none"));
    EXPECT_FALSE(reader.isAbsent("zero"));
    EXPECT_FALSE(reader.member("zero").has("x"));
}

TEST(Json, KeepsTheOrderOfKeys) {
    const std::string spelt = R"({"z":1,"a":{"y":2,"b":3},"m":[]})";
    EXPECT_EQ(parseJson(spelt, "x").dump(), spelt);
}

} // namespace spherewalk
