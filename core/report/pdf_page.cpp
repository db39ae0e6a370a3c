// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdf_page.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"

#include <cairo-pdf.h>
#include <librsvg/rsvg.h>
#include <numbers>
#include <utility>

namespace spherewalk::report {

using Eigen::Vector2d;

namespace {

constexpr double kPointsAMm = 72 / 25.4;
constexpr int kJpegQuality = 88;

cairo_status_t append(void* closure, const unsigned char* data, unsigned int length) {
    auto& bytes = *static_cast<Bytes*>(closure);
    bytes.insert(bytes.end(), data, data + length);
    return CAIRO_STATUS_SUCCESS;
}

void forgetBytes(void* bytes) {
    delete static_cast<Bytes*>(bytes);
}

/// The SVG as its library knows it.
class SvgHandle {
  public:
    explicit SvgHandle(const std::string& svg) {
        GError* failure = nullptr;
        m_handle.reset(
            rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), svg.size(), &failure));
        check(failure);
    }

    Vector2d size() const {
        gdouble width = 0;
        gdouble height = 0;
        if (rsvg_handle_get_intrinsic_size_in_pixels(m_handle.get(), &width, &height) == 0 || !(width > 0) ||
            !(height > 0)) {
            throw Error(ErrorKind::Internal, "A drawing says nothing of its size.");
        }
        return {width, height};
    }

    void draw(cairo_t* cairo, const RsvgRectangle& place) const {
        GError* failure = nullptr;
        rsvg_handle_render_document(m_handle.get(), cairo, &place, &failure);
        check(failure);
    }

  private:
    static void check(GError* failure) {
        if (failure != nullptr) {
            const std::string why = failure->message;
            g_error_free(failure);
            throw Error(ErrorKind::Internal, text("A drawing could not be put on paper: ", why, "."));
        }
    }

    std::unique_ptr<RsvgHandle, decltype(&g_object_unref)> m_handle{nullptr, &g_object_unref};
};

} // namespace

PdfPages::PdfPages(const Paper& paper)
    : m_paper(paper),
      m_surface(cairo_pdf_surface_create_for_stream(append, &m_bytes, paper.widthMm * kPointsAMm,
                                                    paper.heightMm * kPointsAMm),
                &cairo_surface_destroy),
      m_cairo(cairo_create(m_surface.get()), &cairo_destroy) {
    check();
    // A fixed date: the same plan gives the same file.
    cairo_pdf_surface_set_metadata(m_surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
    cairo_pdf_surface_set_metadata(m_surface.get(), CAIRO_PDF_METADATA_CREATOR, "Spherewalk");
    cairo_scale(m_cairo.get(), kPointsAMm, kPointsAMm);
    cairo_set_line_cap(m_cairo.get(), CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(m_cairo.get(), CAIRO_LINE_JOIN_MITER);
}

PdfPages::~PdfPages() {
    cairo_surface_finish(m_surface.get()); // it writes into m_bytes, which goes before it otherwise
}

void PdfPages::nextPage(const Paper& paper) {
    cairo_show_page(m_cairo.get());
    cairo_pdf_surface_set_size(m_surface.get(), paper.widthMm * kPointsAMm, paper.heightMm * kPointsAMm);
    m_paper = paper;
    check();
}

Bytes PdfPages::finish() {
    cairo_show_page(m_cairo.get());
    cairo_surface_finish(m_surface.get());
    check();
    return std::exchange(m_bytes, {});
}

void PdfPages::check() const {
    for (const cairo_status_t status : {cairo_surface_status(m_surface.get()), cairo_status(m_cairo.get())}) {
        if (status != CAIRO_STATUS_SUCCESS && status != CAIRO_STATUS_SURFACE_FINISHED) {
            throw Error(ErrorKind::Internal,
                        text("The sheet could not be drawn: ", cairo_status_to_string(status), "."));
        }
    }
}

void PdfPages::setGrey(double lightness) {
    cairo_set_source_rgb(m_cairo.get(), lightness, lightness, lightness);
}

void PdfPages::setLine(double widthMm) {
    cairo_set_line_width(m_cairo.get(), widthMm);
}

void PdfPages::line(const Vector2d& from, const Vector2d& to) {
    cairo_move_to(m_cairo.get(), from.x(), from.y());
    cairo_line_to(m_cairo.get(), to.x(), to.y());
    cairo_stroke(m_cairo.get());
}

void PdfPages::path(const Polygon& corners) {
    cairo_new_path(m_cairo.get());
    for (const Vector2d& corner : corners) {
        cairo_line_to(m_cairo.get(), corner.x(), corner.y());
    }
    cairo_close_path(m_cairo.get());
}

void PdfPages::outline(const Polygon& corners) {
    path(corners);
    cairo_stroke(m_cairo.get());
}

void PdfPages::hatched(const Polygon& corners) {
    const Bounds2 box = bounds(corners);
    cairo_save(m_cairo.get());
    path(corners);
    cairo_clip(m_cairo.get());
    constexpr double kSpacingMm = 2;
    const double height = box.greatest.y() - box.least.y();
    for (double x = box.least.x() - height; x < box.greatest.x(); x += kSpacingMm) {
        line({x, box.greatest.y()}, {x + height, box.least.y()});
    }
    cairo_restore(m_cairo.get());
    outline(corners);
}

void PdfPages::filled(std::span<const Polygon> polygons) {
    cairo_new_path(m_cairo.get());
    for (const Polygon& polygon : polygons) {
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            (i == 0 ? cairo_move_to : cairo_line_to)(m_cairo.get(), polygon[i].x(), polygon[i].y());
        }
        cairo_close_path(m_cairo.get());
    }
    cairo_fill(m_cairo.get());
    check();
}

void PdfPages::ring(const Vector2d& centre, double radiusMm) {
    cairo_new_path(m_cairo.get());
    cairo_arc(m_cairo.get(), centre.x(), centre.y(), radiusMm, 0, 2 * std::numbers::pi);
    cairo_stroke(m_cairo.get());
}

void PdfPages::disc(const Vector2d& centre, double radiusMm) {
    cairo_new_path(m_cairo.get());
    cairo_arc(m_cairo.get(), centre.x(), centre.y(), radiusMm, 0, 2 * std::numbers::pi);
    cairo_fill(m_cairo.get());
}

void PdfPages::font(double heightMm, bool isBold) const {
    cairo_select_font_face(m_cairo.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           isBold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(m_cairo.get(), heightMm);
}

double PdfPages::widthOf(const std::string& text, double heightMm, bool isBold) const {
    font(heightMm, isBold);
    cairo_text_extents_t extents;
    cairo_text_extents(m_cairo.get(), text.c_str(), &extents);
    return extents.x_advance;
}

void PdfPages::words(const Vector2d& at, const std::string& text, double heightMm, Align align, bool isBold) {
    const double width = widthOf(text, heightMm, isBold);
    const double left = align == Align::Left ? 0 : align == Align::Centre ? 0.5 * width : width;
    cairo_move_to(m_cairo.get(), at.x() - left, at.y());
    cairo_show_text(m_cairo.get(), text.c_str());
    check();
}

void PdfPages::picture(const Vector2d& at, double widthMm, const RgbImage& picture) {
    const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture.width(), picture.height()),
        &cairo_surface_destroy);
    auto jpeg = std::make_unique<Bytes>(jpeg::encode(picture, kJpegQuality));
    const Bytes& bytes = *jpeg;
    if (cairo_surface_set_mime_data(surface.get(), CAIRO_MIME_TYPE_JPEG, bytes.data(), bytes.size(),
                                    forgetBytes, jpeg.get()) == CAIRO_STATUS_SUCCESS) {
        static_cast<void>(jpeg.release()); // forgetBytes() has it now
    }
    cairo_save(m_cairo.get());
    cairo_translate(m_cairo.get(), at.x(), at.y());
    cairo_scale(m_cairo.get(), widthMm / picture.width(), widthMm / picture.width());
    cairo_set_source_surface(m_cairo.get(), surface.get(), 0, 0);
    cairo_paint(m_cairo.get());
    cairo_restore(m_cairo.get());
    check();
}

Vector2d PdfPages::sizeOf(const std::string& svg) {
    return SvgHandle(svg).size();
}

void PdfPages::drawing(const Vector2d& at, double widthMm, const std::string& svg) {
    const SvgHandle handle(svg);
    const Vector2d size = handle.size();
    cairo_save(m_cairo.get());
    handle.draw(m_cairo.get(), {at.x(), at.y(), widthMm, widthMm * size.y() / size.x()});
    cairo_restore(m_cairo.get());
    check();
}

} // namespace spherewalk::report
