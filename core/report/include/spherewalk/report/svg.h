// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::measure {

/// In pixels of the picture, y downwards.
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

/// A drawing that follows the reader's light or dark scheme where the viewer knows it, and is light
/// elsewhere.
class Svg {
  public:
    /// What a line or a text is for decides how it looks.
    enum class Line { Axis, Grid, Mark, Dashed };
    enum class Text { Title, Label, Small };

    /// title: read out by screen readers.
    Svg(int width, int height, std::string_view title);

    /// colour: "" for that of the lines of this kind.
    void line(const SvgPoint& from, const SvgPoint& to, Line kind, std::string_view colour = {});
    void rectangle(const SvgBox& box, std::string_view colour);
    void circle(const SvgPoint& centre, double radius, std::string_view colour);
    /// Filled with the colour, "" for no filling; line: of its edge.
    void polygon(const std::vector<SvgPoint>& corners, std::string_view colour,
                 std::optional<Line> line = std::nullopt);
    /// From point to point.
    void path(const std::vector<SvgPoint>& points, Line kind, std::string_view colour = {});
    /// turned: by a quarter to the left.
    void text(const SvgPoint& at, std::string_view words, Text kind, SvgAnchor anchor = SvgAnchor::Start,
              bool turned = false);

    /// About as much as a text of this kind covers that begins at the point.
    static SvgBox extent(const SvgPoint& at, std::string_view words, Text kind);

    std::string str() const { return m_text + "</svg>\n"; }

  private:
    std::string m_text;
};

/// The words as XML and HTML take them.
std::string escaped(std::string_view words);

} // namespace spherewalk::measure
