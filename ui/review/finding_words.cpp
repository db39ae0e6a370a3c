// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/finding_words.h"

#include "ui/look/words.h"
#include "ui/map/station_words.h"

#include "spherewalk/base/json.h"
#include "spherewalk/geometry/rotation.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace spherewalk::ui {

namespace {

/// The words of this file, for translators.
struct FindingWords {
    Q_DECLARE_TR_FUNCTIONS(spherewalk::ui::FindingWords)
};

QRegularExpressionMatch placeIn(const QString& sentence) {
    static const QRegularExpression place("(\\d+) degrees to the (left|right) of the picture's middle"
                                          "(?:, (\\d+) degrees (above|below) the horizon)?"
                                          " \\(([0-9.]+) % of the sphere\\)");
    return place.match(sentence);
}

QString foreignText(const QString& sentence) {
    const QRegularExpressionMatch found = placeIn(sentence);
    return found.hasMatch() ? FindingWords::tr("foreign, %L1 %").arg(found.captured(5).toDouble(), 0, 'f', 1)
                            : FindingWords::tr("foreign");
}

} // namespace

QString shortText(const photo::Finding& finding) {
    using photo::Flaw;
    switch (finding.flaw) {
    case Flaw::Damaged:
        return FindingWords::tr("damaged");
    case Flaw::Size:
        return FindingWords::tr("other size");
    case Flaw::Kind:
        return FindingWords::tr("no sphere");
    case Flaw::Settings:
        return FindingWords::tr("other settings");
    case Flaw::Brightness:
        return FindingWords::tr("too dark or bright");
    case Flaw::Colour:
        return FindingWords::tr("other colours");
    case Flaw::Blur:
        return FindingWords::tr("blurred");
    case Flaw::Black:
        return FindingWords::tr("black area");
    case Flaw::Burnt:
        return FindingWords::tr("burnt area");
    case Flaw::Foreign:
        return foreignText(QString::fromStdString(finding.sentence));
    case Flaw::UpsideDown:
        return FindingWords::tr("leaning");
    case Flaw::Turned:
        return FindingWords::tr("turned");
    case Flaw::Elsewhere:
        return FindingWords::tr("elsewhere");
    case Flaw::Unmoved:
        return FindingWords::tr("not moved");
    }
    return {};
}

QString shortText(const QString& sentence) {
    return placeIn(sentence).hasMatch() ? foreignText(sentence) : sentence;
}

std::optional<PhotoArea> areaOf(const QString& sentence) {
    const QRegularExpressionMatch found = placeIn(sentence);
    if (!found.hasMatch()) {
        return std::nullopt;
    }
    constexpr double kMargin = 1.4;
    constexpr double kLeastDeg = 4;
    constexpr double kUsualElevationDeg = -12; // people and chairs, where only the side is told
    constexpr double kUsualHalfHeightDeg = 40;
    const double part = 0.01 * found.captured(5).toDouble();
    const double radiusDeg = Degrees(Radians(std::acos(std::clamp(1 - 2 * part, -1.0, 1.0)))).value();
    const double half = std::max(kLeastDeg, kMargin * radiusDeg);
    const double azimuth = (found.captured(2) == "left" ? 1 : -1) * found.captured(1).toDouble();
    PhotoArea area{Degrees(azimuth), Degrees(kUsualElevationDeg), Degrees(half),
                   Degrees(kUsualHalfHeightDeg)};
    if (found.hasCaptured(3)) {
        area.elevation = Degrees((found.captured(4) == "above" ? 1 : -1) * found.captured(3).toDouble());
        area.halfHeight = Degrees(half);
    }
    return area;
}

namespace {

QString timeWords(store::Moment at) {
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(at.time_since_epoch()).count();
    return QLocale().toString(QDateTime::fromMSecsSinceEpoch(ms), QLocale::ShortFormat);
}

QString takenWords(const store::PhotoRecord& photo) {
    const QString file = QString::fromStdString(photo.cameraFileName);
    const QString taken = photo.takenAt
                              ? FindingWords::tr("Taken %1 as %2").arg(timeWords(*photo.takenAt), file)
                              : FindingWords::tr("Taken as %1, it does not say when").arg(file);
    const QString camera =
        photo.cameraSerial.empty()
            ? QString()
            : FindingWords::tr(", by the camera %1").arg(QString::fromStdString(photo.cameraSerial));
    return FindingWords::tr("%1%2; stored %3.").arg(taken, camera, timeWords(photo.addedAt));
}

QString judgedWords(const store::SurveyStore& store, std::int64_t photo) {
    const auto verdict = store.verdict(photo);
    if (!verdict) {
        return FindingWords::tr("No check has judged it.");
    }
    const auto findings = static_cast<int>(Json::parse(verdict->findings).size());
    return findings == 0 ? FindingWords::tr("The checks found nothing.")
                         : FindingWords::tr("The checks found %n thing(s).", nullptr, findings);
}

QString solvedWords(const store::SurveyStore& store, std::int64_t photo) {
    const auto solution = store.activeSolution();
    if (!solution) {
        return FindingWords::tr("It is not aligned yet.");
    }
    const std::vector<store::SolvedPhoto> solved = store.solvedPhotos(solution->id);
    const auto found = std::find_if(solved.begin(), solved.end(),
                                    [&](const store::SolvedPhoto& one) { return one.photo == photo; });
    const QString when = timeWords(solution->createdAt);
    if (found == solved.end()) {
        return FindingWords::tr("The alignment of %1 found no heading for it.").arg(when);
    }
    const double yawDeg = Degrees(yawPitchRoll(found->roomFromPhoto).yaw).value();
    return found->sigmaYawRad
               ? FindingWords::tr("Aligned %1: it looks along %L2 degrees, known to %L3 degrees.")
                     .arg(when)
                     .arg(yawDeg, 0, 'f', 1)
                     .arg(Degrees(Radians(*found->sigmaYawRad)).value(), 0, 'f', 3)
               : FindingWords::tr("Aligned %1: it looks along %L2 degrees.").arg(when).arg(yawDeg, 0, 'f', 1);
}

QString decidedWords(const store::Review& review) {
    switch (review.decision) {
    case store::Decision::Accepted:
        return FindingWords::tr("Somebody has accepted it.");
    case store::Decision::Rejected:
        return FindingWords::tr("Somebody has rejected it.");
    case store::Decision::Open:
        break;
    }
    return FindingWords::tr("Nobody has decided on it yet.");
}

} // namespace

QStringList storyOf(const store::SurveyStore& store, std::int64_t photo) {
    const store::PhotoRecord record = store.photo(photo);
    QStringList story{takenWords(record)};
    const auto shot = store.shotOf(photo);
    if (shot && shot->station != record.station) {
        story << FindingWords::tr("Moved here from %1, where it was tagged first.")
                     .arg(stationWords(store.station(shot->station).name));
    }
    const auto others = static_cast<int>(store.photosAt(record.station).size()) - 1;
    if (others > 0) {
        story << FindingWords::tr("The station has %n other photo(s).", nullptr, others);
    }
    story << judgedWords(store, photo) << solvedWords(store, photo) << decidedWords(store.review(photo));
    return story;
}

} // namespace spherewalk::ui
