// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plan/plan_draft.h"
#include "ui/tasks/background_worker.h"

#include <QObject>
#include <QUndoStack>

#include <functional>
#include <optional>
#include <string>

namespace spherewalk::ui {

/// A polygon of the room, one of its corners, a rail, one of its stops, or nothing.
struct PlanPart {
    static constexpr int kNone = -1;
    static constexpr int kOutline = 0;

    int polygon = kNone; ///< 0 is the outline; obstacles count from 1.
    int corner = kNone;
    int rail = kNone;
    int stop = kNone;

    bool operator==(const PlanPart&) const = default;
};

/// The room while it is edited. Every change can be undone, and a background thread computes the plan that
/// follows from it. It holds no widget. Threads: the GUI thread.
class PlanEditor : public QObject {
    Q_OBJECT

  public:
    explicit PlanEditor(QObject* parent = nullptr);

    /// Takes another room and empties the undo stack.
    void begin(PlanDraft draft);

    const PlanDraft& draft() const { return m_draft; }

    /// Returns the outcome that was computed last, of the draft or of preview().
    const PlanOutcome& outcome() const { return m_outcome; }

    /// Whether outcome() belongs to the present draft.
    bool isSettled() const { return m_taken == m_posted && !m_isPreview; }

    QUndoStack* undoStack() { return &m_undoStack; }

    void setLocked(bool isLocked) { m_isLocked = isLocked; }

    /// Whether all edits are ignored, because the survey has photos at the stations of the plan.
    bool isLocked() const { return m_isLocked; }

    PlanPart selected() const { return m_selected; }

    void select(PlanPart part);
    /// Returns the outline or an obstacle. Range: an index of PlanPart::polygon, except kNone.
    const Polygon& polygon(int index) const;

    /// Changes the draft as one step of undo. Successive steps of one key are joined, unless the key is 0.
    void change(const QString& text, const std::function<void(PlanDraft&)>& apply, int key = 0);
    /// Keeps the next step from being joined to the last one.
    void endRun();

    /// Range of the following calls: parts of the draft. Units: metres, room frame.
    void moveCorner(PlanPart part, const Eigen::Vector2d& to);
    void movePolygon(int polygon, const Eigen::Vector2d& by);
    /// Inserts a corner after this one and selects it.
    void insertCorner(PlanPart after, const Eigen::Vector2d& at);
    /// Removes the selected corner if the polygon keeps three corners, or else the selected obstacle.
    void removeSelected();
    void setOutline(const Polygon& outline);
    void addObstacle(const Polygon& obstacle);
    /// Writes the name of a room at this place. `at`: the name there is replaced, or removed by an empty one.
    void nameRoom(const Eigen::Vector2d& place, const std::string& name, std::optional<std::size_t> at);

    /// Returns the rails as they are shown: those of the draft, or else those of the outcome.
    const std::vector<survey::RailPlacement>& rails() const;
    /// Changes the rails as they are shown; from then on the plan is laid by hand. Without a rail, the
    /// program lays all again.
    void changeRails(const QString& text,
                     const std::function<void(std::vector<survey::RailPlacement>&)>& apply, int key = 0);
    /// Puts another rail in the place of this one, unless that is locked.
    void changeRail(const QString& text, int rail, const survey::RailPlacement& to, int key);
    /// Adds a rail and selects it.
    void addRail(const survey::RailPlacement& rail);
    /// Splits the rail before its selected stop.
    void splitSelected();
    void setSelectedLocked(bool isLocked);
    /// Keeps the locked rails, and has the program lay the rest around them.
    void layOthersAnew();

    /// Computes the outcome of another outline without a change of the draft; empty: of the draft again.
    void preview(const Polygon& outline);

  signals:
    void draftChanged();
    void selectionChanged();
    void outcomeChanged();

  private:
    class Step;

    bool isGone(const PlanPart& part) const;
    void removeSelectedRail();
    void setDraft(PlanDraft draft);
    void compute(PlanDraft draft);
    void take(int number, const PlanOutcome& outcome);

    PlanDraft m_draft;
    PlanOutcome m_outcome;
    PlanPart m_selected;
    bool m_isLocked = false;
    bool m_isPreview = false;
    QUndoStack m_undoStack;
    int m_posted = 0;          ///< Number of drafts that were posted to the worker.
    int m_taken = 0;           ///< Number of the draft that the outcome belongs to.
    BackgroundWorker m_worker; ///< The last member, as its results use the others.
};

} // namespace spherewalk::ui
