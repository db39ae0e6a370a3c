// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/measure_summary.h"

#include "parts/report_parts.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/statistics.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace spherewalk::jobs {

namespace {

constexpr EnumNames<Places, 2> kPlaces{{{Places::Features, "features"}, {Places::Pixels, "pixels"}}};
constexpr double kMedian = 0.5;
constexpr double kNearlyAll = 0.95;

void append(std::vector<int>& all, const std::vector<int>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

bool isFinite(const std::optional<double>& value) {
    return value && std::isfinite(*value);
}

} // namespace

std::string_view name(Places places) {
    return nameOf(kPlaces, places);
}

Places places(std::string_view name) {
    return valueOf(kPlaces, "The kind of places", name);
}

std::optional<double> errorPx(Places places, const std::optional<double>& features,
                              const std::optional<double>& pixels) {
    const bool isFeatures = places == Places::Features;
    const std::optional<double>& wanted = isFeatures ? features : pixels;
    return wanted ? wanted : isFeatures ? pixels : features;
}

SceneSummary::SceneSummary(render::SceneKind scene, render::Sampling sampling, Places places)
    : m_places(places) {
    m_result.scene = scene;
    m_result.sampling = sampling;
}

void SceneSummary::add(const Comparison& comparison, ViewLikeness view) {
    view.looks = comparison.looks;
    view.matches = comparison.features.found.size();
    view.missed = comparison.features.missed;
    view.medianPx = quantilePx(comparison.features, kMedian);
    view.p95Px = quantilePx(comparison.features, kNearlyAll);
    view.exactMedianPx = quantilePx(comparison.exact, kMedian);
    view.exactP95Px = quantilePx(comparison.exact, kNearlyAll);
    view.things = comparison.things;
    m_features.add(comparison.features);
    append(m_exact, comparison.exact);
    if (view.leftOut) {
        const bool isExact = m_places == Places::Pixels && !comparison.exact.empty();
        m_ofPhotos[*view.leftOut].add(isExact ? PlaceErrors{comparison.exact, 0} : comparison.features);
    }
    m_result.views.push_back(std::move(view));
}

SceneLikeness SceneSummary::result() const {
    SceneLikeness result = m_result;
    std::vector<Looks> looks;
    for (const ViewLikeness& view : result.views) {
        looks.push_back(view.looks);
    }
    result.looks = summaryOf(looks);
    result.medianPx = quantilePx(m_features, kMedian);
    result.p95Px = quantilePx(m_features, kNearlyAll);
    result.missedShare = m_features.missedShare();
    result.exactMedianPx = quantilePx(m_exact, kMedian);
    result.exactP95Px = quantilePx(m_exact, kNearlyAll);
    for (const auto& [photo, errors] : m_ofPhotos) {
        result.photos.push_back({photo, quantilePx(errors, kNearlyAll), errors.size()});
    }
    return result;
}

void SamplingSummary::add(const SamplingErrors& errors) {
    for (const auto& [sampling, values] : errors) {
        append(m_errors[sampling], values);
    }
}

std::optional<double> SamplingSummary::errorWith(render::Sampling sampling, render::Sampling usual,
                                                 const std::optional<double>& usualPx) const {
    if (sampling == usual || !usualPx) {
        return usualPx;
    }
    const auto own = [&](render::Sampling of) {
        const auto found = m_errors.find(of);
        return found == m_errors.end() ? std::nullopt : quantilePx(found->second, kNearlyAll);
    };
    const std::optional<double> added = own(sampling);
    const std::optional<double> there = own(usual);
    if (!added || !there) {
        return std::nullopt;
    }
    return std::sqrt(std::max(0.0, *usualPx * *usualPx - *there * *there) + *added * *added);
}

double betweenPhotosM(const std::vector<Eigen::Vector3d>& photos) {
    constexpr int kParts = 8;          // of the distance between neighbours
    constexpr double kMostParts = 400; // along an axis
    const auto nearestM = [&](const Eigen::Vector2d& place, std::size_t without) {
        double nearest = HUGE_VAL;
        for (std::size_t i = 0; i < photos.size(); ++i) {
            if (i != without) {
                nearest = std::min(nearest, (photos[i].head<2>() - place).norm());
            }
        }
        return nearest;
    };
    if (photos.size() < 2) {
        return 0;
    }
    std::vector<double> steps;
    Eigen::AlignedBox2d box;
    for (std::size_t i = 0; i < photos.size(); ++i) {
        steps.push_back(nearestM(photos[i].head<2>(), i));
        box.extend(Eigen::Vector2d(photos[i].head<2>()));
    }
    const double step = median(steps);
    const double apart = std::max(step / kParts, box.sizes().maxCoeff() / kMostParts);
    std::vector<double> distances;
    for (double y = box.min().y(); apart > 0 && y <= box.max().y() + 0.5 * apart; y += apart) {
        for (double x = box.min().x(); x <= box.max().x() + 0.5 * apart; x += apart) {
            const double nearest = nearestM({x, y}, photos.size());
            if (nearest <= 1.01 * step / std::numbers::sqrt2) {
                distances.push_back(nearest);
            }
        }
    }
    return median(distances);
}

namespace {

/// The share of its exact error that is a left-out view's own. The true picture's depth is estimated, too, so
/// that with depths both are off: two equal errors are together sqrt(2) times as large.
double ownShare(render::SceneKind scene) {
    return render::usesDepths(scene) ? 1 / std::numbers::sqrt2 : 1;
}

} // namespace

std::optional<double> betweenPx(const MeasureReport& leaveOneOut, const SceneLikeness& scene) {
    const std::optional<double> px =
        scene.exactMedianPx ? ownShare(scene.scene) * *scene.exactMedianPx : scene.medianPx;
    const bool isKnown = isFinite(px) && leaveOneOut.viewM > 0 && leaveOneOut.betweenM > 0;
    return isKnown && scene.scene != render::SceneKind::Room // that was found to be four times too large
               ? std::optional(*px * leaveOneOut.betweenM / leaveOneOut.viewM)
               : std::nullopt;
}

ShownView shownView(const ViewLikeness& likeness, Places places, const RgbImage& truth,
                    const RgbImage& view) {
    return {likeness.subject,          likeness.errorPx(places), likeness.looks, truth, view,
            difference(view, truth, 1)};
}

namespace {

constexpr double kAlongShare = 0.3; ///< of an offset along the axis, at half way to the picture's edge
constexpr double kLeastAcrossM = 0.01;
constexpr double kNearM = 0.5;    ///< at which a view that was left out counts half as much
constexpr double kTurnRad = 0.35; ///< likewise, a third of a usual field of view

double nearness(const ViewLikeness& from, const ViewLikeness& view) {
    const double apart = (from.at() - view.at()).norm() / kNearM;
    return std::exp2(-apart * apart);
}

double weight(const ViewLikeness& from, const ViewLikeness& view) {
    const double turned = std::acos(std::clamp(from.axis().dot(view.axis()), -1.0, 1.0)) / kTurnRad;
    return nearness(from, view) * std::exp2(-turned * turned);
}

/// How much the way to the thing turns between a camera and the photo, small angles. thing: from the camera.
double parallax(const Eigen::Vector3d& offset, const Eigen::Vector3d& thing) {
    return std::max(kLeastAcrossM, offset.cross(thing.normalized()).norm()) / thing.norm();
}

bool isInFrame(const Eigen::Vector2d& pixel, const CameraModel& camera) {
    return pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() <= camera.width() - 1 &&
           pixel.y() <= camera.height() - 1;
}

/// What is foretold of one part of a view's frame.
struct Part {
    double nearestM = HUGE_VAL;                    ///< what hides the rest
    std::vector<std::pair<double, double>> errors; ///< each with its weight
};

/// Range: at least one error.
double weightedMean(const std::vector<std::pair<double, double>>& errors) {
    double sum = 0;
    double weights = 0;
    for (const auto& [error, weight] : errors) {
        sum += weight * error;
        weights += weight;
    }
    return sum / weights;
}

/// Range: at least one error.
double weightedMedian(std::vector<std::pair<double, double>> errors) {
    std::sort(errors.begin(), errors.end());
    double weights = 0;
    for (const auto& [error, weight] : errors) {
        weights += weight;
    }
    double below = 0;
    for (const auto& [error, weight] : errors) {
        below += weight;
        if (below >= 0.5 * weights) {
            return error;
        }
    }
    return errors.back().first;
}

/// A view's frame in square parts, about as many as a person would tell apart.
class Frame {
  public:
    explicit Frame(const CameraModel& camera)
        : m_sidePx(std::max(camera.width(), camera.height()) / double{kAcross}),
          m_columns(1 + static_cast<int>((camera.width() - 1) / m_sidePx)),
          m_parts(static_cast<std::size_t>(m_columns) *
                  static_cast<std::size_t>(1 + static_cast<int>((camera.height() - 1) / m_sidePx))) {}

    /// Range: inside the frame.
    Part& at(const Eigen::Vector2d& pixel) {
        const auto row = static_cast<std::size_t>(pixel.y() / m_sidePx);
        const auto column = static_cast<std::size_t>(pixel.x() / m_sidePx);
        return m_parts[row * static_cast<std::size_t>(m_columns) + column];
    }

    /// Of the parts' errors; nothing where too few are known. hasOutliers: whether a few things at edges are
    /// off by very much, which a mean would spread over a part.
    std::optional<double> median(bool hasOutliers) const {
        std::vector<double> errors;
        for (const Part& part : m_parts) {
            if (!part.errors.empty()) {
                errors.push_back(hasOutliers ? weightedMedian(part.errors) : weightedMean(part.errors));
            }
        }
        constexpr std::size_t kEnough = 4; // one part of so many
        return kEnough * errors.size() < m_parts.size() ? std::nullopt
                                                        : std::optional(spherewalk::median(errors));
    }

  private:
    static constexpr int kAcross = 20;

    double m_sidePx;
    int m_columns;
    std::vector<Part> m_parts;
};

std::optional<double> foretoldByThings(const SceneLikeness& leaveOneOut, const ViewLikeness& view,
                                       const CameraModel& camera) {
    const Eigen::Quaterniond cameraFromRoom = view.roomFromCamera.rotation.conjugate();
    Frame frame(camera);
    const auto forEach = [&](const auto& what) {
        for (const ViewLikeness& from : leaveOneOut.views) {
            const Eigen::Vector3d apart = from.at() - view.at();
            for (const SeenThing& thing : from.things) {
                const Eigen::Vector3d seen = apart + thing.at;
                const auto pixel = camera.project(cameraFromRoom * seen);
                if (pixel && isInFrame(*pixel, camera)) {
                    what(from, thing, seen, frame.at(*pixel));
                }
            }
        }
    };
    forEach([](const ViewLikeness& /*from*/, const SeenThing& /*thing*/, const Eigen::Vector3d& seen,
               Part& part) { part.nearestM = std::min(part.nearestM, seen.norm()); });
    forEach([&](const ViewLikeness& from, const SeenThing& thing, const Eigen::Vector3d& seen, Part& part) {
        constexpr double kHidden = 1.2;
        if (seen.norm() <= kHidden * part.nearestM) {
            const double w = nearness(from, view);
            part.errors.emplace_back(ownShare(leaveOneOut.scene) * thing.errorPx *
                                         parallax(view.offset, seen) / parallax(from.offset, thing.at),
                                     w);
        }
    });
    return frame.median(render::hasSurfaces(leaveOneOut.scene));
}

std::optional<double> foretoldByViews(const SceneLikeness& leaveOneOut, const ViewLikeness& view) {
    double sum = 0;
    double weights = 0;
    for (const ViewLikeness& from : leaveOneOut.views) {
        const std::optional<double> found =
            from.exactMedianPx ? ownShare(leaveOneOut.scene) * *from.exactMedianPx : from.medianPx;
        if (isFinite(found)) {
            const double w = weight(from, view);
            sum += w * *found / std::max(kLeastAcrossM, offsetAcross(from.offset, from.axis()));
            weights += w;
        }
    }
    return weights > 0 ? std::optional(sum / weights * offsetAcross(view.offset, view.axis())) : std::nullopt;
}

} // namespace

double offsetAcross(const Eigen::Vector3d& offset, const Eigen::Vector3d& axis) {
    const double along = offset.dot(axis);
    const double across = (offset - along * axis).norm();
    return std::hypot(across, kAlongShare * along);
}

std::optional<double> foretoldPx(const SceneLikeness& leaveOneOut, const ViewLikeness& view,
                                 const CameraModel& camera) {
    const std::optional<double> byThings = foretoldByThings(leaveOneOut, view, camera);
    return byThings ? byThings : foretoldByViews(leaveOneOut, view);
}

std::vector<Prediction> predictions(const MeasureReport& leaveOneOut, const MeasureReport& robot,
                                    const CameraModel& camera) {
    std::vector<Prediction> result;
    for (const SceneLikeness& found : robot.scenes) {
        const auto from = std::find_if(leaveOneOut.scenes.begin(), leaveOneOut.scenes.end(),
                                       [&](const SceneLikeness& s) { return s.scene == found.scene; });
        if (from == leaveOneOut.scenes.end()) {
            continue;
        }
        Prediction prediction;
        prediction.scene = found.scene;
        std::vector<double> factors;
        for (const ViewLikeness& view : found.views) {
            const std::optional<double> foretold = foretoldPx(*from, view, camera);
            const std::optional<double>& px = view.exactMedianPx ? view.exactMedianPx : view.medianPx;
            if (isFinite(foretold) && isFinite(px)) {
                prediction.foretoldPx.push_back(*foretold);
                prediction.foundPx.push_back(*px);
                if (*px > 0) {
                    factors.push_back(*foretold / *px);
                }
            }
        }
        if (!factors.empty()) {
            prediction.factor = median(factors);
        }
        prediction.rankCorrelation = spherewalk::rankCorrelation(prediction.foretoldPx, prediction.foundPx);
        result.push_back(std::move(prediction));
    }
    return result;
}

} // namespace spherewalk::jobs
