// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/words.h"
#include "ui/panorama/panorama_presenter.h"
#include "ui/panorama/photo_pictures.h"

#include "spherewalk/jobs/measure_page.h"
#include "spherewalk/jobs/solution_findings.h"
#include "spherewalk/store/survey_store.h"

#include <QAbstractListModel>
#include <QSortFilterProxyModel>
#include <QString>
#include <QStringList>
#include <QStyledItemDelegate>

#include <cstdint>
#include <optional>
#include <vector>

namespace spherewalk::ui {

/// A station with its chosen photo, for the reviewer.
struct ReviewRow {
    std::int64_t station = 0;
    QString stationName;                                 ///< In the user's language.
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero(); ///< Place of the station in the room.
    bool isPlaced = true;                                ///< Whether that is known.
    Standing standing = Standing::Missing;

    // The following members describe the chosen photo, if there is one.
    std::optional<std::int64_t> photo;
    std::filesystem::path file;
    QString fileName;
    QString sha256;
    store::Decision decision = store::Decision::Open;
    QString note;
    QStringList flags;                        ///< Sentences of the checks and of the alignment.
    QStringList reasons;                      ///< The same in short.
    std::vector<PhotoArea> areas;             ///< Areas of the photo that the flags tell of.
    std::vector<store::RegionRecord> regions; ///< Private ones, which exports blur.
    bool isChecked = false;                   ///< The checks or the alignment have graded the photo.
    std::optional<Rigid3> roomFromPhoto;
    std::optional<Radians> sigmaYaw;
    std::optional<Radians> residual;
    std::optional<double> errorPx; ///< Measured error of views at the place of the photo.

    /// Returns the photo for the viewer, with the areas of its flags. Range: a row with a
    /// photo.
    ShownPhoto shown() const;
};

/// Returns how far apart two stations are, metres; nothing where nobody knows that.
std::optional<double> apartM(const ReviewRow& a, const ReviewRow& b);

/// Returns one row for each station, in walking order. findings: those of the active solution. Errors: those
/// of the store.
std::vector<ReviewRow> reviewRows(const store::SurveyStore& store,
                                  const std::optional<jobs::SolutionFindings>& findings);

/// Fills in the measured errors of photos. Photos that were taken or moved after the measurement get none.
void fillErrors(std::vector<ReviewRow>& rows, const jobs::MeasuredPhotos& measured);

/// The stations of a survey as a list. It asks for a thumbnail when a view shows the row.
class ReviewModel : public QAbstractListModel {
    Q_OBJECT

  public:
    enum Role {
        StationRole = Qt::UserRole, ///< Id of the station.
        StandingRole,
        NoteRole,
        ReasonRole, ///< All reasons in one short text.
        UnreadableRole,
        ErrorRole,   ///< "3.4 px"; empty without a measurement.
        RegionsRole, ///< Number of the photo's private regions.
    };

    explicit ReviewModel(ThumbnailCache& thumbnails, QObject* parent = nullptr);

    const std::vector<ReviewRow>& rows() const { return m_rows; }

    /// Takes these rows and signals only the changed ones, so that a view keeps its position.
    void setRows(std::vector<ReviewRow> rows);
    /// Returns the row of a station; null without one.
    const ReviewRow* rowOf(std::int64_t station) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;

  private:
    void showThumbnail(const QString& sha256);

    ThumbnailCache& m_thumbnails;
    std::vector<ReviewRow> m_rows;
};

/// The stations that a reviewer wants to see.
enum class ReviewFilter { All, ToReview, Doubtful, Failed, Missing, Rejected, WithNote, WithRegions };

/// Returns the name of a filter, translated.
QString filterText(ReviewFilter filter);

/// Whether a row passes the filter. ToReview passes photos without a decision.
bool passes(ReviewFilter filter, const ReviewRow& row);

/// The stations that pass a filter and have a text in their name, file or note.
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

/// Draws a row of the reviewer's list: thumbnail, name, standing as a sign and a word, and the note or the
/// reason for doubt.
class ReviewDelegate : public QStyledItemDelegate {
    Q_OBJECT

  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
};

} // namespace spherewalk::ui
