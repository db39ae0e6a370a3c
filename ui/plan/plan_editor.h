// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plan/plan_draft.h"
#include "ui/tasks/background_worker.h"

#include <QObject>
#include <QUndoStack>

#include <functional>

namespace spherewalk::ui {

/// A polygon of the room, or one of its corners.
struct PlanPart {
    static constexpr int kNone = -1;
    static constexpr int kOutline = 0;

    int polygon = kNone; ///< 0: the outline; from 1: the obstacles
    int corner = kNone;

    bool operator==(const PlanPart&) const = default;
};

/// The room while it is edited: every change can be undone, and is followed by the plan that it leads to,
/// computed in the background. It holds no widget.
class PlanEditor : public QObject {
    Q_OBJECT

  public:
    explicit PlanEditor(QObject* parent = nullptr);

    /// Another room; forgets what could be undone.
    void begin(PlanDraft draft);

    const PlanDraft& draft() const { return m_draft; }

    /// Of the draft, or of what is being drawn, as of the last outcomeChanged().
    const PlanOutcome& outcome() const { return m_outcome; }

    /// Whether the outcome is the present draft's.
    bool isSettled() const { return m_taken == m_posted && !m_isPreview; }

    QUndoStack* undoStack() { return &m_undoStack; }

    void setLocked(bool isLocked) { m_isLocked = isLocked; }

    /// Locked: photos stand on the plan, which cannot change any more. All edits are then ignored.
    bool isLocked() const { return m_isLocked; }

    PlanPart selected() const { return m_selected; }

    void select(PlanPart part);
    /// Range: a part of the draft, not none.
    const Polygon& polygon(int index) const;

    /// Changes the draft as one step of undo. Steps with the same key, one after the other, become one; key 0
    /// never does.
    void change(const QString& text, const std::function<void(PlanDraft&)>& apply, int key = 0);
    /// Ends a run of steps that become one.
    void endRun();

    void moveCorner(PlanPart part, const Eigen::Vector2d& to);
    void movePolygon(int polygon, const Eigen::Vector2d& by);
    /// After the corner; selects the new one.
    void insertCorner(PlanPart after, const Eigen::Vector2d& at);
    /// The selected corner, while the polygon keeps three; else the selected obstacle.
    void removeSelected();
    void setOutline(const Polygon& outline);
    void addObstacle(const Polygon& obstacle);

    /// Shows what the room would come to with this outline, without changing the draft; empty: ends that.
    void preview(const Polygon& outline);

  signals:
    void draftChanged();
    void selectionChanged();
    void outcomeChanged();

  private:
    class Step;

    void setDraft(PlanDraft draft);
    void compute(PlanDraft draft);
    void take(int number, const PlanOutcome& outcome);

    PlanDraft m_draft;
    PlanOutcome m_outcome;
    PlanPart m_selected;
    bool m_isLocked = false;
    bool m_isPreview = false;
    QUndoStack m_undoStack;
    int m_posted = 0;          ///< how many drafts were to be computed
    int m_taken = 0;           ///< which of them the outcome is of
    BackgroundWorker m_worker; ///< last: what it delivers uses the rest
};

} // namespace spherewalk::ui
