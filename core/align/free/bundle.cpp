// SPDX-License-Identifier: GPL-3.0-or-later
#include "free/placing.h"
#include "pairs/pair_geometry.h"
#include "solve/match_selection.h"
#include "solve/refinement.h"
#include "solve/unknowns.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/statistics.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

namespace spherewalk::align {

namespace {

constexpr int kMostPointsOfPhoto = 1200;
constexpr double kLeastPointParallax = 5;
constexpr double kFirstReachRad = 0.06; ///< Rays that miss by more at the first poses are of something else.
constexpr double kReachSigmas = 4;
constexpr double kLargestScale = 8;
constexpr double kFloorBand = 0.02; ///< About the floor, within which points lie on it, as such a share.

/// What one photo gives to one thing.
struct Sighting {
    int feature = 0;
    Ray ray;
};

/// The rays of a thing, without those of photos that would see two things in it.
std::vector<Ray> raysOf(std::vector<Sighting> sightings) {
    std::ranges::stable_sort(sightings, {},
                             [](const Sighting& one) { return std::pair(one.ray.photo, one.feature); });
    const auto isSame = [](const Sighting& one, const Sighting& other) {
        return one.ray.photo == other.ray.photo && one.feature == other.feature;
    };
    sightings.erase(std::unique(sightings.begin(), sightings.end(), isSame), sightings.end());
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < sightings.size();) {
        std::size_t next = i + 1;
        while (next < sightings.size() && sightings[next].ray.photo == sightings[i].ray.photo) {
            ++next;
        }
        if (next == i + 1) {
            rays.push_back(sightings[i].ray);
        }
        i = next;
    }
    return rays;
}

} // namespace

std::vector<SeenPoint> seenPoints(const Component& component, std::span<const int> placeOf,
                                  std::span<const PhotoPair> pairs, std::span<const PairEstimate> estimates) {
    std::vector<std::vector<bool>> isUsed;
    for (const PhotoPair& pair : pairs) {
        isUsed.emplace_back(pair.matches.size(), false);
    }
    for (const GraphEdge& edge : component.edges) {
        const auto at = static_cast<std::size_t>(edge.pair);
        isUsed[at] = estimates[at].isInlier;
    }
    const std::vector<std::vector<int>> trackOf = tracks(pairs, isUsed);
    std::map<int, std::vector<Sighting>> byTrack;
    for (const GraphEdge& edge : component.edges) {
        const auto at = static_cast<std::size_t>(edge.pair);
        const int a = placeOf[static_cast<std::size_t>(edge.a)];
        const int b = placeOf[static_cast<std::size_t>(edge.b)];
        for (std::size_t i = 0; a >= 0 && b >= 0 && i < trackOf[at].size(); ++i) {
            const auto match = isUsed[at][i] ? unitMatch(pairs[at].matches[i]) : std::nullopt;
            if (match) {
                auto& sightings = byTrack[trackOf[at][i]];
                sightings.push_back({pairs[at].matches[i].featureA, {a, match->inA, match->sigmaRad}});
                sightings.push_back({pairs[at].matches[i].featureB, {b, match->inB, match->sigmaRad}});
            }
        }
    }
    std::vector<SeenPoint> points;
    for (auto& [track, sightings] : byTrack) {
        SeenPoint point;
        point.rays = raysOf(std::move(sightings));
        if (point.rays.size() >= 2) {
            points.push_back(std::move(point));
        }
    }
    std::ranges::stable_sort(points, std::greater<>(),
                             [](const SeenPoint& point) { return point.rays.size(); });
    return points;
}

namespace {

/// The distance on the unit sphere between where a photo sees a point and where it should see it, in standard
/// deviations. Parameters: the photo's turn from its reference, its position, the point, and how far the
/// lenses stand ahead.
class RayBlock : public ceres::SizedCostFunction<3, 3, 3, 3, 1> {
  public:
    RayBlock(const Eigen::Quaterniond& reference, const Ray& ray, double sigmaRad)
        : m_reference(reference), m_bearing(ray.bearing), m_sigmaRad(sigmaRad) {}

    bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
        const Eigen::Vector3d moved = Eigen::Map<const Eigen::Vector3d>(parameters[0]);
        const Eigen::Matrix3d photoFromRoom = (turn(moved) * m_reference).conjugate().toRotationMatrix();
        const Eigen::Vector3d apart = Eigen::Map<const Eigen::Vector3d>(parameters[2]) -
                                      Eigen::Map<const Eigen::Vector3d>(parameters[1]);
        const double side = softSide(m_bearing);
        const Eigen::Vector3d inPhoto =
            photoFromRoom * apart - side * parameters[3][0] * Eigen::Vector3d::UnitX();
        const double distance = std::max(inPhoto.norm(), 1e-9);
        const Eigen::Vector3d unit = inPhoto / distance;
        Eigen::Map<Eigen::Vector3d> off(residuals);
        off = (unit - m_bearing) / m_sigmaRad;
        if (jacobians == nullptr) {
            return true;
        }
        using RowMajor = Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;
        const Eigen::Matrix3d byInPhoto =
            (Eigen::Matrix3d::Identity() - unit * unit.transpose()) / (distance * m_sigmaRad);
        const Eigen::Matrix3d byInRoom = byInPhoto * photoFromRoom;
        if (jacobians[0] != nullptr) {
            RowMajor rows(jacobians[0]);
            rows = byInRoom * skew(apart) * leftJacobian(moved);
        }
        if (jacobians[1] != nullptr) {
            RowMajor rows(jacobians[1]);
            rows = -byInRoom;
        }
        if (jacobians[2] != nullptr) {
            RowMajor rows(jacobians[2]);
            rows = byInRoom;
        }
        if (jacobians[3] != nullptr) {
            Eigen::Map<Eigen::Vector3d> column(jacobians[3]);
            column = -side * byInPhoto.col(0);
        }
        return true;
    }

  private:
    Eigen::Quaterniond m_reference;
    Eigen::Vector3d m_bearing;
    double m_sigmaRad;
};

Eigen::Vector3d inRoom(const Bundle& bundle, const Ray& ray) {
    return bundle.photos[static_cast<std::size_t>(ray.photo)].roomFromPhoto * ray.bearing;
}

/// How far the ray misses the point, as an angle; pi where the point lies behind.
double missRad(const Bundle& bundle, const Ray& ray, const Eigen::Vector3d& point) {
    const Eigen::Vector3d apart = point - bundle.lensOf(ray);
    const Eigen::Vector3d seen = inRoom(bundle, ray);
    return std::atan2(apart.cross(seen).norm(), apart.dot(seen));
}

/// Where the rays come nearest to each other: least squares of the distances.
std::optional<Eigen::Vector3d> meetingPoint(const Bundle& bundle, std::span<const Ray> rays, double scale) {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    double parallax = 0;
    for (const Ray& ray : rays) {
        const Eigen::Vector3d seen = inRoom(bundle, ray);
        const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - seen * seen.transpose();
        matrix += across;
        right += across * bundle.lensOf(ray);
        parallax = std::max(parallax, inRoom(bundle, rays.front()).cross(seen).norm() / ray.sigmaRad);
    }
    if (parallax < kLeastPointParallax * scale) {
        return std::nullopt;
    }
    const Eigen::Vector3d point = matrix.ldlt().solve(right);
    return point.allFinite() ? std::optional(point) : std::nullopt;
}

double reachRad(const Ray& ray, double scale, bool isFirst) {
    const double reach = kReachSigmas * scale * ray.sigmaRad;
    return isFirst ? std::max(kFirstReachRad, reach) : reach;
}

/// Puts the points to where most of their rays meet, and leaves out the rays that miss. Returns all points.
/// scale: of the rays' sigmas.
std::vector<SeenPoint> placed(const Bundle& bundle, std::span<const SeenPoint> all, double scale,
                              bool isFirst) {
    std::vector<SeenPoint> points(all.begin(), all.end());
    for (SeenPoint& point : points) {
        point.isPlaced = false;
        while (point.rays.size() >= 2) {
            const auto at = meetingPoint(bundle, point.rays, scale);
            if (!at) {
                break;
            }
            point.at = *at;
            const auto worst = std::ranges::max_element(point.rays, {}, [&](const Ray& ray) {
                return missRad(bundle, ray, point.at) / reachRad(ray, scale, isFirst);
            });
            if (missRad(bundle, *worst, point.at) < reachRad(*worst, scale, isFirst)) {
                point.isPlaced = true;
                break;
            }
            point.rays.erase(worst);
        }
    }
    return points;
}

double rayScale(const Bundle& bundle) {
    std::vector<double> residuals;
    for (const SeenPoint& point : bundle.points) {
        for (const Ray& ray : point.rays) {
            // Of an angle in two dimensions the root mean square along either axis.
            residuals.push_back(missRad(bundle, ray, point.at) / ray.sigmaRad);
        }
    }
    // Of such a length the median is 1.18 standard deviations along either axis. Each point takes a part.
    return residuals.empty() ? 1 : std::clamp(median(std::move(residuals)) / 1.18, 0.5, kLargestScale);
}

/// How far a point on the floor lies above the floor's height, as a share of the first photo's height above
/// it, in standard deviations. As a share, since else the whole would shrink. Parameters: the point, and the
/// floor's height.
class FloorBlock : public ceres::SizedCostFunction<1, 3, 1> {
  public:
    FloorBlock(double photo, double sigma) : m_photo(photo), m_sigma(sigma) {}

    bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
        const double floor = parameters[1][0];
        const double over = (parameters[0][2] - floor) / (m_photo - floor);
        const double slope = 1 / (m_sigma * (m_photo - floor));
        residuals[0] = over / m_sigma;
        if (jacobians != nullptr && jacobians[0] != nullptr) {
            Eigen::Map<Eigen::RowVector3d> row(jacobians[0]);
            row = Eigen::RowVector3d(0, 0, slope);
        }
        if (jacobians != nullptr && jacobians[1] != nullptr) {
            jacobians[1][0] = (over - 1) * slope;
        }
        return std::isfinite(over);
    }

  private:
    double m_photo;
    double m_sigma;
};

/// The floor below the photos where they know what is level.
std::optional<FloorPlane> levelFloor(const Bundle& bundle, std::span<const PhotoPrior> priors) {
    const auto level = static_cast<std::size_t>(std::ranges::count_if(priors, saysUp));
    if (2 * level < priors.size()) {
        return std::nullopt;
    }
    std::vector<Eigen::Vector3d> points;
    for (const SeenPoint& point : bundle.points) {
        points.push_back(point.at);
    }
    return floorBelow(bundle.positions(), points, Eigen::Vector3d::UnitZ(), Degrees(3));
}

/// One run of least squares on the present points and rays.
class Adjustment {
  public:
    Adjustment(Bundle& bundle, std::span<const PhotoPrior> priors, double width, bool solvesLenses)
        : m_bundle(bundle),
          m_turns(bundle.photos.size(), {0, 0, 0}),
          m_ahead(bundle.photos.front().lenses.aheadM),
          m_trust(std::min(1.0, bundle.scale)) {
        m_problem.AddParameterBlock(&m_ahead, 1);
        if (!solvesLenses) {
            m_problem.SetParameterBlockConstant(&m_ahead);
        }
        for (std::size_t i = 0; i < bundle.photos.size(); ++i) {
            const Vertical up = knownUp(priors[i]);
            m_problem.AddParameterBlock(m_turns[i].data(), 3);
            m_problem.AddParameterBlock(bundle.photos[i].positionM.data(), 3);
            m_problem.AddResidualBlock(
                new UprightBlock(bundle.photos[i].roomFromPhoto, up.upInPhoto, m_trust * up.sigmaRad),
                new ceres::HuberLoss(2), m_turns[i].data());
        }
        m_problem.SetParameterBlockConstant(bundle.photos.front().positionM.data());
        for (SeenPoint& point : bundle.points) {
            for (const Ray& ray : point.rays) {
                const auto i = static_cast<std::size_t>(ray.photo);
                m_problem.AddResidualBlock(
                    new RayBlock(bundle.photos[i].roomFromPhoto, ray, bundle.scale * ray.sigmaRad),
                    new ceres::CauchyLoss(width), m_turns[i].data(), bundle.photos[i].positionM.data(),
                    point.at.data(), &m_ahead);
            }
        }
    }

    /// Holds points that lie on one floor at one height. What lies within a height of the lens from each
    /// other counts once, since a floor that is uneven is so for all of it.
    void keepLevel(const FloorPlane& floor) {
        m_floor = floor.at;
        const auto patchOf = [&floor](const SeenPoint& point) {
            const double width = 2 * floor.lensHeight;
            return std::pair(std::floor(point.at.x() / width), std::floor(point.at.y() / width));
        };
        std::map<std::pair<double, double>, std::vector<SeenPoint*>> patches;
        for (SeenPoint& point : m_bundle.points) {
            if (std::abs(point.at.z() - floor.at) < kFloorBand * floor.lensHeight) {
                patches[patchOf(point)].push_back(&point);
            }
        }
        for (const auto& [patch, points] : patches) {
            const double sigma = m_trust * kUnevenFloor * std::sqrt(static_cast<double>(points.size()));
            for (SeenPoint* const point : points) {
                m_problem.AddResidualBlock(new FloorBlock(m_bundle.photos.front().positionM.z(), sigma),
                                           nullptr, point->at.data(), &m_floor);
            }
        }
    }

    void solve(int iterations, ProgressSink& progress, const std::stop_token& stop) {
        ceres::Solver::Options options;
        constexpr std::size_t kMostDense = 80;
        options.linear_solver_type = m_turns.size() > kMostDense ? ceres::SPARSE_SCHUR : ceres::DENSE_SCHUR;
        options.max_num_iterations = iterations;
        options.function_tolerance = 1e-7;
        options.num_threads = 1; // The sums, and so the result, would depend on their number.
        options.logging_type = ceres::SILENT;
        SolverWatch watch(progress, stop, iterations, "Adjusting photos and points");
        options.callbacks.push_back(&watch);
        ceres::Solver::Summary summary;
        ceres::Solve(options, &m_problem, &summary);
        throwIfStopped(stop);
        if (!summary.IsSolutionUsable()) {
            throw Error(ErrorKind::Internal,
                        "The places of the photos could not be solved: what they share contradicts itself. "
                        "Leave out the photos taken last, and try again.",
                        summary.message);
        }
        for (std::size_t i = 0; i < m_turns.size(); ++i) {
            Eigen::Quaterniond& rotation = m_bundle.photos[i].roomFromPhoto;
            rotation = (turn(Eigen::Map<const Eigen::Vector3d>(m_turns[i].data())) * rotation).normalized();
            m_bundle.photos[i].lenses.aheadM = m_ahead;
        }
    }

  private:
    Bundle& m_bundle;
    std::vector<std::array<double, 3>> m_turns;
    double m_ahead;     ///< In the unit of the positions.
    double m_floor = 0; ///< Height, in that unit.
    /// What residuals keep below the features' stated errors is what those have in common: it does not make
    /// them truer than the floor and what is level.
    double m_trust;
    ceres::Problem m_problem;
};

/// So many points that each photo has enough.
std::vector<SeenPoint> enoughPoints(std::vector<SeenPoint> points, std::size_t photos) {
    std::vector<int> count(photos, 0);
    std::erase_if(points, [&](const SeenPoint& point) {
        const bool isWanted = std::ranges::any_of(point.rays, [&](const Ray& ray) {
            return count[static_cast<std::size_t>(ray.photo)] < kMostPointsOfPhoto;
        });
        for (const Ray& ray : point.rays) {
            count[static_cast<std::size_t>(ray.photo)] += isWanted ? 1 : 0;
        }
        return !isWanted;
    });
    return points;
}

/// Photos of a camera that joins its pictures as if both lenses stood in one place give 0.
void keepClearLenses(Bundle& bundle) {
    constexpr double kClearSigmas = 5;
    if (!(std::abs(bundle.photos.front().lenses.aheadM) > kClearSigmas * lensSigma(bundle))) {
        for (PhotoState& photo : bundle.photos) {
            photo.lenses.aheadM = 0;
        }
    }
}

} // namespace

void adjust(Bundle& bundle, std::span<const PhotoPrior> priors, ProgressSink& progress,
            const std::stop_token& stop) {
    const std::vector<SeenPoint> all = enoughPoints(std::move(bundle.points), bundle.photos.size());
    constexpr std::array kWidths{20.0, 5.0, 2.0, 2.0};
    constexpr std::array kIterations{20, 15, 15, 25};
    for (std::size_t round = 0; round < kWidths.size(); ++round) {
        ProgressStep step(progress, static_cast<double>(round) / kWidths.size(),
                          static_cast<double>(round + 1) / kWidths.size());
        throwIfStopped(stop);
        bundle.points = placed(bundle, all, bundle.scale, round == 0);
        std::erase_if(bundle.points, [](const SeenPoint& point) { return !point.isPlaced; });
        bundle.scale = round == 0 ? 1 : rayScale(bundle);
        const bool solvesLenses = round == 1 || (round > 1 && bundle.photos.front().lenses.aheadM != 0);
        Adjustment adjustment(bundle, priors, kWidths[round], solvesLenses);
        if (const auto floor = round > 1 ? levelFloor(bundle, priors) : std::nullopt) {
            adjustment.keepLevel(*floor);
        }
        adjustment.solve(kIterations[round], step, stop);
        bundle.scale = rayScale(bundle);
        if (solvesLenses) {
            keepClearLenses(bundle);
        }
    }
    std::erase_if(bundle.points, [&](SeenPoint& point) {
        std::erase_if(point.rays, [&](const Ray& ray) {
            return missRad(bundle, ray, point.at) > reachRad(ray, bundle.scale, false);
        });
        return point.rays.size() < 2;
    });
}

std::vector<Eigen::Vector3d> meetingPoints(const Bundle& bundle, std::span<const SeenPoint> things,
                                           double scale) {
    std::vector<Eigen::Vector3d> points;
    for (const SeenPoint& point : placed(bundle, things, scale, false)) {
        if (point.isPlaced) {
            points.push_back(point.at);
        }
    }
    return points;
}

void move(Bundle& bundle, const Eigen::Quaterniond& turned, double scale, const Eigen::Vector3d& shift) {
    for (PhotoState& photo : bundle.photos) {
        photo.roomFromPhoto = (turned * photo.roomFromPhoto).normalized();
        photo.positionM = scale * (turned * photo.positionM) + shift;
        photo.lenses.aheadM *= scale;
    }
    for (SeenPoint& point : bundle.points) {
        point.at = scale * (turned * point.at) + shift;
    }
    for (Eigen::Vector3d& point : bundle.seen) {
        point = scale * (turned * point) + shift;
    }
}

} // namespace spherewalk::align
