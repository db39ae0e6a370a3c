// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/station_selection.h"
#include "ui/session/survey_state.h"
#include "ui/tasks/background_worker.h"

#include <QObject>
#include <QString>
#include <QUndoStack>

#include <filesystem>
#include <memory>
#include <utility>

namespace spherewalk::ui {

/// One open survey: where it is, a store for reading, and the way to write. Nobody holds the writer's lock
/// for longer than a change takes, except a task that writes; so the command line can capture while the
/// window looks on. Views refresh by what changed. Threads: the GUI thread; a task opens a store of its own
/// by path().
class SurveySession : public QObject {
    Q_OBJECT

  public:
    enum Change { Plan = 1, Photos = 2, Reviews = 4, Solutions = 8, Profile = 16, Everything = 31 };
    Q_DECLARE_FLAGS(Changes, Change)

    /// Errors: those of store::SurveyStore::open().
    static std::unique_ptr<SurveySession> open(const QString& folder);

    QString folder() const { return m_folder; }

    std::filesystem::path path() const { return m_store.folder(); }

    QString name() const { return m_name; }

    /// Whether another program wrote the survey, or the disk allowed no writing, when it was last looked at:
    /// on opening and at each write().
    bool isReadOnly() const { return m_isReadOnly; }

    /// For reading. While somebody writes, it can take some tens of milliseconds to answer.
    const store::SurveyStore& store() const { return m_store; }

    /// As it was read last.
    const SurveyState& state() const { return m_state; }

    /// Calls change(store::SurveyStore&) with a store that may write, and tells what changed. Errors: those
    /// of the change; Busy if another program, or a task of this one, writes.
    template <class Apply>
    void write(Changes what, Apply&& change) {
        {
            store::SurveyStore writer = openForWriting();
            std::forward<Apply>(change)(writer);
        }
        noteChanged(what);
    }

    /// To be called after somebody else wrote, a task or another program: reads, and tells what changed.
    void noteChanged(Changes what);
    /// The same while somebody writes on: reads in the background, and tells later.
    void noteChangedSoon(Changes what);

    /// Of edits that are not, or not only, in the store.
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
    Changes m_soon;            ///< to be told once the background has read
    int m_posted = 0;          ///< how often the background was asked to
    int m_overtaken = 0;       ///< so many of those readings are older than the state
    BackgroundWorker m_worker; ///< last: what it delivers uses the rest
};

Q_DECLARE_OPERATORS_FOR_FLAGS(SurveySession::Changes)

} // namespace spherewalk::ui
