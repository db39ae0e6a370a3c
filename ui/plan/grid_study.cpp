// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/grid_study.h"

#include "ui/fields/camera_box.h"
#include "ui/fields/scene_fields.h"
#include "ui/look/core_words.h"
#include "ui/look/words.h"
#include "ui/tasks/task_panel.h"

#include "spherewalk/jobs/measured_dataset.h"
#include "spherewalk/render/renderer.h"

#include <QCheckBox>
#include <QFont>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTableView>

#include <algorithm>
#include <cmath>

namespace spherewalk::ui {

namespace {

QString minutesText(double minutes) {
    return durationText(std::chrono::duration<double>(60 * minutes));
}

QString centimetresText(double metres) {
    return GridStudyModel::tr("%L1 cm").arg(100 * metres, 0, 'f', 0);
}

constexpr double kExportShare = 0.1; ///< Share of the progress, about.

/// Runs on the thread of the task.
jobs::GridStudy studied(const std::filesystem::path& survey, const GridQuestion& question,
                        ProgressSink& progress, const std::stop_token& stop) {
    const auto store = store::SurveyStore::open(survey, store::Access::Read);
    const std::filesystem::path cache = jobs::measureCacheFolder(survey);
    ProgressStep exporting(progress, 0, kExportShare);
    // The study finds depths of its own, from the photos that it keeps.
    const auto folder = jobs::surveyDataset(store, render::SceneKind::Sphere, cache, exporting, stop);
    const render::Renderer renderer(
        std::make_shared<const render::Dataset>(render::Dataset::open(folder, render::Verify::Sizes)));
    jobs::GridStudyOptions options;
    options.tolerancePx = question.tolerancePx;
    options.withDepth = question.withDepth;
    options.room = store.knownRoom();
    options.plan = store.planOptions();
    options.cacheFolder = cache / "results";
    ProgressStep studying(progress, kExportShare, 1);
    return jobs::gridStudy(renderer, CameraModel(question.camera), options, studying, stop);
}

} // namespace

void GridStudyModel::setStudy(const jobs::GridStudy& study) {
    beginResetModel();
    m_tolerancePx = study.tolerancePx;
    m_scenes.clear();
    m_lines.clear();
    for (const jobs::GridAnswer& answer : study.answers) {
        m_scenes.push_back(answer.scene);
    }
    for (const jobs::GridRow& row : study.rows) {
        if (m_lines.empty() || m_lines.back().stepM != row.stepM) {
            Line line{row.stepM, {}, std::vector<std::optional<double>>(m_scenes.size())};
            for (const jobs::GridCost& cost : study.costs) {
                if (cost.stepM == row.stepM) {
                    line.cost = cost;
                }
            }
            m_lines.push_back(std::move(line));
        }
        const auto scene = std::find(m_scenes.begin(), m_scenes.end(), row.scene);
        if (scene != m_scenes.end() && row.p95Px && std::isfinite(*row.p95Px)) { // else too much is missed
            m_lines.back().errorsPx[static_cast<std::size_t>(scene - m_scenes.begin())] = row.p95Px;
        }
    }
    endResetModel();
}

int GridStudyModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_lines.size());
}

int GridStudyModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : FirstSceneColumn + static_cast<int>(m_scenes.size());
}

std::optional<double> GridStudyModel::errorPx(const Line& line, int column) const {
    return line.errorsPx.at(static_cast<std::size_t>(column - FirstSceneColumn));
}

QString GridStudyModel::text(const Line& line, int column) const {
    switch (column) {
    case StepColumn:
        return centimetresText(line.stepM);
    case PhotosColumn:
        return line.cost ? QLocale().toString(line.cost->photos) : QString();
    case TimeColumn:
        return line.cost ? minutesText(line.cost->minutes) : QString();
    default: {
        const auto error = errorPx(line, column);
        constexpr double kLarge = 99.95; // whose tenths say nothing, and would not fit
        return error ? tr("%L1 px").arg(*error, 0, 'f', *error < kLarge ? 1 : 0) : QStringLiteral("–");
    }
    }
}

QVariant GridStudyModel::data(const QModelIndex& index, int role) const {
    const Line& line = m_lines.at(static_cast<std::size_t>(index.row()));
    const bool isError = index.column() >= FirstSceneColumn;
    const auto error = isError ? errorPx(line, index.column()) : std::nullopt;
    const bool holds = error && *error <= m_tolerancePx;
    switch (role) {
    case Qt::DisplayRole:
        return holds ? tr("✓ %1").arg(text(line, index.column())) : text(line, index.column());
    case Qt::TextAlignmentRole:
        return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
    case Qt::FontRole: {
        QFont font;
        font.setBold(holds);
        return font;
    }
    case Qt::ToolTipRole:
        return holds     ? tr("95 of 100 places are displaced by no more: within the tolerance.")
               : error   ? tr("95 of 100 places are displaced by no more: beyond the tolerance.")
               : isError ? tr("The pictures had too little in common to say.")
                         : QString();
    default:
        return {};
    }
}

QVariant GridStudyModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
    case StepColumn:
        return tr("Step");
    case PhotosColumn:
        return tr("Photos");
    case TimeColumn:
        return tr("Time");
    default:
        return sceneWord(m_scenes.at(static_cast<std::size_t>(section - FirstSceneColumn)));
    }
}

QString answerWords(const jobs::GridAnswer& answer) {
    const QString step = centimetresText(answer.stepM.value());
    const QString words = GridStudyModel::tr("%1 with %2").arg(step, sceneWord(answer.scene));
    return answer.cost ? GridStudyModel::tr("%1: %n photo(s), %2", nullptr, answer.cost->photos)
                             .arg(words, minutesText(answer.cost->minutes))
                       : words;
}

GridStudyPresenter::GridStudyPresenter(TaskList& tasks, QObject* parent)
    : SurveyPresenter(parent), m_tasks(tasks) {
}

void GridStudyPresenter::setSession(SurveySession* session) {
    m_problem.clear();
    SurveyPresenter::setSession(session);
}

QString GridStudyPresenter::obstacle() const {
    if (session() == nullptr) {
        return tr("Open a survey with a small block of photos, 5 x 5 at the finest step that you would use.");
    }
    const int photos = session()->state().counts.stationsWithPhoto;
    if (photos < kLeastPhotos) {
        return tr("This survey has %n photo(s). Take a block of 5 x 5 at the finest step that you would use "
                  "(3 x 3 at least), and ask then.",
                  nullptr, photos);
    }
    return {};
}

void GridStudyPresenter::study(const GridQuestion& question) {
    if (task() != nullptr || !obstacle().isEmpty()) {
        return;
    }
    m_problem.clear();
    m_task = m_tasks.start(
        tr("Studying the grid of %1").arg(session()->name()), this,
        [survey = session()->path(), question](ProgressSink& progress, const std::stop_token& stop) {
            return studied(survey, question, progress, stop);
        },
        [this, name = session()->name()](jobs::GridStudy found) {
            m_found = std::move(found);
            m_foundIn = name;
            emit foundChanged();
        });
    connect(m_task, &Task::ended, this, [this, task = m_task.data()] { ended(*task); });
    emit changed();
}

void GridStudyPresenter::ended(const Task& task) {
    if (task.state() == Task::State::Failed) {
        m_problem = task.sentence();
    } else if (task.state() == Task::State::Stopped) {
        m_problem = tr("Stopped. What was found is kept: the next study goes on from there.");
    }
    emit changed();
}

QString GridStudyPresenter::words() const {
    if (!m_problem.isEmpty()) {
        return m_problem;
    }
    if (!m_found) {
        return {};
    }
    return tr("%1\nFound in %2: %n photo(s), %L3 cm apart.", nullptr, static_cast<int>(m_found->photos))
        .arg(coreWords(m_found->reason), m_foundIn)
        .arg(100 * m_found->gridStepM, 0, 'f', 0);
}

GridStudyPanel::GridStudyPanel(GridStudyPresenter& presenter, QWidget* parent)
    : Section(tr("How dense?"), parent), m_presenter(presenter), m_model(new GridStudyModel(this)) {
    makeQuestion();
    makeAnswer();
    connect(&presenter, &GridStudyPresenter::changed, this, &GridStudyPanel::showState);
    connect(&presenter, &GridStudyPresenter::foundChanged, this, &GridStudyPanel::showFound);
    showState();
    showFound();
}

void GridStudyPanel::makeQuestion() {
    m_obstacle = addWords();
    m_obstacle->setObjectName("gridObstacle");
    auto* form = addForm();
    m_camera = new CameraBox(this);
    m_camera->setObjectName("gridCamera");
    connect(m_camera, &CameraBox::message, &m_presenter, &GridStudyPresenter::message);
    m_tolerance = new ToleranceBox("gridTolerance", this);
    addRow(form, tr("Robot's ca&mera"), m_camera, m_camera->toolTip());
    addRow(form, tr("T&olerance"), m_tolerance, m_tolerance->toolTip());
    m_depth = new QCheckBox(tr("With &depth (takes minutes)"), this);
    m_depth->setObjectName("gridDepth");
    m_depth->setChecked(true);
    m_depth->setToolTip(tr("Also estimate how far away every pixel is, which lets grids be much coarser"));
    form->addRow(QString(), m_depth);
    auto* row = new QHBoxLayout;
    m_study = new QPushButton(tr("Stud&y the grid"), this);
    m_study->setObjectName("gridStudy");
    m_study->setToolTip(tr("Leave photos out, render what they would show from the rest, and compare"));
    connect(m_study, &QPushButton::clicked, this, &GridStudyPanel::study);
    m_progress = new TaskBar("gridStop", tr("Stop; what was found is kept for the next run"), this);
    row->addWidget(m_study);
    row->addWidget(m_progress, 1);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void GridStudyPanel::makeAnswer() {
    m_words = addWords();
    m_words->setObjectName("gridWords");
    m_table = new QTableView(this);
    m_table->setObjectName("gridTable");
    m_table->setAccessibleName(tr("Steps that were studied"));
    m_table->setModel(m_model);
    m_table->setSelectionMode(QAbstractItemView::NoSelection);
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    layout()->addWidget(m_table);
    auto* row = new QHBoxLayout;
    m_answer = new QComboBox(this);
    m_answer->setObjectName("gridAnswer");
    m_answer->setAccessibleName(tr("Step to plan with"));
    m_answer->setToolTip(tr("The coarsest step that holds the tolerance, for each scene model"));
    m_answer->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_use = new QPushButton(tr("&Use this step"), this);
    m_use->setObjectName("gridUse");
    m_use->setToolTip(
        tr("Plan with this step; where the plan is fixed, a new survey of the same room begins with it"));
    connect(m_use, &QPushButton::clicked, this,
            [this] { emit stepChosen(m_answer->currentData().toDouble()); });
    row->addWidget(m_answer, 1);
    row->addWidget(m_use);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void GridStudyPanel::study() {
    m_presenter.study({m_camera->camera(), m_tolerance->value(), m_depth->isChecked()});
}

void GridStudyPanel::showState() {
    const QString obstacle = m_presenter.obstacle();
    Task* task = m_presenter.task();
    m_obstacle->setText(obstacle);
    m_obstacle->setVisible(!obstacle.isEmpty());
    const bool canStudy = obstacle.isEmpty() && task == nullptr;
    for (QWidget* widget : std::initializer_list<QWidget*>{m_camera, m_tolerance, m_depth, m_study}) {
        widget->setEnabled(canStudy);
    }
    m_study->setVisible(task == nullptr);
    m_progress->setTask(task);
    m_words->setText(m_presenter.words());
    m_words->setVisible(!m_words->text().isEmpty());
}

void GridStudyPanel::showFound() {
    const auto& found = m_presenter.found();
    m_answer->clear();
    if (found) {
        m_model->setStudy(*found);
        int height = m_table->horizontalHeader()->sizeHint().height() + 2 * m_table->frameWidth();
        for (int row = 0; row < m_model->rowCount(); ++row) {
            height += m_table->rowHeight(row);
        }
        m_table->setFixedHeight(height);
        for (auto answer = found->answers.rbegin(); answer != found->answers.rend(); ++answer) {
            if (answer->stepM) { // the most exact model first, which allows the coarsest grid
                m_answer->addItem(answerWords(*answer), *answer->stepM);
            }
        }
    }
    m_table->setVisible(found.has_value());
    m_answer->setVisible(m_answer->count() > 0);
    m_use->setVisible(m_answer->count() > 0);
}

} // namespace spherewalk::ui
