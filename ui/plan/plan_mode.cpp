// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/plan_mode.h"

#include "ui/look/core_words.h"
#include "ui/look/icon.h"
#include "ui/look/side_panel.h"
#include "ui/plan/grid_study.h"
#include "ui/plan/plan_draft.h"
#include "ui/plan/plan_panel.h"
#include "ui/plan/plan_storage.h"
#include "ui/plan/rail_panel.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"

#include <QActionGroup>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSplitter>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <utility>

namespace spherewalk::ui {

PlanMode::PlanMode(TaskList& tasks, QWidget* parent)
    : Mode("plan", tr("Plan"), tr("Draw the room and lay out where photos are to be taken"), parent),
      m_tasks(tasks),
      m_storage(m_editor),
      m_study(tasks),
      m_view(new PlanEditorView(m_editor, this)) {
    auto* side = new QWidget(this);
    auto* sideLayout = new QVBoxLayout(side);
    sideLayout->setContentsMargins(6, 6, 6, 6);
    m_form = new NewSurveyForm(this);
    m_locked = makeLocked();
    m_stored = new QLabel(this);
    m_stored->setObjectName("planStored");
    m_stored->setWordWrap(true);
    sideLayout->addWidget(m_locked);
    sideLayout->addWidget(new RailPanel(m_editor, side));
    sideLayout->addWidget(new PlanPanel(m_editor, side), 1);
    auto* study = new GridStudyPanel(m_study, side);
    sideLayout->addWidget(study);
    auto* scroll = new ColumnScrollArea(side, this);
    auto* column = new QWidget(this); // what ends the work stays in sight below
    auto* columnLayout = new QVBoxLayout(column);
    columnLayout->setContentsMargins(0, 0, 0, 0);
    columnLayout->addWidget(scroll, 1);
    columnLayout->addWidget(m_form);
    columnLayout->addWidget(m_stored);
    m_form->setContentsMargins(6, 0, 6, 6);
    m_stored->setContentsMargins(10, 0, 6, 6);
    m_hint = new QLabel(this);
    m_hint->setObjectName("planHint");
    m_hint->setWordWrap(true);
    m_hint->setContentsMargins(8, 2, 8, 4);
    auto* drawing = new QWidget(this);
    auto* drawingLayout = new QVBoxLayout(drawing);
    drawingLayout->setContentsMargins(0, 0, 0, 0);
    drawingLayout->setSpacing(0);
    drawingLayout->addWidget(makeToolBar());
    drawingLayout->addWidget(m_view, 1);
    drawingLayout->addWidget(makeScaleForm());
    drawingLayout->addWidget(m_hint);
    auto* splitter = new QSplitter(this);
    splitter->addWidget(drawing);
    splitter->addWidget(column);
    splitter->setStretchFactor(0, 1);
    splitter->setChildrenCollapsible(false);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(splitter);
    connect(m_form, &NewSurveyForm::createRequested, this, &PlanMode::create);
    connect(m_view, &PlanEditorView::hint, m_hint, &QLabel::setText);
    connect(m_view, &PlanEditorView::scaleDrawn, this, &PlanMode::askLength);
    connect(m_view, &PlanEditorView::pictureMoved, this, &PlanMode::keepPicture);
    connect(m_view, &PlanEditorView::nameWanted, this, &PlanMode::askName);
    connect(&m_storage, &PlanStorage::stateChanged, this, &PlanMode::showState);
    connect(&m_storage, &PlanStorage::problem, this, &Mode::message);
    connect(study, &GridStudyPanel::stepChosen, this, &PlanMode::useStep);
    connect(&m_study, &GridStudyPresenter::message, this, &Mode::message);
    connect(&m_storage, &PlanStorage::created, this, &Mode::openRequested);
    connect(&m_editor, &PlanEditor::outcomeChanged, this, &PlanMode::showState);
    connect(m_editor.undoStack(), &QUndoStack::cleanChanged, m_view, qOverload<>(&QWidget::update));
    m_form->propose();
    m_storage.beginNew();
    m_view->fitRoom();
    showState();
}

void PlanMode::addTool(QToolBar* bar, PlanEditorView::Tool tool, const QString& iconName, const QString& text,
                       const QString& hint, const QKeySequence& key) {
    QAction* action = bar->addAction(ui::icon(iconName), text);
    action->setCheckable(true);
    action->setShortcut(key);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    action->setToolTip(tr("%1 (%2)").arg(hint, key.toString(QKeySequence::NativeText)));
    action->setData(static_cast<int>(tool));
    addAction(action);
    m_tools->addAction(action);
    connect(action, &QAction::triggered, this, [this, tool] {
        m_view->setTool(tool);
        m_view->setFocus();
    });
}

QToolBar* PlanMode::makeToolBar() {
    auto* bar = new QToolBar(tr("Drawing"), this);
    bar->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    bar->setIconSize({20, 20});
    m_tools = new QActionGroup(this);
    using Tool = PlanEditorView::Tool;
    addTool(bar, Tool::Select, "select", tr("Move"), tr("Move corners and obstacles"), Qt::Key_V);
    addTool(bar, Tool::Outline, "outline", tr("Outline"), tr("Draw the outline of the room anew"), Qt::Key_O);
    addTool(bar, Tool::Obstacle, "obstacle", tr("Obstacle"), tr("Draw something that stands on the floor"),
            Qt::Key_B);
    addTool(bar, Tool::Name, "name", tr("Name"), tr("Name the rooms of a flat"), Qt::Key_N);
    addTool(bar, Tool::Rails, "rails", tr("Rails"), tr("Move, turn, lengthen, add and remove rails by hand"),
            Qt::Key_R);
    addTool(bar, Tool::Scale, "ruler", tr("Scale"), tr("Draw a known length on the picture"), Qt::Key_S);
    addTool(bar, Tool::Place, "place", tr("Place"),
            tr("Move, turn and scale the picture by two of its corners"), Qt::Key_P);
    connect(m_view, &PlanEditorView::toolChanged, this, [this](Tool tool) {
        for (QAction* action : m_tools->actions()) {
            action->setChecked(action->data().toInt() == static_cast<int>(tool));
        }
    });
    m_tools->actions().constFirst()->setChecked(true);
    const auto addAction = [&](const QString& iconName, const QString& text, const QString& hint, auto slot) {
        QAction* action = bar->addAction(ui::icon(iconName), text, this, slot);
        action->setToolTip(hint);
        return action;
    };
    m_edits << m_tools->actions().mid(1, 4);
    m_edits << addAction("delete", tr("Remove"),
                         tr("Remove the selected corner, obstacle, stop or rail (Delete)"),
                         [this] { m_editor.removeSelected(); });
    bar->addSeparator();
    QAction* undo = m_editor.undoStack()->createUndoAction(this, tr("Undo"));
    undo->setIcon(ui::icon("undo"));
    undo->setIconText(tr("Undo"));
    QAction* redo = m_editor.undoStack()->createRedoAction(this, tr("Redo"));
    redo->setIcon(ui::icon("redo"));
    redo->setIconText(tr("Redo"));
    bar->addActions({undo, redo});
    bar->addSeparator();
    addAction("fit", tr("Fit"), tr("Bring the whole room into sight (0)"), [this] { m_view->fitRoom(); });
    addAction("picture", tr("Picture"), tr("Lay a floor plan under the drawing, or take it away"),
              [this] { m_view->picture().isEmpty() ? choosePicture() : removePicture(); });
    m_sheet = addAction("sheet", tr("Sheet"),
                        tr("Write the marking-out sheet: the plan to scale with tape distances, as PDF"),
                        [this] { chooseSheet(); });
    if (auto* more = bar->findChild<QToolButton*>("qt_toolbar_ext_button")) {
        more->setIcon(ui::icon("more")); // Qt's own is not seen in the dark
    }
    return bar;
}

QWidget* PlanMode::makeScaleForm() {
    m_scaleForm = new QWidget(this);
    auto* row = new QHBoxLayout(m_scaleForm);
    row->addWidget(new QLabel(tr("The line is this long:"), m_scaleForm));
    m_length = new QDoubleSpinBox(m_scaleForm);
    m_length->setObjectName("scaleLength");
    m_length->setAccessibleName(tr("Length of the line"));
    m_length->setRange(0.01, 2000);
    m_length->setSuffix(" " + tr("m"));
    row->addWidget(m_length);
    auto* apply = new QPushButton(tr("Set the scale"), m_scaleForm);
    apply->setObjectName("setScale");
    row->addWidget(apply);
    row->addStretch();
    connect(apply, &QPushButton::clicked, this, &PlanMode::applyLength);
    connect(m_length->findChild<QLineEdit*>(), &QLineEdit::returnPressed, this, &PlanMode::applyLength);
    m_scaleForm->hide();
    return m_scaleForm;
}

QWidget* PlanMode::makeLocked() {
    auto* section = new Section(tr("The plan is fixed"), this);
    m_lockedWords = section->addWords();
    auto* begin = new QPushButton(ui::icon("new"), tr("New survey with this room"), section);
    begin->setObjectName("newWithThisRoom");
    section->layout()->addWidget(begin);
    connect(begin, &QPushButton::clicked, this, &PlanMode::beginWithThisRoom);
    return section;
}

void PlanMode::beginWithThisRoom() {
    m_nextDraft = m_editor.draft();
    m_nextDraft->hasRails = true;
    m_nextDraft->byHand.clear();
    m_nextDraft->isRoomKnown = true;
    emit newRequested();
}

void PlanMode::useStep(double stepM) {
    if (m_editor.isLocked() || !m_editor.draft().hasRails) {
        m_nextStepM = stepM;
        return beginWithThisRoom();
    }
    m_editor.change(tr("Use step"), [&](PlanDraft& draft) {
        changeStep(draft, stepM);
        keepLocked(draft);
    });
}

void PlanMode::setSession(SurveySession* session) {
    keepPicture();
    m_storage.setSession(session);
    m_study.setSession(session);
    m_surveyId = session != nullptr ? QString::fromStdString(session->store().info().uuid) : QString();
    m_surveyName = session != nullptr ? session->name() : QString();
    if (session != nullptr) {
        m_view->picture() = FloorPicture::kept(m_surveyId);
    } else {
        m_view->picture().clear();
        m_form->propose();
        if (m_nextDraft) {
            m_editor.begin(*std::exchange(m_nextDraft, std::nullopt));
            if (m_nextStepM) {
                useStep(*std::exchange(m_nextStepM, std::nullopt));
            }
        }
    }
    m_view->fitRoom();
    showState();
}

void PlanMode::keepPicture() const {
    if (!m_surveyId.isEmpty()) {
        m_view->picture().keep(m_surveyId);
    }
}

void PlanMode::showState() {
    using State = PlanStorage::State;
    const State state = m_storage.state();
    m_form->setVisible(state == State::New);
    m_form->setPossible(m_editor.outcome().problem.isEmpty());
    m_locked->setVisible(state == State::Locked);
    m_lockedWords->setText(m_editor.draft().hasRails || !m_editor.draft().byHand.empty()
                               ? tr("Photos stand on this plan, or another program writes the survey.")
                               : tr("Nobody knows where the photos stand. Align finds that out from the "
                                    "pictures alone; then their room can be drawn."));
    m_sheet->setEnabled(m_editor.draft().isRoomKnown);
    m_stored->setVisible(state == State::Stored || state == State::Edited);
    m_stored->setText(storedWords());
    using Tool = PlanEditorView::Tool;
    for (QAction* action : std::as_const(m_edits)) {
        const bool isOfRails = action->data() == static_cast<int>(Tool::Rails);
        action->setEnabled(state != State::Locked && (m_editor.draft().hasRails || !isOfRails));
    }
    if (state == State::Locked && m_view->tool() != Tool::Scale && m_view->tool() != Tool::Place) {
        m_view->setTool(Tool::Select); // its sentence, too
    }
}

QString PlanMode::storedWords() const {
    if (m_storage.state() != PlanStorage::State::Stored) {
        return tr("Storing...");
    }
    if (m_editor.draft().hasRails) {
        return m_storage.hasStoredRails()
                   ? tr("Stored.")
                   : tr("These rails are a proposal: nothing of it is stored before you change something.");
    }
    if (!m_editor.draft().isRoomKnown) {
        return tr("Nobody has drawn this room: the rectangle is only to begin with. Draw it as it is; "
                  "without that, an export with depth finds it in the photos.");
    }
    return m_storage.isRoomDrawn()
               ? tr("Stored. Align keeps the room as you drew it.")
               : tr("The room is what the photos show. If you draw it as it is, Align keeps it so.");
}

void PlanMode::create(const QString& folder) {
    try {
        const FloorPicture picture = m_view->picture();
        m_storage.create(folder); // opens it
        if (!picture.isEmpty()) {
            m_view->picture() = picture;
            keepPicture();
        }
    } catch (const Error& error) {
        emit message(coreTold(error.sentence()));
    }
}

void PlanMode::choosePicture() {
    const QString file = QFileDialog::getOpenFileName(
        this, tr("Floor plan"), {},
        tr("Pictures and maps (*.png *.jpg *.jpeg *.svg *.bmp *.pgm *.pdf *.yaml *.yml)"));
    if (!file.isEmpty()) {
        layPicture(file);
    }
}

void PlanMode::showPart(const QString& part) {
    if (!part.isEmpty()) {
        layPicture(part);
    }
}

void PlanMode::layPicture(const QString& file) {
    try {
        m_view->picture().load(file);
        keepPicture();
        const bool isMap = file.endsWith("yaml") || file.endsWith("yml"); // it knows its scale
        m_view->setTool(isMap ? PlanEditorView::Tool::Select : PlanEditorView::Tool::Scale);
        m_view->fitRoom();
    } catch (const Error& error) {
        emit message(coreTold(error.sentence()));
    }
}

void PlanMode::removePicture() {
    m_view->picture().clear();
    keepPicture();
    m_view->fitRoom();
}

/// Asks what the room at this place is called. An empty name removes the one that is there.
void PlanMode::askName(const QPointF& inRoom, std::optional<std::size_t> name) {
    const std::vector<survey::RoomName>& names = m_editor.draft().room.names;
    const QString before = name ? QString::fromStdString(names[*name].name) : QString();
    bool isGiven = false;
    const QString now = QInputDialog::getText(this, tr("Name of the room"), tr("What is this room called?"),
                                              QLineEdit::Normal, before, &isGiven)
                            .trimmed();
    if (isGiven && now != before) {
        m_editor.nameRoom({inRoom.x(), inRoom.y()}, now.toStdString(), name);
    }
}

void PlanMode::askLength(const QLineF& inRoom) {
    m_scaleLine = inRoom;
    m_length->setValue(inRoom.length());
    m_scaleForm->show();
    m_length->setFocus();
    m_length->selectAll();
}

void PlanMode::applyLength() {
    if (!m_view->picture().isEmpty()) {
        m_view->picture().setLength(m_scaleLine, m_length->value());
        keepPicture();
    } else {
        emit message(tr("There is no picture to scale; choose one first."));
    }
    m_scaleForm->hide();
    m_view->setTool(PlanEditorView::Tool::Select);
    m_view->fitRoom();
}

void PlanMode::chooseSheet() {
    const QString file =
        QFileDialog::getSaveFileName(this, tr("Marking-out sheet"), tr("marking-out.pdf"), tr("PDF (*.pdf)"));
    if (!file.isEmpty()) {
        writeSheet(file);
    }
}

void PlanMode::writeSheet(const QString& file) {
    const QString name =
        m_surveyName.isEmpty() ? QFileInfo(m_form->folder()).completeBaseName() : m_surveyName;
    m_tasks.start(
        tr("Marking-out sheet"), this,
        [file, name = name.toStdString(), draft = m_editor.draft(),
         words = sheetWords()](ProgressSink& /*progress*/, const std::stop_token& /*stop*/) {
            writeFile(file.toStdString(),
                      report::markingSheet(name, draft.room, draft.options, planOf(draft), words));
        },
        [this, file] { emit message(tr("Wrote %1.").arg(file)); });
}

} // namespace spherewalk::ui
