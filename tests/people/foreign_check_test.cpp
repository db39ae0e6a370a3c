// SPDX-License-Identifier: GPL-3.0-or-later
#include "peopled_survey.h"

#include "spherewalk/align/foreign_check.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/photo/picture_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <utility>

namespace spherewalk::align {

using practice::RoomStyle;
using test::PeopledOptions;
using test::PeopledPhoto;

namespace {

constexpr double kLeastPerson = 0.003; ///< Of the sphere.
constexpr double kTrace = 0.0003;      ///< A photo that shows less of a person counts as neither.

/// The photos with the poses that an alignment would give them.
std::vector<SightPhoto> solved(const std::vector<PeopledPhoto>& photos, std::uint64_t seed) {
    constexpr double kPlaceM = 0.001;
    constexpr double kTurnRad = 0.0003;
    FixedRandom random(seed, 99);
    const auto vector = [&](double sigma) {
        return Eigen::Vector3d(random.normal(sigma), random.normal(sigma), random.normal(sigma));
    };
    std::vector<SightPhoto> result;
    for (const PeopledPhoto& photo : photos) {
        Rigid3 pose = photo.truth;
        pose.translation += vector(kPlaceM);
        const Eigen::Vector3d by = vector(kTurnRad);
        pose.rotation = pose.rotation * Eigen::AngleAxisd(by.norm(), by.normalized());
        result.push_back({photo::resized(photo.picture, kSightWidth, kSightWidth / 2), pose});
    }
    return result;
}

struct Count {
    int found = 0;
    int all = 0;

    void add(bool isFound) {
        found += isFound ? 1 : 0;
        ++all;
    }

    void operator+=(const Count& other) {
        found += other.found;
        all += other.all;
    }
};

std::string words(const Count& count) {
    return text(count.found, " of ", count.all);
}

/// Persons by their size in the picture, by their distance, and of those kinds that are hard.
struct Tally {
    Count clean; ///< Photos without a person; "found" are false alarms.
    std::array<Count, 4> bySize;
    std::array<Count, 3> byDistance;
    Count still;
    Count hidden;

    Count persons() const {
        Count all;
        for (const Count& one : bySize) {
            all += one;
        }
        return all;
    }

    void add(const PeopledPhoto& photo, bool isFound) {
        if (!photo.person || photo.person->part == 0) {
            clean.add(isFound);
            return;
        }
        const test::SeenPerson& person = *photo.person;
        if (person.part < kLeastPerson) {
            if (person.part < kTrace) {
                clean.add(isFound);
            }
            return;
        }
        bySize[person.part < 0.006 ? 0 : person.part < 0.012 ? 1 : person.part < 0.03 ? 2 : 3].add(isFound);
        byDistance[person.distanceM < 1.2 ? 0 : person.distanceM < 2 ? 1 : 2].add(isFound);
        if (person.photos > 1) {
            still.add(isFound);
        }
        if (person.hiddenShare > 0.25) {
            hidden.add(isFound);
        }
    }

    void operator+=(const Tally& other) {
        clean += other.clean;
        still += other.still;
        hidden += other.hidden;
        for (std::size_t i = 0; i < bySize.size(); ++i) {
            bySize[i] += other.bySize[i];
        }
        for (std::size_t i = 0; i < byDistance.size(); ++i) {
            byDistance[i] += other.byDistance[i];
        }
    }
};

void addChecked(const std::vector<PeopledPhoto>& photos, std::uint64_t seed, Tally& tally) {
    const ForeignCheck check = foreignThings(solved(photos, seed), {}, noProgress(), {});
    for (std::size_t i = 0; i < photos.size(); ++i) {
        tally.add(photos[i], std::ranges::count(check.things, static_cast<int>(i), &ForeignThing::photo) > 0);
    }
}

/// The survey without persons, and with somebody in every fourth photo.
Tally tallyOf(PeopledOptions options) {
    Tally tally;
    std::vector<PeopledPhoto> photos = test::emptySurvey(options);
    addChecked(photos, options.seed, tally);
    options.peopled = 0.25;
    test::addPersons(options, photos);
    addChecked(photos, options.seed, tally);
    return tally;
}

void print(const std::string& what, const Tally& tally) {
    std::printf("| %s | %s |", what.c_str(), words(tally.clean).c_str());
    for (const Count& one : tally.bySize) {
        std::printf(" %s |", words(one).c_str());
    }
    for (const Count& one : tally.byDistance) {
        std::printf(" %s |", words(one).c_str());
    }
    std::printf(" %s | %s |\n", words(tally.still).c_str(), words(tally.hidden).c_str());
    std::fflush(stdout);
}

PeopledOptions survey(RoomStyle room, double stepM, bool isReal) {
    PeopledOptions options;
    options.room = room;
    options.stepM = stepM;
    options.isReal = isReal;
    options.tiltDeg = isReal ? 5 : 0.5;
    options.mostPhotos = 12;
    options.width = kSightWidth;
    return options;
}

PeopledOptions large(PeopledOptions options) {
    options.mostPhotos = 20;
    return options;
}

} // namespace

TEST(ForeignCheck, FindsPersonsAndLeavesFurnitureAlone) {
    Tally all;
    all += tallyOf(large(survey(RoomStyle::Lively, 0.4, false)));
    all += tallyOf(survey(RoomStyle::Lively, 0.8, true));
    all += tallyOf(survey(RoomStyle::Bare, 0.6, true));
    print("a few", all);
    EXPECT_LE(all.clean.found, 0.02 * all.clean.all);
    EXPECT_GE(all.persons().found, 0.85 * all.persons().all);
    EXPECT_GE(all.persons().all, 8);
    EXPECT_EQ(all.still.found, all.still.all) << "who keeps still for several photos is named in each";
    EXPECT_GE(all.still.all, 3);
}

TEST(ForeignCheck, LeavesPlainWallsAloneHoweverBrightThePhotosAre) {
    const PeopledOptions options = large(survey(RoomStyle::Bare, 0.4, true));
    const ForeignCheck check =
        foreignThings(solved(test::emptySurvey(options), options.seed), {}, noProgress(), {});
    EXPECT_TRUE(check.things.empty()) << "photo " << check.things.front().photo;
}

TEST(ForeignCheck, LeavesARoomAloneThatOneLensShowsBrighter) {
    PeopledOptions options = large(survey(RoomStyle::Bare, 0.8, false));
    options.seed = 102;
    options.lensSigma = 0.12;
    const ForeignCheck check =
        foreignThings(solved(test::emptySurvey(options), options.seed), {}, noProgress(), {});
    EXPECT_TRUE(check.things.empty()) << "photo " << check.things.front().photo;
}

TEST(ForeignCheck, LeavesRoomsAloneAtTheRimOfASurvey) {
    // In a corner and on both sides of a doorway; and where little is known of plain walls.
    for (const auto& [seed, isReal] : {std::pair(13, true), std::pair(18, false)}) {
        PeopledOptions options = large(survey(RoomStyle::Flat, 0.4, isReal));
        options.seed = static_cast<std::uint64_t>(seed);
        const ForeignCheck check =
            foreignThings(solved(test::emptySurvey(options), options.seed), {}, noProgress(), {});
        EXPECT_TRUE(check.things.empty()) << "seed " << seed << ", photo " << check.things.front().photo;
    }
}

TEST(ForeignCheck, JudgesNoPhotoWhoseSurroundingsNoOtherShows) {
    PeopledOptions options = large(survey(RoomStyle::Flat, 0.4, false));
    options.seed = 20; // Its last photo stands alone behind a wall.
    const ForeignCheck check =
        foreignThings(solved(test::emptySurvey(options), options.seed), {}, noProgress(), {});
    EXPECT_FALSE(check.isJudged.back());
    EXPECT_EQ(std::ranges::count(check.things, 19, &ForeignThing::photo), 0);
}

TEST(ForeignCheck, JudgesNothingThatStandsAlone) {
    PeopledOptions options = survey(RoomStyle::Lively, 0.4, false);
    options.mostPhotos = 1;
    std::vector<SightPhoto> photos = solved(test::emptySurvey(options), 1);
    photos.push_back({{}, std::nullopt});
    const ForeignCheck check = foreignThings(photos, {}, noProgress(), {});
    EXPECT_EQ(check.isJudged, (std::vector<bool>{false, false}));
    EXPECT_TRUE(check.things.empty());
}

/// The table of resources/docs/testing.md.
TEST(ForeignCheck, TableByGridSizeAndDistance) {
    const char* seeds = std::getenv("SPHEREWALK_PEOPLE");
    if (seeds == nullptr) {
        GTEST_SKIP() << "takes half an hour for each seed";
    }
    const std::map<RoomStyle, std::string> rooms{
        {RoomStyle::Lively, "lively"}, {RoomStyle::Bare, "bare"}, {RoomStyle::Flat, "flat"}};
    std::istringstream wanted(seeds);
    Tally all;
    for (std::uint64_t seed = 0; wanted >> seed;) {
        for (const double stepM : {0.2, 0.4, 0.6, 0.8}) {
            Tally ofGrid;
            for (const auto& [room, name] : rooms) {
                for (const bool isReal : {false, true}) {
                    PeopledOptions options = large(survey(room, stepM, isReal));
                    options.seed = seed;
                    const Tally one = tallyOf(options);
                    print(text("seed ", seed, ", ", fixed(100 * stepM, 0), " cm, ", name,
                               isReal ? ", real" : ""),
                          one);
                    ofGrid += one;
                }
            }
            print(text("seed ", seed, ", ", fixed(100 * stepM, 0), " cm"), ofGrid);
            all += ofGrid;
        }
    }
    print("all", all);
}

} // namespace spherewalk::align
