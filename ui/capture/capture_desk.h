// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/capture/camera_login.h"
#include "ui/capture/camera_status.h"
#include "ui/capture/desk_operator.h"
#include "ui/capture/pace.h"
#include "ui/capture/practice_host.h"
#include "ui/capture/preview_feed.h"
#include "ui/session/survey_session.h"
#include "ui/tasks/task_list.h"

#include "spherewalk/jobs/capture_survey.h"
#include "spherewalk/survey/marking.h"

#include <QPointer>
#include <QTimer>

#include <functional>
#include <memory>
#include <set>

namespace spherewalk::ui {

/// What the operator works with: the camera, the next station, the key, and how far the survey is. It runs
/// jobs::captureSurvey(), as `spherewalk-cli capture` does, and holds no widget. Threads: the GUI thread; the
/// network is never used on it.
class CaptureDesk : public QObject {
    Q_OBJECT

  public:
    enum class State {
        NoCamera,
        Connecting,
        Ready,     ///< a camera is there, nothing runs
        Preparing, ///< the run settles and prepares
        AtStation, ///< waits for the key
        AskAgain,  ///< no picture was taken; the key tries again
        Hiding,    ///< counts down
        Shooting,  ///< from the key to the stored photo
    };
    Q_ENUM(State)

    explicit CaptureDesk(TaskList& tasks, QObject* parent = nullptr);
    /// Stops what runs, and waits for it.
    ~CaptureDesk() override;

    void setSession(SurveySession* session);

    SurveySession* session() const { return m_session; }

    State state() const { return m_state; }

    bool isRunning() const { return m_state >= State::Preparing; }

    /// Asks the camera at this address how it is.
    void connectTo(const QString& address);

    /// Who is there, for a camera that asks.
    const CameraLogin& login() const { return m_login; }

    /// What a person has said; connects again to the camera that has asked. isKept: in the keychain.
    void giveLogin(const camera::Endpoint& endpoint, const camera::Credentials& credentials, bool isKept);

    /// Of the practice camera that is started next.
    void setPracticeSettings(const PracticeSettings& settings) { m_practiceSettings = settings; }

    const PracticeSettings& practiceSettings() const { return m_practiceSettings; }

    /// Starts the practice camera in this program, if need be, and connects to it.
    void connectToPractice();

    bool hasPracticeCamera() const { return m_isPractice; }

    /// Of the practice camera in this program; null without one.
    PracticeHost* practice() const { return m_practice.get(); }

    /// Takes what is missing, and what is to be taken again.
    void start();
    void stop();
    /// The one key: starts, shoots, tries again, or ends a countdown.
    void trigger();

    void setHideSeconds(int seconds) { m_hideSeconds = seconds; }

    int hideSeconds() const { return m_hideSeconds; }

    /// Shoots without the key; with the practice camera only, which moves its cart by itself.
    void setAutomatic(bool isAutomatic) { m_isAutomatic = isAutomatic; }

    /// How the camera is set for the photos of this survey.
    std::optional<survey::CaptureProfile> profile() const {
        return m_session ? m_session->state().profile : std::nullopt;
    }

    /// Keeps it in the survey; not while a run goes on.
    void setProfile(const std::optional<survey::CaptureProfile>& profile);

    /// What the camera sees. It rests from the key to the stored photo, as a camera cannot do both.
    const PreviewFeed& preview() const { return m_preview; }

    bool showsPreview() const { return m_showsPreview; }

    void setShowsPreview(bool isShown);

    /// Left of the countdown.
    int countdown() const { return m_countdown; }

    /// Where the next photo is to be taken; nothing once all are there.
    const std::optional<store::StationRecord>& next() const { return m_next; }

    /// "Rail 3, stop 5".
    QString nextText() const;
    /// What to do to get there: roll on, or lay the rail, with tape distances.
    QString wayText() const;

    int stationsLeft() const { return static_cast<int>(m_missing.size()); }

    int stations() const { return m_session ? static_cast<int>(m_session->state().stations.size()) : 0; }

    /// With tasks of the network aside: how long the rest will take.
    std::chrono::duration<double> timeLeft() const;

    std::optional<double> photosAMinute() const { return m_pace.photosAMinute(); }

    const std::optional<CameraStatus>& camera() const { return m_status; }

    /// Of the latest shot, and what is to be said of it, or of what went wrong.
    Verdict verdict() const { return m_verdict; }

    QString sentence() const { return m_sentence; }

    /// Stations to be taken although they have a photo, in walking order.
    std::vector<store::StationRecord> again() const;
    void setAgain(std::int64_t station, bool isAgain);

    bool isAgain(std::int64_t station) const { return m_again.contains(station); }

  signals:
    void changed();
    void verdictGiven(spherewalk::ui::Verdict verdict);
    void countdownTicked(int secondsLeft);
    /// The run has ended; all stations have a photo, or not.
    void runEnded(bool isComplete);

  private:
    void setState(State state);
    void followWithPreview();
    void markRails();
    void read();
    void connectAgain(const camera::Endpoint& endpoint);
    void connected(const CameraStatus& status);
    void connectingEnded(const Task* task);
    void failed(const QString& sentence);
    void shoot();
    void tick();
    DeskEvents events();
    void ended(const store::StationRecord& station, Verdict verdict, bool isThere, const QString& sentence);
    void runDone(const Task* task);
    jobs::CaptureSurveyOptions captureOptions() const;

    double timeScale() const { return m_isPractice ? m_practiceSettings.timeScale : 1; }

    TaskList& m_tasks;
    QPointer<SurveySession> m_session;
    State m_state = State::NoCamera;
    State m_beforeHiding = State::AtStation;
    QPointer<Task> m_task;
    int m_run = 0; ///< how many have ended
    camera::Endpoint m_endpoint;
    PracticeSettings m_practiceSettings;
    std::unique_ptr<PracticeHost> m_practice;
    bool m_isPractice = false;
    bool m_isAutomatic = false;
    CameraLogin m_login;
    bool m_connectsAgain = false;
    PreviewFeed m_preview;
    bool m_showsPreview = false;
    bool m_isPreviewing = false;
    std::shared_ptr<ShutterKey> m_key = std::make_shared<ShutterKey>();
    QTimer m_timer;
    int m_hideSeconds = 0;
    int m_countdown = 0;
    std::optional<store::StationRecord> m_next;
    std::optional<store::StationRecord> m_last; ///< where the cart stands, as far as is known
    std::vector<store::StationRecord> m_missing;
    std::set<std::int64_t> m_again;
    std::vector<survey::RailMark> m_rails;
    Pace m_pace;
    std::optional<CameraStatus> m_status;
    Verdict m_verdict = Verdict::None;
    QString m_sentence;
};

} // namespace spherewalk::ui
