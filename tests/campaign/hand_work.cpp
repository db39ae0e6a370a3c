// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand_work.h"

#include "program.h"
#include "verdicts.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/camera/endpoint.h"

#include <algorithm>
#include <utility>

namespace spherewalk::campaign {

namespace fs = std::filesystem;

namespace {

constexpr double kSamePlaceM = 1e-6;

bool isSamePlace(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return (a - b).norm() <= kSamePlaceM;
}

/// The station at the place; nothing if none lies there.
std::optional<store::StationRecord> stationAt(const std::vector<store::StationRecord>& stations,
                                              const Eigen::Vector3d& placeM) {
    const auto found = std::ranges::find_if(stations, [&](const store::StationRecord& station) {
        return isSamePlace(station.station.positionM, placeM);
    });
    return found == stations.end() ? std::nullopt : std::optional(*found);
}

/// A picture's name on the stick: names on cameras repeat.
std::string nameOnStick(const practice::Truth& truth) {
    return truth.sha256.substr(0, 8) + "-" + truth.file;
}

} // namespace

HandWork::HandWork(std::string cli, RunCameras& cameras, test::Random& random, fs::path folder, Json exposure)
    : m_cli(std::move(cli)),
      m_cameras(cameras),
      m_random(random),
      m_stick(folder / "stick"),
      m_exposure(std::move(exposure)) {
    fs::create_directory(m_stick);
}

Answer HandWork::run(const std::vector<std::string>& words) {
    std::vector<std::string> command{m_cli};
    command.insert(command.end(), words.begin(), words.end());
    test::Program program(command);
    const int status = program.wait();
    if (status > 3) {
        m_violations.push_back(text(words[0], " ended with status ", status, ": ", program.errors()));
    }
    return {status, program.output(), program.errors()};
}

bool HandWork::isWrongOnPurpose(const Eigen::Vector3d& saidM, const Eigen::Vector3d& trueM) const {
    return std::ranges::any_of(m_wrong, [&](const auto& wrong) {
        return isSamePlace(wrong.first, saidM) && isSamePlace(wrong.second, trueM);
    });
}

std::vector<practice::Truth> HandWork::picturesOnCameras() const {
    std::vector<practice::Truth> pictures;
    for (const auto& [sha256, truth] : m_cameras.truth()) {
        if (m_cameras.fileOf(truth)) {
            pictures.push_back(truth);
        }
    }
    return pictures;
}

/// Of a station, beside one, or anywhere.
Eigen::Vector3d HandWork::somePlace(const std::vector<store::StationRecord>& stations) {
    const int any = m_random.integer(0, static_cast<int>(stations.size()) - 1);
    const Eigen::Vector3d at = stations[static_cast<std::size_t>(any)].station.positionM;
    return m_random.integer(0, 1) == 0
               ? at
               : Eigen::Vector3d(
                     at + Eigen::Vector3d(m_random.uniform(-0.2, 0.2), m_random.uniform(-0.2, 0.2), 0));
}

fs::path HandWork::writeLines(const std::vector<Line>& lines, bool withRotations) {
    std::string csv = withRotations ? "file,x_m,y_m,z_m,qw,qx,qy,qz\n" : "file,x_m,y_m,z_m\n";
    const auto number = [](double value) { return fixed(value, 17); };
    for (const Line& line : lines) {
        csv += line.file;
        for (const double value : line.positionM) {
            csv += "," + number(value);
        }
        if (withRotations) {
            const Eigen::Quaterniond& q = line.roomFromPhoto;
            csv += text(",", number(q.w()), ",", number(q.x()), ",", number(q.y()), ",", number(q.z()));
        }
        csv += "\n";
    }
    const fs::path file = m_stick / "places.csv";
    writeFile(file, bytesOf(csv));
    return file;
}

void HandWork::importLines(const fs::path& survey, const std::vector<Line>& lines, bool withRotations,
                           bool move) {
    std::vector<std::string> command{"import",      survey.string(),
                                     "--photos",    m_stick.string(),
                                     "--positions", writeLines(lines, withRotations).string()};
    if (move) {
        command.emplace_back("--move");
    }
    const Answer answer = run(command);
    if (answer.status != 0 && answer.errors.empty()) {
        m_violations.push_back("import failed without a word");
    }
}

void HandWork::import(const fs::path& survey) {
    std::vector<practice::Truth> pictures = picturesOnCameras();
    if (pictures.empty()) {
        return;
    }
    ++m_counts["imports"];
    const std::vector<store::StationRecord> stations =
        store::SurveyStore::open(survey, store::Access::Read).stations();
    std::vector<Line> lines;
    const int count = m_random.integer(1, 3);
    for (int i = 0; i < count; ++i) {
        const int any = m_random.integer(0, static_cast<int>(pictures.size()) - 1);
        const practice::Truth& truth = pictures[static_cast<std::size_t>(any)];
        fs::copy_file(*m_cameras.fileOf(truth), m_stick / nameOnStick(truth),
                      fs::copy_options::overwrite_existing);
        const bool isWrong = m_random.integer(0, 3) == 0;
        const Eigen::Vector3d said = isWrong ? somePlace(stations) : truth.nominalPositionM;
        if (isWrong) {
            ++m_counts["wrong lines"];
            noteWrongPlace(said, truth.nominalPositionM);
            if (const auto near = stationAt(stations, said)) {
                noteWrongPlace(near->station.positionM, truth.nominalPositionM);
            }
        }
        lines.push_back({nameOnStick(truth), said, truth.roomFromPhoto.value()});
    }
    if (m_random.integer(0, 3) == 0) {
        writeFile(m_stick / "notes.txt", bytesOf("Today it rained.\n"));
        lines.push_back({"notes.txt", somePlace(stations), Eigen::Quaterniond::Identity()});
    }
    importLines(survey, lines, m_random.integer(0, 1) == 0, m_random.integer(0, 2) == 0);
}

void HandWork::retag(const fs::path& survey) {
    const auto store = store::SurveyStore::open(survey, store::Access::Read);
    const std::vector<store::PhotoRecord> photos = store.photos();
    const std::vector<store::StationRecord> stations = store.stations();
    if (photos.empty()) {
        return;
    }
    ++m_counts["retags"];
    const int which = m_random.integer(0, static_cast<int>(photos.size()) - 1);
    const int where = m_random.integer(0, static_cast<int>(stations.size()) - 1);
    const store::PhotoRecord& photo = photos[static_cast<std::size_t>(which)];
    const store::StationRecord& station = stations[static_cast<std::size_t>(where)];
    const auto truth = m_cameras.truth();
    if (const auto found = truth.find(photo.cameraSha256); found != truth.end()) {
        noteWrongPlace(station.station.positionM, found->second.nominalPositionM);
    }
    retagTo(survey, photo, station);
}

void HandWork::retagTo(const fs::path& survey, const store::PhotoRecord& photo,
                       const store::StationRecord& station) {
    const Answer answer =
        run({"retag", survey.string(), "--photo", photo.fileName, "--station", station.name});
    if (answer.status != 0) {
        m_violations.push_back("retag said: " + answer.errors);
    }
}

void HandWork::align(const fs::path& survey) {
    ++m_counts["alignments"];
    run({"align", survey.string(), "--effort", "draft"});
}

/// Whether the picture that the shot waits for lies on a camera, was taken there, and as it should be.
bool HandWork::isOfStation(const survey::Shot& shot, const Eigen::Vector3d& placeM) const {
    if (shot.fileUrl.empty()) {
        return false;
    }
    const std::string path = camera::pathOfUrl(shot.fileUrl.substr(0, shot.fileUrl.find('#')));
    const auto pictures = picturesOnCameras();
    return std::ranges::any_of(pictures, [&](const practice::Truth& truth) {
        return truth.urlPath == path && isSamePlace(truth.nominalPositionM, placeM) &&
               exposureDifference(m_exposure, truth).empty();
    });
}

void HandWork::giveUp(const fs::path& survey, const survey::Shot& shot, const std::string& station,
                      const std::string& said) {
    const std::string number = std::to_string(shot.id);
    if (said.find("--give-up " + number) == std::string::npos) {
        m_violations.push_back(text("no way out is named for shot ", number, " at ", station, ": ", said));
    }
    ++m_counts["shots given up"];
    ++m_givenUp[station];
    run({"shots", survey.string(), "--give-up", number});
}

void HandWork::decide(const fs::path& survey, bool isLast) {
    const std::string said = run({"shots", survey.string()}).output;
    std::vector<std::pair<survey::Shot, store::StationRecord>> shots;
    {
        const auto store = store::SurveyStore::open(survey, store::Access::Read);
        for (const auto& list : {store.unclearShots(), store.openShots()}) {
            for (const survey::Shot& shot : list) {
                shots.emplace_back(shot, store.station(shot.station));
            }
        }
    }
    for (const auto& [shot, station] : shots) {
        const std::string number = std::to_string(shot.id);
        const bool isUnclear = shot.step == survey::ShotStep::Unclear;
        const bool canConfirm = said.find("--confirm " + number) != std::string::npos;
        if (isUnclear && canConfirm && !isLast && isOfStation(shot, station.station.positionM)) {
            ++m_counts["shots confirmed"];
            run({"shots", survey.string(), "--confirm", number});
        } else if (isUnclear || isLast) {
            giveUp(survey, shot, station.name, said);
        }
    }
}

void HandWork::correct(const fs::path& survey) {
    const auto truths = m_cameras.truth();
    std::vector<store::PhotoRecord> photos;
    std::vector<store::StationRecord> stations;
    {
        const auto store = store::SurveyStore::open(survey, store::Access::Read);
        photos = store.photos();
        stations = store.stations();
    }
    for (const store::PhotoRecord& photo : photos) {
        const auto found = truths.find(photo.cameraSha256);
        if (found == truths.end() || isSamePlace(photo.positionM, found->second.nominalPositionM)) {
            continue;
        }
        const practice::Truth& truth = found->second;
        if (!isWrongOnPurpose(photo.positionM, truth.nominalPositionM)) {
            continue; // the program's own error is not covered up
        }
        ++m_counts["corrections"];
        if (const auto station = stationAt(stations, truth.nominalPositionM)) {
            retagTo(survey, photo, *station);
        } else if (fs::exists(m_stick / nameOnStick(truth))) {
            importLines(survey, {{nameOnStick(truth), truth.nominalPositionM, *truth.roomFromPhoto}}, false,
                        true);
        }
    }
}

} // namespace spherewalk::campaign
