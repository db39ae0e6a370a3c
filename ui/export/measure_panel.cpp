// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/measure_panel.h"

#include "ui/export/measure_presenter.h"
#include "ui/preview/camera_box.h"
#include "ui/preview/tolerance_box.h"
#include "ui/tasks/task_bar.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace spherewalk::ui {

MeasurePanel::MeasurePanel(MeasurePresenter& presenter, QWidget* parent)
    : QGroupBox(tr("How right its views are"), parent), m_presenter(presenter) {
    auto* layout = new QVBoxLayout(this);
    makeQuestion();
    m_words = new QLabel(this);
    m_words->setObjectName("measureWords");
    m_words->setWordWrap(true);
    m_words->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_open = new QPushButton(tr("Open &report"), this);
    m_open->setObjectName("openReport");
    m_open->setToolTip(tr("The page with error maps and trade-offs; the same as PDF lies beside it"));
    connect(m_open, &QPushButton::clicked, this, [this] { emit openRequested(m_presenter.page()); });
    auto* row = new QHBoxLayout;
    row->addWidget(m_words, 1);
    row->addWidget(m_open, 0, Qt::AlignTop);
    layout->addLayout(row);
    connect(&presenter, &MeasurePresenter::changed, this, &MeasurePanel::showAll);
    showAll();
}

void MeasurePanel::makeQuestion() {
    m_camera = new CameraBox(this);
    m_camera->setObjectName("measureCamera");
    connect(m_camera, &CameraBox::message, this, &MeasurePanel::message);
    m_tolerance = new ToleranceBox("measureTolerance", this);
    m_measure = new QPushButton(tr("&Measure"), this);
    m_measure->setObjectName("measureNow");
    m_measure->setToolTip(tr("Leave photos out, render what they would show from the rest, and compare"));
    connect(m_measure, &QPushButton::clicked, this,
            [this] { m_presenter.measure(m_camera->camera(), m_tolerance->value()); });
    m_progress = new TaskBar("stopMeasuring", tr("Stop; what was found is kept for the next run"), this);
    auto* asked = new QHBoxLayout;
    asked->addWidget(new QLabel(tr("Robot's camera"), this));
    asked->addWidget(m_camera, 1);
    asked->addWidget(new QLabel(tr("Tolerance"), this));
    asked->addWidget(m_tolerance);
    auto* row = new QHBoxLayout;
    row->addWidget(m_measure);
    row->addWidget(m_progress, 1);
    row->addStretch(0);
    static_cast<QVBoxLayout*>(layout())->addLayout(asked);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void MeasurePanel::showAll() {
    Task* task = m_presenter.task();
    const bool isNone = m_presenter.dataset().isEmpty();
    for (QWidget* widget : std::initializer_list<QWidget*>{m_camera, m_tolerance, m_measure}) {
        widget->setEnabled(m_presenter.canMeasure());
    }
    m_progress->setTask(task);
    m_words->setText(isNone ? tr("Export a dataset first, or name the folder of one that is there.")
                            : m_presenter.words());
    m_words->setVisible(!m_words->text().isEmpty());
    m_open->setVisible(task == nullptr && !m_presenter.page().isEmpty());
}

} // namespace spherewalk::ui
