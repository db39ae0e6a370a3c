// SPDX-License-Identifier: GPL-3.0-or-later
#include "peopled_survey.h"

#include "photo/exposure.h"

#include "spherewalk/practice/practice_room.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spherewalk::test {

namespace {

using practice::PracticeObject;
using practice::PracticeRoom;
using practice::PracticeRoomOptions;

constexpr double kLensM = 1.2;
constexpr double kPi = std::numbers::pi;

PracticeRoomOptions roomOptions(practice::RoomStyle style) {
    PracticeRoomOptions options;
    options.style = style;
    if (style == practice::RoomStyle::Flat) {
        options.sizeM = {8, 6, 2.6};
    }
    return options;
}

/// The places of a grid that are in free floor, those next to the room's middle first, or with other seeds
/// than 1 those next to any of them.
std::vector<Eigen::Vector3d> places(const PracticeRoom& room, const PeopledOptions& options) {
    constexpr double kFreeM = 0.3;
    const practice::RoomPlan plan = room.plan();
    const Eigen::Vector3d size = room.options().sizeM;
    std::vector<Eigen::Vector3d> all;
    for (double x = 0.5; x <= size.x() - 0.5; x += options.stepM) {
        for (double y = 0.5; y <= size.y() - 0.5; y += options.stepM) {
            const Eigen::Vector2d at(x, y);
            bool isFree = true;
            for (double turn = 0; turn < 2 * kPi && isFree; turn += kPi / 8) {
                const Eigen::Vector2d rim = at + kFreeM * Eigen::Vector2d(std::cos(turn), std::sin(turn));
                isFree = contains(plan.outline, rim) &&
                         std::ranges::none_of(plan.obstacles, [&](const Polygon& obstacle) {
                             return contains(obstacle, rim) || contains(obstacle, at);
                         });
            }
            if (isFree) {
                all.emplace_back(x, y, kLensM);
            }
        }
    }
    Eigen::Vector3d middle(size.x() / 2, size.y() / 2, kLensM);
    if (options.seed != 1) {
        FixedRandom random(options.seed, 1234);
        middle = all[random.below(all.size())];
    } else if (options.room == practice::RoomStyle::Flat) {
        middle = {0.27 * size.x(), 0.6 * size.y(), kLensM};
    }
    std::ranges::stable_sort(all, {}, [&](const auto& at) { return (at - middle).norm(); });
    all.resize(std::min<std::size_t>(all.size(), static_cast<std::size_t>(options.mostPhotos)));
    return all;
}

/// Body, legs and head. scale: 1 for a grown-up, less for children.
std::vector<PracticeObject> body(const Eigen::Vector3d& floorM, double scale, FixedRandom& random) {
    const auto colour = [&] {
        const auto value = [&] { return static_cast<std::uint8_t>(random.uniform(20, 220)); };
        return std::array<std::uint8_t, 3>{value(), value(), value()};
    };
    const Radians yaw(random.uniform(-kPi, kPi));
    const auto up = [&](double z) { return Eigen::Vector3d(floorM.x(), floorM.y(), floorM.z() + scale * z); };
    using Shape = PracticeObject::Shape;
    return {{Shape::Box, up(0.43), scale * Eigen::Vector3d(0.11, 0.17, 0.42), yaw, colour()},
            {Shape::Box, up(1.15), scale * Eigen::Vector3d(0.13, 0.23, 0.3), yaw, colour()},
            {Shape::Sphere, up(1.62), scale * Eigen::Vector3d::Constant(0.12), yaw, {205, 160, 130}}};
}

/// Makes the front lens brighter than the back one. Pictures change from one lens to the other within some
/// degrees.
void brightenFront(double log, RgbImage& picture) {
    constexpr double kSoftness = 8;
    for (int x = 0; x < picture.width(); ++x) {
        const double ahead = -std::cos(2 * kPi * (x + 0.5) / picture.width());
        const double factor = std::exp(0.5 * log * std::tanh(kSoftness * ahead));
        for (int y = 0; y < picture.height(); ++y) {
            for (int c = 0; c < 3; ++c) {
                std::uint8_t& value = picture.at(x, y)[c];
                value = static_cast<std::uint8_t>(std::clamp(std::round(factor * value), 0.0, 255.0));
            }
        }
    }
}

RgbImage photographed(const PracticeRoom& room, const Rigid3& pose, const PeopledOptions& options, int shot) {
    const practice::PhotoFlaws flaws =
        options.isReal ? practice::PhotoFlaws::ofARealCamera(options.seed) : practice::PhotoFlaws();
    const int width = options.width;
    const EquirectSize size{width, width / 2};
    const auto seenFrom = [&](double forwardM) {
        Rigid3 lens = pose;
        lens.translation += pose.rotation * Eigen::Vector3d(forwardM, 0, 0);
        return room.spherical(lens, size);
    };
    RgbImage picture = flaws.lensOffsetM > 0
                           ? practice::stitched(seenFrom(flaws.lensOffsetM), seenFrom(-flaws.lensOffsetM))
                           : seenFrom(0);
    FixedRandom random(options.seed, 777 + static_cast<std::uint64_t>(shot));
    brightenFront(random.normal(options.lensSigma), picture);
    practice::addFlaws(picture, flaws, shot);
    return picture;
}

SeenPerson seen(const PracticeRoom& peopled, const PracticeRoom& room, const Rigid3& pose,
                const Eigen::Vector3d& personM) {
    const EquirectSize size{512, 256};
    const DepthImage with = peopled.sphericalRange(pose, size);
    const DepthImage without = room.sphericalRange(pose, size);
    const DepthImage alone = peopled.sphericalRange(pose, size, {practice::Content::Objects, 0});
    double visible = 0;
    double whole = 0;
    double sphere = 0;
    for (int y = 0; y < size.height; ++y) {
        const double weight = std::cos(kPi / 2 - kPi * (y + 0.5) / size.height);
        for (int x = 0; x < size.width; ++x) {
            sphere += weight;
            visible += *with.at(x, y) < *without.at(x, y) - 1e-3F ? weight : 0;
            whole += std::isfinite(*alone.at(x, y)) ? weight : 0;
        }
    }
    SeenPerson person;
    person.part = visible / sphere;
    person.hiddenShare = whole > 0 ? 1 - visible / whole : 0;
    person.distanceM = (personM - pose.translation).head<2>().norm();
    return person;
}

} // namespace

std::vector<PeopledPhoto> emptySurvey(const PeopledOptions& options) {
    const PracticeRoomOptions plain = roomOptions(options.room);
    const PracticeRoom room(plain);
    practice::PhotoErrors errors;
    errors.tiltSigma = Degrees(options.tiltDeg);
    errors.seed = options.seed;
    std::vector<PeopledPhoto> photos;
    for (const Eigen::Vector3d& at : places(room, options)) {
        const int shot = static_cast<int>(photos.size());
        photos.push_back({{}, errors.truePose(at, shot), at, {}});
        photos.back().picture = photographed(room, photos.back().truth, options, shot);
    }
    return photos;
}

void addPersons(const PeopledOptions& options, std::vector<PeopledPhoto>& photos) {
    const PracticeRoomOptions plain = roomOptions(options.room);
    const PracticeRoom room(plain);
    FixedRandom random(options.seed, 7);
    int shown = 0;
    for (int tries = 0; shown < options.peopled * static_cast<double>(photos.size()) && tries < 400;
         ++tries) {
        const std::size_t home = random.below(photos.size());
        const double direction = random.uniform(-kPi, kPi);
        const double away = random.uniform(0.6, 3.5);
        const double scale = random.uniform(0.65, 1.1);
        Eigen::Vector3d floorM =
            photos[home].nominalM + away * Eigen::Vector3d(std::cos(direction), std::sin(direction), 0);
        floorM.z() = 0;
        const Eigen::Array2d at = floorM.head<2>().array();
        if ((at < 0.3).any() || (at > plain.sizeM.head<2>().array() - 0.3).any()) {
            continue;
        }
        std::vector<std::size_t> group(photos.size());
        for (std::size_t i = 0; i < group.size(); ++i) {
            group[i] = i;
        }
        std::ranges::stable_sort(
            group, {}, [&](std::size_t i) { return (photos[i].nominalM - photos[home].nominalM).norm(); });
        group.resize(random.uniform() < 0.67 ? 1 : 2 + random.below(2));
        if (std::ranges::any_of(group, [&](std::size_t i) {
                return photos[i].person || (photos[i].nominalM - floorM).head<2>().norm() < 0.45;
            })) {
            continue;
        }
        PracticeRoomOptions with = plain;
        with.objects = body(floorM, scale, random);
        const PracticeRoom peopled(with);
        for (const std::size_t i : group) {
            SeenPerson person = seen(peopled, room, photos[i].truth, floorM);
            person.photos = static_cast<int>(group.size());
            photos[i].person = person;
            photos[i].picture = photographed(peopled, photos[i].truth, options, static_cast<int>(i));
            ++shown;
        }
    }
}

} // namespace spherewalk::test
