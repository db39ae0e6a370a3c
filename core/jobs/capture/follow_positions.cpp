// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/follow_positions.h"

#include "capture/capture_run.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <sstream>

namespace spherewalk::jobs {

namespace {

constexpr std::size_t kLongestLine = 4096;

[[noreturn]] void refuseLine(std::string_view line) {
    throw Error(ErrorKind::InvalidInput, text("\"", printable(line),
                                              "\" is no position; send \"x y z\" in metres, or a JSON object "
                                              "with x, y and z."));
}

ReachedPosition fromJson(std::string_view line) {
    const Json json = parseJson(line, "the position", {kLongestLine, 4});
    const JsonReader reader(json, "the position");
    return {{reader.number("x"), reader.number("y"), reader.number("z")},
            !reader.isAbsent("again") && reader.boolean("again")};
}

ReachedPosition fromWords(std::string_view line) {
    std::istringstream words{std::string(line)};
    ReachedPosition reached;
    std::string word;
    for (double& coordinate : reached.positionM) {
        words >> word;
        const auto number = words ? parseNumber(word) : std::nullopt;
        if (!number) {
            refuseLine(line);
        }
        coordinate = *number;
    }
    if (words >> word) {
        reached.again = word == "again";
        if (!reached.again || words >> word) {
            refuseLine(line);
        }
    }
    return reached;
}

std::string positionText(const Eigen::Vector3d& p) {
    return text("(", fixed(p.x(), 3), ", ", fixed(p.y(), 3), ", ", fixed(p.z(), 3), ")");
}

/// Tells a robot what becomes of its lines.
class Robot : public Operator {
  public:
    explicit Robot(const FollowLink& link) : m_link(link) {}

    void tell(const FollowEvent& event) {
        const std::scoped_lock lock(m_mutex);
        m_link.tell(event);
    }

    void moveTo(const store::StationRecord& /*station*/, const std::stop_token& /*stop*/) override {}

    bool tryAgain(const store::StationRecord& /*station*/, const camera::ShotOutcome& /*outcome*/, int tries,
                  const std::stop_token& /*stop*/) override {
        constexpr int kMostTries = 3;
        return tries < kMostTries;
    }

    /// The camera stands at the station, and will be exposed next.
    void reach(std::int64_t station) { m_exposing = station; }

    void exposed(const store::StationRecord& station) override {
        refuseEarlyLines(station);
        tell({FollowEvent::Kind::Exposed, station.name, {}, {}});
    }

    void shotEnded(const store::StationRecord& station, const camera::ShotOutcome& outcome,
                   const photo::Verdict* verdict) override {
        if (verdict != nullptr) {
            tell({FollowEvent::Kind::Verdict, station.name, std::string(name(verdict->quality())),
                  verdict->sentence()});
        } else {
            if (m_exposing == station.id) {
                refuseEarlyLines(station);
            }
            tell({FollowEvent::Kind::Missed, station.name, {}, outcome.sentence});
        }
    }

  private:
    /// Before the robot hears that it may move.
    void refuseEarlyLines(const store::StationRecord& station) {
        m_exposing = 0;
        for (const std::string& line : m_link.waitingLines ? m_link.waitingLines() : kNoLines) {
            tell({FollowEvent::Kind::Refused,
                  {},
                  {},
                  text("\"", printable(line), "\" arrived before the exposure at ", station.name,
                       " was over; send a position when the camera stands there, after the answer to the one "
                       "before.")});
        }
    }

    static inline const std::vector<std::string> kNoLines;
    const FollowLink& m_link;
    std::mutex m_mutex;
    std::atomic<std::int64_t> m_exposing{0}; ///< Station whose exposure is not answered yet; 0 for none.
};

/// The stations whose positions arrive.
class FollowedRoute : public Route {
  public:
    FollowedRoute(SharedStore& store, CaptureRun& run, const FollowLink& link, Robot& robot,
                  double toleranceM)
        : m_store(store), m_run(run), m_link(link), m_robot(robot), m_toleranceM(toleranceM) {}

    std::optional<store::StationRecord> next(const std::stop_token& stop) override {
        while (const auto line = m_link.nextLine(stop)) {
            try {
                const ReachedPosition reached = parseReachedPosition(*line);
                const store::StationRecord station = stationAt(reached.positionM);
                if (!reached.again && isAnswered(station)) {
                    continue;
                }
                if (m_link.reached) {
                    m_link.reached(station, stop);
                }
                m_robot.reach(station.id);
                return station;
            } catch (const Error& error) {
                if (error.kind() != ErrorKind::InvalidInput && error.kind() != ErrorKind::NotFound) {
                    throw;
                }
                m_robot.tell({FollowEvent::Kind::Refused, {}, {}, error.sentence()});
            }
        }
        return std::nullopt;
    }

  private:
    store::StationRecord stationAt(const Eigen::Vector3d& at) const {
        const auto stations = m_store.use([](const store::SurveyStore& store) { return store.stations(); });
        const auto distance = [&](const store::StationRecord& station) {
            return (station.station.positionM - at).norm();
        };
        const auto nearest = std::ranges::min_element(stations, {}, distance);
        if (nearest == stations.end()) {
            throw Error(ErrorKind::NotFound, "The survey has no stations; plan it first.");
        }
        if (distance(*nearest) > m_toleranceM) {
            throw Error(ErrorKind::NotFound, text("No station lies within ", fixed(m_toleranceM, 3), " m of ",
                                                  positionText(at), "; the nearest is ", nearest->name,
                                                  " at ", positionText(nearest->station.positionM), ", ",
                                                  fixed(distance(*nearest), 3), " m away."));
        }
        return *nearest;
    }

    /// Tells the verdict on the photo that the station has already. False without one.
    bool isAnswered(const store::StationRecord& station) {
        if (m_run.isOnItsWay(station.id)) {
            m_robot.tell({FollowEvent::Kind::Exposed, station.name, {}, "Its photo has been taken already."});
            return true;
        }
        const auto photo = m_store.use([&](const store::SurveyStore& store) -> std::optional<std::int64_t> {
            const auto chosen = store.chosenPhoto(station.id);
            const bool isKept = chosen && store.review(chosen->id).decision != store::Decision::Rejected;
            return isKept ? std::optional(chosen->id) : std::nullopt;
        });
        if (!photo) {
            return false;
        }
        const photo::Verdict verdict = m_run.verdictOn(*photo);
        m_robot.tell(
            {FollowEvent::Kind::Verdict, station.name, std::string(name(verdict.quality())),
             text("It has a photo already.", verdict.findings.empty() ? "" : " ", verdict.sentence())});
        return true;
    }

    SharedStore& m_store;
    CaptureRun& m_run;
    const FollowLink& m_link;
    Robot& m_robot;
    double m_toleranceM;
};

constexpr EnumNames<FollowEvent::Kind, 4> kKinds{{{FollowEvent::Kind::Refused, "refused"},
                                                  {FollowEvent::Kind::Exposed, "exposed"},
                                                  {FollowEvent::Kind::Verdict, "verdict"},
                                                  {FollowEvent::Kind::Missed, "missed"}}};

} // namespace

ReachedPosition parseReachedPosition(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string_view::npos || line.size() > kLongestLine) {
        refuseLine(line);
    }
    try {
        const ReachedPosition reached = line[first] == '{' ? fromJson(line) : fromWords(line);
        constexpr double kFarthestM = 1e8;
        if (reached.positionM.cwiseAbs().maxCoeff() > kFarthestM) {
            refuseLine(line);
        }
        return reached;
    } catch (const Error& error) {
        throw Error(ErrorKind::InvalidInput, error.sentence(), error.context());
    }
}

std::string line(const FollowEvent& event) {
    const bool isVerdict = event.kind == FollowEvent::Kind::Verdict;
    return text(isVerdict ? event.verdict : std::string(nameOf(kKinds, event.kind)),
                event.station.empty() ? "" : " ", event.station, event.sentence.empty() ? "" : ": ",
                event.sentence);
}

Json toJson(const FollowEvent& event) {
    Json json{{"event", nameOf(kKinds, event.kind)}};
    if (!event.station.empty()) {
        json["station"] = event.station;
    }
    if (event.kind == FollowEvent::Kind::Verdict) {
        json["verdict"] = event.verdict;
    }
    if (!event.sentence.empty()) {
        json["sentence"] = event.sentence;
    }
    return json;
}

void FollowOptions::validate() const {
    camera.validate();
    if (!(toleranceM > 0 && toleranceM <= 1)) {
        throw Error(ErrorKind::InvalidInput, "The tolerance must lie above 0 and at most 1 m.");
    }
}

CaptureSurveyReport followPositions(store::SurveyStore& store, camera::OscClient& client,
                                    const FollowLink& link, Clock& clock, FollowOptions options,
                                    ProgressSink& progress, const std::stop_token& stop) {
    options.camera.download.check = photoCheck();
    options.camera.profile = store.captureProfile();
    options.validate();
    SharedStore shared(store);
    Robot robot(link);
    CaptureRun run(shared, client, robot, clock, options.camera, progress, stop);
    run.begin();
    FollowedRoute route(shared, run, link, robot, options.toleranceM);
    run.take(route);
    return run.finish();
}

} // namespace spherewalk::jobs
