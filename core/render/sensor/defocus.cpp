// SPDX-License-Identifier: Apache-2.0
#include "sensor/effects.h"

#include "spherewalk/base/error.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::render {

namespace {

constexpr int kClassesAPixel = 2; ///< Diameters are rounded to half a pixel.
constexpr double kMostDiameterPx = 120;
constexpr int kOnePixel = 256; ///< Fixed point along rows.
constexpr int kRowBand = 8;    ///< Rows that a worker takes.

/// A disc, cut into one strip for each row that it touches. A strip is as long as its area: it stands for the
/// part of the disc in the row.
struct Disc {
    int reach = 0;           ///< Rows above and below the middle.
    std::vector<int> widths; ///< Of the strips from -reach to reach, in fixed point.
    double area = 0;         ///< Of all strips, in fixed point.
};

/// The area of the unit disc between x = 0 and this x in [0, 1].
double unitArea(double x) {
    return x * std::sqrt(std::max(0.0, 1 - x * x)) + std::asin(std::min(1.0, x));
}

Disc discOf(double diameter) {
    const double radius = 0.5 * std::max(diameter, 1.0);
    Disc disc;
    disc.reach = static_cast<int>(std::ceil(radius - 0.5));
    const auto areaUpTo = [radius](double y) {
        const double area = radius * radius * unitArea(std::min(1.0, std::abs(y) / radius));
        return y < 0 ? -area : area;
    };
    for (int row = -disc.reach; row <= disc.reach; ++row) {
        disc.widths.push_back(
            static_cast<int>(std::lround(kOnePixel * (areaUpTo(row + 0.5) - areaUpTo(row - 0.5)))));
        disc.area += disc.widths.back();
    }
    return disc;
}

/// Red, green, blue and the number of pixels of one class.
constexpr int kSums = 4;
/// Sums along the rows of the pixels to the left of each border between pixels: width + 1 of them.
using RowSums = Image<std::uint32_t, kSums>;
/// Light, and the weight that it comes with.
using Scattered = Image<double, kSums>;

RowSums rowSums(const LightImage& light, const MaskImage& classes, int wanted, WorkerPool& pool,
                int threads) {
    RowSums sums(light.width() + 1, light.height());
    pool.run((light.height() + kRowBand - 1) / kRowBand, threads, [&](int band, int) {
        for (int y = band * kRowBand; y < std::min(light.height(), (band + 1) * kRowBand); ++y) {
            for (int x = 0; x < light.width(); ++x) {
                const bool isOf = *classes.at(x, y) == wanted;
                const std::uint16_t* from = light.at(x, y);
                const std::uint32_t* left = sums.at(x, y);
                std::uint32_t* right = sums.at(x + 1, y);
                for (int c = 0; c < 3; ++c) {
                    right[c] = left[c] + (isOf ? from[c] : 0U);
                }
                right[3] = left[3] + (isOf ? 1U : 0U);
            }
        }
    });
    return sums;
}

/// The sum to the left of a place in fixed point. The picture goes on evenly beyond its sides.
std::int64_t sumLeftOf(const RowSums& sums, int place, int y, int value) {
    const int last = sums.width() - 2;
    const int pixel = std::clamp(place >= 0 ? place / kOnePixel : -1, 0, last);
    const std::int64_t left = sums.at(pixel, y)[value];
    const std::int64_t right = sums.at(pixel + 1, y)[value];
    return left * kOnePixel + (right - left) * (place - pixel * kOnePixel);
}

void scatter(const RowSums& sums, const Disc& disc, WorkerPool& pool, int threads, Scattered& onto) {
    pool.run((onto.height() + kRowBand - 1) / kRowBand, threads, [&](int band, int) {
        for (int y = band * kRowBand; y < std::min(onto.height(), (band + 1) * kRowBand); ++y) {
            for (int strip = -disc.reach; strip <= disc.reach; ++strip) {
                const int from = std::clamp(y + strip, 0, onto.height() - 1);
                const int width = disc.widths[static_cast<std::size_t>(strip + disc.reach)];
                if (*std::max_element(sums.at(onto.width(), from), sums.at(onto.width(), from) + kSums) ==
                    0) {
                    continue;
                }
                for (int x = 0; x < onto.width(); ++x) {
                    const int begin = x * kOnePixel + (kOnePixel - width) / 2;
                    double* to = onto.at(x, y);
                    for (int c = 0; c < kSums; ++c) {
                        const std::int64_t sum =
                            sumLeftOf(sums, begin + width, from, c) - sumLeftOf(sums, begin, from, c);
                        to[c] += static_cast<double>(sum) / disc.area;
                    }
                }
            }
        }
    });
}

} // namespace

MaskImage Defocus::classes(const LightImage& light, const DepthImage& depth) const {
    MaskImage classes(light.width(), light.height());
    const double pxPerDioptre = m_focalPx * m_model.apertureMm / 1000;
    if (pxPerDioptre > 0 && (depth.width() != light.width() || depth.height() != light.height())) {
        throw Error(ErrorKind::InvalidInput,
                    "A sensor with an aperture needs the view's depth, and a scene model that knows it.");
    }
    for (int y = 0; y < light.height(); ++y) {
        for (int x = 0; x < light.width(); ++x) {
            double diameter = m_model.diameterPx;
            if (pxPerDioptre > 0) {
                const double z = static_cast<double>(*depth.at(x, y));
                const double dioptre = std::isfinite(z) && z > 0 ? 1 / z : 0;
                diameter += pxPerDioptre * std::abs(1 / m_model.focusM - dioptre);
            }
            *classes.at(x, y) = static_cast<std::uint8_t>(
                static_cast<int>(std::min(diameter, kMostDiameterPx) * kClassesAPixel + 0.5));
        }
    }
    return classes;
}

void Defocus::apply(LightImage& light, const DepthImage& depth, WorkerPool& pool, int threads) const {
    const MaskImage classes = this->classes(light, depth);
    std::array<bool, 256> isUsed{};
    for (const std::uint8_t value : classes.values()) {
        isUsed[value] = true;
    }
    Scattered onto(light.width(), light.height());
    for (int wanted = 0; wanted < 256; ++wanted) {
        if (isUsed[static_cast<std::size_t>(wanted)]) {
            const Disc disc = discOf(static_cast<double>(wanted) / kClassesAPixel);
            scatter(rowSums(light, classes, wanted, pool, threads), disc, pool, threads, onto);
        }
    }
    for (int y = 0; y < light.height(); ++y) {
        for (int x = 0; x < light.width(); ++x) {
            const double* from = onto.at(x, y);
            for (int c = 0; c < 3; ++c) {
                light.at(x, y)[c] = static_cast<std::uint16_t>(from[c] / from[3] + 0.5);
            }
        }
    }
}

} // namespace spherewalk::render
