// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/survey_session.h"

#include <QObject>
#include <QPointer>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace spherewalk::ui {

/// Records decisions and notes of a person on photos, and which regions of them are private. Each call is one
/// step of the session's undo stack.
class PhotoReviewer : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    /// Null: no survey is open.
    void setSession(SurveySession* session) { m_session = session; }

    /// Sets the decision of these photos; their notes stay.
    void decide(const std::vector<std::int64_t>& photos, store::Decision decision);
    /// Sets the note of a photo; its decision stays.
    void setNote(std::int64_t photo, const QString& note);
    /// Lets exports blur a region of a photo. Returns its identity; nothing if that was refused.
    std::optional<std::int64_t> markRegion(std::int64_t photo, const survey::PrivateRegion& region);
    /// Lets exports show a region again. One that a search has found is not found once more.
    void removeRegion(const store::RegionRecord& region);

  signals:
    /// Nothing was recorded; the sentence says why.
    void refused(const QString& sentence);

  private:
    void apply(const QString& what, const std::vector<std::int64_t>& photos,
               const std::function<void(store::Review&)>& change);

    QPointer<SurveySession> m_session;
};

} // namespace spherewalk::ui
