// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "parts/practice_dataset.h"
#include "random.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/jobs/measure_dataset.h"
#include "spherewalk/jobs/measure_page.h"
#include "spherewalk/jobs/measured_dataset.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/render/colour_correction.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spherewalk::jobs {

using render::SceneKind;
using test::PracticeDataset;
using testing::HasSubstr;

namespace {

const PracticeDataset& room() {
    static const PracticeDataset dataset(2);
    return dataset;
}

MeasureOptions quick() {
    MeasureOptions options;
    options.mostViews = 4;
    options.samplingViews = 1;
    return options;
}

MeasureReport measuredWith(const MeasureOptions& options, const std::stop_token& stop = {}) {
    return measureDataset(room().renderer(), PracticeDataset::camera(), options, noProgress(), stop);
}

/// Errors alone: times differ from run to run.
std::vector<double> errorsOf(const MeasureReport& report) {
    std::vector<double> errors;
    for (const SceneLikeness& scene : report.scenes) {
        for (const ViewLikeness& view : scene.views) {
            errors.insert(errors.end(), {view.looks.psnrDb, view.looks.ssim, view.looks.falseEdges,
                                         view.looks.missedEdges, view.looks.bendPx.value_or(-1),
                                         view.p95Px.value_or(-1), static_cast<double>(view.missed)});
        }
    }
    return errors;
}

std::size_t filesIn(const std::filesystem::path& folder) {
    const std::filesystem::directory_iterator files(folder);
    return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

} // namespace

TEST(MeasureDataset, RanksTheSceneModels) {
    const MeasureReport report = measuredWith(quick());
    ASSERT_EQ(report.scenes.size(), 5U);
    EXPECT_EQ(report.scenes.front().views.size(), 4U);
    EXPECT_GT(report.scenes[0].exactP95Px.value(), 2 * report.scenes[3].exactP95Px.value());
    EXPECT_GT(report.scenes[3].looks.mean.psnrDb, report.scenes[1].looks.mean.psnrDb);
    EXPECT_GT(report.scenes[3].looks.mean.ssim, report.scenes[1].looks.mean.ssim);
    EXPECT_LT(report.scenes[3].looks.mean.falseEdges, report.scenes[1].looks.mean.falseEdges);
    EXPECT_LT(report.scenes[3].looks.mean.missedEdges, report.scenes[1].looks.mean.missedEdges);
    EXPECT_LT(report.scenes[3].missedShare, report.scenes[0].missedShare);
    EXPECT_GE(report.scenes[4].looks.mean.ssim, report.scenes[3].looks.mean.ssim); // mixed, not one
    EXPECT_EQ(report.rungs.size(), 25U);
    for (const Rung& rung : report.rungs) {
        EXPECT_GT(rung.renderMs, 0);
    }
    EXPECT_GT(report.rungs.back().bytes, report.rungs.front().bytes);
}

// Photos of automatic exposure are no worse for that.
TEST(MeasureDataset, ComparesViewsAsBrightAsThePhotoThatIsLeftOut) {
    constexpr std::array kExposures = {0.75, 1.0, 0.9, 0.7};
    const PracticeDataset dark(2);
    const std::filesystem::path file = dark.path() / render::kDatasetFile;
    const auto report = [&] {
        return measureDataset(dark.renderer(), PracticeDataset::camera(), quick(), noProgress(), {});
    };
    const MeasureReport even = report();
    const auto measured = [&](bool areGainsKnown) {
        Json json = parseJson(textOf(readFile(file)), "the dataset");
        for (std::size_t i = 0; i < kExposures.size(); ++i) {
            Json& photo = json["photos"][i];
            const double gain = 1 / kExposures.at(i);
            photo["exposure_gain"] = areGainsKnown ? Json({gain, gain, gain}) : Json();
        }
        writeFile(file, bytesOf(json.dump()));
        return report();
    };
    Json json = parseJson(textOf(readFile(file)), "the dataset");
    for (std::size_t i = 0; i < kExposures.size(); ++i) {
        Json& photo = json["photos"][i];
        const std::filesystem::path picture = dark.path() / photo["file"].get<std::string>();
        RgbImage pixels = jpeg::decode(readFile(picture), "a photo");
        render::expose(pixels, Eigen::Vector3d::Constant(kExposures.at(i)), 0);
        const Bytes bytes = jpeg::encode(pixels, 95);
        writeFile(picture, bytes);
        photo["sha256"] = sha256Hex(bytes);
        photo["size_bytes"] = bytes.size();
    }
    writeFile(file, bytesOf(json.dump()));
    const MeasureReport unknown = measured(false);
    const MeasureReport known = measured(true);
    for (std::size_t i = 0; i < even.scenes.size(); ++i) {
        const auto& looks = known.scenes[i].looks.mean;
        EXPECT_GT(looks.ssim, unknown.scenes[i].looks.mean.ssim + 0.02) << i;
        EXPECT_GT(looks.psnrDb, unknown.scenes[i].looks.mean.psnrDb + 2) << i;
    }
    EXPECT_NEAR(known.scenes[3].looks.mean.ssim, even.scenes[3].looks.mean.ssim, 0.02);
}

TEST(MeasureDataset, SaysHowMuchViewsChangeAtBorders) {
    const MeasureReport report = measuredWith(quick());
    ASSERT_EQ(report.borders.size(), 5U);
    const BorderJump& sphere = report.borders[1];
    const BorderJump& depth = report.borders[3];
    const BorderJump& blend = report.borders[4];
    EXPECT_GE(depth.borders, 2U);
    EXPECT_GT(depth.psnrDb, sphere.psnrDb + 3);
    EXPECT_GT(blend.psnrDb, depth.psnrDb + 3); // both photos count the same there
    EXPECT_LE(depth.worstPsnrDb, depth.psnrDb);
    EXPECT_LT(depth.medianPx.value(), sphere.medianPx.value());
    EXPECT_THAT(measureText(report), HasSubstr("half way between two photos"));
    EXPECT_EQ(toJson(report)["borders"].size(), 5U);
}

TEST(MeasureDataset, CountsFeaturesOrPixels) {
    const auto errorOf = [](const MeasureReport& report, SceneKind scene) {
        const auto rung = std::find_if(report.rungs.begin(), report.rungs.end(), [&](const Rung& one) {
            return one.scene == scene && one.sampling == render::Sampling::Footprint;
        });
        return rung->errorPx;
    };
    MeasureOptions options = quick();
    const MeasureReport features = measuredWith(options);
    options.places = Places::Pixels;
    const MeasureReport pixels = measuredWith(options);
    for (std::size_t i = 0; i < features.scenes.size(); ++i) {
        const SceneLikeness& scene = features.scenes[i];
        EXPECT_EQ(errorOf(features, scene.scene), scene.p95Px);
        EXPECT_EQ(errorOf(pixels, scene.scene), scene.exactP95Px);
        EXPECT_GT(pixels.scenes[i].photos.front().places, features.scenes[i].photos.front().places);
    }
    EXPECT_EQ(places(name(Places::Pixels)), Places::Pixels);
    test::expectError(ErrorKind::InvalidInput, "features and pixels", [] { places("voxels"); });
}

TEST(MeasureDataset, LeavesOutEveryPhotoBeforeAnyTwice) {
    MeasureOptions options = quick();
    options.scene = SceneKind::None;
    const MeasureReport report = measuredWith(options);
    EXPECT_EQ(report.scenes.front().photos.size(), 4U);
    std::vector<double> turns;
    for (const ViewLikeness& view : report.scenes.front().views) {
        turns.push_back(std::round(std::atan2(view.axis().y(), view.axis().x()) / 1.57));
    }
    std::sort(turns.begin(), turns.end());
    EXPECT_EQ(std::unique(turns.begin(), turns.end()) - turns.begin(), 4); // each in another direction
}

TEST(MeasureDataset, GoesOnWhereItWasStoppedWithTheSameErrors) {
    const test::TemporaryFolder folder;
    MeasureOptions options = quick();
    options.cacheFolder = folder / "results";
    options.threads = 1;

    struct StopAtHalf : ProgressSink {
        void progress(double fraction, std::string_view /*activity*/) override {
            if (fraction > 0.5) {
                source.request_stop();
            }
        }

        void warning(std::string_view /*sentence*/) override {}

        std::stop_source source;
    } half;

    test::expectError(ErrorKind::Stopped, "", [&] {
        measureDataset(room().renderer(), PracticeDataset::camera(), options, half, half.source.get_token());
    });
    const std::size_t kept = filesIn(options.cacheFolder);
    EXPECT_GT(kept, 1U);
    EXPECT_LT(kept, 4U);
    const MeasureReport report = measuredWith(options);
    EXPECT_EQ(report.reusedViews, kept);
    EXPECT_EQ(errorsOf(report), errorsOf(measuredWith(quick())));
}

TEST(MeasureDataset, PutsPartsOfOtherProcessesTogether) {
    const test::TemporaryFolder folder;
    MeasureOptions options = quick();
    options.scene = SceneKind::Sphere;
    test::expectError(ErrorKind::InvalidInput, "folder", [&] {
        measurePart(room().renderer(), PracticeDataset::camera(), options, {}, noProgress(), {});
    });
    options.cacheFolder = folder.path();
    for (const char* shard : {"2/3", "1/3", "3/3", "1/3"}) {
        const MeasuredPart part = measurePart(room().renderer(), PracticeDataset::camera(), options,
                                              Shard::parse(shard), noProgress(), {});
        EXPECT_EQ(part.ofViews, 4U);
        EXPECT_GE(part.views, 1U);
    }
    const MeasureReport together = measuredWith(options);
    EXPECT_EQ(together.reusedViews, 4U);
    options.cacheFolder.clear();
    EXPECT_EQ(errorsOf(together), errorsOf(measuredWith(options)));
}

TEST(MeasureDataset, MakesDamagedResultsAnew) {
    const test::TemporaryFolder folder;
    MeasureOptions options = quick();
    options.mostViews = 2;
    options.scene = SceneKind::Sphere;
    options.cacheFolder = folder.path();
    const MeasureReport first = measuredWith(options);
    for (const auto& file : std::filesystem::directory_iterator(folder.path())) {
        writeFile(file.path(), bytesOf("\x9f\x01 no such thing"));
    }
    const MeasureReport second = measuredWith(options);
    EXPECT_EQ(second.reusedViews, 0U);
    EXPECT_EQ(errorsOf(first), errorsOf(second));
    EXPECT_EQ(measuredWith(options).reusedViews, 2U);
}

TEST(MeasureDataset, StoresTheChoiceForViewsThatAskForNone) {
    const PracticeDataset dataset(2); // of its own, since it is changed
    const auto sceneOf = [&] {
        return dataset.renderer()
            .render(PracticeDataset::camera(), {bodyFromOptical(), {1.95, 1.7, 1.2}})
            .report.scene;
    };
    EXPECT_EQ(sceneOf(), SceneKind::Depth); // the best
    MeasureOptions options = quick();
    options.tolerancePx = 900;
    MeasureReport report =
        measureDataset(dataset.renderer(), PracticeDataset::camera(), options, noProgress(), {});
    report.choice.rung = 1; // whichever was the fastest: the second sampling without a scene model
    storeChoice(dataset.path(), report);
    EXPECT_EQ(sceneOf(), SceneKind::None); // enough for such a tolerance
    const render::Renderer renderer = dataset.renderer();
    EXPECT_EQ(renderer.dataset().info().choice, viewChoice(report));
    EXPECT_EQ(renderer.dataset().info().measuredErrorPx.size(), 4U);
    render::ViewOptions automatic;
    automatic.sampling = render::Sampling::Auto;
    EXPECT_EQ(renderer.render(PracticeDataset::camera(), {bodyFromOptical(), {1.95, 1.7, 1.2}}, automatic)
                  .report.sampling,
              render::Sampling::Bilinear);
}

// What is chosen by leaving photos out holds for pictures from between them. Errors are told in size and
// order. All places are as far from a photo, so that the distance alone tells no order.
TEST(MeasureDataset, ForetellsTheErrorsOfPicturesFromBetweenThePhotos) {
    practice::PracticeRoomOptions flat;
    flat.sizeM = {8, 6, 2.6};
    flat.style = practice::RoomStyle::Flat;
    const Eigen::Vector2d corner(1.4, 2.6);
    const PracticeDataset dataset(3, true, flat, corner);
    const test::TemporaryFolder folder;
    MeasureOptions options = quick();
    options.mostViews = 36;
    test::Random random(85);
    for (int i = 0; i < 24; ++i) {
        const Eigen::Vector2d photo = corner + PracticeDataset::kStepM * Eigen::Vector2d(i % 3, i / 3 % 3);
        const double towards = random.uniform(-3, 3);
        const Eigen::Vector2d at = photo + 0.09 * Eigen::Vector2d(std::cos(towards), std::sin(towards));
        const Rigid3 pose{(yawRotation(Radians(random.uniform(-3, 3))) * bodyFromOptical()).normalized(),
                          {at.x(), at.y(), 1.2}};
        const std::filesystem::path file = folder / (std::to_string(i) + ".png");
        photo::writePng(file, dataset.room().view(PracticeDataset::camera(), pose));
        options.pictures.push_back({file, {}, pose});
    }
    const MeasureReport report =
        measureDataset(dataset.renderer(), PracticeDataset::camera(), options, noProgress(), {});
    EXPECT_FALSE(report.isLeaveOneOut);
    ASSERT_TRUE(report.leaveOneOut);
    ASSERT_EQ(report.predictions.size(), 5U);
    for (const std::size_t i : {0, 1}) { // the others' errors are below those of finding features
        const Prediction& prediction = report.predictions[i];
        SCOPED_TRACE(name(prediction.scene));
        EXPECT_GT(prediction.rankCorrelation.value(), 0.45);
        EXPECT_GT(prediction.factor.value(), 0.6);
        EXPECT_LT(prediction.factor.value(), 1.7);
        const double ratio = betweenPx(*report.leaveOneOut, report.leaveOneOut->scenes[i]).value() /
                             report.scenes[i].medianPx.value();
        EXPECT_GT(ratio, 0.5);
        EXPECT_LT(ratio, 2);
    }
    EXPECT_NEAR(report.leaveOneOut->viewM, PracticeDataset::kStepM, 1e-6);
    EXPECT_NEAR(report.leaveOneOut->betweenM, 0.08, 0.01);
    EXPECT_THAT(measureText(report), HasSubstr("times the found one, at the median"));
    EXPECT_THAT(measureText(report),
                HasSubstr("expect about this median error in views of the same directions: none"));
    EXPECT_THAT(measureText(*report.leaveOneOut), HasSubstr(" times nearer"));
    for (const Choice& choice : report.leaveOneOut->choices) {
        if (choice.isWithin) {
            EXPECT_LE(report.rungs[*choice.rung].errorPx.value(), choice.tolerancePx);
        }
    }
}

TEST(MeasureDataset, RefusesPicturesOfAnotherSize) {
    const test::TemporaryFolder folder;
    photo::writePng(folder / "p.png", RgbImage(20, 20));
    MeasureOptions options = quick();
    options.pictures = {{folder / "p.png", {}, {}}};
    test::expectError(ErrorKind::InvalidInput, "240 x 180", [&] { measuredWith(options); });
}

TEST(MeasurePage, NeedsNoNetworkAndShowsWhatWasFound) {
    const test::TemporaryFolder folder;
    MeasureOptions options = quick();
    options.worst = 1;
    const MeasureReport report = measuredWith(options);
    const render::Renderer renderer = room().renderer();
    writeReport({&renderer.dataset().info(), &report, nullptr}, folder.path());
    const std::string page = readTextFile(folder / "report.html");
    EXPECT_THAT(page, HasSubstr("<svg"));
    EXPECT_THAT(page, HasSubstr("report-3.jpg"));
    EXPECT_THAT(page, HasSubstr("Error by direction"));
    EXPECT_EQ(photo::readPicture(folder / "report-1.jpg").width(), 240);
    for (std::size_t at = page.find("http"); at != std::string::npos; at = page.find("http", at + 1)) {
        EXPECT_EQ(page.substr(at, 26), "http://www.w3.org/2000/svg"); // a name, never fetched
    }
    EXPECT_THAT(readTextFile(folder / "report.pdf"), testing::StartsWith("%PDF"));
    EXPECT_THAT(page, HasSubstr("false edges %"));
    EXPECT_THAT(page, HasSubstr("missed %"));
    const Json measured = parseJson(readTextFile(folder / "report.json"), "x")["measured"];
    EXPECT_EQ(measured["photos"], 4);
    const Json& scene = measured["scenes"][0];
    EXPECT_EQ(scene["mean_ssim"], report.scenes[0].looks.mean.ssim);
    EXPECT_EQ(scene["worst_false_edges"], report.scenes[0].looks.worst.falseEdges);
    EXPECT_EQ(scene["missed_share"], report.scenes[0].missedShare);
    EXPECT_EQ(scene["views"][0]["missed_edges"], report.scenes[0].views[0].looks.missedEdges);
    EXPECT_EQ(measured["rungs"][0]["cost"], nominalCost(SceneKind::None, render::Sampling::Nearest));
}

} // namespace spherewalk::jobs
