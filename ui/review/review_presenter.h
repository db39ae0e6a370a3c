// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/panorama/panorama_presenter.h"
#include "ui/review/photo_reviewer.h"
#include "ui/review/review_model.h"
#include "ui/review/survey_watch.h"
#include "ui/session/survey_presenter.h"

#include <QDateTime>

namespace spherewalk::ui {

/// What the review page does: keeps the list and the viewer in step with the survey and the station that all
/// views share, and records decisions.
class ReviewPresenter : public SurveyPresenter {
    Q_OBJECT

  public:
    explicit ReviewPresenter(std::filesystem::path thumbnailFolder, PanoramaPresenter& viewer,
                             QObject* parent = nullptr);

    void setSession(SurveySession* session) override;

    ReviewModel& model() { return m_model; }

    ReviewProxy& list() { return m_list; }

    /// Of the current station; null without one.
    const ReviewRow* current() const;
    void setCurrent(std::optional<std::int64_t> station);
    /// The next (or with -1 the previous) station of the list that has a photo.
    void step(int by);

    /// Decides on the current photo, and goes on to the next one of the list if it is accepted or rejected.
    void decide(store::Decision decision);
    void setNote(std::int64_t photo, const QString& note);

    /// Photos near the current one, nearest first, to compare it with.
    const std::vector<const ReviewRow*>& neighbours() const { return m_neighbours; }

    /// Compares with the neighbour of this rank; nothing: with none.
    void compareWith(std::optional<std::size_t> neighbour);

    /// Whether decisions can be recorded: a survey is open, and no other program was writing it.
    bool canDecide() const;

    /// Takes measured errors from this report.json, now and when the survey is opened again. If it is not
    /// one of this survey's, message() says so.
    void readErrors(const QString& reportFile);
    /// Looks whether the survey's dataset has been measured since.
    void lookForErrors();
    /// What the measured errors are of, or that there are none, and what to do.
    QString errorWords() const;

    /// "12 accepted, 3 rejected, 40 to be reviewed, 5 missing".
    QString summary() const;

  signals:
    /// Another station, or something about this one.
    void currentChanged();
    void rowsChanged();

  private:
    void read() override;
    void showCurrent();
    void takeErrors(const QString& reportFile);
    QString surveyId() const;

    PanoramaPresenter& m_viewer;
    ThumbnailCache m_thumbnails;
    ReviewModel m_model;
    ReviewProxy m_list;
    PhotoReviewer m_reviewer;
    SurveyWatch m_watch;
    std::vector<const ReviewRow*> m_neighbours;
    std::optional<std::size_t> m_compared;
    std::optional<jobs::MeasuredPhotos> m_errors;
    QString m_errorsFile;    ///< that they were read from
    QDateTime m_errorsSince; ///< when that was written
};

} // namespace spherewalk::ui
