// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/align/align_mode.h"

#include "ui/align/align_presenter.h"
#include "ui/look/told_label.h"
#include "ui/review/coverage_view.h"
#include "ui/tasks/task_panel.h"

#include "spherewalk/base/error.h"
#include "spherewalk/geometry/rotation.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QTableView>

#include <algorithm>
#include <cmath>

namespace spherewalk::ui {

namespace {

constexpr double kShortestPx = 12;
constexpr double kLongestPx = 34;
constexpr double kLengthM = 0.16;
constexpr double kWidestFanDeg = 120;

} // namespace

void HeadingLayer::paint(QPainter& painter, const QTransform& widgetFromRoom) {
    const QColor ink = painter.pen().color();
    const double scale = std::hypot(widgetFromRoom.m11(), widgetFromRoom.m12());
    const double length = std::clamp(kLengthM * scale, kShortestPx, kLongestPx);
    for (const jobs::PhotoFinding& photo : m_photos) {
        if (!photo.roomFromPhoto) {
            continue;
        }
        const QPointF at = mapped(photo.roomFromPhoto->translation.head<2>(), widgetFromRoom);
        const double yawDeg = Degrees(yawPitchRoll(photo.roomFromPhoto->rotation).yaw).value();
        if (photo.sigmaYaw) {
            const double halfDeg =
                std::min(0.5 * kWidestFanDeg, 3 * kMagnified * Degrees(*photo.sigmaYaw).value());
            QColor fan = ink;
            fan.setAlphaF(0.25F);
            painter.setPen(Qt::NoPen);
            painter.setBrush(fan);
            // Qt counts sixteenths of a degree, counter-clockwise as the room does.
            painter.drawPie(QRectF(at.x() - length, at.y() - length, 2 * length, 2 * length),
                            static_cast<int>(16 * (yawDeg - halfDeg)), static_cast<int>(32 * halfDeg));
        }
        QLineF line(at, at + QPointF(length, 0));
        line.setAngle(yawDeg);
        painter.setPen(QPen(ink, 1.6));
        painter.drawLine(line);
    }
}

AlignMode::AlignMode(TaskList& tasks, QWidget* parent)
    : Mode("align", tr("Align"), tr("Solve how each photo is turned, and see how well it is known"), parent),
      m_presenter(new AlignPresenter(tasks, this)) {
    m_presenter->setShown(false);
    auto* columns = new QSplitter(this);
    columns->addWidget(makeTable());
    columns->addWidget(makePlan());
    columns->setStretchFactor(0, 3);
    columns->setStretchFactor(1, 2);
    columns->setSizes({720, 480});
    columns->setChildrenCollapsible(false);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(makeBar());
    layout->addWidget(columns, 1);
    connect(m_presenter, &AlignPresenter::findingsChanged, this, &AlignMode::showFindings);
    connect(m_presenter, &AlignPresenter::taskChanged, this, &AlignMode::showTask);
    connect(m_presenter, &AlignPresenter::message, this, &Mode::message);
    connect(this, &Mode::shownChanged, m_presenter, &AlignPresenter::setShown);
    showFindings();
    showTask();
}

AlignMode::~AlignMode() {
    m_plan->removeLayer(&m_headings);
}

void AlignMode::setSession(SurveySession* session) {
    m_plan->setSession(session);
    m_presenter->setSession(session);
    setMask({});
    m_places->setCurrentIndex(0);
    m_isByHand = false;
    chooseFree();
    if (session != nullptr) {
        const SurveyState& survey = session->state();
        const bool isGuess = survey.options.areHeightsGuessed && survey.plan.placements.empty();
        m_lensHeight->setValue(isGuess ? m_lensHeight->minimum() : survey.options.heightsM.front());
        const double saidM = survey.findings ? survey.findings->positionSigmaM : 0;
        m_positionSigma->setValue(1000 * (saidM > 0 ? saidM : jobs::AlignOptions().positionSigmaM));
        connect(session->selection(), &StationSelection::currentChanged, this, &AlignMode::selectStation);
    }
    showTask();
}

void AlignMode::activated() {
    selectStation();
    (m_run->isEnabled() && !m_presenter->findings() ? static_cast<QWidget*>(m_run) : m_table)->setFocus();
}

QWidget* AlignMode::makeBar() {
    auto* bar = new QWidget(this);
    auto* rows = new QVBoxLayout(bar);
    rows->setContentsMargins(0, 0, 0, 0);
    auto* layout = new QHBoxLayout;
    rows->addLayout(layout);
    const auto addLabelled = [&](const QString& text, QWidget* widget) {
        auto* label = new QLabel(text, bar);
        label->setBuddy(widget);
        layout->addWidget(label);
        layout->addWidget(widget);
        return QList<QWidget*>{label, widget};
    };
    m_places = new QComboBox(bar);
    m_places->setObjectName("places");
    m_places->addItem(tr("As tagged"));
    m_places->addItem(tr("From the pictures alone"));
    m_places->setToolTip(
        tr("Where the photos were taken: as they are tagged, or solved from what they show; then the "
           "stations move there"));
    connect(m_places, &QComboBox::currentIndexChanged, this, &AlignMode::showFree);
    addLabelled(tr("Pla&ces"), m_places);
    m_effort = new QComboBox(bar);
    m_effort->setObjectName("effort");
    m_effort->addItem(tr("Draft"), static_cast<int>(align::Effort::Draft));
    m_effort->addItem(tr("Normal"), static_cast<int>(align::Effort::Normal));
    m_effort->addItem(tr("Fine"), static_cast<int>(align::Effort::Fine));
    m_effort->addItem(tr("Exact"), static_cast<int>(align::Effort::Exact));
    m_effort->setCurrentIndex(1);
    m_effort->setToolTip(
        tr("How much work goes into the pictures: about 0.1, 0.5, 1.5 or 3.5 s a photo on one core"));
    addLabelled(tr("Eff&ort"), m_effort);
    m_model = new QComboBox(bar);
    m_model->setObjectName("model");
    m_model->addItem(tr("What the photos support"), static_cast<int>(align::Model::Auto));
    m_model->addItem(tr("Yaw"), static_cast<int>(align::Model::Yaw));
    m_model->addItem(tr("Yaw and tilt"), static_cast<int>(align::Model::Tilt));
    m_model->addItem(tr("And rail placements"), static_cast<int>(align::Model::Placement));
    m_model->addItem(tr("And positions"), static_cast<int>(align::Model::Position));
    m_model->setToolTip(tr("What is solved, each with all that the ones above it solve"));
    m_ofTagged << addLabelled(tr("&Model"), m_model);
    m_positionSigma = new QDoubleSpinBox(bar);
    m_positionSigma->setObjectName("positionSigma");
    m_positionSigma->setRange(0.1, 1000);
    m_positionSigma->setDecimals(1);
    m_positionSigma->setSuffix(tr(" mm"));
    m_positionSigma->setValue(1000 * jobs::AlignOptions().positionSigmaM);
    m_positionSigma->setToolTip(
        tr("How far photos stand from where they are tagged, one standard deviation"));
    m_ofTagged << addLabelled(tr("&Positions to"), m_positionSigma);
    m_lensHeight = new QDoubleSpinBox(bar);
    m_lensHeight->setObjectName("lensHeight");
    m_lensHeight->setRange(0.05, 20);
    m_lensHeight->setSpecialValueText(tr("not known")); // At the least value, which is none.
    m_lensHeight->setDecimals(2);
    m_lensHeight->setSingleStep(0.01);
    m_lensHeight->setSuffix(tr(" m"));
    m_lensHeight->setToolTip(
        tr("Usual height of the lens above the floor: it tells how large everything is"));
    m_ofFree << addLabelled(tr("Le&ns at"), m_lensHeight);
    layout->addStretch(1);
    layout = new QHBoxLayout;
    rows->addLayout(layout);
    m_maskButton = new QPushButton(bar);
    m_maskButton->setObjectName("mask");
    m_maskButton->setToolTip(
        tr("A picture, twice as wide as high, black where photos are not to be looked at: cart, operator"));
    connect(m_maskButton, &QPushButton::clicked, this, &AlignMode::chooseMask);
    layout->addWidget(m_maskButton);
    m_run = new QPushButton(tr("&Align"), bar);
    m_run->setObjectName("run");
    m_run->setDefault(true);
    m_run->setToolTip(tr("Solve how each photo is turned"));
    connect(m_run, &QPushButton::clicked, this, &AlignMode::run);
    layout->addWidget(m_run);
    m_progress =
        new TaskBar("stop", tr("Stop; what was found in the pictures is kept for the next run"), bar);
    layout->addWidget(m_progress, 1);
    layout->addStretch(0);
    setMask({});
    showFree();
    return bar;
}

QWidget* AlignMode::makeTable() {
    auto* column = new QWidget(this);
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 0, 0, 0);
    m_summary = new ToldLabel(column);
    m_summary->setObjectName("summary");
    auto* onlyFlagged = new QCheckBox(tr("Only photos with a fla&g"), column);
    onlyFlagged->setObjectName("onlyFlagged");
    connect(onlyFlagged, &QCheckBox::toggled, &m_presenter->table(), &AlignProxy::setOnlyFlagged);
    m_table = new QTableView(column);
    m_table->setObjectName("photos");
    m_table->setAccessibleName(tr("Photos and what the alignment says of them"));
    m_table->setModel(&m_presenter->table());
    m_table->setSortingEnabled(true);
    m_table->sortByColumn(AlignModel::Station, Qt::AscendingOrder);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setAlternatingRowColors(true);
    m_table->setShowGrid(false);
    m_table->setWordWrap(false);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height() + 8);
    m_table->horizontalHeader()->setStretchLastSection(true);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &AlignMode::showProposals);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this,
            [this](const QModelIndex& index) {
                if (m_presenter->session() != nullptr && index.isValid()) {
                    m_presenter->session()->selection()->setCurrent(
                        index.data(AlignModel::StationRole).toLongLong());
                }
            });
    m_reason = new ToldLabel(column);
    m_reason->setObjectName("reason");
    auto* buttons = new QHBoxLayout;
    const auto add = [&](const QString& text, const QString& name, const QString& toolTip) {
        auto* button = new QPushButton(text, column);
        button->setObjectName(name);
        button->setToolTip(toolTip);
        buttons->addWidget(button);
        return button;
    };
    m_retag = add(tr("Re&tag"), "retag", tr("Move the chosen photos to the stations that fit them"));
    m_retagAll =
        add(tr("Retag a&ll proposed"), "retagAll", tr("Move every photo that fits another station there"));
    m_retake =
        add(tr("&Retake"), "retake", tr("Reject the chosen photos, so that their stations are taken again"));
    connect(m_retag, &QPushButton::clicked, this, [this] { m_presenter->retag(chosen()); });
    connect(m_retagAll, &QPushButton::clicked, m_presenter, &AlignPresenter::retagAll);
    connect(m_retake, &QPushButton::clicked, this, [this] { m_presenter->retake(chosen()); });
    buttons->addStretch(1);
    layout->addWidget(m_summary);
    layout->addWidget(onlyFlagged);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_reason);
    layout->addLayout(buttons);
    return column;
}

QWidget* AlignMode::makePlan() {
    auto* column = new QWidget(this);
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 0, 0, 0);
    m_plan = new CoverageView(column);
    m_plan->setObjectName("headings");
    m_plan->setAccessibleName(tr("Headings of the photos"));
    m_plan->setMeasure(CoverageMeasure::Sigma);
    m_plan->addLayer(&m_headings);
    m_legend = new CoverageLegend(column);
    auto* words =
        new QLabel(tr("Lines: how photos are turned. Fans: three standard deviations, %1 times as wide. "
                      "Colour: standard deviation of the yaw.")
                       .arg(HeadingLayer::kMagnified),
                   column);
    words->setWordWrap(true);
    layout->addWidget(m_plan, 1);
    layout->addWidget(m_legend);
    layout->addWidget(words);
    return column;
}

void AlignMode::run() {
    jobs::AlignOptions options;
    options.isFree = isFree();
    const auto effort = static_cast<align::Effort>(m_effort->currentData().toInt());
    if (effort != options.chosenEffort()) { // Else what suits: rough tags want more.
        options.effort = effort;
    }
    if (options.isFree) {
        const bool isKnown = m_lensHeight->value() > m_lensHeight->minimum();
        options.lensHeightM = isKnown ? m_lensHeight->value() : 0;
    } else {
        options.model = static_cast<align::Model>(m_model->currentData().toInt());
        options.positionSigmaM = 0.001 * m_positionSigma->value();
    }
    options.mask = m_mask;
    m_presenter->run(options);
}

bool AlignMode::isFree() const {
    return m_places->currentIndex() == 1;
}

/// Photos whose places nobody knows, or that the alignment alone knows, are aligned in one way.
void AlignMode::chooseFree() {
    const SurveySession* session = m_presenter->session();
    const bool isByHand =
        session != nullptr && (session->state().hasUnknownPlaces() ||
                               (session->state().findings && session->state().findings->isFree));
    if (isByHand && !m_isByHand) {
        m_places->setCurrentIndex(1);
    }
    m_isByHand = isByHand;
}

/// Takes the effort that suits the choice, and offers what has a meaning with it.
void AlignMode::showFree() {
    jobs::AlignOptions options;
    options.isFree = isFree();
    m_effort->setCurrentIndex(m_effort->findData(static_cast<int>(options.chosenEffort())));
    for (QWidget* widget : std::as_const(m_ofTagged)) {
        widget->setVisible(!options.isFree);
    }
    for (QWidget* widget : std::as_const(m_ofFree)) {
        widget->setVisible(options.isFree);
    }
}

void AlignMode::chooseMask() {
    const QString file = QFileDialog::getOpenFileName(this, tr("Picture that tells what is left out"), {},
                                                      tr("Pictures (*.png *.jpg *.jpeg)"));
    setMask(file.toStdString());
}

void AlignMode::setMask(const std::filesystem::path& mask) {
    m_mask = mask;
    m_maskButton->setText(mask.empty()
                              ? tr("No mas&k...")
                              : tr("Mas&k: %1").arg(QString::fromStdString(mask.filename().string())));
}

void AlignMode::showFindings() {
    chooseFree();
    const auto& findings = m_presenter->findings();
    m_summary->tell(m_presenter->summary());
    m_headings.setPhotos(findings ? findings->photos : std::vector<jobs::PhotoFinding>());
    try {
        m_plan->setRows(m_presenter->session() != nullptr
                            ? reviewRows(m_presenter->session()->store(), findings)
                            : std::vector<ReviewRow>());
    } catch (const Error& error) {
        emit message(coreTold(error.sentence()));
    }
    m_legend->setHottest(m_plan->hottest());
    sizeColumns();
    selectStation();
    showProposals();
}

void AlignMode::showTask() {
    m_run->setEnabled(m_presenter->canRun());
    m_progress->setTask(m_presenter->task());
    showProposals();
}

/// Sizes the columns once, for the first rows. Later sizes are the user's own.
void AlignMode::sizeColumns() {
    if (m_areColumnsSized || m_presenter->model().rowCount() == 0) {
        return;
    }
    m_areColumnsSized = true;
    for (const int column :
         {AlignModel::Station, AlignModel::Verdict, AlignModel::Yaw, AlignModel::SigmaYaw,
          AlignModel::SigmaTilt, AlignModel::Residual, AlignModel::Neighbours, AlignModel::Proposal}) {
        m_table->resizeColumnToContents(column);
    }
}

std::vector<std::int64_t> AlignMode::chosen() const {
    std::vector<std::int64_t> photos;
    for (const QModelIndex& row : m_table->selectionModel()->selectedRows()) {
        photos.push_back(row.data(AlignModel::PhotoRole).toLongLong());
    }
    return photos;
}

void AlignMode::showProposals() {
    const std::vector<std::int64_t> photos = chosen();
    bool hasRetag = false;
    QList<Told> reasons;
    for (const std::int64_t id : photos) {
        const jobs::PhotoFinding* photo = m_presenter->model().photo(id);
        hasRetag = hasRetag || (photo != nullptr && photo->fits);
        for (const std::string& flag : photo != nullptr ? photo->flags : std::vector<std::string>()) {
            const Told reason = coreTold(flag);
            const auto isSame = [&](const Told& other) { return other.text == reason.text; };
            if (std::none_of(reasons.cbegin(), reasons.cend(), isSame)) {
                reasons << reason;
            }
        }
    }
    m_reason->tell(reasons.mid(0, 4));
    const bool isFree = m_presenter->canRun();
    const auto& findings = m_presenter->findings();
    m_retag->setEnabled(isFree && hasRetag);
    m_retagAll->setEnabled(isFree && findings && !findings->retags().empty());
    m_retake->setEnabled(isFree && !photos.empty());
}

void AlignMode::selectStation() {
    SurveySession* session = m_presenter->session();
    const auto station = session != nullptr ? session->selection()->current() : std::nullopt;
    if (!station || m_presenter->table().rowCount() == 0) {
        return;
    }
    const QModelIndexList found =
        m_presenter->table().match(m_presenter->table().index(0, 0), AlignModel::StationRole,
                                   QVariant::fromValue<qlonglong>(*station), 1, Qt::MatchExactly);
    if (!found.isEmpty() && found.first().row() != m_table->currentIndex().row()) {
        m_table->setCurrentIndex(found.first());
    }
}

} // namespace spherewalk::ui
