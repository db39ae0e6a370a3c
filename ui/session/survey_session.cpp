// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/survey_session.h"

#include "spherewalk/base/error.h"

#include <QFileInfo>

#include <algorithm>

namespace spherewalk::ui {

using store::Access;

namespace {

/// Whether the survey can be written now.
bool canWrite(const std::filesystem::path& folder) {
    try {
        store::SurveyStore::open(folder, Access::Write);
        return true;
    } catch (const Error&) { // reading may work, and says best what is wrong if it does not
        return false;
    }
}

Standing standingOf(store::Decision decision, survey::Quality quality) {
    switch (decision) {
    case store::Decision::Accepted:
        return Standing::Accepted;
    case store::Decision::Rejected:
        return Standing::Rejected;
    case store::Decision::Open:
        break;
    }
    switch (quality) {
    case survey::Quality::Good:
        return Standing::Taken;
    case survey::Quality::Doubtful:
        return Standing::Doubtful;
    case survey::Quality::Failed:
        break;
    }
    return Standing::Failed;
}

} // namespace

std::map<std::int64_t, Standing> standings(const store::SurveyStore& store,
                                           const std::optional<jobs::SolutionFindings>& findings) {
    std::map<std::int64_t, survey::Quality> qualities; // by photo: the worse of checks and alignment
    for (const store::PhotoVerdict& verdict : store.verdicts()) {
        qualities[verdict.photo] = verdict.quality;
    }
    if (findings) {
        for (const jobs::PhotoFinding& photo : findings->photos) {
            survey::Quality& worst = qualities[photo.photo];
            worst = std::max(worst, photo.quality.value_or(survey::Quality::Good));
        }
    }
    std::map<std::int64_t, store::Decision> decisions; // by photo
    for (const store::Review& review : store.reviews()) {
        decisions[review.photo] = review.decision;
    }
    std::map<std::int64_t, Standing> result;
    for (const store::StationRecord& station : store.stations()) {
        result[station.id] = Standing::Missing;
    }
    for (const store::PhotoRecord& photo : store.chosenPhotos()) {
        result[photo.station] = standingOf(decisions[photo.id], qualities[photo.id]);
    }
    return result;
}

SurveyState readState(const store::SurveyStore& store) {
    SurveyState state;
    state.room = store.knownRoom();
    state.options = store.planOptions();
    state.profile = store.captureProfile();
    state.plan = store.plan();
    state.stations = store.stations();
    for (const store::StationRecord& station : store.stationsWithoutPhoto()) {
        state.missing.insert(station.id);
    }
    state.counts = store.counts();
    state.roomOrigin = store.roomOrigin();
    try {
        state.findings = jobs::activeFindings(store);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::Corrupt) {
            throw;
        }
        // The pages that show findings read them again and say it.
    }
    state.standings = standings(store, state.findings);
    return state;
}

int SurveyState::count(Standing standing) const {
    return static_cast<int>(std::count_if(standings.begin(), standings.end(),
                                          [&](const auto& one) { return one.second == standing; }));
}

bool SurveyState::hasUnknownPlaces() const {
    return std::ranges::any_of(stations, [&](const store::StationRecord& station) {
        const auto standing = standings.find(station.id);
        return !station.isPlaceKnown && standing != standings.end() && standing->second != Standing::Missing;
    });
}

std::unique_ptr<SurveySession> SurveySession::open(const QString& folder) {
    const std::filesystem::path path = folder.toStdString();
    const bool isReadOnly = !canWrite(path);
    // The constructor is private, so that a session cannot be without a store.
    return std::unique_ptr<SurveySession>(
        new SurveySession(folder, store::SurveyStore::open(path, Access::Read), isReadOnly));
}

SurveySession::SurveySession(QString folder, store::SurveyStore store, bool isReadOnly)
    : m_folder(std::move(folder)),
      m_store(std::move(store)),
      m_state(readState(m_store)),
      m_name(QString::fromStdString(m_store.info().name)),
      m_isReadOnly(isReadOnly) {
}

store::SurveyStore SurveySession::openForWriting() {
    try {
        store::SurveyStore writer = store::SurveyStore::open(path(), Access::Write);
        setReadOnly(false);
        return writer;
    } catch (const Error&) {
        setReadOnly(true);
        throw;
    }
}

void SurveySession::noteChanged(Changes what) {
    m_overtaken = m_posted;
    m_state = readState(m_store);
    emit changed(what | std::exchange(m_soon, {}));
}

void SurveySession::noteChangedSoon(Changes what) {
    m_soon |= what;
    m_worker.post(
        QStringLiteral("state"), [this, folder = path(), number = ++m_posted]() -> BackgroundWorker::Deliver {
            try {
                return [this, number, state = readState(store::SurveyStore::open(folder, Access::Read))] {
                    if (number > m_overtaken) {
                        m_state = state;
                        emit changed(std::exchange(m_soon, {}));
                    }
                };
            } catch (const Error& error) { // the window says it
                return [error] { throw error; };
            }
        });
}

void SurveySession::setReadOnly(bool isReadOnly) {
    if (isReadOnly != m_isReadOnly) {
        m_isReadOnly = isReadOnly;
        emit readOnlyChanged(isReadOnly);
    }
}

void SurveyPresenter::setSession(SurveySession* session) {
    if (m_session) {
        m_session->disconnect(this);
        m_session->selection()->disconnect(this);
    }
    const bool isFirst = m_session == nullptr;
    m_session = session;
    if (session != nullptr) {
        connect(session, &SurveySession::changed, this, &SurveyPresenter::refresh);
    }
    m_isStale = isFirst && session != nullptr && !m_isShown;
    if (!m_isStale) { // nothing of the session before may stay
        read();
    }
}

void SurveyPresenter::setShown(bool isShown) {
    m_isShown = isShown;
    if (isShown && m_isStale) {
        refresh();
    }
}

void SurveyPresenter::refresh() {
    m_isStale = !m_isShown;
    if (m_isShown) {
        read();
    }
}

QString freeFolder(const QString& base, const QString& ending) {
    QString folder = base + ending;
    for (int i = 2; QFileInfo::exists(folder); ++i) {
        folder = QStringLiteral("%1-%2%3").arg(base).arg(i).arg(ending);
    }
    return folder;
}

} // namespace spherewalk::ui
