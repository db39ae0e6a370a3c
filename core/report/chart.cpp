// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/report/chart.h"

#include "spherewalk/base/text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spherewalk::report {

namespace {

/// `times` the number `index` of 1, 2, 5, 10, 20 ...; the index may be negative. The result is the double
/// next to that decimal: powers of ten below 1 are divisors, since these are exact.
double roundNumber(int index, double times = 1) {
    constexpr double kMantissas[] = {1, 2, 5};
    const int mantissa = ((index % 3) + 3) % 3;
    const int exponent = (index - mantissa) / 3;
    const double power = std::pow(10, std::abs(exponent));
    return exponent < 0 ? times * kMantissas[mantissa] / power : times * kMantissas[mantissa] * power;
}

/// The greatest such number that is not above the value.
int indexBelow(double value) {
    int index = 3 * static_cast<int>(std::floor(std::log10(value)));
    while (roundNumber(index + 1) <= value * (1 + 1e-9)) {
        ++index;
    }
    return index;
}

using Colour = std::array<double, 3>;

// Source: Brewer, RdYlBu: the ends and the middle.
constexpr Colour kWithin{49, 54, 149};
constexpr Colour kAtTolerance{255, 255, 191};
constexpr Colour kBeyond{165, 0, 38};

std::string hex(const Colour& colour) {
    constexpr const char* kDigits = "0123456789abcdef";
    std::string result = "#";
    for (const double part : colour) {
        const auto byte = static_cast<unsigned>(std::lround(part));
        result += kDigits[byte / 16];
        result += kDigits[byte % 16];
    }
    return result;
}

} // namespace

std::string_view seriesColour(std::size_t index) {
    static constexpr std::array<std::string_view, 8> kColours{"#0072b2", "#e69f00", "#009e73", "#cc79a7",
                                                              "#d55e00", "#56b4e9", "#999999", "#b8a900"};
    return kColours[index % kColours.size()];
}

double Chart::Range::share(double value) const {
    return scale == Scale::Even ? (value - least) / (greatest - least)
                                : std::log(value / least) / std::log(greatest / least);
}

void Chart::title(std::string_view words) {
    m_svg.text({m_frame.x, m_frame.y - 14}, words, Svg::Text::Label);
}

void Chart::xAxis(const std::vector<double>& ticks, Scale scale, std::string_view caption) {
    m_x = {ticks.front(), ticks.back(), scale};
    for (const double tick : ticks) {
        m_svg.line({x(tick), m_frame.y}, {x(tick), bottom()}, Svg::Line::Grid);
        tickText({x(tick), bottom() + 18}, text(tick), SvgAnchor::Middle);
    }
    xCaption(caption);
}

void Chart::xCaption(std::string_view caption) {
    m_svg.text({m_frame.x + m_frame.width / 2, bottom() + 40}, caption, Svg::Text::Label, SvgAnchor::Middle);
}

void Chart::yAxis(const std::vector<double>& ticks, Scale scale, std::string_view caption) {
    m_y = {ticks.front(), ticks.back(), scale};
    for (const double tick : ticks) {
        m_svg.line({m_frame.x, y(tick)}, {m_frame.x + m_frame.width, y(tick)}, Svg::Line::Grid);
        tickText({m_frame.x - 8, y(tick) + 4}, text(tick), SvgAnchor::End);
    }
    m_svg.text({m_frame.x - 46, m_frame.y + m_frame.height / 2}, caption, Svg::Text::Label, SvgAnchor::Middle,
               true);
}

void Chart::axisLines() {
    m_svg.line({m_frame.x, bottom()}, {m_frame.x + m_frame.width, bottom()}, Svg::Line::Axis);
    m_svg.line({m_frame.x, m_frame.y}, {m_frame.x, bottom()}, Svg::Line::Axis);
}

void Chart::tickText(const SvgPoint& at, const std::string& words, SvgAnchor anchor) {
    m_svg.text(at, words, Svg::Text::Small, anchor);
}

std::vector<double> evenTicks(double least, double greatest, int most) {
    int index = indexBelow((greatest - least) / most);
    const auto first = [&] { return std::floor(least / roundNumber(index) + 1e-9); };
    const auto last = [&] { return std::ceil(greatest / roundNumber(index) - 1e-9); };
    while (last() - first() > most) {
        ++index;
    }
    std::vector<double> ticks;
    for (double i = first(); i <= last(); ++i) {
        ticks.push_back(roundNumber(index, i));
    }
    return ticks;
}

std::vector<double> logarithmicTicks(double least, double greatest) {
    std::vector<double> ticks;
    for (int index = indexBelow(least); ticks.size() < 2 || ticks.back() < greatest; ++index) {
        ticks.push_back(roundNumber(index));
    }
    return ticks;
}

std::string errorColour(std::optional<double> errorPx, double tolerancePx) {
    if (!errorPx || !std::isfinite(*errorPx)) {
        return "#b0b0b0";
    }
    const double share = std::clamp(0.5 * std::log2(std::max(*errorPx, 1e-9) / tolerancePx), -1.0, 1.0);
    const Colour& end = share < 0 ? kWithin : kBeyond;
    Colour mixed{};
    for (std::size_t i = 0; i < mixed.size(); ++i) {
        mixed[i] = kAtTolerance[i] + std::abs(share) * (end[i] - kAtTolerance[i]);
    }
    return hex(mixed);
}

} // namespace spherewalk::report
