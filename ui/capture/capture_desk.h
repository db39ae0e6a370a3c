// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/capture/camera_login.h"
#include "ui/capture/cameras.h"
#include "ui/capture/desk_operator.h"
#include "ui/capture/live_preview.h"
#include "ui/capture/station_queue.h"
#include "ui/session/survey_session.h"
#include "ui/tasks/task.h"

#include "spherewalk/jobs/capture_survey.h"

#include <QPointer>
#include <QTimer>

#include <chrono>
#include <memory>
#include <optional>

namespace spherewalk::ui {

/// Captures the open survey: it holds the camera, the next station, the key and the progress, but no widget.
/// A run is jobs::captureSurvey(), as in `spherewalk-cli capture`; DeskOperator brings its events here.
/// Threads: the GUI thread. Tasks use the network.
class CaptureDesk : public QObject {
    Q_OBJECT

  public:
    enum class State {
        NoCamera,
        Connecting,
        Ready,     ///< A camera has answered and no run is on.
        Preparing, ///< A run ends open shots and sets the camera.
        AtStation, ///< The run waits for the key.
        AskAgain,  ///< The camera took no picture; the key tries again.
        Hiding,    ///< The countdown runs.
        Shooting,  ///< The run takes and stores a photo.
    };
    Q_ENUM(State)

    explicit CaptureDesk(TaskList& tasks, QObject* parent = nullptr);
    /// Stops the run and waits for its end.
    ~CaptureDesk() override;

    /// Asks a run to stop, and takes the stations of this survey. Null: no survey is open.
    void setSession(SurveySession* session);

    SurveySession* session() const { return m_session; }

    State state() const { return m_state; }

    bool isRunning() const { return m_state >= State::Preparing; }

    /// Asks the camera at this address for its status. The state becomes Ready, or NoCamera with a
    /// sentence().
    void connectTo(const QString& address);

    /// User names and passwords for cameras in client mode.
    const CameraLogin& login() const { return m_login; }

    /// Takes a user name and password, and connects again to the camera that asked for them. isKept: whether
    /// the keychain keeps them.
    void giveLogin(const camera::Endpoint& endpoint, const camera::Credentials& credentials, bool isKept);

    /// Applies to the practice camera that is started next.
    void setPracticeSettings(const PracticeSettings& settings) { m_practiceSettings = settings; }

    const PracticeSettings& practiceSettings() const { return m_practiceSettings; }

    /// Lets go of the camera. A run is asked to stop, and what it still tells is dropped.
    void disconnectCamera();

    /// Connects to the practice camera of this program, which starts when it is first wanted. The camera is
    /// let go of when another survey is opened.
    void connectToPractice();
    /// Connects to the practice camera and then takes all photos without the key.
    void runPractice();

    bool hasPracticeCamera() const { return m_isPractice; }

    /// Whether the survey is of the room that the practice camera photographs.
    bool isPracticeRoom() const;

    /// Returns the practice camera of this program, or null before its first start.
    PracticeHost* practice() const { return m_practice.get(); }

    /// Starts a run over the stations without a photo and those of again().
    void start();
    /// Asks the run to stop; stored photos stay.
    void stop();
    /// Ends the run as a person wants it: a walk by hand takes in what was shot, and looks where. A second
    /// call stops that, too.
    void end();
    /// Does what the one key does now: starts, shoots, tries again, or ends a countdown.
    void trigger();

    /// Whether trigger() does anything now.
    bool takesKey() const {
        return m_state == State::AtStation || m_state == State::AskAgain || m_state == State::Hiding ||
               (m_state == State::Ready && (next() || isByHand()));
    }

    /// Whether photos are taken wherever the operator stands, as the survey has no rails.
    bool isByHand() const { return m_queue.isByHand(); }

    /// What is known by now of the places of photos by hand; nothing before the first look.
    const std::optional<jobs::PlacesFound>& places() const { return m_queue.places(); }

    /// Whether the plan can show where this station is.
    bool isPlaced(const store::StationRecord& station) const { return m_queue.isPlaced(station); }

    void setHideSeconds(int seconds) { m_hideSeconds = seconds; }

    int hideSeconds() const { return m_hideSeconds; }

    /// Whether the next run takes its photos without the key. Only the practice camera does, as it moves its
    /// own cart. Connecting to another camera ends it.
    void setAutomatic(bool isAutomatic);

    bool isAutomatic() const { return m_isAutomatic; }

    /// Returns the exposure settings of this survey, or nothing if the camera stays as it is set.
    std::optional<survey::CaptureProfile> profile() const {
        return m_session ? m_session->state().profile : std::nullopt;
    }

    /// Stores the exposure settings in the survey. A run that is on ignores the call.
    void setProfile(const std::optional<survey::CaptureProfile>& profile);

    /// The live preview. It pauses from the key to the stored photo, as a camera cannot do both.
    const PreviewFeed& preview() const { return m_preview; }

    bool showsPreview() const { return m_showsPreview; }

    void setShowsPreview(bool isShown);

    /// Seconds that the countdown still has.
    int countdown() const { return m_countdown; }

    /// Returns the station of the next photo, or nothing once every station has its photo.
    const std::optional<store::StationRecord>& next() const { return m_queue.next(); }

    /// "Rail 3, stop 5", or "Photo 7" by hand.
    QString nextText() const { return m_queue.nextWords(); }

    /// Says how the cart gets to next(): by rolling on, or by laying the rail, with tape distances. By hand,
    /// it says how many photos found their place.
    QString wayText() const { return m_queue.wayWords(); }

    /// Returns how the rail of next() is laid; null while the cart is on it.
    const survey::RailMark* railToLay() const { return m_queue.railToLay(); }

    int stationsLeft() const { return m_queue.size(); }

    /// Whether every station has its photo and none is to be taken again.
    bool isComplete() const { return stations() > 0 && stationsLeft() == 0 && !isByHand() && !isRunning(); }

    int stations() const { return m_session ? static_cast<int>(m_session->state().stations.size()) : 0; }

    /// Estimates how long the remaining photos take, without waits for the network.
    std::chrono::duration<double> timeLeft() const;

    std::optional<double> photosAMinute() const { return m_queue.pace().photosAMinute(); }

    const std::optional<CameraStatus>& camera() const { return m_status; }

    /// Whether the camera at rest does not answer any more.
    bool isSilent() const { return m_isSilent; }

    /// Returns the result of the latest shot, Failed for any other failure, and nothing before.
    std::optional<survey::Quality> verdict() const { return m_verdict; }

    /// Explains verdict(), or says what went wrong; empty if there is nothing to say.
    QString sentence() const { return m_told.text; }

    /// Returns sentence(), with the place of its cure.
    const Told& told() const { return m_told; }

    /// Returns the stations that are photographed again although they have a photo, in walking order.
    std::vector<store::StationRecord> again() const { return m_queue.again(); }

    /// Puts a station on that list or takes it off. A run that is on ignores the call.
    void setAgain(std::int64_t station, bool isAgain);

    /// Puts every station on that list whose photo is doubtful or failed, and nobody has decided on.
    void takeDoubtfulAgain();

    bool isAgain(std::int64_t station) const { return m_queue.isAgain(station); }

  signals:
    void changed();
    void verdictGiven(spherewalk::survey::Quality quality);
    /// The result of a shot at this station is known: verdict() and sentence() are of it.
    void shotEnded(const spherewalk::store::StationRecord& station);
    void countdownTicked(int secondsLeft);
    /// A run has ended. isComplete: every station has its photo.
    void runEnded(bool isComplete);

  private:
    friend class DeskOperator;

    void setState(State state);
    void followWithPreview();
    void followWithPulse();
    void hear(const camera::CameraState& state);
    void hearNothing(const Told& told);
    void read();
    void connectAgain(const camera::Endpoint& endpoint);
    void connected(const CameraStatus& status);
    void connectingEnded(const Task* task);
    /// Makes a sentence and its weight what verdict() and told() return; an empty one takes them away.
    void say(const Told& told, survey::Quality quality = survey::Quality::Failed);
    void shoot();
    void tick();
    void showStatus(const CameraStatus& status);
    void atStation(const store::StationRecord& station, bool waitsForKey);
    void askAgain(const store::StationRecord& station, const QString& sentence);
    void shooting();
    void showPlaces(const jobs::PlacesFound& places);
    void ended(const store::StationRecord& station, survey::Quality quality, bool isThere,
               const QString& sentence);
    void runDone(const Task* task);
    jobs::CaptureSurveyOptions captureOptions() const;

    double timeScale() const { return m_isPractice ? m_practiceSettings.timeScale : 1; }

    TaskList& m_tasks;
    QPointer<SurveySession> m_session;
    State m_state = State::NoCamera;
    State m_beforeHiding = State::AtStation;
    QPointer<Task> m_task;
    int m_run = 0; ///< Number of runs that have ended.
    camera::Endpoint m_endpoint;
    PracticeSettings m_practiceSettings;
    std::unique_ptr<PracticeHost> m_practice;
    bool m_isPractice = false;
    bool m_isAutomatic = false;
    bool m_startsWhenReady = false;
    CameraLogin m_login;
    bool m_connectsAgain = false;
    PreviewFeed m_preview;
    bool m_showsPreview = false;
    bool m_isPreviewing = false;
    CameraPulse m_pulse;
    bool m_hasPulse = false;
    bool m_isSilent = false;
    ShutterKey m_key;
    QTimer m_timer;
    int m_hideSeconds = 0;
    int m_countdown = 0;
    StationQueue m_queue;
    std::optional<CameraStatus> m_status;
    std::optional<survey::Quality> m_verdict;
    Told m_told;
};

} // namespace spherewalk::ui
