// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "random.h"
#include "temporary_folder.h"
#include "test_dataset.h"

#include "spherewalk/base/json.h"
#include "spherewalk/render/colour_correction.h"
#include "spherewalk/render/renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace spherewalk::render {

namespace {

const CameraModel kCamera(CameraIntrinsics::pinhole(64, 48, 1.0));

ColourCorrection madeCorrection(test::Random& random) {
    ColourCorrection correction;
    for (double& entry : std::span(correction.matrix.data(), 9)) {
        entry += random.uniform(-0.3, 0.3);
    }
    for (ColourCorrection::Curve& curve : correction.curves) {
        const double power = random.uniform(0.7, 1.4);
        for (double& value : curve) {
            value = std::pow(value, power);
        }
    }
    return correction;
}

RgbImage anyColours(test::Random& random, int width, int height) {
    RgbImage picture(width, height);
    for (std::uint8_t& value : picture.values()) {
        value = static_cast<std::uint8_t>(random.integer(0, 255));
    }
    return picture;
}

RgbImage corrected(const ColourCorrection& correction, const CameraModel& camera, RgbImage picture,
                   int threads = 0) {
    WorkerPool pool(4);
    ColourTables(correction).apply(picture, PixelRays(camera, pool), pool, threads);
    return picture;
}

/// What is read of a correction whose JSON was changed.
ColourCorrection readWith(const std::function<void(Json&)>& change) {
    Json json = toJson(ColourCorrection());
    change(json);
    return parseColourCorrection(JsonReader(json, "x.json", "/colour_correction"));
}

} // namespace

TEST(ColourCorrection, ThatCorrectsNothingChangesNoValueOfAnyChannel) {
    RgbImage picture(256, 3);
    for (int y = 0; y < 3; ++y) {
        for (int value = 0; value < 256; ++value) {
            std::fill_n(picture.at(value, y), 3, static_cast<std::uint8_t>(255 - value));
            picture.at(value, y)[y] = static_cast<std::uint8_t>(value);
        }
    }
    const CameraModel camera(CameraIntrinsics::pinhole(256, 3, 1.0));
    EXPECT_EQ(corrected({}, camera, picture), picture);
}

TEST(ExposedValue, FollowsTheGainWhereItIsDarkAndEndsAtWhite) {
    for (const double rolloff : {0.0, 0.001, 0.02, 0.15, 0.3, 0.5}) {
        for (const double gain : {0.05, 0.7, 0.999, 1.0, 1.001, 1.4, 20.0}) {
            double before = -1;
            for (int value = 0; value <= 255; ++value) {
                const double exposed = exposedValue(value, gain, rolloff);
                EXPECT_GE(exposed, before - 1e-9) << rolloff << " " << gain << " " << value;
                EXPECT_LE(exposed, 255 + 1e-9);
                EXPECT_LE(std::abs(std::log((exposed + 1e-9) / (value + 1e-9))),
                          std::abs(std::log(gain)) + 1e-6);
                if (value * std::max(1.0, gain) < 64 && rolloff <= 0.15) {
                    EXPECT_NEAR(exposed, gain * value, 1e-3 * gain * value);
                }
                if (rolloff >= 0.15 && std::abs(std::log(gain)) < 1) { // else all light is in one level
                    EXPECT_NEAR(exposedValue(exposed, 1 / gain, rolloff), value, 1e-6);
                    // What two changes of exposure make of it, one of both makes of it.
                    EXPECT_NEAR(exposedValue(exposed, 1.3, rolloff), exposedValue(value, 1.3 * gain, rolloff),
                                1e-6);
                }
                before = exposed;
            }
            EXPECT_NEAR(exposedValue(255, gain, rolloff), rolloff >= 0.01 ? 255 : std::min(255.0, 255 * gain),
                        1e-9);
        }
    }
}

TEST(ColourCorrection, LightAndStoredValuesTurnBackIntoEachOther) {
    for (double stored = 0; stored <= 1; stored += 0.001) {
        EXPECT_NEAR(storedValue(linearLight(stored)), stored, 1e-12);
    }
}

TEST(ColourCorrection, ByTablesIsWithinTwoLevelsOfItsDefinition) {
    test::Random random(5);
    for (int round = 0; round < 20; ++round) {
        const ColourCorrection correction = madeCorrection(random);
        const RgbImage picture = anyColours(random, 64, 48);
        const RgbImage by = corrected(correction, kCamera, picture);
        for (std::size_t i = 0; i < picture.values().size(); i += 3) {
            const Eigen::Vector3d stored(picture.values()[i], picture.values()[i + 1],
                                         picture.values()[i + 2]);
            const Eigen::Vector3d exact = 255 * correction.corrected(stored / 255);
            for (std::size_t c = 0; c < 3; ++c) {
                ASSERT_NEAR(by.values()[i + c], exact[static_cast<Eigen::Index>(c)], 2);
            }
        }
    }
}

TEST(ColourCorrection, GivesTheSameBytesWithAnyNumberOfThreads) {
    test::Random random(6);
    const ColourCorrection correction = madeCorrection(random);
    const RgbImage picture = anyColours(random, 64, 48);
    EXPECT_EQ(corrected(correction, kCamera, picture, 1), corrected(correction, kCamera, picture, 4));
}

TEST(ColourCorrection, LeavesBlackWhatTheLensDoesNotSee) {
    CameraIntrinsics fisheye{64, 48, 14, 14, 31.5, 23.5, LensModel::Equidistant, {-0.2, 0, 0, 0}};
    const CameraModel camera(fisheye);
    ASSERT_FALSE(camera.ray({0, 0})) << "the corner is to lie outside of the lens's field";
    ColourCorrection brighter;
    for (ColourCorrection::Curve& curve : brighter.curves) {
        std::fill(curve.begin(), curve.end(), 0.5);
    }
    const RgbImage picture = corrected(brighter, camera, RgbImage(64, 48));
    EXPECT_EQ(*picture.at(0, 0), 0);
    EXPECT_EQ(*picture.at(32, 24), 128);
}

TEST(ColourCorrection, IsReadAsItWasWritten) {
    test::Random random(7);
    const ColourCorrection correction = madeCorrection(random);
    EXPECT_EQ(parseColourCorrection(JsonReader(toJson(correction), "x.json")), correction);
}

TEST(ColourCorrection, RefusesHostileValues) {
    const auto refused = [](const std::function<void(Json&)>& change) {
        test::expectError(ErrorKind::Corrupt, "x.json", [&] { readWith(change); });
    };
    EXPECT_NO_THROW(readWith([](Json&) {}));
    refused([](Json& json) { json["matrix"][1][2] = 8.5; });
    refused([](Json& json) { json["matrix"][1][2] = "1"; });
    refused([](Json& json) { json["matrix"][1][2] = nullptr; });
    refused([](Json& json) { json["matrix"].push_back({0, 0, 1}); });
    refused([](Json& json) { json["matrix"][0].push_back(0); });
    refused([](Json& json) { json.erase("matrix"); });
    refused([](Json& json) { json["curves"][0][3] = 0.0; }); // falls
    refused([](Json& json) { json["curves"][2][16] = 2.5; });
    refused([](Json& json) { json["curves"][2].erase(0); });
    refused([](Json& json) { json["curves"] = 3; });
}

TEST(ColourCorrection, RefusesNumbersThatAreNone) {
    ColourCorrection correction;
    correction.matrix(0, 0) = std::numeric_limits<double>::quiet_NaN();
    test::expectError(ErrorKind::InvalidInput, "matrix", [&] { ColourTables{correction}; });
    ColourCorrection other;
    other.curves[1][4] = std::numeric_limits<double>::infinity();
    test::expectError(ErrorKind::InvalidInput, "curve", [&] { ColourTables{other}; });
}

class CorrectedDataset : public testing::Test {
  protected:
    CorrectedDataset() {
        DatasetInfo info = test::writeTestDataset(m_folder.path(), {Rigid3{}}, test::smoothWorld, 256);
        m_correction.matrix.diagonal() = Eigen::Vector3d(0.6, 1, 1.3);
        info.colour = m_correction;
        test::rewriteInfo(m_folder.path(), info);
    }

    View view(const ViewOptions& options) const {
        return Renderer(std::make_shared<const Dataset>(Dataset::open(m_folder.path())))
            .render(kCamera, {}, options);
    }

    ColourCorrection m_correction;
    test::TemporaryFolder m_folder;
};

TEST_F(CorrectedDataset, GivesViewsInTheCorrectedColours) {
    ViewOptions plain;
    plain.correctsColour = false;
    const RgbImage photo = view(plain).picture;
    const RgbImage picture = view({}).picture;
    EXPECT_EQ(picture, corrected(m_correction, kCamera, photo));
    EXPECT_NE(picture, photo);
}

TEST_F(CorrectedDataset, LeavesOverlaysTheirOwnColours) {
    Overlay overlay;
    overlay.camera = kCamera.intrinsics();
    overlay.picture = RgbaImage(64, 48);
    overlay.depth = DepthImage(64, 48);
    std::fill(overlay.picture.values().begin(), overlay.picture.values().end(), std::uint8_t{200});
    for (int i = 3; i < 4 * 64 * 48; i += 4) {
        overlay.picture.values()[static_cast<std::size_t>(i)] = 255;
    }
    std::fill(overlay.depth.values().begin(), overlay.depth.values().end(), 1.0F);
    ViewOptions options;
    options.overlays = {&overlay, 1};
    const RgbImage picture = view(options).picture;
    EXPECT_TRUE(
        std::all_of(picture.values().begin(), picture.values().end(), [](int v) { return v == 200; }));
}

} // namespace spherewalk::render
