// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/frame/mode.h"
#include "ui/plan/grid_study.h"
#include "ui/plan/plan_editor.h"
#include "ui/plan/plan_editor_view.h"
#include "ui/plan/plan_storage.h"
#include "ui/tasks/task.h"

#include <optional>

class QAction;
class QActionGroup;
class QDoubleSpinBox;
class QLabel;
class QToolBar;

namespace spherewalk::ui {

class NewSurveyForm;

/// The page that draws a room and lays out its stations.
class PlanMode : public Mode {
    Q_OBJECT

  public:
    explicit PlanMode(TaskList& tasks, QWidget* parent = nullptr);

    void setSession(SurveySession* session) override;

    QUndoStack* undoStack() override { return m_editor.undoStack(); }

    bool worksWithoutSurvey() const override { return true; }

    /// Lays the picture of this name under the drawing.
    void showPart(const QString& part) override;

    PlanEditor& editor() { return m_editor; }

    PlanStorage& storage() { return m_storage; }

    PlanEditorView& view() { return *m_view; }

    GridStudyPresenter& study() { return m_study; }

    /// Plans with this step, as one step of undo. A locked plan stays, and a new survey of this room begins.
    /// Units: metres.
    void useStep(double stepM);

    /// Lays a picture, the first page of a PDF or a robot's map under the drawing. message() says why not.
    void layPicture(const QString& file);

    /// Writes the marking-out sheet in a task.
    void writeSheet(const QString& file);

  private:
    QToolBar* makeToolBar();
    void addTool(QToolBar* bar, PlanEditorView::Tool tool, const QString& iconName, const QString& text,
                 const QString& hint, const QKeySequence& key);
    QWidget* makeScaleForm();
    QWidget* makeLocked();
    void beginWithThisRoom();
    void choosePicture();
    void removePicture();
    void askName(const QPointF& inRoom, std::optional<std::size_t> name);
    void askLength(const QLineF& inRoom);
    void applyLength();
    void chooseSheet();
    void create(const QString& folder);
    void showState();
    QString storedWords() const;
    void keepPicture() const;

    TaskList& m_tasks;
    PlanEditor m_editor;
    PlanStorage m_storage;
    GridStudyPresenter m_study;
    PlanEditorView* m_view;
    NewSurveyForm* m_form = nullptr;
    QWidget* m_locked = nullptr;
    QLabel* m_lockedWords = nullptr;
    QLabel* m_stored = nullptr;
    QLabel* m_hint = nullptr;
    QWidget* m_scaleForm = nullptr;
    QDoubleSpinBox* m_length = nullptr;
    QLineF m_scaleLine;
    QActionGroup* m_tools = nullptr;
    QList<QAction*> m_edits; ///< Disabled while the plan is locked.
    QAction* m_sheet = nullptr;
    QString m_surveyId;
    QString m_surveyName;
    std::optional<PlanDraft> m_nextDraft; ///< Room of the next new survey.
    std::optional<double> m_nextStepM;    ///< Step of the next new survey.
};

} // namespace spherewalk::ui
