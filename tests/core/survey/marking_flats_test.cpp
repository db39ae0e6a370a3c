// SPDX-License-Identifier: GPL-3.0-or-later
// Marking out random flats: several rooms behind doorways, walls of 8 to 30 cm, furniture. A person who has
// nothing but the printed distances finds every rail.
#include "flats.h"
#include "rooms.h"

#include "spherewalk/base/text.h"
#include "spherewalk/survey/marking.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace spherewalk::survey {

using Eigen::Vector2d;

namespace {

constexpr unsigned kSeed = 2300;
constexpr int kFlats = 200;

/// One flat with its plan and marks.
struct Flat {
    Room room;
    Plan plan;
    std::vector<RailMark> marks;
};

std::vector<Flat> manyFlats() {
    spherewalk::test::Random random(kSeed);
    std::vector<Flat> flats(kFlats);
    for (Flat& flat : flats) {
        flat.room = test::FlatBuilder(random).build();
        PlanOptions options;
        options.stepM = random.uniform(0.8, 1.4);
        options.railStops = random.integer(2, 6);
        options.clearanceM = random.uniform(0.15, 0.4);
        flat.plan = plan(flat.room, options);
        flat.marks = railMarks(flat.room, flat.plan);
    }
    return flats;
}

template <class Law>
void onFlats(Law&& law) {
    static const std::vector<Flat> flats = manyFlats();
    for (std::size_t i = 0; i < flats.size(); ++i) {
        SCOPED_TRACE(testing::Message() << "seed " << kSeed << " flat " << i);
        law(flats[i]);
    }
}

double asPrinted(double metres) {
    return std::stod(fixed(metres, 3));
}

/// What a tape begins at: a point, or a wall with its direction.
struct Begin {
    Vector2d at;
    std::optional<Vector2d> wall;
};

Vector2d turned(const Vector2d& along) {
    return {-along.y(), along.x()};
}

/// The places that are as far from a wall, on its inner side, and from a point.
std::vector<Vector2d> besideWall(const Begin& wall, double fromWall, const Vector2d& point, double metres) {
    const Vector2d inner = wall.at + fromWall * turned(*wall.wall);
    const double at = wall.wall->dot(point - inner);
    const double off = (inner + at * *wall.wall - point).norm();
    if (off > metres) {
        return {};
    }
    const double half = std::sqrt(metres * metres - off * off);
    return {inner + (at + half) * *wall.wall, inner + (at - half) * *wall.wall};
}

/// Where two tapes meet: one place, or two.
std::vector<Vector2d> tapesMeet(const Begin& a, double fromA, const Begin& b, double fromB) {
    if (a.wall && b.wall) {
        const Vector2d onA = a.at + fromA * turned(*a.wall);
        const Vector2d onB = b.at + fromB * turned(*b.wall);
        const Vector2d across = turned(*b.wall);
        return {onA + across.dot(onB - onA) / across.dot(*a.wall) * *a.wall};
    }
    if (a.wall) {
        return besideWall(a, fromA, b.at, fromB);
    }
    if (b.wall) {
        return besideWall(b, fromB, a.at, fromA);
    }
    const double apart = (b.at - a.at).norm();
    const Vector2d along = (b.at - a.at) / apart;
    const double x = (fromA * fromA - fromB * fromB + apart * apart) / (2 * apart);
    const double y2 = fromA * fromA - x * x;
    if (y2 < 0) {
        return {};
    }
    const Vector2d across = std::sqrt(y2) * turned(along);
    return {a.at + x * along + across, a.at + x * along - across};
}

/// A person who marks one flat. Each reading can be wrong by what `misread` says.
class Person {
  public:
    using Key = std::pair<int, bool>; ///< A rail, and whether it is its last stop.

    explicit Person(const Flat& flat) : m_flat(flat) {}

    std::map<std::pair<Key, int>, double> misread; ///< By point and tape.

    /// Where the person marks this end of a rail; nothing if its tapes do not meet.
    std::optional<Vector2d> placeOf(const Key& key) {
        if (const auto known = m_places.find(key); known != m_places.end()) {
            return known->second;
        }
        const MarkedPoint& point = pointOf(key);
        if (point.tapes.size() != 2) {
            return std::nullopt;
        }
        std::array<Begin, 2> from;
        std::array<double, 2> metres{};
        for (int i = 0; i < 2; ++i) {
            const auto at = static_cast<std::size_t>(i);
            const std::optional<Begin> origin = originOf(point.tapes[at].from);
            if (!origin) {
                return std::nullopt;
            }
            from.at(at) = *origin;
            const auto wrong = misread.find({key, i});
            metres.at(at) = asPrinted(point.tapes[at].metres) + (wrong != misread.end() ? wrong->second : 0);
        }
        const std::vector<Vector2d> meetings = tapesMeet(from[0], metres[0], from[1], metres[1]);
        if (meetings.empty()) {
            return std::nullopt;
        }
        const Vector2d place = meetings.size() == 1 ? meetings[0] : chosen(meetings, point);
        m_places[key] = place;
        return place;
    }

    static const MarkedPoint& pointOf(const RailMark& mark, bool isLast) {
        return isLast ? mark.last : mark.first;
    }

    const MarkedPoint& pointOf(const Key& key) const {
        return pointOf(m_flat.marks[static_cast<std::size_t>(key.first)], key.second);
    }

  private:
    std::optional<Begin> originOf(const TapeOrigin& from) {
        const Polygon& outline = m_flat.room.outline;
        const auto index = static_cast<std::size_t>(from.index);
        if (from.kind == TapeOrigin::Kind::Corner) {
            return Begin{outline[index], {}};
        }
        if (from.kind == TapeOrigin::Kind::Wall) { // the outline runs counter-clockwise
            return Begin{outline[index],
                         (outline[(index + 1) % outline.size()] - outline[index]).normalized()};
        }
        const std::optional<Vector2d> place = placeOf({from.index, from.kind == TapeOrigin::Kind::LastStop});
        return place ? std::optional(Begin{*place, {}}) : std::nullopt;
    }

    /// The meeting that lies in the room, or that the check tells.
    Vector2d chosen(const std::vector<Vector2d>& both, const MarkedPoint& point) {
        const bool isFirst = contains(m_flat.room.outline, both[0]);
        const bool isSecond = contains(m_flat.room.outline, both[1]);
        if (isFirst != isSecond) {
            return isFirst ? both[0] : both[1];
        }
        const std::optional<Begin> third = point.check ? originOf(point.check->from) : std::nullopt;
        if (!third) {
            return both[0];
        }
        const auto miss = [&](const Vector2d& place) {
            const double metres =
                third->wall ? turned(*third->wall).dot(place - third->at) : (place - third->at).norm();
            return std::abs(metres - asPrinted(point.check->metres));
        };
        return miss(both[0]) < miss(both[1]) ? both[0] : both[1];
    }

    const Flat& m_flat;
    std::map<Key, Vector2d> m_places;
};

std::vector<Person::Key> endsOf(const Flat& flat) {
    std::vector<Person::Key> ends;
    for (int i = 0; i < static_cast<int>(flat.marks.size()); ++i) {
        ends.emplace_back(i, false);
        ends.emplace_back(i, true);
    }
    return ends;
}

} // namespace

TEST(MarkingFlats, HaveSeveralRoomsAndThinWalls) {
    spherewalk::test::Random random(kSeed);
    std::size_t rooms = 0;
    for (int i = 0; i < kFlats; ++i) {
        test::FlatBuilder builder(random);
        EXPECT_NO_THROW(builder.build().validate());
        rooms += builder.rooms();
    }
    EXPECT_GT(rooms, 3 * kFlats);
}

TEST(MarkingFlats, ThePrintedDistancesGiveEveryPlaceWithinAMillimetre) {
    int points = 0;
    int hung = 0;
    double worst = 0;
    onFlats([&](const Flat& flat) {
        Person person(flat);
        for (const Person::Key& key : endsOf(flat)) {
            const std::optional<Vector2d> place = person.placeOf(key);
            ASSERT_TRUE(place) << "rail " << key.first + 1;
            const MarkedPoint& point = person.pointOf(key);
            EXPECT_LE((*place - point.point).norm(), 0.001) << "rail " << key.first + 1;
            worst = std::max(worst, (*place - point.point).norm());
            ++points;
            hung += point.tapes[0].from.kind != TapeOrigin::Kind::Corner ||
                            point.tapes[1].from.kind != TapeOrigin::Kind::Corner
                        ? 1
                        : 0;
        }
    });
    testing::Test::RecordProperty("points", points);
    testing::Test::RecordProperty("hung", hung);
    testing::Test::RecordProperty("worst_mm", fixed(1000 * worst, 2));
    EXPECT_GT(points, 100 * kFlats / 10);
}

TEST(MarkingFlats, NoTapeBeginsAtACornerThatAnotherWallHides) {
    onFlats([&](const Flat& flat) {
        for (const RailMark& mark : flat.marks) {
            for (const MarkedPoint* point : {&mark.first, &mark.last}) {
                std::vector<TapeDistance> tapes = point->tapes;
                if (point->check) {
                    tapes.push_back(*point->check);
                }
                for (const TapeDistance& tape : tapes) {
                    const Vector2d from = placeOf(tape.from, point->point, flat.room, flat.plan);
                    EXPECT_NEAR((from - point->point).norm(), tape.metres, 1e-9);
                    const double hook = std::min(0.5, 0.012 / tape.metres);
                    for (double share = hook; share <= 1; share += 0.01) {
                        const Vector2d at = from + share * (point->point - from);
                        ASSERT_TRUE(test::onFloor(flat.room, at)) << "rail " << mark.placement + 1;
                    }
                }
            }
        }
    });
}

TEST(MarkingFlats, NoPlaceIsOffByMoreThanTwentyMillimetresForReadingsFiveMillimetresWrong) {
    double worst = 0;
    onFlats([&](const Flat& flat) {
        for (const RailMark& mark : flat.marks) {
            for (const MarkedPoint* point : {&mark.first, &mark.last}) {
                ASSERT_TRUE(point->errorM) << "rail " << mark.placement + 1;
                EXPECT_LE(*point->errorM, kMostPlaceErrorM)
                    << "rail " << mark.placement + 1 << " at " << point->point.transpose();
                worst = std::max(worst, *point->errorM);
            }
        }
    });
    testing::Test::RecordProperty("worst_mm", fixed(1000 * worst, 1));
}

TEST(MarkingFlats, MisreadTapesMoveAPlaceAsFarAsIsPrinted) {
    onFlats([&](const Flat& flat) {
        for (const Person::Key& key : endsOf(flat)) {
            Person exact(flat);
            const std::optional<Vector2d> right = exact.placeOf(key);
            ASSERT_TRUE(right);
            const MarkedPoint& point = exact.pointOf(key);
            double most = 0;
            for (const double first : {-kReadingErrorM, kReadingErrorM}) {
                for (const double second : {-kReadingErrorM, kReadingErrorM}) {
                    Person person(flat);
                    person.misread = {{{key, 0}, first}, {{key, 1}, second}};
                    const std::optional<Vector2d> place = person.placeOf(key);
                    ASSERT_TRUE(place);
                    most = std::max(most, (*place - *right).norm());
                }
            }
            const double curvedM = 0.0005 + 0.05 * *point.errorM; // tapes swing in circles
            EXPECT_LE(most, *point.errorM + curvedM) << "rail " << key.first + 1;
            const bool isFromCorners = point.tapes[0].from.kind == TapeOrigin::Kind::Corner &&
                                       point.tapes[1].from.kind == TapeOrigin::Kind::Corner;
            if (isFromCorners) { // no other reading counts
                EXPECT_GE(most, *point.errorM - curvedM) << "rail " << key.first + 1;
            }
        }
    });
}

TEST(MarkingFlats, EveryRailCanBeChecked) {
    int unchecked = 0;
    int points = 0;
    onFlats([&](const Flat& flat) {
        for (const RailMark& mark : flat.marks) {
            const bool isRail = flat.plan.placements[static_cast<std::size_t>(mark.placement)].stops > 1;
            points += 1;
            unchecked += !mark.first.check && !mark.last.check ? 1 : 0;
            EXPECT_TRUE(mark.first.check || isRail); // a rail's length is a check by itself
        }
    });
    testing::Test::RecordProperty("rails", points);
    testing::Test::RecordProperty("rails_without_third_tape", unchecked);
}

} // namespace spherewalk::survey
