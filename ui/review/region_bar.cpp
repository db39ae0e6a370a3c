// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/region_bar.h"

#include "ui/look/icon.h"
#include "ui/panorama/panorama_view.h"
#include "ui/review/review_presenter.h"
#include "ui/tasks/task_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QHBoxLayout>
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
    setText(m_isWanted ? m_presenter.story().join(QLatin1Char('\n')) : QString());
}

} // namespace spherewalk::ui
