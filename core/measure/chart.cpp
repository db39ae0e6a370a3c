// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/measure/chart.h"

#include "spherewalk/base/text.h"

#include <array>
#include <cmath>

namespace spherewalk::measure {

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

} // namespace spherewalk::measure
