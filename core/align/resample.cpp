// SPDX-License-Identifier: GPL-3.0-or-later
#include "resample.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::align {

namespace {

/// The source pixels that make one pixel of the result.
struct Taps {
    int first = 0;
    std::vector<float> weights;
};

double catmullRom(double t) {
    t = std::abs(t);
    if (t >= 2) {
        return 0;
    }
    return t < 1 ? (1.5 * t - 2.5) * t * t + 1 : ((-0.5 * t + 2.5) * t - 4) * t + 2;
}

Taps taps(const SourcePlace& place) {
    const double extent = std::max(1.0, place.extent);
    Taps result;
    result.first = static_cast<int>(std::ceil(place.position - 2 * extent));
    const int last = static_cast<int>(std::floor(place.position + 2 * extent));
    double sum = 0;
    for (int i = result.first; i <= last; ++i) {
        const double weight = catmullRom((i - place.position) / extent);
        result.weights.push_back(static_cast<float>(weight));
        sum += weight;
    }
    for (float& weight : result.weights) {
        weight = static_cast<float>(weight / sum);
    }
    return result;
}

void addScaled(const std::uint8_t* source, float weight, float* sum, int count) {
    for (int x = 0; x < count; ++x) {
        sum[x] += weight * static_cast<float>(source[x]);
    }
}

std::uint8_t toByte(float value) {
    return static_cast<std::uint8_t>(std::clamp(value + 0.5F, 0.0F, 255.0F));
}

} // namespace

GreyImage grey(const RgbImage& picture) {
    GreyImage result(picture.width(), picture.height());
    const std::uint8_t* from = picture.values().data();
    std::uint8_t* to = result.values().data();
    const std::size_t count = result.values().size();
    for (std::size_t i = 0; i < count; ++i) {
        to[i] = static_cast<std::uint8_t>(
            (77 * from[3 * i] + 150 * from[3 * i + 1] + 29 * from[3 * i + 2] + 128) >> 8);
    }
    return result;
}

GreyImage resampled(const GreyImage& source, const std::vector<SourcePlace>& columns,
                    const std::vector<SourcePlace>& rows) {
    const int width = source.width();
    std::vector<Taps> across;
    std::size_t longest = 0;
    for (const SourcePlace& place : columns) {
        across.push_back(taps(place));
        across.back().first = ((across.back().first % width) + width) % width;
        longest = std::max(longest, across.back().weights.size());
    }
    GreyImage result(static_cast<int>(columns.size()), static_cast<int>(rows.size()));
    std::vector<float> line(static_cast<std::size_t>(width) + longest);
    for (int y = 0; y < result.height(); ++y) {
        std::fill(line.begin(), line.end(), 0.0F);
        const Taps down = taps(rows[static_cast<std::size_t>(y)]);
        for (std::size_t i = 0; i < down.weights.size(); ++i) {
            const int row = std::clamp(down.first + static_cast<int>(i), 0, source.height() - 1);
            addScaled(source.at(0, row), down.weights[i], line.data(), width);
        }
        for (std::size_t i = 0; i < longest; ++i) {
            line[static_cast<std::size_t>(width) + i] = line[i % static_cast<std::size_t>(width)];
        }
        std::uint8_t* out = result.at(0, y);
        for (const Taps& tap : across) {
            const float* at = line.data() + tap.first;
            float sum = 0;
            for (std::size_t i = 0; i < tap.weights.size(); ++i) {
                sum += tap.weights[i] * at[i];
            }
            *out++ = toByte(sum);
        }
    }
    return result;
}

} // namespace spherewalk::align
