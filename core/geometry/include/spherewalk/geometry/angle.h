// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <compare>
#include <numbers>

namespace spherewalk {

class Degrees;

/// An angle in radians. Plain numbers convert only explicitly, so that no degree is taken for a radian.
class Radians {
  public:
    constexpr Radians() = default;

    constexpr explicit Radians(double value) : m_value(value) {}

    constexpr Radians(Degrees degrees); // NOLINT(google-explicit-constructor): both know their unit

    constexpr double value() const { return m_value; }

    constexpr Radians operator-() const { return Radians(-m_value); }

    constexpr Radians operator+(Radians other) const { return Radians(m_value + other.m_value); }

    constexpr Radians operator-(Radians other) const { return Radians(m_value - other.m_value); }

    constexpr Radians operator*(double factor) const { return Radians(m_value * factor); }

    constexpr auto operator<=>(const Radians&) const = default;

  private:
    double m_value = 0;
};

/// An angle in degrees, for texts that people read and write. It converts to and from Radians by itself.
class Degrees {
  public:
    constexpr Degrees() = default;

    constexpr explicit Degrees(double value) : m_value(value) {}

    constexpr Degrees(Radians radians) // NOLINT(google-explicit-constructor): both know their unit
        : m_value(radians.value() * (180 / std::numbers::pi)) {}

    constexpr double value() const { return m_value; }

    constexpr auto operator<=>(const Degrees&) const = default;

  private:
    double m_value = 0;
};

constexpr Radians::Radians(Degrees degrees) : m_value(degrees.value() * (std::numbers::pi / 180)) {
}

inline double sin(Radians angle) {
    return std::sin(angle.value());
}

inline double cos(Radians angle) {
    return std::cos(angle.value());
}

inline double tan(Radians angle) {
    return std::tan(angle.value());
}

/// The same direction as an angle in (-pi, pi]. NaN stays NaN.
inline Radians wrapped(Radians angle) {
    // remainder() is exact and gives [-pi, pi].
    const double rest = std::remainder(angle.value(), 2 * std::numbers::pi);
    return Radians(rest <= -std::numbers::pi ? std::numbers::pi : rest);
}

} // namespace spherewalk
