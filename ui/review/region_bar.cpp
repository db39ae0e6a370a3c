// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/region_bar.h"

#include "ui/look/core_words.h"
#include "ui/look/icon.h"
#include "ui/map/station_words.h"
#include "ui/panorama/panorama_view.h"
#include "ui/review/review_presenter.h"
#include "ui/tasks/task_panel.h"

#include "spherewalk/base/error.h"
#include "spherewalk/geometry/rotation.h"

#include <QAction>
#include <QCheckBox>
#include <QDateTime>
#include <QHBoxLayout>
#include <QLocale>
#include <QPushButton>
#include <QToolButton>

namespace spherewalk::ui {

RegionBar::RegionBar(ReviewPresenter& presenter, PanoramaView& viewer, QWidget* parent)
    : QWidget(parent),
      m_presenter(presenter),
      m_viewer(viewer),
      m_hide(new QAction(ui::icon("hide"), tr("Hide a region"), this)),
      m_remove(new QPushButton(ui::icon("delete"), tr("Remove"), this)),
      m_asExported(new QCheckBox(tr("As e&xported"), this)) {
    m_hide->setCheckable(true);
    m_hide->setShortcut(Qt::Key_H);
    m_hide->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    m_hide->setToolTip(
        tr("Put a box around a face, a screen or a sheet of paper: exports show it blurred (%1)")
            .arg(m_hide->shortcut().toString(QKeySequence::NativeText)));
    connect(m_hide, &QAction::triggered, this, &RegionBar::begin);
    auto* button = new QToolButton(this);
    button->setObjectName("hideRegion");
    button->setDefaultAction(m_hide);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_remove->setObjectName("removeRegion");
    m_remove->setAccessibleName(tr("Remove the selected region"));
    m_remove->setToolTip(
        tr("Let exports show the selected region again (Delete in the photo); click or Tab selects one"));
    m_remove->setFocusPolicy(Qt::TabFocus); // a click leaves the keyboard with the photo
    connect(m_remove, &QPushButton::clicked, &presenter, &ReviewPresenter::removeRegion);
    m_asExported->setObjectName("asExported");
    m_asExported->setToolTip(tr("Show the photo as exports have it, with its private regions blurred"));
    connect(m_asExported, &QCheckBox::toggled, &viewer.presenter(), &PanoramaPresenter::setAsExported);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(button);
    row->addWidget(m_remove);
    row->addStretch(1);
    row->addWidget(m_asExported);
    connect(&viewer, &PanoramaView::regionMarked, &presenter, &ReviewPresenter::markRegion);
    connect(&viewer, &PanoramaView::removalWanted, &presenter, &ReviewPresenter::removeRegion);
    connect(&viewer.presenter(), &PanoramaPresenter::changed, this, &RegionBar::showState);
    connect(&presenter, &ReviewPresenter::currentChanged, this, &RegionBar::showState);
    showState();
}

void RegionBar::begin(bool isMarking) {
    m_viewer.presenter().regions().setMarking(isMarking);
    if (isMarking) {
        m_viewer.setFocus(); // whose keys move the box
    }
}

void RegionBar::showState() {
    const PanoramaPresenter& viewer = m_viewer.presenter();
    const bool canMark = viewer.photo() && m_presenter.canDecide();
    m_hide->setEnabled(canMark);
    m_hide->setChecked(viewer.regions().isMarking());
    m_remove->setEnabled(canMark && viewer.regions().selected() != nullptr);
}

FaceSearchBar::FaceSearchBar(ReviewPresenter& presenter, QWidget* parent)
    : QWidget(parent),
      m_presenter(presenter),
      m_search(new QPushButton(this)),
      m_progress(new TaskBar("stopFaces",
                             tr("Stop; the photos before are done, and the next search goes on "
                                "behind them"),
                             this)) {
    m_search->setObjectName("searchFaces");
    connect(m_search, &QPushButton::clicked, &presenter, &ReviewPresenter::searchFaces);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_search);
    column->addWidget(m_progress);
    connect(&presenter, &ReviewPresenter::searchChanged, this, &FaceSearchBar::showState);
    connect(&presenter, &ReviewPresenter::rowsChanged, this, &FaceSearchBar::showState);
    connect(&presenter, &ReviewPresenter::currentChanged, this, &FaceSearchBar::showState);
    showState();
}

void FaceSearchBar::showState() {
    Task* task = m_presenter.searching();
    m_progress->setTask(task);
    m_search->setVisible(task == nullptr);
    const int unsearched = m_presenter.unsearched();
    m_search->setText(unsearched > 0 ? tr("&Search %n photo(s) for faces", nullptr, unsearched)
                                     : tr("&Search for faces again"));
    m_search->setToolTip(tr("Exports show faces blurred that the search finds. It misses small, covered and "
                            "turned ones: look through the photos, too."));
    m_search->setEnabled(m_presenter.canSearchFaces());
}

namespace {

/// The words of a photo's story, for translators.
struct StoryWords {
    Q_DECLARE_TR_FUNCTIONS(spherewalk::ui::StoryWords)
};

QString timeWords(store::Moment at) {
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(at.time_since_epoch()).count();
    return QLocale().toString(QDateTime::fromMSecsSinceEpoch(ms), QLocale::ShortFormat);
}

QString takenWords(const store::PhotoRecord& photo) {
    const QString file = QString::fromStdString(photo.cameraFileName);
    const QString taken = photo.takenAt
                              ? StoryWords::tr("Taken %1 as %2").arg(timeWords(*photo.takenAt), file)
                              : StoryWords::tr("Taken as %1, it does not say when").arg(file);
    const QString camera =
        photo.cameraSerial.empty()
            ? QString()
            : StoryWords::tr(", by the camera %1").arg(QString::fromStdString(photo.cameraSerial));
    return StoryWords::tr("%1%2; stored %3.").arg(taken, camera, timeWords(photo.addedAt));
}

QString judgedWords(const ReviewRow& row) {
    return !row.isChecked ? StoryWords::tr("No check has judged it.")
           : row.flags.isEmpty()
               ? StoryWords::tr("The checks found nothing.")
               : StoryWords::tr("The checks found %n thing(s).", nullptr, static_cast<int>(row.flags.size()));
}

QString solvedWords(const ReviewRow& row, const std::optional<store::SolutionRecord>& solution) {
    if (!solution) {
        return StoryWords::tr("It is not aligned yet.");
    }
    const QString when = timeWords(solution->createdAt);
    if (!row.roomFromPhoto) {
        return StoryWords::tr("The alignment of %1 found no heading for it.").arg(when);
    }
    const double yawDeg = Degrees(yawPitchRoll(row.roomFromPhoto->rotation).yaw).value();
    return row.sigmaYaw
               ? StoryWords::tr("Aligned %1: it looks along %L2 degrees, known to %L3 degrees.")
                     .arg(when)
                     .arg(yawDeg, 0, 'f', 1)
                     .arg(Degrees(*row.sigmaYaw).value(), 0, 'f', 3)
               : StoryWords::tr("Aligned %1: it looks along %L2 degrees.").arg(when).arg(yawDeg, 0, 'f', 1);
}

QString decidedWords(store::Decision decision) {
    switch (decision) {
    case store::Decision::Accepted:
        return StoryWords::tr("Somebody has accepted it.");
    case store::Decision::Rejected:
        return StoryWords::tr("Somebody has rejected it.");
    case store::Decision::Open:
        break;
    }
    return StoryWords::tr("Nobody has decided on it yet.");
}

/// A sentence each: taken, moved, judged, aligned, decided on. Errors: those of the store.
QStringList storyOf(const store::SurveyStore& store, const ReviewRow& row) {
    const store::PhotoRecord photo = store.photo(*row.photo);
    QStringList story{takenWords(photo)};
    const auto shot = store.shotOf(photo.id);
    if (shot && shot->station != photo.station) {
        story << StoryWords::tr("Moved here from %1, where it was tagged first.")
                     .arg(stationWords(store.station(shot->station).name));
    }
    const auto others = static_cast<int>(store.photosAt(photo.station).size()) - 1;
    if (others > 0) {
        story << StoryWords::tr("The station has %n other photo(s).", nullptr, others);
    }
    story << judgedWords(row) << solvedWords(row, store.activeSolution()) << decidedWords(row.decision);
    return story;
}

} // namespace

StoryLabel::StoryLabel(ReviewPresenter& presenter, QWidget* parent) : QLabel(parent), m_presenter(presenter) {
    setObjectName("story");
    setWordWrap(true);
    setTextInteractionFlags(Qt::TextSelectableByMouse);
    connect(&presenter, &ReviewPresenter::currentChanged, this, &StoryLabel::showState);
    showState();
}

void StoryLabel::setWanted(bool isWanted) {
    m_isWanted = isWanted;
    showState();
}

void StoryLabel::showState() {
    setVisible(m_isWanted);
    setText(m_isWanted ? story() : QString());
}

QString StoryLabel::story() const {
    const ReviewRow* row = m_presenter.current();
    if (m_presenter.session() == nullptr || row == nullptr || !row->photo) {
        return {};
    }
    try {
        return storyOf(m_presenter.session()->store(), *row).join(QLatin1Char('\n'));
    } catch (const Error& error) {
        return coreWords(error.sentence());
    }
}

} // namespace spherewalk::ui
