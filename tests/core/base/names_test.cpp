// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/image.h"

#include <set>

namespace spherewalk {

namespace {

enum class Fruit { Apple, Pear, Plum, Nameless };

constexpr EnumNames<Fruit, 3> kFruitNames{
    {{Fruit::Apple, "apple"}, {Fruit::Pear, "pear"}, {Fruit::Plum, "plum"}}};

} // namespace

TEST(EnumNames, NamesAndValuesAreEachOthersInverse) {
    for (const auto& [value, name] : kFruitNames) {
        EXPECT_EQ(nameOf(kFruitNames, value), name);
        EXPECT_EQ(valueOf(kFruitNames, "The fruit", name), value);
    }
    EXPECT_EQ(nameOf(kFruitNames, Fruit::Nameless), "unknown");
}

TEST(EnumNames, AnUnknownNameIsRefusedWithTheOnesThatThereAre) {
    test::expectError(ErrorKind::InvalidInput,
                      "The fruit \"Ap?ple\" is unknown; there are apple, pear and plum.",
                      [] { valueOf(kFruitNames, "The fruit", "Ap\nple"); });
}

TEST(ErrorKind, EachHasANameOfItsOwn) {
    std::set<std::string_view> names;
    for (int kind = 0; kind <= static_cast<int>(ErrorKind::Internal); ++kind) {
        EXPECT_TRUE(names.insert(name(static_cast<ErrorKind>(kind))).second) << kind;
    }
    EXPECT_TRUE(names.contains("invalid_input"));
}

TEST(Error, KeepsItsKindSentenceAndContext) {
    const Error error(ErrorKind::Full, "Could not write x: the disk is full.", "errno 28");
    EXPECT_EQ(error.kind(), ErrorKind::Full);
    EXPECT_STREQ(error.what(), "Could not write x: the disk is full.");
    EXPECT_EQ(error.context(), "errno 28");
}

TEST(Image, RowsFollowEachOtherWithoutPadding) {
    Image<int, 3> image(5, 4);
    for (std::size_t i = 0; i < image.values().size(); ++i) {
        EXPECT_EQ(image.values()[i], 0);
        image.values()[i] = static_cast<int>(i);
    }
    for (int y = 0; y < 4; ++y) {
        EXPECT_EQ(image.row(y).size(), 15U);
        for (int x = 0; x < 5; ++x) {
            EXPECT_EQ(image.at(x, y)[2], 3 * (5 * y + x) + 2);
        }
    }
    EXPECT_TRUE((Image<int, 3>()).empty());
    EXPECT_FALSE(image == (Image<int, 3>(5, 4)));
}

} // namespace spherewalk
