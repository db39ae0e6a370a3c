// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/photo/blurred_photo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace spherewalk::photo {

using Eigen::Vector2d;
using Eigen::Vector3d;
using survey::PrivateRegion;
using survey::RegionFrame;

namespace {

constexpr int kLeastCellPx = 8; ///< Smaller cells would keep what is there of a small region.

/// Columns of the picture, which wrap at its width.
struct Columns {
    int first = 0;
    int count = 0;
};

/// The columns that a region may reach.
Columns columnsOf(const PrivateRegion& region, const RegionFrame& frame, const EquirectSize& size) {
    const double reach = frame.reach().value();
    if (std::abs(region.elevation.value()) + reach >= std::numbers::pi / 2) { // it holds a pole
        return {0, size.width};
    }
    const double aside = std::asin(std::sin(reach) / cos(region.elevation));
    const double perRadian = size.width / (2 * std::numbers::pi);
    const double middle = pixel(size, frame.middle()).x();
    const int first = static_cast<int>(std::floor(middle - aside * perRadian)) - 1;
    const int last = static_cast<int>(std::ceil(middle + aside * perRadian)) + 1;
    return {first, std::min(last - first + 1, size.width)};
}

/// Calls use(x, y, place, weight) for each pixel within the region. weight: the pixel's share of the sphere.
template <class Use>
void forEachPixel(const PrivateRegion& region, const EquirectSize& size, const Use& use) {
    const RegionFrame frame(region);
    const Columns columns = columnsOf(region, frame, size);
    const double perRadian = size.height / std::numbers::pi;
    const double middle = pixel(size, frame.middle()).y();
    const double reach = frame.reach().value() * perRadian + 1;
    const int top = std::max(0, static_cast<int>(std::floor(middle - reach)));
    const int bottom = std::min(size.height - 1, static_cast<int>(std::ceil(middle + reach)));
    for (int y = top; y <= bottom; ++y) {
        const double weight = std::sin(std::numbers::pi * (y + 0.5) / size.height);
        for (int i = 0; i < columns.count; ++i) {
            const int x = ((columns.first + i) % size.width + size.width) % size.width;
            const auto place = frame.at(direction(size, Vector2d(x, y)));
            if (place && place->cwiseAbs().maxCoeff() <= 1) {
                use(x, y, *place, weight);
            }
        }
    }
}

/// The mean colours of a region's cells.
class Cells {
  public:
    Cells(const PrivateRegion& region, const EquirectSize& size)
        : m_columns(countFor(region.width, size)), m_rows(countFor(region.height, size)) {}

    void add(const Vector2d& place, const std::uint8_t* colour, double weight) {
        Cell& cell = at(std::min(static_cast<int>((place.x() + 1) / 2 * m_columns), m_columns - 1),
                        std::min(static_cast<int>((place.y() + 1) / 2 * m_rows), m_rows - 1));
        cell.sum += weight * Vector3d(colour[0], colour[1], colour[2]);
        cell.weight += weight;
    }

    /// Gives the cells that no pixel fell into the mean of all.
    void finish() {
        Cell all;
        for (const Cell& cell : m_cells) {
            all.sum += cell.sum;
            all.weight += cell.weight;
        }
        for (Cell& cell : m_cells) {
            cell = cell.weight > 0 ? cell : all;
        }
    }

    /// Between the middles of cells, colours run evenly.
    Vector3d colour(const Vector2d& place) const {
        const double x = std::clamp((place.x() + 1) / 2 * m_columns - 0.5, 0.0, m_columns - 1.0);
        const double y = std::clamp((place.y() + 1) / 2 * m_rows - 0.5, 0.0, m_rows - 1.0);
        const int left = std::min(static_cast<int>(x), std::max(0, m_columns - 2));
        const int low = std::min(static_cast<int>(y), std::max(0, m_rows - 2));
        const int right = std::min(left + 1, m_columns - 1);
        const int high = std::min(low + 1, m_rows - 1);
        const double u = x - left;
        const double v = y - low;
        return (1 - v) * ((1 - u) * mean(left, low) + u * mean(right, low)) +
               v * ((1 - u) * mean(left, high) + u * mean(right, high));
    }

  private:
    struct Cell {
        Vector3d sum = Vector3d::Zero();
        double weight = 0;
    };

    static int countFor(Radians side, const EquirectSize& size) {
        const double sidePx = side.value() / (2 * std::numbers::pi) * size.width;
        return std::clamp(static_cast<int>(sidePx / kLeastCellPx), 1, kBlurCells);
    }

    static std::size_t index(int column, int row) {
        return static_cast<std::size_t>(row) * kBlurCells + static_cast<std::size_t>(column);
    }

    Cell& at(int column, int row) { return m_cells[index(column, row)]; }

    Vector3d mean(int column, int row) const {
        const Cell& cell = m_cells[index(column, row)];
        return cell.sum / cell.weight;
    }

    int m_columns;
    int m_rows;
    std::array<Cell, static_cast<std::size_t>(kBlurCells) * kBlurCells> m_cells;
};

} // namespace

MaskImage blurRegions(RgbImage& picture, std::span<const PrivateRegion> regions) {
    const EquirectSize size{picture.width(), picture.height()};
    MaskImage changed(picture.width(), picture.height());
    for (const PrivateRegion& region : regions) {
        Cells cells(region, size);
        forEachPixel(region, size, [&](int x, int y, const Vector2d& place, double weight) {
            cells.add(place, picture.at(x, y), weight);
        });
        cells.finish();
        forEachPixel(region, size, [&](int x, int y, const Vector2d& place, double /*weight*/) {
            const Vector3d colour = cells.colour(place);
            for (int channel = 0; channel < RgbImage::kChannels; ++channel) {
                picture.at(x, y)[channel] = static_cast<std::uint8_t>(std::lround(colour[channel]));
            }
            *changed.at(x, y) = 255;
        });
    }
    return changed;
}

} // namespace spherewalk::photo
