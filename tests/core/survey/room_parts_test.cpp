// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "random.h"

#include "spherewalk/base/json.h"
#include "spherewalk/survey/room_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace spherewalk::survey {

namespace {

/// Two rooms side by side, with a doorway in the wall of 10 cm between them.
Room flat() {
    Room room;
    room.outline = {{0, 0},   {4, 0},   {4, 1.5},   {4.1, 1.5}, {4.1, 0}, {8.1, 0},
                    {8.1, 4}, {4.1, 4}, {4.1, 2.4}, {4, 2.4},   {4, 4},   {0, 4}};
    room.ceilingM = 2.6;
    room.names = {{"bedroom", {6.1, 2}}, {"kitchen", {2, 2}}};
    return room;
}

std::vector<std::string> namesOfRails(const Plan& plan, const Room& room) {
    const RoomParts parts(room);
    std::vector<std::string> names;
    for (const std::size_t part : parts.ofRails(plan)) {
        names.push_back(parts.names()[part]);
    }
    return names;
}

} // namespace

TEST(RoomParts, APlaceBelongsToTheRoomThatItLiesIn) {
    const RoomParts parts(flat());
    EXPECT_EQ(parts.names(), (std::vector<std::string>{"bedroom", "kitchen"}));
    spherewalk::test::Random random(41);
    for (int i = 0; i < 500; ++i) {
        const Eigen::Vector2d inKitchen(random.uniform(0, 4), random.uniform(0, 4));
        const Eigen::Vector2d inBedroom = inKitchen + Eigen::Vector2d(4.1, 0);
        EXPECT_EQ(parts.at(inKitchen), 1U) << inKitchen.transpose() << ", seed " << random.seed();
        EXPECT_EQ(parts.at(inBedroom), 0U) << inBedroom.transpose() << ", seed " << random.seed();
    }
}

TEST(RoomParts, ALongRoomHasItsNameAtSeveralPlaces) {
    Room room = flat();
    room.names = {{"hall", {1, 2}}, {"hall", {3.5, 2}}, {"store", {6, 2}}};
    const RoomParts parts(room);
    EXPECT_EQ(parts.names(), (std::vector<std::string>{"hall", "store"}));
    EXPECT_EQ(parts.at({3.9, 2}), 0U);
    EXPECT_EQ(parts.at({0.2, 0.2}), 0U);
}

TEST(RoomParts, AFlatWithoutNamesHasNone) {
    Room room = flat();
    room.names.clear();
    const RoomParts parts(room);
    EXPECT_TRUE(parts.names().empty());
    EXPECT_FALSE(parts.at({1, 1}).has_value());
    EXPECT_TRUE(parts.ofRails(plan(room, {})).empty());
}

TEST(RoomParts, APlanGoesRoomByRoomAndHasTheSameStations) {
    for (const double stepM : {0.3, 0.45, 0.7}) {
        const PlanOptions options{.stepM = stepM, .railStops = 3};
        Room unnamed = flat();
        unnamed.names.clear();
        const Plan before = plan(unnamed, options);
        const Plan named = plan(flat(), options);
        std::vector<std::string> rooms = namesOfRails(named, flat());
        const std::set<std::string> distinct(rooms.begin(), rooms.end());
        rooms.erase(std::unique(rooms.begin(), rooms.end()), rooms.end());
        EXPECT_EQ(rooms.size(), distinct.size()) << stepM; // each room comes once
        EXPECT_EQ(distinct.size(), 2U);
        const auto places = [](const Plan& plan) {
            std::set<std::pair<double, double>> result;
            for (const Station& station : plan.stations) {
                result.emplace(station.positionM.x(), station.positionM.y());
            }
            return result;
        };
        EXPECT_EQ(places(named), places(before));
        for (const Station& station : named.stations) {
            const RailPlacement& rail = named.placements[static_cast<std::size_t>(station.placement)];
            EXPECT_LT((rail.stop(station.stop) - station.positionM.head<2>()).norm(), 1e-9);
        }
        EXPECT_TRUE(
            std::is_sorted(named.stations.begin(), named.stations.end(),
                           [](const Station& a, const Station& b) { return a.placement < b.placement; }));
    }
}

TEST(RoomNames, AreWrittenAndReadWithTheOutline) {
    const Outline read = parseOutline(outlineJson(flat()), "flat.json");
    EXPECT_EQ(read.names, flat().names);
    EXPECT_FALSE(outlineJson(Room{flat().outline, {}, 2.6}).contains("rooms"));
    expectError(ErrorKind::Corrupt, "[x, y]", [] {
        parseOutline(Json::parse(R"({"outline":[[0,0],[1,0],[1,1]],"rooms":[{"name":"a","at":[1]}]})"), "x");
    });
}

TEST(RoomNames, AreRefusedWhereTheyCannotBe) {
    Room room = flat();
    room.names[0].at = {9, 9};
    expectError(ErrorKind::InvalidInput, "The room \"bedroom\" lies outside the outline",
                [&] { room.validate(); });
    room = flat();
    for (const std::string& name : {std::string(), std::string("a\nb"), std::string(101, 'x')}) {
        room.names[1].name = name;
        expectError(ErrorKind::InvalidInput, "A room cannot be called", [&] { room.validate(); });
    }
}

} // namespace spherewalk::survey
