// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_mode.h"

#include "ui/export/export_presenter.h"
#include "ui/export/measure_panel.h"
#include "ui/export/page_panel.h"
#include "ui/export/place_panel.h"
#include "ui/fields/camera_box.h"
#include "ui/fields/scene_fields.h"
#include "ui/look/side_panel.h"
#include "ui/look/told_label.h"
#include "ui/look/words.h"
#include "ui/tasks/task_panel.h"

#include "spherewalk/jobs/measured_dataset.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDesktopServices>
#include <QFileDialog>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QUrl>

namespace spherewalk::ui {

namespace {

constexpr int kNarrowestPage = 640;
constexpr int kWidestPage = 760; ///< Longer lines are hard to read.

QString secondsText(double seconds) {
    return durationText(std::chrono::duration<double>(seconds));
}

/// Puts the sign of a finding before its sentence.
Told marked(Standing standing, const Told& told) {
    return {standingSign(standing) + QLatin1Char(' ') + told.text, told.cure};
}

/// Lets the box be narrower than its longest item, so that the page fits a small window in any language.
void makeNarrow(QComboBox* box) {
    constexpr int kLeastCharacters = 24;
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(kLeastCharacters);
}

ToldLabel* wrapped(QWidget* parent, const char* name) {
    auto* label = new ToldLabel(parent);
    label->setObjectName(name);
    return label;
}

} // namespace

ExportMode::ExportMode(TaskList& tasks, QWidget* parent)
    : Mode("export", tr("Export"), tr("Make a dataset for simulators"), parent),
      m_presenter(new ExportPresenter(tasks, this)),
      m_measure(new MeasurePresenter(tasks, this)),
      m_place(new PlacePresenter(tasks, this)),
      m_page(new PagePresenter(tasks, this)),
      m_open([](const QUrl& url) { return QDesktopServices::openUrl(url); }) {
    auto* page = new QWidget(this);
    page->setMaximumWidth(kWidestPage);
    page->setMinimumWidth(kNarrowestPage); // else the plan beside it takes the space
    auto* column = new QVBoxLayout(page);
    column->addWidget(makeWhere());
    column->addWidget(makeBefore());
    column->addWidget(makeAfter());
    auto* measure = new MeasurePanel(*m_measure, page);
    connect(measure, &MeasurePanel::message, this, &Mode::message);
    connect(measure, &MeasurePanel::openRequested, this, &ExportMode::open);
    column->addWidget(measure);
    auto* place = new PlacePanel(*m_place, page);
    connect(place, &PlacePanel::openRequested, this, &ExportMode::open);
    column->addWidget(place);
    auto* shared = new PagePanel(*m_page, page);
    connect(shared, &PagePanel::openRequested, this, &ExportMode::open);
    column->addWidget(shared);
    column->addStretch(1);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(new ColumnScrollArea(page, this));
    connect(m_presenter, &ExportPresenter::changed, this, &ExportMode::showAll);
    connect(m_presenter, &ExportPresenter::message, this, &Mode::message);
    showTolerance(false);
    showAll();
}

void ExportMode::setSession(SurveySession* session) {
    m_isSceneChosen = false;
    m_presenter->setSession(session);
    m_page->setSession(session);
    m_folder->setText(m_presenter->folder());
    proposeScene();
}

/// Proposes to measure where there is enough to compare, until somebody chooses.
void ExportMode::proposeScene() {
    if (m_isSceneChosen || m_presenter->session() == nullptr) {
        return;
    }
    const int photos = m_presenter->session()->state().counts.stationsWithPhoto;
    m_scene->setCurrentIndex(photos >= jobs::kEnoughToMeasure ? m_scene->count() - 1 : 0);
    m_isSceneChosen = false;
}

void ExportMode::activated() {
    proposeScene();
    m_presenter->check();
    m_folder->setFocus();
}

void ExportMode::showPart(const QString& part) {
    if (part == QLatin1String("scene")) {
        m_scene->setFocus(Qt::ShortcutFocusReason);
    } else if (part == QLatin1String("folder")) {
        m_folder->setFocus(Qt::ShortcutFocusReason);
        m_folder->selectAll();
    }
}

QWidget* ExportMode::makeWhere() {
    auto* box = new QGroupBox(tr("What and where"), this);
    auto* form = new QFormLayout(box);
    m_folder = new QLineEdit(box);
    m_folder->setObjectName("folder");
    m_folder->setToolTip(tr("A folder that does not exist yet"));
    connect(m_folder, &QLineEdit::textEdited, m_presenter, &ExportPresenter::setFolder);
    connect(m_folder, &QLineEdit::editingFinished, m_presenter, &ExportPresenter::check);
    auto* choose = new QPushButton(tr("Choose..."), box);
    connect(choose, &QPushButton::clicked, this, &ExportMode::chooseFolder);
    auto* row = new QHBoxLayout;
    row->addWidget(m_folder, 1);
    row->addWidget(choose);
    auto* label = new QLabel(tr("Fo&lder"), box);
    label->setBuddy(m_folder);
    form->addRow(label, row);
    m_scene = new QComboBox(box);
    m_scene->setObjectName("scene");
    makeNarrow(m_scene);
    m_scene->addItem(tr("Sphere (nothing more is computed)"), static_cast<int>(render::SceneKind::Sphere));
    m_scene->addItem(tr("Room: walls, floor, ceiling (a minute or two)"),
                     static_cast<int>(render::SceneKind::Room));
    m_scene->addItem(tr("Depth of each pixel (some seconds a photo)"),
                     static_cast<int>(render::SceneKind::Depth));
    m_scene->addItem(tr("The cheapest that holds a tolerance (all are tried and measured)"));
    m_scene->setToolTip(
        tr("What views of places between photos can be computed with; cheaper ones come with it"));
    connect(m_scene, &QComboBox::currentIndexChanged, this, [this] {
        m_isSceneChosen = true;
        applyOptions();
    });
    form->addRow(tr("S&cene model"), m_scene);
    form->addRow(tr("Eno&ugh for"), makeTolerance(box));
    m_markers = new QComboBox(box);
    m_markers->setObjectName("markers");
    makeNarrow(m_markers);
    m_markers->addItem(tr("Fastest views (photos grow by about 2 %)"),
                       dataset::WriteOptions().mcusPerInterval);
    m_markers->addItem(tr("Smaller (0.6 %), views of new places take longer"), 21);
    m_markers->setToolTip(tr("How far apart the marks are that let a part of a photo be decoded by itself"));
    connect(m_markers, &QComboBox::currentIndexChanged, this, &ExportMode::applyOptions);
    form->addRow(tr("&Optimised for"), m_markers);
    m_opens = new QCheckBox(tr("Open the folder &when it is done"), box);
    m_opens->setObjectName("opens");
    m_opens->setChecked(true);
    form->addRow(QString(), m_opens);
    return box;
}

/// Makes the fields of camera and tolerance, for which the scene model is chosen.
QWidget* ExportMode::makeTolerance(QWidget* parent) {
    m_wanted = new QWidget(parent);
    auto* row = new QHBoxLayout(m_wanted);
    row->setContentsMargins(0, 0, 0, 0);
    m_camera = new CameraBox(m_wanted);
    m_camera->setObjectName("sceneCamera");
    connect(m_camera, &CameraBox::message, this, &Mode::message);
    connect(m_camera, &CameraBox::cameraChanged, this, &ExportMode::applyOptions);
    m_tolerance = new ToleranceBox("sceneTolerance", m_wanted);
    connect(m_tolerance, &QDoubleSpinBox::valueChanged, this, &ExportMode::applyOptions);
    row->addWidget(m_camera, 1);
    row->addWidget(new QLabel(tr("within"), m_wanted));
    row->addWidget(m_tolerance);
    m_wanted->setFocusProxy(m_camera);
    return m_wanted;
}

QWidget* ExportMode::makeBefore() {
    auto* box = new QGroupBox(tr("Before"), this);
    auto* layout = new QVBoxLayout(box);
    m_amount = wrapped(box, "amount");
    m_findings = wrapped(box, "findings");
    m_check = new QPushButton(tr("Chec&k again"), box);
    m_check->setObjectName("check");
    m_check->setToolTip(tr("Look again at what the dataset would have and lack"));
    connect(m_check, &QPushButton::clicked, m_presenter, &ExportPresenter::check);
    auto* row = new QHBoxLayout;
    row->addWidget(m_amount, 1);
    row->addWidget(m_check);
    m_review = new QPushButton(tr("Look at them in &Review"), box);
    m_review->setObjectName("toReview");
    connect(m_review, &QPushButton::clicked, this, [this] { emit pageRequested("review", "doubtful"); });
    auto* below = new QHBoxLayout;
    below->addWidget(m_findings, 1);
    below->addWidget(m_review, 0, Qt::AlignTop);
    layout->addLayout(row);
    layout->addLayout(below);
    return box;
}

QWidget* ExportMode::makeAfter() {
    auto* box = new QWidget(this);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* row = new QHBoxLayout;
    m_export = new QPushButton(tr("E&xport"), box);
    m_export->setObjectName("export");
    m_export->setMinimumHeight(36);
    m_export->setDefault(true);
    connect(m_export, &QPushButton::clicked, m_presenter, &ExportPresenter::exportNow);
    m_progress = new TaskBar("stop", tr("Stop; nothing of the dataset is left then"), box);
    row->addWidget(m_export);
    row->addWidget(m_progress, 1);
    row->addStretch(0);
    m_result = wrapped(box, "result");
    m_openButton = new QPushButton(tr("Open the fol&der"), box);
    m_openButton->setObjectName("open");
    connect(m_openButton, &QPushButton::clicked, this, [this] { open(m_presenter->exported()); });
    auto* after = new QHBoxLayout;
    after->addWidget(m_result, 1);
    after->addWidget(m_openButton);
    layout->addLayout(row);
    layout->addLayout(after);
    return box;
}

void ExportMode::chooseFolder() {
    const QString folder = QFileDialog::getSaveFileName(this, tr("Folder of the dataset"), m_folder->text(),
                                                        {}, nullptr, QFileDialog::DontConfirmOverwrite);
    if (!folder.isEmpty()) {
        m_folder->setText(folder);
        m_presenter->setFolder(folder);
        m_presenter->check();
    }
}

void ExportMode::applyOptions() {
    const bool isChosen = !m_scene->currentData().isValid();
    jobs::ExportOptions options;
    options.scene =
        isChosen ? render::SceneKind::Depth : static_cast<render::SceneKind>(m_scene->currentData().toInt());
    options.write.mcusPerInterval = m_markers->currentData().toInt();
    showTolerance(isChosen);
    m_presenter->setOptions(options,
                            isChosen ? std::optional(ViewTolerance{m_camera->camera(), m_tolerance->value()})
                                     : std::nullopt);
    m_presenter->check();
}

void ExportMode::showTolerance(bool isWanted) {
    static_cast<QFormLayout*>(m_wanted->parentWidget()->layout())->setRowVisible(m_wanted, isWanted);
}

void ExportMode::open(const QString& path) {
    if (!m_open(QUrl::fromLocalFile(path))) {
        emit message(tr("No program could open %1.").arg(path));
    }
}

void ExportMode::showAll() {
    showFound();
    showTask();
    m_measure->setDataset(m_presenter->dataset());
    m_place->setDataset(m_presenter->dataset());
    const QString exported = m_presenter->exported();
    m_openButton->setVisible(!exported.isEmpty());
    m_result->setVisible(!exported.isEmpty());
    if (exported.isEmpty()) {
        m_opened.clear();
        return;
    }
    const jobs::ExportReport& report = m_presenter->report();
    Told told =
        marked(Standing::Accepted,
               tr("%1: %n photo(s), %2, in %3.", nullptr, static_cast<int>(report.written.photos))
                   .arg(exported, bytesText(report.written.totalBytes), secondsText(m_presenter->seconds())));
    if (const QString reason = m_presenter->reason(); !reason.isEmpty()) {
        told.text += QLatin1Char('\n') + coreTold(reason).text;
        told.cure = coreTold(reason).cure;
    }
    if (report.carriedShare > 0) {
        told.text +=
            QLatin1Char('\n') + tr("What the camera carries along covers %1 % of each photo. The dataset "
                                   "shows floor and walls there, as other photos see them.")
                                    .arg(100 * report.carriedShare, 0, 'f', 1);
    }
    m_result->tell(told);
    if (m_opens->isChecked() && m_opened != exported) {
        m_opened = exported;
        open(exported);
    }
}

void ExportMode::showFound() {
    const auto& found = m_presenter->found();
    const int undecided = m_presenter->undecided();
    m_review->setVisible(found && undecided > 0);
    m_check->setEnabled(m_presenter->session() != nullptr && !m_presenter->isChecking());
    if (!found) {
        m_amount->tell(m_presenter->session() == nullptr ? Told(tr("No survey is open."), Cure::Start)
                       : m_presenter->isChecking()       ? Told(tr("Trying one photo..."))
                                                         : Told(tr("Not checked yet.")));
        m_findings->tell(Told());
        return;
    }
    QString amount =
        tr("%n photo(s), about %1 and %2; %3 are free.", nullptr, static_cast<int>(found->photos))
            .arg(bytesText(found->totalBytes), secondsText(found->seconds), bytesText(found->freeBytes));
    if (!m_scene->currentData().isValid()) {
        amount += QLatin1Char(' ') + tr("Measuring all that is tried comes on top of that.");
    }
    m_amount->tell(amount);
    QList<Told> sentences;
    for (const std::string& obstacle : found->obstacles) {
        sentences << marked(Standing::Failed, coreTold(obstacle));
    }
    for (const std::string& doubt : found->doubts) {
        sentences << marked(Standing::Doubtful, coreTold(doubt));
    }
    if (undecided > 0) {
        sentences << marked(
            Standing::Doubtful,
            tr("%n photo(s) are doubtful or failed, and nobody has decided.", nullptr, undecided));
    }
    if (sentences.isEmpty()) {
        sentences << marked(Standing::Accepted, tr("Nothing is missing or doubtful."));
    }
    if (found->privateRegions > 0) {
        const QString where = tr("in %n photo(s)", nullptr, static_cast<int>(found->blurredPhotos));
        sentences << Told(
            tr("%n private region(s) %1 will be blurred.", nullptr, static_cast<int>(found->privateRegions))
                .arg(where),
            Cure::Regions);
    }
    m_findings->tell(sentences);
}

void ExportMode::showTask() {
    m_export->setEnabled(m_presenter->canExport());
    m_progress->setTask(m_presenter->task());
}

} // namespace spherewalk::ui
