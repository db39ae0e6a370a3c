// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict/labelled_photos.h"

#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/practice/practice_room.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace spherewalk::test {

namespace {

constexpr double kPi = std::numbers::pi;

std::uint8_t byteOf(double value) {
    return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
}

RgbImage changed(const RgbImage& picture, const std::function<double(double value, int channel)>& change) {
    RgbImage result = picture;
    int channel = 0;
    for (std::uint8_t& value : result.values()) {
        value = byteOf(change(value, channel));
        channel = (channel + 1) % RgbImage::kChannels;
    }
    return result;
}

/// Weights of a Gaussian out to three sigmas.
std::vector<double> kernel(double sigmaPx) {
    const int reach = static_cast<int>(std::ceil(3 * sigmaPx));
    std::vector<double> weights;
    double sum = 0;
    for (int i = -reach; i <= reach; ++i) {
        weights.push_back(std::exp(-i * i / (2 * sigmaPx * sigmaPx)));
        sum += weights.back();
    }
    for (double& weight : weights) {
        weight /= sum;
    }
    return weights;
}

RgbImage smoothed(const RgbImage& picture, const std::vector<double>& weights, bool alongRows) {
    const int reach = static_cast<int>(weights.size() / 2);
    RgbImage result(picture.width(), picture.height());
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            std::array<double, 3> sum{};
            for (int i = -reach; i <= reach; ++i) {
                const int u = alongRows ? (x + i + picture.width()) % picture.width() : x;
                const int v = alongRows ? y : std::clamp(y + i, 0, picture.height() - 1);
                for (std::size_t c = 0; c < 3; ++c) {
                    sum[c] += weights[static_cast<std::size_t>(i + reach)] * picture.at(u, v)[c];
                }
            }
            std::transform(sum.begin(), sum.end(), result.at(x, y), byteOf);
        }
    }
    return result;
}

/// The pixels within so many degrees of a direction on the horizon get one value.
RgbImage flooded(const RgbImage& picture, double degrees, std::uint8_t value) {
    RgbImage result = picture;
    const EquirectSize size{picture.width(), picture.height()};
    const Eigen::Vector3d middle(0, 1, 0);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if (direction(size, Eigen::Vector2d(x, y)).dot(middle) > std::cos(degrees * kPi / 180)) {
                std::fill_n(result.at(x, y), 3, value);
            }
        }
    }
    return result;
}

} // namespace

std::vector<PlacedPicture> practicePhotos(int columns, int rows, double stepM, int width, bool anyYaw,
                                          Random& random) {
    const practice::PracticeRoom room;
    std::vector<PlacedPicture> photos;
    for (int i = 0; i < columns; ++i) {
        for (int j = 0; j < rows; ++j) {
            const Eigen::Vector3d at(1.4 + stepM * i, 1.3 + stepM * j, 1.2);
            const YawPitchRoll turn{Radians(anyYaw ? random.uniform(-kPi, kPi) : random.uniform(-0.05, 0.05)),
                                    Degrees(random.uniform(-0.7, 0.7)), Degrees(random.uniform(-0.7, 0.7))};
            photos.push_back({room.spherical({rotation(turn), at}, {width, width / 2}), at});
        }
    }
    return photos;
}

RgbImage blurred(const RgbImage& picture, double sigmaPx, bool alongRowsOnly) {
    const std::vector<double> weights = kernel(sigmaPx);
    const RgbImage once = smoothed(picture, weights, true);
    return alongRowsOnly ? once : smoothed(once, weights, false);
}

RgbImage exposed(const RgbImage& picture, double stops) {
    const double gain = std::exp2(stops / 2.2);
    return changed(picture, [&](double value, int /*channel*/) { return value * gain; });
}

RgbImage tinted(const RgbImage& picture, double red, double blue) {
    return changed(picture, [&](double value, int channel) {
        return value * (channel == 0 ? red : channel == 2 ? blue : 1);
    });
}

RgbImage upsideDown(const RgbImage& picture) {
    RgbImage result(picture.width(), picture.height());
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            std::copy_n(picture.at(x, y), 3, result.at(picture.width() - 1 - x, picture.height() - 1 - y));
        }
    }
    return result;
}

RgbImage withPerson(const RgbImage& picture, double distanceM, Random& random) {
    constexpr std::array<std::array<double, 3>, 7> kClothes{{{40, 45, 80},
                                                             {25, 25, 28},
                                                             {120, 120, 125},
                                                             {170, 40, 40},
                                                             {215, 210, 200},
                                                             {50, 90, 60},
                                                             {90, 120, 180}}};
    const auto clothes = [&] {
        return kClothes[static_cast<std::size_t>(random.integer(0, kClothes.size() - 1))];
    };
    const std::array<double, 3> shirt = clothes();
    const std::array<double, 3> trousers = clothes();
    const double middle = random.uniform(-kPi, kPi);
    const double height = random.uniform(1.6, 1.85);
    RgbImage result = picture;
    const EquirectSize size{picture.width(), picture.height()};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const SphericalDirection at = sphericalDirection(direction(size, Eigen::Vector2d(x, y)));
            const double across = std::remainder(at.azimuth.value() - middle, 2 * kPi) * distanceM;
            const double up = 1.2 + distanceM * std::tan(at.elevation.value());
            const double headUp = height - 0.12;
            const bool isHead = std::hypot(across / 0.085, (up - headUp) / 0.12) < 1;
            const bool isShirt = up > 0.85 && up < height - 0.25 && std::abs(across) < 0.24;
            const bool isTrousers =
                up > 0 && up <= 0.85 && std::abs(across) < 0.17 && std::abs(across) > 0.015;
            if (!isHead && !isShirt && !isTrousers) {
                continue;
            }
            constexpr std::array<double, 3> kSkin{205, 160, 135};
            const auto& colour = isHead ? kSkin : isShirt ? shirt : trousers;
            const double shade =
                1 - 1.6 * std::abs(across) + 0.06 * std::sin(40 * up) * std::sin(30 * across);
            for (std::size_t c = 0; c < 3; ++c) {
                result.at(x, y)[c] = byteOf(colour[c] * shade);
            }
        }
    }
    return result;
}

RgbImage halfBlack(const RgbImage& picture) {
    return flooded(picture, 85, 2);
}

RgbImage halfBurnt(const RgbImage& picture) {
    return flooded(picture, 40, 255);
}

RgbImage ordinary(const RgbImage& picture, Random& random) {
    const int shift = random.integer(0, picture.width() - 1);
    const double gain = random.uniform(0.98, 1.02);
    RgbImage result(picture.width(), picture.height());
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const std::uint8_t* from = picture.at((x + shift) % picture.width(), y);
            std::transform(from, from + 3, result.at(x, y),
                           [&](std::uint8_t value) { return byteOf(value * gain + random.uniform(-3, 3)); });
        }
    }
    return result;
}

} // namespace spherewalk::test
