// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/capture_desk.h"

#include "ui/look/core_words.h"
#include "ui/map/station_words.h"

#include "spherewalk/base/error.h"
#include "spherewalk/practice/practice_room.h"

#include <algorithm>
#include <utility>

namespace spherewalk::ui {

namespace {

/// Options for a practice camera, which draws its pictures slowly on a busy computer.
camera::PreviewOptions patientPreview() {
    camera::PreviewOptions options;
    options.frameTimeout = std::chrono::minutes(1);
    return options;
}

} // namespace

CaptureDesk::CaptureDesk(TaskList& tasks, QObject* parent) : QObject(parent), m_tasks(tasks) {
    m_timer.setInterval(std::chrono::seconds(1));
    connect(&m_timer, &QTimer::timeout, this, &CaptureDesk::tick);
    connect(this, &CaptureDesk::changed, this, &CaptureDesk::followWithPreview);
    connect(this, &CaptureDesk::changed, this, &CaptureDesk::followWithPulse);
    connect(&m_pulse, &CameraPulse::answered, this, &CaptureDesk::hear);
    connect(&m_pulse, &CameraPulse::silent, this, &CaptureDesk::hearNothing);
    connect(&m_login, &CameraLogin::known, this, &CaptureDesk::connectAgain);
}

CaptureDesk::~CaptureDesk() {
    if (m_task) {
        m_task->disconnect(this);
        m_task->stopAndWait(); // its events come here
    }
}

void CaptureDesk::setSession(SurveySession* session) {
    stop();
    if (m_isPractice) {
        disconnectCamera(); // its photos belong to the survey that it was connected for
    }
    if (m_session) {
        m_session->disconnect(this);
    }
    m_session = session;
    m_verdict.reset();
    m_told = {};
    if (session != nullptr) {
        connect(session, &SurveySession::changed, this, [this](SurveySession::Changes what) {
            if (what.testFlag(SurveySession::Plan)) {
                m_queue.markRails(&m_session->state());
            }
            read();
        });
    }
    m_queue.begin(m_session ? &m_session->state() : nullptr);
    read();
}

/// Reads which stations still need a photo.
void CaptureDesk::read() {
    m_queue.read(m_session ? &m_session->state() : nullptr);
    if (!isRunning()) {
        m_queue.goToFirst();
    }
    emit changed();
}

void CaptureDesk::setState(State state) {
    m_state = state;
    emit changed();
}

void CaptureDesk::setProfile(const std::optional<survey::CaptureProfile>& profile) {
    if (!m_session || isRunning()) {
        return;
    }
    try {
        m_session->write(SurveySession::Profile,
                         [&](store::SurveyStore& store) { store.setCaptureProfile(profile); });
    } catch (const Error& error) {
        say(coreTold(error.sentence()));
    }
}

void CaptureDesk::setShowsPreview(bool isShown) {
    m_showsPreview = isShown;
    emit changed();
}

/// Begins and ends the preview as the state allows it.
void CaptureDesk::followWithPreview() {
    const bool isAtRest = m_state == State::Ready || m_state == State::AtStation ||
                          m_state == State::AskAgain || m_state == State::Hiding;
    const bool wants = m_showsPreview && isAtRest;
    if (wants == m_isPreviewing) {
        return;
    }
    m_isPreviewing = wants;
    if (wants) {
        m_preview.start(m_endpoint, timeScale(), m_isPractice ? patientPreview() : camera::PreviewOptions{},
                        m_login.sourceFor(m_endpoint));
    } else {
        m_preview.stop();
    }
}

/// Listens to a camera at rest. A run asks by itself, and a live preview notices when no picture comes.
void CaptureDesk::followWithPulse() {
    const bool wants = m_state == State::Ready && !m_isPreviewing;
    if (wants == m_hasPulse) {
        return;
    }
    m_hasPulse = wants;
    m_isSilent = false;
    wants ? m_pulse.begin(m_endpoint, m_login.sourceFor(m_endpoint)) : m_pulse.end();
}

void CaptureDesk::hear(const camera::CameraState& state) {
    if (m_status) {
        update(*m_status, state);
    }
    if (std::exchange(m_isSilent, false)) {
        say({});
    }
    emit changed();
}

void CaptureDesk::hearNothing(const Told& told) {
    if (m_status) {
        m_status->batteryFraction.reset();
    }
    m_isSilent = true;
    say(told);
}

void CaptureDesk::connectTo(const QString& address) {
    if (isRunning() || m_state == State::Connecting) {
        return;
    }
    try {
        const camera::Endpoint endpoint = camera::parseEndpoint(address.trimmed().toStdString());
        if (!(endpoint == m_endpoint)) {
            m_queue.pace() = {}; // of another camera
        }
        m_endpoint = endpoint;
    } catch (const Error& error) {
        return say(coreTold(error.sentence()));
    }
    m_isPractice = m_practice && m_practice->endpoint() == m_endpoint;
    m_isAutomatic = m_isAutomatic && m_isPractice;
    m_status.reset();
    setState(State::Connecting);
    m_task = m_tasks.start(
        tr("Connecting to %1").arg(QString::fromStdString(m_endpoint.name())), this,
        [endpoint = m_endpoint, login = m_login.sourceFor(m_endpoint)](ProgressSink& /*progress*/,
                                                                       const std::stop_token& stop) {
            camera::OscOptions options;
            options.attempts = 1; // a person waits, and can try again
            options.http.credentials = login;
            camera::OscClient client(endpoint, options, systemClock());
            return askCamera(client, stop);
        },
        [this](const CameraStatus& status) { connected(status); });
    connect(m_task, &Task::ended, this, [this, task = m_task.data()] { connectingEnded(task); });
}

void CaptureDesk::disconnectCamera() {
    stop();
    if (m_state == State::Connecting && m_task) {
        m_task->stopAndWait();
    }
    const bool wasRunning = isRunning();
    m_run += wasRunning ? 1 : 0;
    m_endpoint = {};
    m_isPractice = false;
    m_isAutomatic = false;
    m_startsWhenReady = false;
    m_connectsAgain = false;
    m_status.reset();
    m_verdict.reset();
    m_told = {};
    setState(wasRunning ? m_state : State::NoCamera);
}

bool CaptureDesk::isPracticeRoom() const {
    return m_session && m_session->state().room.outline == practice::PracticeRoom().plan().outline;
}

void CaptureDesk::giveLogin(const camera::Endpoint& endpoint, const camera::Credentials& credentials,
                            bool isKept) {
    m_login.give(endpoint, credentials, isKept);
    connectAgain(endpoint);
}

/// Connects with credentials that are new. A run needs no connection, as its next request uses them.
void CaptureDesk::connectAgain(const camera::Endpoint& endpoint) {
    if (endpoint == m_endpoint && m_state == State::Connecting) {
        m_connectsAgain = true; // what still runs knew nothing of it
    } else if (endpoint == m_endpoint && m_state == State::NoCamera) {
        connectTo(QString::fromStdString(endpoint.name()));
    }
}

void CaptureDesk::connectToPractice() {
    if (isRunning() || m_state == State::Connecting) {
        return;
    }
    if (m_practice) {
        return connectTo(QString::fromStdString(m_practice->endpoint().name()));
    }
    m_isPractice = true;
    setState(State::Connecting);
    m_task = m_tasks.start(
        tr("Starting the practice camera"), this,
        [settings = m_practiceSettings](ProgressSink& /*progress*/, const std::stop_token& /*stop*/) {
            return std::make_shared<PracticeHost>(settings);
        },
        [this](std::shared_ptr<PracticeHost> host) {
            m_practice = std::make_unique<PracticeHost>(std::move(*host));
            m_state = State::NoCamera;
            connectTo(QString::fromStdString(m_practice->endpoint().name()));
        });
    connect(m_task, &Task::ended, this, [this, task = m_task.data()] { connectingEnded(task); });
}

void CaptureDesk::connectingEnded(const Task* task) {
    if (m_task == task && m_state == State::Connecting) { // else it has led on
        m_state = State::NoCamera;
        m_isPractice = false;
        say(task->told());
        if (std::exchange(m_connectsAgain, false)) {
            connectTo(QString::fromStdString(m_endpoint.name()));
        } else {
            m_startsWhenReady = false; // whoever connects later has asked for no run
        }
    }
}

void CaptureDesk::connected(const CameraStatus& status) {
    m_connectsAgain = false;
    m_status = status;
    m_verdict.reset();
    m_told = coreTold(status.troubles.join(" "));
    setState(State::Ready);
    if (std::exchange(m_startsWhenReady, false)) {
        start();
    }
}

void CaptureDesk::setAutomatic(bool isAutomatic) {
    if (isAutomatic != m_isAutomatic) {
        m_isAutomatic = isAutomatic;
        emit changed();
    }
}

void CaptureDesk::say(const Told& told, survey::Quality quality) {
    m_verdict = told.isEmpty() ? std::nullopt : std::optional(quality);
    m_told = told;
    emit changed();
}

jobs::CaptureSurveyOptions CaptureDesk::captureOptions() const {
    jobs::CaptureSurveyOptions options =
        m_isPractice ? jobs::practiceCaptureOptions(timeScale()) : jobs::CaptureSurveyOptions();
    options.again.assign(m_queue.againIds().begin(), m_queue.againIds().end());
    options.byHand = isByHand();
    return options;
}

void CaptureDesk::showStatus(const CameraStatus& status) {
    m_status = status;
    emit changed();
}

void CaptureDesk::atStation(const store::StationRecord& station, bool waitsForKey) {
    m_queue.goTo(station);
    setState(waitsForKey ? State::AtStation : State::Shooting);
}

void CaptureDesk::askAgain(const store::StationRecord& station, const QString& sentence) {
    m_queue.goTo(station);
    m_state = State::AskAgain;
    say(coreTold(sentence));
    emit verdictGiven(survey::Quality::Failed);
}

void CaptureDesk::shooting() {
    m_queue.arrive();
    setState(State::Shooting);
}

void CaptureDesk::showPlaces(const jobs::PlacesFound& places) {
    m_queue.setPlaces(places);
    m_session ? m_session->noteChangedSoon(SurveySession::Plan) : emit changed(); // the room may have grown
}

void CaptureDesk::runPractice() {
    setAutomatic(true);
    m_startsWhenReady = true;
    connectToPractice();
}

void CaptureDesk::start() {
    if (m_state != State::Ready || !m_session) {
        return;
    }
    m_verdict.reset();
    m_told = {};
    m_queue.pace().begin(systemClock().now());
    setState(State::Preparing);
    DeskOptions options;
    options.run = m_run;
    options.practice = m_isPractice ? std::optional(m_endpoint) : std::nullopt;
    options.isAutomatic = m_isPractice && m_isAutomatic;
    m_key.begin();
    m_task = m_tasks.start(
        tr("Capturing %1").arg(m_session->name()), this,
        [this, folder = m_session->path(), endpoint = m_endpoint, options, capture = captureOptions(),
         login = m_login.sourceFor(m_endpoint),
         scale = timeScale()](ProgressSink& progress, const std::stop_token& stop) {
            auto store = store::SurveyStore::open(folder, store::Access::Write);
            camera::OscOptions clientOptions = camera::OscOptions{}.scaled(scale);
            clientOptions.http.credentials = login;
            camera::OscClient client(endpoint, clientOptions, systemClock());
            DeskOperator people(*this, client, options);
            return jobs::captureSurvey(store, client, people, systemClock(), capture, progress, stop);
        },
        [](const jobs::CaptureSurveyReport& /*report*/) {});
    connect(m_task, &Task::ended, this, [this, task = m_task.data()] { runDone(task); });
}

void CaptureDesk::stop() {
    m_timer.stop();
    if (m_task && m_task->isRunning()) {
        m_task->stop();
    }
}

void CaptureDesk::end() {
    if (!isByHand() || m_key.hasLeft()) {
        return stop();
    }
    m_timer.stop();
    m_key.leave();
}

void CaptureDesk::trigger() {
    switch (m_state) {
    case State::Ready:
        return start();
    case State::AtStation:
    case State::AskAgain:
        if (m_hideSeconds == 0) {
            return shoot();
        }
        m_beforeHiding = m_state;
        m_countdown = m_hideSeconds;
        m_timer.start();
        setState(State::Hiding);
        return emit countdownTicked(m_countdown);
    case State::Hiding: // the operator has thought better of it
        m_timer.stop();
        return setState(m_beforeHiding);
    default:
        return;
    }
}

void CaptureDesk::tick() {
    if (m_state != State::Hiding) {
        return m_timer.stop();
    }
    --m_countdown;
    emit countdownTicked(m_countdown);
    if (m_countdown > 0) {
        emit changed();
        return;
    }
    m_timer.stop();
    shoot();
}

void CaptureDesk::shoot() {
    setState(State::Shooting);
    m_key.press();
}

void CaptureDesk::ended(const store::StationRecord& station, survey::Quality quality, bool isThere,
                        const QString& sentence) {
    m_verdict = quality;
    const Told told = coreTold(sentence); // of a station that the cart may have left by now
    const Cure cure = told.cure == Cure::Capture ? Cure::None : told.cure; // that is here
    m_told = told.isEmpty() ? told : Told(tr("%1: %2").arg(stationWords(station.name), told.text), cure);
    const bool isFailed = quality == survey::Quality::Failed;
    if (isThere || !isFailed) {
        m_queue.pace().photo(systemClock().now());
        m_queue.setAgain(station.id,
                         isFailed &&
                             station.isPlaceKnown); // offered for the next run, and taken back by a click
    }
    if (m_session) {
        m_session->noteChangedSoon(SurveySession::Photos); // the run goes on writing
    }
    emit changed(); // the colour comes with the sound, whatever is read later
    emit verdictGiven(quality);
    emit shotEnded(station);
}

void CaptureDesk::runDone(const Task* task) {
    ++m_run;
    m_timer.stop();
    m_state = m_status ? State::Ready : State::NoCamera;
    if (task->state() == Task::State::Failed) {
        say(task->told());
        emit verdictGiven(survey::Quality::Failed);
    }
    if (m_session) {
        m_session->noteChanged(SurveySession::Photos);
    }
    read();
    emit runEnded(stationsLeft() == 0 && task->state() == Task::State::Done);
}

std::chrono::duration<double> CaptureDesk::timeLeft() const {
    return m_queue.timeLeft(m_session ? m_session->state().options : survey::PlanOptions());
}

void CaptureDesk::setAgain(std::int64_t station, bool isAgain) {
    if (!isRunning()) {
        m_queue.setAgain(station, isAgain);
        read();
    }
}

void CaptureDesk::takeDoubtfulAgain() {
    if (!isRunning() && m_session) {
        m_queue.takeDoubtfulAgain(m_session->state());
        read();
    }
}

} // namespace spherewalk::ui
