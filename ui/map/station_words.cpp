// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/map/station_words.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace spherewalk::ui {

namespace {

/// The words of this file, for translators.
struct StationWords {
    Q_DECLARE_TR_FUNCTIONS(spherewalk::ui::StationWords)
};

QString originWords(const survey::TapeOrigin& origin, const survey::Room& room) {
    using Kind = survey::TapeOrigin::Kind;
    switch (origin.kind) {
    case Kind::Corner:
        return QString::fromStdString(survey::cornerName(origin.index));
    case Kind::FirstStop:
        return StationWords::tr("ring %1").arg(origin.index + 1);
    case Kind::LastStop:
        return StationWords::tr("arrow %1").arg(origin.index + 1);
    case Kind::Wall:
        return QString::fromStdString(survey::wallName(room, origin.index));
    }
    return {};
}

QString tapeWords(const survey::TapeDistance& tape, const survey::Room& room) {
    return StationWords::tr("%1 %L2 m").arg(originWords(tape.from, room)).arg(tape.metres, 0, 'f', 3);
}

QString tapeWords(const survey::MarkedPoint& point, const survey::Room& room) {
    if (point.tapes.size() < 2) {
        return StationWords::tr("x %L1, y %L2")
            .arg(point.point.x(), 0, 'f', 2)
            .arg(point.point.y(), 0, 'f', 2);
    }
    const QString tapes = tapeWords(point.tapes[0], room) + " · " + tapeWords(point.tapes[1], room);
    return point.check ? StationWords::tr("%1 (check: %2)").arg(tapes, tapeWords(*point.check, room)) : tapes;
}

/// Of a photo by hand, or of one that came without a place.
QString unplannedWords(const QString& name) {
    static const QRegularExpression position(R"(^unplanned position \((-?[0-9.]+), (-?[0-9.]+)\)$)");
    if (const QRegularExpressionMatch found = position.match(name); found.hasMatch()) {
        return StationWords::tr("At x %L1, y %L2")
            .arg(found.captured(1).toDouble(), 0, 'f', 2)
            .arg(found.captured(2).toDouble(), 0, 'f', 2);
    }
    static const QRegularExpression unplanned("^(unknown place|unknown place of|place of) (\\S+)$");
    const QRegularExpressionMatch found = unplanned.match(name);
    const QString kind = found.captured(1);
    return kind == "unknown place"      ? StationWords::tr("Unknown place %1").arg(found.captured(2))
           : kind == "unknown place of" ? StationWords::tr("Unknown place of %1").arg(found.captured(2))
           : kind == "place of"         ? StationWords::tr("Place of %1").arg(found.captured(2))
                                        : name;
}

} // namespace

QString stationWords(const std::string& name) {
    static const QRegularExpression planned("^rail (\\d+), stop (\\d+)(?: at ([0-9.]+) m)?$");
    const QRegularExpressionMatch found = planned.match(QString::fromStdString(name));
    if (!found.hasMatch()) {
        return unplannedWords(QString::fromStdString(name));
    }
    const QString place = StationWords::tr("Rail %1, stop %2").arg(found.captured(1), found.captured(2));
    const double heightM = found.captured(3).toDouble();
    return found.hasCaptured(3) ? StationWords::tr("%1, at %L2 m").arg(place).arg(heightM, 0, 'f', 2) : place;
}

QString positionWords(const survey::Station& station) {
    const Eigen::Vector3d& p = station.positionM;
    return StationWords::tr("x %L1 m, y %L2 m, lens at %L3 m")
        .arg(p.x(), 0, 'f', 2)
        .arg(p.y(), 0, 'f', 2)
        .arg(p.z(), 0, 'f', 2);
}

QString railWords(const survey::RailMark& rail, const survey::Room& room) {
    return StationWords::tr("Lay the rail. First stop: %1. Last stop: %2.")
        .arg(tapeWords(rail.first, room), tapeWords(rail.last, room));
}

} // namespace spherewalk::ui
