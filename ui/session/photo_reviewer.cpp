// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/photo_reviewer.h"

#include "ui/look/core_words.h"

#include "spherewalk/base/error.h"

#include <QUndoCommand>

#include <algorithm>

namespace spherewalk::ui {

namespace {

using Change = std::function<void(store::SurveyStore&)>;

void write(SurveySession& session, const Change& change) {
    session.write(SurveySession::Reviews | SurveySession::Photos, change);
}

Change recording(std::vector<store::Review> reviews) {
    return [reviews = std::move(reviews)](store::SurveyStore& store) {
        for (const store::Review& review : reviews) {
            store.setReview(review);
        }
    };
}

/// What a person did to photos, and which has been recorded. If another program writes, undo reports that and
/// changes nothing. It then leaves the stack.
class ReviewCommand : public QUndoCommand {
  public:
    /// photo: the one that is shown when the step is taken back.
    ReviewCommand(const QString& text, SurveySession& session, PhotoReviewer& reviewer, std::int64_t photo,
                  Change before, Change after)
        : QUndoCommand(text),
          m_session(&session),
          m_reviewer(&reviewer),
          m_photo(photo),
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
    void tryTo(const Change& change) {
        if (!m_session) {
            return;
        }
        try {
            write(*m_session, change);
            // What has changed is shown.
            m_session->selection()->setCurrent(m_session->store().photo(m_photo).station);
        } catch (const Error& error) {
            setObsolete(true);
            if (m_reviewer) {
                emit m_reviewer->refused(coreWords(error.sentence()));
            }
        }
    }

    QPointer<SurveySession> m_session;
    QPointer<PhotoReviewer> m_reviewer;
    std::int64_t m_photo;
    Change m_before;
    Change m_after;
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
        write(*m_session, recording(after));
        m_session->undoStack()->push(new ReviewCommand(what, *m_session, *this, photos.front(),
                                                       recording(std::move(before)),
                                                       recording(std::move(after))));
    } catch (const Error& error) {
        emit refused(coreWords(error.sentence()));
    }
}

std::optional<std::int64_t> PhotoReviewer::markRegion(std::int64_t photo,
                                                      const survey::PrivateRegion& region) {
    if (!m_session) {
        return std::nullopt;
    }
    try {
        store::RegionRecord record{0, photo, region, store::RegionOrigin::Marked};
        write(*m_session, [&](store::SurveyStore& store) { record.id = store.markRegion(photo, region); });
        m_session->undoStack()->push(new ReviewCommand(
            tr("Hide a region"), *m_session, *this, photo,
            [id = record.id](store::SurveyStore& store) { store.removeRegion(id); },
            [record](store::SurveyStore& store) { store.restoreRegion(record); }));
        return record.id;
    } catch (const Error& error) {
        emit refused(coreWords(error.sentence()));
        return std::nullopt;
    }
}

void PhotoReviewer::removeRegion(const store::RegionRecord& region) {
    if (!m_session) {
        return;
    }
    try {
        const Change removal = [id = region.id](store::SurveyStore& store) { store.removeRegion(id); };
        write(*m_session, removal);
        m_session->undoStack()->push(new ReviewCommand(
            tr("Remove a region"), *m_session, *this, region.photo,
            [region](store::SurveyStore& store) { store.restoreRegion(region); }, removal));
    } catch (const Error& error) {
        emit refused(coreWords(error.sentence()));
    }
}

} // namespace spherewalk::ui
