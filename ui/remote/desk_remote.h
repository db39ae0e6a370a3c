// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/survey_session.h"
#include "ui/tasks/background_worker.h"

#include "spherewalk/base/clock.h"

#include <QByteArray>
#include <QJsonObject>
#include <QString>

#include <chrono>
#include <deque>
#include <optional>
#include <utility>

namespace spherewalk::ui {

class CaptureDesk;

/// A capture desk as a person far from the window sees it and works it, over a network that may lose, repeat
/// and delay what is sent. Each press is one photo at most. Threads: the GUI thread.
class DeskRemote : public QObject {
    Q_OBJECT

  public:
    /// What a press asks for.
    enum class Wish {
        Shoot,     ///< What the window's key does now.
        TakeAgain, ///< The photo that was shown is taken again, before what comes next.
    };

    struct Press {
        QString id; ///< A press that comes again by the network has the same one.
        /// The "turn" of the state that the person saw, or its "photo" for TakeAgain.
        qint64 about = 0;
        qint64 seen = 0; ///< The "seen" of that state.
    };

    struct Answer {
        bool isDone = false;
        QString sentence; ///< Says why nothing was done; otherwise empty.
    };

    /// A press about a state that was sent longer ago than this is refused, as it was delayed on its way.
    static constexpr std::chrono::seconds kLate{10};

    /// Owner: desk and clock outlive this.
    DeskRemote(CaptureDesk& desk, const Clock& clock, QObject* parent = nullptr);

    /// Returns what the page shows.
    QJsonObject state();
    Answer press(Wish wish, const Press& press);

    /// Returns the photo whose number state() has under "photo", small, as JPEG; empty as long as there is
    /// none.
    const QByteArray& photo() const { return m_photo; }

  signals:
    /// photo() is another one.
    void photoReady();

  private:
    /// What the desk waits for; presses for another one are refused.
    struct Step {
        const SurveySession* survey = nullptr;
        int state = 0;
        std::int64_t station = 0;

        bool operator==(const Step&) const = default;
    };

    void follow();
    void note(const store::StationRecord& station);
    void readPhoto(std::int64_t station);
    void runEnded();
    bool canTakeAgain() const;
    bool isLate(const Press& press) const;
    Answer apply(Wish wish, const Press& press);
    void takeAgain();
    QJsonObject latest() const;
    qint64 now() const;

    CaptureDesk& m_desk;
    const Clock& m_clock;
    Step m_step;
    qint64 m_turn = 1;
    std::deque<std::pair<QString, Answer>> m_answers; ///< Those of the latest presses, by id.
    const SurveySession* m_survey = nullptr;          ///< The survey of what follows.
    std::optional<store::StationRecord> m_shooting;   ///< Its result is not known yet.
    std::optional<store::StationRecord> m_latest;     ///< Its result is known.
    std::optional<survey::Quality> m_quality;
    QString m_words;
    qint64 m_photoNumber = 0;
    QByteArray m_photo;
    bool m_startsAgain = false; ///< The run is stopping to take m_latest again.
    BackgroundWorker m_worker;  ///< The last member, as its results use the others.
};

} // namespace spherewalk::ui
