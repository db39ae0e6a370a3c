// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/icon.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <QSvgRenderer>

/// The linker keeps the resources of a static library only if they are asked for; in no namespace, as Qt
/// wants it.
static void keepIcons() {
    Q_INIT_RESOURCE(icons);
}

namespace spherewalk::ui {

namespace {

QByteArray svgOf(const QString& name) {
    keepIcons();
    QFile file(":/icons/" + name + ".svg");
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void draw(QByteArray svg, const QColor& colour, QPainter& painter, const QRectF& rect) {
    svg.replace("currentColor", colour.name().toLatin1());
    QSvgRenderer(svg).render(&painter, rect);
}

/// Draws "currentColor" of an SVG in the palette's colour, anew each time, so that dark and light can change.
class LineIcon : public QIconEngine {
  public:
    explicit LineIcon(QByteArray svg) : m_svg(std::move(svg)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
        const QPalette palette = QGuiApplication::palette();
        const QColor colour = mode == QIcon::Disabled
                                  ? palette.color(QPalette::Disabled, QPalette::WindowText)
                              : mode == QIcon::Selected ? palette.color(QPalette::HighlightedText)
                              : state == QIcon::On      ? palette.color(QPalette::Highlight)
                                                        : palette.color(QPalette::WindowText);
        draw(m_svg, colour, *painter, rect);
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap result(size);
        result.fill(Qt::transparent);
        QPainter painter(&result);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return result;
    }

    QIconEngine* clone() const override { return new LineIcon(m_svg); }

  private:
    QByteArray m_svg;
};

} // namespace

QIcon icon(const QString& name) {
    const QByteArray svg = svgOf(name);
    return svg.isEmpty() ? QIcon() : QIcon(new LineIcon(svg));
}

QPixmap colouredIcon(const QString& name, const QColor& colour, int sizePx) {
    const double density = qApp->devicePixelRatio();
    QPixmap result(QSize(sizePx, sizePx) * density);
    result.setDevicePixelRatio(density);
    result.fill(Qt::transparent);
    QPainter painter(&result);
    draw(svgOf(name), colour, painter, QRectF(0, 0, sizePx, sizePx));
    return result;
}

IconLabel::IconLabel(const QString& iconName, int sizePx, QWidget* parent) : QWidget(parent) {
    setFixedSize(sizePx, sizePx);
    setIcon(iconName);
}

void IconLabel::setIcon(const QString& iconName) {
    if (iconName != m_name) {
        m_name = iconName;
        m_icon = ui::icon(iconName);
        update();
    }
}

void IconLabel::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    m_icon.paint(&painter, rect());
}

} // namespace spherewalk::ui
