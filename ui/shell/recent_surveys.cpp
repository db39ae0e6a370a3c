// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/recent_surveys.h"

#include "ui/look/icon.h"
#include "ui/look/theme.h"

#include "spherewalk/base/error.h"
#include "spherewalk/store/survey_store.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <set>

namespace spherewalk::ui {

namespace {

constexpr int kPicturePx = 56;

/// Draws the plan of a survey as small as a thumbnail.
QImage pictureOf(const store::SurveyStore& store, const std::set<std::int64_t>& missing) {
    constexpr double kMarginPx = 4;
    constexpr double kLeastM = 1;
    const survey::Room room = store.knownRoom();
    std::vector<store::StationRecord> stations = store.stations();
    std::erase_if(stations, [](const store::StationRecord& station) { return !station.isPlaceKnown; });
    Polygon shown = room.outline;
    for (const store::StationRecord& station : stations) {
        shown.emplace_back(station.station.positionM.head<2>());
    }
    if (shown.empty()) {
        shown.emplace_back(0, 0);
    }
    const Bounds2 extent = bounds(shown);
    const Eigen::Vector2d size = extent.greatest - extent.least;
    const double scale = (kPicturePx - 2 * kMarginPx) / std::max(size.maxCoeff(), kLeastM);
    const auto at = [&](const Eigen::Vector2d& pInRoom) {
        const Eigen::Vector2d from = pInRoom - 0.5 * (extent.least + extent.greatest);
        return QPointF(0.5 * kPicturePx + scale * from.x(), 0.5 * kPicturePx - scale * from.y());
    };
    QImage picture(kPicturePx, kPicturePx, QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    QPolygonF walls;
    for (const Eigen::Vector2d& corner : room.outline) {
        walls << at(corner);
    }
    painter.setPen(QPen(Qt::gray, 1.5));
    painter.drawPolygon(walls);
    painter.setPen(QPen(goodColour(), 1));
    for (const store::StationRecord& station : stations) {
        painter.setBrush(missing.contains(station.id) ? QBrush(Qt::NoBrush) : QBrush(goodColour()));
        painter.drawEllipse(at(station.station.positionM.head<2>()), 1.5, 1.5);
    }
    return picture;
}

} // namespace

SurveySummary summaryOf(const QString& folder) {
    const auto store = store::SurveyStore::open(folder.toStdString(), store::Access::Read);
    std::set<std::int64_t> missing;
    for (const store::StationRecord& station : store.stationsWithoutPhoto()) {
        missing.insert(station.id);
    }
    const store::Counts counts = store.counts();
    return {counts.stationsWithPhoto, counts.stations, pictureOf(store, missing)};
}

RecentSurveys::RecentSurveys(QWidget* parent) : QListWidget(parent) {
    setIconSize({kPicturePx, kPicturePx});
    setAlternatingRowColors(true);
    setTextElideMode(Qt::ElideMiddle);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

void RecentSurveys::list(const QStringList& folders) {
    m_worker.dropWaiting();
    clear();
    for (const QString& folder : folders) {
        const QDateTime used = QFileInfo(folder + "/survey.sqlite").lastModified();
        auto* item = new QListWidgetItem(ui::icon("plan"), QString(), this);
        item->setData(Qt::UserRole, folder);
        item->setData(Qt::UserRole + 1, QLocale().toString(used, QLocale::ShortFormat));
        item->setToolTip(QDir::toNativeSeparators(folder));
        fill(folder, {});
        m_worker.post(folder, [this, folder]() -> BackgroundWorker::Deliver {
            try {
                return [this, folder, summary = summaryOf(folder)] { fill(folder, summary); };
            } catch (const Error&) { // opening the survey says what is wrong with it
                return [] {};
            }
        });
    }
}

void RecentSurveys::fill(const QString& folder, const SurveySummary& summary) {
    for (int row = 0; row < count(); ++row) {
        QListWidgetItem* shown = item(row);
        if (shown->data(Qt::UserRole).toString() != folder) {
            continue;
        }
        const QFileInfo file(folder);
        const QString place = QDir::toNativeSeparators(file.path());
        const QString used = shown->data(Qt::UserRole + 1).toString();
        const QString progress =
            summary.stations > 0
                ? tr("%1 of %2 photos, %3").arg(summary.photos).arg(summary.stations).arg(used)
                : used;
        shown->setText(file.completeBaseName() + "\n" + progress + "\n" + place);
        if (!summary.picture.isNull()) {
            shown->setIcon(QPixmap::fromImage(summary.picture));
        }
    }
}

} // namespace spherewalk::ui
