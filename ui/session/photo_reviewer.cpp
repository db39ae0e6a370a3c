// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/photo_reviewer.h"

#include "ui/look/core_words.h"

#include "spherewalk/base/error.h"

#include <QUndoCommand>

#include <algorithm>

namespace spherewalk::ui {

namespace {

void record(SurveySession& session, const std::vector<store::Review>& reviews) {
    session.write(SurveySession::Reviews | SurveySession::Photos, [&](store::SurveyStore& store) {
        for (const store::Review& review : reviews) {
            store.setReview(review);
        }
    });
}

/// A decision that has been recorded. If another program writes, undo reports that and changes nothing. It
/// then leaves the stack.
class ReviewCommand : public QUndoCommand {
  public:
    ReviewCommand(const QString& text, SurveySession& session, PhotoReviewer& reviewer,
                  std::vector<store::Review> before, std::vector<store::Review> after)
        : QUndoCommand(text),
          m_session(&session),
          m_reviewer(&reviewer),
          m_before(std::move(before)),
          m_after(std::move(after)) {}

    void undo() override { tryTo(m_before); }

    void redo() override {
        if (m_isRecorded) {
            m_isRecorded = false;
            return;
        }
        tryTo(m_after);
    }

  private:
    void tryTo(const std::vector<store::Review>& reviews) {
        if (!m_session) {
            return;
        }
        try {
            record(*m_session, reviews);
            // What has changed is shown.
            m_session->selection()->setCurrent(m_session->store().photo(reviews.front().photo).station);
        } catch (const Error& error) {
            setObsolete(true);
            if (m_reviewer) {
                emit m_reviewer->refused(coreWords(error.sentence()));
            }
        }
    }

    QPointer<SurveySession> m_session;
    QPointer<PhotoReviewer> m_reviewer;
    std::vector<store::Review> m_before;
    std::vector<store::Review> m_after;
    bool m_isRecorded = true;
};

} // namespace

void PhotoReviewer::decide(const std::vector<std::int64_t>& photos, store::Decision decision) {
    const int count = static_cast<int>(photos.size());
    const QString what = decision == store::Decision::Accepted   ? tr("Accept %n photo(s)", nullptr, count)
                         : decision == store::Decision::Rejected ? tr("Reject %n photo(s)", nullptr, count)
                                                                 : tr("Reopen %n photo(s)", nullptr, count);
    apply(what, photos, [decision](store::Review& review) { review.decision = decision; });
}

void PhotoReviewer::setNote(std::int64_t photo, const QString& note) {
    apply(tr("Note on a photo"), {photo},
          [&](store::Review& review) { review.note = note.simplified().toStdString(); });
}

void PhotoReviewer::apply(const QString& what, const std::vector<std::int64_t>& photos,
                          const std::function<void(store::Review&)>& change) {
    if (!m_session) {
        return;
    }
    try {
        std::vector<store::Review> before;
        for (const std::int64_t photo : photos) {
            before.push_back(m_session->store().review(photo));
        }
        std::vector<store::Review> after = before;
        std::for_each(after.begin(), after.end(), change);
        if (before == after) {
            return;
        }
        record(*m_session, after);
        m_session->undoStack()->push(
            new ReviewCommand(what, *m_session, *this, std::move(before), std::move(after)));
    } catch (const Error& error) {
        emit refused(coreWords(error.sentence()));
    }
}

} // namespace spherewalk::ui
