// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/source_dataset.h"
#include "measure/measure_plots.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/folder.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/export_place.h"
#include "spherewalk/jobs/measure_dataset.h"
#include "spherewalk/jobs/measure_page.h"
#include "spherewalk/jobs/solution_findings.h"
#include "spherewalk/place/seen_depth.h"
#include "spherewalk/render/dataset.h"
#include "spherewalk/render/renderer.h"
#include "spherewalk/report/chart.h"
#include "spherewalk/store/survey_store.h"
#include "spherewalk/web/page.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <set>

namespace spherewalk::jobs {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostNeighbours = 12;
constexpr const char* kCoverageColour = "#7fb2d8"; ///< visible on light and dark paper

double sigmaOf(const std::optional<Eigen::Vector3d>& sigma) {
    return sigma ? sigma->maxCoeff() : 0;
}

/// The largest part of a turn's standard deviation.
Radians sigmaOf(const std::optional<render::RotationSigma>& sigma) {
    return sigma ? std::max({sigma->yaw, sigma->pitch, sigma->roll}) : Radians();
}

/// The page of a dataset, without what people and checks say of it.
class DatasetPage {
  public:
    DatasetPage(const render::Dataset& dataset, const std::stop_token& stop)
        : m_dataset(dataset), m_stop(stop), m_baselines(place::baselinesM(poses())) {}

    web::Page page() const {
        const render::DatasetInfo& info = m_dataset.info();
        web::Page page;
        page.name = info.name;
        page.madeBy = info.madeBy;
        page.createdUtc = info.createdUtc;
        page.room = {info.outline, info.obstacles, info.ceilingM};
        page.floorM = info.roomShape ? info.roomShape->floorM : 0;
        page.stepM = info.stepM;
        page.scaleSigma = info.scaleSigma;
        page.radiusM = info.sphereRadiusM.value_or(page.radiusM);
        page.floor = floorCells(info, [](std::size_t photo) { return std::to_string(photo); });
        for (std::size_t i = 0; i < info.photos.size(); ++i) {
            throwIfStopped(m_stop);
            page.photos.push_back(photo(i));
        }
        page.maps.push_back({web::word("coverage"),
                             web::word("coverageAbout"),
                             std::vector<std::string>(page.photos.size(), kCoverageColour),
                             {{kCoverageColour, web::word("covered")}}});
        return page;
    }

  private:
    std::vector<Rigid3> poses() const {
        std::vector<Rigid3> result;
        for (const render::DatasetPhoto& photo : m_dataset.info().photos) {
            result.push_back(photo.roomFromPhoto);
        }
        return result;
    }

    web::Photo photo(std::size_t number) const {
        const render::DatasetPhoto& entry = m_dataset.info().photos[number];
        web::Photo photo;
        photo.station = entry.station.empty() ? fs::path(entry.file).stem().string() : entry.station;
        photo.roomFromPhoto = entry.roomFromPhoto;
        photo.lenses = entry.lenses;
        photo.isHeadingKnown = entry.rotationSource == "aligned" || entry.rotationSource == "imported";
        photo.sigmaPositionM = sigmaOf(entry.positionSigmaM);
        photo.sigmaTurn = sigmaOf(entry.rotationSigma);
        photo.neighbours = neighbours(number);
        if (photo.isHeadingKnown && !entry.depth.empty()) {
            const auto depth = render::DepthMap::read(m_dataset.folder() / entry.depth);
            // A depth without another photo nearby was not estimated, and is taken to be exact.
            const double baselineM = m_baselines[number] > 0 ? m_baselines[number] : HUGE_VAL;
            const place::SeenDepth seen(depth, entry.roomFromPhoto, entry.lenses, baselineM);
            photo.depth = {seen.sigmaM(0), seen.sigmaM(1) - seen.sigmaM(0)};
        }
        return photo;
    }

    /// The nearest photos whose places this photo sees.
    std::vector<std::size_t> neighbours(std::size_t number) const {
        const auto& photos = m_dataset.info().photos;
        const auto place = [&](std::size_t i) -> const Eigen::Vector3d& {
            return photos[i].roomFromPhoto.translation;
        };
        std::vector<std::size_t> others;
        for (std::size_t i = 0; i < photos.size(); ++i) {
            if (i != number) {
                others.push_back(i);
            }
        }
        std::ranges::sort(others, {}, [&](std::size_t i) { return (place(i) - place(number)).norm(); });
        std::vector<std::size_t> result;
        for (const std::size_t other : others) {
            if (result.size() < kMostNeighbours && m_dataset.sees(number, place(other))) {
                result.push_back(other);
            }
        }
        return result;
    }

    const render::Dataset& m_dataset;
    const std::stop_token& m_stop;
    std::vector<double> m_baselines;
};

/// Puts what a survey knows onto the page of its dataset.
class SurveyWords {
  public:
    explicit SurveyWords(const store::SurveyStore& store)
        : m_store(store), m_exported(photosToExport(store)) {
        if (const auto solution = store.activeSolution()) {
            for (const store::SolvedPhoto& photo : store.solvedPhotos(solution->id)) {
                m_solved.emplace(photo.photo, photo);
            }
        }
    }

    /// Whether any heading is known, without which no depth can be right.
    bool isAligned() const { return !m_solved.empty(); }

    void put(web::Page& page) const {
        if (page.photos.size() != m_exported.photos.size()) {
            throw Error(ErrorKind::Busy, "The survey has changed while its page was made: export it again.");
        }
        page.hasReview = true;
        if (survey::Room room = m_store.knownRoom(); !room.outline.empty()) {
            page.room = std::move(room);
        }
        for (std::size_t i = 0; i < page.photos.size(); ++i) {
            put(m_exported.photos[i].id, page.photos[i]);
        }
        putEmptyStations(page);
    }

  private:
    void put(std::int64_t id, web::Photo& photo) const {
        std::optional<survey::Quality> worst;
        const auto take = [&](survey::Quality quality, const std::string& findings, bool areObjects) {
            worst = std::max(worst.value_or(quality), quality);
            const Json json = parseJson(findings, "the findings of a photo");
            const JsonReader list(json, "the findings of a photo");
            for (std::size_t i = 0; i < list.arraySize(); ++i) {
                const JsonReader finding = list.element(i);
                photo.findings.push_back(areObjects ? finding.string("sentence") : finding.asString());
            }
        };
        if (const auto verdict = m_store.verdict(id)) {
            take(verdict->quality, verdict->findings, true);
        }
        if (const auto solved = m_solved.find(id); solved != m_solved.end()) {
            take(solved->second.quality, solved->second.flags, false);
        }
        const store::Review review = m_store.review(id);
        photo.state = worst ? survey::name(*worst) : "unjudged";
        photo.decision = store::name(review.decision);
        photo.note = review.note;
    }

    void putEmptyStations(web::Page& page) const {
        std::set<std::int64_t> shown;
        std::set<std::int64_t> failed;
        for (const store::PhotoRecord& photo : m_exported.photos) {
            shown.insert(photo.station);
        }
        for (const store::PhotoRecord& photo : m_exported.failed) {
            failed.insert(photo.station);
        }
        for (const store::StationRecord& station : m_store.stations()) {
            if (station.isPlaceKnown && !shown.contains(station.id)) {
                const bool hasPhoto = m_store.chosenPhoto(station.id).has_value();
                page.without.push_back({station.name, station.station.positionM.head<2>(),
                                        failed.contains(station.id) ? "notPlaced"
                                        : hasPhoto                  ? "rejected"
                                                                    : "missing"});
            }
        }
    }

    const store::SurveyStore& m_store;
    PhotosToExport m_exported;
    std::map<std::int64_t, store::SolvedPhoto> m_solved;
};

/// A map of errors, one for each photo, beside a tolerance. unknown: the key of the word for no error.
web::FloorMap floorErrors(const std::string& name, const std::string& about,
                          const std::vector<std::optional<double>>& errorsPx, double tolerancePx,
                          const std::string& unknown = "notMeasured") {
    constexpr double kLargestPx = 1e9; // an endless error is known to be too large
    web::FloorMap map{web::word(name), web::word(about), {}, {}};
    for (const std::optional<double>& error : errorsPx) {
        map.colours.push_back(report::errorColour(
            error ? std::optional(std::min(*error, kLargestPx)) : std::nullopt, tolerancePx));
    }
    for (const double step : report::kErrorSteps) {
        const char* key = step == report::kErrorSteps.front()  ? "orLess"
                          : step == report::kErrorSteps.back() ? "orMore"
                          : step == 1                          ? "tolerance"
                                                               : "pixels";
        map.legend.push_back(
            {report::errorColour(step * tolerancePx, tolerancePx), web::word(key), step * tolerancePx});
    }
    map.legend.push_back({report::errorColour(std::nullopt, tolerancePx), web::word(unknown)});
    return map;
}

/// What views are off where photos were left out, if the report is of this survey.
void putMeasured(const render::DatasetInfo& info, const fs::path& report, web::Page& page) {
    const MeasuredPhotos measured = readMeasuredPhotos(report);
    if (measured.surveyId != info.surveyId) {
        throw Error(ErrorKind::InvalidInput, text("The report ", report.string(), " is of another survey, ",
                                                  printable(measured.dataset), "."));
    }
    std::map<std::string, std::optional<double>> known;
    for (const MeasuredPhoto& photo : measured.photos) {
        known[photo.file] = photo.p95Px;
    }
    std::vector<std::optional<double>> errors;
    for (std::size_t i = 0; i < info.photos.size(); ++i) {
        errors.push_back(known[info.photos[i].file]);
        page.photos[i].errorPx =
            errors.back() && std::isfinite(*errors.back()) ? errors.back() : std::nullopt;
    }
    page.maps.push_back(floorErrors("error", "errorAbout", errors, measured.tolerancePx));
}

/// What the headings' uncertainty comes to in a robot's view.
void putHeadings(const render::DatasetInfo& info, web::Page& page) {
    const double focalPx = 320 / std::tan(Radians(Degrees(57)).value() / 2);
    std::vector<std::optional<double>> errors;
    for (const render::DatasetPhoto& photo : info.photos) {
        errors.push_back(photo.rotationSigma ? std::optional(photo.rotationSigma->yaw.value() * focalPx)
                                             : std::nullopt);
    }
    if (std::ranges::any_of(errors, [](const auto& error) { return error.has_value(); })) {
        page.maps.push_back(floorErrors("heading", "headingAbout", errors, MeasureOptions().tolerancePx));
    }
}

/// What views from all over the floor are foretold to be off, by the photos' own evidence.
class Foretold {
  public:
    explicit Foretold(const std::shared_ptr<const render::Dataset>& dataset) : m_renderer(dataset) {}

    /// Range: a dataset with photos.
    void put(web::Page& page, ProgressSink& progress, const std::stop_token& stop) const {
        const double heightM = this->heightM();
        const Bounds2 area = this->area();
        const Eigen::Vector2d size = area.greatest - area.least;
        web::Floor floor{area.least, std::max(kLeastCellM, std::sqrt(size.prod() / kMostCells)), {}};
        const auto rows = static_cast<int>(std::ceil(size.y() / floor.cellM));
        const auto columns = static_cast<int>(std::ceil(size.x() / floor.cellM));
        std::vector<std::optional<double>> errors;
        for (int cell = 0; cell < rows * columns; ++cell) {
            throwIfStopped(stop);
            progress.progress(static_cast<double>(cell) / (rows * columns),
                              "Foretelling how far views are off");
            const Eigen::Vector2d middle =
                floor.origin + floor.cellM * Eigen::Vector2d(cell % columns + 0.5, cell / columns + 0.5);
            const Eigen::Vector3d place(middle.x(), middle.y(), heightM);
            if (!m_renderer.dataset().isOutside(place)) {
                floor.runs.push_back({cell / columns, cell % columns, cell % columns + 1, errors.size()});
                errors.push_back(errorPx(place));
            }
        }
        if (std::ranges::any_of(errors, [](const auto& error) { return error.has_value(); })) {
            page.maps.push_back(floorErrors("foretold", "foretoldAbout", errors, MeasureOptions().tolerancePx,
                                            "notForetold"));
            page.maps.back().floor = std::move(floor);
        }
    }

  private:
    static constexpr double kLeastCellM = 0.2;
    static constexpr double kMostCells = 600;
    static constexpr int kDirections = 6; ///< So many views of 57 degrees see all around.
    static constexpr int kCoarser = 4;    ///< Such views need a coarser and smaller part of the photos.

    double heightM() const {
        std::vector<double> heights;
        for (const render::DatasetPhoto& photo : m_renderer.dataset().info().photos) {
            heights.push_back(photo.roomFromPhoto.translation.z());
        }
        return median(heights);
    }

    /// Of the outline; without one, a metre about the photos.
    Bounds2 area() const {
        const render::DatasetInfo& info = m_renderer.dataset().info();
        Polygon corners = info.outline;
        if (corners.empty()) {
            for (const render::DatasetPhoto& photo : info.photos) {
                const Eigen::Vector2d at = photo.roomFromPhoto.translation.head<2>();
                corners.emplace_back(at - Eigen::Vector2d::Ones());
                corners.emplace_back(at + Eigen::Vector2d::Ones());
            }
        }
        return bounds(corners);
    }

    /// The median of views all around, in pixels of the whole camera. Nothing where nothing is known.
    std::optional<double> errorPx(const Eigen::Vector3d& place) const {
        std::vector<double> errors;
        for (int i = 0; i < kDirections; ++i) {
            const Radians yaw(2 * std::numbers::pi * i / kDirections);
            const render::ViewReport report =
                m_renderer.render(m_camera, {yawRotation(yaw) * bodyFromOptical(), place}).report;
            if (!(report.trust > 0)) {
                return std::nullopt;
            }
            errors.push_back(kCoarser * report.parallaxPx);
        }
        return median(errors);
    }

    render::Renderer m_renderer;
    CameraModel m_camera{
        CameraIntrinsics::pinhole(640 / kCoarser, 480 / kCoarser, Radians(Degrees(57)).value())};
};

/// The photo nearest to the middle of all.
std::size_t middlePhoto(const render::DatasetInfo& info) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const render::DatasetPhoto& photo : info.photos) {
        middle += photo.roomFromPhoto.translation / static_cast<double>(info.photos.size());
    }
    const auto nearest = std::ranges::min_element(info.photos, {}, [&](const render::DatasetPhoto& photo) {
        return (photo.roomFromPhoto.translation - middle).norm();
    });
    return static_cast<std::size_t>(nearest - info.photos.begin());
}

/// Writes one script for each photo. Returns the bytes that they have.
std::uint64_t writePhotos(const render::Dataset& dataset, const web::Page& page, const fs::path& folder,
                          ProgressSink& progress, const std::stop_token& stop) {
    const auto& photos = dataset.info().photos;
    std::uint64_t total = 0;
    for (std::size_t i = 0; i < photos.size(); ++i) {
        throwIfStopped(stop);
        const fs::path depth = page.photos[i].depth ? dataset.folder() / photos[i].depth : fs::path();
        const std::string script = web::photoScript(i, dataset.readPhoto(i), depth);
        writeFile(folder / web::scriptName(i), bytesOf(script));
        total += script.size();
        progress.progress(static_cast<double>(i + 1) / static_cast<double>(photos.size()),
                          text("Writing photo ", i + 1, " of ", photos.size()));
    }
    return total;
}

WebReport write(const fs::path& source, const SurveyWords* survey, const fs::path& folder,
                const WebOptions& options, ProgressSink& progress, const std::stop_token& stop) {
    const auto opened = std::make_shared<const render::Dataset>(
        render::Dataset::open(source, render::Verify::Sizes, noProgress(), stop));
    const render::Dataset& dataset = *opened;
    progress.progress(0, "Looking which photos see each other");
    web::Page page = DatasetPage(dataset, stop).page();
    page.begin = middlePhoto(dataset.info());
    if (survey != nullptr) {
        survey->put(page);
    }
    if (!options.measured.empty()) {
        putMeasured(dataset.info(), options.measured, page);
    }
    ProgressStep foretelling(progress, 0.1, 0.4);
    if (!page.photos.empty()) {
        Foretold(opened).put(page, foretelling, stop);
    }
    putHeadings(dataset.info(), page);
    WebReport report;
    report.photos = page.photos.size();
    report.withDepth = static_cast<std::size_t>(
        std::ranges::count_if(page.photos, [](const web::Photo& photo) { return photo.depth.has_value(); }));
    report.leftOut = page.without.size();
    ProgressStep writing(progress, 0.4, 1);
    makeFolder(folder, "the page", [&](const fs::path& unfinished) {
        web::writePage(page, {options.language, options.translated}, unfinished);
        report.totalBytes = writePhotos(dataset, page, unfinished, writing, stop);
    });
    return report;
}

} // namespace

WebReport exportWeb(const fs::path& source, const fs::path& folder, const WebOptions& options,
                    ProgressSink& progress, const std::stop_token& stop) {
    requireAbsent(folder, "the page");
    const auto begin = std::chrono::steady_clock::now();
    WebReport report;
    if (fs::exists(source / render::kDatasetFile)) {
        report = write(source, nullptr, folder, options, progress, stop);
    } else {
        const auto store = store::SurveyStore::open(source, store::Access::Read);
        const SurveyWords survey(store);
        ExportOptions wanted;
        wanted.scene = survey.isAligned() ? render::SceneKind::Depth : render::SceneKind::Sphere;
        ProgressStep exporting(progress, 0, 0.7);
        const SourceDataset dataset(store, wanted, exporting, stop);
        ProgressStep writing(progress, 0.7, 1);
        report = write(dataset.path(), &survey, folder, options, writing, stop);
        report.depthSeconds = dataset.depthSeconds();
    }
    report.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() - report.depthSeconds;
    return report;
}

Json toJson(const WebReport& report) {
    return {{"photos", report.photos},
            {"photos_with_depth", report.withDepth},
            {"stations_without_photo", report.leftOut},
            {"total_bytes", report.totalBytes}};
}

} // namespace spherewalk::jobs
