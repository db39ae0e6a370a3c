// SPDX-License-Identifier: GPL-3.0-or-later
/// How well faces are found: spherewalk_face_figures [PHOTO...]. Portraits that Debian's packages
/// python3-skimage and python-matplotlib-data hold hang life-size in photos of practice rooms, 1 to 3 m away,
/// each facing the camera and turned by up to 45 degrees about the vertical. Then faces are looked for in
/// rooms without people: practice rooms, and the photos that are named.
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/face_search.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/practice/practice_room.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <functional>
#include <iostream>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace spherewalk::campaign {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kWidth = 5376;
constexpr EquirectSize kSearched{kWidth, kWidth / 2};
constexpr double kFaceM = 0.22; ///< From the chin to the hair.

/// A portrait, and where its face is: the middle, and the distance from chin to hair. Units: pixels.
struct Portrait {
    const char* file;
    Vector2d face;
    double facePx;
};

const std::array kPortraits{
    Portrait{"/usr/lib/python3/dist-packages/skimage/data/astronaut.png", {224, 130}, 116},
    Portrait{"/usr/share/matplotlib/mpl-data/sample_data/grace_hopper.jpg", {265, 237}, 205},
};

/// Where a portrait hangs. turn: about the vertical, from facing the camera.
struct Place {
    SphericalDirection towards;
    double distanceM = 0;
    Radians turn;
};

RgbImage roomPhoto(practice::RoomStyle style, const Vector3d& place) {
    practice::PracticeRoomOptions options;
    options.style = style;
    if (style == practice::RoomStyle::Flat) {
        options.sizeM = {9, 7, 2.6};
    }
    const RgbImage half = practice::PracticeRoom(options).spherical({Eigen::Quaterniond::Identity(), place},
                                                                    {kWidth / 2, kWidth / 4});
    return photo::resized(half, kWidth, kWidth / 2);
}

/// The portrait at the size of the photo's pixels, so that none of its detail aliases.
RgbImage reduced(const RgbImage& portrait, double scale) {
    return scale < 1 ? photo::resized(portrait, static_cast<int>(std::lround(portrait.width() * scale)),
                                      static_cast<int>(std::lround(portrait.height() * scale)))
                     : portrait;
}

std::uint8_t between(const RgbImage& picture, const Vector2d& at, int channel) {
    const int x = static_cast<int>(at.x());
    const int y = static_cast<int>(at.y());
    const double u = at.x() - x;
    const double v = at.y() - y;
    const double value =
        (1 - v) * ((1 - u) * picture.at(x, y)[channel] + u * picture.at(x + 1, y)[channel]) +
        v * ((1 - u) * picture.at(x, y + 1)[channel] + u * picture.at(x + 1, y + 1)[channel]);
    return static_cast<std::uint8_t>(std::lround(value));
}

void hang(const Portrait& portrait, const RgbImage& whole, const Place& place, RgbImage& photo) {
    const double pixelsPerM = portrait.facePx / kFaceM;
    const double photoPxPerM = photo.width() / (2 * std::numbers::pi * place.distanceM);
    const double scale = std::min(1.0, photoPxPerM / pixelsPerM);
    const RgbImage picture = reduced(whole, scale);
    const double azimuth = place.towards.azimuth.value();
    const Vector3d middle = place.distanceM * direction(place.towards);
    const Vector3d right = cos(place.turn) * Vector3d(std::sin(azimuth), -std::cos(azimuth), 0) -
                           sin(place.turn) * Vector3d(std::cos(azimuth), std::sin(azimuth), 0);
    const Vector3d normal = right.cross(Vector3d::UnitZ());
    for (int y = 0; y < photo.height(); ++y) {
        for (int x = 0; x < photo.width(); ++x) {
            const Vector3d ray = direction(kSearched, Vector2d(x, y));
            const double along = middle.dot(normal) / ray.dot(normal);
            if (!(along > 0) || !std::isfinite(along)) {
                continue;
            }
            const Vector3d aside = along * ray - middle;
            const Vector2d at = scale * (portrait.face + pixelsPerM * Vector2d(aside.dot(right), -aside.z()));
            if (at.x() >= 0 && at.y() >= 0 && at.x() < picture.width() - 1 && at.y() < picture.height() - 1) {
                for (int channel = 0; channel < RgbImage::kChannels; ++channel) {
                    photo.at(x, y)[channel] = between(picture, at, channel);
                }
            }
        }
    }
}

struct Tally {
    int shown = 0;
    int found = 0;
};

/// Whether a region holds the face's middle and most of its height.
bool isFound(const std::vector<survey::PrivateRegion>& regions, const Place& place) {
    return std::ranges::any_of(regions, [&](const survey::PrivateRegion& region) {
        const survey::RegionFrame frame(region);
        SphericalDirection chin = place.towards;
        SphericalDirection hair = place.towards;
        const Radians quarter(kFaceM / place.distanceM / 4);
        chin.elevation = chin.elevation - quarter;
        hair.elevation = hair.elevation + quarter;
        return frame.contains(direction(place.towards)) && frame.contains(direction(chin)) &&
               frame.contains(direction(hair));
    });
}

void countPortraits(const photo::FaceSearch& search) {
    constexpr std::array kDistancesM{1.0, 1.5, 2.0, 3.0};
    constexpr std::array kTurnsDeg{-45.0, -22.0, 0.0, 22.0, 45.0};
    std::mt19937 random(7);
    const std::array<RgbImage, 3> rooms{roomPhoto(practice::RoomStyle::Lively, {2.6, 2.1, 1.4}),
                                        roomPhoto(practice::RoomStyle::Bare, {2.6, 2.1, 1.4}),
                                        roomPhoto(practice::RoomStyle::Flat, {2.0, 2.0, 1.4})};
    std::array<Tally, kDistancesM.size()> byDistance;
    for (const Portrait& portrait : kPortraits) {
        if (!std::filesystem::exists(portrait.file)) {
            std::cout << "There is no " << portrait.file << "; it is left out.\n";
            continue;
        }
        const RgbImage whole = photo::readPicture(portrait.file);
        for (std::size_t d = 0; d < kDistancesM.size(); ++d) {
            for (const double turnDeg : kTurnsDeg) {
                RgbImage photo = rooms[random() % rooms.size()];
                const Place place{{Degrees(std::uniform_real_distribution<>(-180, 180)(random)),
                                   Degrees(std::uniform_real_distribution<>(-20, 20)(random))},
                                  kDistancesM[d],
                                  Degrees(turnDeg)};
                hang(portrait, whole, place, photo);
                const bool found = isFound(search.faces(photo, 0, {}), place);
                ++byDistance[d].shown;
                byDistance[d].found += found ? 1 : 0;
                if (!found) {
                    std::cout << "Missed " << std::filesystem::path(portrait.file).filename().string()
                              << " at " << kDistancesM[d] << " m, turned by " << turnDeg
                              << " degrees, elevation " << Degrees(place.towards.elevation).value() << "\n";
                }
            }
        }
    }
    for (std::size_t d = 0; d < kDistancesM.size(); ++d) {
        std::cout << kDistancesM[d] << " m: found " << byDistance[d].found << " of " << byDistance[d].shown
                  << std::endl;
    }
}

/// The regions that are found where nobody is, with their count a photo and what a photo takes.
void countFalse(const photo::FaceSearch& search, std::span<const char* const> files) {
    int photos = 0;
    std::size_t regions = 0;
    double cpuS = 0;
    double wallS = 0;
    const auto look = [&](const std::string& name, const std::function<RgbImage()>& picture) {
        const auto begin = std::chrono::steady_clock::now();
        const std::clock_t before = std::clock();
        const RgbImage seen = picture();
        const std::vector<survey::PrivateRegion> found = search.faces(seen, 0, {});
        cpuS += static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
        wallS += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        ++photos;
        regions += found.size();
        for (const survey::PrivateRegion& region : found) {
            std::cout << "In " << name << " a face at " << fixed(Degrees(region.azimuth).value(), 1) << ", "
                      << fixed(Degrees(region.elevation).value(), 1) << ", "
                      << fixed(Degrees(region.width).value(), 1) << " degrees wide" << std::endl;
        }
    };
    const auto say = [&](const char* what) {
        std::cout << what << ": " << regions << " regions in " << photos << " photos, "
                  << fixed(wallS / std::max(photos, 1), 2) << " s and "
                  << fixed(cpuS / std::max(photos, 1), 2) << " s of processors a photo" << std::endl;
        photos = 0;
        regions = 0;
        cpuS = wallS = 0;
    };
    for (const auto style :
         {practice::RoomStyle::Lively, practice::RoomStyle::Bare, practice::RoomStyle::Flat}) {
        for (int i = 0; i < 4; ++i) {
            const RgbImage photo = roomPhoto(style, Vector3d(1.8 + 0.5 * i, 1.9, 1.0 + 0.2 * i));
            look(text("practice room ", static_cast<int>(style)), [&] { return photo; });
        }
    }
    say("Practice rooms");
    for (const char* file : files) {
        const Bytes bytes = readFile(file);
        look(file, [&] {
            const RgbImage picture = jpeg::decode(bytes, file);
            return picture.width() == kWidth ? picture : photo::resized(picture, kWidth, kWidth / 2);
        });
    }
    say("Photos");
}

} // namespace
} // namespace spherewalk::campaign

int main(int argc, char** argv) {
    try {
        const spherewalk::photo::FaceSearch search;
        spherewalk::campaign::countFalse(search, {argv + 1, static_cast<std::size_t>(argc - 1)});
        spherewalk::campaign::countPortraits(search);
        return 0;
    } catch (const spherewalk::Error& error) {
        std::cerr << error.sentence() << "\n";
        return 1;
    }
}
