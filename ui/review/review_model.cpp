// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/review_model.h"

#include <QCoreApplication>

#include <algorithm>

namespace spherewalk::ui {

namespace {

bool isSame(const ReviewRow& a, const ReviewRow& b) {
    return a.station == b.station && a.photo == b.photo && a.sha256 == b.sha256 && a.standing == b.standing &&
           a.note == b.note && a.flags == b.flags && a.errorPx == b.errorPx;
}

QString errorText(const ReviewRow& row) {
    return row.errorPx ? ReviewModel::tr("%L1 px").arg(*row.errorPx, 0, 'f', 1) : QString();
}

QString toolTip(const ReviewRow& row) {
    QStringList lines{row.fileName, row.note};
    if (row.errorPx) {
        lines << ReviewModel::tr("95 of 100 places of views in its place are displaced by %1 or less.")
                     .arg(errorText(row));
    }
    lines << row.flags;
    lines.removeAll(QString());
    return lines.join('\n');
}

} // namespace

ReviewModel::ReviewModel(ThumbnailCache& thumbnails, QObject* parent)
    : QAbstractListModel(parent), m_thumbnails(thumbnails) {
    connect(&thumbnails, &ThumbnailCache::ready, this, &ReviewModel::showThumbnail);
}

void ReviewModel::setRows(std::vector<ReviewRow> rows) {
    const bool isSameList =
        rows.size() == m_rows.size() &&
        std::equal(rows.begin(), rows.end(), m_rows.begin(),
                   [](const ReviewRow& a, const ReviewRow& b) { return a.station == b.station; });
    if (!isSameList) {
        beginResetModel();
        m_rows = std::move(rows);
        endResetModel();
        return;
    }
    m_rows.swap(rows);
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (!isSame(m_rows[i], rows[i])) {
            const QModelIndex changed = index(static_cast<int>(i));
            emit dataChanged(changed, changed);
        }
    }
}

const ReviewRow* ReviewModel::rowOf(std::int64_t station) const {
    const auto found = std::find_if(m_rows.begin(), m_rows.end(),
                                    [&](const ReviewRow& row) { return row.station == station; });
    return found != m_rows.end() ? &*found : nullptr;
}

int ReviewModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

QVariant ReviewModel::data(const QModelIndex& index, int role) const {
    const ReviewRow& row = m_rows.at(static_cast<std::size_t>(index.row()));
    switch (role) {
    case Qt::DisplayRole:
        return row.stationName;
    case Qt::AccessibleTextRole:
        return QStringLiteral("%1, %2").arg(row.stationName, standingText(row.standing));
    case Qt::ToolTipRole:
        return toolTip(row);
    case Qt::DecorationRole:
        return row.photo ? m_thumbnails.find(row.file, row.sha256) : QImage();
    case StationRole:
        return QVariant::fromValue<qlonglong>(row.station);
    case StandingRole:
        return static_cast<int>(row.standing);
    case NoteRole:
        return row.note;
    case ReasonRole:
        return row.flags.join(' ');
    case ErrorRole:
        return errorText(row);
    case UnreadableRole:
        return m_thumbnails.isUnreadable(row.sha256);
    default:
        return {};
    }
}

void ReviewModel::showThumbnail(const QString& sha256) {
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (m_rows[i].sha256 == sha256) {
            const QModelIndex changed = index(static_cast<int>(i));
            emit dataChanged(changed, changed, {Qt::DecorationRole});
        }
    }
}

QString filterText(ReviewFilter filter) {
    switch (filter) {
    case ReviewFilter::All:
        return QCoreApplication::translate("ReviewFilter", "All stations");
    case ReviewFilter::ToReview:
        return QCoreApplication::translate("ReviewFilter", "To be reviewed");
    case ReviewFilter::Doubtful:
        return QCoreApplication::translate("ReviewFilter", "Doubtful");
    case ReviewFilter::Failed:
        return QCoreApplication::translate("ReviewFilter", "Failed");
    case ReviewFilter::Missing:
        return QCoreApplication::translate("ReviewFilter", "Missing");
    case ReviewFilter::Rejected:
        return QCoreApplication::translate("ReviewFilter", "Rejected");
    case ReviewFilter::WithNote:
        return QCoreApplication::translate("ReviewFilter", "With a note");
    }
    return {};
}

bool passes(ReviewFilter filter, const ReviewRow& row) {
    switch (filter) {
    case ReviewFilter::All:
        return true;
    case ReviewFilter::ToReview:
        return row.photo && row.decision == store::Decision::Open;
    case ReviewFilter::Doubtful:
        return row.standing == Standing::Doubtful;
    case ReviewFilter::Failed:
        return row.standing == Standing::Failed;
    case ReviewFilter::Missing:
        return row.standing == Standing::Missing;
    case ReviewFilter::Rejected:
        return row.standing == Standing::Rejected;
    case ReviewFilter::WithNote:
        return !row.note.isEmpty();
    }
    return true;
}

ReviewProxy::ReviewProxy(ReviewModel& model, QObject* parent)
    : QSortFilterProxyModel(parent), m_model(model) {
    setSourceModel(&model);
}

void ReviewProxy::setFilter(ReviewFilter filter) {
    m_filter = filter;
    invalidateFilter();
}

void ReviewProxy::setText(const QString& text) {
    m_text = text.trimmed();
    invalidateFilter();
}

QModelIndex ReviewProxy::indexOf(std::int64_t station) const {
    const ReviewRow* row = m_model.rowOf(station);
    return row == nullptr ? QModelIndex()
                          : mapFromSource(m_model.index(static_cast<int>(row - m_model.rows().data())));
}

bool ReviewProxy::filterAcceptsRow(int row, const QModelIndex& /*parent*/) const {
    const ReviewRow& candidate = m_model.rows().at(static_cast<std::size_t>(row));
    const auto has = [&](const QString& where) { return where.contains(m_text, Qt::CaseInsensitive); };
    return passes(m_filter, candidate) &&
           (m_text.isEmpty() || has(candidate.stationName) || has(candidate.fileName) || has(candidate.note));
}

} // namespace spherewalk::ui
