// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/panorama/thumbnail_cache.h"
#include "ui/review/review_rows.h"

#include <QAbstractListModel>
#include <QSortFilterProxyModel>

namespace spherewalk::ui {

/// The stations of a survey as a list. Thumbnails are asked for when a view shows their row.
class ReviewModel : public QAbstractListModel {
    Q_OBJECT

  public:
    enum Role {
        StationRole = Qt::UserRole, ///< its id
        StandingRole,
        NoteRole,
        ReasonRole, ///< the flags, joined
        UnreadableRole,
        ErrorRole, ///< "3.4 px"; empty if it was not measured
    };

    explicit ReviewModel(ThumbnailCache& thumbnails, QObject* parent = nullptr);

    const std::vector<ReviewRow>& rows() const { return m_rows; }

    /// Rows that are as before are left alone, so that the view keeps its place.
    void setRows(std::vector<ReviewRow> rows);
    /// Nothing if there is none.
    const ReviewRow* rowOf(std::int64_t station) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;

  private:
    void showThumbnail(const QString& sha256);

    ThumbnailCache& m_thumbnails;
    std::vector<ReviewRow> m_rows;
};

/// Which stations a reviewer wants to see.
enum class ReviewFilter { All, ToReview, Doubtful, Failed, Missing, Rejected, WithNote };

/// In a few words, translated.
QString filterText(ReviewFilter filter);

/// Whether the row is one of those; of ToReview: photos on which nobody has decided.
bool passes(ReviewFilter filter, const ReviewRow& row);

/// The stations that pass a filter and whose name, file or note contains a text.
class ReviewProxy : public QSortFilterProxyModel {
    Q_OBJECT

  public:
    explicit ReviewProxy(ReviewModel& model, QObject* parent = nullptr);

    ReviewFilter filter() const { return m_filter; }

    void setFilter(ReviewFilter filter);
    void setText(const QString& text);

    QModelIndex indexOf(std::int64_t station) const;

  protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

  private:
    ReviewModel& m_model;
    ReviewFilter m_filter = ReviewFilter::All;
    QString m_text;
};

} // namespace spherewalk::ui
