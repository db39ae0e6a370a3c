// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan_drawing.h"

#include "grid_lattice.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spherewalk::jobs {

using Eigen::Vector2d;
using measure::Svg;
using measure::SvgBox;
using measure::SvgPoint;

namespace {

constexpr int kWidth = 760;
constexpr double kPlanWidth = 520;
constexpr double kMostHeight = 620;
constexpr double kMarginPx = 24;
constexpr double kTopPx = 70;
constexpr double kReachWithoutGridM = 0.3;
constexpr double kMostRasterCells = 120; ///< along the longer side

std::vector<Eigen::Vector3d> placesOf(const render::DatasetInfo& info) {
    std::vector<Eigen::Vector3d> places;
    for (const render::DatasetPhoto& photo : info.photos) {
        places.push_back(photo.roomFromPhoto.translation);
    }
    return places;
}

double reachOf(const render::DatasetInfo& info) {
    const double step = std::max(GridLattice(placesOf(info)).stepM(), info.stepM);
    return step > 0 ? std::sqrt(0.5) * step : kReachWithoutGridM;
}

/// Of the room, or of the photos with their reach where the room is not known.
Bounds2 boundsOf(const render::DatasetInfo& info, double reachM) {
    if (!info.outline.empty()) {
        return bounds(info.outline);
    }
    Polygon corners;
    for (const Eigen::Vector3d& place : placesOf(info)) {
        corners.emplace_back(place.head<2>() - Vector2d::Constant(2 * reachM));
        corners.emplace_back(place.head<2>() + Vector2d::Constant(2 * reachM));
    }
    return bounds(corners);
}

double scaleOf(const Bounds2& bounds) {
    const Vector2d size = (bounds.greatest - bounds.least).cwiseMax(Vector2d::Constant(0.1));
    return std::min(kPlanWidth / size.x(), kMostHeight / size.y());
}

int heightOf(const Bounds2& bounds, double scale) {
    return static_cast<int>(kTopPx + kMarginPx +
                            std::max(200.0, scale * (bounds.greatest.y() - bounds.least.y())));
}

} // namespace

PlanDrawing::PlanDrawing(const render::DatasetInfo& info, std::string_view title, std::string_view below)
    : m_info(info),
      m_bounds(boundsOf(info, reachOf(info))),
      m_pixelsAMetre(scaleOf(m_bounds)),
      m_reachM(reachOf(info)),
      m_svg(kWidth, heightOf(m_bounds, m_pixelsAMetre), title),
      m_legendY(kTopPx + 12) {
    m_svg.text({kMarginPx, 30}, title, Svg::Text::Title);
    m_svg.text({kMarginPx, 50}, below, Svg::Text::Small);
}

SvgPoint PlanDrawing::at(const Vector2d& pInRoom) const {
    return {kMarginPx + pixels(pInRoom.x() - m_bounds.least.x()),
            kTopPx + pixels(m_bounds.greatest.y() - pInRoom.y())};
}

bool PlanDrawing::isFloor(const Vector2d& pInRoom) const {
    return (m_info.outline.empty() || contains(m_info.outline, pInRoom)) &&
           std::none_of(m_info.obstacles.begin(), m_info.obstacles.end(),
                        [&](const Polygon& obstacle) { return contains(obstacle, pInRoom); });
}

std::optional<std::size_t> PlanDrawing::nearest(const Vector2d& pInRoom) const {
    std::optional<std::size_t> best;
    double least = m_reachM * (1 + 1e-9);
    for (std::size_t i = 0; i < m_info.photos.size(); ++i) {
        const double distance = (m_info.photos[i].roomFromPhoto.translation.head<2>() - pInRoom).norm();
        if (distance <= least) {
            least = distance;
            best = i;
        }
    }
    return best;
}

void PlanDrawing::floor(const std::function<std::string(std::size_t)>& colour) {
    const Vector2d size = m_bounds.greatest - m_bounds.least;
    const double cell = size.maxCoeff() / kMostRasterCells;
    const auto columns = static_cast<int>(std::ceil(size.x() / cell));
    const auto rows = static_cast<int>(std::ceil(size.y() / cell));
    for (int row = 0; row < rows; ++row) {
        std::string runColour; // cells of one colour in a row are one rectangle
        int runBegin = 0;
        for (int column = 0; column <= columns; ++column) {
            const Vector2d middle = m_bounds.least + cell * Vector2d(column + 0.5, row + 0.5);
            const auto photo = column < columns && isFloor(middle) ? nearest(middle) : std::nullopt;
            const std::string now = photo ? colour(*photo) : "";
            if (now == runColour) {
                continue;
            }
            if (!runColour.empty()) {
                const SvgPoint corner = at(m_bounds.least + cell * Vector2d(runBegin, row + 1));
                m_svg.rectangle(
                    {corner.x, corner.y, pixels(cell * (column - runBegin)) + 0.3, pixels(cell) + 0.3},
                    runColour);
            }
            runColour = now;
            runBegin = column;
        }
    }
}

void PlanDrawing::walls() {
    const auto drawn = [&](const Polygon& polygon, std::string_view colour, Svg::Line line) {
        std::vector<SvgPoint> corners;
        for (const Vector2d& corner : polygon) {
            corners.push_back(at(corner));
        }
        m_svg.polygon(corners, colour, line);
    };
    for (const Polygon& obstacle : m_info.obstacles) {
        drawn(obstacle, "#8a8a8a", Svg::Line::Grid);
    }
    if (!m_info.outline.empty()) {
        drawn(m_info.outline, "", Svg::Line::Axis);
    }
}

void PlanDrawing::legend(const std::string& colour, const std::string& words) {
    constexpr double kX = kMarginPx + kPlanWidth + 24;
    m_svg.rectangle({kX, m_legendY - 11, 14, 14}, colour);
    m_svg.text({kX + 22, m_legendY}, words, Svg::Text::Small);
    m_legendY += 22;
}

} // namespace spherewalk::jobs
