// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/capture_survey.h"

#include "capture/capture_run.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/photo/integrity.h"

#include <algorithm>
#include <set>
#include <utility>

namespace spherewalk::jobs {

namespace {

/// Stations one after the other, to each of which the operator brings the camera.
class ListedRoute : public Route {
  public:
    ListedRoute(std::vector<store::StationRecord> stations, Operator& people, ProgressSink& progress)
        : m_stations(std::move(stations)), m_people(people), m_progress(progress) {}

    std::optional<store::StationRecord> next(const std::stop_token& stop) override {
        if (m_done == m_stations.size()) {
            return std::nullopt;
        }
        const store::StationRecord& station = m_stations[m_done];
        m_progress.progress(static_cast<double>(m_done) / static_cast<double>(m_stations.size()),
                            text("Photo ", m_done + 1, " of ", m_stations.size(), ", ", station.name));
        ++m_done;
        m_people.moveTo(station, stop);
        return station;
    }

  private:
    std::vector<store::StationRecord> m_stations;
    Operator& m_people;
    ProgressSink& m_progress;
    std::size_t m_done = 0;
};

/// In walking order.
std::vector<store::StationRecord> stationsToTake(const store::SurveyStore& store,
                                                 const CaptureSurveyOptions& options) {
    std::set<std::int64_t> wanted;
    for (const std::int64_t id : options.again) {
        wanted.insert(store.station(id).id);
    }
    for (const store::StationRecord& missing : store.stationsWithoutPhoto()) {
        wanted.insert(missing.id);
    }
    std::vector<store::StationRecord> result = store.stations();
    std::erase_if(result, [&](const store::StationRecord& station) { return !wanted.contains(station.id); });
    if (options.most > 0 && result.size() > static_cast<std::size_t>(options.most)) {
        result.resize(static_cast<std::size_t>(options.most));
    }
    return result;
}

} // namespace

CaptureSurveyReport captureSurvey(store::SurveyStore& store, camera::OscClient& client, Operator& people,
                                  Clock& clock, CaptureSurveyOptions options, ProgressSink& progress,
                                  const std::stop_token& stop) {
    options.camera.download.check = photoCheck();
    options.camera.profile = store.captureProfile();
    SharedStore shared(store);
    CaptureRun run(shared, client, people, clock, options.camera, progress, stop);
    run.begin();
    auto stations =
        shared.use([&](const store::SurveyStore& survey) { return stationsToTake(survey, options); });
    if (!stations.empty()) {
        ListedRoute route(std::move(stations), people, progress);
        run.take(route);
    }
    return run.finish();
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
    Json flawed = Json::array();
    for (const FlawedPhoto& photo : report.flawed) {
        flawed.push_back({{"station", photo.station},
                          {"verdict", name(photo.verdict.quality())},
                          {"sentence", photo.verdict.sentence()}});
    }
    const double minutes = report.secondsAtStations / 60;
    const int own = std::max(1, report.exposed);
    const double software = report.secondsAtStations - report.secondsMoving - report.secondsExposing;
    return {{"taken", report.taken},
            {"resumed", report.resumed},
            {"exposed", report.exposed},
            {"stations", report.stations},
            {"remaining", report.remaining},
            {"missed", missed},
            {"flawed", flawed},
            {"not_compared", report.notCompared},
            {"content_not_compared", report.contentNotCompared},
            {"warnings", report.warnings},
            {"seconds", report.seconds},
            {"seconds_at_stations", report.secondsAtStations},
            {"seconds_moving", report.secondsMoving},
            {"seconds_exposing", report.secondsExposing},
            {"seconds_fetching", report.secondsFetching},
            {"seconds_judging", report.secondsJudging},
            {"photos_per_minute", minutes > 0 ? report.exposed / minutes : 0},
            {"software_seconds_per_photo", software / own}};
}

void PracticeOperator::moveTo(const store::StationRecord& station, const std::stop_token& stop) {
    m_clock.sleep(m_moveTime, stop);
    throwIfStopped(stop);
    const Eigen::Vector3d& p = station.station.positionM;
    const Json pose = {{"x", p.x()}, {"y", p.y()}, {"z", p.z()}};
    const camera::HttpResponse response = m_http.post("/practice/pose", pose.dump(), stop);
    if (response.status != 200) {
        throw Error(ErrorKind::Unsupported,
                    text("The camera at ", m_http.endpoint().name(),
                         " is no practice camera: it cannot be moved by itself. Leave --practice out "
                         "and bring it to each station."));
    }
}

bool PracticeOperator::tryAgain(const store::StationRecord& /*station*/,
                                const camera::ShotOutcome& /*outcome*/, int tries,
                                const std::stop_token& /*stop*/) {
    constexpr int kMostTries = 3;
    return tries < kMostTries;
}

CaptureSurveyOptions practiceCaptureOptions(double timeScale) {
    using namespace std::chrono_literals;
    CaptureSurveyOptions options{camera::CaptureOptions{}.scaled(timeScale)};
    options.camera.allowance.base = std::max<std::chrono::milliseconds>(options.camera.allowance.base, 10s);
    options.camera.idleTime = std::max<std::chrono::milliseconds>(options.camera.idleTime, 60s);
    return options;
}

} // namespace spherewalk::jobs
