// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "photo/exposure.h"

#include "spherewalk/geometry/equirect.h"
#include "spherewalk/practice/practice_room.h"
#include "spherewalk/scene/depth_sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <set>

namespace spherewalk::scene {

namespace {

constexpr int kSweepWidth = 256;

SweepOptions quick() {
    SweepOptions options;
    options.width = kSweepWidth;
    options.coarseWidth = 128;
    options.distances = 64;
    options.neighbours = 4;
    return options;
}

/// Photos of the practice room, each turned another way, made once.
struct Survey {
    std::vector<Rigid3> poses;
    std::vector<RgbImage> pictures;
    DepthImage range; ///< of the first

    static const Survey& made() {
        static const Survey survey = [] {
            const practice::PracticeRoom room;
            Survey made;
            double yaw = 0;
            for (const auto& [x, y] : {std::pair{2.5, 2.0}, {2.7, 2.0}, {2.3, 2.0}, {2.5, 2.2}, {2.5, 1.8}}) {
                made.poses.push_back(
                    {Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ())), {x, y, 1.2}});
                made.pictures.push_back(room.spherical(made.poses.back(), {2 * kSweepWidth, kSweepWidth}));
                yaw += 0.9;
            }
            made.range = room.sphericalRange(made.poses[0], {kSweepWidth, kSweepWidth / 2});
            return made;
        }();
        return survey;
    }

    PosedPicture photo(std::size_t i) const { return {&pictures[i], poses[i]}; }

    std::vector<PosedPicture> others(std::size_t than) const {
        std::vector<PosedPicture> result;
        for (std::size_t i = 0; i < poses.size(); ++i) {
            if (i != than) {
                result.push_back(photo(i));
            }
        }
        return result;
    }
};

bool isUsable(const PhotoDepth& depth) {
    return std::all_of(depth.inverseM.values().begin(), depth.inverseM.values().end(),
                       [](float value) { return std::isfinite(value) && value > 0; });
}

/// The share of the pixels, poles left out, whose 1 / distance is off by less than so much per metre.
double rightShare(const PhotoDepth& depth, const DepthImage& range, double tolerance) {
    int right = 0;
    int all = 0;
    for (int y = range.height() / 8; y < range.height() * 7 / 8; ++y) {
        for (int x = 0; x < range.width(); ++x) {
            right += std::abs(*depth.inverseM.at(x, y) - 1 / *range.at(x, y)) < tolerance ? 1 : 0;
            ++all;
        }
    }
    return static_cast<double>(right) / all;
}

} // namespace

TEST(DepthSweep, FindsTheDepthOfThePracticeRoom) {
    const Survey& survey = Survey::made();
    const PhotoDepth depth = sweptDepth(survey.photo(0), survey.others(0), quick());
    EXPECT_GT(rightShare(depth, survey.range, 0.05), 0.85);
}

TEST(DepthSweep, IsAsRightWhenNeighboursAreAStopDarker) {
    const Survey& survey = Survey::made();
    std::vector<RgbImage> darker;
    std::vector<PosedPicture> others = survey.others(0);
    for (PosedPicture& other : others) {
        darker.push_back(*other.picture);
        for (std::uint8_t& value : darker.back().values()) {
            value = static_cast<std::uint8_t>(std::lround(0.73 * value)); // 2^(-1 / 2.2)
        }
    }
    for (std::size_t i = 0; i < others.size(); ++i) {
        others[i].picture = &darker[i];
    }
    const double as = rightShare(sweptDepth(survey.photo(0), survey.others(0), quick()), survey.range, 0.05);
    EXPECT_GT(rightShare(sweptDepth(survey.photo(0), others, quick()), survey.range, 0.05), as - 0.08);
}

TEST(DepthSweep, KnowsThatACameraHasTwoLenses) {
    const LensPair lenses{0.02};
    const practice::PracticeRoom room;
    const auto lens = [&](const Rigid3& pose, double side) {
        return Rigid3{pose.rotation, pose * lenses.place({side, 0, 0})};
    };
    std::vector<RgbImage> pictures;
    std::vector<PosedPicture> photos;
    for (const Rigid3& pose : Survey::made().poses) {
        const EquirectSize size{2 * kSweepWidth, kSweepWidth};
        pictures.push_back(
            practice::stitched(room.spherical(lens(pose, 1), size), room.spherical(lens(pose, -1), size)));
    }
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        photos.push_back({&pictures[i], Survey::made().poses[i], lenses});
    }
    const EquirectSize size{kSweepWidth, kSweepWidth / 2};
    DepthImage range = room.sphericalRange(lens(photos[0].roomFromPhoto, 1), size);
    const DepthImage back = room.sphericalRange(lens(photos[0].roomFromPhoto, -1), size);
    for (int y = 0; y < range.height(); ++y) {
        for (int x = 0; x < range.width(); ++x) {
            const bool isBack = direction(size, Eigen::Vector2d(x, y)).x() < 0;
            *range.at(x, y) = isBack ? *back.at(x, y) : *range.at(x, y);
        }
    }
    const auto share = [&] {
        return rightShare(sweptDepth(photos[0], std::span(photos).subspan(1), quick()), range, 0.05);
    };
    const double known = share();
    EXPECT_GT(known, 0.85);
    for (PosedPicture& photo : photos) {
        photo.lenses = {};
    }
    EXPECT_LT(share(), known - 0.05);
}

TEST(DepthSweep, FindsNoEvidenceInNoise) {
    std::mt19937 random(3);
    std::vector<RgbImage> walls(5, RgbImage(2 * kSweepWidth, kSweepWidth));
    for (RgbImage& wall : walls) {
        for (std::uint8_t& value : wall.values()) {
            value = static_cast<std::uint8_t>(200 + random() % 5);
        }
    }
    std::vector<PosedPicture> others;
    for (std::size_t i = 1; i < walls.size(); ++i) {
        others.push_back({&walls[i], Survey::made().poses[i]});
    }
    const PhotoDepth depth = sweptDepth({walls.data(), Survey::made().poses[0]}, others, quick());
    const auto evident = std::count(depth.sure.values().begin(), depth.sure.values().end(), 255);
    EXPECT_LT(static_cast<double>(evident), 0.02 * static_cast<double>(depth.sure.values().size()));
}

TEST(DepthSweep, IsTheSameForAnyNumberOfThreads) {
    const Survey& survey = Survey::made();
    SweepOptions options = quick();
    options.threads = 1;
    const PhotoDepth one = sweptDepth(survey.photo(0), survey.others(0), options);
    options.threads = 3;
    EXPECT_EQ(sweptDepth(survey.photo(0), survey.others(0), options).inverseM, one.inverseM);
}

TEST(DepthSweep, GivesADepthWhereNothingHasTexture) {
    RgbImage grey(2 * kSweepWidth, kSweepWidth);
    std::fill(grey.values().begin(), grey.values().end(), std::uint8_t{128});
    const std::vector<PosedPicture> other{{&grey, {Eigen::Quaterniond::Identity(), {0.2, 0, 0}}}};
    EXPECT_TRUE(isUsable(sweptDepth({&grey, {}}, other, quick())));
}

TEST(DepthSweep, LeavesOutPhotosOfTheSamePlace) {
    const std::vector<Rigid3> poses{{}, {}, {Eigen::Quaterniond::Identity(), {0.2, 0, 0}}};
    EXPECT_EQ(sweepNeighbours(poses, 0, quick()), std::vector<std::size_t>{2});
}

TEST(DepthSweep, AsksPhotosBehindAWallOnlyWhereFewOthersAreThere) {
    std::vector<Rigid3> poses(6, Rigid3{Eigen::Quaterniond::Identity(), {0, 0, 1.2}});
    const double places[] = {0, 0.8, -1, -1.2, -1.4, 1};
    for (std::size_t i = 0; i < poses.size(); ++i) {
        poses[i].translation.x() = places[i];
    }
    const Polygon walls{{-5, -1}, {0.35, -1}, {0.35, 1}, {-5, 1}}; // between the first photo and two others
    EXPECT_EQ(sweepNeighbours(poses, 0, {}, walls), (std::vector<std::size_t>{2, 3, 4}));
    EXPECT_EQ(sweepNeighbours(poses, 1, {}, walls), (std::vector<std::size_t>{5, 0, 2}));
    EXPECT_EQ(sweepNeighbours(poses, 0, {}), (std::vector<std::size_t>{1, 2, 5, 3, 4}));
}

TEST(DepthSweep, SurvivesABaselineOfZero) {
    const Survey& survey = Survey::made();
    const std::vector<PosedPicture> same{survey.photo(0)};
    EXPECT_TRUE(isUsable(sweptDepth(survey.photo(0), same, quick())));
}

namespace {

/// Spots of random brightness on a sphere, interpolated between.
class Spots {
  public:
    Spots() : m_values(kColumns, kColumns / 2) {
        std::mt19937 random(5);
        for (std::uint8_t& value : m_values.values()) {
            value = static_cast<std::uint8_t>(40 + random() % 170);
        }
    }

    std::uint8_t at(const Eigen::Vector3d& direction) const {
        const Eigen::Vector2d place = pixel({kColumns, kColumns / 2}, direction);
        const int x = static_cast<int>(std::floor(place.x()));
        const int y = std::clamp(static_cast<int>(std::floor(place.y())), 0, kColumns / 2 - 2);
        const double right = place.x() - x;
        const double down = std::clamp(place.y() - y, 0.0, 1.0);
        const auto value = [&](int i, int j) {
            return static_cast<double>(*m_values.at((x + i + kColumns) % kColumns, y + j));
        };
        return static_cast<std::uint8_t>(
            std::lround((1 - down) * ((1 - right) * value(0, 0) + right * value(1, 0)) +
                        down * ((1 - right) * value(0, 1) + right * value(1, 1))));
    }

  private:
    static constexpr int kColumns = 96;
    MaskImage m_values;
};

constexpr double kPanelM = 0.3; ///< Half its width and height.

/// Whether a ray meets a panel a metre ahead of the sphere's centre.
bool meetsPanel(const Eigen::Vector3d& place, const Eigen::Vector3d& ray) {
    const Eigen::Vector3d at = place + (1 - place.x()) / ray.x() * ray;
    return ray.x() > 0 && std::abs(at.y()) < kPanelM && std::abs(at.z()) < kPanelM;
}

/// What is seen from a place inside a sphere with spots. Units: metres from the sphere's centre.
RgbImage insideOfSphere(double radiusM, const Eigen::Vector3d& place, bool hasPanel = false) {
    static const Spots spots;
    RgbImage picture(2 * kSweepWidth, kSweepWidth);
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const Eigen::Vector3d ray = direction({picture.width(), picture.height()}, Eigen::Vector2d(x, y));
            const double along = ray.dot(place);
            const double rangeM = -along + std::sqrt(along * along + radiusM * radiusM - place.squaredNorm());
            const Eigen::Vector3d onPanel = place + (1 - place.x()) / ray.x() * ray;
            std::fill_n(picture.at(x, y), 3,
                        hasPanel && meetsPanel(place, ray) ? spots.at(onPanel - Eigen::Vector3d(1.5, 0.2, 0))
                                                           : spots.at(place + rangeM * ray));
        }
    }
    return picture;
}

} // namespace

TEST(DepthSweep, FindsThingsAtAnyDistanceThatTheBaselineTells) {
    for (const auto& [radiusM, baselineM] :
         {std::pair{0.15, 0.06}, {0.3, 0.08}, {2.0, 0.2}, {2.0, 0.8}, {8.0, 3.0}, {60.0, 3.0}}) {
        const std::vector<Eigen::Vector3d> places{
            {0, 0, 0}, {baselineM, 0, 0}, {-baselineM, 0, 0}, {0, baselineM, 0}, {0, -baselineM, 0}};
        std::vector<RgbImage> pictures;
        for (const Eigen::Vector3d& place : places) {
            pictures.push_back(insideOfSphere(radiusM, place));
        }
        std::vector<PosedPicture> others;
        for (std::size_t i = 1; i < places.size(); ++i) {
            others.push_back({&pictures[i], {Eigen::Quaterniond::Identity(), places[i]}});
        }
        const PhotoDepth depth = sweptDepth({pictures.data(), {}}, others, quick());
        DepthImage range(kSweepWidth, kSweepWidth / 2);
        std::fill(range.values().begin(), range.values().end(), static_cast<float>(radiusM));
        const double pixelRad = 2 * std::numbers::pi / kSweepWidth;
        EXPECT_GT(rightShare(depth, range, pixelRad / baselineM), 0.95) << radiusM << " " << baselineM;
    }
}

TEST(DepthSweep, WidensNearThingsByLessThanATenthOfAPixel) {
    const std::vector<Eigen::Vector3d> places{
        {0, 0, 0}, {0, 0.2, 0}, {0, -0.2, 0}, {0, 0, 0.2}, {0, 0, -0.2}};
    std::vector<RgbImage> pictures;
    for (const Eigen::Vector3d& place : places) {
        pictures.push_back(insideOfSphere(3, place, true));
    }
    std::vector<PosedPicture> others;
    for (std::size_t i = 1; i < places.size(); ++i) {
        others.push_back({&pictures[i], {Eigen::Quaterniond::Identity(), places[i]}});
    }
    const PhotoDepth depth = sweptDepth({pictures.data(), {}}, others, quick());
    const EquirectSize size{kSweepWidth, kSweepWidth / 2};
    int panel = 0;
    int widened = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const bool isOnPanel = meetsPanel({0, 0, 0}, direction(size, Eigen::Vector2d(x, y)));
            const bool isNear = *depth.inverseM.at(x, y) > 0.6F;
            panel += isOnPanel ? 1 : 0;
            widened += isNear && !isOnPanel ? 1 : 0;
        }
    }
    const double aroundPx = 4 * std::sqrt(panel);
    EXPECT_LT(widened / aroundPx, 0.1);
}

TEST(DepthSweep, RefusesAPhotoAlone) {
    const Survey& survey = Survey::made();
    test::expectError(ErrorKind::InvalidInput, "one alone tells no depth",
                      [&] { sweptDepth(survey.photo(0), {}, quick()); });
}

TEST(DepthSweep, RefusesAPoseThatIsNone) {
    const Survey& survey = Survey::made();
    std::vector<PosedPicture> others = survey.others(0);
    others[0].roomFromPhoto.translation.x() = NAN;
    test::expectError(ErrorKind::InvalidInput, "align the survey",
                      [&] { sweptDepth(survey.photo(0), others, quick()); });
}

TEST(DepthSweep, StopsWhenAsked) {
    const Survey& survey = Survey::made();
    std::stop_source stop;
    stop.request_stop();
    test::expectError(ErrorKind::Stopped, "",
                      [&] { sweptDepth(survey.photo(0), survey.others(0), quick(), stop.get_token()); });
}

namespace {

/// Two photos of the inside of a sphere about the first.
struct TwoDepths {
    PhotoDepth first{Image<float, 1>(kSweepWidth, kSweepWidth / 2), MaskImage(kSweepWidth, kSweepWidth / 2)};
    PhotoDepth second = first;
    RgbImage picture{kSweepWidth, kSweepWidth / 2};

    TwoDepths() {
        std::fill(first.inverseM.values().begin(), first.inverseM.values().end(), 0.5F);
        second = first;
    }

    PhotoDepth agreed() const {
        const std::vector<PosedDepth> other{{&second, {Eigen::Quaterniond::Identity(), {0.1, 0, 0}}}};
        return agreeingDepth({&first, {}}, picture, other);
    }
};

} // namespace

TEST(DepthAgreement, IsSureOfWhatANeighbourSaysToo) {
    const PhotoDepth depth = TwoDepths().agreed();
    EXPECT_TRUE(std::all_of(depth.sure.values().begin(), depth.sure.values().end(),
                            [](std::uint8_t sure) { return sure != 0; }));
}

TEST(DepthAgreement, TakesOverWhatLiesBesideWhereNobodyAgrees) {
    TwoDepths depths;
    *depths.first.inverseM.at(100, 64) = 2;
    const PhotoDepth depth = depths.agreed();
    EXPECT_EQ(*depth.sure.at(100, 64), 0);
    EXPECT_NEAR(*depth.inverseM.at(100, 64), 0.5F, 0.01F);
}

// As in a white room: one wall in eight shows anything, and of the others each photo has another guess.
TEST(DepthAgreement, KeepsWhatIsEvidentBetweenBareWalls) {
    TwoDepths depths;
    for (int y = 0; y < kSweepWidth / 2; ++y) {
        for (int x = 0; x < kSweepWidth; ++x) {
            const bool isSeen = x >= kSweepWidth / 4 && x < kSweepWidth * 3 / 8;
            *depths.first.sure.at(x, y) = isSeen ? 255 : 0;
            *depths.first.inverseM.at(x, y) = isSeen ? 0.5F : 0.2F;
            *depths.second.inverseM.at(x, y) = isSeen ? 0.5F : 1.0F;
        }
    }
    const PhotoDepth depth = depths.agreed();
    const int middle = kSweepWidth * 5 / 16;
    EXPECT_EQ(*depth.sure.at(middle, kSweepWidth / 4), 255);
    EXPECT_NEAR(*depth.inverseM.at(middle, kSweepWidth / 4), 0.5F, 0.01F);
    EXPECT_NEAR(*depth.inverseM.at(0, kSweepWidth / 4), 0.5F, 0.05F); // and what is bare continues it
}

TEST(DepthAgreement, DropsWhatNeighboursConfirmByChance) {
    TwoDepths depths;
    std::mt19937 random(7);
    for (PhotoDepth* depth : {&depths.first, &depths.second}) {
        std::fill(depth->sure.values().begin(), depth->sure.values().end(), std::uint8_t{255});
        for (float& value : depth->inverseM.values()) {
            value = 0.1F + 1.5F * static_cast<float>(random()) / static_cast<float>(std::mt19937::max());
        }
    }
    const PhotoDepth depth = depths.agreed();
    EXPECT_EQ(std::count(depth.sure.values().begin(), depth.sure.values().end(), 255), 0);
    const auto [least, most] =
        std::minmax_element(depth.inverseM.values().begin(), depth.inverseM.values().end());
    EXPECT_LT(*most, 1.05F * *least);
}

TEST(DepthAgreement, LeavesNoSpeckThatStandsByItself) {
    TwoDepths depths;
    for (PhotoDepth* depth : {&depths.first, &depths.second}) {
        std::fill(depth->sure.values().begin(), depth->sure.values().end(), std::uint8_t{255});
        *depth->inverseM.at(100, 64) = 2; // Where both look alike, both may be wrong alike.
    }
    depths.second.inverseM = depths.first.inverseM;
    const std::vector<PosedDepth> same{{&depths.second, {}}};
    const PhotoDepth depth = agreeingDepth({&depths.first, {}}, depths.picture, same);
    EXPECT_NEAR(*depth.inverseM.at(100, 64), 0.5F, 0.01F);
}

TEST(RanksByPlace, PutPhotosThatStandBesideEachOtherNearEachOther) {
    constexpr int kSide = 20;
    std::vector<Rigid3> poses;
    for (int i = 0; i < kSide * kSide; ++i) { // row by row, far from the origin
        poses.push_back({Eigen::Quaterniond::Identity(), {1e6 + 0.2 * (i % kSide), 0.2 * (i / kSide), 1.2}});
    }
    const std::vector<std::size_t> ranks = ranksByPlace(poses);
    EXPECT_EQ(std::set(ranks.begin(), ranks.end()).size(), poses.size());
    int near = 0;
    for (std::size_t i = 0; i + kSide < poses.size(); ++i) {
        const auto apart = static_cast<int>(ranks[i]) - static_cast<int>(ranks[i + kSide]);
        near += std::abs(apart) <= 5 ? 1 : 0;
    }
    EXPECT_GT(near, 350) << "of 380";
    EXPECT_TRUE(ranksByPlace({}).empty());
    EXPECT_EQ(ranksByPlace(std::vector<Rigid3>(2)), (std::vector<std::size_t>{0, 1}));
}

} // namespace spherewalk::scene
