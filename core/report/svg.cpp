// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/report/svg.h"

#include "spherewalk/base/text.h"

#include <array>

namespace spherewalk::report {

namespace {

constexpr std::string_view kSvgStyle = R"(<style>
text { font-family: "DejaVu Sans", Verdana, Arial, sans-serif; fill: #222 }
.title { font-size: 15px; font-weight: bold }
.label { font-size: 13px; paint-order: stroke; stroke: #fff; stroke-width: 3px }
.small { font-size: 12px; fill: #555 }
.paper { fill: #fff }
.axis { stroke: #222; stroke-width: 1.2 }
.grid { stroke: #ddd; stroke-width: 1 }
.mark { stroke-width: 2 }
.dashed { stroke: #777; stroke-width: 1.5; stroke-dasharray: 5 4 }
@media (prefers-color-scheme: dark) {
text { fill: #e6e6e6 } .small { fill: #b0b0b0 } .paper { fill: #1b1d20 }
.axis { stroke: #e6e6e6 } .grid { stroke: #3a3d42 } .dashed { stroke: #999 }
.label { stroke: #1b1d20 }
}
</style>
)";

constexpr std::array<std::string_view, 4> kLineClasses{"axis", "grid", "mark", "dashed"};
constexpr std::array<std::string_view, 3> kTextClasses{"title", "label", "small"};
constexpr std::array<double, 3> kTextSizes{15, 13, 12};
constexpr std::array<std::string_view, 3> kAnchors{"start", "middle", "end"};
constexpr double kWidthOfLetter = 0.62; // of the font's size, in a wide font

template <class Kind, std::size_t Count>
std::string_view nameOf(const std::array<std::string_view, Count>& names, Kind kind) {
    return names[static_cast<std::size_t>(kind)];
}

std::string number(double value) {
    return fixed(value, 1);
}

std::string pointsText(const std::vector<SvgPoint>& points) {
    std::string result;
    for (const SvgPoint& point : points) {
        result += text(result.empty() ? "" : " ", number(point.x), ",", number(point.y));
    }
    return result;
}

std::string attribute(std::string_view name, std::string_view value) {
    return value.empty() ? "" : text(" ", name, "=\"", value, "\"");
}

} // namespace

std::string escaped(std::string_view words) {
    std::string result;
    for (const char letter : words) {
        result += letter == '<'   ? "&lt;"
                  : letter == '>' ? "&gt;"
                  : letter == '&' ? "&amp;"
                  : letter == '"' ? "&quot;"
                                  : std::string(1, letter);
    }
    return result;
}

Svg::Svg(int width, int height, std::string_view title) {
    m_text = spherewalk::text("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"", width, "\" height=\"",
                              height, "\" viewBox=\"0 0 ", width, " ", height, "\" role=\"img\">\n<title>",
                              escaped(title), "</title>\n", kSvgStyle,
                              "<rect class=\"paper\" width=\"100%\" height=\"100%\" rx=\"8\"/>\n");
}

void Svg::line(const SvgPoint& from, const SvgPoint& to, Line kind, std::string_view colour) {
    m_text += spherewalk::text("<line", attribute("class", nameOf(kLineClasses, kind)),
                               attribute("x1", number(from.x)), attribute("y1", number(from.y)),
                               attribute("x2", number(to.x)), attribute("y2", number(to.y)),
                               attribute("stroke", colour), "/>\n");
}

void Svg::rectangle(const SvgBox& box, std::string_view colour) {
    m_text += spherewalk::text("<rect", attribute("x", number(box.x)), attribute("y", number(box.y)),
                               attribute("width", number(box.width)), attribute("height", number(box.height)),
                               attribute("fill", colour), "/>\n");
}

void Svg::circle(const SvgPoint& centre, double radius, std::string_view colour) {
    m_text +=
        spherewalk::text("<circle", attribute("cx", number(centre.x)), attribute("cy", number(centre.y)),
                         attribute("r", number(radius)), attribute("fill", colour), "/>\n");
}

void Svg::polygon(const std::vector<SvgPoint>& corners, std::string_view colour, std::optional<Line> line) {
    m_text += spherewalk::text("<polygon", attribute("class", line ? nameOf(kLineClasses, *line) : ""),
                               attribute("points", pointsText(corners)),
                               attribute("fill", colour.empty() ? "none" : colour), "/>\n");
}

void Svg::path(const std::vector<SvgPoint>& points, Line kind, std::string_view colour) {
    m_text += spherewalk::text("<polyline", attribute("class", nameOf(kLineClasses, kind)),
                               attribute("points", pointsText(points)), attribute("stroke", colour),
                               " fill=\"none\"/>\n");
}

void Svg::text(const SvgPoint& at, std::string_view words, Text kind, SvgAnchor anchor, bool turned) {
    const std::string place = spherewalk::text(number(at.x), " ", number(at.y));
    m_text += spherewalk::text(
        "<text", attribute("class", nameOf(kTextClasses, kind)), attribute("x", number(at.x)),
        attribute("y", number(at.y)), attribute("text-anchor", nameOf(kAnchors, anchor)),
        attribute("transform", turned ? spherewalk::text("rotate(-90 ", place, ")") : ""), ">",
        escaped(words), "</text>\n");
}

SvgBox Svg::extent(const SvgPoint& at, std::string_view words, Text kind) {
    const double size = kTextSizes[static_cast<std::size_t>(kind)];
    return {at.x, at.y - size, kWidthOfLetter * size * static_cast<double>(words.size()), 1.25 * size};
}

} // namespace spherewalk::report
