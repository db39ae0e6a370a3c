// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/jobs/solution_findings.h"

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>

namespace spherewalk::ui {

/// What the active solution says of each photo, a row a photo.
class AlignModel : public QAbstractTableModel {
    Q_OBJECT

  public:
    enum Column {
        Station,
        Verdict,
        Yaw,
        SigmaYaw,
        SigmaTilt,
        Residual,
        Neighbours,
        Proposal,
        Reason,
        Columns
    };

    enum Role {
        PhotoRole = Qt::UserRole, ///< its id
        StationRole,              ///< its id
        SortRole,                 ///< a number or a text, for sorting
        FlaggedRole,              ///< whether there is something to do or to look at
    };

    using QAbstractTableModel::QAbstractTableModel;

    void setPhotos(std::vector<jobs::PhotoFinding> photos);

    const std::vector<jobs::PhotoFinding>& photos() const { return m_photos; }

    /// Null if there is none.
    const jobs::PhotoFinding* photo(std::int64_t id) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  private:
    QVariant text(const jobs::PhotoFinding& photo, int column) const;
    QVariant sortKey(const jobs::PhotoFinding& photo, int row, int column) const;

    std::vector<jobs::PhotoFinding> m_photos;
};

/// The rows sorted by any column, all or only those with a flag.
class AlignProxy : public QSortFilterProxyModel {
    Q_OBJECT

  public:
    explicit AlignProxy(AlignModel& model, QObject* parent = nullptr);

    void setOnlyFlagged(bool isOnlyFlagged);

  protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

  private:
    bool m_isOnlyFlagged = false;
};

/// What is proposed for a photo, as words for a button or a cell; empty for nothing.
QString cureText(jobs::Cure cure);

} // namespace spherewalk::ui
