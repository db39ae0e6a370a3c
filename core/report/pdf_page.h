// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/image.h"
#include "spherewalk/geometry/polygon.h"
#include "spherewalk/report/page_layout.h"

#include <Eigen/Core>

#include <cairo.h>
#include <memory>
#include <span>
#include <string>

namespace spherewalk::report {

enum class Align { Left, Centre, Right };

/// A PDF that is drawn page after page. Units: millimetres from the upper left corner, y down. Errors of all
/// functions: Internal.
class PdfPages {
  public:
    explicit PdfPages(const Paper& paper);
    ~PdfPages();
    PdfPages(const PdfPages&) = delete;
    PdfPages& operator=(const PdfPages&) = delete;

    const Paper& paper() const { return m_paper; }

    /// Ends the present page and begins one of this size.
    void nextPage(const Paper& paper);
    /// Ends the document and returns it.
    Bytes finish();

    void setGrey(double lightness);
    void setLine(double widthMm);
    void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to);
    void outline(const Polygon& corners);
    /// Draws the edge of a hatched area.
    void hatched(const Polygon& corners);
    /// Fills all polygons at once, so that those that touch show no seam.
    void filled(std::span<const Polygon> polygons);
    void ring(const Eigen::Vector2d& centre, double radiusMm);
    void disc(const Eigen::Vector2d& centre, double radiusMm);
    /// at: on the base line.
    void words(const Eigen::Vector2d& at, const std::string& text, double heightMm, Align align = Align::Left,
               bool isBold = false);
    double widthOf(const std::string& text, double heightMm, bool isBold) const;
    /// at: the upper left corner. The height follows from the width. The PDF keeps the picture as a JPEG.
    void picture(const Eigen::Vector2d& at, double widthMm, const RgbImage& picture);
    /// Draws a whole SVG document. at: the upper left corner. The height follows from the width.
    void drawing(const Eigen::Vector2d& at, double widthMm, const std::string& svg);
    /// The size of an SVG document. Units: pixels.
    static Eigen::Vector2d sizeOf(const std::string& svg);

  private:
    void path(const Polygon& corners);
    void font(double heightMm, bool isBold) const;
    void check() const;

    Paper m_paper;
    Bytes m_bytes;
    std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> m_surface;
    std::unique_ptr<cairo_t, decltype(&cairo_destroy)> m_cairo;
};

} // namespace spherewalk::report
