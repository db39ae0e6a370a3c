// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/capture_survey.h"

#include "capture/capture_run.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/photo/integrity.h"

#include <algorithm>
#include <iterator>
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

/// Wherever the operator stands. Each photo gets a station whose place nobody knows yet.
class HandRoute : public Route {
  public:
    HandRoute(SharedStore& store, Operator& people, int most)
        : m_store(store), m_people(people), m_most(most) {}

    std::optional<store::StationRecord> next(const std::stop_token& stop) override {
        if ((m_most > 0 && m_taken == m_most) || !m_people.walkOn(m_taken + 1, stop)) {
            return std::nullopt;
        }
        ++m_taken;
        return m_store.use([](store::SurveyStore& store) {
            if (const auto unused = unusedStation(store)) {
                return *unused;
            }
            // A metre apart from the others, so that none takes another's place.
            const std::size_t number = store.stations().size() + 1;
            const Eigen::Vector3d anywhereM(static_cast<double>(number), 0,
                                            store.planOptions().heightsM.front());
            return store.station(store.addStation(anywhereM, text("unknown place ", number), false));
        });
    }

  private:
    /// One whose shot took no picture.
    static std::optional<store::StationRecord> unusedStation(const store::SurveyStore& store) {
        std::vector<survey::Shot> shots = store.openShots();
        std::ranges::move(store.unclearShots(), std::back_inserter(shots));
        for (store::StationRecord& station : store.stations()) {
            const bool isAwaited =
                std::ranges::find(shots, station.id, &survey::Shot::station) != shots.end();
            if (!station.isPlaceKnown && !isAwaited && store.photosAt(station.id).empty()) {
                return std::move(station);
            }
        }
        return std::nullopt;
    }

    SharedStore& m_store;
    Operator& m_people;
    int m_most;
    int m_taken = 0;
};

/// In walking order. Nobody can go back to an unknown place.
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
    std::erase_if(result, [&](const store::StationRecord& station) {
        return !wanted.contains(station.id) || !station.isPlaceKnown;
    });
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
    std::optional<PlaceFinder> finder;
    if (options.byHand) {
        finder.emplace(shared, people);
    }
    CaptureRun run(shared, client, people, clock, options.camera, progress, stop,
                   finder ? &*finder : nullptr);
    run.begin();
    const auto stations =
        shared.use([&](const store::SurveyStore& survey) { return stationsToTake(survey, options); });
    if (options.byHand) {
        HandRoute route(shared, people, options.most);
        run.take(route);
    } else if (!stations.empty()) {
        ListedRoute route(stations, people, progress);
        run.take(route);
    }
    CaptureSurveyReport report = run.finish();
    if (finder) {
        report.places = finder->finish(stop);
    }
    return report;
}

bool isByHand(const store::SurveyStore& store) {
    return store.plan().placements.empty() && stationsToTake(store, {}).empty();
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
    Json json = {{"taken", report.taken},
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
    if (report.places) {
        json["places"] = {{"photos", report.places->photos},
                          {"placed", report.places->placed.size()},
                          {"unplaced", report.places->unplaced}};
    }
    return json;
}

Json PracticeOperator::ask(const std::string& path, const Json& body, const std::stop_token& stop) {
    m_clock.sleep(m_moveTime, stop);
    throwIfStopped(stop);
    const camera::HttpResponse response = m_http.post(path, body.dump(), stop);
    if (response.status != 200) {
        throw Error(ErrorKind::Unsupported,
                    text("The camera at ", m_http.endpoint().name(),
                         " is no practice camera: it cannot be moved by itself. Leave --practice out "
                         "and bring it to each station."));
    }
    return parseJson(response.body, "the practice camera's answer");
}

void PracticeOperator::moveTo(const store::StationRecord& station, const std::stop_token& stop) {
    const Eigen::Vector3d& p = station.station.positionM;
    ask("/practice/pose", {{"x", p.x()}, {"y", p.y()}, {"z", p.z()}}, stop);
}

bool PracticeOperator::walkOn(int /*photo*/, const std::stop_token& stop) {
    const Json answer = ask("/practice/walk", Json::object(), stop);
    return JsonReader(answer, "the practice camera's answer").boolean("moved");
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
