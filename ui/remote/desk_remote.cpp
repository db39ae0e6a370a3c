// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/remote/desk_remote.h"

#include "ui/capture/capture_desk.h"
#include "ui/capture/desk_words.h"
#include "ui/map/station_words.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/jpeg/jpeg.h"

#include <algorithm>
#include <utility>

namespace spherewalk::ui {

using State = CaptureDesk::State;

namespace {

/// The latest photo at the station, small enough for a slow network; empty if there is none to be shown.
QByteArray smallPhoto(const std::filesystem::path& survey, std::int64_t station) {
    constexpr int kWidth = 640;
    constexpr int kQuality = 80;
    try {
        const auto store = store::SurveyStore::open(survey, store::Access::Read);
        const auto photos = store.photosAt(station);
        if (photos.empty()) {
            return {};
        }
        const auto latest = std::ranges::max_element(photos, {}, &store::PhotoRecord::id);
        const auto file = store.photoFolder() / latest->fileName;
        const Bytes small =
            jpeg::encode(jpeg::decodeAtLeast(readFile(file), file.string(), kWidth), kQuality);
        return QByteArray(reinterpret_cast<const char*>(small.data()), static_cast<qsizetype>(small.size()));
    } catch (const Error&) {
        return {}; // a photo that cannot be read has its verdict, which is shown
    }
}

} // namespace

DeskRemote::DeskRemote(CaptureDesk& desk, const Clock& clock, QObject* parent)
    : QObject(parent), m_desk(desk), m_clock(clock) {
    connect(&desk, &CaptureDesk::changed, this, &DeskRemote::follow);
    connect(&desk, &CaptureDesk::shotEnded, this, &DeskRemote::note);
    connect(&desk, &CaptureDesk::runEnded, this, &DeskRemote::runEnded);
    follow();
}

qint64 DeskRemote::now() const {
    return std::chrono::duration_cast<std::chrono::milliseconds>(m_clock.now().time_since_epoch()).count();
}

/// Counts a turn for everything that a press could be about.
void DeskRemote::follow() {
    if (m_survey != m_desk.session()) {
        m_survey = m_desk.session();
        m_latest.reset();
        m_words.clear();
        m_photo.clear();
        ++m_photoNumber;
    }
    const Step step{m_desk.session(), static_cast<int>(m_desk.state()),
                    m_desk.next() ? m_desk.next()->id : 0};
    if (step == m_step) {
        return;
    }
    m_step = step;
    ++m_turn;
    if (m_desk.state() == State::Shooting) {
        m_shooting = m_desk.next();
    } else if (m_desk.state() == State::AskAgain || !m_desk.isRunning()) {
        m_shooting.reset();
    }
}

void DeskRemote::note(const store::StationRecord& station) {
    if (m_shooting && m_shooting->id == station.id) {
        m_shooting.reset();
    }
    m_latest = station;
    m_quality = m_desk.verdict();
    m_words = resultWords(m_desk).text;
    m_photo.clear();
    ++m_photoNumber;
    readPhoto(station.id);
}

void DeskRemote::readPhoto(std::int64_t station) {
    if (m_desk.session() == nullptr) {
        return;
    }
    m_worker.post("photo", [this, station, survey = m_desk.session()->path(), number = m_photoNumber] {
        return [this, number, picture = smallPhoto(survey, station)] {
            if (number == m_photoNumber) {
                m_photo = picture;
                emit photoReady();
            }
        };
    });
}

QJsonObject DeskRemote::latest() const {
    const bool isDownloading = m_shooting && m_desk.state() != State::Shooting;
    QString words =
        isDownloading
            ? tr("%1: the photo is being downloaded and checked.").arg(stationWords(m_shooting->name))
            : QString();
    if (!m_latest) {
        return {{"words", words}};
    }
    return {{"photo", m_photoNumber},
            {"hasPicture", !m_photo.isEmpty()},
            {"station", stationWords(m_latest->name)},
            {"quality", m_quality ? QString::fromUtf8(name(*m_quality)) : QString()},
            {"verdict", m_words},
            {"words", words},
            {"canTakeAgain", canTakeAgain()}};
}

QJsonObject DeskRemote::state() {
    follow();
    const bool hasSurvey = m_desk.session() != nullptr;
    const bool takesKey = hasSurvey && m_desk.takesKey();
    const QString result = resultWords(m_desk).text;
    return {{"seen", now()},
            {"turn", m_turn},
            {"survey", hasSurvey ? m_desk.session()->name() : tr("Open a survey in the window.")},
            {"practice", m_desk.hasPracticeCamera() ? practiceWords() : QString()},
            {"state", stateWords(m_desk)},
            {"station", m_desk.nextText()},
            {"way", m_desk.wayText()},
            {"left", m_desk.isByHand() ? QString() : tr("%n photo(s) left", nullptr, m_desk.stationsLeft())},
            {"key", keyWords(m_desk)},
            {"takesKey", takesKey},
            {"trouble", result == m_words ? QString() : result},
            {"latest", latest()}};
}

bool DeskRemote::canTakeAgain() const {
    const bool isAtRest = m_desk.state() == State::Ready || m_desk.state() == State::AtStation;
    return m_latest && !m_shooting && isAtRest && m_survey == m_desk.session() && !m_desk.isAutomatic();
}

bool DeskRemote::isLate(const Press& press) const {
    const qint64 age = now() - press.seen;
    return age < 0 || age > std::chrono::milliseconds(kLate).count();
}

DeskRemote::Answer DeskRemote::press(Wish wish, const Press& press) {
    constexpr std::size_t kRemembered = 64;
    const auto before =
        std::ranges::find(m_answers, press.id, [](const auto& answered) { return answered.first; });
    if (before != m_answers.end()) {
        return before->second; // the network has sent it twice, or its answer was lost
    }
    const Answer answer = apply(wish, press);
    m_answers.emplace_back(press.id, answer);
    if (m_answers.size() > kRemembered) {
        m_answers.pop_front();
    }
    return answer;
}

DeskRemote::Answer DeskRemote::apply(Wish wish, const Press& press) {
    follow();
    const qint64 current = wish == Wish::Shoot ? m_turn : m_photoNumber;
    if (isLate(press) || press.about != current) {
        return {false,
                tr("Nothing was done: the press came too late, or was for another station. Look at what "
                   "is next, and press again.")};
    }
    if (wish == Wish::Shoot ? !m_desk.takesKey() : !canTakeAgain()) {
        return {false, tr("Nothing was done: the camera is not ready for that.")};
    }
    wish == Wish::Shoot ? m_desk.trigger() : takeAgain();
    return {true, {}};
}

/// Which stations a run takes is settled when it begins. The run begins anew, therefore.
void DeskRemote::takeAgain() {
    m_startsAgain = true;
    m_desk.isRunning() ? m_desk.stop() : runEnded();
}

void DeskRemote::runEnded() {
    if (std::exchange(m_startsAgain, false) && m_latest && m_survey == m_desk.session()) {
        m_desk.setAgain(m_latest->id, true);
        m_desk.start();
    }
}

} // namespace spherewalk::ui
