// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/colour_correction.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::render {

using Eigen::Vector3d;

namespace {

constexpr double kToe = 0.04045; ///< Stored values up to this one are proportional to light.
constexpr double kToeSlope = 12.92;

double curveValue(const ColourCorrection::Curve& curve, double at) {
    const double scaled = std::clamp(at, 0.0, 1.0) * (ColourCorrection::kKnots - 1);
    const int knot = std::min(static_cast<int>(scaled), ColourCorrection::kKnots - 2);
    const double left = curve[static_cast<std::size_t>(knot)];
    const double right = curve[static_cast<std::size_t>(knot) + 1];
    return std::clamp(left + (scaled - knot) * (right - left), 0.0, 1.0);
}

} // namespace

double linearLight(double stored) {
    return stored <= kToe ? stored / kToeSlope : std::pow((stored + 0.055) / 1.055, 2.4);
}

double storedValue(double linear) {
    return linear <= kToe / kToeSlope ? linear * kToeSlope : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double exposedValue(double value, double gain, double rolloff) {
    constexpr double kWhite = 255;
    constexpr double kLeast = 0.01; // with less the curve's corner is within a level
    if (rolloff < kLeast) {
        return std::min(kWhite, gain * value);
    }
    const double power = 1 / rolloff;
    const double share = value / kWhite;
    return gain * value / std::pow(1 - std::pow(share, power) + std::pow(gain * share, power), rolloff);
}

std::array<std::uint8_t, 256> exposedValues(double gain, double rolloff) {
    std::array<std::uint8_t, 256> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = static_cast<std::uint8_t>(exposedValue(static_cast<double>(i), gain, rolloff) + 0.5);
    }
    return values;
}

void expose(RgbImage& picture, const Eigen::Vector3d& gains, double rolloff) {
    const std::array tables = {exposedValues(gains[0], rolloff), exposedValues(gains[1], rolloff),
                               exposedValues(gains[2], rolloff)};
    const std::span<std::uint8_t> values = picture.values();
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = tables[i % 3][values[i]];
    }
}

void ColourCorrection::validate() const {
    if (!(matrix.array().abs() <= kMostMatrix).all()) { // NaN too
        throw Error(ErrorKind::InvalidInput,
                    text("A colour matrix must have entries from ", -kMostMatrix, " to ", kMostMatrix, "."));
    }
    for (const Curve& curve : curves) {
        for (std::size_t i = 0; i < curve.size(); ++i) {
            if (!(curve[i] >= -1 && curve[i] <= 2) || (i > 0 && curve[i] < curve[i - 1])) {
                throw Error(ErrorKind::InvalidInput,
                            "A colour curve must have numbers from -1 to 2, none less than the one before.");
            }
        }
    }
}

Vector3d ColourCorrection::corrected(const Vector3d& stored) const {
    const Vector3d mixed = matrix * stored.unaryExpr(&linearLight);
    Vector3d result;
    for (int c = 0; c < 3; ++c) {
        result[c] =
            curveValue(curves[static_cast<std::size_t>(c)], storedValue(std::clamp(mixed[c], 0.0, 1.0)));
    }
    return result;
}

Json toJson(const ColourCorrection& correction) {
    Json matrix = Json::array();
    for (int row = 0; row < 3; ++row) {
        matrix.push_back({correction.matrix(row, 0), correction.matrix(row, 1), correction.matrix(row, 2)});
    }
    return {{"matrix", matrix}, {"curves", correction.curves}};
}

ColourCorrection parseColourCorrection(const JsonReader& reader) {
    const auto numbers = [](const JsonReader& list, std::size_t count, double* into) {
        if (list.arraySize() != count) {
            list.fail(text("expected ", count, " numbers"));
        }
        for (std::size_t i = 0; i < count; ++i) {
            into[i] = list.element(i).asNumber();
        }
    };
    const auto rowsOf = [&](std::string_view key) {
        JsonReader list = reader.member(key);
        if (list.arraySize() != 3) {
            list.fail("expected three lists, of red, green and blue");
        }
        return list;
    };
    ColourCorrection correction;
    const JsonReader matrix = rowsOf("matrix");
    const JsonReader curves = rowsOf("curves");
    for (std::size_t c = 0; c < 3; ++c) {
        Vector3d row;
        numbers(matrix.element(c), 3, row.data());
        correction.matrix.row(static_cast<Eigen::Index>(c)) = row;
        numbers(curves.element(c), ColourCorrection::kKnots, correction.curves[c].data());
    }
    try {
        correction.validate();
    } catch (const Error& error) {
        reader.fail(error.sentence());
    }
    return correction;
}

// Fixed point makes every machine compute the same. A product has 14 bits of light and 16 of the matrix, 3 of
// these before the point. The sum of three products fills 32 bits.
ColourTables::ColourTables(const ColourCorrection& correction) {
    correction.validate();
    constexpr int kMostLight = (1 << kLightBits) - 1;
    constexpr int kShift = kMatrixBits + kLightBits - kEntryBits;
    for (int from = 0; from < 3; ++from) {
        for (std::size_t value = 0; value < 256; ++value) {
            const auto light = static_cast<std::int32_t>(
                std::lround(kMostLight * linearLight(static_cast<double>(value) / 255)));
            for (int to = 0; to < 3; ++to) {
                const auto factor =
                    static_cast<std::int32_t>(std::lround(correction.matrix(to, from) * (1 << kMatrixBits)));
                m_shares[static_cast<std::size_t>(from)][value][static_cast<std::size_t>(to)] =
                    factor * light + (from == 0 ? 1 << (kShift - 1) : 0); // rounds the sum
            }
        }
    }
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t entry = 0; entry < m_developed[c].size(); ++entry) {
            const double linear = std::min(1.0, 2.0 * static_cast<double>(entry) / kMostLight);
            m_developed[c][entry] = static_cast<std::uint8_t>(
                std::lround(255 * curveValue(correction.curves[c], storedValue(linear))));
        }
    }
}

void ColourTables::apply(RgbImage& picture, const PixelRays& rays, WorkerPool& pool, int threads) const {
    constexpr int kRows = 16; // at a time: a row alone is done sooner than handed out
    constexpr int kShift = kMatrixBits + kLightBits - kEntryBits;
    constexpr std::int32_t kLast = (1 << kEntryBits) - 1;
    const bool seesAll = rays.camera().intrinsics().lens == LensModel::Pinhole;
    pool.run((picture.height() + kRows - 1) / kRows, threads, [&](int part, int) {
        const int end = std::min(picture.height(), (part + 1) * kRows);
        for (int y = part * kRows; y < end; ++y) {
            std::uint8_t* rgb = picture.at(0, y);
            for (int x = 0; x < picture.width(); ++x, rgb += 3) {
                if (!seesAll && rays.ray(x, y).isZero()) {
                    continue;
                }
                const Share& red = m_shares[0][rgb[0]];
                const Share& green = m_shares[1][rgb[1]];
                const Share& blue = m_shares[2][rgb[2]];
                Share entry;
                for (std::size_t c = 0; c < 4; ++c) {
                    entry[c] = std::clamp((red[c] + green[c] + blue[c]) >> kShift, 0, kLast);
                }
                for (std::size_t c = 0; c < 3; ++c) {
                    rgb[c] = m_developed[c][static_cast<std::size_t>(entry[c])];
                }
            }
        }
    });
}

} // namespace spherewalk::render
