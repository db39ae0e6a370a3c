// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/solution_findings.h"

#include "spherewalk/base/text.h"

#include <algorithm>
#include <map>

namespace spherewalk::jobs {

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

/// Joins what the store and the report know of the photos.
class Reading {
  public:
    Reading(const store::SurveyStore& store, store::SolutionRecord solution) {
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
            photo.status = solved.status;
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
        if (!report.isAbsent("reason")) {
            m_findings.reason = report.string("reason");
        }
        if (!report.isAbsent("warnings")) {
            m_findings.warnings = strings(report.member("warnings"));
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
        photo.status = reported.string("status");
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

} // namespace spherewalk::jobs
