// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/dataset_format.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <array>

namespace spherewalk::render {

using Eigen::Vector3d;

namespace {

constexpr std::size_t kMostPhotos = 1'000'000;
constexpr std::size_t kMostVertices = 100'000;
constexpr double kFarthestM = 1e8;
constexpr double kGreatestGain = 32;
constexpr double kFarthestLensM = 0.1;
constexpr double kMostErrorPx = 1e6;
constexpr double kLeastTagM = 0.001;

Json listOf(const Vector3d& v) {
    return Json::array({v.x(), v.y(), v.z()});
}

Json listOf(const Polygon& polygon) {
    Json result = Json::array();
    for (const Eigen::Vector2d& vertex : polygon) {
        result.push_back({vertex.x(), vertex.y()});
    }
    return result;
}

template <class Item>
Json listOf(const std::vector<Item>& items, Json (*jsonOf)(const Item&)) {
    Json result = Json::array();
    for (const Item& item : items) {
        result.push_back(jsonOf(item));
    }
    return result;
}

template <class Item>
std::vector<Item> listFrom(const JsonReader& list, std::size_t most, Item (*itemOf)(const JsonReader&)) {
    std::vector<Item> result;
    for (std::size_t i = 0; i < list.arraySize(most); ++i) {
        result.push_back(itemOf(list.element(i)));
    }
    return result;
}

Json optionalText(const std::string& value) {
    return value.empty() ? Json() : Json(value);
}

double boundedNumber(const JsonReader& reader, double least, double most) {
    const double value = reader.asNumber();
    if (!(value >= least && value <= most)) {
        reader.fail(text("expected a number from ", least, " to ", most));
    }
    return value;
}

/// A member that may be absent.
double numberOr(double fallback, const JsonReader& reader, std::string_view key, double least, double most) {
    return reader.isAbsent(key) ? fallback : boundedNumber(reader.member(key), least, most);
}

Vector3d vectorOf(const JsonReader& list, double least, double most) {
    if (list.arraySize() != 3) {
        list.fail("expected three numbers");
    }
    Vector3d result;
    for (int i = 0; i < 3; ++i) {
        result[i] = boundedNumber(list.element(static_cast<std::size_t>(i)), least, most);
    }
    return result;
}

Polygon polygonOf(const JsonReader& list) {
    Polygon result;
    for (std::size_t i = 0; i < list.arraySize(kMostVertices); ++i) {
        const JsonReader vertex = list.element(i);
        if (vertex.arraySize() != 2) {
            vertex.fail("expected two numbers");
        }
        result.emplace_back(boundedNumber(vertex.element(0), -kFarthestM, kFarthestM),
                            boundedNumber(vertex.element(1), -kFarthestM, kFarthestM));
    }
    return result;
}

/// The name of a file of the dataset, or "" if the member is absent.
std::string fileName(const JsonReader& photo, std::string_view key, std::string_view folder) {
    if (photo.isAbsent(key)) {
        return {};
    }
    std::string result = photo.string(key);
    if (!isSafeRelativePath(result) || !result.starts_with(folder)) {
        photo.member(key).fail(
            text("\"", printable(result), "\" is not the name of a file under ", folder, " of the dataset"));
    }
    return result;
}

Json photoJson(const DatasetPhoto& photo) {
    const Eigen::Quaterniond& q = photo.roomFromPhoto.rotation;
    Json rotationSigma;
    if (photo.rotationSigma) {
        rotationSigma = {{"yaw", Degrees(photo.rotationSigma->yaw).value()},
                         {"pitch", Degrees(photo.rotationSigma->pitch).value()},
                         {"roll", Degrees(photo.rotationSigma->roll).value()}};
    }
    return {{"file", photo.file},
            {"sha256", photo.sha256},
            {"size_bytes", photo.sizeBytes},
            {"width", photo.width},
            {"height", photo.height},
            {"restart_index", optionalText(photo.restartIndex)},
            {"thumbnail", optionalText(photo.thumbnail)},
            {"depth", optionalText(photo.depth)},
            {"station", photo.station},
            {"position_m", listOf(photo.roomFromPhoto.translation)},
            {"position_sigma_m", photo.positionSigmaM ? listOf(*photo.positionSigmaM) : Json()},
            {"room_from_photo", {{"w", q.w()}, {"x", q.x()}, {"y", q.y()}, {"z", q.z()}}},
            {"rotation_sigma_deg", rotationSigma},
            {"lens_ahead_m", photo.lenses.aheadM},
            {"exposure_gain", photo.exposureGain ? listOf(*photo.exposureGain) : Json()},
            {"rotation_source", photo.rotationSource},
            {"scene", photo.scene ? Json(name(*photo.scene)) : Json()},
            {"blurred_regions", photo.blurredRegions}};
}

Eigen::Quaterniond rotationOf(const JsonReader& photo) {
    const JsonReader q = photo.member("room_from_photo");
    const double w = q.number("w");
    const double x = q.number("x");
    const double y = q.number("y");
    const double z = q.number("z");
    try {
        return checkedQuaternion(w, x, y, z, "the photo");
    } catch (const Error& error) {
        q.fail(error.sentence());
    }
}

RotationSigma rotationSigmaOf(const JsonReader& sigma) {
    const auto angle = [&](std::string_view key) {
        return Degrees(boundedNumber(sigma.member(key), 0, 360));
    };
    return {angle("yaw"), angle("pitch"), angle("roll")};
}

DatasetPhoto photoOf(const JsonReader& reader) {
    DatasetPhoto photo;
    photo.file = fileName(reader, "file", "photos/");
    if (photo.file.empty()) {
        reader.fail("the member \"file\" is missing");
    }
    photo.sha256 = reader.string("sha256");
    constexpr std::string_view kDigits = "0123456789abcdef";
    if (photo.sha256.size() != 64 || photo.sha256.find_first_not_of(kDigits) != std::string::npos) {
        reader.member("sha256").fail("expected 64 lower-case hexadecimal digits");
    }
    photo.sizeBytes = static_cast<std::uint64_t>(reader.integer("size_bytes", 1, 1LL << 32));
    photo.width = static_cast<int>(reader.integer("width", 16, 16384));
    photo.height = static_cast<int>(reader.integer("height", 1, 16384));
    if (photo.width != 2 * photo.height) {
        reader.fail(text("the photo is ", photo.width, " x ", photo.height,
                         " pixels, and an equirectangular picture is twice as wide as high"));
    }
    photo.restartIndex = fileName(reader, "restart_index", "index/");
    photo.thumbnail = fileName(reader, "thumbnail", "thumbnails/");
    photo.depth = fileName(reader, "depth", "depth/");
    photo.station = reader.isAbsent("station") ? "" : reader.string("station");
    photo.roomFromPhoto = {rotationOf(reader),
                           vectorOf(reader.member("position_m"), -kFarthestM, kFarthestM)};
    photo.rotationSource = reader.isAbsent("rotation_source") ? "unknown" : reader.string("rotation_source");
    if (!reader.isAbsent("position_sigma_m")) {
        photo.positionSigmaM = vectorOf(reader.member("position_sigma_m"), 0, kFarthestM);
    }
    if (!reader.isAbsent("rotation_sigma_deg")) {
        photo.rotationSigma = rotationSigmaOf(reader.member("rotation_sigma_deg"));
    }
    photo.lenses.aheadM = numberOr(0, reader, "lens_ahead_m", -kFarthestLensM, kFarthestLensM);
    if (!reader.isAbsent("exposure_gain")) {
        photo.exposureGain = vectorOf(reader.member("exposure_gain"), 1 / kGreatestGain, kGreatestGain);
    }
    if (!reader.isAbsent("scene")) {
        photo.scene = sceneKind(reader, "scene");
    }
    photo.blurredRegions = reader.isAbsent("blurred_regions") ? 0 : reader.integer("blurred_regions", 0);
    return photo;
}

Json cameraJson(const SuggestedCamera& camera) {
    const CameraIntrinsics& k = camera.intrinsics;
    return {{"name", camera.name},
            {"width", k.width},
            {"height", k.height},
            {"fx", k.fx},
            {"fy", k.fy},
            {"cx", k.cx},
            {"cy", k.cy},
            {"distortion_model", name(k.lens)},
            {"distortion", k.distortion}};
}

SuggestedCamera cameraOf(const JsonReader& reader) {
    SuggestedCamera camera{reader.string("name"), {}};
    CameraIntrinsics& k = camera.intrinsics;
    k.width = static_cast<int>(reader.integer("width", 1, 32768));
    k.height = static_cast<int>(reader.integer("height", 1, 32768));
    k.fx = reader.number("fx");
    k.fy = reader.number("fy");
    k.cx = reader.number("cx");
    k.cy = reader.number("cy");
    const std::optional<LensModel> lens = lensNamed(reader.string("distortion_model"));
    if (!lens) {
        reader.member("distortion_model").fail("the lens model is unknown");
    }
    k.lens = *lens;
    const JsonReader distortion = reader.member("distortion");
    for (std::size_t i = 0; i < distortion.arraySize(CameraIntrinsics::kMostDistortion); ++i) {
        k.distortion.push_back(distortion.element(i).asNumber());
    }
    try {
        k.validate();
    } catch (const Error& error) {
        reader.fail(error.sentence());
    }
    return camera;
}

Json tagJson(const DatasetTag& tag) {
    Json corners = Json::array();
    for (const Eigen::Vector3d& corner : tag.cornersM) {
        corners.push_back(listOf(corner));
    }
    return {{"number", tag.number}, {"sigma_m", tag.sigmaM}, {"corners_m", corners}};
}

DatasetTag tagOf(const JsonReader& reader) {
    DatasetTag tag;
    constexpr int kLastNumber = 586; // Of the family 36h11.
    tag.number = static_cast<int>(reader.integer("number", 0, kLastNumber));
    tag.sigmaM = boundedNumber(reader.member("sigma_m"), 0, kFarthestM);
    const JsonReader corners = reader.member("corners_m");
    if (corners.arraySize() != tag.cornersM.size()) {
        corners.fail("expected four corners");
    }
    for (std::size_t i = 0; i < tag.cornersM.size(); ++i) {
        tag.cornersM[i] = vectorOf(corners.element(i), -kFarthestM, kFarthestM);
    }
    for (std::size_t i = 0; i < tag.cornersM.size(); ++i) {
        if (!((tag.cornersM[i] - tag.cornersM[(i + 1) % 4]).norm() >= kLeastTagM)) {
            corners.fail(text("expected sides of at least ", kLeastTagM, " m"));
        }
    }
    return tag;
}

std::vector<DatasetTag> tagsOf(const JsonReader& root) {
    std::vector<DatasetTag> tags;
    const std::size_t count = root.isAbsent("april_tags") ? 0 : root.member("april_tags").arraySize(1000);
    for (std::size_t i = 0; i < count; ++i) {
        tags.push_back(tagOf(root.member("april_tags").element(i)));
        if (std::ranges::count(tags, tags.back().number, &DatasetTag::number) > 1) {
            root.member("april_tags").element(i).fail(text("tag ", tags.back().number, " is listed twice"));
        }
    }
    return tags;
}

void checkVersion(const JsonReader& root, const std::string& source) {
    if (root.isAbsent("format") || root.member("format").value() != kDatasetFormat) {
        throw Error(ErrorKind::Corrupt,
                    text("Could not open ", source, ": it is not the description of a dataset."));
    }
    const std::int64_t version = root.integer("version", 1);
    if (version != kDatasetVersion) {
        throw Error(ErrorKind::Unsupported,
                    text("Could not open ", source, ": the dataset has version ", version,
                         ", and this program reads version ", kDatasetVersion,
                         "; export it again, or use a newer Spherewalk."));
    }
}

void readRoom(const JsonReader& room, DatasetInfo& info) {
    info.outline = polygonOf(room.member("outline_m"));
    info.obstacles = listFrom(room.member("obstacles_m"), kMostVertices, polygonOf);
    info.ceilingM = boundedNumber(room.member("ceiling_m"), 0, kFarthestM);
}

RoomShape roomShapeOf(const JsonReader& model) {
    const RoomShape shape{polygonOf(model.member("outline_m")),
                          boundedNumber(model.member("floor_m"), -kFarthestM, kFarthestM),
                          boundedNumber(model.member("ceiling_m"), -kFarthestM, kFarthestM)};
    try {
        shape.validate();
    } catch (const Error& error) {
        model.fail(error.sentence());
    }
    return shape;
}

void readSceneModels(const JsonReader& models, DatasetInfo& info) {
    for (std::size_t i = 0; i < models.arraySize(100); ++i) {
        const JsonReader model = models.element(i);
        const std::string kind = model.string("kind"); // kinds of later versions are left out
        if (kind != "sphere" && kind != "room" && kind != "depth" && kind != "blend") {
            continue;
        }
        if (!model.isAbsent("measured_error_px")) {
            const double errorPx = boundedNumber(model.member("measured_error_px"), 0, kMostErrorPx);
            info.measuredErrorPx[sceneKind(model, "kind")] = errorPx;
        }
        if (kind == "sphere") {
            info.sphereRadiusM = boundedNumber(model.member("radius_m"), 1e-3, kFarthestM);
        } else if (kind == "room") {
            info.roomShape = roomShapeOf(model);
        }
    }
}

Json measuredErrorPx(const DatasetInfo& info, SceneKind kind) {
    return info.measuredErrorPx.contains(kind) ? Json(info.measuredErrorPx.at(kind)) : Json();
}

/// Scene models that the dataset does not have cannot have been chosen.
void checkChoice(const DatasetInfo& info, const JsonReader& root) {
    const std::vector<SceneKind> there = scenesOf(info);
    const auto isThere = [&](SceneKind kind) { return std::ranges::find(there, kind) != there.end(); };
    if (info.choice && !isThere(info.choice->scene)) {
        root.member("choice").fail("the dataset does not have the scene model that was chosen");
    }
    for (std::size_t i = 0; i < info.photos.size(); ++i) {
        if (info.photos[i].scene && !isThere(*info.photos[i].scene)) {
            root.member("photos").element(i).fail("the dataset does not have the photo's scene model");
        }
    }
}

} // namespace

void putMeasured(Json& description, const ViewChoice& choice, const std::map<SceneKind, double>& errorPx,
                 const std::vector<std::optional<SceneKind>>& photoScenes) {
    const JsonReader root(description, "the dataset's description");
    const std::size_t photos = root.member("photos").arraySize(kMostPhotos);
    const std::size_t models = root.member("scene_models").arraySize(100);
    if (!photoScenes.empty() && photoScenes.size() != photos) {
        root.member("photos").fail(text("expected ", photoScenes.size(), " photos"));
    }
    description["choice"] = toJson(choice);
    for (std::size_t i = 0; i < photos; ++i) {
        const bool isKnown = !photoScenes.empty() && photoScenes[i];
        description["photos"][i]["scene"] = isKnown ? Json(name(*photoScenes[i])) : Json();
    }
    for (std::size_t i = 0; i < models; ++i) {
        Json& model = description["scene_models"][i];
        for (const auto& [kind, px] : errorPx) {
            if (model.value("kind", "") == name(kind)) {
                model["measured_error_px"] = px;
            }
        }
    }
}

Json toJson(const DatasetInfo& info) {
    Json obstacles = Json::array();
    for (const Polygon& obstacle : info.obstacles) {
        obstacles.push_back(listOf(obstacle));
    }
    Json models = Json::array();
    if (info.sphereRadiusM) {
        models.push_back({{"kind", "sphere"},
                          {"radius_m", *info.sphereRadiusM},
                          {"measured_error_px", measuredErrorPx(info, SceneKind::Sphere)}});
    }
    if (info.roomShape) {
        models.push_back({{"kind", "room"},
                          {"outline_m", listOf(info.roomShape->outline)},
                          {"floor_m", info.roomShape->floorM},
                          {"ceiling_m", info.roomShape->ceilingM},
                          {"measured_error_px", measuredErrorPx(info, SceneKind::Room)}});
    }
    for (const SceneKind kind : scenesOf(info)) {
        if (usesDepths(kind)) {
            models.push_back({{"kind", name(kind)}, {"measured_error_px", measuredErrorPx(info, kind)}});
        }
    }
    return {
        {"format", kDatasetFormat},
        {"version", kDatasetVersion},
        {"id", info.id},
        {"name", info.name},
        {"created_utc", info.createdUtc},
        {"made_by", info.madeBy},
        {"survey_id", info.surveyId},
        {"frames",
         {{"room", "right-handed, x and y on the floor, z up, metres"},
          {"photo", "x forward (the picture's centre), y left, z up; room_from_photo takes photo to room"}}},
        {"room",
         {{"outline_m", listOf(info.outline)}, {"obstacles_m", obstacles}, {"ceiling_m", info.ceilingM}}},
        {"grid", {{"step_m", info.stepM}}},
        {"scale_sigma", info.scaleSigma},
        {"highlight_rolloff", info.highlightRolloff},
        {"scene_models", models},
        {"choice", info.choice ? toJson(*info.choice) : Json()},
        {"colour_correction", info.colour ? toJson(*info.colour) : Json()},
        {"april_tags", listOf(info.tags, tagJson)},
        {"suggested_cameras", listOf(info.cameras, cameraJson)},
        {"photos", listOf(info.photos, photoJson)}};
}

DatasetInfo parseDatasetInfo(const Json& json, const std::string& source) {
    const JsonReader root(json, source);
    checkVersion(root, source);
    DatasetInfo info;
    info.id = root.string("id");
    info.name = root.string("name");
    info.createdUtc = root.string("created_utc");
    info.madeBy = root.string("made_by");
    info.surveyId = root.string("survey_id");
    readRoom(root.member("room"), info);
    info.scaleSigma = numberOr(0, root, "scale_sigma", 0, 1);
    info.highlightRolloff = numberOr(0, root, "highlight_rolloff", 0, 0.5);
    info.stepM = boundedNumber(root.member("grid").member("step_m"), 0, kFarthestM);
    readSceneModels(root.member("scene_models"), info);
    info.choice =
        root.isAbsent("choice") ? std::nullopt : std::optional(parseViewChoice(root.member("choice")));
    if (!root.isAbsent("colour_correction")) {
        info.colour = parseColourCorrection(root.member("colour_correction"));
    }
    info.tags = tagsOf(root);
    info.cameras = listFrom(root.member("suggested_cameras"), 1000, cameraOf);
    info.photos = listFrom(root.member("photos"), kMostPhotos, photoOf);
    if (info.photos.empty()) {
        root.member("photos").fail("the dataset has no photos");
    }
    checkChoice(info, root);
    return info;
}

} // namespace spherewalk::render
