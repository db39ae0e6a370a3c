// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/scene/depth_sweep.h"

#include "plane_filters.h"
#include "sweep_cost.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/geometry/rigid3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>

namespace spherewalk::scene {

namespace {

constexpr float kBytesPerCost = 2.5F;
constexpr int kPixelsAtATime = 64; ///< What a neighbour shows there at all distances stays in a fast cache.
constexpr float kLeastInverseM = 1e-3F; ///< Nothing is taken to be farther than a kilometre.
constexpr int kRoughWidth = 128;        ///< At which it is found how bright photos are.
constexpr int kRounds = 6;         ///< Of that; a wrong gain makes distances wrong that make it look right.
constexpr float kLeastRise = 0.5F; ///< Of the cost from the best distance to the mean about it.
constexpr float kLeastRiseShare = 0.15F; ///< The same as a share of the best cost.
constexpr int kOffsets = 4;              ///< Number of steps tried to either side when a distance is refined.

/// The place of the least of the parabola through three costs, in steps from the middle one.
float leastBetween(float before, float here, float after) {
    const float bend = before + after - 2 * here;
    return bend > 0 ? 0.5F * (before - after) / bend : 0;
}

/// The inverse distances that are tried, from endless to near. With each step, what lies across the way to a
/// neighbour moves in the neighbour's picture, by the same angle in the one where it moves most.
class TriedDistances {
  public:
    TriedDistances(std::vector<double> baselinesM, const SweepOptions& options)
        : m_baselinesM(std::move(baselinesM)) {
        const double beside = *std::min_element(m_baselinesM.begin(), m_baselinesM.end());
        const double most =
            1 / std::clamp(beside, options.nearestM, std::max(options.nearestM, kUsualNearestM));
        m_stepRad = options.stepPx * 2 * std::numbers::pi / options.coarseWidth;
        for (place(most); count() > options.distances; place(most)) {
            m_stepRad *= 1.01 * count() / options.distances;
        }
    }

    int count() const { return static_cast<int>(m_inverse.size()); }

    /// 1 / distance at a place, which may lie between two tried ones. Range: from 0 to count() - 1.
    float inverse(float place) const {
        const auto before = std::min(static_cast<std::size_t>(place), m_inverse.size() - 2);
        const float share = place - static_cast<float>(before);
        return m_inverse[before] + share * (m_inverse[before + 1] - m_inverse[before]);
    }

    /// The change of 1 / distance from one tried distance to the next, at a 1 / distance.
    float stepAt(float inverse) const { return static_cast<float>(m_stepRad) / anglePer(inverse); }

  private:
    static constexpr float kLeastBaselineM = 1e-3F;
    static constexpr double kUsualNearestM =
        0.45; ///< Neighbours farther away than that do not see nearer things.
    static constexpr std::size_t kFewest = 3;

    /// By how much a thing moves in the picture where it moves most, in radians for a change of 1 / distance.
    float anglePer(float inverse) const {
        float most = 0;
        for (const double baseline : m_baselinesM) {
            const float baselineM = std::max(kLeastBaselineM, static_cast<float>(baseline));
            const float across = inverse * baselineM;
            most = std::max(most, baselineM / (1 + across * across));
        }
        return most;
    }

    void place(double most) {
        m_inverse.assign(1, kLeastInverseM);
        while (m_inverse.back() < static_cast<float>(most) || m_inverse.size() < kFewest) {
            m_inverse.push_back(m_inverse.back() + stepAt(m_inverse.back()));
        }
    }

    std::vector<double> m_baselinesM;
    double m_stepRad = 0;
    std::vector<float> m_inverse;
};

std::vector<double> baselines(const PosedPicture& photo, std::span<const PosedPicture> neighbours) {
    std::vector<double> result;
    for (const PosedPicture& other : neighbours) {
        result.push_back((other.roomFromPhoto.translation - photo.roomFromPhoto.translation).norm());
    }
    return result;
}

/// One photo's sweep.
class Sweep {
  public:
    Sweep(const PosedPicture& photo, std::span<const PosedPicture> neighbours, const SweepOptions& options,
          std::stop_token stop)
        : m_photo(photo),
          m_neighbours(neighbours),
          m_options(options),
          m_stop(std::move(stop)),
          m_distances(baselines(photo, neighbours), options),
          m_evident(options.width, options.width / 2) {
        std::fill(m_evident.values().begin(), m_evident.values().end(), std::uint8_t{255});
    }

    PhotoDepth run() {
        compareBrightness();
        Plane inverse = coarse();
        float step = 1;
        for (int width = 2 * m_options.coarseWidth; width <= m_options.width; width *= 2) {
            step *= 0.5F;
            inverse = finer(inverse, width, step);
        }
        return {.inverseM = std::move(inverse), .sure = std::move(m_evident)};
    }

  private:
    /// Finds gains and rough distances in turn.
    void compareBrightness() {
        SweepOptions options = m_options;
        options.coarseWidth = kRoughWidth;
        Sweep rough(m_photo, m_neighbours, options, m_stop);
        rough.m_gains = gainsTo(m_photo, m_neighbours);
        for (int round = 0; round < kRounds && rough.m_gains != m_gains; ++round) {
            m_gains = rough.m_gains;
            rough.m_gains = gainsTo(m_photo, rough.coarse(), m_neighbours);
        }
        m_gains = rough.m_gains;
    }

    SweepCost costsAt(int width) const {
        throwIfStopped(m_stop);
        return {m_photo, m_neighbours, m_options.keptShare, width, m_options.threads, m_gains};
    }

    /// Range: costs have a row of pixels for each distance.
    static void enter(const std::vector<float>& costs, int distances, std::uint8_t* volume) {
        for (std::size_t x = 0; x < kPixelsAtATime; ++x) {
            for (auto d = 0UL; d < static_cast<std::size_t>(distances); ++d) {
                *volume++ = static_cast<std::uint8_t>(kBytesPerCost * costs[d * kPixelsAtATime + x]);
            }
        }
    }

    CostVolume<std::uint8_t> volume(const SweepCost& cost) const {
        CostVolume<std::uint8_t> volume(cost.width(), cost.height(), m_distances.count());
        parallelFor(cost.height(), 2, m_options.threads, [&](int begin, int end) {
            throwIfStopped(m_stop);
            const int values = volume.distances * kPixelsAtATime;
            SweepCost::Scratch scratch(cost, values);
            std::vector<float> costs(static_cast<std::size_t>(values));
            std::vector<float> inverse(costs.size());
            for (int value = 0; value < values; ++value) {
                const int layer = value / kPixelsAtATime;
                inverse[static_cast<std::size_t>(value)] = m_distances.inverse(static_cast<float>(layer));
            }
            for (int y = begin; y < end; ++y) {
                for (int x = 0; x < cost.width(); x += kPixelsAtATime) {
                    cost.at({y, x, x + kPixelsAtATime}, volume.distances, inverse.data(),
                            SweepCost::Order::BySteps, scratch, costs.data());
                    enter(costs, volume.distances, volume.at(x, y));
                }
            }
        });
        return volume;
    }

    Plane coarse() const {
        const SweepCost cost = costsAt(m_options.coarseWidth);
        const CostVolume<std::int16_t> sums =
            aggregatedOverPaths(volume(cost), cost.photo(), {}, m_options.threads, m_stop);
        Plane inverse(sums.width, sums.height);
        for (int y = 0; y < sums.height; ++y) {
            for (int x = 0; x < sums.width; ++x) {
                const std::int16_t* at = sums.at(x, y);
                const auto best = std::min_element(at, at + sums.distances) - at;
                auto place = static_cast<float>(best);
                if (best > 0 && best + 1 < sums.distances) {
                    place += leastBetween(at[best - 1], at[best], at[best + 1]);
                }
                *inverse.at(x, y) = m_distances.inverse(place);
            }
        }
        return median3x3(inverse, m_options.threads);
    }

    /// Chooses at each pixel between the coarse pixel's own distance and the nearest and farthest around it,
    /// whichever fits best. Here edges get their place at the finer size.
    Plane chosen(const Plane& coarse, const SmoothCost& cost) const {
        std::array<Plane, 3> candidates;
        candidates.fill(Plane(cost.width(), cost.height()));
        for (int y = 0; y < cost.height(); ++y) {
            for (int x = 0; x < cost.width(); ++x) {
                const auto [least, most] = rangeAbout(coarse, x / 2, y / 2);
                *candidates[0].at(x, y) = *coarse.at(x / 2, y / 2);
                *candidates[1].at(x, y) = least;
                *candidates[2].at(x, y) = most;
            }
        }
        std::vector<Plane> costs = cost.all(candidates, m_stop);
        Plane& best = costs[0];
        Plane result = candidates[0];
        for (std::size_t k = 1; k < candidates.size(); ++k) {
            for (std::size_t i = 0; i < best.values().size(); ++i) {
                if (costs[k].values()[i] < best.values()[i] - 1e-4F) {
                    best.values()[i] = costs[k].values()[i];
                    result.values()[i] = candidates[k].values()[i];
                }
            }
        }
        return result;
    }

    static std::pair<float, float> rangeAbout(const Plane& plane, int x, int y) {
        float least = *plane.at(x, y);
        float most = least;
        for (int j = std::max(0, y - 1); j <= std::min(plane.height() - 1, y + 1); ++j) {
            for (int i = x - 1; i <= x + 1; ++i) {
                const float value = *plane.at((i + plane.width()) % plane.width(), j);
                least = std::min(least, value);
                most = std::max(most, value);
            }
        }
        return {least, most};
    }

    /// step: from one distance to the next, in steps of the coarse width.
    Plane finer(const Plane& coarse, int width, float step) {
        const SmoothCost cost(costsAt(width), m_options.threads);
        const Plane base = chosen(coarse, cost);
        // The least cost so far, its offset, and the costs of the offsets before and after.
        Plane best(width, width / 2);
        std::fill(best.values().begin(), best.values().end(), HUGE_VALF);
        Plane offset(width, width / 2);
        Plane before = best;
        Plane after = best;
        Plane last = best;
        Plane sum(width, width / 2);
        int k = -kOffsets;
        for (const Plane& costs : cost.all(movedBy(base, step), m_stop)) {
            for (std::size_t i = 0; i < costs.values().size(); ++i) {
                const float here = costs.values()[i];
                sum.values()[i] += here;
                if (offset.values()[i] == static_cast<float>(k - 1)) {
                    after.values()[i] = here;
                }
                if (here < best.values()[i]) {
                    best.values()[i] = here;
                    offset.values()[i] = static_cast<float>(k);
                    before.values()[i] = last.values()[i];
                    after.values()[i] = HUGE_VALF;
                }
            }
            last = costs;
            ++k;
        }
        if (width == m_options.width) {
            judge(best, offset, sum);
        }
        Plane inverse(width, width / 2);
        for (std::size_t i = 0; i < inverse.values().size(); ++i) {
            const float a = before.values()[i];
            const float b = after.values()[i];
            const float between =
                std::isfinite(a) && std::isfinite(b) ? leastBetween(a, best.values()[i], b) : 0;
            inverse.values()[i] = moved(base.values()[i], (offset.values()[i] + between) * step);
        }
        return median3x3(inverse, m_options.threads);
    }

    /// The distances that are tried about these.
    std::vector<Plane> movedBy(const Plane& base, float step) const {
        std::vector<Plane> tried(2 * kOffsets + 1, Plane(base.width(), base.height()));
        parallelFor(base.height(), 32, m_options.threads, [&](int begin, int end) {
            const auto width = static_cast<std::size_t>(base.width());
            for (std::size_t i = static_cast<std::size_t>(begin) * width;
                 i < static_cast<std::size_t>(end) * width; ++i) {
                const float value = base.values()[i];
                const float stepHere = m_distances.stepAt(value);
                for (std::size_t k = 0; k < tried.size(); ++k) {
                    const float steps = static_cast<float>(static_cast<int>(k) - kOffsets) * step;
                    tried[k].values()[i] = std::max(kLeastInverseM, value + steps * stepHere);
                }
            }
        });
        return tried;
    }

    /// 1 / distance, so many steps nearer.
    float moved(float inverse, float steps) const {
        return std::max(kLeastInverseM, inverse + steps * m_distances.stepAt(inverse));
    }

    /// A distance is evident where those beside it fit much less well. On a bare wall all fit alike, and
    /// what remains is noise.
    void judge(const Plane& best, const Plane& offset, const Plane& sum) {
        for (std::size_t i = 0; i < best.values().size(); ++i) {
            const float least = best.values()[i];
            const float rise = sum.values()[i] / (2 * kOffsets + 1) - least;
            const bool isWithin = std::fabs(offset.values()[i]) < kOffsets;
            m_evident.values()[i] =
                isWithin && rise > std::max(kLeastRise, kLeastRiseShare * least) ? 255 : 0;
        }
    }

    const PosedPicture& m_photo;
    std::span<const PosedPicture> m_neighbours;
    std::vector<Gains> m_gains;
    SweepOptions m_options;
    std::stop_token m_stop;
    TriedDistances m_distances;
    MaskImage m_evident;
};

void checkPicture(const PosedPicture& photo) {
    if (photo.picture == nullptr || photo.picture->width() < 16 ||
        photo.picture->width() != 2 * photo.picture->height()) {
        throw Error(ErrorKind::InvalidInput,
                    "Could not estimate depth: a picture is empty or not twice as wide as high.");
    }
    if (!isPose(photo.roomFromPhoto)) {
        throw Error(ErrorKind::InvalidInput,
                    "Could not estimate depth: a photo's pose is not a position and a unit quaternion; align "
                    "the survey first.");
    }
}

bool isPowerOfTwo(int value) {
    return value > 0 && (value & (value - 1)) == 0;
}

} // namespace

void SweepOptions::validate() const {
    const bool sizes = coarseWidth >= 64 && coarseWidth % 64 == 0 && width >= coarseWidth && width <= 8192 &&
                       width % coarseWidth == 0 && isPowerOfTwo(width / coarseWidth);
    const bool range = nearestM > 0 && std::isfinite(nearestM) && stepPx > 0 && std::isfinite(stepPx);
    if (!sizes || !range || distances < 3 || distances > 1024 || neighbours < 1 || neighbours > 64 ||
        !(leastBaselineM >= 0) || !(keptShare > 0) || keptShare > 1) {
        throw Error(ErrorKind::InvalidInput,
                    "Could not estimate depth: the width must be a power of two times the coarse width (a "
                    "multiple of 64), 3 to 1024 distances may be tried by steps above 0, with 1 to 64 "
                    "neighbours, of which a share above 0 and up to 1 counts.");
    }
}

std::vector<std::size_t> sweepNeighbours(std::span<const Rigid3> roomFromPhotos, std::size_t photo,
                                         const SweepOptions& options, const Polygon& walls) {
    constexpr std::ptrdiff_t kFewest = 3; ///< Photos, of which some may stand behind walls.
    const auto place = [&](std::size_t i) -> const Eigen::Vector3d& { return roomFromPhotos[i].translation; };
    const auto distance = [&](std::size_t other) { return (place(other) - place(photo)).norm(); };
    const auto isInSight = [&](std::size_t other) {
        return walls.empty() || distanceToEdge(walls, place(photo).head<2>(), place(other).head<2>()) > 0;
    };
    std::vector<std::size_t> order(roomFromPhotos.size());
    std::iota(order.begin(), order.end(), 0);
    std::erase_if(order, [&](std::size_t other) {
        return other == photo || !(distance(other) > options.leastBaselineM);
    });
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
    const auto behind = std::stable_partition(order.begin(), order.end(), isInSight);
    order.erase(std::max(behind, order.begin() + std::min(std::ssize(order), kFewest)), order.end());
    order.resize(std::min(order.size(), static_cast<std::size_t>(options.neighbours)));
    return order;
}

std::vector<std::size_t> ranksByPlace(std::span<const Rigid3> roomFromPhotos) {
    constexpr double kStrip = 4; // of the usual distance from a photo to the nearest one
    std::vector<double> nearestM{1e-3};
    for (std::size_t i = 0; i < roomFromPhotos.size(); ++i) {
        for (const std::size_t other : sweepNeighbours(roomFromPhotos, i, {.neighbours = 1})) {
            nearestM.push_back((roomFromPhotos[other].translation - roomFromPhotos[i].translation).norm());
        }
    }
    const double stripM = kStrip * median(nearestM);
    std::vector<std::size_t> order(roomFromPhotos.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const auto place = [&](std::size_t i) {
            const Eigen::Vector3d& at = roomFromPhotos[i].translation;
            return std::tuple(std::floor(at.x() / stripM), at.y(), i);
        };
        return place(a) < place(b);
    });
    std::vector<std::size_t> ranks(order.size());
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
        ranks[order[rank]] = rank;
    }
    return ranks;
}

PhotoDepth sweptDepth(const PosedPicture& photo, std::span<const PosedPicture> neighbours,
                      const SweepOptions& options, const std::stop_token& stop) {
    options.validate();
    if (neighbours.empty()) {
        throw Error(ErrorKind::InvalidInput,
                    "Could not estimate depth: no other photo is far enough, and one alone tells no depth.");
    }
    checkPicture(photo);
    for (const PosedPicture& neighbour : neighbours) {
        checkPicture(neighbour);
    }
    return Sweep(photo, neighbours, options, stop).run();
}

} // namespace spherewalk::scene
