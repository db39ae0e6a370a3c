// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/review_mode.h"

#include "ui/look/icon.h"
#include "ui/look/told_label.h"
#include "ui/panorama/panorama_view.h"
#include "ui/review/coverage_view.h"
#include "ui/review/region_bar.h"
#include "ui/review/review_model.h"
#include "ui/review/review_presenter.h"

#include <QAction>
#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QScrollBar>
#include <QSplitter>
#include <QToolBar>
#include <QToolButton>

#include <utility>

namespace spherewalk::ui {

ReviewMode::ReviewMode(TaskList& tasks, QWidget* parent)
    : ReviewMode(tasks, ThumbnailCache::usualFolder(), parent) {
}

ReviewMode::ReviewMode(TaskList& tasks, std::filesystem::path thumbnailFolder, QWidget* parent)
    : Mode("review", tr("Review"), tr("Look at the photos, and accept or reject them"), parent),
      m_viewer(new PanoramaView(this)),
      m_presenter(new ReviewPresenter(tasks, std::move(thumbnailFolder), m_viewer->presenter(), this)) {
    m_presenter->setShown(false);
    auto* columns = new QSplitter(this);
    columns->addWidget(makeList());
    m_besideList = {makeViewer(), makePlan()};
    columns->addWidget(m_besideList.first());
    columns->addWidget(m_besideList.last());
    columns->setStretchFactor(0, 0);
    columns->setStretchFactor(1, 3);
    columns->setStretchFactor(2, 2);
    columns->setSizes({310, 560, 380});
    columns->setChildrenCollapsible(false);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(columns);
    connect(m_presenter, &ReviewPresenter::rowsChanged, this, &ReviewMode::showRows);
    connect(m_presenter, &ReviewPresenter::currentChanged, this, &ReviewMode::showCurrent);
    connect(m_presenter, &ReviewPresenter::message, this, &Mode::message);
    connect(this, &Mode::shownChanged, m_presenter, &ReviewPresenter::setShown);
    showCurrent();
}

void ReviewMode::setSession(SurveySession* session) {
    m_presenter->setSession(session);
    m_plan->setSession(session);
    showRows();
}

void ReviewMode::activated() {
    m_presenter->lookForErrors();
    if (m_presenter->current() == nullptr) {
        m_presenter->step(1);
    }
    m_list->setFocus();
}

void ReviewMode::showPart(const QString& part) {
    if (part == "doubtful" && m_presenter->session() != nullptr) {
        const bool hasDoubtful = m_presenter->session()->state().count(Standing::Doubtful) > 0;
        list(hasDoubtful ? ReviewFilter::Doubtful : ReviewFilter::Failed);
    } else if (part == "regions" && m_presenter->session() != nullptr) {
        list(ReviewFilter::WithRegions);
    }
}

/// Lists what passes the filter, and shows the first of it.
void ReviewMode::list(ReviewFilter filter) {
    m_search->clear();
    m_filter->setCurrentIndex(m_filter->findData(static_cast<int>(filter)));
    m_presenter->setCurrent(std::nullopt);
    m_presenter->step(1);
}

QList<Mode::Key> ReviewMode::keys() const {
    return {{tr("Tab, Delete"), tr("In the photo: select a private region, remove it")},
            {tr("arrows, Shift+arrows, Return"),
             tr("While a region is being hidden: move the box, size it, store it")}};
}

QWidget* ReviewMode::makeList() {
    auto* column = new QWidget(this);
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 0, 0, 0);
    m_filter = new QComboBox(column);
    m_filter->setObjectName("filter");
    m_filter->setAccessibleName(tr("Which stations are listed"));
    for (const ReviewFilter filter :
         {ReviewFilter::All, ReviewFilter::ToReview, ReviewFilter::Doubtful, ReviewFilter::Failed,
          ReviewFilter::Missing, ReviewFilter::Rejected, ReviewFilter::WithNote, ReviewFilter::WithRegions}) {
        m_filter->addItem(filterText(filter), static_cast<int>(filter));
    }
    connect(m_filter, &QComboBox::currentIndexChanged, this, [this] {
        m_presenter->list().setFilter(static_cast<ReviewFilter>(m_filter->currentData().toInt()));
        showCurrent();
    });
    m_search = new QLineEdit(column);
    m_search->setObjectName("search");
    m_search->setPlaceholderText(tr("Station, file or note"));
    m_search->setClearButtonEnabled(true);
    m_search->setAccessibleName(tr("Text that listed stations contain"));
    connect(m_search, &QLineEdit::textChanged, &m_presenter->list(), &ReviewProxy::setText);
    m_list = new QListView(column);
    m_list->setObjectName("stations");
    m_list->setAccessibleName(tr("Stations"));
    m_list->setModel(&m_presenter->list());
    m_list->setItemDelegate(new ReviewDelegate(m_list));
    m_list->setUniformItemSizes(true);
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_list->setResizeMode(QListView::Adjust);
    m_sheet = makeAction(tr("Contact sheet"), {QKeySequence(Qt::Key_G)},
                         tr("Show the listed photos beside each other, in place of one photo and the plan"));
    m_sheet->setCheckable(true);
    connect(m_sheet, &QAction::toggled, this, &ReviewMode::showSheet);
    connect(m_list, &QListView::activated, this, [this] { m_sheet->setChecked(false); });
    m_sheet->setIcon(ui::icon("contact"));
    auto* sheet = new QToolButton(column);
    sheet->setObjectName("contactSheet");
    sheet->setDefaultAction(m_sheet);
    auto* searching = new QHBoxLayout;
    searching->addWidget(m_search, 1);
    searching->addWidget(sheet);
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this,
            [this](const QModelIndex& index) {
                if (index.isValid()) {
                    m_presenter->setCurrent(index.data(ReviewModel::StationRole).toLongLong());
                }
            });
    m_summary = new QLabel(column);
    m_summary->setObjectName("summary");
    m_summary->setWordWrap(true);
    m_acceptGood = new QPushButton(column);
    m_acceptGood->setObjectName("acceptGood");
    m_acceptGood->setToolTip(tr("Accept every photo that the checks and the alignment call good"));
    connect(m_acceptGood, &QPushButton::clicked, this,
            [this] { m_presenter->decideAll(m_presenter->goodStations(), store::Decision::Accepted); });
    m_check = new QPushButton(column);
    m_check->setObjectName("checkPhotos");
    m_check->setToolTip(tr("Judge the photos that no check has seen, such as imported ones"));
    connect(m_check, &QPushButton::clicked, m_presenter, &ReviewPresenter::check);
    layout->addWidget(m_filter);
    layout->addLayout(searching);
    layout->addWidget(m_list, 1);
    layout->addWidget(m_summary);
    layout->addWidget(m_check);
    layout->addWidget(m_acceptGood);
    layout->addWidget(new FaceSearchBar(*m_presenter, column));
    return column;
}

QAction* ReviewMode::makeAction(const QString& text, const QList<QKeySequence>& keys,
                                const QString& toolTip) {
    auto* action = new QAction(text, this);
    action->setShortcuts(keys);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    action->setToolTip(keys.isEmpty()
                           ? toolTip
                           : tr("%1 (%2)").arg(toolTip, keys.first().toString(QKeySequence::NativeText)));
    addAction(action);
    return action;
}

QWidget* ReviewMode::makeViewer() {
    auto* column = new QWidget(this);
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 0, 0, 0);

    auto* comparing = new QHBoxLayout;
    m_comparison = new QComboBox(column);
    m_comparison->setObjectName("comparison");
    m_comparison->addItems({tr("One photo"), tr("Blink with"), tr("Slider with")});
    m_comparison->setAccessibleName(tr("How the photo is compared"));
    m_comparison->setToolTip(tr("Compare the photo with a neighbour: C for the next way"));
    m_neighbour = new QComboBox(column);
    m_neighbour->setObjectName("neighbour");
    m_neighbour->setAccessibleName(tr("Neighbour to compare with"));
    m_neighbour->setToolTip(tr("The neighbour to compare with: N for the next one"));
    m_neighbour->setEnabled(false);
    m_align = new QPushButton(tr("Align first"), column);
    m_align->setObjectName("toAlign");
    m_align->setToolTip(tr("Photos that are not aligned may be turned differently"));
    m_align->hide();
    connect(m_align, &QPushButton::clicked, this, [this] { emit pageRequested("align"); });
    comparing->addWidget(m_comparison);
    comparing->addWidget(m_neighbour, 1);
    comparing->addWidget(m_align);
    connect(m_comparison, &QComboBox::currentIndexChanged, this, &ReviewMode::compare);
    connect(m_neighbour, &QComboBox::currentIndexChanged, this,
            [this] { compare(m_comparison->currentIndex()); });
    const auto addCycle = [&](const QString& text, Qt::Key key, QComboBox* box) {
        connect(makeAction(text, {QKeySequence(key)}, {}), &QAction::triggered, box, [box] {
            box->setCurrentIndex(box->count() > 0 ? (box->currentIndex() + 1) % box->count() : -1);
        });
    };
    addCycle(tr("Next way to compare"), Qt::Key_C, m_comparison);
    addCycle(tr("Next neighbour"), Qt::Key_N, m_neighbour);

    m_reasons = new ToldLabel(column);
    m_reasons->setObjectName("reasons");

    auto* story = new StoryLabel(*m_presenter, column);
    QAction* tells = makeAction(tr("Story"), {QKeySequence(Qt::Key_I)},
                                tr("Tell what became of this photo: taken, judged, moved, aligned, decided"));
    tells->setCheckable(true);
    connect(tells, &QAction::toggled, story, &StoryLabel::setWanted);
    m_note = new QLineEdit(column);
    m_note->setObjectName("note");
    m_note->setMaxLength(500);
    m_note->setPlaceholderText(tr("Note on this photo (M)"));
    m_note->setAccessibleName(tr("Note on this photo"));
    connect(m_note, &QLineEdit::editingFinished, this, &ReviewMode::keepNote);
    connect(makeAction(tr("Write a note"), {QKeySequence(Qt::Key_M)}, {}), &QAction::triggered, m_note,
            qOverload<>(&QWidget::setFocus));

    auto* buttons = new QHBoxLayout;
    const auto addDecision = [&](const QString& text, const QString& name, const QList<QKeySequence>& keys,
                                 const QString& toolTip, store::Decision decision) {
        QAction* action = makeAction(text, keys, toolTip);
        connect(action, &QAction::triggered, this, [this, decision] { decide(decision); });
        auto* button = new QToolButton(this);
        button->setObjectName(name);
        button->setDefaultAction(action);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        button->setMinimumHeight(34);
        buttons->addWidget(button);
        m_decisions << action;
    };
    addDecision(standingSign(Standing::Accepted) + tr(" Accept"), "accept", {QKeySequence(Qt::Key_A)},
                tr("Accept the photo and go on"), store::Decision::Accepted);
    addDecision(standingSign(Standing::Rejected) + tr(" Reject"), "reject",
                {QKeySequence(Qt::Key_R), QKeySequence(Qt::Key_Delete)},
                tr("Reject the photo: it is left out of datasets and is to be taken again"),
                store::Decision::Rejected);
    addDecision(tr("Reopen"), "reopen", {QKeySequence(Qt::Key_O)}, tr("Withdraw the decision"),
                store::Decision::Open);
    const auto addStep = [&](const QString& text, const QList<QKeySequence>& keys, int by) {
        connect(makeAction(text, keys, text), &QAction::triggered, this,
                [this, by] { m_presenter->step(by); });
    };
    auto* teller = new QToolButton(this);
    teller->setDefaultAction(tells);
    teller->setMinimumHeight(34);
    buttons->addWidget(teller);
    addStep(tr("Next photo"), {QKeySequence(Qt::Key_J), QKeySequence(Qt::Key_PageDown)}, 1);
    addStep(tr("Previous photo"), {QKeySequence(Qt::Key_K), QKeySequence(Qt::Key_PageUp)}, -1);

    layout->addLayout(comparing);
    auto* regions = new RegionBar(*m_presenter, *m_viewer, column);
    addAction(regions->hideAction());
    layout->addWidget(m_viewer, 1);
    layout->addWidget(regions);
    layout->addWidget(m_reasons);
    layout->addWidget(story);
    layout->addWidget(m_note);
    layout->addLayout(buttons);
    return column;
}

QWidget* ReviewMode::makePlan() {
    auto* column = new QWidget(this);
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 0, 0, 0);
    m_measure = new QComboBox(column);
    m_measure->setObjectName("measure");
    m_measure->setAccessibleName(tr("What the plan shows"));
    m_measure->addItem(tr("Coverage"), static_cast<int>(CoverageMeasure::Standing));
    m_measure->addItem(tr("Residuals of the alignment"), static_cast<int>(CoverageMeasure::Residual));
    m_measure->addItem(tr("Uncertainty of the headings"), static_cast<int>(CoverageMeasure::Sigma));
    m_measure->addItem(tr("Measured errors of views"), static_cast<int>(CoverageMeasure::Error));
    m_report = new QPushButton(tr("Report..."), column);
    m_report->setObjectName("report");
    m_report->setToolTip(tr("Take the errors from another report.json"));
    connect(m_report, &QPushButton::clicked, this, &ReviewMode::chooseReport);
    m_errorWords = new QLabel(column);
    m_errorWords->setObjectName("errorWords");
    m_errorWords->setWordWrap(true);
    m_plan = new CoverageView(column);
    m_plan->setObjectName("coverage");
    m_legend = new CoverageLegend(column);
    connect(m_measure, &QComboBox::currentIndexChanged, this, &ReviewMode::showMeasure);
    auto* row = new QHBoxLayout;
    row->addWidget(m_measure, 1);
    row->addWidget(m_report);
    layout->addLayout(row);
    layout->addWidget(m_plan, 1);
    layout->addWidget(m_legend);
    layout->addWidget(m_errorWords);
    showMeasure();
    return column;
}

std::vector<std::int64_t> ReviewMode::chosen() const {
    std::vector<std::int64_t> stations;
    for (const QModelIndex& index : m_list->selectionModel()->selectedIndexes()) {
        stations.push_back(index.data(ReviewModel::StationRole).toLongLong());
    }
    return stations;
}

void ReviewMode::decide(store::Decision decision) {
    keepNote();
    const std::vector<std::int64_t> stations = chosen();
    if (stations.size() > 1) {
        m_presenter->decideAll(stations, decision);
    } else {
        m_presenter->decide(decision);
    }
}

void ReviewMode::chooseReport() {
    const QString file = QFileDialog::getOpenFileName(this, tr("Report of a measured dataset"), {},
                                                      tr("Report (report.json *.json)"));
    if (!file.isEmpty()) {
        m_presenter->readErrors(file);
    }
}

void ReviewMode::showMeasure() {
    const auto measure = static_cast<CoverageMeasure>(m_measure->currentData().toInt());
    m_plan->setMeasure(measure);
    m_legend->setHottest(m_plan->hottest());
    m_report->setVisible(measure == CoverageMeasure::Error);
    m_errorWords->setVisible(measure == CoverageMeasure::Error);
    m_errorWords->setText(m_presenter->errorWords());
}

void ReviewMode::showRows() {
    m_plan->setRows(m_presenter->model().rows());
    showMeasure();
    m_summary->setText(m_presenter->summary());
    showBatch();
}

/// Shows what can be done with many photos at once.
void ReviewMode::showBatch() {
    const int good = static_cast<int>(m_presenter->goodStations().size());
    m_acceptGood->setText(tr("Accept all &good ones (%1)").arg(good));
    m_acceptGood->setEnabled(good > 0 && m_presenter->canDecide());
    const int unchecked = m_presenter->unchecked();
    m_check->setText(tr("&Check %n photo(s)", nullptr, unchecked));
    m_check->setVisible(unchecked > 0);
    m_check->setEnabled(m_presenter->canDecide());
}

void ReviewMode::showCurrent() {
    const ReviewRow* row = m_presenter->current();
    const bool hasPhoto = row != nullptr && row->photo;
    if (row != nullptr) {
        const QModelIndex index = m_presenter->list().indexOf(row->station);
        if (index != m_list->currentIndex()) {
            m_list->setCurrentIndex(index);
        }
    }
    QList<Told> reasons;
    if (hasPhoto) {
        reasons << tr("%1 %2").arg(standingSign(row->standing), standingText(row->standing));
        for (const QString& flag : row->flags) {
            reasons << coreTold(flag);
        }
    }
    m_reasons->tell(reasons);
    showNote();
    m_note->setEnabled(hasPhoto && m_presenter->canDecide());
    for (QAction* action : std::as_const(m_decisions)) {
        action->setEnabled(hasPhoto && m_presenter->canDecide());
    }
    showNeighbours();
    showBatch();
    showRegions();
}

/// Lets the list take the page, in as many columns as it has room for.
void ReviewMode::showSheet(bool isSheet) {
    m_besideList.first()->setVisible(!isSheet);
    m_besideList.last()->setVisible(!isSheet);
    m_list->setFlow(isSheet ? QListView::LeftToRight : QListView::TopToBottom);
    m_list->setWrapping(isSheet);
    m_list->scrollTo(m_list->currentIndex());
    m_list->setFocus();
}

/// Turns to the first private region of each photo while photos with such are listed.
void ReviewMode::showRegions() {
    const ReviewRow* row = m_presenter->current();
    const bool isWanted = row != nullptr && m_presenter->list().filter() == ReviewFilter::WithRegions;
    const auto photo = isWanted ? row->photo : std::nullopt;
    if (photo != std::exchange(m_regionsOf, photo) && photo &&
        m_viewer->presenter().regions().selected() == nullptr) {
        m_viewer->presenter().selectNextRegion(1);
    }
}

/// Shows the note of the photo. A note that is being written stays with its own photo.
void ReviewMode::showNote() {
    const ReviewRow* row = m_presenter->current();
    const auto photo = row != nullptr ? row->photo : std::nullopt;
    if (photo == m_notePhoto && m_note->isModified()) {
        return;
    }
    keepNote();
    m_notePhoto = photo;
    m_note->setText(photo ? row->note : QString());
}

void ReviewMode::keepNote() {
    if (m_notePhoto && m_note->isModified()) {
        m_note->setModified(false); // before: recording it shows the row anew
        m_presenter->setNote(*m_notePhoto, m_note->text());
    }
}

void ReviewMode::showNeighbours() {
    const QSignalBlocker blocker(m_neighbour);
    const int chosen = m_neighbour->currentIndex();
    m_neighbour->clear();
    const ReviewRow* row = m_presenter->current();
    for (const ReviewRow* neighbour : m_presenter->neighbours()) {
        const QString& name = neighbour->stationName;
        const std::optional<double> metres = apartM(*row, *neighbour);
        m_neighbour->addItem(metres ? tr("%1, %2 cm away").arg(name).arg(100 * *metres, 0, 'f', 0) : name);
    }
    m_neighbour->setCurrentIndex(std::min(std::max(0, chosen), m_neighbour->count() - 1));
    m_align->setVisible(m_viewer->presenter().isComparingUnaligned());
}

void ReviewMode::compare(int comparison) {
    m_neighbour->setEnabled(comparison > 0);
    m_viewer->presenter().setComparison(static_cast<Comparison>(comparison));
    const int neighbour = m_neighbour->currentIndex();
    m_presenter->compareWith(
        comparison > 0 && neighbour >= 0 ? std::optional(static_cast<std::size_t>(neighbour)) : std::nullopt);
}

} // namespace spherewalk::ui
