// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure_comparison.h"

#include "cache_key.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/sha256.h"
#include "spherewalk/base/text.h"
#include "spherewalk/photo/picture_file.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::jobs {

namespace {

constexpr int kMethod = 5; ///< grows when the same dataset and subject give other comparisons
constexpr double kMostDb = 99;
constexpr std::uint64_t kLargestFile = 64ULL << 20;
constexpr int kMostHundredths = 10'000'000;
constexpr int kMostMillimetres = 10'000'000;
constexpr std::size_t kMostValues = 10'000'000;

std::vector<int> hundredths(const std::vector<measure::Displacement>& displacements) {
    std::vector<int> result;
    result.reserve(displacements.size());
    for (const measure::Displacement& displacement : displacements) {
        result.push_back(
            static_cast<int>(std::lround(std::min(100 * displacement.errorPx, double{kMostHundredths}))));
    }
    return result;
}

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
                         {"psnr_db", comparison.psnrDb},
                         {"ssim", comparison.ssim},
                         {"matched", comparison.matched},
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
             entry.number("psnr_db"),
             entry.number("ssim"),
             integers(entry.member("matched")),
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
        bytesOf(text("measure ", kMethod, "\n", keyOf(camera), "\n", render::toJson(info).dump())));
}

} // namespace

render::View viewOf(const Subject& subject, const render::Renderer& renderer, const CameraModel& camera,
                    const SceneAndSampling& with) {
    render::ViewOptions wanted;
    wanted.scene = with.first;
    wanted.sampling = with.second;
    wanted.threads = 1; // subjects are compared beside each other
    wanted.without = subject.without;
    wanted.wantsDepth = !subject.depth.empty();
    return renderer.render(camera, subject.roomFromCamera, wanted);
}

namespace {

/// Every so many pixels of a row and rows. Things farther than 10 km count as none.
constexpr int kThingEvery = 32;

std::vector<SeenThing> thingsAt(const std::vector<measure::Displacement>& displacements,
                                const Subject& subject, const CameraModel& camera) {
    std::vector<SeenThing> things;
    for (const measure::Displacement& displacement : displacements) {
        const Eigen::Vector2i pixel = displacement.pixel.cast<int>();
        const auto ray = camera.ray(displacement.pixel);
        const double z = *subject.depth.at(pixel.x(), pixel.y());
        if (pixel.x() % kThingEvery == 0 && pixel.y() % kThingEvery == 0 && ray &&
            z < 1e-3 * kMostMillimetres) {
            things.push_back({subject.roomFromCamera.rotation * (z / ray->z() * *ray), displacement.errorPx});
        }
    }
    return things;
}

Comparison compared(const Subject& subject, const measure::PictureFeatures& features,
                    const render::Renderer& renderer, const CameraModel& camera,
                    const SceneAndSampling& with) {
    const render::View view = viewOf(subject, renderer, camera, with);
    Comparison result;
    result.photo = view.report.photo;
    result.psnrDb = std::min(kMostDb, photo::psnr(subject.picture, view.picture));
    result.ssim = photo::structuralSimilarity(subject.picture, view.picture);
    result.matched =
        hundredths(measure::matchedDisplacements(features, measure::PictureFeatures(view.picture)));
    if (!subject.depth.empty()) {
        const Eigen::Vector3d photoAt =
            renderer.dataset().info().photos[result.photo].roomFromPhoto.translation;
        const std::vector<measure::Displacement> exact =
            measure::exactDisplacements(camera, subject.roomFromCamera, photoAt, subject.depth, view.depth);
        result.exact = hundredths(exact);
        result.things = thingsAt(exact, subject, camera);
    }
    return result;
}

} // namespace

bool compareMissing(const std::vector<render::SceneKind>& scenes, render::Sampling sampling,
                    const std::function<Subject()>& subject, const render::Renderer& renderer,
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
    const Subject truth = subject();
    const measure::PictureFeatures features(truth.picture);
    for (const SceneAndSampling& rung : missing) {
        throwIfStopped(stop);
        known.views[rung] = compared(truth, features, renderer, camera, rung);
    }
    return true;
}

SamplingErrors samplingErrors(const Subjects::Place& place, const render::Renderer& renderer,
                              const CameraModel& camera) {
    render::ViewOptions wanted;
    wanted.scene = render::SceneKind::None; // the pixels of one photo, wherever they should be
    wanted.threads = 1;
    wanted.without = place.without;
    const auto features = [&](render::Sampling sampling) {
        wanted.sampling = sampling;
        return measure::PictureFeatures(renderer.render(camera, place.roomFromCamera, wanted).picture);
    };
    const std::size_t photo =
        renderer.dataset().nearestPhoto(place.roomFromCamera.translation, place.without);
    const measure::PictureFeatures best = features(bestSampling(renderer, photo, camera));
    SamplingErrors errors;
    for (const render::Sampling sampling : kSamplings) {
        errors[sampling] = hundredths(measure::matchedDisplacements(best, features(sampling)));
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

std::filesystem::path ComparisonCache::fileOf(const std::string& subjectKey) const {
    return m_folder / (sha256Hex(bytesOf(m_context + "\n" + subjectKey)).substr(0, 32) + ".cbor");
}

Comparisons ComparisonCache::read(const std::string& subjectKey) const {
    if (m_folder.empty() || !std::filesystem::is_regular_file(fileOf(subjectKey))) {
        return {};
    }
    const std::filesystem::path file = fileOf(subjectKey);
    const Bytes bytes = readFile(file, kLargestFile);
    try {
        const Json json = Json::from_cbor(bytes);
        return comparisonsOf(JsonReader(json, file.string()), m_photos);
    } catch (const Json::exception& /*damaged*/) {
        return {};
    } catch (const Error& /*damaged*/) {
        return {};
    }
}

void ComparisonCache::write(const std::string& subjectKey, const Comparisons& comparisons) const {
    if (!m_folder.empty()) {
        writeFile(fileOf(subjectKey), Json::to_cbor(jsonOf(comparisons)));
    }
}

} // namespace spherewalk::jobs
