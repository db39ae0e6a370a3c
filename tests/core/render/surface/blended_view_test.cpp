// SPDX-License-Identifier: Apache-2.0
#include "each_target.h"
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
const CameraModel kCamera(CameraIntrinsics::pinhole(161, 121, 1.1));

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

    template <class View>
    RgbImage view(const Eigen::Vector3d& from, std::size_t photos, int threads = 1) {
        View view;
        const PixelRays rays(kCamera, m_pool);
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

    /// What is really seen.
    static RgbImage truth(const Eigen::Vector3d& from) {
        RgbImage picture(kCamera.width(), kCamera.height());
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const Eigen::Vector3d way =
                    bodyFromOptical() * kCamera.ray(Eigen::Vector2d(x, y))->normalized();
                const Eigen::Vector3d colour = painted(from + distanceTo(from, way) * way);
                for (int c = 0; c < 3; ++c) {
                    picture.at(x, y)[c] = static_cast<std::uint8_t>(colour[c]);
                }
            }
        }
        return picture;
    }

  private:
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
    EXPECT_LE(worst(ball.view<BlendedView>(kSquare[0], 4), ball.view<SurfaceView>(kSquare[0], 1)), 1);
}

TEST(BlendedView, ShowsWhatIsThere) {
    Ball ball(kSquare);
    const Eigen::Vector3d middle(0.25, 0.25, 0.1);
    EXPECT_LT(rms(ball.view<BlendedView>(middle, 4), Ball::truth(middle)), 1.5);
}

TEST(BlendedView, EvensOutTheNoiseOfPhotosThatAgree) {
    Ball ball(kSquare, 40);
    const Eigen::Vector3d middle(0.25, 0.25, 0);
    const RgbImage truth = Ball::truth(middle);
    // The mean of four has half the noise.
    EXPECT_LT(rms(ball.view<BlendedView>(middle, 4), truth),
              0.6 * rms(ball.view<SurfaceView>(middle, 4), truth));
}

TEST(BlendedView, OfOnePhotoIsItsSurface) {
    Ball ball({kSquare[0]}, 40);
    const Eigen::Vector3d beside(0.1, 0.05, 0);
    EXPECT_LE(worst(ball.view<BlendedView>(beside, 1), ball.view<SurfaceView>(beside, 1)), 1);
}

TEST(BlendedView, HasTheSameBytesForAnyNumberOfThreadsAndOnEachProcessor) {
    Ball ball(kSquare, 40);
    const Eigen::Vector3d from(0.2, 0.1, 0.05);
    const RgbImage expected = ball.view<BlendedView>(from, 4);
    EXPECT_EQ(ball.view<BlendedView>(from, 4, 3), expected);
    test::forEachTarget(
        [&](const char* target) { EXPECT_EQ(ball.view<BlendedView>(from, 4), expected) << target; });
}

TEST(DepthFusion, MixesWhatAgreesAndLeavesOutWhatDoesNot) {
    WorkerPool pool(2);
    std::vector<InverseBuffer> seen(3);
    std::vector<MaskImage> shares(3);
    for (InverseBuffer& buffer : seen) {
        fit(buffer, 4, 1);
        std::fill(buffer.values().begin(), buffer.values().end(), 0.0F);
    }
    *seen[0].at(0, 0) = 0.5F;
    *seen[1].at(0, 0) = 0.502F; // it agrees
    *seen[2].at(0, 0) = 0.6F;   // it does not
    *seen[1].at(1, 0) = 0.3F;   // the first sees nothing there
    *seen[0].at(2, 0) = 0.5F;
    InverseBuffer inverse;
    fuseDepths({{{0.1, &seen[0], &shares[0]}, {0.1, &seen[1], &shares[1]}, {0.2, &seen[2], &shares[2]}}}, 4,
               1, pool, 1, inverse);
    EXPECT_NEAR(*inverse.at(0, 0), 0.501, 1e-3);
    EXPECT_NEAR(*shares[1].at(0, 0), 127, 2);
    EXPECT_EQ(*shares[2].at(0, 0), 0);
    EXPECT_FLOAT_EQ(*inverse.at(1, 0), 0.3F);
    EXPECT_EQ(*shares[1].at(1, 0), 255);
    EXPECT_EQ(*shares[0].at(2, 0), 255);
    EXPECT_EQ(*inverse.at(3, 0), 0); // a hole
    for (int x = 0; x < 4; ++x) {
        EXPECT_EQ(*shares[0].at(x, 0) + *shares[1].at(x, 0) + *shares[2].at(x, 0), 255) << x;
    }
}

TEST(DepthFusion, OfRandomDistancesGivesSharesThatAddUp) {
    WorkerPool pool(2);
    test::Random random(3);
    std::vector<InverseBuffer> seen(4);
    std::vector<MaskImage> shares(4);
    std::vector<DepthWitness> witnesses;
    for (std::size_t i = 0; i < 4; ++i) {
        fit(seen[i], 50, 40);
        for (float& value : seen[i].values()) {
            value = random.uniform(0, 1) < 0.2 ? 0 : static_cast<float>(random.uniform(0.3, 0.35));
        }
        witnesses.push_back({i == 0 ? 0.0 : random.uniform(0, 1e6), &seen[i], &shares[i]});
    }
    InverseBuffer inverse;
    fuseDepths(witnesses, 50, 40, pool, 2, inverse);
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 50; ++x) {
            int sum = 0;
            for (const MaskImage& share : shares) {
                sum += *share.at(x, y);
            }
            ASSERT_EQ(sum, 255);
            ASSERT_TRUE(*inverse.at(x, y) == 0 ||
                        (*inverse.at(x, y) >= 0.299F && *inverse.at(x, y) <= 0.351F));
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

TEST(SoftFill, TakesTheColourOfWhatLiesBehind) {
    WorkerPool pool(2);
    RgbImage picture(40, 30);
    MaskImage known(40, 30);
    InverseBuffer inverse;
    fit(inverse, 40, 30);
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
            const bool isNear = x < 15;
            std::fill_n(picture.at(x, y), 3, static_cast<std::uint8_t>(isNear ? 200 : 50));
            *inverse.at(x, y) = isNear ? 1.0F : 0.25F;
            *known.at(x, y) = x >= 15 && x < 22 ? 0 : 1;
        }
    }
    const RgbImage before = picture;
    fillSoftly(known, inverse, pool, 2, picture);
    for (int x = 15; x < 22; ++x) {
        EXPECT_NEAR(*picture.at(x, 15), 50, 10) << x;
    }
    EXPECT_EQ(*picture.at(14, 15), *before.at(14, 15));
    EXPECT_EQ(*picture.at(22, 15), *before.at(22, 15));
}

TEST(SoftFill, OfNothingKnownChangesNothing) {
    WorkerPool pool(1);
    RgbImage picture(20, 10);
    std::fill(picture.values().begin(), picture.values().end(), std::uint8_t{77});
    const RgbImage before = picture;
    InverseBuffer inverse;
    fit(inverse, 20, 10);
    fillSoftly(MaskImage(20, 10), inverse, pool, 1, picture);
    EXPECT_EQ(picture, before);
}

} // namespace spherewalk::render
