// SPDX-License-Identifier: Apache-2.0
#include "each_target.h"
#include "expect_error.h"
#include "lenses.h"
#include "random.h"

#include "spherewalk/render/colour_correction.h"
#include "spherewalk/render/overlay.h"

#include <array>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <thread>

namespace spherewalk::render {

using Eigen::Vector2d;
using Rgba = std::array<int, 4>;
using Rgb = std::array<int, 3>;

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr Rgb kGround{10, 100, 200};

void set(RgbaImage& picture, int x, int y, const Rgba& value) {
    for (std::size_t c = 0; c < 4; ++c) {
        picture.at(x, y)[c] = static_cast<std::uint8_t>(value[c]);
    }
}

DepthImage depthOf(int width, int height, float value) {
    DepthImage depth(width, height);
    std::fill(depth.values().begin(), depth.values().end(), value);
    return depth;
}

Overlay plain(const CameraIntrinsics& camera, const Rgba& colour, float depth) {
    Overlay overlay;
    overlay.camera = camera;
    overlay.picture = RgbaImage(camera.width, camera.height);
    for (int y = 0; y < camera.height; ++y) {
        for (int x = 0; x < camera.width; ++x) {
            set(overlay.picture, x, y, colour);
        }
    }
    overlay.depth = depthOf(camera.width, camera.height, depth);
    return overlay;
}

Overlay noise(const CameraIntrinsics& camera, test::Random& random) {
    Overlay overlay = plain(camera, {}, 1);
    for (std::uint8_t& value : overlay.picture.values()) {
        value = static_cast<std::uint8_t>(random.integer(0, 3) == 0 ? 255 * random.integer(0, 1)
                                                                    : random.integer(0, 255));
    }
    overlay.roomDepth = overlay.depth;
    for (float& depth : overlay.depth.values()) {
        depth = static_cast<float>(random.uniform(-0.5, 4));
    }
    for (float& depth : overlay.roomDepth.values()) {
        depth = static_cast<float>(random.uniform(-0.5, 4));
    }
    return overlay;
}

/// A view of one colour, with overlays laid into it.
struct Composed {
    RgbImage picture;
    MaskImage shown;
    LabelImage labels;

    Rgb at(int x, int y) const {
        const std::uint8_t* rgb = picture.at(x, y);
        return {rgb[0], rgb[1], rgb[2]};
    }
};

RgbImage ground(const CameraIntrinsics& camera) {
    RgbImage picture(camera.width, camera.height);
    for (std::size_t i = 0; i < picture.values().size(); ++i) {
        picture.values()[i] = static_cast<std::uint8_t>(kGround[i % 3]);
    }
    return picture;
}

Composed composed(std::span<const Overlay> overlays, const CameraIntrinsics& camera,
                  const ComposeOptions& options = {}, const DepthImage& viewDepth = {}) {
    static WorkerPool pool(3);
    Composer composer;
    Composed result{ground(camera), {}, {}};
    composer.compose(overlays, CameraModel(camera), viewDepth, options, pool, result.picture, &result.shown,
                     &result.labels);
    return result;
}

Composed composed(const Overlay& overlay, const ComposeOptions& options = {},
                  const DepthImage& viewDepth = {}) {
    return composed({&overlay, 1}, overlay.camera, options, viewDepth);
}

const CameraIntrinsics kSmall = CameraIntrinsics::pinhole(8, 6, 1);

/// What is left of a stored value in a shadow, in double precision.
double darkened(int stored, double share) {
    return 255 * storedValue(share * linearLight(stored / 255.0));
}

Image<float, 1> noisyShadow(const CameraIntrinsics& camera, test::Random& random) {
    Image<float, 1> shadow(camera.width, camera.height);
    for (float& share : shadow.values()) {
        share = random.integer(0, 2) == 0 ? 1.0F : static_cast<float>(random.uniform(0, 1));
    }
    return shadow;
}

} // namespace

TEST(Overlay, IsBlendedByItsAlphaAndRoundedOnce) {
    for (int alpha = 0; alpha <= 255; ++alpha) {
        const Rgb colour{255 - alpha, 77, alpha};
        const Composed straight = composed(plain(kSmall, {colour[0], colour[1], colour[2], alpha}, 1));
        for (std::size_t c = 0; c < 3; ++c) {
            const double exact = (colour[c] * alpha + kGround[c] * (255 - alpha)) / 255.0;
            ASSERT_EQ(straight.at(3, 2)[c], static_cast<int>(exact + 0.5)) << alpha;
        }
        ASSERT_EQ(*straight.shown.at(3, 2), alpha);
    }
}

TEST(Overlay, PremultipliedColoursAreNotMultipliedAgain) {
    for (int alpha = 0; alpha <= 255; ++alpha) {
        Overlay overlay = plain(kSmall, {alpha / 2, 0, alpha, alpha}, 1);
        overlay.alpha = Alpha::Premultiplied;
        const Composed result = composed(overlay);
        for (const auto& [c, own] : {std::pair{0, alpha / 2}, {1, 0}, {2, alpha}}) {
            const double exact = own + kGround[static_cast<std::size_t>(c)] * (255 - alpha) / 255.0;
            ASSERT_EQ(result.at(0, 0)[static_cast<std::size_t>(c)], static_cast<int>(exact + 0.5)) << alpha;
        }
    }
    Overlay glow = plain(kSmall, {255, 255, 255, 0}, 1); // colour without alpha: still nothing
    glow.alpha = Alpha::Premultiplied;
    EXPECT_EQ(composed(glow).at(0, 0), kGround);
    Overlay brighter = plain(kSmall, {255, 255, 255, 128}, 1);
    brighter.alpha = Alpha::Premultiplied;
    EXPECT_EQ(composed(brighter).at(0, 0), (Rgb{255, 255, 255}));
}

TEST(Overlay, WithoutADepthThereIsNothing) {
    for (const float none : {kInfinity, -kInfinity, kNan, 0.0F, -1.0F}) {
        EXPECT_EQ(composed(plain(kSmall, {255, 0, 0, 255}, none)).picture, ground(kSmall)) << none;
    }
}

TEST(Overlay, IsHiddenByNothingWhereTheRoomHasNoDepth) {
    for (const float none : {kInfinity, -kInfinity, kNan, 0.0F, -1.0F}) {
        Overlay overlay = plain(kSmall, {255, 0, 0, 255}, 3);
        overlay.roomDepth = depthOf(8, 6, none);
        EXPECT_EQ(composed(overlay).at(4, 4), (Rgb{255, 0, 0})) << none;
        overlay.roomDepth = {};
        EXPECT_EQ(composed(overlay, {}, depthOf(8, 6, none)).at(4, 4), (Rgb{255, 0, 0})) << none;
    }
}

TEST(Overlay, FadesBetweenOneAndTwoTolerancesBehindTheRoom) {
    ComposeOptions options;
    options.toleranceM = 0.25;
    for (const auto& [behind, share] : {std::pair{-2.0F, 1.0},
                                        {-0.01F, 1.0},
                                        {0.0F, 1.0},
                                        {0.25F, 1.0},
                                        {0.3125F, 0.75},
                                        {0.375F, 0.5},
                                        {0.5F, 0.0},
                                        {4.0F, 0.0}}) {
        Overlay overlay = plain(kSmall, {255, 255, 255, 255}, 4 + behind);
        overlay.roomDepth = depthOf(8, 6, 4);
        EXPECT_NEAR(*composed(overlay, options).shown.at(3, 3), 255 * share, 0.51) << behind;
    }
    options.toleranceM = 0;
    options.toleranceShare = 0.0625; // of 4 m: the same
    Overlay overlay = plain(kSmall, {255, 255, 255, 255}, 4.375F);
    overlay.roomDepth = depthOf(8, 6, 4);
    EXPECT_NEAR(*composed(overlay, options).shown.at(3, 3), 127.5, 0.51);
    options.toleranceShare = 0; // no band at all
    overlay.depth = depthOf(8, 6, std::nextafter(4.0F, 5.0F));
    EXPECT_EQ(*composed(overlay, options).shown.at(3, 3), 0);
    overlay.depth = depthOf(8, 6, 4);
    EXPECT_EQ(*composed(overlay, options).shown.at(3, 3), 255);
}

TEST(Overlay, IsHiddenByItsOwnRoomElseByTheViewsDepth) {
    Overlay overlay = plain(kSmall, {255, 0, 0, 255}, 2);
    EXPECT_EQ(composed(overlay, {}, depthOf(8, 6, 1)).at(1, 1), kGround);
    EXPECT_EQ(composed(overlay, {}, depthOf(8, 6, 3)).at(1, 1), (Rgb{255, 0, 0}));
    overlay.roomDepth = depthOf(8, 6, 3);
    EXPECT_EQ(composed(overlay, {}, depthOf(8, 6, 1)).at(1, 1), (Rgb{255, 0, 0}));
    overlay.roomDepth = depthOf(8, 6, 1);
    EXPECT_EQ(composed(overlay, {}, depthOf(8, 6, 3)).at(1, 1), kGround);
}

TEST(Overlay, ThroughAnotherCameraIsHiddenByTheViewsDepthToo) {
    const CameraIntrinsics other = CameraIntrinsics::pinhole(40, 30, 1.2);
    const Overlay overlay = plain(other, {255, 0, 0, 255}, 2);
    DepthImage depth = depthOf(8, 6, 3);
    *depth.at(2, 3) = 1;
    const Composed result = composed({&overlay, 1}, kSmall, {}, depth);
    EXPECT_EQ(result.at(2, 3), kGround);
    EXPECT_EQ(result.at(3, 3), (Rgb{255, 0, 0}));
}

TEST(Overlay, FarthestIsLaidFirstInWhateverOrderTheyAreGiven) {
    const Overlay farRed = plain(kSmall, {255, 0, 0, 255}, 3);
    const Overlay middleGreen = plain(kSmall, {0, 255, 0, 255}, 2);
    Overlay nearBlue = plain(kSmall, {0, 0, 255, 255}, 1);
    set(nearBlue.picture, 5, 1, {0, 0, 255, 0});
    set(nearBlue.picture, 6, 1, {0, 0, 255, 128});
    std::vector<Overlay> overlays{farRed, middleGreen, nearBlue};
    std::vector<int> order{0, 1, 2};
    do {
        const std::vector<Overlay> given{overlays[static_cast<std::size_t>(order[0])],
                                         overlays[static_cast<std::size_t>(order[1])],
                                         overlays[static_cast<std::size_t>(order[2])]};
        const Composed result = composed(given, kSmall);
        EXPECT_EQ(result.at(2, 2), (Rgb{0, 0, 255}));
        EXPECT_EQ(result.at(5, 1), (Rgb{0, 255, 0}));
        EXPECT_EQ(result.at(6, 1), (Rgb{0, 127, 128}));
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Overlay, OfTheSameDepthTheLaterOneIsOnTop) {
    const std::vector<Overlay> overlays{plain(kSmall, {255, 0, 0, 255}, 2),
                                        plain(kSmall, {0, 255, 0, 255}, 2)};
    EXPECT_EQ(composed(overlays, kSmall).at(0, 5), (Rgb{0, 255, 0}));
}

TEST(Overlay, MaskTellsHowMuchAllOfThemCover) {
    const std::vector<Overlay> overlays{plain(kSmall, {1, 2, 3, 128}, 2), plain(kSmall, {4, 5, 6, 64}, 3)};
    const double left = (1 - 128 / 255.0) * (1 - 64 / 255.0);
    EXPECT_NEAR(*composed(overlays, kSmall).shown.at(7, 0), 255 * (1 - left), 0.51);
    const Composed none = composed(std::span<const Overlay>(), kSmall);
    EXPECT_EQ(none.picture, ground(kSmall));
    EXPECT_EQ(none.shown, MaskImage(8, 6));
}

TEST(Overlay, LabelsTellTheObjectThatCoversMost) {
    Overlay red = plain(kSmall, {255, 0, 0, 255}, 2);
    Overlay glass = plain(kSmall, {0, 255, 0, 0}, 1); // in front of it
    set(glass.picture, 1, 1, {0, 255, 0, 127});
    set(glass.picture, 2, 1, {0, 255, 0, 129});
    set(glass.picture, 3, 1, {0, 255, 0, 100});
    set(glass.picture, 4, 1, {0, 255, 0, 100});
    set(red.picture, 3, 1, {255, 0, 0, 100}); // both cover 63 %, the glass 39 % and the red 24 %
    set(red.picture, 4, 1, {255, 0, 0, 10});  // 42 %: more of the pixel is room
    set(red.picture, 5, 1, {255, 0, 0, 0});
    const Composed result = composed({std::vector{red, glass}}, kSmall);
    std::array<int, 6> labels{};
    std::copy_n(result.labels.at(0, 1), labels.size(), labels.begin());
    EXPECT_EQ(labels, (std::array{1, 1, 2, 2, 0, 0}));
    EXPECT_EQ(composed(std::span<const Overlay>(), kSmall).labels, LabelImage(8, 6));
}

TEST(Overlay, WhatTheRoomHidesIsLabelledAsRoom) {
    const CameraIntrinsics other = CameraIntrinsics::pinhole(40, 30, 1.2);
    DepthImage depth = depthOf(8, 6, 3);
    *depth.at(2, 3) = 1;
    ComposeOptions options;
    options.edges = Edges::Hard;
    for (const CameraIntrinsics& camera : {kSmall, other}) {
        Overlay overlay = plain(camera, {255, 0, 0, 255}, 2);
        overlay.labels = LabelImage(camera.width, camera.height);
        std::fill(overlay.labels.values().begin(), overlay.labels.values().end(), 40000);
        std::fill(overlay.labels.at(0, camera.height / 2), overlay.labels.at(camera.width, camera.height - 1),
                  std::uint16_t{7});
        const Composed result = composed({&overlay, 1}, kSmall, options, depth);
        EXPECT_EQ(*result.labels.at(4, 0), 40000) << camera.width;
        EXPECT_EQ(*result.labels.at(4, 5), 7) << camera.width;
        EXPECT_EQ(*result.labels.at(2, 3), 0) << camera.width;
        EXPECT_EQ(*result.labels.at(3, 3), 7) << camera.width;
    }
}

TEST(Overlay, ARimPixelTakesTheNearestDepthBesideIt) {
    Overlay overlay = plain(kSmall, {0, 0, 0, 0}, kInfinity);
    overlay.roomDepth = depthOf(8, 6, 2);
    for (const int x : {2, 3, 6}) {
        set(overlay.picture, x, 2, {255, 255, 255, 255});
    }
    *overlay.depth.at(1, 2) = 5; // behind the room
    *overlay.depth.at(3, 3) = 1; // in front of it; beside (2, 2) and (3, 2)
    const Composed result = composed(overlay);
    EXPECT_EQ(*result.shown.at(2, 2), 255);
    EXPECT_EQ(*result.shown.at(3, 2), 255);
    EXPECT_EQ(*result.shown.at(6, 2), 0); // alone: its depth is not invented
    EXPECT_EQ(*result.shown.at(3, 3), 0); // a depth without a colour is nothing
}

TEST(Overlay, AnEdgeOfTheRoomIsSoftenedOnBothSides) {
    Overlay overlay = plain(kSmall, {255, 255, 255, 255}, 2);
    overlay.roomDepth = depthOf(8, 6, 3);
    for (int y = 0; y < 6; ++y) {
        for (int x = 4; x < 8; ++x) {
            *overlay.roomDepth.at(x, y) = 1;
        }
    }
    ComposeOptions options;
    const Composed soft = composed(overlay, options);
    options.edges = Edges::Hard;
    const Composed hard = composed(overlay, options);
    const std::array<int, 8> expectedSoft{255, 255, 255, 223, 32, 0, 0, 0}; // 7/8 and 1/8
    for (int x = 0; x < 8; ++x) {
        EXPECT_EQ(*soft.shown.at(x, 3), expectedSoft[static_cast<std::size_t>(x)]) << x;
        EXPECT_EQ(*hard.shown.at(x, 3), x < 4 ? 255 : 0) << x;
    }
}

TEST(Overlay, WhereOneObjectEndsBeforeAnotherNothingIsSoftened) {
    // Left an object in front of the room, right one behind it: what separates them is not the room's edge.
    Overlay overlay = plain(kSmall, {255, 255, 255, 255}, 1);
    overlay.roomDepth = depthOf(8, 6, 2);
    for (int y = 0; y < 6; ++y) {
        for (int x = 4; x < 8; ++x) {
            *overlay.depth.at(x, y) = 3;
        }
    }
    const Composed result = composed(overlay);
    for (int x = 0; x < 8; ++x) {
        EXPECT_EQ(*result.shown.at(x, 3), x < 4 ? 255 : 0) << x;
    }
}

TEST(Overlay, OfACameraShiftedByWholePixelsIsTakenPixelForPixel) {
    test::Random random(71);
    SCOPED_TRACE(random.seed());
    CameraIntrinsics wider = CameraIntrinsics::pinhole(40, 30, 1);
    const Overlay overlay = noise(wider, random);
    CameraIntrinsics view = wider;
    view.width = 30;
    view.height = 20;
    view.cx -= 6;
    view.cy -= 4;
    const Composed looked = composed({&overlay, 1}, view);
    const Composed own = composed(overlay);
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 30; ++x) {
            ASSERT_EQ(looked.at(x, y), own.at(x + 6, y + 4)) << x << ", " << y;
        }
    }
}

TEST(Overlay, ThroughALensIsBilinearInPremultipliedColours) {
    test::Random random(72);
    SCOPED_TRACE(random.seed());
    const CameraIntrinsics simulator = CameraIntrinsics::pinhole(90, 70, 1.7);
    const CameraModel simulated(simulator);
    Overlay overlay = noise(simulator, random);
    overlay.depth = depthOf(90, 70, 1);
    overlay.roomDepth = {};
    int seen = 0;
    for (const CameraIntrinsics& intrinsics : test::everyLens(64, 48)) {
        const CameraModel camera(intrinsics);
        const Composed result = composed({&overlay, 1}, intrinsics);
        for (int y = 0; y < 48; ++y) {
            for (int x = 0; x < 64; ++x) {
                const auto ray = camera.ray(Vector2d(x, y));
                const auto place = ray ? simulated.project(*ray) : std::nullopt;
                if (!place || place->x() < 0 || place->y() < 0 || place->x() > 88.9 || place->y() > 68.9) {
                    continue;
                }
                const int left = static_cast<int>(place->x());
                const int top = static_cast<int>(place->y());
                Eigen::Vector4d sum = Eigen::Vector4d::Zero();
                for (const int k : {0, 1, 2, 3}) {
                    const std::uint8_t* rgba = overlay.picture.at(left + k % 2, top + k / 2);
                    const double weight = (1 - std::abs(place->x() - (left + k % 2))) *
                                          (1 - std::abs(place->y() - (top + k / 2)));
                    const double alpha = rgba[3] / 255.0;
                    sum += weight * alpha * Eigen::Vector4d(rgba[0], rgba[1], rgba[2], 1);
                }
                for (std::size_t c = 0; c < 3; ++c) {
                    const double exact = sum[static_cast<int>(c)] + (1 - sum[3]) * kGround[c];
                    // Places are multiples of 1/256 pixels, which is up to 1/512 of 255 levels along each
                    // axis.
                    ASSERT_NEAR(result.at(x, y)[c], exact, 1.6) << name(intrinsics.lens) << x << ", " << y;
                }
                ++seen;
            }
        }
    }
    EXPECT_GT(seen, 4000);
}

TEST(Overlay, BetweenPixelsNoDepthIsInvented) {
    // Left a near thing, right a far one, the room between: halfway between two pixels half of the near thing
    // is shown, and nothing of the far one. A depth between them would show all or nothing of both.
    CameraIntrinsics camera = CameraIntrinsics::pinhole(8, 6, 1);
    Overlay overlay = plain(camera, {255, 0, 0, 255}, 1);
    overlay.roomDepth = depthOf(8, 6, 2);
    for (int y = 0; y < 6; ++y) {
        for (int x = 4; x < 8; ++x) {
            *overlay.depth.at(x, y) = 3;
            set(overlay.picture, x, y, {0, 255, 0, 255});
        }
    }
    CameraIntrinsics view = camera;
    view.cx -= 0.5; // the view's pixel x lies at the overlay's x + 0.5
    const Composed result = composed({&overlay, 1}, view);
    EXPECT_EQ(result.at(2, 3), (Rgb{255, 0, 0}));
    EXPECT_EQ(*result.shown.at(3, 3), 128);
    EXPECT_EQ(result.at(3, 3), (Rgb{133, 50, 100}));
    EXPECT_EQ(result.at(4, 3), kGround);
    // The same with the depth of the view itself.
    overlay.roomDepth = {};
    EXPECT_EQ(composed({&overlay, 1}, view, {}, depthOf(8, 6, 2)).at(3, 3), (Rgb{133, 50, 100}));
}

TEST(Overlay, ChangesNothingBesideItsPictureAndWhereTheLensSeesNothing) {
    const CameraIntrinsics narrow = CameraIntrinsics::pinhole(20, 20, 0.3);
    const Overlay overlay = plain(narrow, {255, 0, 0, 255}, 1);
    for (const CameraIntrinsics& intrinsics : test::everyLens(64, 48)) {
        const CameraModel camera(intrinsics);
        const CameraModel simulator(narrow);
        const Composed result = composed({&overlay, 1}, intrinsics);
        for (int y = 0; y < 48; ++y) {
            for (int x = 0; x < 64; ++x) {
                const auto ray = camera.ray(Vector2d(x, y));
                const auto place = ray ? simulator.project(*ray) : std::nullopt;
                const bool isInside = place && (*place - Vector2d(9.5, 9.5)).cwiseAbs().maxCoeff() <= 10;
                ASSERT_EQ(result.at(x, y), isInside ? (Rgb{255, 0, 0}) : kGround) << x << ", " << y;
            }
        }
    }
}

TEST(Overlay, GivesTheSameBytesForAnyNumberOfThreads) {
    test::Random random(73);
    SCOPED_TRACE(random.seed());
    const std::vector<CameraIntrinsics> lenses = test::everyLens(97, 61);
    std::vector<Overlay> overlays;
    for (const CameraIntrinsics& camera : lenses) {
        overlays.push_back(noise(camera, random));
    }
    overlays[2].roomDepth = {};
    const DepthImage depth = depthOf(97, 61, 2);
    for (const CameraIntrinsics& view : lenses) {
        const Composed one = composed(overlays, view, {0.1, 0.1, Edges::Soft, 1}, depth);
        for (const int threads : {0, 2, 3}) {
            const Composed many = composed(overlays, view, {0.1, 0.1, Edges::Soft, threads}, depth);
            EXPECT_EQ(many.picture, one.picture) << threads;
            EXPECT_EQ(many.shown, one.shown) << threads;
            EXPECT_EQ(many.labels, one.labels) << threads;
        }
    }
}

// One overlay alone is laid in by runs of pixels. Beside one that shows nothing it is laid in pixel by pixel.
TEST(Overlay, IsLaidInByRunsAsItIsPixelByPixel) {
    test::Random random(75);
    SCOPED_TRACE(random.seed());
    const CameraIntrinsics view = CameraIntrinsics::pinhole(131, 90, 1.2);
    CameraIntrinsics wider = CameraIntrinsics::pinhole(150, 110, 1.5);
    wider.lens = LensModel::PlumbBob;
    wider.distortion = {-0.05, 0.01, 0, 0, 0};
    const auto smooth = [&](const CameraIntrinsics& camera) {
        Overlay overlay = noise(camera, random);
        for (int y = 0; y < camera.height; ++y) {
            for (int x = 0; x < camera.width; ++x) { // mostly whole objects before the room
                const bool isPlain = random.integer(0, 60) != 0;
                std::uint8_t& alpha = overlay.picture.at(x, y)[3];
                alpha = isPlain ? ((x / 40 + y / 30) % 2 == 0 ? 255 : 0) : alpha;
                *overlay.depth.at(x, y) = isPlain ? 1 + 0.01F * static_cast<float>(x) : kNan;
                *overlay.roomDepth.at(x, y) = random.integer(0, 400) != 0 ? 1.9F : -1;
            }
        }
        return overlay;
    };
    const Overlay nothing = plain(view, {}, kInfinity);
    for (const CameraIntrinsics& camera : {view, wider}) {
        for (const Alpha alpha : {Alpha::Straight, Alpha::Premultiplied}) {
            for (const bool hasRoom : {true, false}) {
                for (const float viewDepth : {0.0F, 1.4F, kInfinity, kNan}) {
                    Overlay overlay = smooth(camera);
                    overlay.alpha = alpha;
                    overlay.roomDepth = hasRoom ? overlay.roomDepth : DepthImage();
                    const DepthImage depth =
                        viewDepth == 0 ? DepthImage() : depthOf(view.width, view.height, viewDepth);
                    const std::array<Overlay, 2> both{overlay, nothing};
                    const Composed expected = composed(both, view, {}, depth);
                    test::forEachTarget([&](const char* target) {
                        const Composed own = composed({&overlay, 1}, view, {}, depth);
                        EXPECT_EQ(own.picture, expected.picture) << target << " " << viewDepth;
                        EXPECT_EQ(own.shown, expected.shown) << target << " " << viewDepth;
                    });
                }
            }
        }
    }
}

TEST(Overlay, GivesTheSameBytesToManyThreadsAtATime) {
    test::Random random(74);
    const std::vector<CameraIntrinsics> lenses = test::everyLens(64, 48);
    const Overlay overlay = noise(CameraIntrinsics::pinhole(80, 60, 1.5), random);
    std::vector<RgbImage> expected;
    for (const CameraIntrinsics& view : lenses) {
        expected.push_back(composed({&overlay, 1}, view).picture);
    }
    Composer composer;
    WorkerPool pool(2);
    std::atomic<int> different{0};
    {
        std::vector<std::jthread> callers;
        for (int caller = 0; caller < 4; ++caller) {
            callers.emplace_back([&] {
                for (std::size_t i = 0; i < 4 * lenses.size(); ++i) {
                    const CameraIntrinsics& view = lenses[i % lenses.size()];
                    RgbImage picture = ground(view);
                    composer.compose({&overlay, 1}, CameraModel(view), {}, {}, pool, picture);
                    different += picture == expected[i % lenses.size()] ? 0 : 1;
                }
            });
        }
    }
    EXPECT_EQ(different, 0);
}

TEST(Overlay, OfOnePixelIsLaidIn) {
    for (const double fov : {0.017, 1.0, 3.12}) {
        const CameraIntrinsics one = CameraIntrinsics::pinhole(1, 1, fov);
        EXPECT_EQ(composed(plain(one, {1, 2, 3, 255}, 2)).at(0, 0), (Rgb{1, 2, 3}));
        const Overlay overlay = plain(CameraIntrinsics::pinhole(1, 1, 0.99 * fov), {1, 2, 3, 255}, 2);
        EXPECT_EQ(composed({&overlay, 1}, one).at(0, 0), (Rgb{1, 2, 3}));
    }
}

TEST(Overlay, LaysItsDepthWhereItCoversHalfAPixel) {
    const CameraIntrinsics wider = CameraIntrinsics::pinhole(40, 30, 1);
    CameraIntrinsics view = wider; // shifted by whole pixels
    view.width = 30;
    view.height = 20;
    view.cx -= 6;
    view.cy -= 4;
    std::vector<Overlay> overlays{plain(wider, {9, 9, 9, 255}, 2), plain(wider, {7, 7, 7, 255}, 1.5F)};
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
            *overlays[0].depth.at(x, y) = x < 20 ? 2 + 0.01F * static_cast<float>(x) : kInfinity;
            *overlays[1].depth.at(x, y) = y < 10 ? 1.5F : kNan;
        }
    }
    MaskImage shown(30, 20);
    std::fill(shown.values().begin(), shown.values().end(), std::uint8_t{255});
    *shown.at(5, 1) = 128;
    *shown.at(6, 1) = 127;
    WorkerPool pool(2);
    for (const CameraIntrinsics& camera : {view, wider}) {
        const bool isOther = camera.width == 30;
        MaskImage covered = isOther ? shown : MaskImage(40, 30);
        if (!isOther) {
            std::fill(covered.values().begin(), covered.values().end(), std::uint8_t{255});
        }
        DepthImage depth = depthOf(camera.width, camera.height, 3);
        Composer().layDepth(overlays, CameraModel(camera), covered, {}, pool, depth);
        for (int y = 0; y < camera.height; ++y) {
            for (int x = 0; x < camera.width; ++x) {
                const int u = isOther ? x + 6 : x;
                const int v = isOther ? y + 4 : y;
                const float expected = isOther && x == 6 && y == 1 ? 3
                                       : v < 10                    ? 1.5F
                                       : u < 20                    ? 2 + 0.01F * static_cast<float>(u)
                                                                   : 3;
                ASSERT_EQ(*depth.at(x, y), expected) << x << ", " << y;
            }
        }
    }
}

TEST(Shadow, DarkensTheLightOfWhatThePhotosShow) {
    const auto camera = CameraIntrinsics::pinhole(256, 101, 1);
    Overlay overlay = plain(camera, {0, 0, 0, 0}, kInfinity);
    overlay.shadow = Image<float, 1>(camera.width, camera.height);
    RgbImage picture(camera.width, camera.height);
    for (int y = 0; y < camera.height; ++y) {
        for (int x = 0; x < camera.width; ++x) {
            *overlay.shadow.at(x, y) = static_cast<float>(y) / 100.0F;
            std::fill_n(picture.at(x, y), 3, static_cast<std::uint8_t>(x));
        }
    }
    WorkerPool pool(2);
    Composer().compose({&overlay, 1}, CameraModel(camera), {}, {}, pool, picture);
    for (int y = 0; y < camera.height; ++y) {
        for (int x = 0; x < camera.width; ++x) {
            ASSERT_NEAR(picture.at(x, y)[1], darkened(x, y / 100.0), 0.53) << x << " " << y;
        }
    }
    EXPECT_EQ(picture.at(200, 0)[0], 0);
    EXPECT_EQ(picture.at(200, 100)[0], 200); // a share of 1 changes nothing
}

TEST(Shadow, LeavesTheColoursOfObjects) {
    constexpr Rgb kObject{200, 150, 100};
    Overlay object = plain(kSmall, {200, 150, 100, 255}, 1);
    object.picture.at(5, 3)[3] = 102;
    set(object.picture, 6, 3, {0, 0, 0, 0});
    object.shadow = depthOf(8, 6, 0.25F);
    const Composed result = composed(object);
    EXPECT_EQ(result.at(2, 2), kObject);
    for (std::size_t c = 0; c < 3; ++c) {
        const int left = static_cast<int>(std::lround(darkened(kGround[c], 0.25)));
        EXPECT_EQ(result.at(6, 3)[c], left);
        EXPECT_NEAR(result.at(5, 3)[c], 0.6 * left + 0.4 * kObject[c], 0.51);
    }
    EXPECT_EQ(*result.shown.at(6, 3), 0); // a shadow is no object
    EXPECT_EQ(*result.labels.at(6, 3), 0);
}

TEST(Shadow, OfAllOverlaysDarkensAndIsLaidUnderAllOfThem) {
    std::vector<Overlay> overlays(2, plain(kSmall, {0, 0, 0, 0}, kInfinity));
    overlays[0].shadow = depthOf(8, 6, 0.5F);
    overlays[1].shadow = depthOf(8, 6, 0.4F);
    const Rgb twice = composed(overlays, kSmall).at(4, 4);
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(twice[c], darkened(kGround[c], 0.2), 1.1); // rounded twice
    }
    set(overlays[0].picture, 4, 4, {9, 8, 7, 255});
    *overlays[0].depth.at(4, 4) = 2;
    EXPECT_EQ(composed(overlays, kSmall).at(4, 4), (Rgb{9, 8, 7})); // of the other one, too
}

TEST(Shadow, ThroughAnotherCameraIsBilinearAndEndsWithItsPicture) {
    // Twice as many pixels, half as wide: the view's columns fall between those of the shadow's camera.
    const CameraIntrinsics view{40, 30, 40, 40, 19.5, 14.5, LensModel::Pinhole, {}};
    const CameraIntrinsics other{40, 30, 80, 80, 19.5, 14.5, LensModel::Pinhole, {}};
    Overlay overlay = plain(other, {0, 0, 0, 0}, kInfinity);
    overlay.shadow = Image<float, 1>(other.width, other.height);
    for (int y = 0; y < other.height; ++y) {
        for (int x = 0; x < other.width; ++x) {
            *overlay.shadow.at(x, y) = static_cast<float>(x) / 39.0F;
        }
    }
    const Composed result = composed({&overlay, 1}, view);
    for (int x = 0; x < view.width; ++x) {
        const double at = 19.5 + 2 * (x - 19.5);
        const double share = at < -0.5 || at > 39.5 ? 1 : std::clamp(at / 39, 0.0, 1.0);
        EXPECT_NEAR(result.at(x, 15)[2], darkened(kGround[2], share), 0.6) << x;
    }
    EXPECT_EQ(result.at(20, 2), kGround); // above its picture
}

TEST(Shadow, GivesTheSameBytesForAnyThreadsAndAnySimd) {
    test::Random random(31);
    for (const CameraIntrinsics& lens : test::everyLens(70, 50)) {
        const CameraIntrinsics camera = CameraIntrinsics::pinhole(70, 50, 1.3);
        std::vector<Overlay> overlays{noise(lens, random),
                                      noise(CameraIntrinsics::pinhole(31, 20, 1), random)};
        overlays[0].shadow = noisyShadow(lens, random);
        overlays[1].shadow = noisyShadow(overlays[1].camera, random);
        std::vector<RgbImage> pictures;
        const auto compose = [&](int threads) {
            WorkerPool pool(threads);
            pictures.push_back(ground(camera));
            Composer().compose(overlays, CameraModel(camera), {}, {}, pool, pictures.back());
            EXPECT_EQ(pictures.back(), pictures.front()) << threads;
        };
        for (const int threads : {1, 2, 5}) {
            compose(threads);
        }
        test::forEachTarget([&](const char*) { compose(2); });
    }
}

TEST(Shadow, OfOneEverywhereChangesNoByte) {
    test::Random random(32);
    for (const CameraIntrinsics& lens : test::everyLens(70, 50)) {
        Overlay overlay = noise(lens, random);
        const CameraIntrinsics camera = CameraIntrinsics::pinhole(70, 50, 1.3);
        const RgbImage without = composed({&overlay, 1}, camera).picture;
        overlay.shadow = depthOf(lens.width, lens.height, 1);
        EXPECT_EQ(composed({&overlay, 1}, camera).picture, without);
    }
}

TEST(Overlay, RefusesWhatDoesNotFitAndLeavesTheViewAlone) {
    WorkerPool pool(1);
    Composer composer;
    RgbImage picture = ground(kSmall);
    MaskImage shown;
    std::vector<Overlay> overlays(2, plain(kSmall, {255, 0, 0, 255}, 1));
    ComposeOptions options;
    DepthImage depth;
    const auto refused = [&](const std::string& part) {
        test::expectError(ErrorKind::InvalidInput, part, [&] {
            composer.compose(overlays, CameraModel(kSmall), depth, options, pool, picture, &shown);
        });
        EXPECT_TRUE(picture.width() != 8 || picture == ground(kSmall));
        EXPECT_TRUE(shown.empty());
        overlays = std::vector<Overlay>(2, plain(kSmall, {255, 0, 0, 255}, 1));
        options = {};
        depth = {};
        picture = ground(kSmall);
    };
    overlays[1].picture = RgbaImage(8, 5);
    refused("Overlay 1 cannot be laid into the view: its picture has 8 x 5 pixels, the camera 8 x 6.");
    overlays[0].depth = {};
    refused("Overlay 0 cannot be laid into the view: its depth has 0 x 0 pixels");
    overlays[1].roomDepth = DepthImage(6, 8);
    refused("its room's depth has 6 x 8 pixels");
    overlays[1].labels = LabelImage(8, 7);
    refused("its labels' picture has 8 x 7 pixels");
    overlays[0].shadow = depthOf(8, 5, 1);
    refused("its shadow has 8 x 5 pixels");
    for (const float share : {-0.001F, 1.001F, kNan, kInfinity, -kInfinity}) {
        overlays[1].shadow = depthOf(8, 6, 1);
        *overlays[1].shadow.at(3, 2) = share;
        refused("in the pixel (3, 2); it must be from 0, no light, to 1.");
    }
    overlays[1].camera.fx = std::nan("");
    refused("Overlay 1 cannot be laid into the view: The camera model");
    overlays[1].camera.lens = LensModel::PlumbBob;
    refused("Overlay 1");
    depth = DepthImage(8, 5);
    refused("the view's depth has 8 x 5 pixels");
    picture = RgbImage(7, 6);
    refused("the view has 7 x 6 pixels");
    for (const double tolerance : {-1.0, std::nan(""), HUGE_VAL}) {
        options.toleranceM = tolerance;
        refused("tolerance");
        options.toleranceShare = tolerance;
        refused("tolerance");
    }
}

} // namespace spherewalk::render
