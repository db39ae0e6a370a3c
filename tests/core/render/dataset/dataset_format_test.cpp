// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "random.h"

#include "spherewalk/base/json.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/dataset_format.h"

namespace spherewalk::render {

using test::expectError;

namespace {

DatasetInfo fullInfo() {
    test::Random random(11);
    DatasetInfo info;
    info.id = "id";
    info.name = "Küche \"1\"";
    info.createdUtc = "2026-01-02T03:04:05.678Z";
    info.madeBy = "spherewalk 0";
    info.surveyId = "survey";
    info.outline = {{0, 0}, {4, 0}, {4, 3}};
    info.obstacles = {{{1, 1}, {2, 1}, {2, 2}}};
    info.ceilingM = 2.6;
    info.stepM = 0.2;
    info.scaleSigma = 0.03;
    info.highlightRolloff = 0.2;
    info.sphereRadiusM = 1.9;
    info.measuredErrorPx = {{SceneKind::Sphere, 5.25}};
    info.choice = ViewChoice{SceneKind::Sphere, Sampling::Bilinear, 8, 5.25, 589, "It holds."};
    SuggestedCamera camera{"vga", CameraIntrinsics::pinhole(640, 480, 1)};
    camera.intrinsics.lens = LensModel::PlumbBob;
    camera.intrinsics.distortion = {1, 2, 3, 4, 5};
    info.cameras = {camera};
    info.tags = {{17, {Eigen::Vector3d(1, 0, 1.6), {1.16, 0, 1.6}, {1.16, 0, 1.44}, {1, 0, 1.44}}, 0.001}};
    for (int i = 0; i < 3; ++i) {
        DatasetPhoto photo;
        photo.file = "photos/" + std::to_string(i) + ".jpg";
        photo.sha256 = std::string(64, 'a');
        photo.sizeBytes = 5'000'000'000 / (i + 2);
        photo.width = 5376;
        photo.height = 2688;
        photo.restartIndex = i == 0 ? "" : "index/a.swri";
        photo.thumbnail = i == 0 ? "" : "thumbnails/a.jpg";
        photo.station = "rail 1, stop 2";
        photo.roomFromPhoto = {random.rotation(), random.vector(1e6)};
        photo.rotationSource = "imported";
        if (i == 1) {
            photo.scene = SceneKind::None;
            photo.exposureGain = Eigen::Vector3d(0.8, 1, 1.25);
            photo.blurredRegions = 3;
            photo.lenses.aheadM = 0.0115;
            photo.positionSigmaM = Eigen::Vector3d(0.01, 0.02, 0.03);
            photo.rotationSigma = RotationSigma{Degrees(0.1), Degrees(0.2), Degrees(0.3)};
        }
        info.photos.push_back(photo);
    }
    return info;
}

/// The sentence with which the description is refused after a change of its JSON.
template <class Change>
void refused(ErrorKind kind, const std::string& part, Change&& change) {
    Json json = toJson(fullInfo());
    change(json);
    expectError(kind, part, [&] { parseDatasetInfo(json, "dataset.json"); });
}

} // namespace

TEST(DatasetFormat, ComesBackAsItWasWritten) {
    const DatasetInfo info = fullInfo();
    const Json json = toJson(info);
    const DatasetInfo again = parseDatasetInfo(parseJson(json.dump(), "x"), "x");
    const auto withoutRotations = [](Json value) { // which are normalised again when read
        for (Json& photo : value["photos"]) {
            photo.erase("room_from_photo");
        }
        return value;
    };
    EXPECT_EQ(withoutRotations(toJson(again)), withoutRotations(json));
    EXPECT_EQ(again.outline, info.outline);
    EXPECT_EQ(again.sphereRadiusM, info.sphereRadiusM);
    EXPECT_EQ(again.scaleSigma, info.scaleSigma);
    EXPECT_EQ(again.highlightRolloff, info.highlightRolloff);
    for (std::size_t i = 0; i < info.photos.size(); ++i) {
        EXPECT_EQ(again.photos[i].roomFromPhoto.translation, info.photos[i].roomFromPhoto.translation);
        EXPECT_LT(angleBetween(again.photos[i].roomFromPhoto.rotation, info.photos[i].roomFromPhoto.rotation)
                      .value(),
                  1e-15);
    }
    EXPECT_FALSE(again.photos[0].rotationSigma);
    EXPECT_FALSE(again.photos[0].exposureGain);
    EXPECT_EQ(again.photos[1].exposureGain, info.photos[1].exposureGain);
    EXPECT_EQ(again.photos[0].blurredRegions, 0);
    EXPECT_EQ(again.photos[1].blurredRegions, 3);
    EXPECT_EQ(again.photos[0].lenses.aheadM, 0);
    EXPECT_EQ(again.photos[1].lenses.aheadM, 0.0115);
    EXPECT_NEAR(Degrees(again.photos[1].rotationSigma->roll).value(), 0.3, 1e-12);
}

TEST(DatasetFormat, RefusesExposuresThatCannotBe) {
    for (const char* gain : {"[0, 1, 1]", "[1, 1, 100]", "[1, 1]", "[-1, 1, 1]", "\"bright\""}) {
        refused(ErrorKind::Corrupt, "/photos/0/exposure_gain",
                [&](Json& json) { json["photos"][0]["exposure_gain"] = parseJson(gain, "a gain"); });
    }
}

TEST(DatasetFormat, RefusesLensesThatCannotBe) {
    for (const char* ahead : {"0.2", "-0.11", "\"far\""}) {
        refused(ErrorKind::Corrupt, "/photos/0/lens_ahead_m",
                [&](Json& json) { json["photos"][0]["lens_ahead_m"] = parseJson(ahead, "lenses"); });
    }
    Json older = toJson(fullInfo());
    older["photos"][1].erase("lens_ahead_m");
    EXPECT_EQ(parseDatasetInfo(older, "dataset.json").photos[1].lenses.aheadM, 0);
}

TEST(DatasetFormat, RefusesTagsThatCannotBe) {
    const auto tag = [](const std::string& key, const Json& value, const std::string& part) {
        refused(ErrorKind::Corrupt, part, [&](Json& json) { json["april_tags"][0][key] = value; });
    };
    tag("number", 587, "/april_tags/0/number");
    tag("number", -1, "/april_tags/0/number");
    tag("sigma_m", -1, "/april_tags/0/sigma_m");
    tag("sigma_m", 1e300, "/april_tags/0/sigma_m");
    tag("corners_m", Json::array({{0, 0, 0}}), "expected four corners");
    tag("corners_m", Json::array({{0, 0}, {0, 0}, {0, 0}, {0, 0}}), "/april_tags/0/corners_m/0");
    tag("corners_m", Json::array({{1, 0, 1}, {2, 0, 1}, {2, 0, 1}, {1, 0, 0}}), "sides of at least");
    refused(ErrorKind::Corrupt, "tag 17 is listed twice",
            [](Json& json) { json["april_tags"].push_back(json["april_tags"][0]); });
    Json older = toJson(fullInfo());
    older.erase("april_tags");
    EXPECT_TRUE(parseDatasetInfo(older, "dataset.json").tags.empty());
}

TEST(DatasetFormat, RefusesOtherFormatsAndVersions) {
    refused(ErrorKind::Unsupported, "version 99", [](Json& json) { json["version"] = 99; });
    refused(ErrorKind::Corrupt, "expected a whole number", [](Json& json) { json["version"] = "1"; });
    refused(ErrorKind::Corrupt, "not the description of a dataset",
            [](Json& json) { json["format"] = "other"; });
    refused(ErrorKind::Corrupt, "not the description of a dataset", [](Json& json) { json.erase("format"); });
    refused(ErrorKind::Corrupt, "not the description of a dataset", [](Json& json) { json = Json::array(); });
}

TEST(DatasetFormat, RefusesNamesThatLeadOutOfTheDataset) {
    for (const char* name : {"../photos/a.jpg", "photos/../../a.jpg", "/etc/passwd", "photos", "a.jpg",
                             "photos//a.jpg", "photos/a\n.jpg", ""}) {
        refused(ErrorKind::Corrupt, "/photos/1/file", [&](Json& json) { json["photos"][1]["file"] = name; });
    }
    refused(ErrorKind::Corrupt, "/photos/1/restart_index",
            [](Json& json) { json["photos"][1]["restart_index"] = "index/../x"; });
    refused(ErrorKind::Corrupt, "/photos/1/thumbnail",
            [](Json& json) { json["photos"][1]["thumbnail"] = "photos/0.jpg"; });
}

TEST(DatasetFormat, RefusesValuesThatCannotBe) {
    const auto photo = [](const std::string& key, const Json& value, const std::string& part) {
        refused(ErrorKind::Corrupt, part, [&](Json& json) { json["photos"][2][key] = value; });
    };
    photo("width", 5375, "5375 x 2688");
    photo("width", 1e300, "whole number");
    photo("size_bytes", -1, "from 1 to");
    photo("size_bytes", 0, "from 1 to");
    photo("sha256", "zz", "64 lower-case");
    photo("position_m", {1, 2}, "three numbers");
    photo("position_m", {1, 2, 1e300}, "expected a number from");
    photo("position_m", {1, 2, nullptr}, "expected a number");
    photo("room_from_photo", {{"w", 0}, {"x", 0}, {"y", 0}, {"z", 0}}, "unit quaternion");
    photo("room_from_photo", {{"w", 1}}, "\"x\" is missing");
    photo("rotation_sigma_deg", {{"yaw", -1}, {"pitch", 0}, {"roll", 0}}, "from 0 to 360");
    refused(ErrorKind::Corrupt, "has no photos", [](Json& json) { json["photos"] = Json::array(); });
    refused(ErrorKind::Corrupt, "/scene_models/0/radius_m",
            [](Json& json) { json["scene_models"][0]["radius_m"] = 0; });
    refused(ErrorKind::Corrupt, "lens model is unknown",
            [](Json& json) { json["suggested_cameras"][0]["distortion_model"] = "x"; });
    refused(ErrorKind::Corrupt, "focal lengths", [](Json& json) { json["suggested_cameras"][0]["fx"] = -1; });
}

// Whatever member is missing, or has another type, the sentence names its place and nothing is assumed.
TEST(DatasetFormat, SurvivesEveryMissingAndMistypedMember) {
    const Json whole = toJson(fullInfo());
    const std::vector<Json> wrongs{
        Json(), 1, -1.5, "text", true, Json::array(), Json::object(), Json::array({Json::array()})};
    int refusals = 0;
    const Json members = whole.flatten();
    for (const auto& [pointer, value] : members.items()) {
        for (const Json& wrong : wrongs) {
            Json changed = whole;
            changed[Json::json_pointer(pointer)] = wrong;
            try {
                parseDatasetInfo(changed, "dataset.json");
            } catch (const Error& error) {
                ++refusals;
                EXPECT_NE(error.sentence().find("dataset.json"), std::string::npos) << pointer;
            }
        }
    }
    EXPECT_GT(refusals, 300);
}

TEST(DatasetFormat, RefusesAChoiceThatCannotBe) {
    const auto with = [](const char* key, const Json& value) {
        return [=](Json& json) { json["choice"][key] = value; };
    };
    refused(ErrorKind::Corrupt, "/choice/scene", with("scene", "magic"));
    refused(ErrorKind::Corrupt, "/choice", with("scene", "depth")); // which the dataset does not have
    refused(ErrorKind::Corrupt, "/choice/sampling", with("sampling", "auto"));
    refused(ErrorKind::Corrupt, "/choice/tolerance_px", with("tolerance_px", 0));
    refused(ErrorKind::Corrupt, "/choice/error_px", with("error_px", -1));
    refused(ErrorKind::Corrupt, "/choice/camera_focal_px", with("camera_focal_px", 1e300));
    refused(ErrorKind::Corrupt, "/photos/0", [](Json& json) { json["photos"][0]["scene"] = "room"; });
    refused(ErrorKind::Corrupt, "measured_error_px",
            [](Json& json) { json["scene_models"][0]["measured_error_px"] = -2; });
}

TEST(DatasetFormat, TakesWhatWasChosenWhereItHoldsForTheCamera) {
    DatasetInfo info = fullInfo();
    const CameraIntrinsics measured = CameraIntrinsics::pinhole(640, 480, 1);
    const CameraIntrinsics longer = CameraIntrinsics::pinhole(1280, 960, 1);
    info.roomShape = RoomShape{info.outline, 0, 2.6};
    EXPECT_EQ(autoScene(info, 0, measured), SceneKind::Sphere);
    EXPECT_EQ(autoScene(info, 1, measured), SceneKind::None); // enough about that photo
    EXPECT_EQ(autoScene(info, 1, longer), SceneKind::Room);   // the best, since nothing was measured for it
    EXPECT_EQ(autoSampling(info, Sampling::Auto, measured), Sampling::Bilinear);
    EXPECT_EQ(autoSampling(info, Sampling::Nearest, measured), Sampling::Nearest);
    EXPECT_EQ(autoSampling(info, Sampling::Auto, longer), Sampling::Auto);
}

TEST(DatasetFormat, KeepsWhatItDoesNotKnowWhenAChoiceIsWritten) {
    Json json = toJson(fullInfo());
    json["of_a_later_version"] = 7;
    const ViewChoice choice{SceneKind::None, Sampling::Nearest, 30, 26.5, 589, ""};
    putMeasured(json, choice, {{SceneKind::Sphere, 6.5}}, {SceneKind::None, std::nullopt, std::nullopt});
    EXPECT_EQ(json["of_a_later_version"], 7);
    const DatasetInfo again = parseDatasetInfo(json, "x");
    EXPECT_EQ(again.choice, choice);
    EXPECT_EQ(again.measuredErrorPx.at(SceneKind::Sphere), 6.5);
    EXPECT_EQ(again.photos[0].scene, SceneKind::None);
    EXPECT_FALSE(again.photos[1].scene);
    expectError(ErrorKind::Corrupt, "photos", [&] { putMeasured(json, choice, {}, {std::nullopt}); });
}

} // namespace spherewalk::render
