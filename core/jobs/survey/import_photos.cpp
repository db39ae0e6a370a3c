// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/import_photos.h"

#include "parts/imported_poses.h"
#include "parts/photo_intake.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/polygon.h"
#include "spherewalk/jobs/positions_csv.h"
#include "spherewalk/jobs/solution_findings.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <utility>

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

/// Whether the error is about one photo, so that others can still be taken in.
bool isOfOnePhoto(ErrorKind kind) {
    return kind == ErrorKind::InvalidInput || kind == ErrorKind::NotFound || kind == ErrorKind::Corrupt ||
           kind == ErrorKind::Unsupported || kind == ErrorKind::Exists;
}

class Import {
  public:
    Import(store::SurveyStore& store, const ImportOptions& options, ProgressSink& progress)
        : m_store(store),
          m_options(options),
          m_progress(progress),
          m_stations(store.stations()),
          m_outline(store.knownRoom().outline) {}

    ~Import() {
        try {
            removeEmptyStations();
        } catch (const Error&) { // an error is on its way already, and an empty station does no harm
        }
    }

    Import(const Import&) = delete;
    Import& operator=(const Import&) = delete;

    void take(const PhotoPosition& position) {
        try {
            takeOne(position);
        } catch (const Error& error) {
            if (!isOfOnePhoto(error.kind())) {
                throw;
            }
            m_firstRefusal = m_firstRefusal ? m_firstRefusal : std::optional(error);
            m_progress.warning(error.sentence());
            m_report.refused.push_back({position.line, position.file, error.sentence()});
        }
    }

    ImportReport finish(const std::stop_token& stop) {
        if (m_firstRefusal && m_report.imported + m_report.alreadyThere + m_report.moved == 0) {
            throw *m_firstRefusal;
        }
        if (!m_moves.empty()) {
            WarningsOnly warnings(m_progress);
            retagPhotos(m_store, m_moves, warnings, stop);
        }
        removeEmptyStations();
        addSolution();
        return std::move(m_report);
    }

  private:
    /// The progress of a part that is too short to be shown.
    class WarningsOnly : public ProgressSink {
      public:
        explicit WarningsOnly(ProgressSink& sink) : m_sink(sink) {}

        void progress(double /*fraction*/, std::string_view /*activity*/) override {}

        void warning(std::string_view sentence) override { m_sink.warning(sentence); }

      private:
        ProgressSink& m_sink;
    };

    bool isPlaced() const { return !m_options.positions.empty(); }

    std::string place(const PhotoPosition& position) const {
        if (!isPlaced()) {
            return (m_options.photos / position.file).string();
        }
        return text("line ", position.line, " of ", m_options.positions.string());
    }

    /// Errors of one photo name the line.
    void takeOne(const PhotoPosition& position) {
        try {
            Arrival arrival = arrivalOf(position);
            if (const auto known = m_store.findPhoto(sha256Hex(arrival.jpeg)); known && !isPlaced()) {
                ++m_report.alreadyThere;
            } else if (!isPlaced()) {
                takeUnplaced(std::move(arrival));
            } else if (known) {
                takeKnown(*known, position);
            } else {
                takeNew(std::move(arrival), position);
            }
        } catch (const Error& error) {
            throw Error(error.kind(), text("Could not import ", place(position), ": ", error.sentence()),
                        error.context());
        }
    }

    Arrival arrivalOf(const PhotoPosition& position) const {
        const std::filesystem::path file = m_options.photos / position.file;
        Arrival arrival;
        arrival.jpeg = readFile(file, kLargestPhoto);
        arrival.source = file.string();
        arrival.positionM = position.positionM;
        arrival.cameraFileName = file.filename().string();
        arrival.roomFromPhoto = position.roomFromPhoto;
        arrival.isPlaced = isPlaced();
        return arrival;
    }

    void takeUnplaced(Arrival arrival) {
        arrival.station =
            m_store.addStation(arrival.positionM, text("unknown place of ", arrival.cameraFileName), false);
        m_added.insert(arrival.station);
        ++m_report.newStations;
        ++m_report.unknownPlaces;
        m_store.addPhoto(takeIn(m_store, arrival));
        ++m_report.imported;
    }

    void takeNew(Arrival arrival, const PhotoPosition& position) {
        arrival.station = stationFor(position.positionM);
        const store::StationRecord station = m_store.station(arrival.station);
        const auto other = m_store.chosenPhoto(station.id);
        const std::int64_t photo = m_store.addPhoto(takeIn(m_store, arrival));
        m_lines.emplace(photo, position);
        ++m_report.imported;
        const bool isInside = m_outline.empty() || contains(m_outline, position.positionM.head<2>());
        m_report.outsideOutline += isInside ? 0 : 1;
        if (other) {
            note(text(position.file, " (line ", position.line, ") and ", other->fileName, " are both at ",
                      station.name, ", and ", position.file,
                      " stands for it. Correct the position of one and import it with --move, or let review "
                      "--choose take the other."));
        }
        solve(photo, position, position.positionM);
    }

    void takeKnown(const store::PhotoRecord& known, const PhotoPosition& position) {
        const auto earlier = m_lines.find(known.id);
        const Eigen::Vector3d there = earlier == m_lines.end() ? known.positionM : earlier->second.positionM;
        const double distance = (there - position.positionM).norm();
        constexpr double kSamePlaceM = 1e-3;
        if (earlier != m_lines.end()) {
            const std::string both = text(position.file, " has the same bytes as ", earlier->second.file,
                                          " in line ", earlier->second.line);
            if (distance > kSamePlaceM) {
                throw Error(ErrorKind::InvalidInput,
                            text(both, ", and a photo cannot be at two places; leave one of the lines out."));
            }
            note(text(both, ": they are one photo."));
        } else if (known.cameraFileName != std::filesystem::path(position.file).filename()) {
            note(text(position.file, " (line ", position.line, ") is in the survey already, as ",
                      known.fileName, "."));
        }
        if (distance <= kSamePlaceM) {
            ++m_report.alreadyThere;
        } else if (m_options.move) {
            m_moves.push_back({known.id, stationFor(position.positionM), position.positionM});
            ++m_report.moved;
        } else {
            throw Error(ErrorKind::InvalidInput,
                        text(position.file, " is in the survey already, as ", known.fileName, " at ",
                             m_store.station(known.station).name, ", ", fixed(distance, 3),
                             " m from the place in the file. Give --move to move it there."));
        }
        m_lines.emplace(known.id, position);
        solve(known.id, position, distance <= kSamePlaceM ? known.positionM : position.positionM);
    }

    std::int64_t stationFor(const Eigen::Vector3d& positionM) {
        if (const auto station = nearestStation(m_stations, positionM, m_options.stationToleranceM)) {
            return *station;
        }
        const std::int64_t station = m_store.addStation(positionM);
        m_added.insert(station);
        m_stations.push_back(m_store.station(station));
        ++m_report.newStations;
        return station;
    }

    /// Those whose photo was refused.
    void removeEmptyStations() {
        for (const std::int64_t station : std::exchange(m_added, {})) {
            if (m_store.photosAt(station).empty()) {
                m_store.removeStation(station);
                --m_report.newStations;
                m_report.unknownPlaces -= isPlaced() ? 0 : 1;
            }
        }
    }

    void note(std::string sentence) {
        m_progress.warning(sentence);
        m_report.notes.push_back(std::move(sentence));
    }

    void solve(std::int64_t photo, const PhotoPosition& position, const Eigen::Vector3d& at) {
        if (!position.roomFromPhoto) {
            return;
        }
        store::SolvedPhoto solved;
        solved.photo = photo;
        solved.roomFromPhoto = *position.roomFromPhoto;
        solved.positionM = at;
        m_solution.photos.push_back(solved);
        ++m_report.withRotation;
    }

    void addSolution() {
        if (m_solution.photos.empty()) {
            return;
        }
        m_solution.source = "imported";
        m_solution.model = "given";
        if (const auto active = m_store.activeSolution()) {
            addOthers(*active);
        }
        m_store.addSolution(m_solution, true);
    }

    /// What is known of other photos stays known.
    void addOthers(const store::SolutionRecord& active) {
        std::set<std::int64_t> given;
        for (const store::SolvedPhoto& solved : m_solution.photos) {
            given.insert(solved.photo);
        }
        for (store::SolvedPhoto& solved : m_store.solvedPhotos(active.id)) {
            if (!given.contains(solved.photo)) {
                m_solution.photos.push_back(std::move(solved));
            }
        }
        if (active.source == "align") {
            takeOver(active, given, m_solution);
        }
    }

    store::SurveyStore& m_store;
    const ImportOptions& m_options;
    ProgressSink& m_progress;
    std::vector<store::StationRecord> m_stations;
    Polygon m_outline;                             ///< Empty if it is not known.
    std::set<std::int64_t> m_added;                ///< Stations.
    std::map<std::int64_t, PhotoPosition> m_lines; ///< Lines of this file, by their photos.
    std::vector<PhotoPlace> m_moves;
    store::NewSolution m_solution;
    std::optional<Error> m_firstRefusal;
    ImportReport m_report;
};

/// All JPEGs of the folder by name, side by side until their places are solved.
std::vector<PhotoPosition> unplacedPhotos(const std::filesystem::path& folder, double lensHeightM) {
    std::vector<std::string> names;
    std::error_code failure;
    for (std::filesystem::directory_iterator entry(folder, failure), end; !failure && entry != end;
         entry.increment(failure)) {
        std::string ending = entry->path().extension().string();
        std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
        if (ending == ".jpg" || ending == ".jpeg") {
            names.push_back(entry->path().filename().string());
        }
    }
    if (failure) {
        throw Error(ErrorKind::NotFound, text("Could not list the photos in ", printable(folder.string()),
                                              ": give --photos a folder that can be read."));
    }
    if (names.empty()) {
        throw Error(ErrorKind::NotFound, text("There is no JPEG in ", printable(folder.string()),
                                              ": give --photos the folder with the spherical photos."));
    }
    std::ranges::sort(names);
    std::vector<PhotoPosition> photos;
    for (const std::string& name : names) {
        PhotoPosition photo;
        photo.file = name;
        photo.positionM = {static_cast<double>(photos.size()), 0, lensHeightM};
        photos.push_back(std::move(photo));
    }
    return photos;
}

} // namespace

ImportReport importPhotos(store::SurveyStore& store, const ImportOptions& options, ProgressSink& progress,
                          const std::stop_token& stop) {
    const std::vector<PhotoPosition> positions =
        options.positions.empty() ? unplacedPhotos(options.photos, store.planOptions().heightsM.front())
                                  : readPositions(options.positions);
    Import import(store, options, progress);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        throwIfStopped(stop);
        progress.progress(static_cast<double>(i) / static_cast<double>(positions.size()),
                          text("Importing photo ", i + 1, " of ", positions.size()));
        import.take(positions[i]);
    }
    ImportReport report = import.finish(stop);
    if (report.outsideOutline > 0) {
        progress.warning(text(report.outsideOutline,
                              " photos stand outside of the room's outline; check the outline and the "
                              "positions."));
    }
    return report;
}

Json toJson(const ImportReport& report) {
    Json refused = Json::array();
    for (const RefusedLine& line : report.refused) {
        refused.push_back({{"line", line.line}, {"file", line.file}, {"sentence", line.sentence}});
    }
    return {{"imported", report.imported},
            {"already_there", report.alreadyThere},
            {"new_stations", report.newStations},
            {"unknown_places", report.unknownPlaces},
            {"with_rotation", report.withRotation},
            {"outside_outline", report.outsideOutline},
            {"moved", report.moved},
            {"refused", refused},
            {"notes", report.notes}};
}

} // namespace spherewalk::jobs
