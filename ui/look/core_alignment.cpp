// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/core_words.h"

#include <QtGlobal>

namespace spherewalk::ui {

namespace {

/// What is said first stands first where another sentence would fit as well.
constexpr const char* kOfAlignments[] = {
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "What its neighbours see there stands about %1 degrees away in this photo: it moved."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "What its neighbours see there is not in this photo: it moved, vanished or is covered."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "one stop farther along its rail than its tag says"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "one stop before the one that its tag says"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "It is one of %1 photos taken %2: it shows what is seen from %3."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "It was taken about %1 m from where its tag says, where "
                                                   "no photo is planned: one stop off the end of its rail."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "It was taken about %1 m from where its tag says, where no photo is planned."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "It was taken %1: it shows what is seen from %2."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Its rail was walked from the other end: it shows what is seen from %1."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "It shows what is seen from %1; the photo tagged so shows %2: they are swapped."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "It shows what is seen from %1."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "It would lean by %1 deg from what its camera states of its tilt."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "It would lean by %1 deg from upright, though it states no tilt."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "Its rotation is therefore not known: check its position, and retake it if that is right."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Its rotation is therefore not known: take another photo beside it."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "All photos of %1 lie on one line."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Nothing but the tilts that they state holds the turn about that line, which is known "
                      "to %1 deg (one standard deviation)."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Add a second rail, or one photo, beside the line."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "%1 of %2 photos lean by more than 3 degrees from what "
                                                   "they state, or from upright if they state nothing."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Most leans %1: by %2 deg."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "If the camera stood level, look at these photos, and at their positions."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Half a turn about the line to its neighbours explains what it shows about as well."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Which way it looks is not known: too little of what it shares with its neighbours "
                      "lies clearly in front of them, so half a turn explains it as well."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Take a photo between them, or nearer to things."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "How it is turned against the others is not known: its position asks for another turn "
                      "than what it shows in common with its neighbours."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Its place contradicts how far the position tags put it from a neighbour: what both "
                      "show alike may be of two places."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Check the positions."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Its matches contradict where the other photos are."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Check its position tag."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "There is no other photo to compare it with."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "It was compared with no other photo."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "No neighbour shares enough with it."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Compared with %1 photos, it shares enough with %2, and nothing confirms that."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "What its neighbours say of it contradicts what they say of each other."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The survey falls into %1 parts that share no photo pair; part %2 is %3."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Each part is aligned for itself, by its positions: take photos between them."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Nothing fixes the common heading of %1: they stand at one place."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Only how they are turned to each other is known."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "The positions of %1 contradict what the photos show of them (%2 % of the directions agree)."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "They seem to be off by about %1 m."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Check the position tags, or state how rough they are."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "The alignment of %1 is doubtful: only %2 % of the matches that pairs agreed on fit it."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The photos fall into %1 parts that share nothing certain; part %2 is %3."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Only the largest part is placed: take photos between the parts."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "By the printed size of the tags, the given distance is %1 % too long."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "By the printed size of the tags, the given distance is %1 % too short."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "By the printed size of the tags, the height of the lens is %1 % too long."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "By the printed size of the tags, the height of the lens is %1 % too short."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "By the printed size of the tags, lengths in the other survey's frame are %1 % too long."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "By the printed size of the tags, lengths in the other survey's frame are %1 % too short."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "By the printed size of the tags, all tapes are %1 % too long (known to %2 %)."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "By the printed size of the tags, all tapes are %1 % too short (known to %2 %)."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Measure the printed tags and the distance again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Measure the printed tags, and the height of the lens."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Measure a printed tag with a ruler, then the tapes."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "Perhaps a tag was moved between the surveys, or the size of their tags was given differently."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "AprilTag %1 hangs elsewhere than in the other survey, and was not used to join them."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Hang tags where nobody moves them."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The scale is not known: the photos show too little of "
                                                   "the floor below them, and no distance was given."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Give the distance between two photos."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Nobody said how high the lens stands over the floor: %1 "
                                                   "m is a guess, and all lengths may be wrong by a "
                                                   "quarter and more."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "All lengths are known to %1 % alone (one standard deviation): align the survey with a "
                      "known height of the lens, or a known distance, and export again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Nobody has drawn the room: its walls are a rectangle around what the photos show."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The world of a dataset with depth has walls as they stand."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Give the height of the lens, or the distance between two photos."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "Where AprilTag %1 hangs is not known: 1 photo sees it (%2), but not from places far enough apart."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "Where AprilTag %1 hangs is not known: %2 photos see it (%3), but not from places far enough apart."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Take a photo near it."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "AprilTag %1 hangs in more than one place, or was moved: "
                                                   "%2 photos see it at (%3, %4, %5), but %6 elsewhere."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Hang each number once."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "No AprilTag was found that two photos see: hang tags where photos see them from up to "
                      "4 m away, or leave out --tag-size."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Something stands where other photos look through: %1 degrees to the left of the "
                      "picture's middle, %2 degrees above the horizon (%3 % of the sphere)."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Something stands where other photos look through: %1 degrees to the left of the "
                      "picture's middle, %2 degrees below the horizon (%3 % of the sphere)."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Something stands where other photos look through: %1 degrees to the right of the "
                      "picture's middle, %2 degrees above the horizon (%3 % of the sphere)."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Something stands where other photos look through: %1 degrees to the right of the "
                      "picture's middle, %2 degrees below the horizon (%3 % of the sphere)."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "If it is a person, step aside and take it again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The file %1 cannot be read; retake the photo."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "The position tags are mirrored: one axis points the wrong way, or x and y are exchanged."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "No photo is aligned; correct the axis in all positions, and align again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The scale of the tags differs along the axes: against x, the tags are %1 times as "
                      "long along y as the photos show."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "Measure the steps along the rails and between them, correct the positions, and align again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The scale of the tags is wrong, or the height of the lens: by the floor that the "
                      "photos show, the tags lie %1 times as far apart as the photos."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "Measure the rail's steps and the lens's height, correct what is wrong, and align again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "How 1 photo is turned is not known: %1."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "How %1 photos are turned is not known: %2."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "1 photo is left out, since the alignment found no pose that holds: %1."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "%1 photos are left out, since the alignment found no pose that holds: %2."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "1 photo is left out, since nobody knows where it was taken: %1."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "%1 photos are left out, since nobody knows where they were taken: %2."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Aligning from the pictures alone finds that out."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Look at what the alignment says of each, mend it, and align again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The alignment puts 1 photo nearer to another station than to the photo's own: %1."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The alignment puts %1 photos nearer to another station than to the photo's own: %2."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The dataset has the solved places; retag the photos, and align again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "1 photo has left the alignment, which was made with the "
                                                   "earlier places; align again before you export."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "%1 photos have left the alignment, which was made with "
                                                   "the earlier places; align again before you export."),
};

} // namespace

std::span<const char* const> alignmentSentences() {
    return kOfAlignments;
}

} // namespace spherewalk::ui
