// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plan/plan_editor.h"
#include "ui/session/survey_session.h"

#include <QPointer>
#include <QTimer>

namespace spherewalk::ui {

/// Keeps the open survey as the editor has it: a plan that can be stored is stored soon after the last edit,
/// as `spherewalk-cli new` would. Once photos stand on a plan it is locked. It holds no widget.
class PlanStorage : public QObject {
    Q_OBJECT

  public:
    enum class State {
        New,    ///< no survey is open; the draft is of one to come
        Stored, ///< the survey is as the draft
        Edited, ///< it is not yet
        Locked, ///< there are photos
    };

    explicit PlanStorage(PlanEditor& editor, QObject* parent = nullptr);

    State state() const { return m_state; }

    /// Stores what is still to be stored, and takes the session's plan into the editor. Null: a new draft.
    void setSession(SurveySession* session);
    /// Begins a new survey with a rectangle.
    void beginNew();
    /// Makes a survey of the draft. Errors: those of store::SurveyStore::create(); InvalidInput if there is
    /// no plan yet.
    void create(const QString& folder);
    /// Stores at once.
    void flush();

    /// How long after the last edit a plan is stored.
    static constexpr std::chrono::milliseconds kCalm{400};

  signals:
    void stateChanged();
    void created(const QString& folder);
    /// Why something could not be stored.
    void problem(const QString& sentence);

  private:
    void setState(State state);
    void read();

    PlanEditor& m_editor;
    QPointer<SurveySession> m_session;
    State m_state = State::New;
    bool m_isWriting = false;
    bool m_isReading = false;
    QTimer m_calm;
};

} // namespace spherewalk::ui
