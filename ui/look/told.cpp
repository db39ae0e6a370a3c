// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/told.h"

#include "ui/look/core_words.h"
#include "ui/look/told_label.h"

#include <QCoreApplication>
#include <QDesktopServices>
#include <QFocusEvent>
#include <QUrl>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace spherewalk::ui {

namespace {

constexpr auto kLinkContext = "spherewalk::ui::Told";

/// How a place is linked to, and what the link says.
struct Place {
    Cure cure;
    const char* path;
    const char* words;
};

constexpr Place kPlaces[] = {
    {Cure::Start, "start", QT_TRANSLATE_NOOP("spherewalk::ui::Told", "Open a survey")},
    {Cure::Plan, "plan", QT_TRANSLATE_NOOP("spherewalk::ui::Told", "Go to Plan")},
    {Cure::Capture, "capture", QT_TRANSLATE_NOOP("spherewalk::ui::Told", "Go to Capture")},
    {Cure::CameraAddress, "capture/address", QT_TRANSLATE_NOOP("spherewalk::ui::Told", "Change the address")},
    {Cure::Connecting, "guide/connecting", QT_TRANSLATE_NOOP("spherewalk::ui::Told", "What the guide says")},
    {Cure::Exposure, "capture/exposure", QT_TRANSLATE_NOOP("spherewalk::ui::Told", "Change the exposure")},
    {Cure::Review, "review/doubtful", QT_TRANSLATE_NOOP("spherewalk::ui::Told", "Go to Review")},
    {Cure::Regions, "review/regions", QT_TRANSLATE_NOOP("spherewalk::ui::Told", "Look at them")},
    {Cure::Align, "align", QT_TRANSLATE_NOOP("spherewalk::ui::Told", "Go to Align")},
    {Cure::ExportFolder, "export/folder", QT_TRANSLATE_NOOP("spherewalk::ui::Told", "Choose the folder")},
    {Cure::ExportDepth, "export/scene", QT_TRANSLATE_NOOP("spherewalk::ui::Told", "Export with depth")},
};

const Place* placeOf(Cure cure) {
    const auto* found = std::find_if(std::begin(kPlaces), std::end(kPlaces),
                                     [cure](const Place& place) { return place.cure == cure; });
    return found != std::end(kPlaces) ? found : nullptr;
}

constexpr CuredSentence kCured[] = {
    {"Could not reach the camera at %1 within %2; press its power button in case it sleeps, and check that "
     "this computer is on the camera's WiFi.",
     Cure::Connecting},
    {"No answer from the camera at %1 within %2; press its power button in case it sleeps, and check the "
     "WiFi.",
     Cure::Connecting},
    {"Could not reach the camera at %1 (%2); check that it is switched on, that no USB data cable is plugged "
     "in, and that this computer is on its WiFi.",
     Cure::Connecting},
    {"The connection to the camera at %1 broke (%2); move closer to the camera, check the WiFi, and try "
     "again.",
     Cure::Connecting},
    {"What answers at http://%1 is not a spherical camera (%2); check that this computer is on the camera's "
     "WiFi and not also on another network with the same addresses, and check the address.",
     Cure::Connecting},
    {"What answers at %1 does not speak HTTP; check the address of the camera.", Cure::CameraAddress},
    {"What answers at %1 sent more than a camera would; check the address.", Cure::CameraAddress},
    {"The camera's address \"%1\" cannot be used; write it like 192.168.1.1 or http://127.0.0.1:8080.",
     Cure::CameraAddress},
    {"The camera takes no photos %1 pixels wide, but %2.", Cure::Exposure},
    {"The camera does not offer the white balance %1.", Cure::Exposure},
    {"The camera does not offer the %1 %2; the nearest are %3.", Cure::Exposure},
    {"Change the survey's capture profile.", Cure::Exposure},
    {"There is nothing to align in %1: no station has a photo yet; capture or import some first.",
     Cure::Capture},
    {"It is %1 pixels wide instead of %2; set the camera's size and take it again.", Cure::Capture},
    {"It says that it is no whole stitched sphere; switch stitching on in the camera and take it again.",
     Cure::Capture},
    {"It says that the camera hung upside down; put it upright and take it again.", Cure::Capture},
    {"It was exposed for %1 s instead of %2 s; take it again.", Cure::Capture},
    {"It was taken at ISO %1 instead of %2; take it again.", Cure::Capture},
    {"Something is in view that its neighbours do not show, %1 degrees to the left of the picture's middle "
     "(%2 % of the sphere); if it is a person, step aside and take it again.",
     Cure::Capture},
    {"Something is in view that its neighbours do not show, %1 degrees to the right of the picture's middle "
     "(%2 % of the sphere); if it is a person, step aside and take it again.",
     Cure::Capture},
    {"It is blurred: its edges are %1 times as wide as they should be; let the camera come to rest and take "
     "it again.",
     Cure::Capture},
    {"It is upside down against its neighbours; put the camera upright and take it again.", Cure::Capture},
    {"No photo is left to export; capture some first, or accept some.", Cure::Capture},
    {"Aligning from the pictures alone finds that out.", Cure::Align},
    {"The survey is not aligned: photos would be exported as if each looked along the room's x axis; align "
     "it "
     "first.",
     Cure::Align},
    {"1 photo has no known heading: it would be exported as if it looked along the room's x axis; align "
     "again, or "
     "reject it.",
     Cure::Align},
    {"The dataset needs about %1, and %2 are free at %3; make space, or choose another place.",
     Cure::ExportFolder},
    {"1 station has no photo: near them, views come from farther away.", Cure::Capture},
    {"%1 stations have no photo: near them, views come from farther away.", Cure::Capture},
    {"No photo could be aligned, so no solution was recorded; see what is said of each photo.", Cure::Align},
    {"The heading of %1 of %2 photos is not known; they are exported as if each looked along the room's x "
     "axis.",
     Cure::Align},
    {"Give the height of the lens, or the distance between two photos.", Cure::Align},
    {"%1 photos have no known heading: they would be exported as if they looked along the room's x axis; "
     "align again, or reject them.",
     Cure::Align},
    {"The alignment of %1 photos is doubtful; review them, or export them as they are.", Cure::Review},
    {"The alignment of 1 photo is doubtful; review it, or export it as it is.", Cure::Review},
    {"The outline cannot be used: %1.", Cure::Plan},
    {"The obstacle %1 cannot be used: %2.", Cure::Plan},
    {"%1 photos stand outside of the room's outline; check the outline and the positions.", Cure::Plan},
    {"The photos do not show where walls, floor and ceiling are, and no room is drawn: the dataset has no "
     "room.",
     Cure::Plan},
    {"Take photos closer together.", Cure::Plan},
    {"It belongs to a part of the survey that nothing connects with the rest (%1 parts): headings are right "
     "within the part, and the part's own rests on its positions alone; take photos between the parts.",
     Cure::Plan},
    {"There is something by the name %1 already; choose another name, or remove it.", Cure::ExportFolder},
    {"Take photos closer together, or export the dataset with a richer scene model.", Cure::ExportDepth},
};

Cure cureOf(const char* sentence) {
    const auto* found = std::find_if(std::begin(kCured), std::end(kCured), [&](const CuredSentence& cured) {
        return std::string_view(cured.sentence) == sentence;
    });
    return found != std::end(kCured) ? found->cure : Cure::None;
}

} // namespace

std::span<const CuredSentence> curedSentences() {
    return kCured;
}

Told coreTold(const QString& text) {
    Told told;
    told.text = coreWords(text, [&told](const char* sentence) {
        told.cure = told.cure == Cure::None ? cureOf(sentence) : told.cure;
    });
    return told;
}

Told coreTold(const std::string& text) {
    return coreTold(QString::fromStdString(text));
}

QUrl linkTo(Cure cure) {
    const Place* place = placeOf(cure);
    return place != nullptr ? QUrl(QString("%1:%2").arg(kLinkScheme, place->path)) : QUrl();
}

QString linkWords(Cure cure) {
    const Place* place = placeOf(cure);
    return place != nullptr ? QCoreApplication::translate(kLinkContext, place->words) : QString();
}

ToldLabel::ToldLabel(QWidget* parent) : QLabel(parent) {
    setWordWrap(true);
    setTextFormat(Qt::PlainText);
    setTextInteractionFlags(Qt::TextSelectableByMouse);
    // The window follows its own links, whoever hands them to the desktop.
    connect(this, &QLabel::linkActivated, this,
            [](const QString& link) { QDesktopServices::openUrl(QUrl(link)); });
}

void ToldLabel::tell(const QList<Told>& lines) {
    QStringList plain;
    QStringList rich;
    bool hasLink = false;
    for (const Told& line : lines) {
        plain << line.text;
        rich << line.text.toHtmlEscaped().replace(QLatin1Char('\n'), QStringLiteral("<br>"));
        if (const QUrl link = linkTo(line.cure); !link.isEmpty()) {
            hasLink = true;
            rich.last() += QString(line.isEmpty() ? "<a href=\"%1\">%2</a>" : " <a href=\"%1\">%2</a>")
                               .arg(link.toString(), linkWords(line.cure).toHtmlEscaped());
        }
    }
    m_words = plain.join(QLatin1Char('\n'));
    const Qt::TextFormat format = hasLink ? Qt::RichText : Qt::PlainText;
    if (format != textFormat()) {
        constexpr Qt::TextInteractionFlags kLinks =
            Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard;
        setTextFormat(format);
        setTextInteractionFlags(hasLink ? Qt::TextSelectableByMouse | kLinks
                                        : Qt::TextInteractionFlags(Qt::TextSelectableByMouse));
    }
    setText(hasLink ? rich.join(QStringLiteral("<br>")) : m_words);
    if (hasLink && hasFocus()) { // of what it said before
        QLabel::focusNextPrevChild(true);
    }
}

/// Goes to the first link at once, or to the last one from behind. Else Tab would first stop at the label.
void ToldLabel::focusInEvent(QFocusEvent* event) {
    QLabel::focusInEvent(event);
    if (textFormat() == Qt::RichText &&
        (event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason)) {
        QLabel::focusNextPrevChild(event->reason() == Qt::TabFocusReason);
    }
}

} // namespace spherewalk::ui
