// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure_plots.h"
#include "plan_drawing.h"

#include "spherewalk/base/text.h"
#include "spherewalk/measure/error_colour.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace spherewalk::jobs {

using Eigen::Vector2d;
using measure::Svg;

namespace {

constexpr const char* kCovered = "#cfe3f1";
constexpr const char* kStation = "#0072b2";
constexpr const char* kNoError = "#e2e2e2";
constexpr double kStationM = 0.03;

Vector2d placeOf(const render::DatasetInfo& info, std::size_t photo) {
    return info.photos[photo].roomFromPhoto.translation.head<2>();
}

std::map<std::size_t, std::optional<double>> errorsOf(const SceneLikeness& scene) {
    std::map<std::size_t, std::optional<double>> errors;
    for (const PhotoError& photo : scene.photos) {
        errors[photo.photo] = photo.p95Px;
    }
    return errors;
}

void errorLegend(PlanDrawing& plan, double tolerancePx) {
    for (const double step : measure::kErrorSteps) {
        const double px = step * tolerancePx;
        plan.legend(measure::errorColour(px, tolerancePx),
                    text(fixed(px, px < 10 ? 2 : 0), " px",
                         step == 1                              ? ", the tolerance"
                         : step == measure::kErrorSteps.front() ? " and less"
                         : step == measure::kErrorSteps.back()  ? " and more"
                                                                : ""));
    }
    plan.legend(kNoError, "not measured");
}

/// A sector of a disc about the place, from one angle to another, counter-clockwise from the room's x axis.
std::vector<measure::SvgPoint> sector(const PlanDrawing& plan, const Vector2d& place, double radiusM,
                                      double begin, double end) {
    constexpr int kParts = 8;
    std::vector<measure::SvgPoint> corners{plan.at(place)};
    for (int i = 0; i <= kParts; ++i) {
        const double angle = begin + (end - begin) * i / kParts;
        corners.push_back(plan.at(place + radiusM * Vector2d(std::cos(angle), std::sin(angle))));
    }
    return corners;
}

} // namespace

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
        return found == errors.end() ? kNoError : measure::errorColour(found->second, tolerancePx);
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
                           measure::errorColour(view.errorPx(report.places), tolerancePx), Svg::Line::Grid);
    }
    errorLegend(plan, tolerancePx);
    return plan.str();
}

} // namespace spherewalk::jobs
