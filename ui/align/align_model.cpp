// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/align/align_model.h"

#include "ui/look/core_words.h"
#include "ui/look/words.h"
#include "ui/map/station_words.h"

#include "spherewalk/geometry/rotation.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <limits>

namespace spherewalk::ui {

namespace {

constexpr double kUnknown =
    std::numeric_limits<double>::infinity(); ///< Unknown numbers sort behind known ones.

std::optional<double> yawDeg(const jobs::PhotoFinding& photo) {
    return photo.roomFromPhoto
               ? std::optional(Degrees(yawPitchRoll(photo.roomFromPhoto->rotation).yaw).value())
               : std::nullopt;
}

std::optional<double> degreesOf(const std::optional<Radians>& angle) {
    return angle ? std::optional(Degrees(*angle).value()) : std::nullopt;
}

std::optional<double> number(const jobs::PhotoFinding& photo, int column) {
    switch (column) {
    case AlignModel::Yaw:
        return yawDeg(photo);
    case AlignModel::SigmaYaw:
        return degreesOf(photo.sigmaYaw);
    case AlignModel::SigmaTilt:
        return degreesOf(photo.sigmaTilt);
    case AlignModel::Residual:
        return degreesOf(photo.residual);
    default:
        return std::nullopt;
    }
}

bool isNumber(int column) {
    return column >= AlignModel::Yaw && column <= AlignModel::Residual;
}

/// Returns the state as the plan shows it.
Standing standingOf(std::optional<survey::Quality> quality) {
    return !quality                                ? Standing::Missing
           : *quality == survey::Quality::Good     ? Standing::Taken
           : *quality == survey::Quality::Doubtful ? Standing::Doubtful
                                                   : Standing::Failed;
}

QString verdictText(Standing standing) {
    const QString word = standing == Standing::Taken     ? AlignModel::tr("good")
                         : standing == Standing::Missing ? AlignModel::tr("not aligned")
                                                         : standingText(standing);
    return standingSign(standing) + QLatin1Char(' ') + word;
}

QString joined(const std::vector<std::string>& sentences) {
    QStringList list;
    for (const std::string& sentence : sentences) {
        list << coreWords(sentence);
    }
    return list.join(QLatin1Char(' '));
}

} // namespace

void AlignModel::setPhotos(std::vector<jobs::PhotoFinding> photos) {
    beginResetModel();
    m_photos = std::move(photos);
    endResetModel();
}

const jobs::PhotoFinding* AlignModel::photo(std::int64_t id) const {
    const auto found = std::find_if(m_photos.begin(), m_photos.end(),
                                    [&](const jobs::PhotoFinding& photo) { return photo.photo == id; });
    return found != m_photos.end() ? &*found : nullptr;
}

int AlignModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_photos.size());
}

int AlignModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : Columns;
}

QVariant AlignModel::data(const QModelIndex& index, int role) const {
    const jobs::PhotoFinding& photo = m_photos.at(static_cast<std::size_t>(index.row()));
    switch (role) {
    case Qt::DisplayRole:
        return text(photo, index.column());
    case Qt::ToolTipRole:
        return index.column() == Reason ? joined(photo.flags) : QString();
    case Qt::TextAlignmentRole:
        return QVariant::fromValue<int>(isNumber(index.column()) || index.column() == Neighbours
                                            ? Qt::AlignRight | Qt::AlignVCenter
                                            : Qt::AlignLeft | Qt::AlignVCenter);
    case PhotoRole:
        return QVariant::fromValue<qlonglong>(photo.photo);
    case StationRole:
        return QVariant::fromValue<qlonglong>(photo.station);
    case SortRole:
        return sortKey(photo, index.row(), index.column());
    case FlaggedRole:
        return !photo.flags.empty() || photo.cure != jobs::Cure::None ||
               photo.quality != survey::Quality::Good;
    default:
        return {};
    }
}

QVariant AlignModel::text(const jobs::PhotoFinding& photo, int column) const {
    if (isNumber(column)) {
        const auto value = number(photo, column);
        return value ? QLocale().toString(*value, 'f', column == Yaw ? 2 : 3) : QStringLiteral("-");
    }
    switch (column) {
    case Station:
        return stationWords(photo.stationName);
    case Verdict:
        return verdictText(standingOf(photo.quality));
    case Neighbours:
        return photo.neighbours > 0 ? QString::number(photo.neighbours) : QStringLiteral("-");
    case Proposal:
        return cureText(photo.cure);
    case Reason:
        return joined(photo.flags);
    default:
        return {};
    }
}

QVariant AlignModel::sortKey(const jobs::PhotoFinding& photo, int row, int column) const {
    if (isNumber(column)) {
        return number(photo, column).value_or(kUnknown);
    }
    switch (column) {
    case Station:
        return row; // rows are in walking order
    case Verdict:
        return -static_cast<int>(standingOf(photo.quality)); // the worst first
    case Neighbours:
        return photo.neighbours;
    default:
        return text(photo, column);
    }
}

QVariant AlignModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) {
        return {};
    }

    struct Header {
        QString title;
        QString toolTip;
    };

    const auto header = [&]() -> Header {
        switch (section) {
        case Station:
            return {tr("Station"), tr("Where the photo was taken, in walking order")};
        case Verdict:
            return {tr("Verdict"), tr("What the alignment says of the photo")};
        case Yaw:
            return {tr("Yaw °"), tr("How the photo is turned, counter-clockwise from the room's x axis")};
        case SigmaYaw:
            return {tr("σ yaw °"), tr("Standard deviation of the yaw")};
        case SigmaTilt:
            return {tr("σ tilt °"), tr("Standard deviation of pitch or roll, the larger of them")};
        case Residual:
            return {tr("Residual °"), tr("How far the photo's matches miss, root mean square")};
        case Neighbours:
            return {tr("Pairs"), tr("Neighbours that hold the photo")};
        case Proposal:
            return {tr("Proposal"), tr("What would help")};
        case Reason:
            return {tr("Why"), tr("What speaks against the photo")};
        default:
            return {};
        }
    }();
    return role == Qt::DisplayRole   ? QVariant(header.title)
           : role == Qt::ToolTipRole ? QVariant(header.toolTip)
                                     : QVariant();
}

AlignProxy::AlignProxy(AlignModel& model, QObject* parent) : QSortFilterProxyModel(parent) {
    setSourceModel(&model);
    setSortRole(AlignModel::SortRole);
    setDynamicSortFilter(true);
}

void AlignProxy::setOnlyFlagged(bool isOnlyFlagged) {
    m_isOnlyFlagged = isOnlyFlagged;
    invalidateFilter();
}

bool AlignProxy::filterAcceptsRow(int row, const QModelIndex& parent) const {
    return !m_isOnlyFlagged || sourceModel()->index(row, 0, parent).data(AlignModel::FlaggedRole).toBool();
}

QString cureText(jobs::Cure cure) {
    switch (cure) {
    case jobs::Cure::None:
        return {};
    case jobs::Cure::Retag:
        return QCoreApplication::translate("Cure", "Retag");
    case jobs::Cure::Retake:
        return QCoreApplication::translate("Cure", "Retake");
    case jobs::Cure::Mask:
        return QCoreApplication::translate("Cure", "Mask");
    }
    return {};
}

} // namespace spherewalk::ui
