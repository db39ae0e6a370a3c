// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/capture_run.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/camera/shot_settler.h"
#include "spherewalk/jobs/judge_survey.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <utility>

namespace spherewalk::jobs {

namespace {

double seconds(Clock::Duration duration) {
    return std::chrono::duration<double>(duration).count();
}

/// Says how many of the missing photos fit on the survey's disk, unless all do. Photos are expected to be as
/// large as those of the survey, or as those of a Theta V.
std::vector<std::string> lookAtDisk(const store::SurveyStore& survey) {
    constexpr double kUsualBytes = 5e6;
    std::error_code failure;
    const auto space = std::filesystem::space(survey.photoFolder(), failure);
    const std::vector<store::PhotoRecord> photos = survey.keptPhotos();
    const std::size_t missing = survey.stationsWithoutPhoto().size();
    double bytes = photos.empty() ? kUsualBytes : 0;
    for (const store::PhotoRecord& photo : photos) {
        bytes += static_cast<double>(photo.sizeBytes) / static_cast<double>(photos.size());
    }
    const double fit = std::floor(static_cast<double>(space.available) / bytes);
    if (failure || fit >= static_cast<double>(missing)) {
        return {};
    }
    return {text("The survey's disk has room for about ", fixed(fit, 0), " of the ", missing,
                 " photos that are still to be taken; make space before you go on.")};
}

} // namespace

CaptureRun::CaptureRun(SharedStore& store, camera::OscClient& client, Operator& people, Clock& clock,
                       const camera::CaptureOptions& options, ProgressSink& progress,
                       const std::stop_token& stop, PlaceFinder* finder)
    : m_store(store),
      m_people(people),
      m_clock(clock),
      m_progress(progress),
      m_callersStop(stop, [this] { m_end.request_stop(); }),
      m_journal(store, StoreJournal::View::All),
      m_capture(client, m_journal, clock, options),
      m_begin(clock.now()),
      m_judge(store),
      m_finder(finder),
      m_fetchersClient(client.another()) {
    const std::vector<survey::Shot> open =
        store.use([](const store::SurveyStore& survey) { return survey.openShots(); });
    m_lastEarlierShot = open.empty() ? 0 : open.back().id;
    PhotoFetcher::Events events;
    events.ended = [this](const camera::ShotOutcome& outcome) { account(outcome); };
    events.failed = [this] { m_end.request_stop(); };
    m_camera = m_capture.connect(m_stop);
    m_fetcher = std::make_unique<PhotoFetcher>(store, *m_fetchersClient, clock, options, std::move(events));
}

void CaptureRun::begin() {
    // What an earlier run has taken comes in first: what cannot is taken again along the route.
    for (const camera::ShotOutcome& outcome : m_capture.settle(m_stop)) {
        account(outcome);
    }
    judgeFetched();
    m_fetcher->wake();
}

/// An earlier run may have been stopped after it fetched a photo and before it judged it.
void CaptureRun::judgeFetched() {
    const std::vector<store::PhotoRecord> unjudged = m_store.use([](const store::SurveyStore& survey) {
        std::vector<store::PhotoRecord> photos = survey.keptPhotos();
        std::erase_if(photos, [&](const store::PhotoRecord& photo) {
            return survey.verdict(photo.id).has_value() || !survey.shotOf(photo.id);
        });
        return photos;
    });
    for (const store::PhotoRecord& photo : unjudged) {
        const photo::Verdict verdict = m_judge.judge(photo.id, m_stop);
        const store::StationRecord station =
            m_store.use([&](const store::SurveyStore& survey) { return survey.station(photo.station); });
        const std::scoped_lock lock(m_mutex);
        tellIfFlawed(station.name, verdict);
        correctEarly();
    }
}

/// Range: while m_mutex is held.
void CaptureRun::tellIfFlawed(const std::string& station, const photo::Verdict& verdict) {
    if (verdict.quality() != survey::Quality::Good) {
        m_progress.warning(text(station, " is ", name(verdict.quality()), ": ", verdict.sentence()));
        m_report.flawed.push_back({station, verdict});
    }
}

bool CaptureRun::isOnItsWay(std::int64_t station) const {
    const std::scoped_lock lock(m_mutex);
    return m_store.use([&](const store::SurveyStore& survey) {
        return std::ranges::any_of(survey.openShots(), [&](const survey::Shot& shot) {
            return shot.station == station && shot.step == survey::ShotStep::Taken &&
                   !m_unfetched.contains(shot.id);
        });
    });
}

photo::Verdict CaptureRun::verdictOn(std::int64_t photo) {
    const auto record = m_store.use([&](const store::SurveyStore& survey) { return survey.verdict(photo); });
    return record ? verdictOf(*record) : m_judge.judge(photo, m_stop);
}

void CaptureRun::take(Route& route) {
    try {
        prepareAndTake(route);
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::Stopped) {
            m_fetcher->throwIfFailed(); // that is why
        }
        throw;
    }
}

/// However it ends, the camera may sleep again.
void CaptureRun::prepareAndTake(Route& route) {
    try {
        camera::CameraReadiness readiness = m_capture.prepare(m_stop);
        readiness.warnings = sentences(readiness);
        std::ranges::move(m_store.use(lookAtDisk), std::back_inserter(readiness.warnings));
        warn(readiness.warnings);
        m_people.cameraReady(m_camera, readiness);
        takeAndFetch(route);
    } catch (...) {
        m_fetcher->stopSoon();
        constexpr std::chrono::milliseconds kHurry(150); // a stop must not take longer than 200
        if (!m_capture.disconnectWithin(kHurry)) {
            m_progress.warning("The camera could not be told that it may sleep again; switch it off and "
                               "on if it is not used soon.");
        }
        throw;
    }
    warn(m_capture.disconnect(m_stop));
}

void CaptureRun::takeAndFetch(Route& route) {
    try {
        takeAlong(route);
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::Stopped && !m_stop.stop_requested()) {
            m_fetcher->finish(m_stop); // the operator has left, and nobody is in a hurry
        }
        throw;
    }
    m_fetcher->finish(m_stop);
}

void CaptureRun::takeAlong(Route& route) {
    const Clock::TimePoint first = m_clock.now();
    for (;;) {
        throwIfStopped(m_stop);
        const Clock::TimePoint before = m_clock.now();
        const auto station = route.next(m_stop);
        if (!station) {
            return;
        }
        const Clock::TimePoint there = m_clock.now();
        const camera::ShotOutcome outcome = expose(*station);
        {
            const std::scoped_lock lock(m_mutex);
            m_report.secondsMoving += seconds(there - before);
            m_report.secondsExposing += seconds(outcome.exposing);
            m_report.secondsAtStations = seconds(m_clock.now() - first);
            m_report.exposed += outcome.shot.step == survey::ShotStep::Taken ? 1 : 0;
        }
        if (outcome.shot.step == survey::ShotStep::Taken) {
            m_people.exposed(*station);
            fetchNow(outcome);
        } else {
            account(outcome, outcome.shot.step == survey::ShotStep::NotTaken);
        }
    }
}

/// In the background, unless a later file could be taken for it: that is fetched before anything else is
/// done.
void CaptureRun::fetchNow(const camera::ShotOutcome& exposed) {
    if (!camera::isMarked(exposed.shot.fileUrl)) {
        account(m_capture.fetch(exposed.shot, m_stop));
    }
    m_fetcher->wake();
}

camera::ShotOutcome CaptureRun::expose(const store::StationRecord& station) {
    for (int tries = 1;; ++tries) {
        camera::ShotOutcome outcome = m_capture.expose(station.id, m_stop);
        outcome.warnings = sentences(outcome);
        warn(outcome.warnings);
        {
            const std::scoped_lock lock(m_mutex);
            m_warningsOf[outcome.shot.id] = outcome.warnings;
        }
        if (outcome.shot.step != survey::ShotStep::NotTaken) {
            return outcome;
        }
        warn({text(station.name, ": ", outcome.sentence)}); // a second trigger is never passed over
        if (!m_people.tryAgain(station, outcome, tries, m_stop)) {
            return outcome;
        }
    }
}

/// What the notes say, with the names of the stations that earlier shots belong to.
std::vector<std::string> CaptureRun::sentences(const camera::CaptureNotes& notes) const {
    std::vector<std::string> result;
    for (const camera::EarlierShot& earlier : notes.earlier) {
        const store::StationRecord station =
            m_store.use([&](const store::SurveyStore& survey) { return survey.station(earlier.station); });
        result.push_back(text(station.name, ": ", earlier.sentence));
    }
    result.insert(result.end(), notes.warnings.begin(), notes.warnings.end());
    return result;
}

void CaptureRun::warn(const std::vector<std::string>& sentences) {
    const std::scoped_lock lock(m_mutex);
    for (const std::string& sentence : sentences) {
        m_progress.warning(sentence);
        m_report.warnings.push_back(sentence);
    }
}

/// Of a photo that has come in.
std::optional<photo::Verdict> CaptureRun::judged(const camera::ShotOutcome& outcome) {
    if (outcome.shot.step != survey::ShotStep::Downloaded) {
        return std::nullopt;
    }
    const Clock::TimePoint start = m_clock.now();
    const auto photo =
        m_store.use([&](const store::SurveyStore& survey) { return survey.shot(outcome.shot.id).photo; });
    photo::Verdict verdict = m_judge.judge(photo.value(), m_stop);
    const std::scoped_lock lock(m_mutex);
    m_report.secondsJudging += seconds(m_clock.now() - start);
    m_judged.insert(photo.value());
    correctEarly();
    return verdict;
}

/// Takes back what was said of photos too early. Range: while m_mutex is held.
void CaptureRun::correctEarly() {
    for (const PhotoJudge::Again& again : m_judge.takeAgain()) {
        if (m_judged.contains(again.photo.id)) { // And is counted.
            m_report.notCompared -= !again.before.isCompared && again.verdict.isCompared ? 1 : 0;
            m_report.contentNotCompared -=
                !again.before.isContentCompared && again.verdict.isContentCompared ? 1 : 0;
        }
        if (again.before == again.verdict) {
            continue;
        }
        const std::string station = m_store.use(
            [&](const store::SurveyStore& survey) { return survey.station(again.photo.station).name; });
        std::erase_if(m_report.flawed, [&](const FlawedPhoto& other) { return other.station == station; });
        tellIfFlawed(station, again.verdict);
    }
}

/// From both threads. isTold: the operator knows it already.
void CaptureRun::account(const camera::ShotOutcome& given, bool isTold) {
    const std::optional<photo::Verdict> verdict = judged(given);
    const store::StationRecord station =
        m_store.use([&](const store::SurveyStore& survey) { return survey.station(given.shot.station); });
    const auto newer = m_store.use(
        [&](const store::SurveyStore& survey) { return survey.photoAfter(survey.shot(given.shot.id)); });
    if (verdict && newer) {
        warn({text(station.name, ": an older photo came in; the newer one, ", newer->fileName,
                   ", stays chosen. review --choose takes another.")});
    }
    if (verdict && m_finder != nullptr) {
        m_finder->wake();
    }
    const std::scoped_lock lock(m_mutex);
    camera::ShotOutcome outcome = given;
    if (const auto warnings = m_warningsOf.extract(given.shot.id)) {
        outcome.warnings = warnings.mapped();
    }
    m_people.shotEnded(station, outcome, verdict ? &*verdict : nullptr);
    m_report.secondsFetching += seconds(outcome.fetching);
    std::erase_if(m_report.missed, [&](const MissedStation& other) { return other.station == station.name; });
    if (outcome.shot.step == survey::ShotStep::Taken) {
        m_unfetched.insert(outcome.shot.id);
    }
    if (!verdict) {
        if (!isTold) {
            m_progress.warning(text(station.name, ": ", outcome.sentence,
                                    newer ? text(" The station has a newer photo, ", newer->fileName,
                                                 "; shots --give-up ends this shot.")
                                          : ""));
        }
        if (!newer) {
            m_report.missed.push_back({station.name, outcome.sentence});
        }
        return;
    }
    ++m_report.taken;
    m_report.notCompared += verdict->isCompared ? 0 : 1;
    m_report.contentNotCompared += verdict->isContentCompared ? 0 : 1;
    m_report.resumed += outcome.shot.id <= m_lastEarlierShot ? 1 : 0;
    tellIfFlawed(station.name, *verdict);
}

CaptureSurveyReport CaptureRun::finish() {
    m_fetcher->finish(m_stop);
    m_fetcher.reset();
    const store::Counts counts =
        m_store.use([](const store::SurveyStore& survey) { return survey.counts(); });
    m_report.stations = counts.stations;
    m_report.remaining = counts.stations - counts.stationsWithPhoto;
    m_report.seconds = seconds(m_clock.now() - m_begin);
    return std::move(m_report);
}

} // namespace spherewalk::jobs
