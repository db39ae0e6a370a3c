// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/core_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <iterator>
#include <vector>

namespace spherewalk::ui {

namespace {

constexpr const char* kContext = "spherewalk::ui::CoreWords";

/// The sentences of the core that people read in the window. Sources: core/photo/verdict,
/// core/jobs/survey, core/align/solve, core/jobs/export, core/jobs/measure.
constexpr const char* kSentences[] = {
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "It is %1 pixels wide instead of %2; set the camera's size and take it again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "It says that it is no whole stitched sphere; switch "
                                                   "stitching on in the camera and take it again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "It says that the camera hung upside down; put it upright and take it again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The camera leaned by %1 degrees; check its mount."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "It was exposed for %1 s instead of %2 s; take it again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "It was taken at ISO %1 instead of %2; take it again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "It was taken with a fixed white balance, against the "
                                                   "survey's settings; take it again if its colours differ."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "It was taken with automatic white balance, against the survey's settings; take it "
                      "again if its colours differ."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "It is too dark; check the lens and the exposure."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "It is too bright; check the exposure."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "It is %1 stops darker than its neighbours; check the exposure and the lamps."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "It is %1 stops brighter than its neighbours; check the exposure and the lamps."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "It is %1 stops darker than %2, and too few photos tell which of the two is wrong; "
                      "look at both, and take the wrong one again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "It is %1 stops brighter than %2, and too few photos tell which of the two is wrong; "
                      "look at both, and take the wrong one again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Its colours differ by %1 % from those of %2, and too few photos tell which of the two "
                      "is wrong; look at both, and take the wrong one again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Its colours differ by %1 % from its neighbours'; fix the "
                                                   "white balance, and check the lamps."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "%1 % of it is black; check that nothing covers a lens."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "%1 % of it is burnt out; shorten the exposure, or keep the light out."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Something is in view that its neighbours do not show, %1 degrees to the left of the "
                      "picture's middle (%2 % of the sphere); if it is a person, step aside and take it "
                      "again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Something is in view that its neighbours do not show, %1 degrees to the right of the "
                      "picture's middle (%2 % of the sphere); if it is a person, step aside and take it "
                      "again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The camera was turned by %1 degrees against its "
                                                   "neighbours, which all look one way; check its mount."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "It is blurred: its edges are %1 times as wide as they should be; let the camera come to "
        "rest and take it again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "It is upside down against its neighbours; put the camera upright and take it again."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "It does not look like its neighbours, however it is "
                                                   "turned; check that the camera stood at this station."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "It shows the same as %1, from the same place: the camera was not moved in between; "
                      "retake the one whose station is wrong."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "It seems to stand %1 cm from where it is tagged, farther off than the others: correct "
                      "its position, or retake it at its station."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "Its rotation against its neighbours is known to %1 deg only: it shares too little with "
        "them; retake it with more light, or with more to see."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "The model yaw does not solve its tilt, so its rotation against its neighbours is known "
        "to %1 deg only: take more photos near it."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "Its neighbours contradict %1 % of what it shows; look at the picture, and retake it if "
        "it is not of this place."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "It belongs to a part of the survey that nothing connects with the rest (%1 parts): "
                      "headings are right within the part, and the part's own rests on its positions alone; "
                      "take photos between the parts."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Where it was taken is known to %1 cm only: correct its "
                                                   "position, or retake it at its station."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "It was taken at one place with %1, though their tags lie %2 m apart: the camera was not "
        "moved between them."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Retake the one whose tag is wrong."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "There was nothing to solve."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "It was asked for."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The position tags are stated to be too rough for any other."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Photos with wrong tags are solved with their places."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The places were solved from the pictures."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The position tags are rough, so the places were solved from the pictures."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The height of the lens over the solved floor, %1 m, gives the scale, to %2 % (one "
                      "standard deviation)."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "A guessed height of the lens over the solved floor, %1 m, gives the scale, to %2 % (one "
        "standard deviation)."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The scale is known to %1 % (one standard deviation)."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The given distance gives the scale, to %1 % (one standard deviation)."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The printed size of the tags gives the scale, to %1 % (one standard deviation)."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Nothing gives the scale."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "The model '%1' is the richest, and every step to it helped: matches that were held out "
        "miss by %2."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "The model '%1' is the richest whose gain exceeds its noise: matches that were held out "
        "miss by %2."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "No other photo shares enough with it that a third one confirms: it seems to be of another place."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Leave it out, or take photos between it and the others."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "It was taken at one place with the others, so nothing tells how far things are: take "
                      "others half a metre from it."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Take photos between them."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The other photo shares too little with it: it seems to be of another place."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "It is the only photo, and nothing tells how far things are: take others half a metre from it."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "It belongs to part %1 of %2, which shares nothing certain with the largest part: take "
                      "photos between the parts."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "How far it is from the others is not known: it shares too little with two of them at a time."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Take another photo near it."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Little confirms where it was taken: it shares %1 points with %2 other photos."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "Only %1 of %2 photos hang together, too few to tell their place from another that looks "
        "like it."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Take photos between them and the others."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Where it was taken is known to %1 cm and %2 deg only: take another photo near it."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Two ways of solving turn it %1 deg apart: take another photo near it."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "It shows some things that the largest part shows, but not what stands around them: it "
                      "seems to be of another place that looks alike."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Little of what the largest part lets expect around it is there, so how it stands to "
                      "the others is not certain: take photos between it and them."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The floor around it lies %1 cm above that of the largest part: if there is no step, "
                      "lengths around it are %2 % too short."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The floor around it lies %1 cm below that of the largest part: if there is no step, "
                      "lengths around it are %2 % too long."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Take photos between it and the others."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "There is something by the name %1 already; choose another name, or remove it."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "No photo is left to export; capture some first, or accept some."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "How much space is left at %1 cannot be told."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "The dataset needs about %1, and %2 are free at %3; make space, or choose another place."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "The survey is not aligned: photos would be exported as if each looked along the "
                      "room's x axis; align it first."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "1 photo has no known heading: it would be exported as if it looked along the room's x "
                      "axis; align again, or reject it."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "1 station has no photo: near them, views come from farther away."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "%1 stations have no photo: near them, views come from farther away."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "1 photo was rejected and is left out."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "%1 photos were rejected and are left out."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "%1 photos have no known heading: they would be exported as if they looked along the room's "
        "x axis; align again, or reject them."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The alignment of %1 photos is doubtful; review them, or "
                                                   "export them as they are."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The alignment of 1 photo is doubtful; review it, or "
                                                   "export it as it is."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::CoreWords",
        "The cheapest that holds %1 px is the scene model %2 with sampling %3: 95 of 100 places "
        "are displaced by at most %4 px, in %5 ms a view."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "No option of this dataset holds %1 px in 95 of 100 places; the best, the scene model "
                      "%2 with sampling %3, reaches %4 px."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "No option of this dataset holds %1 px in 95 of 100 places; the best, the scene model "
                      "%2 with sampling %3, misses more than 5 of 100 places."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "None of the steps studied holds %1 px in 95 of 100 places; the best, %2 cm with the "
                      "scene model %3, reaches %4 px."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "None of the steps studied holds %1 px in 95 of 100 places; the best, %2 cm with the "
                      "scene model %3, misses more than 5 of 100 places."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Study a denser block, or allow more."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "For %1 px in 95 of 100 places a grid of %2 cm is enough with the scene model %3 (no "
                      "coarser one was studied): %4 photos, about %5."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "For %1 px in 95 of 100 places a grid of %2 cm is enough with the scene model %3: %4 "
                      "photos, about %5."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Take photos closer together."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Take photos closer together, or export the dataset with "
                                                   "a richer scene model."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Faces cannot be looked for: there is no file %1."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords",
                      "Install the package opencv-data, or mark the regions yourself."),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "The file %1 is no cascade."),
};

/// What the core says that it does now, while it works. A step that others match, too, comes after them.
constexpr const char* kSteps[] = {
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Looking for features"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Matching photos"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Looking for AprilTags"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Looking for photos that look alike"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Averaging rotations"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Comparing what photos show"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Solving"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Solved"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Placed"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Aligned"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Reading what the photos say"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Estimating how neighbours are turned to each other"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Checking the positions"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Looking for what moved"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Looking for what stands where other photos look through"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Writing the photos' position tags"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Retagged"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Photo %1 of %2, %3"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Judging photo %1 of %2"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Importing photo %1 of %2"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Looking at the place of %1"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Looked at all places"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Writing photo %1 of %2"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Estimating depth, photo %1 of %2"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Clearing the floor below the camera, photo %1 of %2"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Trying one photo"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Trying one depth"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Looking at the survey"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Making boxes of furniture"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Finding surfaces"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Reading depth %1 of %2"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Painting surfaces, photo %1 of %2"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Fusing depths"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Looking for faces in photo %1 of %2"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Looking which photos see each other"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Foretelling how far views are off"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Drawing picture %1 of %2"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Rendering the walk"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Registering picture %1 of %2 by its tags"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Comparing picture %1 of %2 again"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Comparing picture %1 of %2"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Comparing border %1 of %2"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Comparing view %1 of %2"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Grid of %1: comparing view %2 of %3"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Comparing with the exact room"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Timing views"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Checking the dataset"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Checking the database"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Checked"),
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "rail %1, stop %2"), // as steps name stations
    QT_TRANSLATE_NOOP("spherewalk::ui::CoreWords", "Checking %1"),
};

/// A sentence with the expression that finds it.
struct Pattern {
    const char* sentence;
    QRegularExpression expression;
};

const QRegularExpression& place() {
    static const QRegularExpression expression("%[1-9]");
    return expression;
}

/// Finds a sentence whose "%1" and so on stand for values in this order.
QRegularExpression expressionOf(const QString& sentence) {
    QString pattern;
    qsizetype at = 0;
    for (auto found = place().globalMatch(sentence); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        pattern += QRegularExpression::escape(sentence.mid(at, match.capturedStart() - at)) + "(.+?)";
        at = match.capturedEnd();
    }
    return QRegularExpression("^" + pattern + QRegularExpression::escape(sentence.mid(at)) + "$");
}

const std::vector<Pattern>& patterns() {
    static const std::vector<Pattern> all = [] {
        std::vector<Pattern> made;
        const auto add = [&](const char* sentence) {
            made.push_back({sentence, expressionOf(QString::fromUtf8(sentence))});
        };
        std::for_each(std::begin(kSentences), std::end(kSentences), add);
        std::for_each(coreErrors().begin(), coreErrors().end(), add);
        std::for_each(alignmentSentences().begin(), alignmentSentences().end(), add);
        std::for_each(std::begin(kSteps), std::end(kSteps), add);
        return made;
    }();
    return all;
}

QString translatedSentence(const QString& sentence, const KnownSentence& told);

/// Translates a value that is a part of a sentence itself, and writes numbers as the language does.
QString localValue(const QString& value) {
    static const QRegularExpression decimal("(?<=\\d)\\.(?=\\d)");
    static const QRegularExpression number("^[-+]?\\d+\\.\\d+( .*)?$");
    return number.match(value).hasMatch() ? QString(value).replace(decimal, QLocale().decimalPoint())
                                          : translatedSentence(value, {});
}

QString translatedSentence(const QString& sentence, const KnownSentence& told) {
    for (const Pattern& pattern : patterns()) {
        const QRegularExpressionMatch match = pattern.expression.match(sentence);
        if (!match.hasMatch()) {
            continue;
        }
        if (told) {
            told(pattern.sentence);
        }
        const QString words = QCoreApplication::translate(kContext, pattern.sentence);
        QString result;
        qsizetype at = 0;
        // In one pass, since a value may contain what looks like a place itself.
        for (auto found = place().globalMatch(words); found.hasNext();) {
            const QRegularExpressionMatch value = found.next();
            result += words.mid(at, value.capturedStart() - at);
            result += localValue(match.captured(value.captured().back().digitValue()));
            at = value.capturedEnd();
        }
        return result + words.mid(at);
    }
    return sentence;
}

} // namespace

QString coreWords(const QString& text, const KnownSentence& told) {
    static const QRegularExpression between("(?<=[.!?])\\s+(?=[A-Z0-9])");
    QStringList sentences = text.split(between);
    for (QString& sentence : sentences) {
        sentence = translatedSentence(sentence, told);
    }
    return sentences.join(' ');
}

QString coreWords(const std::string& text) {
    return coreWords(QString::fromStdString(text));
}

} // namespace spherewalk::ui
