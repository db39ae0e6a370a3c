// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace spherewalk {

/// Pixels of Channels values each, row after row from the top left, without padding. Owner: the image owns
/// them.
template <class Value, int Channels>
class Image {
  public:
    static constexpr int kChannels = Channels;

    Image() = default;

    /// All values zero. Range: width and height >= 0.
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

    /// Shape: width * Channels values of row y.
    std::span<Value> row(int y) { return {at(0, y), static_cast<std::size_t>(m_width) * Channels}; }

    std::span<const Value> row(int y) const {
        return {at(0, y), static_cast<std::size_t>(m_width) * Channels};
    }

    /// Shape: height * width * Channels.
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

/// 8-bit red, green, blue.
using RgbImage = Image<std::uint8_t, 3>;
/// 8-bit red, green, blue, alpha. Whether the colours are multiplied by alpha is said where one is used.
using RgbaImage = Image<std::uint8_t, 4>;
/// One byte a pixel: how much of it something covers (255: all), or flags.
using MaskImage = Image<std::uint8_t, 1>;
/// Distances in metres; +infinity where there is nothing. Whether along the ray or along the axis is said
/// where one is used.
using DepthImage = Image<float, 1>;

} // namespace spherewalk
