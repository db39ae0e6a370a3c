// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/import_photos.h"

#include "parts/photo_intake.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/polygon.h"
#include "spherewalk/jobs/positions_csv.h"

namespace spherewalk::jobs {

namespace {

constexpr std::uint64_t kLargestPhoto = 1ULL << 30;

std::optional<std::int64_t> nearestStation(const std::vector<store::StationRecord>& stations,
                                           const Eigen::Vector3d& positionM, double toleranceM) {
    std::optional<std::int64_t> nearest;
    double least = toleranceM;
    for (const store::StationRecord& station : stations) {
        const double distance = (station.station.positionM - positionM).norm();
        if (distance <= least) {
            least = distance;
            nearest = station.id;
        }
    }
    return nearest;
}

class Import {
  public:
    Import(store::SurveyStore& store, const ImportOptions& options)
        : m_store(store), m_options(options), m_stations(store.stations()), m_outline(store.room().outline) {}

    void take(const PhotoPosition& position) {
        Arrival arrival = arrivalOf(position);
        if (const auto known = m_store.findPhoto(sha256Hex(arrival.jpeg))) {
            ++m_report.alreadyThere;
            solve(known->id, position);
            return;
        }
        arrival.station = stationFor(position);
        const std::int64_t photo = m_store.addPhoto(takeIn(m_store, arrival));
        ++m_report.imported;
        m_report.outsideOutline += contains(m_outline, position.positionM.head<2>()) ? 0 : 1;
        solve(photo, position);
    }

    ImportReport finish() {
        if (!m_solution.photos.empty()) {
            m_solution.source = "imported";
            m_solution.model = "given";
            m_store.addSolution(m_solution, true);
        }
        return m_report;
    }

  private:
    Arrival arrivalOf(const PhotoPosition& position) const {
        const std::filesystem::path file = m_options.photos / position.file;
        Arrival arrival;
        try {
            arrival.jpeg = readFile(file, kLargestPhoto);
        } catch (const Error& error) {
            throw Error(error.kind(), text("Could not import line ", position.line, " of ",
                                           m_options.positions.string(), ": ", error.sentence()));
        }
        arrival.source = file.string();
        arrival.positionM = position.positionM;
        arrival.cameraFileName = file.filename().string();
        arrival.roomFromPhoto = position.roomFromPhoto;
        return arrival;
    }

    std::int64_t stationFor(const PhotoPosition& position) {
        if (const auto station =
                nearestStation(m_stations, position.positionM, m_options.stationToleranceM)) {
            return *station;
        }
        ++m_report.newStations;
        const std::int64_t station = m_store.addStation(position.positionM);
        m_stations.push_back(m_store.station(station));
        return station;
    }

    void solve(std::int64_t photo, const PhotoPosition& position) {
        if (!position.roomFromPhoto) {
            return;
        }
        store::SolvedPhoto solved;
        solved.photo = photo;
        solved.roomFromPhoto = *position.roomFromPhoto;
        solved.positionM = position.positionM;
        m_solution.photos.push_back(solved);
        ++m_report.withRotation;
    }

    store::SurveyStore& m_store;
    const ImportOptions& m_options;
    std::vector<store::StationRecord> m_stations;
    Polygon m_outline;
    store::NewSolution m_solution;
    ImportReport m_report;
};

} // namespace

ImportReport importPhotos(store::SurveyStore& store, const ImportOptions& options, ProgressSink& progress,
                          const std::stop_token& stop) {
    const std::vector<PhotoPosition> positions = readPositions(options.positions);
    Import import(store, options);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        throwIfStopped(stop);
        progress.progress(static_cast<double>(i) / static_cast<double>(positions.size()),
                          text("Importing photo ", i + 1, " of ", positions.size()));
        import.take(positions[i]);
    }
    const ImportReport report = import.finish();
    if (report.outsideOutline > 0) {
        progress.warning(text(report.outsideOutline,
                              " photos stand outside of the room's outline; check the outline and the "
                              "positions."));
    }
    return report;
}

Json toJson(const ImportReport& report) {
    return {{"imported", report.imported},
            {"already_there", report.alreadyThere},
            {"new_stations", report.newStations},
            {"with_rotation", report.withRotation},
            {"outside_outline", report.outsideOutline}};
}

} // namespace spherewalk::jobs
