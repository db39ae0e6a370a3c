// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/sphere_view.h"

#include "spherewalk/geometry/equirect.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace spherewalk::align {

namespace {

/// Where a row or column of the result lies in the source, and how many source pixels it stands for.
struct SourcePlace {
    double position = 0; ///< Pixel centres are integers.
    double extent = 1;   ///< Below 1 where the result is finer than the source.
};

/// The source pixels that make one pixel of the result.
struct Taps {
    int first = 0;
    std::vector<float> weights;
};

double catmullRom(double t) {
    t = std::abs(t);
    if (t >= 2) {
        return 0;
    }
    return t < 1 ? (1.5 * t - 2.5) * t * t + 1 : ((-0.5 * t + 2.5) * t - 4) * t + 2;
}

Taps taps(const SourcePlace& place) {
    const double extent = std::max(1.0, place.extent);
    Taps result;
    result.first = static_cast<int>(std::ceil(place.position - 2 * extent));
    const int last = static_cast<int>(std::floor(place.position + 2 * extent));
    double sum = 0;
    for (int i = result.first; i <= last; ++i) {
        const double weight = catmullRom((i - place.position) / extent);
        result.weights.push_back(static_cast<float>(weight));
        sum += weight;
    }
    for (float& weight : result.weights) {
        weight = static_cast<float>(weight / sum);
    }
    return result;
}

void addScaled(const std::uint8_t* source, float weight, float* sum, int count) {
    for (int x = 0; x < count; ++x) {
        sum[x] += weight * static_cast<float>(source[x]);
    }
}

std::uint8_t toByte(float value) {
    return static_cast<std::uint8_t>(std::clamp(value + 0.5F, 0.0F, 255.0F));
}

/// The picture whose rows and columns lie at these places of the source. Columns wrap around, rows stop at
/// the source's edge. Filter: Catmull-Rom, widened to the extent where it is above 1.
GreyImage resampled(const GreyImage& source, const std::vector<SourcePlace>& columns,
                    const std::vector<SourcePlace>& rows) {
    const int width = source.width();
    std::vector<Taps> across;
    std::size_t longest = 0;
    for (const SourcePlace& place : columns) {
        across.push_back(taps(place));
        across.back().first = ((across.back().first % width) + width) % width;
        longest = std::max(longest, across.back().weights.size());
    }
    GreyImage result(static_cast<int>(columns.size()), static_cast<int>(rows.size()));
    std::vector<float> line(static_cast<std::size_t>(width) + longest);
    for (int y = 0; y < result.height(); ++y) {
        std::fill(line.begin(), line.end(), 0.0F);
        const Taps down = taps(rows[static_cast<std::size_t>(y)]);
        for (std::size_t i = 0; i < down.weights.size(); ++i) {
            const int row = std::clamp(down.first + static_cast<int>(i), 0, source.height() - 1);
            addScaled(source.at(0, row), down.weights[i], line.data(), width);
        }
        for (std::size_t i = 0; i < longest; ++i) {
            line[static_cast<std::size_t>(width) + i] = line[i % static_cast<std::size_t>(width)];
        }
        std::uint8_t* out = result.at(0, y);
        for (const Taps& tap : across) {
            const float* at = line.data() + tap.first;
            float sum = 0;
            for (std::size_t i = 0; i < tap.weights.size(); ++i) {
                sum += tap.weights[i] * at[i];
            }
            *out++ = toByte(sum);
        }
    }
    return result;
}

constexpr double kPi = std::numbers::pi;

double mercator(double elevation) {
    return std::asinh(std::tan(elevation));
}

double elevationOf(double mercatorOrdinate) {
    return std::atan(std::sinh(mercatorOrdinate));
}

/// Where the photo shows the columns of a picture `width` pixels around, from column `first` on.
std::vector<SourcePlace> columnsOf(const GreyImage& photo, int width, int first, int count) {
    const double ratio = static_cast<double>(photo.width()) / width;
    std::vector<SourcePlace> columns;
    for (int x = first; x < first + count; ++x) {
        columns.push_back({(x + 0.5) * ratio - 0.5, ratio});
    }
    return columns;
}

SourcePlace rowAt(const GreyImage& photo, double elevation, double pixelRad) {
    const double perRad = photo.height() / kPi;
    return {(kPi / 2 - elevation) * perRad - 0.5, pixelRad * perRad};
}

/// Bicubic between the pixels; columns wrap, rows stop at the edge.
double between(const GreyImage& picture, double u, double v) {
    const double u0 = std::floor(u);
    const double v0 = std::floor(v);
    const auto weights = [](double t) {
        return std::array{((-0.5 * t + 1) * t - 0.5) * t, (1.5 * t - 2.5) * t * t + 1,
                          ((-1.5 * t + 2) * t + 0.5) * t, (0.5 * t - 0.5) * t * t};
    };
    const auto across = weights(u - u0);
    const auto down = weights(v - v0);
    const int width = picture.width();
    double sum = 0;
    for (int j = 0; j < 4; ++j) {
        const int y = std::clamp(static_cast<int>(v0) - 1 + j, 0, picture.height() - 1);
        double line = 0;
        for (int i = 0; i < 4; ++i) {
            const int x = static_cast<int>(u0) - 1 + i;
            line += across[static_cast<std::size_t>(i)] * *picture.at(((x % width) + width) % width, y);
        }
        sum += down[static_cast<std::size_t>(j)] * line;
    }
    return sum;
}

} // namespace

GreyImage grey(const RgbImage& picture) {
    GreyImage result(picture.width(), picture.height());
    const std::uint8_t* from = picture.values().data();
    std::uint8_t* to = result.values().data();
    const std::size_t count = result.values().size();
    for (std::size_t i = 0; i < count; ++i) {
        to[i] = static_cast<std::uint8_t>(
            (77 * from[3 * i] + 150 * from[3 * i + 1] + 29 * from[3 * i + 2] + 128) >> 8);
    }
    return result;
}

double SphereView::pixelsPerRad() const {
    return m_width / (2 * kPi);
}

SphereView SphereView::band(const GreyImage& photo, int width, Radians lowest, Squeeze squeeze) {
    const int around = static_cast<int>(std::lround(width / squeeze.across));
    SphereView view(Part::Band, around, squeeze.upright * around / width);
    const double perRad = view.m_perRadDown;
    const double bottom = mercator(std::max(lowest, -edge()).value()) - kMargin / perRad;
    view.m_top = mercator(edge().value()) + kMargin / perRad;
    const int height = static_cast<int>(std::ceil((view.m_top - bottom) * perRad));
    std::vector<SourcePlace> rows;
    for (int y = 0; y < height; ++y) {
        const double elevation = elevationOf(view.m_top - (y + 0.5) / perRad);
        rows.push_back(rowAt(photo, elevation, std::cos(elevation) / perRad));
    }
    view.m_picture = resampled(photo, columnsOf(photo, around, -kMargin, around + 2 * kMargin), rows);
    return view;
}

SphereView SphereView::cap(const GreyImage& photo, int width, bool isZenith) {
    SphereView view(isZenith ? Part::Zenith : Part::Nadir, width);
    const double perRad = view.pixelsPerRad();
    const double reach = 2 * std::tan((kPi / 2 - edge().value()) / 2) + kMargin / perRad;
    // The first step brings the photo to the working size, so that the second step needs no filter.
    const double widest = 2 * std::atan(reach * std::numbers::sqrt2 / 2); // Up to the corners.
    const int rows = std::min(width / 2, static_cast<int>(std::ceil(widest * perRad)) + 2);
    std::vector<SourcePlace> places;
    for (int y = 0; y < rows; ++y) {
        const double fromPole = (y + 0.5) / perRad;
        places.push_back(rowAt(photo, (isZenith ? 1 : -1) * (kPi / 2 - fromPole), 1 / perRad));
    }
    const GreyImage flat = resampled(photo, columnsOf(photo, width, 0, width), places);

    const int side = 2 * static_cast<int>(std::ceil(reach * perRad));
    view.m_picture = GreyImage(side, side);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const SphericalDirection at = sphericalDirection(view.bearing(x, y));
            const double fromPole = kPi / 2 - std::abs(at.elevation.value());
            const double value =
                between(flat, (kPi - at.azimuth.value()) * perRad - 0.5, fromPole * perRad - 0.5);
            *view.m_picture.at(x, y) = static_cast<std::uint8_t>(std::clamp(value + 0.5, 0.0, 255.0));
        }
    }
    return view;
}

Eigen::Vector2d SphereView::onPlane(double x, double y) const {
    const double middle = (m_picture.width() - 1) / 2.0;
    return Eigen::Vector2d(x - middle, y - middle) / pixelsPerRad();
}

Eigen::Vector3d SphereView::bearing(double x, double y) const {
    if (m_part == Part::Band) {
        return direction({Radians(kPi - (x - kMargin + 0.5) / pixelsPerRad()),
                          Radians(elevationOf(m_top - (y + 0.5) / m_perRadDown))});
    }
    // The view is from inside, with the horizon at azimuth 0 below the zenith and above the nadir.
    const double sign = m_part == Part::Zenith ? 1 : -1;
    const Eigen::Vector2d p = onPlane(x, y);
    const double q = p.squaredNorm() / 4;
    return Eigen::Vector3d(sign * p.y(), -p.x(), sign * (1 - q)) / (1 + q);
}

double SphereView::pixelRad(double x, double y) const {
    const double shrinks = m_part == Part::Band ? std::cosh(m_top - (y + 0.5) / m_perRadDown)
                                                : 1 + onPlane(x, y).squaredNorm() / 4;
    return 1 / (std::min(pixelsPerRad(), m_perRadDown) * shrinks);
}

bool SphereView::owns(double x, double y) const {
    const double height = std::asin(std::clamp(bearing(x, y).z(), -1.0, 1.0));
    if (m_part != Part::Band) {
        return (m_part == Part::Zenith ? height : -height) > edge().value();
    }
    const double column = x - kMargin + 0.5;
    return column >= 0 && column < m_width && std::abs(height) <= edge().value();
}

std::vector<SphereView> sphereViews(const GreyImage& photo, int width, Radians lowest, bool usesZenith) {
    std::vector<SphereView> views;
    views.push_back(SphereView::band(photo, width, lowest));
    if (usesZenith) {
        views.push_back(SphereView::cap(photo, width, true));
    }
    if (lowest < -SphereView::edge()) {
        views.push_back(SphereView::cap(photo, width, false));
    }
    return views;
}

} // namespace spherewalk::align
