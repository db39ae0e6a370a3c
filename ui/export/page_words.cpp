// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/page_words.h"

#include "ui/look/core_words.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace spherewalk::ui {

namespace {

constexpr const char* kContext = "spherewalk::ui::PageWords";

/// The words of resources/web/words.json.
constexpr std::string_view kWords[] = {
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Panorama"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Panorama of %1. Drag, or use the arrow keys."),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Plan"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Plan of the room with the photos"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Photo"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Station"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "On the floor"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "nothing"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Measure"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Distances"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords",
                      "± is one standard deviation of the depth and of the click. A scale that is wrong for "
                      "the whole room is not in it."),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Remove the last one"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Keys"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Close"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Walk ahead"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Walk back"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Zoom in"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Zoom out"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords",
                      "This page needs JavaScript, which is switched off in this browser."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::PageWords",
        "This browser shows no 3D graphics (WebGL), so there are no panoramas. Plan and notes work."),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords",
                      "The file %1 could not be read. The folder must be copied whole."),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "1 photo"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "%1 photos"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "made by %1 on %2"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "good"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "doubtful"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "failed the checks"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "not judged"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "accepted by a person"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "no photo"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "photo rejected"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "photo not placed: its alignment failed"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords",
                      "This page was made of a dataset, which has no verdicts and no notes."),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Note: %1"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "x %1 m, y %2 m, %3 m high"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "x %1 m, y %2 m, %3 m high, ± %4 m"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Views that replace this photo are off by %1 pixels."),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "The heading of this photo is not known."),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "This photo has no depth: nothing can be measured in it."),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "The depth there was not measured."),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords",
                      "Choose a point, with a click or with Enter for the middle."),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Choose the other end."),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "There is no photo to walk to in this direction."),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "%1 m ± %2 m"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "turn"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "walk ahead and back"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "look up and down"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "zoom"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "look level"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "measure a distance"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "while measuring: take the middle of the picture"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "while measuring: take back the last point"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "end measuring"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "this list"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Coverage"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords",
                      "Floor within reach of a photo: half the diagonal of the grid's cell"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "covered"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Error of views"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords",
                      "95th percentile of displacement where the photo was left out"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Uncertainty of the heading"),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::PageWords",
        "Standard deviation of each photo's heading, in pixels of a camera of 640 pixels and 57 degrees"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "%1 px"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "%1 px, the tolerance"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "%1 px and less"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "%1 px and more"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "not measured"),
};

} // namespace

std::string pageWord(const std::string& english) {
    const bool isKnown = std::ranges::find(kWords, english) != std::end(kWords);
    return (isKnown ? QCoreApplication::translate(kContext, english.c_str()) : coreWords(english))
        .toStdString();
}

} // namespace spherewalk::ui
