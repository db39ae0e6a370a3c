// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/export_dataset.h"

#include "export/cleared_photos.h"
#include "parts/imported_poses.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/folder.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/align_survey.h"
#include "spherewalk/jobs/solution_findings.h"
#include "spherewalk/photo/metadata.h"
#include "spherewalk/scene/room_fit.h"
#include "spherewalk/store/survey_store.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <unistd.h>

namespace spherewalk::jobs {

namespace fs = std::filesystem;

namespace {

std::vector<render::SuggestedCamera> usualCameras() {
    const auto camera = [](const std::string& name, int width, int height, double fovDeg) {
        return render::SuggestedCamera{
            name, CameraIntrinsics::pinhole(width, height, Radians(Degrees(fovDeg)).value())};
    };
    return {camera("vga-57", 640, 480, 57), camera("vga-90", 640, 480, 90), camera("hd-69", 1280, 720, 69)};
}

/// What a solution's report says of a photo. Sigmas are those among the other photos.
struct PhotoReport {
    Radians turn{HUGE_VAL};
    double positionM = HUGE_VAL;
    /// What the turns of pairs disagree by, about each axis. Noise of matches is not all of it: a camera of
    /// two lenses has no single centre. It is 0 where the alignment knows how the lenses stand.
    Radians apart;
    LensPair lenses;
};

/// By the photos' numbers.
std::map<std::int64_t, PhotoReport> photoReports(const store::SolutionRecord& solution) {
    // The median length of the sum of three errors in space, in standard deviations of one along an axis.
    constexpr double kPerTriangle = 2.67;
    const Json json = parseJson(solution.report, "the report of a solution");
    const JsonReader report(json, "the report of a solution");
    std::map<std::int64_t, PhotoReport> result;
    if (report.isAbsent("photos")) {
        return result;
    }
    const double aroundDeg = report.isAbsent("cycle_error_deg") ? 0 : report.number("cycle_error_deg");
    const JsonReader photos = report.member("photos");
    for (std::size_t i = 0; i < photos.arraySize(); ++i) {
        const JsonReader photo = photos.element(i);
        PhotoReport& said = result[photo.integer("photo")];
        said.lenses.aheadM = photo.isAbsent("lens_ahead_m") ? 0 : photo.number("lens_ahead_m");
        if (!photo.isAbsent("sigma_own")) {
            const JsonReader own = photo.member("sigma_own");
            said.turn = Degrees(own.number("turn_deg"));
            said.positionM = own.number("position_m");
            constexpr double kKnownM = 0.001;
            const bool areLensesKnown =
                said.lenses.aheadM != 0 ||
                (!photo.isAbsent("lens_ahead_sigma_m") && photo.number("lens_ahead_sigma_m") < kKnownM);
            said.apart = Degrees(areLensesKnown ? 0 : aroundDeg / kPerTriangle);
        }
    }
    return result;
}

/// Poses of photos, from the active solution where it has them.
class Poses {
  public:
    explicit Poses(const store::SurveyStore& store) : m_folder(store.photoFolder()) {
        if (const auto solution = store.activeSolution()) {
            m_imported.emplace(*solution);
            m_reports = photoReports(*solution);
            for (const store::SolvedPhoto& photo : store.solvedPhotos(solution->id)) {
                m_solved.emplace(photo.photo, photo);
            }
        }
    }

    /// Fills in the pose; false if the heading is not known.
    bool fill(const store::PhotoRecord& photo, render::DatasetPhoto& entry) const {
        const auto found = m_solved.find(photo.id);
        if (found == m_solved.end()) {
            fillFromMetadata(photo, entry);
            return false;
        }
        const store::SolvedPhoto& solved = found->second;
        entry.roomFromPhoto = {solved.roomFromPhoto, solved.positionM};
        entry.rotationSource = m_imported->has(photo.id) ? "imported" : "aligned";
        const auto reported = m_reports.find(photo.id);
        const PhotoReport most = reported != m_reports.end() ? reported->second : PhotoReport();
        entry.lenses = most.lenses;
        if (solved.sigmaPositionM) {
            entry.positionSigmaM =
                Eigen::Vector3d::Constant(std::min(*solved.sigmaPositionM, most.positionM));
        }
        if (solved.sigmaYawRad && solved.sigmaPitchRad && solved.sigmaRollRad) {
            const auto about = [&](double sigmaRad) {
                return Radians(std::hypot(std::min(sigmaRad, most.turn.value()), most.apart.value()));
            };
            entry.rotationSigma = render::RotationSigma{
                about(*solved.sigmaYawRad), about(*solved.sigmaPitchRad), about(*solved.sigmaRollRad)};
        }
        return true;
    }

  private:
    void fillFromMetadata(const store::PhotoRecord& photo, render::DatasetPhoto& entry) const {
        const std::filesystem::path file = m_folder / photo.fileName;
        const auto level = photo::levelFromPhoto(photo::readMetadata(readFile(file), file.string()));
        entry.roomFromPhoto = {level.value_or(Eigen::Quaterniond::Identity()), photo.positionM};
        entry.rotationSource = level ? "metadata" : "unknown";
    }

    std::filesystem::path m_folder;
    std::optional<ImportedPoses> m_imported;
    std::map<std::int64_t, store::SolvedPhoto> m_solved;
    std::map<std::int64_t, PhotoReport> m_reports;
};

render::DatasetInfo infoOf(const store::SurveyStore& store) {
    const survey::Room room = store.knownRoom();
    const store::SurveyInfo survey = store.info();
    render::DatasetInfo info;
    info.id = randomUuid();
    info.name = survey.name;
    info.createdUtc = isoUtc(std::chrono::system_clock::now());
    info.madeBy = "spherewalk " SPHEREWALK_VERSION;
    info.surveyId = survey.uuid;
    info.outline = room.outline;
    info.obstacles = room.obstacles;
    info.ceilingM = room.ceilingM;
    info.stepM = store.planOptions().stepM;
    info.cameras = usualCameras();
    return info;
}

/// Nothing if no photo stands inside of the room, so that there is nothing to estimate it from.
std::optional<double> radiusFor(const store::SurveyStore& store,
                                const std::vector<dataset::SourcePhoto>& photos) {
    const bool isKnown = !store.knownRoom().outline.empty();
    std::vector<Eigen::Vector3d> positions;
    for (const dataset::SourcePhoto& photo : photos) {
        const Eigen::Vector3d& at = photo.entry.roomFromPhoto.translation;
        positions.push_back(isKnown ? at
                                    : Eigen::Vector3d(0, 0, at.z())); // The middle of survey::unknownRoom().
    }
    return scene::sphereRadius(store.room(), positions);
}

/// Where depths are kept: beside the survey. If that may only be read, new depths are kept as long as the
/// object lives.
class DepthCache {
  public:
    DepthCache(const store::SurveyStore& store, const ExportOptions& options)
        : m_path(options.depth.cacheFolder.empty() ? store.folder() / kDepthCacheFolder
                                                   : options.depth.cacheFolder) {
        const fs::path existing = fs::exists(m_path) ? m_path : store.folder();
        if (render::hasSurfaces(options.scene) && ::access(existing.c_str(), W_OK) != 0) {
            m_own.emplace("spherewalk-depth");
            std::error_code none; // no depth was kept yet
            for (const fs::directory_entry& depth : fs::directory_iterator(m_path, none)) {
                fs::create_symlink(depth.path(), m_own->path() / depth.path().filename());
            }
            m_path = m_own->path();
        }
    }

    const fs::path& path() const { return m_path; }

  private:
    fs::path m_path;
    std::optional<TemporaryFolder> m_own;
};

/// How depths of these photos are found, and where they are kept.
DepthOptions depthOptions(const store::SurveyStore& store, const ExportOptions& options,
                          const DepthCache& cache) {
    DepthOptions depth = options.depth;
    depth.cacheFolder = cache.path();
    const survey::Room room = store.knownRoom();
    depth.drawn = {room.outline, room.ceilingM};
    depth.onlyForScene = !render::usesDepths(options.scene);
    return depth;
}

/// The room as a person drew it, in place of one that the photos do not show.
std::optional<render::RoomShape> drawnRoom(const survey::Room& room, ProgressSink& progress) {
    if (room.outline.size() < 3 || !(room.ceilingM > 0)) {
        progress.warning(
            "The photos do not show where walls, floor and ceiling are, and no room is drawn: the "
            "dataset has no room.");
        return std::nullopt;
    }
    progress.warning(
        "The photos do not show where walls, floor and ceiling are: the dataset's room is the drawn "
        "one.");
    return render::RoomShape{room.outline, 0, room.ceilingM};
}

/// The photos that depths are estimated from. Nothing is cleared if a heading is not known, since other
/// photos would then be looked into at wrong places.
ClearedPhotos clearedPhotos(const store::SurveyStore& store, const ExportOptions& options,
                            const DepthCache& cache, const dataset::Contents& contents,
                            const ExportReport& report, const std::stop_token& stop) {
    const bool looks = options.clearsCarried && report.withoutRotation == 0;
    return {depthInputs(contents.photos), store.knownRoom(), cache.path(), looks, stop};
}

/// Makes the photos without what is carried along, and exports them.
void takeCleared(ClearedPhotos& cleared, dataset::Contents& contents, ProgressSink& progress,
                 const std::stop_token& stop) {
    const std::size_t count = cleared.carried().empty() ? 0 : contents.photos.size();
    for (std::size_t i = 0; i < count; ++i) {
        cleared.make(i, stop);
        contents.photos[i].file = cleared.inputs()[i].file;
        contents.photos[i].sha256 = sha256Hex(readFile(contents.photos[i].file));
        progress.progress(static_cast<double>(i + 1) / static_cast<double>(count),
                          text("Clearing the floor below the camera, photo ", i + 1, " of ", count));
    }
}

/// Radius, room and depths from what the photos show.
void addScene(const store::SurveyStore& store, const ExportOptions& options, const DepthCache& cache,
              dataset::Contents& contents, ExportReport& report, ProgressSink& progress,
              const std::stop_token& stop) {
    ClearedPhotos cleared = clearedPhotos(store, options, cache, contents, report, stop);
    report.carriedShare = cleared.carried().share();
    DepthOptions depth = depthOptions(store, options, cache);
    depth.beforeReading = [&](std::size_t photo) { cleared.make(photo, stop); };
    ProgressStep sweeping(progress, 0, cleared.carried().empty() ? 1 : 0.9);
    const SurveyDepth found = surveyDepth(cleared.inputs(), depth, sweeping, stop);
    ProgressStep clearing(progress, 0.9, 1);
    takeCleared(cleared, contents, clearing, stop);
    report.depth = found.report;
    if (found.radiusM) {
        contents.info.sphereRadiusM = found.radiusM;
    }
    report.roomShape = found.room ? found.room->shape : drawnRoom(store.knownRoom(), progress);
    const bool isKnown = contents.info.outline.size() >= 3;
    if (found.room && (found.room->contradictsOutline || !isKnown)) {
        contents.info.outline = found.room->shape.outline;
        contents.info.ceilingM = isKnown ? contents.info.ceilingM : found.room->shape.ceilingM;
    }
    for (const std::string& doubt :
         found.room ? roomDoubts(*found.room, store.room()) : std::vector<std::string>()) {
        progress.warning(doubt);
    }
    contents.info.roomShape = report.roomShape;
    contents.info.highlightRolloff = found.highlightRolloff;
    for (std::size_t i = 0; i < contents.photos.size() && !depth.onlyForScene; ++i) {
        contents.photos[i].depthFile = found.files[i];
        const scene::Gains& gains = found.gains[i];
        contents.photos[i].entry.exposureGain = Eigen::Vector3d(gains[0], gains[1], gains[2]);
    }
}

/// What nobody shall recognise, by the photos' numbers.
std::map<std::int64_t, std::vector<survey::PrivateRegion>> privateRegions(const store::SurveyStore& store) {
    std::map<std::int64_t, std::vector<survey::PrivateRegion>> result;
    for (const store::RegionRecord& record : store.regions()) {
        if (record.origin != store::RegionOrigin::Rejected) {
            result[record.photo].push_back(record.region);
        }
    }
    return result;
}

/// What is written for these photos, and the report as far as it is known before.
dataset::Contents contentsOf(const store::SurveyStore& store, const std::vector<store::PhotoRecord>& photos,
                             ExportReport& report) {
    const Poses poses(store);
    dataset::Contents contents{infoOf(store), {}};
    for (const align::RoomTag& tag : aprilTagsOf(store)) {
        contents.info.tags.push_back({tag.number, tag.corners, tag.sigma});
    }
    const std::string surveyId = store.info().uuid;
    auto regions = privateRegions(store);
    for (const store::PhotoRecord& photo : photos) {
        dataset::SourcePhoto source{store.photoFolder() / photo.fileName, photo.fileSha256, {}};
        source.regions = std::move(regions[photo.id]);
        source.entry.station = store.station(photo.station).name;
        const bool isSolved = poses.fill(photo, source.entry);
        report.withoutRotation += isSolved ? 0 : 1;
        source.tag = {
            surveyId,     photo.station, source.entry.station, source.entry.roomFromPhoto.translation,
            std::nullopt, isSolved};
        if (isSolved) {
            source.tag->roomFromPhoto = source.entry.roomFromPhoto.rotation;
        }
        contents.photos.push_back(std::move(source));
    }
    contents.info.sphereRadiusM = radiusFor(store, contents.photos);
    report.sphereRadiusM = contents.info.sphereRadiusM.value_or(0);
    report.rejected = store.counts().rejectedPhotos;
    report.withoutPhoto = static_cast<int>(store.stationsWithoutPhoto().size()) - report.rejected;
    return contents;
}

} // namespace

void ExportOptions::validate() const {
    if (testEvery < 0 || testEvery == 1) {
        throw Error(ErrorKind::InvalidInput, text("Could not leave one of ", testEvery,
                                                  " photos out for tests: it must be one of 2 or more."));
    }
}

std::size_t countTests(std::size_t photos, int testEvery) {
    std::size_t tests = 0;
    for (std::size_t i = 0; i < photos; ++i) {
        tests += isTestPhoto(i, testEvery) ? 1 : 0;
    }
    if (testEvery > 0 && tests == 0) {
        throw Error(ErrorKind::InvalidInput, text("None of ", counted(photos, "photo", "photos"),
                                                  " would be left out for tests: give "
                                                  "a smaller --test-every."));
    }
    return tests;
}

ExportReport exportDataset(const store::SurveyStore& store, const std::filesystem::path& folder,
                           const ExportOptions& options, ProgressSink& progress,
                           const std::stop_token& stop) {
    options.validate();
    ExportReport report;
    const PhotosToExport exported = photosToExport(store);
    report.failed = static_cast<int>(exported.failed.size());
    for (const std::string& doubt : exported.doubts) {
        progress.warning(doubt);
    }
    if (exported.photos.empty() && !exported.failed.empty()) {
        throw Error(ErrorKind::InvalidInput, text("Nothing can be exported. ", exported.allDoubts()));
    }
    const std::vector<store::PhotoRecord> photos = withoutTests(exported.photos, options.testEvery);
    report.tests = static_cast<int>(countTests(exported.photos.size(), options.testEvery));
    dataset::Contents contents = contentsOf(store, photos, report);
    contents.info.scaleSigma = exported.scaleSigma;
    const DepthCache cache(store, options);
    ProgressStep writing(progress, render::hasSurfaces(options.scene) ? 0.9 : 0, 1);
    if (render::hasSurfaces(options.scene)) {
        ProgressStep finding(progress, 0, 0.9);
        addScene(store, options, cache, contents, report, finding, stop);
        report.sphereRadiusM = contents.info.sphereRadiusM.value_or(0);
    }
    if (report.withoutRotation > 0) {
        progress.warning(
            text("The heading of ", report.withoutRotation, " of ", contents.photos.size(),
                 " photos is not known; they are exported as if each looked along the room's x axis."));
    }
    if (const std::string elsewhere = placesInDoubt(store); !elsewhere.empty()) {
        progress.warning(elsewhere);
    }
    report.written = dataset::writeDataset(contents, folder, options.write, writing, stop);
    return report;
}

dataset::WriteReport exportOne(const store::SurveyStore& store, const store::PhotoRecord& photo,
                               const std::filesystem::path& folder, const dataset::WriteOptions& options,
                               const std::stop_token& stop) {
    ExportReport report;
    return dataset::writeDataset(contentsOf(store, {photo}, report), folder, options, noProgress(), stop);
}

DepthForecast exportForecast(const store::SurveyStore& store, const ExportOptions& options, bool withTrial,
                             const std::stop_token& stop) {
    if (!render::hasSurfaces(options.scene)) {
        return {};
    }
    ExportReport report;
    const dataset::Contents contents =
        contentsOf(store, withoutTests(photosToExport(store).photos, options.testEvery), report);
    const DepthCache cache(store, options);
    ClearedPhotos cleared = clearedPhotos(store, options, cache, contents, report, stop);
    DepthOptions depth = depthOptions(store, options, cache);
    depth.beforeReading = [&](std::size_t photo) { cleared.make(photo, stop); };
    return depthForecast(cleared.inputs(), depth, withTrial, stop);
}

render::SceneKind knownScene(const store::SurveyStore& store, const DepthOptions& depth) {
    const ExportOptions options{{}, render::SceneKind::Depth, depth};
    const DepthForecast forecast = exportForecast(store, options, false, {});
    return forecast.photos > 0 && forecast.missing == 0 ? options.scene : render::SceneKind::Sphere;
}

std::map<std::int64_t, fs::path> keptDepths(const store::SurveyStore& store, const DepthOptions& options,
                                            const std::stop_token& stop) {
    const ExportOptions all{{}, render::SceneKind::Depth, options};
    const DepthCache cache(store, all);
    std::map<std::int64_t, fs::path> kept;
    if (!fs::exists(cache.path())) { // nothing was ever estimated
        return kept;
    }
    ExportReport report;
    const std::vector<store::PhotoRecord> photos = photosToExport(store).photos;
    const dataset::Contents contents = contentsOf(store, photos, report);
    const ClearedPhotos cleared = clearedPhotos(store, all, cache, contents, report, stop);
    const std::vector<fs::path> files = keptDepths(cleared.inputs(), depthOptions(store, all, cache));
    for (std::size_t i = 0; i < photos.size(); ++i) {
        if (!files[i].empty()) {
            kept.emplace(photos[i].id, files[i]);
        }
    }
    return kept;
}

Json toJson(const ExportReport& report) {
    return {{"photos", report.written.photos},
            {"stations_without_photo", report.withoutPhoto},
            {"rejected_photos", report.rejected},
            {"test_photos", report.tests},
            {"failed_photos", report.failed},
            {"photos_without_rotation", report.withoutRotation},
            {"sphere_radius_m", report.sphereRadiusM},
            {"photos_with_depth", report.depth.photos},
            {"depths_reused", report.depth.reused},
            {"depth_seconds", report.depth.seconds},
            {"blurred_photos", report.written.blurredPhotos},
            {"blurred_regions", report.written.blurredRegions},
            {"carried_share", report.carriedShare},
            {"source_bytes", report.written.sourceBytes},
            {"photo_bytes", report.written.photoBytes},
            {"total_bytes", report.written.totalBytes},
            {"seconds", report.written.seconds}};
}

} // namespace spherewalk::jobs
