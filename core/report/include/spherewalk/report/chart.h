// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/report/svg.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::report {

/// A colour for each series, as SVG and CSS take it. The colours differ with any kind of colour vision, and
/// are visible on light and dark paper. They repeat from the ninth series on. Source: Okabe and Ito, Color
/// Universal Design.
std::string_view seriesColour(std::size_t index);

/// The colour of an error beside a tolerance, as SVG and CSS take it: blue well within, light yellow at the
/// tolerance, red well beyond, grey for an unknown error. The scale ends at a quarter of the tolerance and at
/// four times the tolerance. The colours differ with any kind of colour vision.
std::string errorColour(std::optional<double> errorPx, double tolerancePx);

/// The errors that a legend of these colours shows. Units: tolerances.
inline constexpr std::array<double, 5> kErrorSteps{0.25, 0.5, 1, 2, 4};

/// Round numbers from at or below `least` to at or beyond `greatest`. They are 1, 2 or 5 times a power of ten
/// apart, with at most `most` steps. Range: least < greatest.
std::vector<double> evenTicks(double least, double greatest, int most);

/// Round numbers for a logarithmic axis: 1, 2 and 5 times powers of ten, from at or below `least` to at or
/// beyond `greatest`, at least two. Range: 0 < least <= greatest.
std::vector<double> logarithmicTicks(double least, double greatest);

enum class Scale { Even, Logarithmic };

/// A frame with axes in a drawing. The chart tells where in the drawing a value lies.
class Chart {
  public:
    /// Owner: the drawing must outlive the chart.
    Chart(Svg& svg, const SvgBox& frame) : m_svg(svg), m_frame(frame) {}

    void title(std::string_view words);
    /// Draws the grid and the ticks' numbers; the axis reaches from the first tick to the last. Range: at
    /// least two ticks, rising; all above 0 if logarithmic.
    void xAxis(const std::vector<double>& ticks, Scale scale, std::string_view caption);
    void yAxis(const std::vector<double>& ticks, Scale scale, std::string_view caption);
    void xCaption(std::string_view caption);
    /// Draws the lines of both axes over the grid.
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

} // namespace spherewalk::report
