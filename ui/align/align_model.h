// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/jobs/solution_findings.h"

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>

namespace spherewalk::ui {

/// The findings of the active solution as a table, with one row for each photo.
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
        PhotoRole = Qt::UserRole, ///< Id of the photo.
        StationRole,              ///< Id of the station.
        SortRole,                 ///< A number or a text to sort by.
        FlaggedRole,              ///< Whether a person must look at the photo or act.
    };

    using QAbstractTableModel::QAbstractTableModel;

    void setPhotos(std::vector<jobs::PhotoFinding> photos);

    const std::vector<jobs::PhotoFinding>& photos() const { return m_photos; }

    /// Returns the finding of a photo; null without one.
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

/// The rows sorted by a column: all rows, or only those of FlaggedRole.
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

/// Returns the words of a proposal for a button or a cell; empty if nothing is proposed.
QString cureText(jobs::Cure cure);

} // namespace spherewalk::ui
