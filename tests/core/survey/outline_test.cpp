// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "rooms.h"

#include "spherewalk/base/json.h"
#include "spherewalk/survey/room.h"

namespace spherewalk::survey {

namespace {

Outline parse(const std::string& text) {
    return parseOutline(parseJson(text, "room.json"), "room.json");
}

void expectCorrupt(const std::string& text, const std::string& part) {
    spherewalk::test::expectError(ErrorKind::Corrupt, part, [&] { parse(text); });
}

} // namespace

TEST(Outline, IsReadFromAPlainListOfCorners) {
    const Outline read = parse("[[0,0],[5,0.5],[5,4]]");
    EXPECT_EQ(read.outline, (Polygon{{0, 0}, {5, 0.5}, {5, 4}}));
    EXPECT_TRUE(read.obstacles.empty());
    EXPECT_FALSE(read.ceilingM.has_value());
}

TEST(Outline, IsReadFromADocument) {
    const Outline read =
        parse(R"({"outline":[[0,0],[5,0],[5,4]],"obstacles":[[[1,1],[2,1],[2,2]]],"ceiling_m":2.6})");
    EXPECT_EQ(read.outline.size(), 3U);
    EXPECT_EQ(read.obstacles, (std::vector<Polygon>{{{1, 1}, {2, 1}, {2, 2}}}));
    EXPECT_EQ(read.ceilingM, 2.6);
}

TEST(Outline, ReadsBackWhatWasWritten) {
    Room room = test::uShape();
    room.obstacles = {test::rectangle(0.1, 0.7, 1. / 3, 1)};
    const Outline read = parse(outlineJson(room).dump());
    EXPECT_EQ(read.outline, room.outline);
    EXPECT_EQ(read.obstacles, room.obstacles);
    EXPECT_EQ(read.ceilingM, room.ceilingM);
}

TEST(Outline, NamesThePlaceOfWhatItCannotRead) {
    expectCorrupt("{}", R"(room.json at its top: the member "outline" is missing.)");
    expectCorrupt("7", "expected an object");
    expectCorrupt("[[0,0],[1]]", "room.json at /1: expected a corner as [x, y].");
    expectCorrupt("[[0,0],[1,2,3]]", "room.json at /1: expected a corner as [x, y].");
    expectCorrupt(R"([[0,0],[1,"2"]])", "room.json at /1/1: expected a number.");
    expectCorrupt("[0,0,1,2]", "room.json at /0: expected a list");
    expectCorrupt(R"({"outline":[],"ceiling_m":"high"})", "room.json at /ceiling_m: expected a number.");
    expectCorrupt(R"({"outline":[],"obstacles":{}})", "room.json at /obstacles: expected a list");
}

TEST(Outline, RefusesMoreCornersThanARoomMayHave) {
    Json corners = Json::array();
    for (int i = 0; i < 2001; ++i) {
        corners.push_back({i, i});
    }
    expectCorrupt(corners.dump(), "more than the 2000 corners");
    corners.erase(0);
    expectCorrupt(Json{{"outline", corners}, {"obstacles", {{{1, 1}}}}}.dump(), "more than the 2000 corners");
}

} // namespace spherewalk::survey
