// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/measure/svg.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::measure {

/// Told apart with any kind of colour vision, and visible on light and dark; from the ninth on they repeat.
/// Source: Okabe and Ito, Color Universal Design.
std::string_view seriesColour(std::size_t index);

enum class Scale { Even, Logarithmic };

/// A frame with its axes; knows where a value is drawn.
class Chart {
  public:
    /// Owner: the drawing must outlive the chart.
    Chart(Svg& svg, const SvgBox& frame) : m_svg(svg), m_frame(frame) {}

    void title(std::string_view words);
    /// From the first tick to the last. Range: at least two ticks, rising; all above 0 if logarithmic.
    void xAxis(const std::vector<double>& ticks, Scale scale, std::string_view caption);
    void yAxis(const std::vector<double>& ticks, Scale scale, std::string_view caption);
    void xCaption(std::string_view caption);
    /// Over the grid.
    void axisLines();
    void tickText(const SvgPoint& at, const std::string& words, SvgAnchor anchor);

    double x(double value) const { return m_frame.x + m_frame.width * m_x.share(value); }

    double y(double value) const { return bottom() - m_frame.height * m_y.share(value); }

    double bottom() const { return m_frame.y + m_frame.height; }

    const SvgBox& frame() const { return m_frame; }

  private:
    struct Range {
        double least = 0;
        double greatest = 1;
        Scale scale = Scale::Even;

        double share(double value) const;
    };

    Svg& m_svg;
    SvgBox m_frame;
    Range m_x;
    Range m_y;
};

} // namespace spherewalk::measure
