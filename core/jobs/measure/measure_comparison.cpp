// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/measure_comparison.h"

#include "parts/cache_key.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/looks.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/render/colour_correction.h"
#include "spherewalk/render/renderer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace spherewalk::jobs {

namespace {

constexpr int kComparisonMethod = 11; ///< grows when the same dataset and picture give other comparisons
constexpr std::uint64_t kLargestCacheFile = 64ULL << 20;
constexpr int kMostHundredths = PlaceErrors::kMostHundredths;
constexpr int kMostMillimetres = 10'000'000;
constexpr std::size_t kMostValues = 10'000'000;

std::vector<int> integers(const JsonReader& list) {
    std::vector<int> result;
    const std::size_t count = list.arraySize(kMostValues);
    result.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        result.push_back(static_cast<int>(list.element(i).asInteger(0, kMostHundredths)));
    }
    return result;
}

constexpr std::size_t kIntegersOfThing = 4;

std::vector<int> integersOf(const std::vector<SeenThing>& things) {
    std::vector<int> result;
    for (const SeenThing& thing : things) {
        for (const double value : {1e3 * thing.at.x(), 1e3 * thing.at.y(), 1e3 * thing.at.z(),
                                   std::min(100 * thing.errorPx, double{kMostHundredths})}) {
            result.push_back(static_cast<int>(std::lround(value)));
        }
    }
    return result;
}

std::vector<SeenThing> thingsOf(const JsonReader& list) {
    std::vector<SeenThing> result(list.arraySize(kMostValues) / kIntegersOfThing);
    for (std::size_t i = 0; i < result.size(); ++i) {
        const auto value = [&](std::size_t k) {
            const auto least = k == 3 ? 0 : -kMostMillimetres;
            return static_cast<double>(
                list.element(kIntegersOfThing * i + k).asInteger(least, kMostMillimetres));
        };
        result[i] = {1e-3 * Eigen::Vector3d(value(0), value(1), value(2)), 1e-2 * value(3)};
    }
    return result;
}

Json jsonOf(const Comparisons& comparisons) {
    Json views = Json::array();
    for (const auto& [with, comparison] : comparisons.views) {
        views.push_back({{"scene", name(with.first)},
                         {"sampling", name(with.second)},
                         {"photo", comparison.photo},
                         {"looks", toJson(comparison.looks)},
                         {"features", comparison.features.found},
                         {"missed", comparison.features.missed},
                         {"exact", comparison.exact},
                         {"things", integersOf(comparison.things)}});
    }
    Json samplings = Json::array();
    for (const auto& [sampling, errors] : comparisons.samplings) {
        samplings.push_back({{"sampling", name(sampling)}, {"errors", errors}});
    }
    return {{"views", views}, {"samplings", samplings}};
}

Comparisons comparisonsOf(const JsonReader& reader, std::size_t photos) {
    Comparisons result;
    const JsonReader views = reader.member("views");
    for (std::size_t i = 0; i < views.arraySize(kMostValues); ++i) {
        const JsonReader entry = views.element(i);
        result.views[{render::sceneKind(entry.string("scene")), render::sampling(entry.string("sampling"))}] =
            {static_cast<std::size_t>(entry.integer("photo", 0, static_cast<std::int64_t>(photos) - 1)),
             looksOf(entry.member("looks")),
             {integers(entry.member("features")),
              static_cast<std::size_t>(entry.integer("missed", 0, kMostHundredths))},
             integers(entry.member("exact")),
             thingsOf(entry.member("things"))};
    }
    const JsonReader samplings = reader.member("samplings");
    for (std::size_t i = 0; i < samplings.arraySize(kSamplings.size()); ++i) {
        const JsonReader entry = samplings.element(i);
        result.samplings[render::sampling(entry.string("sampling"))] = integers(entry.member("errors"));
    }
    return result;
}

/// The dataset as views depend on it: not on what was measured.
std::string contextOf(render::DatasetInfo info, const CameraIntrinsics& camera) {
    info.choice.reset();
    info.measuredErrorPx.clear();
    for (render::DatasetPhoto& photo : info.photos) {
        photo.scene.reset();
    }
    return sha256Hex(
        bytesOf(text("measure ", kComparisonMethod, "\n", keyOf(camera), "\n", render::toJson(info).dump())));
}

} // namespace

render::View viewOf(const TruePicture& truth, const render::Renderer& renderer, const CameraModel& camera,
                    const SceneAndSampling& with) {
    render::ViewOptions wanted;
    wanted.scene = with.first;
    wanted.sampling = with.second;
    wanted.threads = 1; // pictures are compared beside each other
    wanted.without = truth.without;
    wanted.wantsDepth = !truth.depth.empty();
    render::View view = renderer.render(camera, truth.roomFromCamera, wanted);
    const render::DatasetInfo& info = renderer.dataset().info();
    const auto& gain = info.photos[view.report.photo].exposureGain;
    if (gain && truth.exposureGain) {
        render::expose(view.picture, gain->cwiseQuotient(*truth.exposureGain), info.highlightRolloff);
    }
    return view;
}

namespace {

/// Every so many pixels of a row and rows. Things farther than 10 km count as none.
constexpr int kThingEvery = 32;

std::vector<SeenThing> thingsAt(const std::vector<compare::Displacement>& displacements,
                                const TruePicture& truth, const CameraModel& camera) {
    std::vector<SeenThing> things;
    for (const compare::Displacement& displacement : displacements) {
        const Eigen::Vector2i pixel = displacement.pixel.cast<int>();
        const auto ray = camera.ray(displacement.pixel);
        const double z = *truth.depth.at(pixel.x(), pixel.y());
        if (pixel.x() % kThingEvery == 0 && pixel.y() % kThingEvery == 0 && ray &&
            z < 1e-3 * kMostMillimetres) {
            things.push_back({truth.roomFromCamera.rotation * (z / ray->z() * *ray), displacement.errorPx});
        }
    }
    return things;
}

Comparison compared(const TruePicture& truth, const compare::PictureFeatures& features,
                    const std::vector<compare::PictureLine>& lines, const render::Renderer& renderer,
                    const CameraModel& camera, const SceneAndSampling& with) {
    const render::View view = viewOf(truth, renderer, camera, with);
    Comparison result;
    result.photo = view.report.photo;
    result.looks = looksOf(truth.picture, lines, view.picture);
    result.features =
        placeErrors(compare::placeDisplacements(features, compare::PictureFeatures(view.picture)));
    if (!truth.depth.empty()) {
        const Eigen::Vector3d photoAt =
            renderer.dataset().info().photos[result.photo].roomFromPhoto.translation;
        const std::vector<compare::Displacement> exact =
            compare::exactDisplacements(camera, truth.roomFromCamera, photoAt, truth.depth, view.depth);
        result.exact = hundredths(exact);
        result.things = thingsAt(exact, truth, camera);
    }
    return result;
}

} // namespace

bool compareMissing(const std::vector<render::SceneKind>& scenes, render::Sampling sampling,
                    const std::function<TruePicture()>& picture, const render::Renderer& renderer,
                    const CameraModel& camera, const std::stop_token& stop, Comparisons& known) {
    std::vector<SceneAndSampling> missing;
    for (const render::SceneKind scene : scenes) {
        if (!known.views.contains({scene, sampling})) {
            missing.emplace_back(scene, sampling);
        }
    }
    throwIfStopped(stop);
    if (missing.empty()) {
        return false;
    }
    const TruePicture truth = picture();
    const compare::PictureFeatures features(truth.picture);
    const std::vector<compare::PictureLine> lines = compare::straightLines(truth.picture);
    for (const SceneAndSampling& rung : missing) {
        throwIfStopped(stop);
        known.views[rung] = compared(truth, features, lines, renderer, camera, rung);
    }
    return true;
}

SamplingErrors samplingErrors(const TruePictures::Place& place, const render::Renderer& renderer,
                              const CameraModel& camera) {
    render::ViewOptions wanted;
    wanted.scene = render::SceneKind::None; // the pixels of one photo, wherever they should be
    wanted.threads = 1;
    wanted.without = place.without;
    const auto features = [&](render::Sampling sampling) {
        wanted.sampling = sampling;
        return compare::PictureFeatures(renderer.render(camera, place.roomFromCamera, wanted).picture);
    };
    const compare::PictureFeatures best = features(render::Sampling::Best);
    SamplingErrors errors;
    for (const render::Sampling sampling : kSamplings) {
        errors[sampling] = hundredths(compare::matchedDisplacements(best, features(sampling)));
    }
    return errors;
}

ComparisonCache::ComparisonCache(std::filesystem::path folder, const render::DatasetInfo& info,
                                 const CameraIntrinsics& camera)
    : m_folder(std::move(folder)), m_photos(info.photos.size()) {
    if (m_folder.empty()) {
        return;
    }
    m_context = contextOf(info, camera);
    ensureFolder(m_folder);
}

std::filesystem::path ComparisonCache::fileOf(const std::string& pictureKey) const {
    return m_folder / (sha256Hex(bytesOf(m_context + "\n" + pictureKey)).substr(0, 32) + ".cbor");
}

Comparisons ComparisonCache::read(const std::string& pictureKey) const {
    if (m_folder.empty() || !std::filesystem::is_regular_file(fileOf(pictureKey))) {
        return {};
    }
    const std::filesystem::path file = fileOf(pictureKey);
    const Bytes bytes = readFile(file, kLargestCacheFile);
    try {
        const Json json = Json::from_cbor(bytes);
        return comparisonsOf(JsonReader(json, file.string()), m_photos);
    } catch (const Json::exception& /*damaged*/) {
        return {};
    } catch (const Error& /*damaged*/) {
        return {};
    }
}

void ComparisonCache::write(const std::string& pictureKey, const Comparisons& comparisons) const {
    if (!m_folder.empty()) {
        writeFile(fileOf(pictureKey), Json::to_cbor(jsonOf(comparisons)));
    }
}

namespace {

TruePicture robotTruePicture(const RobotPicture& picture, const CameraModel& camera) {
    TruePicture truth{picture.roomFromCamera, readRobotPicture(picture, camera), {}, {}};
    if (!picture.depthFile.empty()) {
        truth.depth = photo::readDepthPng(picture.depthFile);
    }
    return truth;
}

std::string fileKey(const std::filesystem::path& file) {
    return file.empty() ? "-" : sha256HexOfFile(file);
}

/// How far away the photo says things are, along the camera's axis; empty if it says nothing.
DepthImage depthFromPhoto(const render::Renderer& renderer, std::size_t photo, const CameraModel& camera,
                          const Rigid3& roomFromCamera) {
    if (renderer.dataset().info().photos[photo].depth.empty()) {
        return {};
    }
    render::ViewOptions view;
    view.scene = render::SceneKind::Depth;
    view.sampling = render::Sampling::Nearest; // its pixels are not looked at
    view.threads = 1;
    view.wantsDepth = true;
    return renderer.render(camera, roomFromCamera, view).depth;
}

} // namespace

std::vector<SpreadView> spreadViews(std::size_t photos, int directions, std::size_t most) {
    const auto turns = static_cast<std::size_t>(directions);
    const std::size_t count = std::min(photos * turns, most);
    const std::size_t spread = std::min(photos, count);
    std::set<SpreadView> views;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = k % spread;
        views.insert({i * photos / spread, (i + k / spread) % turns});
    }
    return {views.begin(), views.end()};
}

TruePictures robotTruePictures(const MeasureOptions& options, const CameraModel& camera) {
    return {options.pictures.size(),
            [&](std::size_t i) {
                const RobotPicture& picture = options.pictures[i];
                return TruePictures::Place{picture.file.filename().string(), picture.roomFromCamera, {}};
            },
            [&](std::size_t i) { return robotTruePicture(options.pictures[i], camera); },
            [&](std::size_t i) {
                const RobotPicture& picture = options.pictures[i];
                return text(fileKey(picture.file), " ", fileKey(picture.depthFile), " ",
                            keyOf(picture.roomFromCamera));
            }};
}

Rigid3 levelPose(const render::DatasetPhoto& photo, Radians turn) {
    const Eigen::Quaterniond rotation = (yawRotation(turn) * bodyFromOptical()).normalized();
    const Eigen::Vector3d ahead =
        photo.roomFromPhoto.rotation.conjugate() * (rotation * Eigen::Vector3d::UnitZ());
    return {rotation, photo.roomFromPhoto * photo.lenses.place(ahead)};
}

render::Sampling samplingFor(render::Sampling wanted, const render::Dataset& dataset,
                             const CameraModel& camera) {
    const std::vector<render::DatasetPhoto>& photos = dataset.info().photos;
    const double ratio = photos.empty() ? 1 : render::minification(camera, photos.front().width);
    return render::chosenSampling(wanted, ratio, render::ViewOptions{}.toleranceDb);
}

RgbImage truthFromPhoto(const render::Renderer& renderer, const CameraModel& camera,
                        const Rigid3& roomFromCamera) {
    render::ViewOptions view;
    view.scene = render::SceneKind::None; // from its own place a photo is the truth, in the best sampling
    view.threads = 1;
    return renderer.render(camera, roomFromCamera, view).picture;
}

TruePictures leftOutTruePictures(const MeasureOptions& options, const render::Renderer& renderer,
                                 const CameraModel& camera) {
    const std::vector<render::DatasetPhoto>& photos = renderer.dataset().info().photos;
    if (photos.size() < 2) {
        return {};
    }
    const std::vector<SpreadView> views =
        spreadViews(photos.size(), options.directions, static_cast<std::size_t>(options.mostViews));
    const double step = 2 * std::numbers::pi / options.directions;
    const auto place = [=, &photos](std::size_t i) {
        const std::size_t photo = views[i].photo;
        const Radians turn(step * static_cast<double>(views[i].direction));
        return TruePictures::Place{text(photos[photo].file, " ", std::lround(Degrees(turn).value()), " deg"),
                                   levelPose(photos[photo], turn), photo};
    };
    const auto get = [=, &renderer, &camera](std::size_t i) {
        const TruePictures::Place at = place(i);
        return TruePicture{at.roomFromCamera, truthFromPhoto(renderer, camera, at.roomFromCamera),
                           depthFromPhoto(renderer, *at.without, camera, at.roomFromCamera), at.without,
                           photos[*at.without].exposureGain};
    };
    const auto key = [=](std::size_t i) {
        return text("left out ", views[i].photo, " ", step * static_cast<double>(views[i].direction));
    };
    return {views.size(), place, get, key};
}

} // namespace spherewalk::jobs
