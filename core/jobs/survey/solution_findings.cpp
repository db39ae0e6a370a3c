// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/solution_findings.h"

#include "parts/imported_poses.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/import_photos.h"
#include "spherewalk/photo/position_tag.h"
#include "spherewalk/store/survey_store.h"

#include <algorithm>
#include <map>
#include <set>

namespace spherewalk::jobs {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostFlags = 1000;

std::vector<std::string> strings(const JsonReader& array) {
    std::vector<std::string> result;
    for (std::size_t i = 0; i < array.arraySize(kMostFlags); ++i) {
        result.push_back(array.element(i).asString());
    }
    return result;
}

Radians degreesIn(const JsonReader& object, std::string_view key) {
    return Degrees(object.number(key));
}

survey::Quality qualityIn(const JsonReader& reported) {
    try {
        return survey::qualityNamed(reported.string("status"));
    } catch (const Error& error) {
        reported.fail(error.sentence());
    }
}

/// Joins what the store and the report know of the photos.
class Reading {
  public:
    Reading(const store::SurveyStore& store, store::SolutionRecord solution) : m_imported(solution) {
        m_findings.solution = std::move(solution);
        for (const store::StationRecord& station : store.stations()) {
            m_stationNames[station.id] = station.name;
            m_stations.emplace(station.name, station.id);
        }
        for (const store::PhotoRecord& photo : store.chosenPhotos()) {
            addPhoto(photo);
        }
    }

    void addSolved(const std::vector<store::SolvedPhoto>& photos) {
        for (const store::SolvedPhoto& solved : photos) {
            const auto found = m_byId.find(solved.photo);
            if (found == m_byId.end()) {
                continue; // another photo was chosen since
            }
            PhotoFinding& photo = m_findings.photos[found->second];
            photo.quality = solved.quality;
            photo.isImported = m_imported.has(solved.photo);
            photo.roomFromPhoto = Rigid3{solved.roomFromPhoto, solved.positionM};
            if (solved.sigmaYawRad) {
                photo.sigmaYaw = Radians(*solved.sigmaYawRad);
            }
            if (solved.sigmaPitchRad && solved.sigmaRollRad) {
                photo.sigmaTilt = Radians(std::max(*solved.sigmaPitchRad, *solved.sigmaRollRad));
            }
            const Json flags = parseJson(solved.flags, "the flags of a solved photo");
            photo.flags = strings(JsonReader(flags, "the flags of a solved photo"));
        }
    }

    void addReport(const JsonReader& report) {
        m_findings.isFree = !report.isAbsent("places");
        if (!report.isAbsent("reason")) {
            m_findings.reason = report.string("reason");
        }
        if (!report.isAbsent("position_sigma_m")) {
            m_findings.positionSigmaM = report.number("position_sigma_m");
        }
        const JsonReader said = m_findings.isFree ? report.member("places") : report;
        if (!said.isAbsent("scale_sigma")) {
            m_findings.scaleSigma = std::clamp(said.number("scale_sigma"), 0., 1.);
        }
        if (!report.isAbsent("warnings")) {
            m_findings.warnings = strings(report.member("warnings"));
        }
        if (!report.isAbsent("tag_warnings")) {
            m_findings.tagWarnings = strings(report.member("tag_warnings"));
        }
        if (report.isAbsent("photos")) {
            return;
        }
        const JsonReader photos = report.member("photos");
        for (std::size_t i = 0; i < photos.arraySize(); ++i) {
            addReported(photos.element(i));
        }
    }

    SolutionFindings done() {
        for (PhotoFinding& photo : m_findings.photos) {
            // What was retagged since is cured of that.
            if (photo.cure == Cure::Retag && !photo.fits) {
                photo.cure = Cure::None;
            }
        }
        return std::move(m_findings);
    }

  private:
    void addPhoto(const store::PhotoRecord& photo) {
        PhotoFinding finding;
        finding.photo = photo.id;
        finding.station = photo.station;
        finding.file = photo.fileName;
        finding.stationName = m_stationNames[photo.station];
        m_byId.emplace(photo.id, m_findings.photos.size());
        m_findings.photos.push_back(std::move(finding));
    }

    void addReported(const JsonReader& reported) {
        const auto found =
            std::find_if(m_findings.photos.begin(), m_findings.photos.end(), [&](const PhotoFinding& photo) {
                // Earlier versions named the file only.
                return reported.isAbsent("photo") ? reported.string("file") == photo.file
                                                  : reported.integer("photo") == photo.photo;
            });
        if (found == m_findings.photos.end()) {
            return;
        }
        PhotoFinding& photo = *found;
        photo.quality = qualityIn(reported);
        photo.flags = strings(reported.member("flags"));
        photo.cure = reported.isAbsent("cure") ? Cure::None : cureNamed(reported.string("cure"));
        if (!reported.isAbsent("residual_deg")) {
            photo.residual = degreesIn(reported, "residual_deg");
            photo.neighbours = static_cast<int>(reported.integer("neighbours", 0, INT32_MAX));
        }
        if (!reported.isAbsent("fits_station")) {
            const auto station = m_stations.find(reported.string("fits_station"));
            if (station != m_stations.end() && station->second != photo.station) {
                photo.fits = station->second;
            }
        }
    }

    ImportedPoses m_imported;
    SolutionFindings m_findings;
    std::map<std::int64_t, std::string> m_stationNames;
    std::map<std::string, std::int64_t> m_stations;
    std::map<std::int64_t, std::size_t> m_byId;
};

} // namespace

std::vector<PhotoPlace> SolutionFindings::retags() const {
    std::vector<PhotoPlace> places;
    for (const PhotoFinding& photo : photos) {
        if (photo.fits) {
            places.push_back({photo.photo, *photo.fits});
        }
    }
    return places;
}

std::optional<SolutionFindings> activeFindings(const store::SurveyStore& store) {
    const auto solution = store.activeSolution();
    if (!solution) {
        return std::nullopt;
    }
    Reading reading(store, *solution);
    reading.addSolved(store.solvedPhotos(solution->id));
    const std::string source = text("the report of solution ", static_cast<long long>(solution->id));
    const Json report = parseJson(solution->report, source);
    reading.addReport(JsonReader(report, source));
    return reading.done();
}

namespace {

/// The first ones by name, and how many there are.
struct Named {
    static constexpr std::size_t kMostNames = 20;

    std::string names;
    std::size_t count = 0;

    void add(std::string_view name) {
        if (++count <= kMostNames + 1) {
            names += text(count == 1 ? "" : ", ", count <= kMostNames ? name : "...");
        }
    }
};

} // namespace

PhotosToExport photosToExport(const store::SurveyStore& store) {
    PhotosToExport made;
    std::set<std::int64_t> failed;
    std::set<std::int64_t> inDoubt; // another rotation may be right
    if (const auto findings = activeFindings(store)) {
        made.doubts = findings->tagWarnings;
        made.scaleSigma = findings->scaleSigma;
        for (const PhotoFinding& photo : findings->photos) {
            if (photo.quality == survey::Quality::Failed) {
                failed.insert(photo.photo);
            } else if (photo.roomFromPhoto && !photo.sigmaYaw && !photo.isImported) {
                inDoubt.insert(photo.photo);
            }
        }
    }
    Named turned;
    Named unplaced;
    Named unsolved;
    for (store::PhotoRecord& photo : store.keptPhotos()) {
        const store::StationRecord station = store.station(photo.station);
        const bool isFailed = failed.contains(photo.id);
        const bool isLeftOut = isFailed || !station.isPlaceKnown;
        if (isLeftOut || inDoubt.contains(photo.id)) {
            (isFailed    ? unsolved
             : isLeftOut ? unplaced
                         : turned)
                .add(store::photoAtStation(photo.fileName, station.name));
        }
        (isLeftOut ? made.failed : made.photos).push_back(std::move(photo));
    }
    if (turned.count > 0) {
        made.doubts.push_back(text("How ", counted(turned.count, "photo is", "photos are"),
                                   " turned is not known: ", turned.names,
                                   ". Look at what the alignment says of each, mend it, and align again."));
    }
    if (unplaced.count > 0) {
        made.doubts.push_back(
            text(counted(unplaced.count, "photo is left out, since nobody knows where it was taken: ",
                         "photos are left out, since nobody knows where they were taken: "),
                 unplaced.names, ". Aligning from the pictures alone finds that out."));
    }
    if (unsolved.count > 0) {
        made.doubts.push_back(
            text(counted(unsolved.count, "photo is", "photos are"),
                 " left out, since the alignment found no pose that holds: ", unsolved.names,
                 ". Look at what the alignment says of each, mend it, and align again."));
    }
    return made;
}

std::string PhotosToExport::allDoubts() const {
    std::string all;
    for (const std::string& doubt : doubts) {
        all += (all.empty() ? "" : " ") + doubt;
    }
    return all;
}

std::string placesInDoubt(const store::SurveyStore& store) {
    constexpr double kTagSigmas = 4; // Of a length in two dimensions: one in 3000 is farther off by chance.
    const std::optional<SolutionFindings> findings = activeFindings(store);
    if (!findings) {
        return "";
    }
    std::map<std::int64_t, store::SolvedPhoto> solved;
    for (store::SolvedPhoto& photo : store.solvedPhotos(findings->solution.id)) {
        solved.emplace(photo.photo, std::move(photo));
    }
    const std::vector<store::StationRecord> stations = store.stations();
    std::string names;
    std::size_t count = 0;
    for (const store::PhotoRecord& photo : store.keptPhotos()) {
        const auto found = solved.find(photo.id);
        if (found == solved.end()) {
            continue;
        }
        const double offM = (found->second.positionM - photo.positionM).norm();
        const bool isFar = offM > kTagSigmas * findings->positionSigmaM;
        const bool isElsewhere =
            isFar && std::ranges::any_of(stations, [&](const store::StationRecord& station) {
                return station.id != photo.station &&
                       (station.station.positionM - found->second.positionM).norm() < offM;
            });
        if (isElsewhere) {
            ++count;
            names += text(count == 1 ? "" : ", ",
                          store::photoAtStation(photo.fileName, store.station(photo.station).name));
        }
    }
    return count == 0 ? ""
                      : text("The alignment puts ", counted(count, "photo", "photos"),
                             " nearer to another station than to the photo's own: ", names,
                             ". The dataset has the solved places; retag the photos, and align again.");
}

namespace {

/// Files that are removed again unless the survey came to name them.
class FilesInDoubt {
  public:
    FilesInDoubt() = default;
    FilesInDoubt(const FilesInDoubt&) = delete;
    FilesInDoubt& operator=(const FilesInDoubt&) = delete;

    ~FilesInDoubt() {
        for (const fs::path& file : m_files) {
            std::error_code ignored; // a file that belongs to no photo does no harm
            fs::remove(file, ignored);
        }
    }

    void add(const fs::path& file) { m_files.push_back(file); }

    void replaceBy(std::vector<fs::path> files) { m_files = std::move(files); }

  private:
    std::vector<fs::path> m_files;
};

/// Errors: NotFound; InvalidInput for a photo that is named twice.
std::vector<PhotoPlace> placesAround(const store::SurveyStore& store, const std::vector<PhotoPlace>& places) {
    std::set<std::int64_t> photos;
    std::set<std::int64_t> stations;
    for (const PhotoPlace& place : places) {
        const store::PhotoRecord photo = store.photo(place.photo);
        if (!photos.insert(place.photo).second) {
            throw Error(ErrorKind::InvalidInput,
                        text("The photo ", photo.fileName, " cannot be at two stations; name it once."));
        }
        stations.insert({photo.station, store.station(place.station).id});
    }
    std::vector<PhotoPlace> result;
    for (const std::int64_t station : stations) {
        for (const store::PhotoRecord& photo : store.photosAt(station)) {
            result.push_back({photo.id, station, photo.positionM, photo.choose});
        }
    }
    return result;
}

/// The row of the photo at its place, its file written if it has to be another one.
store::MovedPhoto placed(const store::SurveyStore& store, const std::string& surveyId,
                         const PhotoPlace& place) {
    const store::PhotoRecord photo = store.photo(place.photo);
    const store::StationRecord station = store.station(place.station);
    const Eigen::Vector3d positionM = place.positionM.value_or(station.station.positionM);
    const fs::path file = store.photoFolder() / photo.fileName;
    const Bytes old = readFile(file);
    // The rotation that came with the photo stays true: it is the photo that was named wrongly, not turned.
    const auto oldTag = photo::readPositionTag(old, file.string());
    const Bytes tagged = photo::withPositionTag(
        old, {surveyId, station.id, station.name, positionM, oldTag ? oldTag->roomFromPhoto : std::nullopt},
        file.string());
    store::MovedPhoto moved{photo.id,          station.id,    positionM,   photo.fileName,
                            sha256Hex(tagged), tagged.size(), place.choose};
    if (moved.fileSha256 != photo.fileSha256) {
        moved.fileName = store.freePhotoName(photo.cameraFileName, moved.fileSha256);
        writeFile(store.photoFolder() / moved.fileName, tagged);
    }
    return moved;
}

} // namespace

std::vector<PhotoPlace> retagPhotos(store::SurveyStore& store, const std::vector<PhotoPlace>& places,
                                    ProgressSink& progress, const std::stop_token& stop) {
    std::vector<PhotoPlace> before = placesAround(store, places);
    const std::string surveyId = store.info().uuid;
    FilesInDoubt files;
    std::vector<fs::path> replaced;
    std::vector<store::MovedPhoto> moved;
    for (const PhotoPlace& place : places) {
        throwIfStopped(stop);
        const std::string oldName = store.photo(place.photo).fileName;
        moved.push_back(placed(store, surveyId, place));
        if (moved.back().fileName != oldName) {
            files.add(store.photoFolder() / moved.back().fileName);
            replaced.push_back(store.photoFolder() / oldName);
        }
        progress.progress(static_cast<double>(moved.size()) / static_cast<double>(places.size() + 1),
                          "Writing the photos' position tags");
    }
    throwIfStopped(stop);
    const std::size_t unsolved = store.movePhotos(moved).size();
    if (unsolved > 0) {
        progress.warning(
            text(counted(unsolved, "photo has", "photos have"),
                 " left the alignment, which was made with the earlier places; align again before "
                 "you export."));
    }
    files.replaceBy(std::move(replaced));
    progress.progress(1, "Retagged");
    return before;
}

} // namespace spherewalk::jobs
