// SPDX-License-Identifier: Apache-2.0
#include "each_target.h"
#include "lenses.h"
#include "random.h"
#include "surface/surface_view.h"

#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/scene_depth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>

namespace spherewalk::render {

namespace {

constexpr EquirectSize kPhoto{512, 256};
constexpr double kRadiusM = 3; ///< The room is a ball about the origin.
const CameraModel kBlendCamera(CameraIntrinsics::pinhole(161, 121, 1.1));

/// The colour of a place on the ball.
Eigen::Vector3d painted(const Eigen::Vector3d& place) {
    const Eigen::Vector3d d = place / kRadiusM;
    return {128 + 60 * std::sin(5 * d.x()), 128 + 60 * std::sin(4 * d.y() + 1),
            128 + 60 * std::sin(6 * d.z())};
}

/// How far the ball is from a place in it.
double distanceTo(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) {
    const double along = from.dot(direction);
    return -along + std::sqrt(along * along + kRadiusM * kRadiusM - from.squaredNorm());
}

/// Photos of the ball from several places, with their depths.
class Ball {
  public:
    explicit Ball(const std::vector<Eigen::Vector3d>& places, double noise = 0) {
        test::Random random(7);
        for (const Eigen::Vector3d& place : places) {
            RgbImage picture(kPhoto.width, kPhoto.height);
            Image<float, 1> inverse(kPhoto.width, kPhoto.height);
            for (int y = 0; y < kPhoto.height; ++y) {
                for (int x = 0; x < kPhoto.width; ++x) {
                    const Eigen::Vector3d way = direction(kPhoto, Eigen::Vector2d(x, y));
                    const double distance = distanceTo(place, way);
                    *inverse.at(x, y) = static_cast<float>(1 / distance);
                    const Eigen::Vector3d colour = painted(place + distance * way);
                    for (int c = 0; c < 3; ++c) {
                        picture.at(x, y)[c] = static_cast<std::uint8_t>(
                            std::clamp(colour[c] + noise * random.uniform(-1, 1), 0.0, 255.0));
                    }
                }
            }
            add(place, picture, DepthMap(std::move(inverse)));
        }
    }

    void add(const Eigen::Vector3d& place, const RgbImage& picture, const DepthMap& depth) {
        m_planes.push_back(std::make_unique<PhotoPlane>(picture));
        m_photos.push_back({m_photos.size(),
                            std::make_shared<const SurfaceMesh>(depth),
                            {Eigen::Quaterniond::Identity(), place},
                            TileGrid(kPhoto)});
    }

    /// Makes a photo darker, and says so or not.
    void darken(std::size_t photo, double factor, bool isTold) {
        RgbImage picture(kPhoto.width, kPhoto.height);
        const PlaneView plane = m_planes[photo]->view();
        for (int y = 0; y < kPhoto.height; ++y) {
            for (int x = 0; x < kPhoto.width; ++x) {
                for (int c = 0; c < 3; ++c) {
                    picture.at(x, y)[c] =
                        static_cast<std::uint8_t>(factor * (plane.stored(x, y, c) + 128) + 0.5);
                }
            }
        }
        m_planes[photo] = std::make_unique<PhotoPlane>(picture);
        m_photos[photo].gain = Eigen::Vector3d::Constant(isTold ? 1 / factor : 1);
    }

    /// The view of one photo after the other.
    RgbImage surface(const Eigen::Vector3d& from, std::size_t photos) {
        return view(SurfaceView(), from, photos, 1);
    }

    /// The view in which photos are mixed.
    RgbImage blend(const Eigen::Vector3d& from, std::size_t photos, int threads = 1,
                   const CameraModel& camera = kBlendCamera) {
        return view(SurfaceView(true), from, photos, threads, camera);
    }

    /// What is really seen.
    static RgbImage truth(const Eigen::Vector3d& from) {
        RgbImage picture(kBlendCamera.width(), kBlendCamera.height());
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const Eigen::Vector3d way =
                    bodyFromOptical() * kBlendCamera.ray(Eigen::Vector2d(x, y))->normalized();
                const Eigen::Vector3d colour = painted(from + distanceTo(from, way) * way);
                for (int c = 0; c < 3; ++c) {
                    picture.at(x, y)[c] = static_cast<std::uint8_t>(colour[c]);
                }
            }
        }
        return picture;
    }

  private:
    RgbImage view(SurfaceView view, const Eigen::Vector3d& from, std::size_t photos, int threads,
                  const CameraModel& camera = kBlendCamera) {
        const PixelRays rays(camera, m_pool);
        const std::span<const SurfacePhoto> used(m_photos.data(), photos);
        view.prepare(rays, {bodyFromOptical(), from}, used, 2, 1, m_pool, threads);
        std::vector<PlaneView> planes;
        for (std::size_t i = 0; i < photos; ++i) {
            planes.push_back(m_planes[i]->view());
        }
        RgbImage picture;
        view.sample(rays, planes, Sampling::Bilinear, m_pool, threads, picture);
        return picture;
    }

    std::vector<std::unique_ptr<PhotoPlane>> m_planes;
    std::vector<SurfacePhoto> m_photos;
    WorkerPool m_pool{3};
};

double rms(const RgbImage& a, const RgbImage& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.values().size(); ++i) {
        const double apart = double{1} * a.values()[i] - b.values()[i];
        sum += apart * apart;
    }
    return std::sqrt(sum / static_cast<double>(a.values().size()));
}

int worst(const RgbImage& a, const RgbImage& b) {
    int most = 0;
    for (std::size_t i = 0; i < a.values().size(); ++i) {
        most = std::max(most, std::abs(int{a.values()[i]} - int{b.values()[i]}));
    }
    return most;
}

const std::vector<Eigen::Vector3d> kSquare{{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}, {0.5, 0.5, 0}};

/// A map of one distance with a nearer square in the middle.
Image<float, 1> stepped(int left, int right) {
    Image<float, 1> inverse(64, 32);
    std::fill(inverse.values().begin(), inverse.values().end(), 0.4F);
    for (int y = 12; y < 20; ++y) {
        for (int x = left; x < right; ++x) {
            *inverse.at((x + 64) % 64, y) = 0.8F;
        }
    }
    return inverse;
}

} // namespace

TEST(BlendedView, AtAPhotoIsThatPhoto) {
    Ball ball(kSquare, 40);
    EXPECT_LE(worst(ball.blend(kSquare[0], 4), ball.surface(kSquare[0], 1)), 1);
}

TEST(BlendedView, AtAPhotoIsThatPhotoAlthoughAnotherStandsThere) {
    const Eigen::Vector3d beside(0.0001, 0, 0);
    Ball ball({kSquare[0], beside}, 40);
    EXPECT_LE(worst(ball.blend(kSquare[0], 2), ball.surface(kSquare[0], 1)), 1);
}

TEST(BlendedView, ShowsWhatIsThere) {
    Ball ball(kSquare);
    const Eigen::Vector3d middle(0.25, 0.25, 0.1);
    EXPECT_LT(rms(ball.blend(middle, 4), Ball::truth(middle)), 1.5);
}

TEST(BlendedView, EvensOutTheNoiseOfPhotosThatAgree) {
    Ball ball(kSquare, 40);
    const Eigen::Vector3d middle(0.25, 0.25, 0);
    const RgbImage truth = Ball::truth(middle);
    // The mean of two has 0.71 of the noise.
    EXPECT_LT(rms(ball.blend(middle, 4), truth), 0.75 * rms(ball.surface(middle, 4), truth));
}

TEST(BlendedView, IsTheSameFromBothSidesOfABorder) {
    const Eigen::Vector3d middle(0.25, 0.1, 0);
    Ball one({kSquare[0], kSquare[1]});
    Ball other({kSquare[1], kSquare[0]});
    one.darken(1, 0.96, false); // which tells the photos apart, by up to eight levels
    other.darken(0, 0.96, false);
    EXPECT_LT(rms(one.blend(middle, 2), other.blend(middle, 2)), 1);
    EXPECT_GT(rms(one.surface(middle, 2), other.surface(middle, 2)), 3);
}

TEST(BlendedView, ShowsNothingThatTheNearestPhotoDoesNotShowThere) {
    const Eigen::Vector3d middle(0.24, 0.1, 0);
    Ball same({kSquare[0], kSquare[1]});
    Ball differing({kSquare[0], kSquare[1]});
    differing.darken(1, 0.3, false);
    EXPECT_LT(rms(differing.blend(middle, 2), same.blend(middle, 2)), 8);
}

TEST(BlendedView, OfOnePhotoIsItsSurface) {
    Ball ball({kSquare[0]}, 40);
    const Eigen::Vector3d beside(0.1, 0.05, 0);
    EXPECT_LE(worst(ball.blend(beside, 1), ball.surface(beside, 1)), 1);
}

TEST(BlendedView, HasTheSameBytesForAnyNumberOfThreadsAndOnEachProcessor) {
    Ball ball(kSquare, 40);
    const Eigen::Vector3d from(0.2, 0.1, 0.05);
    const RgbImage expected = ball.blend(from, 4);
    EXPECT_EQ(ball.blend(from, 4, 3), expected);
    test::forEachTarget([&](const char* target) { EXPECT_EQ(ball.blend(from, 4), expected) << target; });
}

TEST(BlendedView, MakesPhotosAsBrightAsTheFirst) {
    const Eigen::Vector3d middle(0.25, 0.2, 0);
    const RgbImage truth = Ball::truth(middle);
    for (const std::size_t photo : {1, 2, 3}) {
        Ball told(kSquare);
        Ball untold(kSquare);
        told.darken(photo, 0.7, true);
        untold.darken(photo, 0.7, false);
        EXPECT_LT(rms(told.blend(middle, 4), truth), 1.5) << photo;
        if (photo == 1) {
            EXPECT_GT(rms(untold.blend(middle, 4), truth), 4);
        }
    }
}

TEST(BlendedView, StaysBlackWhereTheLensSeesNothing) {
    Ball ball(kSquare);
    CameraIntrinsics lens = test::everyLens(161, 121).back();
    lens.fx = lens.fy = 25;
    lens.distortion = {0, 0, 0, 0};
    const CameraModel fisheye(lens);
    const RgbImage picture = ball.blend({0.25, 0.25, 0}, 4, 1, fisheye);
    int blind = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const bool isBlind = !fisheye.ray(Eigen::Vector2d(x, y));
            const std::uint8_t* pixel = picture.at(x, y);
            ASSERT_EQ(pixel[0] == 0 && pixel[1] == 0 && pixel[2] == 0, isBlind) << x << ' ' << y;
            blind += isBlind ? 1 : 0;
        }
    }
    EXPECT_GT(blind, 1000);
}

/// A cell of two photos.
struct TwoSeen {
    static constexpr std::size_t kPixels = SurfaceCoordinates::kCellPixels;

    std::array<float, kPixels> first{};
    std::array<float, kPixels> second{};
    std::array<std::uint8_t, kPixels> sources{};
    std::array<std::uint8_t, kPixels> shares{};

    simd::Mixture mix(float perFirst) {
        return simd::mixDistances(second.data(), kCell, perFirst, first.data(), sources.data(),
                                  shares.data());
    }
};

TEST(Mixture, IsOfWhatAgrees) {
    TwoSeen cell;
    cell.first[0] = 0.5F;
    cell.second[0] = 0.502F; // it agrees
    cell.first[1] = 0.5F;
    cell.second[1] = 0.6F; // it does not
    cell.second[2] = 0.3F; // the first sees nothing there
    cell.first[3] = 0.5F;  // the second sees nothing there
    const simd::Mixture mixture = cell.mix(1);
    EXPECT_NEAR(cell.first[0], 0.501, 1e-4);
    EXPECT_NEAR(cell.shares[0], 127, 1);
    EXPECT_EQ(cell.first[1], 0.5F);
    EXPECT_EQ(cell.shares[1], 0);
    EXPECT_EQ(cell.first[2], 0.3F);
    EXPECT_EQ(cell.sources[2], 1);
    EXPECT_EQ(cell.shares[2], 0);
    EXPECT_EQ(cell.first[3], 0.5F);
    EXPECT_EQ(cell.sources[3], 0);
    EXPECT_EQ(cell.first[4], 0); // a hole
    EXPECT_EQ(cell.sources[4], 0);
    EXPECT_EQ(mixture.open, static_cast<int>(TwoSeen::kPixels) - 3);
    EXPECT_TRUE(mixture.hasOthers);
    EXPECT_TRUE(mixture.isMixed);
}

TEST(Mixture, LeavesTheFirstPhotoAloneAtItsPlace) {
    TwoSeen cell;
    cell.first.fill(0.5F);
    cell.second.fill(0.5F);
    const simd::Mixture mixture = cell.mix(1e-6F);
    EXPECT_FALSE(mixture.isMixed);
    EXPECT_FALSE(mixture.hasOthers);
    EXPECT_EQ(mixture.open, 0);
}

TEST(Mixture, LiesBetweenTheTwoOnEachProcessor) {
    test::Random random(3);
    TwoSeen seen;
    for (std::size_t i = 0; i < TwoSeen::kPixels; ++i) {
        seen.first[i] = random.uniform(0, 1) < 0.2 ? 0 : static_cast<float>(random.uniform(1e-6, 0.35));
        seen.second[i] =
            random.uniform(0, 1) < 0.2 ? 0 : seen.first[i] * static_cast<float>(random.uniform(0.9, 1.1));
    }
    TwoSeen expected = seen;
    expected.mix(0.7F);
    for (std::size_t i = 0; i < TwoSeen::kPixels; ++i) {
        ASSERT_LE(expected.first[i], std::max(seen.first[i], seen.second[i]) * 1.000001F);
        ASSERT_GE(expected.first[i] * 1.000001F, seen.first[i] > 0 && seen.second[i] > 0
                                                     ? std::min(seen.first[i], seen.second[i])
                                                     : std::max(seen.first[i], seen.second[i]));
        ASSERT_LE(expected.shares[i], 105);
    }
    test::forEachTarget([&](const char* target) {
        TwoSeen cell = seen;
        cell.mix(0.7F);
        EXPECT_EQ(cell.first, expected.first) << target;
        EXPECT_EQ(cell.shares, expected.shares) << target;
        EXPECT_EQ(cell.sources, expected.sources) << target;
    });
}

TEST(WeighedShares, LeaveRimsToTheOtherPhoto) {
    std::array<std::uint8_t, TwoSeen::kPixels> own{};
    std::array<std::uint8_t, TwoSeen::kPixels> other{};
    std::array<std::uint8_t, TwoSeen::kPixels> shares{};
    own.fill(255);
    other.fill(255);
    shares.fill(100);
    own[0] = 1;   // the first shows a rim
    other[1] = 1; // the second shows one
    own[2] = other[2] = 1;
    simd::weighShares(own.data(), other.data(), shares.data());
    EXPECT_GE(shares[0], 253);
    EXPECT_LE(shares[1], 1);
    EXPECT_EQ(shares[2], 100); // both show one
    EXPECT_EQ(shares[3], 100);
}

TEST(ColoursKeptWithin, AreNotBeyondWhatIsBesideThem) {
    using Colours = std::array<std::uint8_t, 3 * TwoSeen::kPixels>;
    test::Random random(6);
    const auto any = [&random] {
        Colours colours;
        for (std::uint8_t& value : colours) {
            value = static_cast<std::uint8_t>(random.uniform(0, 256));
        }
        return colours;
    };
    Colours view = any();
    for (std::size_t i = 0; i < view.size() / 2; ++i) { // the upper half is even, and white at its right end
        view[i] = i / 3 % kCell < 12 ? static_cast<std::uint8_t>(100 + i % 7) : 255;
    }
    const Colours others = any();
    test::forEachTarget([&](const char* target) {
        Colours kept = others;
        simd::keepWithin(view.data(), kept.data());
        for (int y = 0; y < kCell; ++y) {
            for (int x = 0; x < kCell; ++x) {
                for (int channel = 0; channel < 3; ++channel) {
                    int least = 255;
                    int most = 0;
                    for (int v = std::max(0, y - 2); v <= std::min(kCell - 1, y + 2); ++v) {
                        for (int u = std::max(0, x - 2); u <= std::min(kCell - 1, x + 2); ++u) {
                            const int value = view[static_cast<std::size_t>(3 * (v * kCell + u) + channel)];
                            least = std::min(least, value);
                            most = std::max(most, value);
                        }
                    }
                    const auto at = static_cast<std::size_t>(3 * (y * kCell + x) + channel);
                    const int expected =
                        std::clamp<int>(others[at], std::max(0, least - 8), std::min(255, most + 8));
                    ASSERT_EQ(kept[at], expected) << target << ' ' << x << ' ' << y;
                }
            }
        }
    });
}

TEST(MixedColours, AreTheNearestLevelOfTheMean) {
    test::Random random(5);
    for (int round = 0; round < 200; ++round) {
        std::array<std::uint8_t, 48> other;
        std::array<std::uint8_t, 48> colours;
        std::array<std::uint8_t, 16> shares;
        for (std::uint8_t& value : other) {
            value = static_cast<std::uint8_t>(random.uniform(0, 256));
        }
        for (std::uint8_t& value : colours) {
            value = static_cast<std::uint8_t>(random.uniform(0, 256));
        }
        for (std::uint8_t& value : shares) {
            value = static_cast<std::uint8_t>(random.uniform(0, 256));
        }
        const std::array<std::uint8_t, 48> before = colours;
        simd::mixColours(other.data(), shares.data(), colours.data());
        for (std::size_t k = 0; k < colours.size(); ++k) {
            const double share = shares[k / 3] / 255.0;
            ASSERT_NEAR(colours[k], before[k] + share * (other[k] - before[k]), 0.5 + 1e-9);
        }
    }
}

TEST(Rims, AreBehindNearerThingsAlone) {
    const MaskImage weights = colourWeights(DepthMap(stepped(28, 36)));
    EXPECT_EQ(*weights.at(28, 15), 255); // the thing itself
    EXPECT_EQ(*weights.at(35, 12), 255);
    const std::array<int, 4> beside{*weights.at(36, 15), *weights.at(37, 15), *weights.at(38, 15),
                                    *weights.at(39, 15)};
    EXPECT_TRUE(std::is_sorted(beside.begin(), beside.end()));
    EXPECT_LT(beside[0], 8);
    EXPECT_EQ(beside[3], 255);
    EXPECT_EQ(*weights.at(30, 11), beside[0]); // above
}

TEST(Rims, GoOnBeyondTheSeam) {
    const MaskImage weights = colourWeights(DepthMap(stepped(-4, 0)));
    EXPECT_LT(*weights.at(0, 15), 8);
    EXPECT_EQ(*weights.at(3, 15), 255);
}

TEST(Rims, AreNotOnAFloorThatIsSeenAtASlant) {
    constexpr int kWidth = 1024;
    Image<float, 1> inverse(kWidth, kWidth / 2);
    for (int y = 0; y < kWidth / 2; ++y) {
        const double down = -std::sin(std::numbers::pi * (0.5 - (y + 0.5) / (kWidth / 2)));
        const double tenDegrees = 0.17; // a wall is farther up
        std::fill_n(inverse.at(0, y), kWidth, static_cast<float>(std::max(tenDegrees, down) / 1.2));
    }
    const MaskImage weights = colourWeights(DepthMap(std::move(inverse)));
    const auto least = std::min_element(weights.values().begin(), weights.values().end());
    EXPECT_GE(*least, 64);
}

TEST(Rims, AreInThePartsOfTheMapThatMayHaveSome) {
    for (const int left : {28, -4, -1, 60}) {
        const SurfaceMesh mesh(DepthMap(stepped(left, left + 8)));
        const MaskImage& weights = mesh.colourWeights();
        int free = 0;
        for (int y = 0; y < weights.height(); ++y) {
            for (int x = 0; x < weights.width(); ++x) {
                const bool mayHave = mesh.hasRims(x - 0.5, y - 0.5, x + 0.5, y + 0.5);
                ASSERT_TRUE(mayHave || *weights.at(x, y) == 255) << x << ' ' << y;
                free += mayHave ? 0 : 1;
            }
        }
        EXPECT_GT(free, 1000);
        EXPECT_TRUE(mesh.hasRims(-0.5, -0.5, 63.5, 31.5));
    }
}

} // namespace spherewalk::render
