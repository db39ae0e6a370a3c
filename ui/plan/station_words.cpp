// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/station_words.h"

#include <QCoreApplication>

namespace spherewalk::ui {

namespace {

/// The words of this file, for translators.
struct StationWords {
    Q_DECLARE_TR_FUNCTIONS(spherewalk::ui::StationWords)
};

QString tapeWords(const survey::MarkedPoint& point) {
    if (point.tapes.size() < 2) {
        return StationWords::tr("x %L1, y %L2")
            .arg(point.point.x(), 0, 'f', 2)
            .arg(point.point.y(), 0, 'f', 2);
    }
    QStringList tapes;
    for (const survey::TapeDistance& tape : point.tapes) {
        tapes << StationWords::tr("%1 %L2 m")
                     .arg(QString::fromStdString(survey::cornerName(tape.corner)))
                     .arg(tape.metres, 0, 'f', 3);
    }
    return tapes.join(" · ");
}

} // namespace

QString stationWords(const store::StationRecord& station, const survey::PlanOptions& options) {
    if (station.station.placement < 0) {
        return QString::fromStdString(station.name);
    }
    const QString place =
        StationWords::tr("Rail %1, stop %2").arg(station.station.placement + 1).arg(station.station.stop + 1);
    return options.heightsM.size() > 1
               ? StationWords::tr("%1, at %L2 m").arg(place).arg(station.station.positionM.z(), 0, 'f', 2)
               : place;
}

QString positionWords(const survey::Station& station) {
    const Eigen::Vector3d& p = station.positionM;
    return StationWords::tr("x %L1 m, y %L2 m, lens at %L3 m")
        .arg(p.x(), 0, 'f', 2)
        .arg(p.y(), 0, 'f', 2)
        .arg(p.z(), 0, 'f', 2);
}

QString railWords(const survey::RailMark& rail) {
    return StationWords::tr("Lay the rail. First stop: %1. Last stop: %2.")
        .arg(tapeWords(rail.first), tapeWords(rail.last));
}

} // namespace spherewalk::ui
