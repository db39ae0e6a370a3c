// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/grid_study_panel.h"

#include "ui/plan/grid_study_model.h"
#include "ui/plan/grid_study_presenter.h"
#include "ui/preview/camera_box.h"
#include "ui/preview/tolerance_box.h"
#include "ui/tasks/task_bar.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableView>

namespace spherewalk::ui {

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
    m_study = new QPushButton(tr("Study the &grid"), this);
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
