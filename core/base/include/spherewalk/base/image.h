// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace spherewalk {

/// A picture whose pixels have `Channels` values each. Rows follow each other from the top, without padding.
/// Owner: the image owns its values.
template <class Value, int Channels>
class Image {
  public:
    static constexpr int kChannels = Channels;

    Image() = default;

    /// A picture whose values are all zero. Range: width and height >= 0.
    Image(int width, int height)
        : m_width(width),
          m_height(height),
          m_values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * Channels) {}

    int width() const { return m_width; }

    int height() const { return m_height; }

    bool empty() const { return m_values.empty(); }

    /// The first value of pixel (x, y). Range: 0 <= x < width, 0 <= y < height, not checked.
    Value* at(int x, int y) { return m_values.data() + offset(x, y); }

    const Value* at(int x, int y) const { return m_values.data() + offset(x, y); }

    /// The width * Channels values of row y.
    std::span<Value> row(int y) { return {at(0, y), static_cast<std::size_t>(m_width) * Channels}; }

    std::span<const Value> row(int y) const {
        return {at(0, y), static_cast<std::size_t>(m_width) * Channels};
    }

    /// All height * width * Channels values.
    std::span<Value> values() { return m_values; }

    std::span<const Value> values() const { return m_values; }

    bool operator==(const Image&) const = default;

  private:
    std::size_t offset(int x, int y) const {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) +
                static_cast<std::size_t>(x)) *
               Channels;
    }

    int m_width = 0;
    int m_height = 0;
    std::vector<Value> m_values;
};

/// The nearest whole number. Range: 0 to 16 million. Loops with std::lround() take longer.
inline int nearestInt(float value) {
    constexpr float kHalf = 0.5F;
    return static_cast<int>(value + kHalf);
}

/// 8-bit red, green, blue.
using RgbImage = Image<std::uint8_t, 3>;
/// 8-bit red, green, blue, alpha. Each user says whether the colours are multiplied by alpha.
using RgbaImage = Image<std::uint8_t, 4>;
/// One byte a pixel: the covered share of the pixel (255: all of it), or flags.
using MaskImage = Image<std::uint8_t, 1>;
/// Distances in metres; +infinity where there is nothing. Each user says whether they are along the ray or
/// along the camera's axis.
using DepthImage = Image<float, 1>;

} // namespace spherewalk
