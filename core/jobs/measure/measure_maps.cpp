// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/measure_plots.h"
#include "measure/photo_grid.h"

#include "spherewalk/base/text.h"
#include "spherewalk/geometry/polygon.h"
#include "spherewalk/render/dataset_format.h"
#include "spherewalk/report/chart.h"
#include "spherewalk/report/svg.h"
#include "spherewalk/web/page.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <string>

namespace spherewalk::jobs {

using Eigen::Vector2d;
using report::Svg;
using report::SvgBox;
using report::SvgPoint;

namespace {

constexpr int kMapWidth = 760;
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

bool isFloor(const render::DatasetInfo& info, const Vector2d& pInRoom) {
    return (info.outline.empty() || contains(info.outline, pInRoom)) &&
           std::none_of(info.obstacles.begin(), info.obstacles.end(),
                        [&](const Polygon& obstacle) { return contains(obstacle, pInRoom); });
}

std::optional<std::size_t> nearest(const render::DatasetInfo& info, double reachM, const Vector2d& pInRoom) {
    std::optional<std::size_t> best;
    double least = reachM * (1 + 1e-9);
    for (std::size_t i = 0; i < info.photos.size(); ++i) {
        const double distance = (info.photos[i].roomFromPhoto.translation.head<2>() - pInRoom).norm();
        if (distance <= least) {
            least = distance;
            best = i;
        }
    }
    return best;
}

/// How far a photo reaches: half the diagonal of a cell of the photos' grid.
double reachOf(const render::DatasetInfo& info) {
    const double step = std::max(PhotoGrid(placesOf(info)).stepM(), info.stepM);
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

/// A dataset's room from above, y upwards.
class PlanDrawing {
  public:
    PlanDrawing(const render::DatasetInfo& info, std::string_view title, std::string_view below);

    report::Svg& svg() { return m_svg; }

    report::SvgPoint at(const Eigen::Vector2d& pInRoom) const;

    double pixels(double metres) const { return metres * m_pixelsAMetre; }

    /// How far a photo reaches: half the diagonal of a cell of the grid.
    double reachM() const { return m_reachM; }

    /// The floor within the reach of photos, in the colour of the nearest one. colour: of a photo by its
    /// index.
    void floor(const std::function<std::string(std::size_t)>& colour);
    void walls();
    /// Beside the plan, from the top.
    void legend(const std::string& colour, const std::string& words);

    std::string str() const { return m_svg.str(); }

  private:
    const render::DatasetInfo& m_info;
    Bounds2 m_bounds;
    double m_pixelsAMetre;
    double m_reachM;
    report::Svg m_svg;
    double m_legendY;
};

PlanDrawing::PlanDrawing(const render::DatasetInfo& info, std::string_view title, std::string_view below)
    : m_info(info),
      m_bounds(boundsOf(info, reachOf(info))),
      m_pixelsAMetre(scaleOf(m_bounds)),
      m_reachM(reachOf(info)),
      m_svg(kMapWidth, heightOf(m_bounds, m_pixelsAMetre), title),
      m_legendY(kTopPx + 12) {
    m_svg.text({kMarginPx, 30}, title, Svg::Text::Title);
    m_svg.text({kMarginPx, 50}, below, Svg::Text::Small);
}

SvgPoint PlanDrawing::at(const Vector2d& pInRoom) const {
    return {kMarginPx + pixels(pInRoom.x() - m_bounds.least.x()),
            kTopPx + pixels(m_bounds.greatest.y() - pInRoom.y())};
}

void PlanDrawing::floor(const std::function<std::string(std::size_t)>& colour) {
    const web::Floor floor = floorCells(m_info, colour);
    for (const web::FloorRun& run : floor.runs) {
        const SvgPoint corner = at(floor.origin + floor.cellM * Vector2d(run.begin, run.row + 1));
        m_svg.rectangle({corner.x, corner.y, pixels(floor.cellM * (run.end - run.begin)) + 0.3,
                         pixels(floor.cellM) + 0.3},
                        colour(run.photo));
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

constexpr const char* kCovered = "#cfe3f1";
constexpr const char* kStation = "#0072b2";
constexpr const char* kNoError = "#e2e2e2";
constexpr double kStationM = 0.03;

Vector2d placeOf(const render::DatasetInfo& info, std::size_t photo) {
    return info.photos[photo].roomFromPhoto.translation.head<2>();
}

/// An infinite error has the colour of the largest ones, since it is known to be too large.
std::string colourOf(const std::optional<double>& errorPx, double tolerancePx) {
    constexpr double kLargestPx = 1e9;
    return report::errorColour(errorPx ? std::optional(std::min(*errorPx, kLargestPx)) : std::nullopt,
                               tolerancePx);
}

std::map<std::size_t, std::optional<double>> errorsOf(const SceneLikeness& scene) {
    std::map<std::size_t, std::optional<double>> errors;
    for (const PhotoError& photo : scene.photos) {
        errors[photo.photo] = photo.p95Px;
    }
    return errors;
}

void errorLegend(PlanDrawing& plan, double tolerancePx) {
    for (const double step : report::kErrorSteps) {
        const double px = step * tolerancePx;
        plan.legend(report::errorColour(px, tolerancePx),
                    text(fixed(px, px < 10 ? 2 : 0), " px",
                         step == 1                             ? ", the tolerance"
                         : step == report::kErrorSteps.front() ? " and less"
                         : step == report::kErrorSteps.back()  ? " and more"
                                                               : ""));
    }
    plan.legend(kNoError, "not measured");
}

/// A sector of a disc about the place, from one angle to another, counter-clockwise from the room's x axis.
std::vector<report::SvgPoint> sector(const PlanDrawing& plan, const Vector2d& place, double radiusM,
                                     double begin, double end) {
    constexpr int kParts = 8;
    std::vector<report::SvgPoint> corners{plan.at(place)};
    for (int i = 0; i <= kParts; ++i) {
        const double angle = begin + (end - begin) * i / kParts;
        corners.push_back(plan.at(place + radiusM * Vector2d(std::cos(angle), std::sin(angle))));
    }
    return corners;
}

} // namespace

web::Floor floorCells(const render::DatasetInfo& info,
                      const std::function<std::string(std::size_t)>& colour) {
    const double reachM = reachOf(info);
    const Bounds2 area = boundsOf(info, reachM);
    const Vector2d size = area.greatest - area.least;
    web::Floor floor{area.least, size.maxCoeff() / kMostRasterCells, {}};
    const auto columns = static_cast<int>(std::ceil(size.x() / floor.cellM));
    const auto rows = static_cast<int>(std::ceil(size.y() / floor.cellM));
    for (int row = 0; row < rows; ++row) {
        std::string runColour; // cells of one colour in a row are one run
        for (int column = 0; column < columns; ++column) {
            const Vector2d middle = area.least + floor.cellM * Vector2d(column + 0.5, row + 0.5);
            const auto photo = isFloor(info, middle) ? nearest(info, reachM, middle) : std::nullopt;
            const std::string now = photo ? colour(*photo) : "";
            if (!now.empty() && now == runColour) {
                ++floor.runs.back().end;
            } else if (!now.empty()) {
                floor.runs.push_back({row, column, column + 1, *photo});
            }
            runColour = now;
        }
    }
    return floor;
}

std::string coveragePlot(const render::DatasetInfo& info) {
    PlanDrawing plan(info, "Coverage", "Floor within reach of a photo: half the diagonal of the grid's cell");
    plan.floor([](std::size_t /*photo*/) { return kCovered; });
    plan.walls();
    for (std::size_t i = 0; i < info.photos.size(); ++i) {
        plan.svg().circle(plan.at(placeOf(info, i)), plan.pixels(kStationM), kStation);
    }
    plan.legend(kStation, text(info.photos.size(), " photos"));
    plan.legend(kCovered, "covered");
    if (!info.obstacles.empty()) {
        plan.legend("#8a8a8a", "obstacle");
    }
    return plan.str();
}

std::string errorMap(const render::DatasetInfo& info, const SceneLikeness& scene, double tolerancePx) {
    const auto errors = errorsOf(scene);
    const auto colour = [&](std::size_t photo) {
        const auto found = errors.find(photo);
        return found == errors.end() ? kNoError : colourOf(found->second, tolerancePx);
    };
    PlanDrawing plan(info, text("Error about each photo, scene model ", name(scene.scene)),
                     "95th percentile of displacement where the photo was left out");
    plan.floor(colour);
    plan.walls();
    for (std::size_t i = 0; i < info.photos.size(); ++i) {
        plan.svg().circle(plan.at(placeOf(info, i)), plan.pixels(1.4 * kStationM), "#444444");
        plan.svg().circle(plan.at(placeOf(info, i)), plan.pixels(kStationM), colour(i));
    }
    errorLegend(plan, tolerancePx);
    return plan.str();
}

std::string directionMap(const render::DatasetInfo& info, const SceneLikeness& scene,
                         const MeasureReport& report) {
    const double tolerancePx = report.choice.tolerancePx;
    PlanDrawing plan(
        info, text("Error by direction, scene model ", name(scene.scene)),
        "Each disc is a photo that was left out, each sector a direction that it was compared in");
    const double radiusM = 0.6 * plan.reachM();
    const double half = std::numbers::pi / report.directions;
    plan.walls();
    for (std::size_t i = 0; i < info.photos.size(); ++i) {
        plan.svg().circle(plan.at(placeOf(info, i)), plan.pixels(radiusM), kNoError);
    }
    for (const ViewLikeness& view : scene.views) {
        const double angle = std::atan2(view.axis().y(), view.axis().x());
        plan.svg().polygon(sector(plan, view.at().head<2>(), radiusM, angle - half, angle + half),
                           colourOf(view.errorPx(report.places), tolerancePx), Svg::Line::Grid);
    }
    errorLegend(plan, tolerancePx);
    return plan.str();
}

} // namespace spherewalk::jobs
