// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/plan_editor.h"

#include "spherewalk/survey/laid_rails.h"

#include <QUndoCommand>

#include <utility>

namespace spherewalk::ui {

using Eigen::Vector2d;

namespace {

enum RunKey { kNoRun = 0, kMoveCorner = 1000, kMovePolygon = 1001 };

template <class Draft>
auto& polygonOf(Draft& draft, int index) {
    return index == PlanPart::kOutline ? draft.room.outline
                                       : draft.room.obstacles[static_cast<std::size_t>(index - 1)];
}

} // namespace

/// A step of undo from one draft to another.
class PlanEditor::Step : public QUndoCommand {
  public:
    Step(PlanEditor& editor, const QString& text, PlanDraft before, PlanDraft after, int key)
        : QUndoCommand(text),
          m_editor(editor),
          m_before(std::move(before)),
          m_after(std::move(after)),
          m_key(key) {}

    void undo() override { m_editor.setDraft(m_before); }

    void redo() override { m_editor.setDraft(m_after); }

    int id() const override { return m_key == kNoRun ? -1 : m_key; }

    bool mergeWith(const QUndoCommand* other) override {
        m_after = static_cast<const Step*>(other)->m_after;
        return true;
    }

    void endRun() { m_key = kNoRun; }

  private:
    PlanEditor& m_editor;
    PlanDraft m_before;
    PlanDraft m_after;
    int m_key;
};

PlanEditor::PlanEditor(QObject* parent) : QObject(parent) {
}

void PlanEditor::begin(PlanDraft draft) {
    m_undoStack.clear();
    select({});
    setDraft(std::move(draft));
}

void PlanEditor::setDraft(PlanDraft draft) {
    m_draft = std::move(draft);
    m_isPreview = false;
    if (isGone(m_selected)) {
        select({});
    }
    compute(m_draft);
    emit draftChanged();
}

bool PlanEditor::isGone(const PlanPart& part) const {
    if (part.rail != PlanPart::kNone) { // what the program lays anew has other numbers
        const auto rail = static_cast<std::size_t>(part.rail);
        return m_draft.laysRest || rail >= m_draft.rails.size() || part.stop >= m_draft.rails[rail].stops;
    }
    return part.polygon > static_cast<int>(m_draft.room.obstacles.size()) ||
           (part.polygon >= 0 && part.corner >= static_cast<int>(polygon(part.polygon).size()));
}

void PlanEditor::compute(PlanDraft draft) {
    m_worker.post(QStringLiteral("plan"), [this, draft = std::move(draft), number = ++m_posted] {
        return [this, number, outcome = outcomeOf(draft)] { take(number, outcome); };
    });
}

void PlanEditor::take(int number, const PlanOutcome& outcome) {
    if (number != m_posted) {
        return; // a newer one is on its way
    }
    m_taken = number;
    m_outcome = outcome;
    if (m_selected.rail >= static_cast<int>(rails().size())) {
        select({}); // of an earlier plan
    }
    emit outcomeChanged();
}

void PlanEditor::select(PlanPart part) {
    if (part != m_selected) {
        m_selected = part;
        emit selectionChanged();
    }
}

const Polygon& PlanEditor::polygon(int index) const {
    return polygonOf(m_draft, index);
}

void PlanEditor::change(const QString& text, const std::function<void(PlanDraft&)>& apply, int key) {
    if (m_isLocked) {
        return;
    }
    PlanDraft after = m_draft;
    after.isRoomKnown = true; // Who changes a room takes it for one.
    apply(after);
    m_undoStack.push(new Step(*this, text, m_draft, std::move(after), key));
}

void PlanEditor::endRun() {
    if (m_undoStack.index() > 0 && !m_undoStack.canRedo()) {
        // The stack hands out its commands as const; the last one's key is this class's own business.
        auto* last = const_cast<QUndoCommand*>(m_undoStack.command(m_undoStack.index() - 1));
        static_cast<Step*>(last)->endRun();
    }
}

void PlanEditor::moveCorner(PlanPart part, const Vector2d& to) {
    change(
        tr("Move corner"),
        [&](PlanDraft& draft) { polygonOf(draft, part.polygon)[static_cast<std::size_t>(part.corner)] = to; },
        kMoveCorner);
}

void PlanEditor::movePolygon(int polygon, const Vector2d& by) {
    change(
        polygon == PlanPart::kOutline ? tr("Move outline") : tr("Move obstacle"),
        [&](PlanDraft& draft) {
            for (Vector2d& corner : polygonOf(draft, polygon)) {
                corner += by;
            }
        },
        kMovePolygon);
}

void PlanEditor::insertCorner(PlanPart after, const Vector2d& at) {
    if (m_isLocked) {
        return;
    }
    change(tr("Add corner"), [&](PlanDraft& draft) {
        Polygon& corners = polygonOf(draft, after.polygon);
        corners.insert(corners.begin() + after.corner + 1, at);
    });
    select({after.polygon, after.corner + 1});
}

void PlanEditor::removeSelected() {
    const PlanPart part = m_selected;
    if (part.rail != PlanPart::kNone) {
        return removeSelectedRail();
    }
    if (m_isLocked || part.polygon == PlanPart::kNone) {
        return;
    }
    if (part.corner != PlanPart::kNone && polygon(part.polygon).size() > 3) {
        change(tr("Remove corner"), [&](PlanDraft& draft) {
            Polygon& corners = polygonOf(draft, part.polygon);
            corners.erase(corners.begin() + part.corner);
        });
        select({part.polygon, PlanPart::kNone});
    } else if (part.polygon != PlanPart::kOutline) {
        select({});
        change(tr("Remove obstacle"), [&](PlanDraft& draft) {
            draft.room.obstacles.erase(draft.room.obstacles.begin() + part.polygon - 1);
        });
    }
}

void PlanEditor::setOutline(const Polygon& outline) {
    change(tr("Draw outline"), [&](PlanDraft& draft) {
        draft.room.outline = outline;
        std::erase_if(draft.room.names,
                      [&](const survey::RoomName& room) { return !contains(outline, room.at); });
    });
    select({PlanPart::kOutline, PlanPart::kNone});
}

void PlanEditor::addObstacle(const Polygon& obstacle) {
    if (m_isLocked) {
        return;
    }
    change(tr("Add obstacle"), [&](PlanDraft& draft) { draft.room.obstacles.push_back(obstacle); });
    select({static_cast<int>(m_draft.room.obstacles.size()), PlanPart::kNone});
}

void PlanEditor::nameRoom(const Vector2d& place, const std::string& name, std::optional<std::size_t> at) {
    change(name.empty() ? tr("Remove the room's name") : tr("Name room"), [&](PlanDraft& draft) {
        std::vector<survey::RoomName>& names = draft.room.names;
        if (at && name.empty()) {
            names.erase(names.begin() + static_cast<std::ptrdiff_t>(*at));
        } else if (at) {
            names[*at].name = name;
        } else if (!name.empty()) {
            names.push_back({name, place});
        }
    });
}

const std::vector<survey::RailPlacement>& PlanEditor::rails() const {
    return m_draft.rails.empty() || m_draft.laysRest ? m_outcome.plan.placements : m_draft.rails;
}

void PlanEditor::changeRails(const QString& text,
                             const std::function<void(std::vector<survey::RailPlacement>&)>& apply, int key) {
    std::vector<survey::RailPlacement> changed = rails();
    apply(changed);
    change(
        text,
        [&](PlanDraft& draft) {
            draft.rails = changed;
            draft.laysRest = false;
        },
        key);
}

void PlanEditor::changeRail(const QString& text, int rail, const survey::RailPlacement& to, int key) {
    const auto index = static_cast<std::size_t>(rail);
    if (index < rails().size() && !rails()[index].isLocked) {
        changeRails(
            text, [&](std::vector<survey::RailPlacement>& all) { all[index] = to; }, key);
    }
}

void PlanEditor::addRail(const survey::RailPlacement& rail) {
    if (!m_isLocked) {
        changeRails(tr("Lay rail"), [&](std::vector<survey::RailPlacement>& all) { all.push_back(rail); });
        select({.rail = static_cast<int>(m_draft.rails.size()) - 1});
    }
}

void PlanEditor::splitSelected() {
    const auto rail = static_cast<std::size_t>(m_selected.rail);
    const int stop = m_selected.stop;
    if (m_selected.rail == PlanPart::kNone || stop <= 0 || rails()[rail].isLocked) {
        return;
    }
    changeRails(tr("Split rail"), [&](std::vector<survey::RailPlacement>& all) {
        const std::vector<survey::RailPlacement> parts = survey::split(all[rail], stop);
        all[rail] = parts[0];
        all.insert(all.begin() + m_selected.rail + 1, parts[1]);
    });
    select({.rail = m_selected.rail + 1});
}

void PlanEditor::removeSelectedRail() {
    const auto [rail, stop] = std::pair(static_cast<std::size_t>(m_selected.rail), m_selected.stop);
    if (m_isLocked || rails()[rail].isLocked) {
        return;
    }
    const bool isWhole = stop == PlanPart::kNone;
    const std::vector<survey::RailPlacement> left =
        isWhole ? std::vector<survey::RailPlacement>() : survey::withoutStop(rails()[rail], stop);
    const auto at = m_selected.rail;
    select({});
    changeRails(isWhole ? tr("Remove rail") : tr("Remove stop"),
                [&](std::vector<survey::RailPlacement>& all) {
                    all.erase(all.begin() + at);
                    all.insert(all.begin() + at, left.begin(), left.end());
                });
}

void PlanEditor::setSelectedLocked(bool isLocked) {
    if (m_selected.rail != PlanPart::kNone) {
        changeRails(isLocked ? tr("Lock rail") : tr("Unlock rail"),
                    [&](std::vector<survey::RailPlacement>& all) {
                        all[static_cast<std::size_t>(m_selected.rail)].isLocked = isLocked;
                    });
    }
}

void PlanEditor::layOthersAnew() {
    select({});
    change(tr("Lay rails anew"), [&](PlanDraft& draft) {
        draft.rails = rails();
        keepLocked(draft);
    });
}

void PlanEditor::preview(const Polygon& outline) {
    PlanDraft shown = m_draft;
    m_isPreview = !outline.empty();
    if (m_isPreview) {
        shown.room.outline = outline;
    }
    compute(std::move(shown));
}

} // namespace spherewalk::ui
