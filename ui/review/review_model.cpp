// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/review_model.h"

#include "ui/look/icon.h"
#include "ui/map/station_words.h"
#include "ui/review/finding_words.h"
#include "ui/session/survey_session.h"

#include "spherewalk/jobs/judge_survey.h"

#include <QApplication>
#include <QCoreApplication>
#include <QListView>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <map>

namespace spherewalk::ui {

namespace {

void fill(ReviewRow& row, const store::PhotoRecord& photo, const std::filesystem::path& folder) {
    row.photo = photo.id;
    row.file = folder / photo.fileName;
    row.fileName = QString::fromStdString(photo.fileName);
    row.sha256 = QString::fromStdString(photo.fileSha256);
}

void addFlag(ReviewRow& row, const QString& sentence, const QString& reason) {
    row.flags << sentence;
    row.reasons << reason;
    if (const auto area = areaOf(sentence)) {
        row.areas.push_back(*area);
    }
}

void fill(ReviewRow& row, const store::PhotoVerdict& verdict) {
    for (const photo::Finding& finding : jobs::verdictOf(verdict).findings) {
        addFlag(row, QString::fromStdString(finding.sentence), shortText(finding));
    }
}

void fill(ReviewRow& row, const jobs::PhotoFinding& finding) {
    row.roomFromPhoto = finding.roomFromPhoto;
    row.sigmaYaw = finding.sigmaYaw;
    row.residual = finding.residual;
    for (const std::string& flag : finding.flags) {
        const QString sentence = QString::fromStdString(flag);
        addFlag(row, sentence, shortText(sentence));
    }
}

bool isSame(const ReviewRow& a, const ReviewRow& b) {
    return a.station == b.station && a.photo == b.photo && a.sha256 == b.sha256 && a.standing == b.standing &&
           a.note == b.note && a.flags == b.flags && a.regions == b.regions && a.isChecked == b.isChecked &&
           a.errorPx == b.errorPx;
}

QString errorText(const ReviewRow& row) {
    if (!row.errorPx) {
        return {};
    }
    return std::isfinite(*row.errorPx) ? ReviewModel::tr("%L1 px").arg(*row.errorPx, 0, 'f', 1)
                                       : ReviewModel::tr("not found");
}

QString regionsText(const ReviewRow& row) {
    return ReviewModel::tr("%n private region(s), which exports show blurred", nullptr,
                           static_cast<int>(row.regions.size()));
}

QString toolTip(const ReviewRow& row) {
    QStringList lines{row.fileName, row.note};
    if (row.errorPx && std::isinf(*row.errorPx)) {
        lines << ReviewModel::tr("More than 5 of 100 places were not found in views in its place.");
    } else if (row.errorPx) {
        lines << ReviewModel::tr("95 of 100 places of views in its place are displaced by %1 or less.")
                     .arg(errorText(row));
    }
    if (!row.regions.empty()) {
        lines << regionsText(row);
    }
    lines << row.flags;
    lines.removeAll(QString());
    return lines.join('\n');
}

constexpr int kThumbnailWidth = 112;
constexpr int kThumbnailHeight = kThumbnailWidth / 2;
constexpr int kGap = 6;

/// Returns the thumbnail or a placeholder.
void paintThumbnail(QPainter& painter, const QRect& box, const QModelIndex& index, const QPalette& palette) {
    const auto picture = index.data(Qt::DecorationRole).value<QImage>();
    if (!picture.isNull()) {
        painter.drawImage(box, picture);
        return;
    }
    painter.fillRect(box, palette.color(QPalette::AlternateBase));
    painter.setPen(palette.color(QPalette::Mid));
    painter.drawRect(box.adjusted(0, 0, -1, -1));
    const auto standing = static_cast<Standing>(index.data(ReviewModel::StandingRole).toInt());
    const QString words = standing == Standing::Missing ? ReviewDelegate::tr("no photo")
                          : index.data(ReviewModel::UnreadableRole).toBool()
                              ? ReviewDelegate::tr("unreadable")
                              : QString();
    painter.setPen(palette.color(QPalette::PlaceholderText));
    painter.drawText(box, Qt::AlignCenter, words);
}

/// Puts the number of private regions into the corner of the thumbnail.
void paintRegions(QPainter& painter, const QRect& box, int regions) {
    if (regions == 0) {
        return;
    }
    constexpr int kIconPx = 14;
    const QString count = QString::number(regions);
    const int width = kIconPx + painter.fontMetrics().horizontalAdvance(count) + 9;
    const QRect plate(box.left() + 2, box.center().y() + kThumbnailHeight / 2 - kIconPx - 6, width,
                      kIconPx + 4);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 190));
    painter.drawRoundedRect(plate, 3, 3);
    painter.drawPixmap(plate.left() + 3, plate.top() + 2, colouredIcon("hide", Qt::white, kIconPx));
    painter.setPen(Qt::white);
    painter.drawText(plate.adjusted(kIconPx + 5, 0, 0, 0), Qt::AlignVCenter, count);
}

} // namespace

ShownPhoto ReviewRow::shown() const {
    std::vector<ShownRegion> shownRegions;
    for (const store::RegionRecord& region : regions) {
        shownRegions.push_back({region.id, region.region, region.origin == store::RegionOrigin::Found});
    }
    return {file,
            QObject::tr("%1 (%2)").arg(stationName, fileName),
            roomFromPhoto.value_or(Rigid3{Eigen::Quaterniond::Identity(), positionM}),
            roomFromPhoto.has_value(),
            areas,
            shownRegions};
}

std::optional<double> apartM(const ReviewRow& a, const ReviewRow& b) {
    return a.isPlaced && b.isPlaced ? std::optional((a.positionM - b.positionM).norm()) : std::nullopt;
}

std::vector<ReviewRow> reviewRows(const store::SurveyStore& store,
                                  const std::optional<jobs::SolutionFindings>& findings) {
    std::map<std::int64_t, store::PhotoRecord> photos; // by station
    for (store::PhotoRecord& photo : store.chosenPhotos()) {
        const std::int64_t station = photo.station;
        photos.emplace(station, std::move(photo));
    }
    std::map<std::int64_t, store::Review> reviews; // by photo
    for (store::Review& review : store.reviews()) {
        const std::int64_t photo = review.photo;
        reviews.emplace(photo, std::move(review));
    }
    std::map<std::int64_t, store::PhotoVerdict> verdicts; // by photo
    for (store::PhotoVerdict& verdict : store.verdicts()) {
        const std::int64_t photo = verdict.photo;
        verdicts.emplace(photo, std::move(verdict));
    }
    std::map<std::int64_t, std::vector<store::RegionRecord>> regions; // by photo
    for (const store::RegionRecord& region : store.regions()) {
        if (region.origin != store::RegionOrigin::Rejected) {
            regions[region.photo].push_back(region);
        }
    }
    std::map<std::int64_t, const jobs::PhotoFinding*> found; // by photo
    if (findings) {
        for (const jobs::PhotoFinding& finding : findings->photos) {
            found.emplace(finding.photo, &finding);
        }
    }
    const std::map<std::int64_t, Standing> standing = standings(store, findings);
    std::vector<ReviewRow> rows;
    for (const store::StationRecord& station : store.stations()) {
        ReviewRow row;
        row.station = station.id;
        row.standing = standing.at(station.id);
        row.stationName = stationWords(station.name);
        row.positionM = station.station.positionM;
        row.isPlaced = station.isPlaceKnown;
        if (const auto photo = photos.find(station.id); photo != photos.end()) {
            fill(row, photo->second, store.photoFolder());
            if (const auto review = reviews.find(*row.photo); review != reviews.end()) {
                row.decision = review->second.decision;
                row.note = QString::fromStdString(review->second.note);
            }
            row.regions = regions[*row.photo];
            const auto verdict = verdicts.find(*row.photo);
            if (verdict != verdicts.end()) {
                fill(row, verdict->second);
            }
            const auto finding = found.find(*row.photo);
            if (finding != found.end()) {
                fill(row, *finding->second);
            }
            row.isChecked =
                verdict != verdicts.end() ||
                (finding != found.end() && finding->second->quality && !finding->second->isImported);
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

void fillErrors(std::vector<ReviewRow>& rows, const jobs::MeasuredPhotos& measured) {
    std::map<std::filesystem::path, std::optional<double>> errorsPx; // by the file's name without its ending
    for (const jobs::MeasuredPhoto& photo : measured.photos) {
        errorsPx.emplace(std::filesystem::path(photo.file).stem(), photo.p95Px);
    }
    for (ReviewRow& row : rows) {
        const auto found = errorsPx.find(row.file.stem());
        if (row.photo && found != errorsPx.end()) {
            row.errorPx = found->second;
        }
    }
}

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
        return QStringLiteral("%1, %2").arg(row.stationName, standingText(row.standing)) +
               (row.regions.empty() ? QString() : QStringLiteral(", ") + regionsText(row));
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
        return row.reasons.join(QStringLiteral(", "));
    case ErrorRole:
        return errorText(row);
    case RegionsRole:
        return static_cast<int>(row.regions.size());
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
    case ReviewFilter::WithRegions:
        return QCoreApplication::translate("ReviewFilter", "With private regions");
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
    case ReviewFilter::WithRegions:
        return !row.regions.empty();
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

QSize ReviewDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& /*index*/) const {
    constexpr int kFewWordsPx = 60; // else a narrow list scrolls sideways, and a wide one gives more anyway
    constexpr int kWordsPx = 150;
    const auto* list = qobject_cast<const QListView*>(option.widget);
    const bool isSheet = list != nullptr && list->isWrapping();
    return {kThumbnailWidth + (isSheet ? kWordsPx : kFewWordsPx),
            std::max(kThumbnailHeight, 3 * option.fontMetrics.height()) + 2 * kGap};
}

void ReviewDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) const {
    QStyleOptionViewItem row = option;
    row.text.clear();
    row.icon = {};
    const QStyle* style = option.widget != nullptr ? option.widget->style() : QApplication::style();
    style->drawPrimitive(QStyle::PE_PanelItemViewItem, &row, painter, option.widget);
    painter->save();
    const QRect box = option.rect.adjusted(kGap, kGap, -kGap, -kGap);
    paintThumbnail(*painter,
                   {box.left(), box.center().y() - kThumbnailHeight / 2, kThumbnailWidth, kThumbnailHeight},
                   index, option.palette);
    paintRegions(*painter, box, index.data(ReviewModel::RegionsRole).toInt());
    const bool isSelected = option.state.testFlag(QStyle::State_Selected);
    const QColor ink = option.palette.color(isSelected ? QPalette::HighlightedText : QPalette::Text);
    const QRect words = box.adjusted(kThumbnailWidth + 2 * kGap, 0, 0, 0);
    const int line = option.fontMetrics.height();
    const auto put = [&](int at, const QString& text, Qt::TextElideMode elide = Qt::ElideRight) {
        painter->drawText(QRect(words.left(), words.top() + at * line, words.width(), line), Qt::AlignVCenter,
                          painter->fontMetrics().elidedText(text, elide, words.width()));
    };
    painter->setPen(ink);
    QFont bold = option.font;
    bold.setBold(true);
    painter->setFont(bold);
    put(0, index.data(Qt::DisplayRole).toString(), Qt::ElideMiddle); // Names differ at their ends.
    painter->setFont(option.font);
    const auto standing = static_cast<Standing>(index.data(ReviewModel::StandingRole).toInt());
    const QString error = index.data(ReviewModel::ErrorRole).toString();
    put(1, standingSign(standing) + QLatin1Char(' ') + standingText(standing) +
               (error.isEmpty() ? error : QStringLiteral(" · ") + error));
    const QString note = index.data(ReviewModel::NoteRole).toString();
    painter->setOpacity(0.75);
    put(2, note.isEmpty() ? index.data(ReviewModel::ReasonRole).toString() : note);
    painter->restore();
}

} // namespace spherewalk::ui
