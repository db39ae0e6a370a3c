// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/sight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace spherewalk::align {

namespace {

/// A photo that shows what no neighbour does, wherever it is.
const SightPhoto kPhoto{{}, Rigid3()};
const PhotoSight kUnlikeAll(kSightCells);

/// Knows of a surface somewhere, and not where: a bare wall.
Observer unsure() {
    Observer made;
    made.nearest.assign(kSightCells, static_cast<float>(1 / kNearestSightM));
    made.farthest.assign(kSightCells, 0);
    return made;
}

/// Stands a metre before the photo and sees a wall two metres on. It is unsure of what lies behind it.
Observer aheadOfIt() {
    Observer made = unsure();
    made.positionM = {1, 0, 0};
    for (int cell = 0; cell < kSightCells; ++cell) {
        if (sightDirection(cell / kSightColumns, cell % kSightColumns).x() > 0.5F) {
            made.nearest[static_cast<std::size_t>(cell)] = 0.5F;
            made.farthest[static_cast<std::size_t>(cell)] = 0.5F;
        }
    }
    return made;
}

/// Stands where the photo does and sees a wall three metres on.
Observer besideIt() {
    Observer made;
    made.nearest.assign(kSightCells, 1.0F / 3);
    made.farthest.assign(kSightCells, 1.0F / 3);
    return made;
}

/// Stands two metres before the photo, looks back, and sees the back of a thing 25 cm ahead of it.
Observer behindWhatIsBesideIt() {
    Observer made = unsure();
    made.positionM = {2.25F, 0, 0};
    made.nearest.assign(kSightCells, 0.5F);
    made.farthest.assign(kSightCells, 0.5F);
    return made;
}

/// What the photo shows straight ahead, below the lamps.
Foreign ahead(std::vector<Observer> observers) {
    observers.resize(10, unsure());
    std::vector<const Observer*> all;
    for (const Observer& observer : observers) {
        all.push_back(&observer);
    }
    const int cell = sightCell({1, 0.01F, -0.01F});
    return foreignCells(kPhoto, kUnlikeAll, all)[static_cast<std::size_t>(cell)];
}

Foreign ahead(std::size_t count, const Observer& as) {
    return ahead(std::vector<Observer>(count, as));
}

} // namespace

TEST(Sightline, IsForeignWhereTwoPhotosLookThroughAllTheWay) {
    EXPECT_EQ(ahead(2, besideIt()), Foreign::Yes);
    EXPECT_EQ(ahead(1, besideIt()), Foreign::Unwitnessed);
}

TEST(Sightline, MayEndBeforeWhereTwoPhotosLookThrough) {
    // A plant may stand where no photo can tell, 40 cm from the lens.
    EXPECT_EQ(ahead(2, aheadOfIt()), Foreign::Unwitnessed);
    EXPECT_EQ(ahead(4, aheadOfIt()), Foreign::Yes);
}

TEST(Sightline, KnowsWhatIsBesideTheLensByOthersThatShowItsOtherSide) {
    const Observer behind = behindWhatIsBesideIt();
    EXPECT_EQ(ahead({behind, behind, besideIt()}), Foreign::Yes) << "One looks through it.";
    EXPECT_EQ(ahead({behind, behind}), Foreign::No);
}

} // namespace spherewalk::align
