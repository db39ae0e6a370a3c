// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "free/placing.h"
#include "made/noise_photo.h"
#include "random.h"

#include "spherewalk/geometry/equirect.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::align {

namespace {

constexpr int kTestWidth = 1024;
constexpr double kTestPixelRad = 2 * std::numbers::pi / kTestWidth;

/// Photos of a room of 4 x 4 x 3 m whose walls, floor and ceiling have a smooth pattern.
class PatternRoom {
  public:
    Bundle bundle;
    bool isBlank = false;
    int foreign = -1; ///< A photo that shows another pattern.

    void addPhoto(const Eigen::Vector3d& at, const Eigen::Vector3d& turnRad) {
        bundle.photos.push_back(
            {Eigen::Quaterniond(Eigen::AngleAxisd(turnRad.norm(), turnRad.normalized())), at});
    }

    /// A thing on a wall, seen by all photos with errors of about half a pixel along either axis.
    void addThing(const Eigen::Vector3d& at, test::Random& random) {
        SeenPoint point;
        point.at = at;
        for (std::size_t i = 0; i < bundle.photos.size(); ++i) {
            const Eigen::Vector3d seen =
                (at - bundle.photos[i].positionM).normalized() + random.vector(0.5 * kTestPixelRad);
            point.rays.push_back({static_cast<int>(i),
                                  (bundle.photos[i].roomFromPhoto.conjugate() * seen).normalized(),
                                  kTestPixelRad});
        }
        bundle.points.push_back(point);
    }

    RgbImage photo(int place) const {
        const PhotoState& state = bundle.photos[static_cast<std::size_t>(place)];
        RgbImage made(kTestWidth, kTestWidth / 2);
        for (int y = 0; y < made.height(); ++y) {
            for (int x = 0; x < made.width(); ++x) {
                const Eigen::Vector3d ray =
                    state.roomFromPhoto * direction(EquirectSize{made.width(), made.height()}, {x, y});
                const double value = isBlank ? 128. : shade(hit(state.positionM, ray), place == foreign);
                // Each photo has another exposure.
                std::fill_n(made.at(x, y), 3,
                            static_cast<std::uint8_t>(std::lround(value * (1 - 0.1 * (place % 3)))));
            }
        }
        return made;
    }

    /// Where a ray from inside meets the room.
    static Eigen::Vector3d hit(const Eigen::Vector3d& from, const Eigen::Vector3d& ray) {
        const Eigen::Vector3d low(-2, -2, 0);
        const Eigen::Vector3d high(2, 2, 3);
        double nearest = 1e9;
        for (int i = 0; i < 3; ++i) {
            if (std::abs(ray[i]) > 1e-12) {
                nearest = std::min(nearest, ((ray[i] > 0 ? high : low)[i] - from[i]) / ray[i]);
            }
        }
        return from + nearest * ray;
    }

    void refine(int threads = 0) {
        refineRays(bundle, [this](int place, int) { return photo(place); }, threads, noProgress(), {});
    }

    /// How far ray i of a point is from where the nearest photo saw the thing, in pixels.
    double offPx(const SeenPoint& point, std::size_t i, std::size_t nearest) const {
        const auto inRoom = [&](const Ray& ray) {
            return bundle.photos[static_cast<std::size_t>(ray.photo)].roomFromPhoto * ray.bearing;
        };
        const Eigen::Vector3d at = hit(bundle.photos[nearest].positionM, inRoom(point.rays[nearest]));
        const Eigen::Vector3d right = (at - bundle.photos[i].positionM).normalized();
        return right.cross(inRoom(point.rays[i])).norm() / kTestPixelRad;
    }

  private:
    static double shade(const Eigen::Vector3d& at, bool isForeign) {
        const Eigen::Vector3d there = at + Eigen::Vector3d::Constant(isForeign ? 100.3 : 10);
        return 255 * (0.5 * test::spaceNoise(there * 6) + 0.5 * test::spaceNoise(there * 14));
    }
};

/// Photos at several distances, leaning and turned, and things on a wall, at the seam, overhead and below.
PatternRoom patternRoom() {
    PatternRoom room;
    room.addPhoto({0.2, 0.1, 1.5}, {0.02, -0.03, 0.4});
    room.addPhoto({0.8, 0.2, 1.4}, {-0.05, 0.02, 3.1});
    room.addPhoto({-0.9, -0.3, 1.6}, {0.01, 0.06, -2.0});
    room.addPhoto({-0.1, -0.6, 1.5}, {0.001, 0, 0});
    test::Random random(7);
    for (int i = 0; i < 8; ++i) {
        room.addThing({2, -0.7 + 0.2 * i, 1.2 + 0.1 * i}, random);
        // The seam of the photo that is not turned.
        room.addThing({-2, -0.8 + 0.2 * i, 1.1 + 0.1 * i}, random);
        room.addThing({-0.8 + 0.25 * i, 0.1 * i, 3}, random);
        room.addThing({-0.8 + 0.25 * i, -0.1 * i, 0}, random);
    }
    return room;
}

} // namespace

TEST(RayRefinement, FindsInAllPhotosWhatTheNearestSees) {
    PatternRoom room = patternRoom();
    room.refine();
    int found = 0;
    int all = 0;
    double squares = 0;
    double worst = 0;
    for (const SeenPoint& point : room.bundle.points) {
        std::size_t nearest = 0;
        for (std::size_t i = 0; i < point.rays.size(); ++i) {
            const auto distance = [&](std::size_t j) {
                return (point.at - room.bundle.photos[j].positionM).norm();
            };
            nearest = distance(i) < distance(nearest) ? i : nearest;
        }
        for (std::size_t i = 0; i < point.rays.size(); ++i) {
            all += i != nearest ? 1 : 0;
            if (i != nearest && point.rays[i].sigmaRad < kTestPixelRad) {
                const double off = room.offPx(point, i, nearest);
                ++found;
                squares += off * off;
                worst = std::max(worst, off);
            }
        }
    }
    RecordProperty("found", found);
    RecordProperty("all", all);
    RecordProperty("rms_px", std::to_string(std::sqrt(squares / found)));
    RecordProperty("worst_px", std::to_string(worst));
    EXPECT_GT(found, 0.8 * all);
    EXPECT_LT(std::sqrt(squares / found), 0.15); // Before, a pixel.
    EXPECT_LT(worst, 0.5);
}

TEST(RayRefinement, KeepsRaysWhereNothingCanBeCompared) {
    PatternRoom room = patternRoom();
    room.isBlank = true;
    const std::vector<SeenPoint> before = room.bundle.points;
    room.refine();
    for (std::size_t i = 0; i < before.size(); ++i) {
        for (std::size_t j = 0; j < before[i].rays.size(); ++j) {
            EXPECT_EQ(room.bundle.points[i].rays[j].bearing, before[i].rays[j].bearing);
            EXPECT_EQ(room.bundle.points[i].rays[j].sigmaRad, before[i].rays[j].sigmaRad);
        }
    }
}

TEST(RayRefinement, KeepsTheRaysOfAPhotoThatShowsSomethingElse) {
    PatternRoom room = patternRoom();
    room.foreign = 3;
    room.refine();
    int changed = 0;
    for (const SeenPoint& point : room.bundle.points) {
        changed += point.rays[3].sigmaRad < kTestPixelRad ? 1 : 0;
    }
    EXPECT_LE(changed, 3);
}

TEST(RayRefinement, GivesTheSameForAnyNumberOfThreads) {
    PatternRoom one = patternRoom();
    PatternRoom many = patternRoom();
    one.refine(1);
    many.refine(5);
    for (std::size_t i = 0; i < one.bundle.points.size(); ++i) {
        for (std::size_t j = 0; j < one.bundle.points[i].rays.size(); ++j) {
            EXPECT_EQ(one.bundle.points[i].rays[j].bearing, many.bundle.points[i].rays[j].bearing);
        }
    }
}

// Two photos of one place, a point on the lens, and a direction that is no number.
TEST(RayRefinement, SurvivesWhatHasNoScale) {
    PatternRoom room = patternRoom();
    room.addPhoto(room.bundle.photos.front().positionM, {0.3, 0, 0});
    room.bundle.points[0].at = room.bundle.photos[0].positionM;
    room.bundle.points[1].at = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    room.bundle.points[2].rays[1].bearing =
        Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    room.bundle.points[3].rays.resize(1);
    room.bundle.points[4].rays.clear();
    EXPECT_NO_THROW(room.refine());
    for (std::size_t i = 5; i < room.bundle.points.size(); ++i) {
        for (const Ray& ray : room.bundle.points[i].rays) {
            EXPECT_TRUE(ray.bearing.allFinite());
        }
    }
}

TEST(RayRefinement, StopsWhenAsked) {
    PatternRoom room = patternRoom();
    std::stop_source stop;
    stop.request_stop();
    const auto picture = [&room](int place, int) { return room.photo(place); };
    test::expectError(ErrorKind::Stopped, "",
                      [&] { refineRays(room.bundle, picture, 0, noProgress(), stop.get_token()); });
}

} // namespace spherewalk::align
