// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::report {

/// A point of a drawing. Units: pixels, y downwards.
struct SvgPoint {
    double x = 0;
    double y = 0;
};

struct SvgBox {
    double x = 0;
    double y = 0;
    double width = 0;
    double height = 0;

    bool overlaps(const SvgBox& other) const {
        return x < other.x + other.width && other.x < x + width && y < other.y + other.height &&
               other.y < y + height;
    }
};

enum class SvgAnchor { Start, Middle, End };

/// A drawing as SVG. It follows the reader's light or dark scheme where the viewer knows it.
class Svg {
  public:
    /// The purpose of a line or a text, which decides how it looks.
    enum class Line { Axis, Grid, Mark, Dashed };
    enum class Text { Title, Label, Small };

    /// title: words that screen readers read out. Units: pixels.
    Svg(int width, int height, std::string_view title);

    /// colour: "" for the usual colour of lines of this kind.
    void line(const SvgPoint& from, const SvgPoint& to, Line kind, std::string_view colour = {});
    void rectangle(const SvgBox& box, std::string_view colour);
    void circle(const SvgPoint& centre, double radius, std::string_view colour);
    /// colour: of the filling, "" for none. line: the kind of the edge, or no edge.
    void polygon(const std::vector<SvgPoint>& corners, std::string_view colour,
                 std::optional<Line> line = std::nullopt);
    /// Draws straight lines from point to point.
    void path(const std::vector<SvgPoint>& points, Line kind, std::string_view colour = {});
    /// at: on the base line. turned: the text runs upwards.
    void text(const SvgPoint& at, std::string_view words, Text kind, SvgAnchor anchor = SvgAnchor::Start,
              bool turned = false);

    /// Roughly the area of a text of this kind that begins at the point.
    static SvgBox extent(const SvgPoint& at, std::string_view words, Text kind);

    /// The whole SVG document.
    std::string str() const { return m_text + "</svg>\n"; }

  private:
    std::string m_text;
};

/// The words with the characters escaped that XML and HTML give a meaning.
std::string escaped(std::string_view words);

} // namespace spherewalk::report
