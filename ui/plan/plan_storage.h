// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/side_panel.h"
#include "ui/plan/plan_editor.h"
#include "ui/session/survey_session.h"

#include <QPointer>
#include <QTimer>

class QLineEdit;
class QPushButton;

namespace spherewalk::ui {

/// Stores the plan of the editor in the open survey soon after the last edit, if the plan has no problem. It
/// locks the editor of a survey with photos; of photos by hand the room stays open. It holds no widget.
/// Threads: the GUI thread.
class PlanStorage : public QObject {
    Q_OBJECT

  public:
    enum class State {
        New,    ///< No survey is open; the draft is for a new one.
        Stored, ///< The survey has the plan of the draft.
        Edited, ///< The draft has edits that are not stored yet.
        Locked, ///< The survey has photos or cannot be written.
    };

    explicit PlanStorage(PlanEditor& editor, QObject* parent = nullptr);

    State state() const { return m_state; }

    /// Whether a person drew the room of photos by hand.
    bool isRoomDrawn() const {
        return m_session && m_session->state().roomOrigin == store::RoomOrigin::Drawn;
    }

    /// Whether the survey has rails. The draft of one by hand has some before the first photo.
    bool hasStoredRails() const { return m_session && !m_session->state().plan.placements.empty(); }

    /// Calls flush() and takes the plan of this survey into the editor. Null: begins a new draft.
    void setSession(SurveySession* session);
    /// Puts a rectangular room for a new survey into the editor.
    void beginNew();
    /// Makes a survey of the draft in this folder and emits created(). Errors: those of
    /// store::SurveyStore::create(); InvalidInput if the draft has no plan.
    void create(const QString& folder);
    /// Stores edits at once; problem() follows if that fails.
    void flush();

    /// Time from the last edit to storing.
    static constexpr std::chrono::milliseconds kCalm{400};

  signals:
    void stateChanged();
    void created(const QString& folder);
    /// The plan could not be stored; the sentence says why.
    void problem(const Told& sentence);

  private:
    void setState(State state);
    bool isLocked(const SurveyState& survey) const;
    /// isOther: the survey was opened just now.
    void read(bool isOther);

    PlanEditor& m_editor;
    QPointer<SurveySession> m_session;
    State m_state = State::New;
    bool m_isWriting = false;
    bool m_isReading = false;
    QTimer m_calm;
};

/// A form for the name and the place of a new survey.
class NewSurveyForm : public Section {
    Q_OBJECT

  public:
    explicit NewSurveyForm(QWidget* parent = nullptr);

    /// Fills in a name that is free in the chosen place.
    void propose();
    /// Tells whether the draft has a plan, without which no survey can be made.
    void setPossible(bool isPossible);
    /// Returns the folder of the survey: place/name.spherewalk.
    QString folder() const;

  signals:
    void createRequested(const QString& folder);

  private:
    void choosePlace();
    void showState();

    QLineEdit* m_name;
    QPushButton* m_place;
    QPushButton* m_create;
    QString m_placeFolder;
    bool m_isPossible = false;
};

/// Returns the folder for surveys of this user, which it makes if it is missing.
QString surveysPlace();

} // namespace spherewalk::ui
