// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/align/align_presenter.h"

#include "spherewalk/base/error.h"

#include <QUndoCommand>

#include <algorithm>
#include <map>

namespace spherewalk::ui {

/// A move that was made already when it is pushed.
class RetagCommand : public QUndoCommand {
  public:
    RetagCommand(AlignPresenter& presenter, std::vector<jobs::PhotoPlace> before,
                 std::vector<jobs::PhotoPlace> after)
        : QUndoCommand(AlignPresenter::tr("Move %n photo(s) to other stations", nullptr,
                                          static_cast<int>(after.size()))),
          m_presenter(&presenter),
          m_before(std::move(before)),
          m_after(std::move(after)) {}

    void undo() override { move(m_before); }

    void redo() override {
        if (m_isMade) {
            m_isMade = false;
            return;
        }
        move(m_after);
    }

  private:
    /// If it cannot be done, what the stack says would no longer be true.
    void move(const std::vector<jobs::PhotoPlace>& places) {
        if (!m_presenter || !m_presenter->m_session) {
            return;
        }
        QUndoStack* stack = m_presenter->m_session->undoStack();
        Task* task = m_presenter->move(places, [](const std::vector<jobs::PhotoPlace>&) {});
        if (task == nullptr) {
            QMetaObject::invokeMethod(stack, &QUndoStack::clear, Qt::QueuedConnection);
            return;
        }
        QObject::connect(task, &Task::ended, stack, [task, stack] {
            if (task->state() != Task::State::Done) {
                stack->clear();
            }
        });
    }

    QPointer<AlignPresenter> m_presenter;
    std::vector<jobs::PhotoPlace> m_before;
    std::vector<jobs::PhotoPlace> m_after;
    bool m_isMade = true;
};

AlignPresenter::AlignPresenter(TaskList& tasks, QObject* parent)
    : QObject(parent), m_tasks(tasks), m_table(m_model) {
    connect(&m_reviewer, &PhotoReviewer::refused, this, &AlignPresenter::message);
}

void AlignPresenter::setSession(SurveySession* session) {
    if (m_session) {
        m_session->disconnect(this);
    }
    m_session = session;
    m_reviewer.setSession(session);
    if (session != nullptr) {
        connect(session, &SurveySession::changed, this, &AlignPresenter::refresh);
    }
    read();
}

void AlignPresenter::setShown(bool isShown) {
    m_isShown = isShown;
    if (isShown && m_isStale) {
        read();
    }
}

void AlignPresenter::refresh() {
    m_isStale = true;
    if (m_isShown) {
        read();
    }
}

void AlignPresenter::read() {
    m_isStale = false;
    try {
        m_findings = m_session ? jobs::activeFindings(m_session->store()) : std::nullopt;
    } catch (const Error& error) {
        m_findings.reset();
        emit message(QString::fromStdString(error.sentence()));
    }
    m_model.setPhotos(m_findings ? m_findings->photos : std::vector<jobs::PhotoFinding>());
    emit findingsChanged();
}

QString AlignPresenter::summary() const {
    if (!m_session) {
        return {};
    }
    if (!m_findings) {
        return tr("The survey is not aligned yet.");
    }
    std::map<std::string, int> counts;
    for (const jobs::PhotoFinding& photo : m_findings->photos) {
        ++counts[photo.status];
    }
    QStringList sentences{tr("%1 photos: %2 good, %3 doubtful, %4 failed.")
                              .arg(m_findings->photos.size())
                              .arg(counts["good"])
                              .arg(counts["doubtful"])
                              .arg(counts["failed"])};
    if (counts[""] > 0) {
        sentences << tr("%n photo(s) came since, or were left out: align again.", nullptr, counts[""]);
    }
    sentences << tr("Model %1.").arg(QString::fromStdString(m_findings->solution.model))
              << QString::fromStdString(m_findings->reason);
    for (const std::string& warning : m_findings->warnings) {
        sentences << QString::fromStdString(warning);
    }
    return sentences.join(QLatin1Char(' ')).simplified();
}

bool AlignPresenter::canRun() const {
    return m_session && !m_task;
}

void AlignPresenter::run(const jobs::AlignOptions& options) {
    if (!canRun()) {
        return;
    }
    watch(m_tasks.start(
        tr("Aligning %1").arg(m_session->name()), this,
        [folder = m_session->path(), options](ProgressSink& progress, const std::stop_token& stop) {
            auto store = store::SurveyStore::open(folder, store::Access::Write);
            return jobs::alignSurvey(store, options, progress, stop);
        },
        [this](const jobs::AlignReport& report) {
            if (m_session) {
                m_session->noteChanged(SurveySession::Solutions);
            }
            emit message(tr("Aligned %n photo(s) in %1 s.", nullptr, static_cast<int>(report.photos.size()))
                             .arg(report.seconds, 0, 'f', 1));
        }));
}

void AlignPresenter::stop() {
    if (m_task) {
        m_task->stop();
    }
}

void AlignPresenter::watch(Task* task) {
    m_task = task;
    connect(task, &Task::ended, this, [this, task] {
        m_task.clear();
        if (task->state() == Task::State::Failed) {
            emit message(task->sentence());
        } else if (task->state() == Task::State::Stopped) {
            emit message(tr("Stopped; the survey is as it was."));
        }
        emit taskChanged();
    });
    emit taskChanged();
}

Task* AlignPresenter::move(std::vector<jobs::PhotoPlace> places,
                           const std::function<void(std::vector<jobs::PhotoPlace>)>& done) {
    if (!m_session || m_task) {
        emit message(tr("Another job is changing the survey; try again when it has ended."));
        return nullptr;
    }
    watch(m_tasks.start(
        tr("Moving photos to other stations"), this,
        [folder = m_session->path(), places = std::move(places)](ProgressSink& progress,
                                                                 const std::stop_token& stop) {
            auto store = store::SurveyStore::open(folder, store::Access::Write);
            return jobs::retagPhotos(store, places, progress, stop);
        },
        [this, done](std::vector<jobs::PhotoPlace> before) {
            if (m_session) {
                m_session->noteChanged(SurveySession::Photos);
                done(std::move(before));
            }
        }));
    return m_task;
}

void AlignPresenter::retag(const std::vector<std::int64_t>& photos) {
    std::vector<jobs::PhotoPlace> places;
    for (const std::int64_t id : photos) {
        const jobs::PhotoFinding* photo = m_model.photo(id);
        if (photo != nullptr && photo->fits) {
            places.push_back({id, *photo->fits});
        }
    }
    if (places.empty()) {
        return;
    }
    move(places, [this, places](std::vector<jobs::PhotoPlace> before) {
        m_session->undoStack()->push(new RetagCommand(*this, std::move(before), places));
        emit message(
            tr("Moved %n photo(s); align again to be sure.", nullptr, static_cast<int>(places.size())));
    });
}

void AlignPresenter::retagAll() {
    std::vector<std::int64_t> photos;
    for (const jobs::PhotoFinding& photo : m_model.photos()) {
        photos.push_back(photo.photo);
    }
    retag(photos);
}

void AlignPresenter::retake(const std::vector<std::int64_t>& photos) {
    m_reviewer.decide(photos, store::Decision::Rejected);
}

} // namespace spherewalk::ui
