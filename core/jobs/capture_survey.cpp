// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/capture_survey.h"

#include "store_journal.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/photo/integrity.h"

#include <algorithm>
#include <set>
#include <utility>

namespace spherewalk::jobs {

namespace {

double seconds(Clock::Duration duration) {
    return std::chrono::duration<double>(duration).count();
}

/// One run over the missing stations.
class Run {
  public:
    Run(store::SurveyStore& store, camera::OscClient& client, Operator& people, Clock& clock,
        const CaptureSurveyOptions& options, ProgressSink& progress, const std::stop_token& stop)
        : m_store(store),
          m_people(people),
          m_clock(clock),
          m_progress(progress),
          m_stop(stop),
          m_journal(store),
          m_capture(client, m_journal, clock, options.camera),
          m_most(options.most),
          m_again(options.again) {}

    CaptureSurveyReport run() {
        const Clock::TimePoint begin = m_clock.now();
        const camera::CameraInfo camera = m_capture.connect(m_stop);
        settle();
        if (const auto stations = stationsToTake(); !stations.empty()) {
            takeAll(camera, stations);
        }
        const store::Counts counts = m_store.counts();
        m_report.stations = counts.stations;
        m_report.remaining = counts.stations - counts.stationsWithPhoto;
        m_report.seconds = seconds(m_clock.now() - begin);
        return std::move(m_report);
    }

  private:
    /// However it ends, the camera may sleep again.
    void takeAll(const camera::CameraInfo& camera, const std::vector<store::StationRecord>& stations) {
        try {
            const camera::CameraReadiness readiness = m_capture.prepare(m_stop);
            warn(readiness.warnings);
            m_people.cameraReady(camera, readiness);
            take(stations);
            settle(); // what was taken but could not be downloaded at once
        } catch (...) {
            constexpr std::chrono::milliseconds kHurry(150); // a stop must not take longer than 200
            if (!m_capture.disconnectWithin(kHurry)) {
                m_progress.warning("The camera could not be told that it may sleep again; switch it off and "
                                   "on if it is not used soon.");
            }
            throw;
        }
        m_capture.disconnect(m_stop);
    }

    void warn(const std::vector<std::string>& sentences) {
        for (const std::string& sentence : sentences) {
            m_progress.warning(sentence);
            m_report.warnings.push_back(sentence);
        }
    }

    void settle() {
        for (const camera::ShotOutcome& outcome : m_capture.settle(m_stop)) {
            m_report.resumed += outcome.shot.step == camera::ShotStep::Downloaded ? 1 : 0;
            account(m_store.station(outcome.shot.station), outcome);
        }
    }

    /// In walking order.
    std::vector<store::StationRecord> stationsToTake() const {
        std::set<std::int64_t> wanted;
        for (const std::int64_t id : m_again) {
            wanted.insert(m_store.station(id).id);
        }
        for (const store::StationRecord& missing : m_store.stationsWithoutPhoto()) {
            wanted.insert(missing.id);
        }
        std::vector<store::StationRecord> result = m_store.stations();
        std::erase_if(result,
                      [&](const store::StationRecord& station) { return !wanted.contains(station.id); });
        if (m_most > 0 && result.size() > static_cast<std::size_t>(m_most)) {
            result.resize(static_cast<std::size_t>(m_most));
        }
        return result;
    }

    void take(const std::vector<store::StationRecord>& stations) {
        std::size_t done = 0;
        for (const store::StationRecord& station : stations) {
            throwIfStopped(m_stop);
            m_progress.progress(static_cast<double>(done) / static_cast<double>(stations.size()),
                                text("Photo ", done + 1, " of ", stations.size(), ", ", station.name));
            ++done;
            const Clock::TimePoint before = m_clock.now();
            m_people.moveTo(station, m_stop);
            m_report.secondsMoving += seconds(m_clock.now() - before);
            account(station, shoot(station));
        }
    }

    camera::ShotOutcome shoot(const store::StationRecord& station) {
        for (int tries = 1;; ++tries) {
            camera::ShotOutcome outcome = m_capture.shoot(station.id, m_stop);
            warn(outcome.warnings);
            const bool again = outcome.shot.step == camera::ShotStep::NotTaken &&
                               m_people.tryAgain(station, outcome, tries, m_stop);
            if (!again) {
                return outcome;
            }
            warn({text(station.name, ": ", outcome.sentence)}); // a second trigger is never passed over
        }
    }

    void account(const store::StationRecord& station, const camera::ShotOutcome& outcome) {
        m_people.shotEnded(station, outcome);
        m_report.secondsExposing += seconds(outcome.exposing);
        m_report.secondsFetching += seconds(outcome.fetching);
        auto& missed = m_report.missed;
        std::erase_if(missed, [&](const MissedStation& other) { return other.station == station.name; });
        if (outcome.shot.step == camera::ShotStep::Downloaded) {
            ++m_report.taken;
            return;
        }
        m_progress.warning(text(station.name, ": ", outcome.sentence));
        missed.push_back({station.name, outcome.sentence});
    }

    store::SurveyStore& m_store;
    Operator& m_people;
    Clock& m_clock;
    ProgressSink& m_progress;
    const std::stop_token& m_stop;
    StoreJournal m_journal;
    camera::Capture m_capture;
    int m_most;
    std::vector<std::int64_t> m_again;
    CaptureSurveyReport m_report;
};

} // namespace

CaptureSurveyReport captureSurvey(store::SurveyStore& store, camera::OscClient& client, Operator& people,
                                  Clock& clock, CaptureSurveyOptions options, ProgressSink& progress,
                                  const std::stop_token& stop) {
    options.camera.download.check = photoCheck();
    options.camera.profile = store.captureProfile();
    return Run(store, client, people, clock, options, progress, stop).run();
}

camera::PhotoCheck photoCheck() {
    return [](const std::filesystem::path& file) {
        const photo::PhotoFacts facts = photo::checkPhotoFile(file);
        return camera::PhotoFacts{facts.width, facts.height};
    };
}

Json toJson(const CaptureSurveyReport& report) {
    Json missed = Json::array();
    for (const MissedStation& station : report.missed) {
        missed.push_back({{"station", station.station}, {"sentence", station.sentence}});
    }
    const double minutes = report.seconds / 60;
    const int own = std::max(1, report.taken);
    return {
        {"taken", report.taken},
        {"resumed", report.resumed},
        {"stations", report.stations},
        {"remaining", report.remaining},
        {"missed", missed},
        {"warnings", report.warnings},
        {"seconds", report.seconds},
        {"seconds_moving", report.secondsMoving},
        {"seconds_exposing", report.secondsExposing},
        {"seconds_fetching", report.secondsFetching},
        {"photos_per_minute", minutes > 0 ? report.taken / minutes : 0},
        {"software_seconds_per_photo",
         (report.seconds - report.secondsMoving - report.secondsExposing - report.secondsFetching) / own}};
}

} // namespace spherewalk::jobs
