// SPDX-License-Identifier: GPL-3.0-or-later
#include "plane_filters.h"
#include "small_surfaces.h"
#include "sweep_cost.h"
#include "vector_math.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/geometry/equirect.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace spherewalk::scene {

namespace {

constexpr float kOnWall = 0.05F; ///< Share of 1 / distance by which what is on a wall may differ from it.
constexpr double kShareOnWalls = 0.4; ///< Of what is sure towards walls, so much must be on them.
constexpr double kKeptShare = 0.5;
constexpr int kTextureRadius = 3;
constexpr float kNearestM = 0.05F;
constexpr float kBetter = 0.5F; ///< By how much another distance must fit better to be taken.
constexpr float kTexture = 6; ///< Grey levels; with less the pictures tell no distance. A standard deviation.

/// Marks a point in a plane of 1 / distance. A point covers two by two pixels, so that a surface has no
/// holes. The nearest point wins.
void splat(const Eigen::Vector3f& point, Plane& plane) {
    const FastPixel at = fastPixel(point.x(), point.y(), point.z(), static_cast<float>(plane.width()));
    const float value = 1 / std::max(kNearestM, point.norm());
    const int column = std::min(static_cast<int>(at.u), plane.width() - 1);
    const int line = std::min(static_cast<int>(at.v), plane.height() - 1);
    for (int i = 0; i < 4; ++i) {
        float& out = *plane.at((column + i % 2) % plane.width(), std::min(line + i / 2, plane.height() - 1));
        out = std::max(out, value);
    }
}

/// What a neighbour is sure of, as the photo sees it: 1 / distance, and 0 where it shows nothing.
Plane seenFromPhoto(const KnownPhoto& photo, const KnownPhoto& neighbour) {
    const PhotoDepth& depth = *neighbour.depth;
    Plane result(depth.inverseM.width(), depth.inverseM.height());
    const PixelAngles angles(result.width());
    SeenByOther seen(photo.photo.roomFromPhoto.inverse() * neighbour.photo.roomFromPhoto,
                     neighbour.photo.lenses, photo.photo.lenses, angles);
    for (int y = 0; y < result.height(); ++y) {
        seen.enter(y);
        for (int x = 0; x < result.width(); ++x) {
            if (*depth.sure.at(x, y) != 0) {
                splat(seen.at(x, *depth.inverseM.at(x, y)), result);
            }
        }
    }
    return result;
}

/// Whether most of what the photo surely shows towards walls lies on them. Furniture stands before walls, but
/// an outline that somebody guessed has nothing on it.
bool fits(const render::RoomShape& room, const KnownPhoto& photo, const Plane& about) {
    constexpr int kEvery = 4;
    const EquirectSize size{about.width(), about.height()};
    const Rigid3& pose = photo.photo.roomFromPhoto;
    double all = 0;
    double near = 0;
    for (int y = kEvery / 2; y < size.height; y += kEvery) {
        for (int x = kEvery / 2; x < size.width; x += kEvery) {
            const Eigen::Vector3d way = direction(size, Eigen::Vector2d(x, y));
            const double up = (pose.rotation * way).z();
            const double heightM = (up < 0 ? room.floorM : room.ceilingM) - pose.translation.z();
            const float wall = *about.at(x, y);
            if (*photo.depth->sure.at(x, y) != 0 && static_cast<double>(wall) > 1.01 * up / heightM) {
                all += way.head<2>().norm();
                near += std::fabs(*photo.depth->inverseM.at(x, y) - wall) < kOnWall * wall
                            ? way.head<2>().norm()
                            : 0;
            }
        }
    }
    return all > 0 && near >= kShareOnWalls * all;
}

class Refinement {
  public:
    Refinement(const KnownPhoto& photo, std::span<const KnownPhoto> neighbours, int threads,
               const std::stop_token& stop)
        : m_threads(threads),
          m_stop(stop),
          m_depth(*photo.depth),
          m_cost(costFor(photo, neighbours, threads), threads),
          m_best(std::move(m_cost.all({&m_depth.inverseM, 1}, stop).front())),
          m_texture(textureOf(m_cost.photo(), threads)) {}

    PhotoDepth run(const KnownPhoto& photo, std::span<const KnownPhoto> neighbours,
                   const render::RoomShape* room) {
        std::vector<Plane> known(neighbours.size());
        parallelFor(static_cast<int>(neighbours.size()), 1, m_threads, [&](int begin, int end) {
            for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
                throwIfStopped(m_stop);
                known[i] = seenFromPhoto(photo, neighbours[i]);
            }
        });
        takeOver(known);
        for (const int reach : {1, 2}) {
            const Plane candidates[] = {leastOfCross(m_depth.inverseM, reach, m_threads),
                                        mostOfCross(m_depth.inverseM, reach, m_threads)};
            takeBetter(candidates, [](std::size_t) {});
        }
        dropSpecks(*photo.depth);
        m_depth.inverseM = continuedFromSure(m_depth, photo.photo.atLeast(m_depth.sure.width()),
                                             surroundings(photo, room, m_threads), m_threads);
        m_depth.inverseM = smoothedSurfaces(m_depth.inverseM, m_threads);
        m_depth.inverseM = evenedBorders(std::move(m_depth.inverseM), m_depth.sure, m_threads);
        return std::move(m_depth);
    }

  private:
    static SweepCost costFor(const KnownPhoto& photo, std::span<const KnownPhoto> neighbours, int threads) {
        std::vector<PosedPicture> pictures;
        std::vector<const Plane*> depths;
        for (const KnownPhoto& neighbour : neighbours) {
            pictures.push_back(neighbour.photo);
            depths.push_back(&neighbour.depth->inverseM);
        }
        const std::vector<Gains> gains = gainsTo(photo.photo, photo.depth->inverseM, pictures);
        return {photo.photo, pictures, kKeptShare, photo.depth->inverseM.width(), threads, gains, depths};
    }

    /// What the photo would show of an empty room. If it does not stand in it, or contradicts it, the depth
    /// that neighbours agreed on, smoothed: where that jumps and nothing is sure, as about a lamp's
    /// reflection on a ceiling, the surface would be torn.
    static Plane surroundings(const KnownPhoto& photo, const render::RoomShape* room, int threads) {
        const Rigid3& pose = photo.photo.roomFromPhoto;
        const Eigen::Vector3d& at = pose.translation;
        const int width = photo.depth->inverseM.width();
        const auto agreed = [&] {
            constexpr int kReach = 8;
            Plane smooth = photo.depth->inverseM;
            blur(smooth, kReach * width / kUsualWidth, threads);
            return smooth;
        };
        if (room == nullptr || !contains(room->outline, at.head<2>()) || at.z() <= room->floorM ||
            at.z() >= room->ceilingM) {
            return agreed();
        }
        Plane about = render::roomDepth(*room, pose, width, photo.photo.lenses).inverseM();
        return fits(*room, photo, about) ? about : agreed();
    }

    /// The variance of brightness about each pixel, in squared grey levels.
    static Plane textureOf(const SweepPicture& photo, int threads) {
        Plane mean(photo.width(), photo.height());
        Plane squares = mean;
        for (int y = 0; y < photo.height(); ++y) {
            for (int x = 0; x < photo.width(); ++x) {
                const float value = photo.brightness(x, y);
                *mean.at(x, y) = value;
                *squares.at(x, y) = value * value;
            }
        }
        blur(mean, kTextureRadius, threads);
        blur(squares, kTextureRadius, threads);
        for (std::size_t i = 0; i < squares.values().size(); ++i) {
            squares.values()[i] -= mean.values()[i] * mean.values()[i];
        }
        return squares;
    }

    /// Takes candidates' distances where they fit better and the picture is not bare. Calls taken(i) for each
    /// such pixel.
    template <class Taken>
    void takeBetter(std::span<const Plane> candidates, const Taken& taken) {
        const std::vector<Plane> costs = m_cost.all(candidates, m_stop);
        for (std::size_t k = 0; k < candidates.size(); ++k) {
            for (std::size_t i = 0; i < m_best.values().size(); ++i) {
                if (m_texture.values()[i] > kTexture * kTexture &&
                    costs[k].values()[i] < m_best.values()[i] - kBetter) {
                    m_best.values()[i] = costs[k].values()[i];
                    m_depth.inverseM.values()[i] = candidates[k].values()[i];
                    taken(i);
                }
            }
        }
    }

    /// A surface that came about and is too small to stand by itself is what it was before.
    void dropSpecks(const PhotoDepth& before) {
        forEachSpeck(Plane(m_depth.inverseM), [&](const std::vector<std::size_t>& pixels) {
            for (const std::size_t i : pixels) {
                m_depth.inverseM.values()[i] = before.inverseM.values()[i];
                m_depth.sure.values()[i] = before.sure.values()[i];
            }
        });
    }

    /// Tries what the neighbours know; 0 where one knows nothing.
    void takeOver(std::vector<Plane>& known) {
        for (Plane& candidate : known) {
            for (std::size_t i = 0; i < candidate.values().size(); ++i) {
                float& value = candidate.values()[i];
                value = value > 0 ? value : m_depth.inverseM.values()[i];
            }
        }
        takeBetter(known, [&](std::size_t i) { m_depth.sure.values()[i] = 255; });
    }

    int m_threads;
    const std::stop_token& m_stop;
    PhotoDepth m_depth;
    SmoothCost m_cost;
    Plane m_best;    ///< The costs of m_depth.
    Plane m_texture; ///< See textureOf().
};

} // namespace

PhotoDepth refinedDepth(const KnownPhoto& photo, std::span<const KnownPhoto> neighbours,
                        const render::RoomShape* room, int threads, const std::stop_token& stop) {
    const int width = photo.depth->inverseM.width();
    if (std::any_of(neighbours.begin(), neighbours.end(),
                    [&](const KnownPhoto& other) { return other.depth->inverseM.width() != width; })) {
        throw Error(ErrorKind::InvalidInput,
                    "Could not refine a depth: the neighbours' depths have another size.");
    }
    return neighbours.empty() ? *photo.depth
                              : Refinement(photo, neighbours, threads, stop).run(photo, neighbours, room);
}

} // namespace spherewalk::scene
