// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/told.h"
#include "ui/look/words.h"
#include "ui/tasks/background_worker.h"

#include "spherewalk/jobs/solution_findings.h"
#include "spherewalk/store/survey_store.h"

#include <QObject>
#include <QPointer>
#include <QString>
#include <QUndoStack>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace spherewalk::ui {

/// Returns the standing of each station's chosen photo, by station; Missing without a photo. All pages show
/// these. findings: those of the active solution. Errors: those of the store.
std::map<std::int64_t, Standing> standings(const store::SurveyStore& store,
                                           const std::optional<jobs::SolutionFindings>& findings);

/// What every page reads of a survey, in memory. The database answers late while somebody writes it.
struct SurveyState {
    survey::Room room; ///< Empty where nobody knows it.
    survey::PlanOptions options;
    std::optional<survey::CaptureProfile> profile; ///< Exposure settings; nothing: the camera stays as it is.
    survey::Plan plan;
    std::vector<store::StationRecord> stations; ///< In walking order.
    std::set<std::int64_t> missing;             ///< Ids of the stations without a photo.
    store::Counts counts;
    store::RoomOrigin roomOrigin = store::RoomOrigin::Solved; ///< Of a survey by hand.
    /// What the active solution says; nothing without one, or with one that cannot be read.
    std::optional<jobs::SolutionFindings> findings;
    std::map<std::int64_t, Standing> standings; ///< Standing of each station's photo, by station.

    /// Returns the number of stations whose photo has this standing.
    int count(Standing standing) const;
    /// Whether there is a photo of which nobody knows where it was taken.
    bool hasUnknownPlaces() const;

    /// Whether photos were taken by hand: there are some, and no rails.
    bool isByHand() const { return plan.placements.empty() && counts.photos > 0; }

    /// Whether nobody has drawn the room: it is a rectangle around what photos by hand show.
    bool isRoomSolved() const { return isByHand() && roomOrigin == store::RoomOrigin::Solved; }
};

/// Reads the state from the database. Errors: those of the store.
SurveyState readState(const store::SurveyStore& store);

/// The current station of a survey, which all of its views share.
class StationSelection : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    std::optional<std::int64_t> current() const { return m_current; }

    void setCurrent(std::optional<std::int64_t> station) {
        if (station != m_current) {
            m_current = station;
            emit currentChanged(station);
        }
    }

  signals:
    void currentChanged(std::optional<std::int64_t> station);

  private:
    std::optional<std::int64_t> m_current;
};

/// One open survey: its folder, a store for reading, and write() for changes. A change holds the writer's
/// lock only while it is made, so that the command line can capture while the window shows the survey.
/// changed() tells views what to refresh. Threads: the GUI thread; a task opens a store of its own by path().
class SurveySession : public QObject {
    Q_OBJECT

  public:
    enum Change { Plan = 1, Photos = 2, Reviews = 4, Solutions = 8, Profile = 16, Everything = 31 };
    Q_DECLARE_FLAGS(Changes, Change)

    /// Opens the survey in this folder. Errors: those of store::SurveyStore::open().
    static std::unique_ptr<SurveySession> open(const QString& folder);

    QString folder() const { return m_folder; }

    std::filesystem::path path() const { return m_store.folder(); }

    QString name() const { return m_name; }

    /// Whether another program or the disk prevented writing at the last attempt. open() and each write()
    /// try.
    bool isReadOnly() const { return m_isReadOnly; }

    /// Returns the store for reading. It can take some tens of milliseconds to answer while somebody writes.
    const store::SurveyStore& store() const { return m_store; }

    /// Returns the state that was read last.
    const SurveyState& state() const { return m_state; }

    /// Calls change(store::SurveyStore&) with a store that can write, then reads the state and emits
    /// changed(). Errors: those of the change; Busy while another program or a task writes.
    template <class Apply>
    void write(Changes what, Apply&& change) {
        {
            store::SurveyStore writer = openForWriting();
            std::forward<Apply>(change)(writer);
        }
        noteChanged(what);
    }

    /// Reads the state and emits changed(). Call it after a task or another program has written.
    void noteChanged(Changes what);
    /// Does the same in the background, for a survey that a task is still writing.
    void noteChangedSoon(Changes what);

    /// The undo stack of the survey, for decisions on photos and moves of photos.
    QUndoStack* undoStack() { return &m_undoStack; }

    StationSelection* selection() { return &m_selection; }

  signals:
    void changed(spherewalk::ui::SurveySession::Changes what);
    void readOnlyChanged(bool isReadOnly);

  private:
    SurveySession(QString folder, store::SurveyStore store, bool isReadOnly);

    store::SurveyStore openForWriting();
    void setReadOnly(bool isReadOnly);

    QString m_folder;
    store::SurveyStore m_store;
    SurveyState m_state;
    QString m_name;
    bool m_isReadOnly;
    QUndoStack m_undoStack;
    StationSelection m_selection;
    Changes m_soon;            ///< Changes that are told once the background has read.
    int m_posted = 0;          ///< Number of readings that the background was asked for.
    int m_overtaken = 0;       ///< Number of readings that are older than the state.
    BackgroundWorker m_worker; ///< The last member, as its results use the others.
};

Q_DECLARE_OPERATORS_FOR_FLAGS(SurveySession::Changes)

/// Base of the presenters of pages. It calls read() when the survey has changed. While its page is hidden, it
/// waits until the page is shown again, which keeps a window with many pages fast.
class SurveyPresenter : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    /// Null: no survey is open.
    virtual void setSession(SurveySession* session);

    SurveySession* session() const { return m_session; }

    /// Tells whether the page is visible. A new presenter takes its page as visible.
    void setShown(bool isShown);

  signals:
    /// Carries a sentence for the status line.
    void message(const Told& sentence);

  protected:
    /// Reads the survey anew. It is called for another session, for no session, and for a changed survey.
    virtual void read() = 0;

  private:
    void refresh();

    QPointer<SurveySession> m_session;
    bool m_isShown = true;
    bool m_isStale = false;
};

/// Returns base + ending, or base-2 + ending and so on: a folder that does not exist yet.
QString freeFolder(const QString& base, const QString& ending);

} // namespace spherewalk::ui
