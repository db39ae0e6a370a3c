// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/align/align_presenter.h"

#include "ui/look/core_words.h"
#include "ui/look/words.h"

#include "spherewalk/base/error.h"

#include <QUndoCommand>

#include <map>

namespace spherewalk::ui {

/// Takes back a move of photos that has been made, or makes it again.
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
    /// Removes this step from the stack if the move fails, as the stack would be wrong.
    void move(const std::vector<jobs::PhotoPlace>& places) {
        if (!m_presenter || !m_presenter->session()) {
            return;
        }
        QUndoStack* stack = m_presenter->session()->undoStack();
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
    : SurveyPresenter(parent), m_tasks(tasks), m_table(m_model) {
    connect(&m_reviewer, &PhotoReviewer::refused, this, &AlignPresenter::message);
}

void AlignPresenter::setSession(SurveySession* session) {
    m_reviewer.setSession(session);
    m_solvedAt.clear();
    SurveyPresenter::setSession(session);
}

void AlignPresenter::read() {
    try {
        m_findings = session() != nullptr ? jobs::activeFindings(session()->store()) : std::nullopt;
        forgetOfMoved();
        m_model.setPhotos(m_findings ? m_findings->photos : std::vector<jobs::PhotoFinding>());
    } catch (const Error& error) {
        m_findings.reset();
        m_model.setPhotos({});
        emit message(coreTold(error.sentence()));
    }
    emit findingsChanged();
}

/// Drops what the alignment said of photos that have come to another station since.
void AlignPresenter::forgetOfMoved() {
    if (!m_findings) {
        return;
    }
    for (jobs::PhotoFinding& photo : m_findings->photos) {
        const auto solved = m_solvedAt.find(photo.photo);
        if (solved != m_solvedAt.end() && solved->second != photo.station) {
            photo.quality.reset();
            photo.fits.reset();
            photo.cure = jobs::Cure::None;
            photo.flags = {tr("Moved to this station since; align again.").toStdString()};
        }
    }
}

Told AlignPresenter::summary() const {
    if (!session()) {
        return {};
    }
    if (!m_findings) {
        return session()->state().counts.stationsWithPhoto > 0
                   ? Told(tr("The survey is not aligned yet."))
                   : Told(tr("There is no photo to align yet; capture or import some first."), Cure::Capture);
    }
    std::map<std::optional<survey::Quality>, int> counts;
    for (const jobs::PhotoFinding& photo : m_findings->photos) {
        ++counts[photo.quality];
    }
    QStringList sentences{tr("Alignment of %n photo(s): %1 good, %2 doubtful, %3 failed.", nullptr,
                             static_cast<int>(m_findings->photos.size()))
                              .arg(counts[survey::Quality::Good])
                              .arg(counts[survey::Quality::Doubtful])
                              .arg(counts[survey::Quality::Failed])};
    const int undecided =
        session()->state().count(Standing::Doubtful) + session()->state().count(Standing::Failed);
    if (undecided > 0) {
        sentences << tr("With what the checks found, %n photo(s) are to be looked at in Review.", nullptr,
                        undecided);
    }
    if (counts[std::nullopt] > 0) {
        sentences << tr("%n photo(s) came since, or were left out: align again.", nullptr,
                        counts[std::nullopt]);
    }
    sentences << tr("Model %1.").arg(QString::fromStdString(m_findings->solution.model))
              << coreWords(m_findings->reason);
    Cure cure = undecided > 0 ? Cure::Review : Cure::None;
    for (const std::string& warning : m_findings->warnings) {
        const Told told = coreTold(warning);
        sentences << told.text;
        cure = cure == Cure::None && told.cure != Cure::Align ? told.cure : cure; // it is cured here
    }
    return {sentences.join(QLatin1Char(' ')).simplified(), cure};
}

bool AlignPresenter::canRun() const {
    return session() != nullptr && task() == nullptr;
}

void AlignPresenter::run(const jobs::AlignOptions& options) {
    if (!canRun()) {
        return;
    }
    watch(m_tasks.start(
        tr("Aligning %1").arg(session()->name()), this,
        [folder = session()->path(), options](ProgressSink& progress, const std::stop_token& stop) {
            auto store = store::SurveyStore::open(folder, store::Access::Write);
            return jobs::alignSurvey(store, options, progress, stop);
        },
        [this, isFree = options.isFree](const jobs::AlignReport& report) {
            m_solvedAt.clear();
            if (session() != nullptr) {
                if (isFree) {
                    session()->undoStack()->clear(); // It knows stations that are no more.
                }
                session()->noteChanged(isFree ? SurveySession::Everything : SurveySession::Solutions);
            }
            emit message(tr("Aligned %n photo(s) in %1.", nullptr, static_cast<int>(report.photos.size()))
                             .arg(durationText(std::chrono::duration<double>(report.seconds))));
        }));
}

void AlignPresenter::watch(Task* task) {
    m_task = task;
    connect(task, &Task::ended, this, [this, task] {
        if (task->state() == Task::State::Stopped) {
            emit message(tr("Stopped; the survey is as it was."));
        }
        emit taskChanged();
    });
    emit taskChanged();
}

Task* AlignPresenter::move(std::vector<jobs::PhotoPlace> places,
                           const std::function<void(std::vector<jobs::PhotoPlace>)>& done) {
    if (!session() || task() != nullptr) {
        emit message(tr("Another job is changing the survey; try again when it has ended."));
        return nullptr;
    }
    watch(m_tasks.start(
        tr("Moving photos to other stations"), this,
        [folder = session()->path(), places = std::move(places)](ProgressSink& progress,
                                                                 const std::stop_token& stop) {
            auto store = store::SurveyStore::open(folder, store::Access::Write);
            return jobs::retagPhotos(store, places, progress, stop);
        },
        [this, done](std::vector<jobs::PhotoPlace> before) {
            if (session() != nullptr) {
                for (const jobs::PhotoPlace& place : before) {
                    m_solvedAt.try_emplace(place.photo, place.station);
                }
                session()->noteChanged(SurveySession::Photos);
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
        session()->undoStack()->push(new RetagCommand(*this, std::move(before), places));
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
