// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/panorama/panorama_presenter.h"
#include "ui/review/review_model.h"
#include "ui/session/photo_reviewer.h"
#include "ui/session/survey_session.h"
#include "ui/tasks/background_worker.h"
#include "ui/tasks/task.h"

#include <QDateTime>
#include <QObject>
#include <QPointer>
#include <QTimer>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>

namespace spherewalk::ui {

/// Calls SurveySession::noteChanged() when another program has changed the survey, such as a capture. It
/// looks every second, in the background.
class SurveyWatch : public QObject {
    Q_OBJECT

  public:
    explicit SurveyWatch(QObject* parent = nullptr);

    /// Null: no survey is open.
    void setSession(SurveySession* session);

  private:
    /// isKnown: the session knows the present state already.
    void look(bool isKnown);

    QPointer<SurveySession> m_session;
    std::shared_ptr<const store::SurveyStore> m_store; ///< Used on the thread of the worker.
    int m_told = 0;                                    ///< Number of changes that the session has told.
    std::int64_t m_seen = 0;
    QTimer m_timer;
    BackgroundWorker m_worker; ///< The last member, as its results use the others.
};

/// The logic of the review page. The list and the viewer follow the survey and its current station, and
/// decisions are recorded in the survey.
class ReviewPresenter : public SurveyPresenter {
    Q_OBJECT

  public:
    ReviewPresenter(TaskList& tasks, std::filesystem::path thumbnailFolder, PanoramaPresenter& viewer,
                    QObject* parent = nullptr);

    void setSession(SurveySession* session) override;

    ReviewModel& model() { return m_model; }

    ReviewProxy& list() { return m_list; }

    /// Returns the row of the current station; null without one.
    const ReviewRow* current() const;
    void setCurrent(std::optional<std::int64_t> station);
    /// Goes to the next station with a photo in the list, or with -1 to the previous one.
    void step(int by);

    /// Decides on the current photo. After accepting or rejecting it goes on to the next one.
    void decide(store::Decision decision);
    /// Decides on the photos of these stations in one step.
    void decideAll(const std::vector<std::int64_t>& stations, store::Decision decision);

    /// Returns the stations whose photo the checks and the alignment call good, and nobody has decided on.
    std::vector<std::int64_t> goodStations() const;
    /// Returns the number of photos that no check has seen.
    int unchecked() const;
    /// Checks these photos in a task.
    void check();
    void setNote(std::int64_t photo, const QString& note);

    /// Lets exports blur this region of the current photo, and selects it.
    void markRegion(const survey::PrivateRegion& region);
    /// Lets exports show the viewer's selected region again.
    void removeRegion();

    /// Returns the number of photos in which nobody has looked for faces yet.
    int unsearched() const { return m_unsearched; }

    bool canSearchFaces() const;
    /// Looks for faces in a task: in these photos, or in all of them again if there are none.
    void searchFaces();

    /// Returns the search that runs; null without one.
    Task* searching() const { return m_searching && m_searching->isRunning() ? m_searching.data() : nullptr; }

    /// Returns the photos near the current one, nearest first, for a comparison.
    const std::vector<const ReviewRow*>& neighbours() const { return m_neighbours; }

    /// Compares with the neighbour of this rank; nothing: ends the comparison.
    void compareWith(std::optional<std::size_t> neighbour);

    /// Whether decisions can be recorded: a survey is open that this program can write, and no task of this
    /// page is writing it.
    bool canDecide() const;

    /// Takes measured errors from this report.json, and remembers the file for this survey. message() tells
    /// if the report belongs to another survey.
    void readErrors(const QString& reportFile);
    /// Reads the errors again if the report has been written anew.
    void lookForErrors();
    /// Says which dataset the errors belong to, or how to measure them.
    QString errorWords() const;

    /// Returns "12 accepted, 3 rejected, 40 to be reviewed, 5 missing".
    QString summary() const;

  signals:
    /// The current station or its row has changed.
    void currentChanged();
    void rowsChanged();
    /// searching() has changed.
    void searchChanged();

  private:
    void read() override;
    void showCurrent();
    void lookForDepths();
    ShownPhoto shown(const ReviewRow& row) const;
    void takeErrors(const QString& reportFile);
    QString surveyId() const;

    TaskList& m_tasks;
    PanoramaPresenter& m_viewer;
    ThumbnailCache m_thumbnails;
    ReviewModel m_model;
    ReviewProxy m_list;
    PhotoReviewer m_reviewer;
    SurveyWatch m_watch;
    std::vector<const ReviewRow*> m_neighbours;
    std::optional<std::size_t> m_compared;
    std::optional<jobs::MeasuredPhotos> m_errors;
    QString m_errorsFile;    ///< The report that the errors come from.
    QDateTime m_errorsSince; ///< Time of its last change.
    QPointer<Task> m_checking;
    QPointer<Task> m_searching;
    int m_unsearched = 0;
    std::map<std::int64_t, std::filesystem::path> m_depths; ///< Depths that exports kept, by photo.
    BackgroundWorker m_worker; ///< The last member, as its results use the others.
};

} // namespace spherewalk::ui
