// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/capture_desk.h"

#include "ui/plan/station_words.h"

#include "spherewalk/base/error.h"

#include <algorithm>
#include <utility>

namespace spherewalk::ui {

namespace {

/// For a practice camera, which draws its pictures on this computer, however busy that is.
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
    if (m_session) {
        m_session->disconnect(this);
    }
    m_session = session;
    m_again.clear();
    m_last.reset();
    m_next.reset();
    m_verdict = Verdict::None;
    m_sentence.clear();
    if (session != nullptr) {
        connect(session, &SurveySession::changed, this, [this](SurveySession::Changes what) {
            if (what.testFlag(SurveySession::Plan)) {
                markRails();
            }
            read();
        });
    }
    markRails();
    read();
}

/// Finding the tapes takes its time in a large room.
void CaptureDesk::markRails() {
    m_rails = m_session ? survey::railMarks(m_session->state().room, m_session->state().plan)
                        : std::vector<survey::RailMark>();
}

/// What is still to be done.
void CaptureDesk::read() {
    m_missing.clear();
    for (const store::StationRecord& station :
         m_session ? m_session->state().stations : std::vector<store::StationRecord>()) {
        if (m_again.contains(station.id) || m_session->state().missing.contains(station.id)) {
            m_missing.push_back(station);
        }
    }
    if (!isRunning()) {
        m_next = m_missing.empty() ? std::nullopt : std::optional(m_missing.front());
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
        failed(QString::fromStdString(error.sentence()));
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

void CaptureDesk::connectTo(const QString& address) {
    if (isRunning() || m_state == State::Connecting) {
        return;
    }
    try {
        m_endpoint = camera::parseEndpoint(address.trimmed().toStdString());
    } catch (const Error& error) {
        return failed(QString::fromStdString(error.sentence()));
    }
    m_isPractice = m_practice && m_practice->endpoint() == m_endpoint;
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

void CaptureDesk::giveLogin(const camera::Endpoint& endpoint, const camera::Credentials& credentials,
                            bool isKept) {
    m_login.give(endpoint, credentials, isKept);
    connectAgain(endpoint);
}

/// Now that it is known who is there; not in the middle of a run, whose next call has it.
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
        failed(task->sentence());
        if (std::exchange(m_connectsAgain, false)) {
            connectTo(QString::fromStdString(m_endpoint.name()));
        }
    }
}

void CaptureDesk::connected(const CameraStatus& status) {
    m_connectsAgain = false;
    m_status = status;
    m_verdict = Verdict::None;
    m_sentence = status.troubles.join(" ");
    setState(State::Ready);
}

void CaptureDesk::failed(const QString& sentence) {
    m_verdict = sentence.isEmpty() ? Verdict::None : Verdict::Failed;
    m_sentence = sentence;
    emit changed();
}

jobs::CaptureSurveyOptions CaptureDesk::captureOptions() const {
    jobs::CaptureSurveyOptions options;
    if (m_isPractice) {
        options = jobs::practiceCaptureOptions(timeScale());
    }
    options.again.assign(m_again.begin(), m_again.end());
    return options;
}

DeskEvents CaptureDesk::events() {
    // From the capturing thread to this one. The destructor waits for that thread. What a run says that has
    // ended meanwhile counts for nothing.
    const auto post = [this, run = m_run](const std::function<void()>& apply) {
        const auto applyInTime = [this, run, apply] {
            if (run == m_run) {
                apply();
            }
        };
        QMetaObject::invokeMethod(this, applyInTime, Qt::QueuedConnection);
    };
    DeskEvents events;
    events.status = [this, post](const CameraStatus& status) {
        post([this, status] {
            m_status = status;
            emit changed();
        });
    };
    events.quiet = [this] { return m_preview.endAndWait(); };
    events.noAnswer = [this, post](const QString& sentence) { post([this, sentence] { failed(sentence); }); };
    events.atStation = [this, post](const store::StationRecord& station) {
        post([this, station] {
            m_next = station;
            setState(m_isAutomatic ? State::Shooting : State::AtStation);
        });
    };
    events.askAgain = [this, post](const store::StationRecord& station, const QString& sentence) {
        post([this, station, sentence] {
            m_next = station;
            m_state = State::AskAgain;
            failed(sentence);
            emit verdictGiven(Verdict::Failed);
        });
    };
    events.shooting = [this, post] {
        post([this] {
            m_last = m_next;
            setState(State::Shooting);
        });
    };
    events.ended = [this, post](const store::StationRecord& station, Verdict verdict, bool isThere,
                                const QString& sentence) {
        post([this, station, verdict, isThere, sentence] { ended(station, verdict, isThere, sentence); });
    };
    return events;
}

void CaptureDesk::start() {
    if (m_state != State::Ready || !m_session) {
        return;
    }
    m_verdict = Verdict::None;
    m_sentence.clear();
    m_pace.begin(systemClock().now());
    setState(State::Preparing);
    const std::optional<camera::Endpoint> practice = m_isPractice ? std::optional(m_endpoint) : std::nullopt;
    m_task = m_tasks.start(
        tr("Capturing %1").arg(m_session->name()), this,
        [folder = m_session->path(), endpoint = m_endpoint, practice, options = captureOptions(),
         login = m_login.sourceFor(m_endpoint), scale = timeScale(), key = m_key, events = events(),
         isAutomatic = m_isPractice && m_isAutomatic](ProgressSink& progress, const std::stop_token& stop) {
            auto store = store::SurveyStore::open(folder, store::Access::Write);
            camera::OscOptions clientOptions = camera::OscOptions{}.scaled(scale);
            clientOptions.http.credentials = login;
            camera::OscClient client(endpoint, clientOptions, systemClock());
            DeskOperator people(client, *key, events, practice, isAutomatic);
            return jobs::captureSurvey(store, client, people, systemClock(), options, progress, stop);
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
    m_key->press();
}

void CaptureDesk::ended(const store::StationRecord& station, Verdict verdict, bool isThere,
                        const QString& sentence) {
    m_verdict = verdict;
    // The cart may stand elsewhere by now.
    m_sentence = sentence.isEmpty() ? sentence : tr("%1: %2").arg(stationWords(station.name), sentence);
    if (isThere || verdict != Verdict::Failed) {
        m_pace.photo(systemClock().now());
        m_again.erase(station.id);
    }
    if (isThere && verdict == Verdict::Failed) {
        m_again.insert(station.id); // offered for the next run, and taken back by a click
    }
    if (m_session) {
        m_session->noteChangedSoon(SurveySession::Photos); // the run goes on writing
    }
    emit verdictGiven(verdict);
}

void CaptureDesk::runDone(const Task* task) {
    ++m_run;
    m_timer.stop();
    m_state = State::Ready;
    if (task->state() == Task::State::Failed) {
        failed(task->sentence());
        emit verdictGiven(Verdict::Failed);
    }
    if (m_session) {
        m_session->noteChanged(SurveySession::Photos);
    }
    read();
    emit runEnded(m_missing.empty() && task->state() == Task::State::Done);
}

QString CaptureDesk::nextText() const {
    return m_next ? stationWords(m_next->name) : QString();
}

QString CaptureDesk::wayText() const {
    if (!m_next) {
        return {};
    }
    const survey::Station& station = m_next->station;
    const bool isOnRail = m_last && m_last->station.placement == station.placement && station.placement >= 0;
    if (isOnRail || station.placement < 0) {
        return positionWords(station);
    }
    return railWords(m_rails[static_cast<std::size_t>(station.placement)]);
}

std::chrono::duration<double> CaptureDesk::timeLeft() const {
    std::set<int> rails;
    for (const store::StationRecord& station : m_missing) {
        rails.insert(station.station.placement);
    }
    return m_pace.left(stationsLeft(), static_cast<int>(rails.size()),
                       m_session ? m_session->state().options : survey::PlanOptions());
}

std::vector<store::StationRecord> CaptureDesk::again() const {
    std::vector<store::StationRecord> result;
    std::copy_if(m_missing.begin(), m_missing.end(), std::back_inserter(result),
                 [this](const store::StationRecord& station) { return m_again.contains(station.id); });
    return result;
}

void CaptureDesk::setAgain(std::int64_t station, bool isAgain) {
    if (isRunning()) {
        return;
    }
    if (isAgain) {
        m_again.insert(station);
    } else {
        m_again.erase(station);
    }
    read();
}

} // namespace spherewalk::ui
