// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "random.h"
#include "temporary_folder.h"
#include "test_dataset.h"

#include "spherewalk/render/colour_correction.h"
#include "spherewalk/render/light_probe.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace spherewalk::render {

using Eigen::Vector2d;
using Eigen::Vector3d;
using test::expectError;

namespace {

constexpr double kPi = std::numbers::pi;

Renderer rendererOf(const std::filesystem::path& folder) {
    return Renderer(std::make_shared<const Dataset>(Dataset::open(folder)));
}

/// A radiance for each direction.
using Sky = std::function<Vector3d(const Vector3d& towards)>;

RadianceImage pictureOf(const Sky& sky, int width) {
    const EquirectSize size{width, width / 2};
    RadianceImage picture(size.width, size.height);
    for (int v = 0; v < size.height; ++v) {
        for (int u = 0; u < size.width; ++u) {
            const Vector3d light = sky(direction(size, Vector2d(u, v)));
            for (int c = 0; c < 3; ++c) {
                picture.at(u, v)[c] = static_cast<float>(light[c]);
            }
        }
    }
    return picture;
}

/// A lamp in a dim room.
const Vector3d kLamp = Vector3d(1, 0.5, 0.4).normalized();
const double kLampCosine = std::cos(0.3);

Vector3d lampWorld(const Vector3d& towards, double brightest, double gain) {
    const double stored = towards.dot(kLamp) > kLampCosine ? brightest : 60;
    return (gain * Vector3d(stored, 0.9 * stored, 0.8 * stored)).cwiseMin(255);
}

/// Two photos side by side of a world with a lamp, the second one taken darker. Stored values are half there.
class LampRoom {
  public:
    explicit LampRoom(double brightest, double gain = 2) {
        const test::World world = [&](const Vector3d& d) { return lampWorld(d, brightest, 1); };
        Rigid3 beside;
        beside.translation = {0.3, 0, 0};
        m_info = test::writeTestDataset(m_folder.path(), {Rigid3{}, beside}, world);
        const test::World darker = [&](const Vector3d& d) { return lampWorld(d, brightest, 1 / gain); };
        const Bytes jpeg = jpeg::encode(test::panorama(darker, beside.rotation, 512), 98);
        DatasetPhoto& photo = m_info.photos[1];
        photo.sha256 = sha256Hex(jpeg);
        photo.sizeBytes = jpeg.size();
        photo.exposureGain = Vector3d::Constant(gain);
        writeFile(m_folder.path() / photo.file, jpeg);
        test::rewriteInfo(m_folder.path(), m_info);
    }

    DatasetInfo& info() { return m_info; }

    const std::filesystem::path& folder() const { return m_folder.path(); }

    LightProbe probe(const ProbeOptions& options = {}) const {
        return lightProbe(rendererOf(folder()), {0.05, 0, 0}, options);
    }

  private:
    test::TemporaryFolder m_folder;
    DatasetInfo m_info;
};

const float* at(const RadianceImage& picture, const Vector3d& towards) {
    const Vector2d where = pixel({picture.width(), picture.height()}, towards);
    return picture.at(static_cast<int>(std::lround(where.x())), static_cast<int>(std::lround(where.y())));
}

const double kLampShare = (1 - kLampCosine) / 2; // of all directions

} // namespace

// A convention that is mirrored, turned or tilted anywhere between faces and probe fails.
TEST(LightProbe, ShowsTheWorldAsItIsInEveryDirection) {
    test::Random random(51);
    const test::TemporaryFolder folder;
    const Rigid3 pose{random.rotation(), random.vector(3)};
    test::writeTestDataset(folder.path(), {pose}, test::smoothWorld);
    const LightProbe probe = lightProbe(rendererOf(folder.path()), pose.translation, {64, {}, 0, true});
    const EquirectSize size{64, 32};
    ASSERT_EQ(probe.radiance.height(), 32);
    for (int v = 0; v < size.height; ++v) {
        for (int u = 0; u < size.width; ++u) {
            const Vector3d stored = test::smoothWorld(direction(size, Vector2d(u, v)));
            for (int c = 0; c < 3; ++c) {
                ASSERT_NEAR(probe.radiance.at(u, v)[c], linearLight(stored[c] / 255), 0.02)
                    << u << " " << v << " " << c;
            }
        }
    }
    EXPECT_EQ(probe.clippedShare, 0);
    EXPECT_EQ(probe.recoveredShare, 0);
}

TEST(LightProbe, TakesWhatIsClippedFromADarkerPhoto) {
    const LampRoom room(480);
    const LightProbe probe = room.probe();
    const float* lamp = at(probe.radiance, kLamp);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(lamp[c], linearLight((1 - 0.1 * c) * 480 / 255), 0.1) << c;
    }
    EXPECT_NEAR(at(probe.radiance, -kLamp)[0], linearLight(60 / 255.0), 0.005);
    EXPECT_NEAR(probe.recoveredShare, kLampShare, 0.1 * kLampShare);
    EXPECT_LT(probe.clippedShare, 0.05 * kLampShare); // at most the lamp's rim
}

TEST(LightProbe, SaysWhatIsClippedInAllPhotos) {
    LampRoom room(700);
    const LightProbe both = room.probe();
    EXPECT_NEAR(both.clippedShare, kLampShare, 0.1 * kLampShare);
    EXPECT_NEAR(at(both.radiance, kLamp)[0], linearLight(2), 0.1); // there is at least so much
    const double marked = static_cast<double>(
        std::count(both.clipped.values().begin(), both.clipped.values().end(), std::uint8_t{255}));
    EXPECT_GT(marked, 0);
    room.info().photos[1].exposureGain = {};
    test::rewriteInfo(room.folder(), room.info());
    const LightProbe alone = room.probe();
    EXPECT_NEAR(alone.clippedShare, kLampShare, 0.1 * kLampShare);
    EXPECT_EQ(alone.recoveredShare, 0);
    EXPECT_EQ(*std::max_element(alone.radiance.values().begin(), alone.radiance.values().end()), 1);
}

TEST(LightProbe, TakesNothingThatAnotherPhotoShowsInTheLampsPlace) {
    LampRoom room(480);
    room.info().photos[1].roomFromPhoto.rotation =
        Eigen::Quaterniond(Eigen::AngleAxisd(kPi, Vector3d::UnitZ())); // not true: the lamp is elsewhere
    test::rewriteInfo(room.folder(), room.info());
    const LightProbe probe = room.probe();
    EXPECT_NEAR(probe.clippedShare, kLampShare, 0.1 * kLampShare);
    EXPECT_EQ(at(probe.radiance, kLamp)[0], 1);
}

TEST(LightProbe, IsInTheDatasetsColours) {
    LampRoom room(480);
    ColourCorrection colour;
    colour.matrix = Eigen::Vector3d(0.5, 0.8, 0.6).asDiagonal();
    room.info().colour = colour;
    test::rewriteInfo(room.folder(), room.info());
    const LightProbe own = room.probe({128, {}, 0, false});
    const LightProbe corrected = room.probe({128, {}, 0, true});
    for (const Vector3d& towards : {kLamp, Vector3d(-kLamp)}) {
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(at(corrected.radiance, towards)[c],
                        colour.matrix(c, c) * at(own.radiance, towards)[c],
                        0.01 * at(own.radiance, towards)[c]);
        }
    }
    EXPECT_EQ(own.recoveredShare, corrected.recoveredShare);
}

TEST(LightProbe, HasTheSameValuesForAnyNumberOfThreads) {
    const LampRoom room(480);
    const LightProbe one = room.probe({96, {}, 1, true});
    for (const int threads : {2, 5}) {
        EXPECT_EQ(room.probe({96, {}, threads, true}).radiance, one.radiance);
    }
}

TEST(LightProbe, RefusesPlacesAndSizesThatAreNone) {
    const LampRoom room(480);
    const Renderer renderer = rendererOf(room.folder());
    for (const int width : {-2, 0, 14, 33, 8194}) {
        expectError(ErrorKind::InvalidInput, "give an even number from 16 to 8192", [&] {
            lightProbe(renderer, {0, 0, 0}, {width, {}, 0, true});
        });
    }
    expectError(ErrorKind::InvalidInput, "nothing was rendered", [&] {
        lightProbe(renderer, {0, std::numeric_limits<double>::quiet_NaN(), 0}, {64, {}, 0, true});
    });
}

TEST(RadianceFile, HoldsWhatThePictureHas) {
    test::Random random(52);
    RadianceImage picture(16, 8);
    for (float& value : picture.values()) {
        value = static_cast<float>(std::exp2(random.uniform(-20, 20)));
    }
    std::fill_n(picture.at(0, 0), 3, 0.0F);
    picture.at(1, 0)[0] = 1.999999F; // it must not round up to the next exponent
    picture.at(1, 0)[1] = picture.at(1, 0)[2] = 0;
    const Bytes file = radianceFile(picture);
    const std::string head = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 16\n";
    ASSERT_EQ(textOf(file).substr(0, head.size()), head);
    ASSERT_EQ(file.size(), head.size() + std::size_t{4} * 16 * 8);
    for (std::size_t i = 0; i < std::size_t{16} * 8; ++i) {
        const std::uint8_t* rgbe = file.data() + head.size() + 4 * i;
        const float* own = picture.values().data() + 3 * i;
        const double greatest = std::max({own[0], own[1], own[2]});
        for (int c = 0; c < 3; ++c) {
            const double read = rgbe[3] == 0 ? 0 : std::ldexp(rgbe[c], rgbe[3] - 136);
            ASSERT_NEAR(read, own[c], greatest / 127) << i;
        }
    }
    expectError(ErrorKind::InvalidInput, "without pixels", [] { radianceFile({}); });
}

// What a sky of order 2 throws on a surface is known exactly.
TEST(LightHarmonics, GiveTheLightOfAnAnalyticSky) {
    test::Random random(53);
    for (int i = 0; i < 20; ++i) {
        const Vector3d p = random.rotation() * Vector3d::UnitX();
        const Vector3d q = random.rotation() * Vector3d::UnitX();
        const Vector3d colour(1, 0.7, 0.3);
        const double c0 = random.uniform(1, 2);
        const double c1 = random.uniform(0, 1);
        const double c2 = random.uniform(0, 0.3);
        const Sky sky = [&](const Vector3d& d) {
            return Vector3d(colour * (c0 + c1 * d.dot(p) + c2 * (3 * d.dot(q) * d.dot(q) - 1)));
        };
        const LightHarmonics harmonics = lightHarmonics(pictureOf(sky, 128));
        for (int k = 0; k < 20; ++k) {
            const Vector3d n = random.rotation() * Vector3d::UnitX();
            const double exact =
                kPi * c0 + 2 * kPi / 3 * c1 * n.dot(p) + kPi / 4 * c2 * (3 * n.dot(q) * n.dot(q) - 1);
            ASSERT_TRUE(harmonics.irradiance(n).isApprox(exact * colour, 2e-3)) << n.transpose();
        }
    }
}

TEST(DominantLight, OfASmallSunInAnEvenSkyIsTheSun) {
    test::Random random(54);
    for (int i = 0; i < 20; ++i) {
        const Vector3d sun = i == 0   ? Vector3d(0, 0, 1)
                             : i == 1 ? Vector3d(-1, 1e-9, 0)
                                      : Vector3d(random.rotation() * Vector3d::UnitX());
        const double cosine = std::cos(0.1);
        const Vector3d ambient(0.2, 0.3, 0.4);
        const Vector3d bright = Vector3d(2, 1.5, 1) / (2 * kPi * (1 - cosine)); // a flux of 2, 1.5, 1
        const Sky disc = [&](const Vector3d& d) { return d.dot(sun) > cosine ? bright : Vector3d(0, 0, 0); };
        const Sky sky = [&](const Vector3d& d) { return Vector3d(ambient + disc(d)); };
        // What the disc's pixels throw; their number is not exactly its area.
        const Vector3d flux = lightHarmonics(pictureOf(disc, 512)).coefficients[0] * std::sqrt(4 * kPi);
        const DominantLight light = dominantLight(lightHarmonics(pictureOf(sky, 512)));
        EXPECT_LT(std::acos(std::min(1.0, light.towards.dot(sun))), 0.01);
        EXPECT_TRUE(flux.isApprox(Vector3d(2, 1.5, 1), 0.06));
        EXPECT_TRUE(light.irradiance.isApprox(flux, 0.01)) << light.irradiance.transpose();
        EXPECT_TRUE(light.ambient.isApprox(ambient, 0.01)) << light.ambient.transpose();
        const double own = Vector3d(2, 1.5, 1).dot(Vector3d(0.2126, 0.7152, 0.0722));
        const double even = kPi * ambient.dot(Vector3d(0.2126, 0.7152, 0.0722));
        EXPECT_NEAR(light.share, own / (own + even), 0.02);
    }
}

TEST(DominantLight, IsNoneInAnEvenSkyAndInTheDark) {
    const DominantLight even =
        dominantLight(lightHarmonics(pictureOf([](const Vector3d&) { return Vector3d(1, 2, 3); }, 64)));
    EXPECT_EQ(even.share, 0);
    EXPECT_EQ(even.towards, Vector3d(0, 0, 1));
    EXPECT_TRUE(even.ambient.isApprox(Vector3d(1, 2, 3), 1e-3));
    const DominantLight dark =
        dominantLight(lightHarmonics(pictureOf([](const Vector3d&) { return Vector3d(0, 0, 0); }, 64)));
    EXPECT_EQ(dark.share, 0);
    EXPECT_TRUE(dark.ambient.isZero());
    EXPECT_TRUE(dark.irradiance.allFinite());
}

TEST(DirectionalLights, ThrowWhatThePictureThrows) {
    test::Random random(55);
    const Sky sky = [](const Vector3d& d) {
        const double window = d.x() > 0.8 && std::abs(d.z()) < 0.3 ? 9 : 0;
        return Vector3d(0.3 + window, 0.2 + 0.1 * d.z() + window, 0.4 + 0.8 * window);
    };
    const RadianceImage picture = pictureOf(sky, 256);
    const LightHarmonics harmonics = lightHarmonics(picture);
    const std::vector<DirectionalLight> lights = directionalLights(picture, 256);
    ASSERT_EQ(lights.size(), 256U);
    Vector3d flux = Vector3d::Zero();
    for (const DirectionalLight& light : lights) {
        EXPECT_NEAR(light.towards.norm(), 1, 1e-9);
        flux += light.irradiance;
    }
    EXPECT_TRUE(flux.isApprox(harmonics.coefficients[0] * std::sqrt(4 * kPi), 1e-4));
    const EquirectSize size{256, 128};
    for (int i = 0; i < 20; ++i) {
        const Vector3d n = random.rotation() * Vector3d::UnitX();
        Vector3d exact = Vector3d::Zero();
        for (int v = 0; v < size.height; ++v) {
            const double angle = std::cos(kPi * (0.5 - (v + 0.5) / 128)) * std::pow(2 * kPi / 256, 2);
            for (int u = 0; u < size.width; ++u) {
                const Vector3d d = direction(size, Vector2d(u, v));
                exact += angle * std::max(0.0, d.dot(n)) * sky(d);
            }
        }
        Vector3d sum = Vector3d::Zero();
        for (const DirectionalLight& light : lights) {
            sum += std::max(0.0, light.towards.dot(n)) * light.irradiance;
        }
        EXPECT_TRUE(sum.isApprox(exact, 0.03)) << sum.transpose() << " instead of " << exact.transpose();
    }
}

TEST(DirectionalLights, AreAsManyAsThereIsLight) {
    RadianceImage one(32, 16);
    std::fill_n(one.at(20, 5), 3, 4.0F);
    const std::vector<DirectionalLight> lights = directionalLights(one, 10);
    ASSERT_EQ(lights.size(), 1U);
    EXPECT_TRUE(lights[0].towards.isApprox(direction({32, 16}, Vector2d(20, 5)), 1e-9));
    EXPECT_TRUE(directionalLights(RadianceImage(32, 16), 10).empty());
    EXPECT_EQ(
        directionalLights(pictureOf([](const Vector3d&) { return Vector3d(1, 1, 1); }, 16), 4096).size(),
        128U); // one a pixel
    for (const int count : {0, -1, 65537}) {
        expectError(ErrorKind::InvalidInput, "give 1 to 65536", [&] { directionalLights(one, count); });
    }
}

TEST(LightLeft, IsTheShareThatNothingHides) {
    const auto lights =
        directionalLights(pictureOf([](const Vector3d&) { return Vector3d(1, 1, 1); }, 128), 512);
    const Vector3d up(0, 0, 1);
    const auto left = [&](const std::function<bool(const Vector3d&)>& isHidden) {
        return lightLeft(lights, up, isHidden);
    };
    EXPECT_EQ(left([](const Vector3d&) { return false; }), 1);
    EXPECT_EQ(left([](const Vector3d&) { return true; }), 0);
    EXPECT_NEAR(left([](const Vector3d& d) { return d.x() > 0; }), 0.5, 0.03);
    // Of an even sky, a cap of 60 degrees about the normal throws 75 %.
    EXPECT_NEAR(left([](const Vector3d& d) { return d.z() > 0.5; }), 0.25, 0.03);
    EXPECT_EQ(lightLeft({}, up, [](const Vector3d&) { return true; }), 1);
}

} // namespace spherewalk::render
