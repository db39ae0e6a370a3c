// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/finding_words.h"

#include "ui/look/core_words.h"

#include <QCoreApplication>
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
    return placeIn(sentence).hasMatch() ? foreignText(sentence) : coreWords(sentence);
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

} // namespace spherewalk::ui
