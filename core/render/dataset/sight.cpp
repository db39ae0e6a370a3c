// SPDX-License-Identifier: Apache-2.0
#include "dataset/evidence.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/recently_used.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/render/dataset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace spherewalk::render {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// Outlines and obstacles are drawn by hand.
constexpr double kRoughM = 0.10;
/// A surface hides a place that lies farther behind it: a thin wall and a camera close to it are 15 cm, and
/// depths are off by a few percent.
constexpr double kBehindM = 0.08;
constexpr double kBehindShare = 0.04;
/// A place is clearly in front of what a photo sees by this much more.
constexpr double kClearM = 0.15;
/// A camera must be so far beyond the border between two photos before the other one is taken.
constexpr double kHoldM = 0.02;
/// A photo is not taken anew at the very edge of what it sees.
constexpr double kFirmM = 0.03;
/// So many photos are asked for their depths at most.
constexpr int kMostLooks = 96;

double cross(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// Whether the segment crosses an edge of the polygon.
bool crosses(const Polygon& polygon, const Vector2d& from, const Vector2d& to) {
    const Vector2d way = to - from;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector2d a = polygon[i] - from;
        const Vector2d b = polygon[(i + 1) % polygon.size()] - from;
        const bool isBetween = (cross(way, a) > 0) != (cross(way, b) > 0);
        if (isBetween && (cross(b - a, -a) > 0) != (cross(b - a, way - a) > 0)) {
            return true;
        }
    }
    return false;
}

/// A point just outside of a rough outline is taken to stand at its edge; nothing for one farther outside.
std::optional<Vector2d> movedInside(const Polygon& outline, const Vector2d& point) {
    if (contains(outline, point)) {
        return point;
    }
    std::optional<Vector2d> nearest;
    double least = 1.5 * kRoughM;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vector2d along = outline[(i + 1) % outline.size()] - outline[i];
        const double share =
            std::clamp((point - outline[i]).dot(along) / along.squaredNorm(), 0.0, 1.0); // NaN: no edge
        const Vector2d foot = outline[i] + share * along;
        if ((foot - point).norm() < least) {
            least = (foot - point).norm();
            nearest = foot + (least > 0 ? Vector2d((foot - point) * (1e-3 / least)) : Vector2d::Zero());
        }
    }
    return nearest;
}

/// What a depth says about a place.
enum class Look { Clear, Unknown, Hidden };

/// The farthest that a photo surely sees in each small patch of its directions.
class SightMap {
  public:
    SightMap() = default;

    explicit SightMap(const DepthSteps& depth) {
        const int side = std::max(1, depth.width() / kWidth);
        m_size = {depth.width() / side, depth.height() / side};
        m_inverseM.reserve(static_cast<std::size_t>(m_size.width) * static_cast<std::size_t>(m_size.height));
        for (int y = 0; y < m_size.height; ++y) {
            addRow(depth, y * side, side);
        }
    }

    /// pInPhoto: the place in the photo's frame.
    Look look(const Vector3d& pInPhoto) const {
        const double distance = pInPhoto.norm();
        if (m_inverseM.empty() || !(distance > 0)) {
            return Look::Unknown;
        }
        const Vector2d at = pixel(m_size, pInPhoto);
        const int x = static_cast<int>(std::lround(at.x())) + m_size.width;
        const int y = static_cast<int>(std::lround(at.y()));
        int sure = 0;
        int hiding = 0;
        int clear = 0;
        for (int row = std::max(0, y - 1); row <= std::min(m_size.height - 1, y + 1); ++row) {
            for (int column = x - 1; column <= x + 1; ++column) {
                const double inverse = m_inverseM[index(column % m_size.width, row)];
                sure += inverse > 0 ? 1 : 0;
                hiding += inverse * (distance - kBehindM - kBehindShare * distance) > 1 ? 1 : 0;
                clear += inverse > 0 && inverse * (distance + kClearM + kBehindShare * distance) < 1 ? 1 : 0;
            }
        }
        constexpr int kEnough = 5; // of nine
        return sure < kEnough   ? Look::Unknown
               : hiding == sure ? Look::Hidden
               : clear == sure  ? Look::Clear
                                : Look::Unknown;
    }

  private:
    static constexpr int kWidth = 256;

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size.width) +
               static_cast<std::size_t>(x);
    }

    /// Adds a row of patches. The value is 0 where less than half of a patch is sure.
    void addRow(const DepthSteps& depth, int top, int side) {
        const auto width = static_cast<std::size_t>(m_size.width) * static_cast<std::size_t>(side);
        std::vector<std::uint16_t> least(width, std::numeric_limits<std::uint16_t>::max());
        std::vector<std::uint16_t> sure(width);
        for (int y = top; y < top + side; ++y) {
            const std::uint16_t* values = depth.row(y);
            for (std::size_t x = 0; x < width; ++x) {
                const auto isSure = static_cast<std::uint16_t>(values[x] & 1U);
                const auto unsure = static_cast<std::uint16_t>(isSure - 1U); // all bits, or none
                least[x] = std::min(least[x], static_cast<std::uint16_t>(values[x] | unsure));
                sure[x] = static_cast<std::uint16_t>(sure[x] + isSure);
            }
        }
        for (auto left = least.begin(); left != least.end(); left += side) {
            const auto first = sure.begin() + (left - least.begin());
            const bool isEnough = 2 * std::accumulate(first, first + side, 0) >= side * side;
            m_inverseM.push_back(isEnough ? DepthSteps::inverseM(*std::min_element(left, left + side)) : 0);
        }
    }

    EquirectSize m_size;
    std::vector<float> m_inverseM;
};

/// What is kept of a photo's depth.
struct DepthKept {
    SightMap sight;
    std::shared_ptr<const DepthEvidence> evidence;
};

} // namespace

/// What is kept to tell what photos see. Threads: any.
class SightMaps {
  public:
    SightMaps(std::filesystem::path folder, const DatasetInfo& info) : m_folder(std::move(folder)) {
        for (const Polygon& obstacle : info.obstacles) {
            const bool isSolid =
                obstacle.size() > 2 &&
                std::none_of(info.photos.begin(), info.photos.end(), [&](const DatasetPhoto& photo) {
                    return contains(obstacle, photo.roomFromPhoto.translation.head<2>());
                });
            if (isSolid) {
                m_solids.push_back({obstacle, bounds(obstacle)});
            }
        }
        if (info.outline.size() > 2) {
            m_outline = info.outline;
        }
    }

    /// Whether the plan leaves a way for light. Both points are on the floor.
    bool isOpen(const Vector2d& photo, const Vector2d& place) const {
        const std::optional<Vector2d> moved = movedInside(m_outline, photo);
        const bool hasOutline = !m_outline.empty() && moved; // else the outline is wrong about the photo
        const Vector2d from = moved.value_or(photo);
        const Vector2d to = hasOutline ? movedInside(m_outline, place).value_or(place) : place;
        const auto isFree = [&](const Vector2d& a, const Vector2d& b) {
            return !(hasOutline && crosses(m_outline, a, b)) && !isHidden(a, b);
        };
        if (isFree(from, to)) {
            return true;
        }
        const Vector2d way = to - from;
        const Vector2d across = Vector2d(-way.y(), way.x()) * (kRoughM / std::max(way.norm(), kRoughM));
        for (const double share : {0.5, 0.25, 0.75}) {
            for (const double side : {1.0, -1.0}) {
                const Vector2d knee = from + share * way + side * across;
                if (isFree(from, knee) && isFree(knee, to)) {
                    return true;
                }
            }
        }
        return false;
    }

    bool isInObstacle(const Vector2d& place) const {
        return std::any_of(m_solids.begin(), m_solids.end(), [&](const Solid& solid) {
            return contains(solid.outline, place) && distanceToEdge(solid.outline, place) > kRoughM / 4;
        });
    }

    bool isInOutline(const Vector2d& place) const { return m_outline.empty() || contains(m_outline, place); }

    Look look(std::size_t photo, const DatasetPhoto& of, const Vector3d& place) {
        if (of.depth.empty()) {
            return Look::Unknown;
        }
        return kept(photo, of)->sight.look(of.roomFromPhoto.rotation.conjugate() *
                                           (place - of.roomFromPhoto.translation));
    }

    std::shared_ptr<const DepthEvidence> evidence(std::size_t photo, const DatasetPhoto& of) {
        return of.depth.empty() ? nullptr : kept(photo, of)->evidence;
    }

    /// The depth's file, which several parts of a first view read.
    std::shared_ptr<const DepthSteps> depth(std::size_t photo, const DatasetPhoto& of) {
        return m_depths.get(photo, [&] { return DepthSteps::read(m_folder / of.depth); });
    }

  private:
    static constexpr std::size_t kKept = 96;      ///< Each has 640 KB.
    static constexpr std::size_t kDepthsKept = 4; ///< Each has 1 MB.

    struct Solid {
        Polygon outline;
        Bounds2 bounds;
    };

    /// A depth that cannot be read tells nothing. A view that draws with it reports the error.
    std::shared_ptr<const DepthKept> kept(std::size_t photo, const DatasetPhoto& of) {
        return m_maps.get(photo, [&]() -> DepthKept {
            try {
                const std::shared_ptr<const DepthSteps> steps = depth(photo, of);
                return {SightMap(*steps), std::make_shared<const DepthEvidence>(*steps)};
            } catch (const Error&) {
                return {};
            }
        });
    }

    /// Whether an obstacle lies between. One in which the place itself lies does not tell.
    bool isHidden(const Vector2d& from, const Vector2d& to) const {
        const Vector2d least = from.cwiseMin(to);
        const Vector2d greatest = from.cwiseMax(to);
        return std::any_of(m_solids.begin(), m_solids.end(), [&](const Solid& solid) {
            const bool isNear = (solid.bounds.least.array() <= greatest.array()).all() &&
                                (solid.bounds.greatest.array() >= least.array()).all();
            return isNear && crosses(solid.outline, from, to) && !contains(solid.outline, to);
        });
    }

    std::filesystem::path m_folder;
    Polygon m_outline; ///< It is empty if it is not known.
    std::vector<Solid> m_solids;
    RecentlyUsed<std::size_t, DepthKept> m_maps{kKept};
    RecentlyUsed<std::size_t, DepthSteps> m_depths{kDepthsKept};
};

Dataset::Dataset(std::filesystem::path folder, DatasetInfo info)
    : m_folder(std::move(folder)),
      m_info(std::move(info)),
      m_sight(std::make_shared<SightMaps>(m_folder, m_info)) {
}

bool Dataset::sees(std::size_t photo, const Vector3d& pInRoom) const {
    const DatasetPhoto& of = m_info.photos.at(photo);
    const Look look = m_sight->look(photo, of, pInRoom);
    return look == Look::Clear ||
           (look != Look::Hidden &&
            m_sight->isOpen(of.roomFromPhoto.translation.head<2>(), pInRoom.head<2>()));
}

bool Dataset::seesFirmly(std::size_t photo, const Vector3d& pInRoom) const {
    constexpr std::array<std::pair<double, double>, 5> kSteps{{{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
    return std::all_of(kSteps.begin(), kSteps.end(), [&](const std::pair<double, double>& step) {
        return sees(photo, pInRoom + kFirmM * Vector3d(step.first, step.second, 0));
    });
}

std::shared_ptr<const DepthEvidence> Dataset::evidence(std::size_t photo) const {
    return m_sight->evidence(photo, m_info.photos.at(photo));
}

std::shared_ptr<const DepthSteps> Dataset::depth(std::size_t photo) const {
    return m_sight->depth(photo, m_info.photos.at(photo));
}

bool Dataset::isOutside(const Vector3d& pInRoom) const {
    constexpr double kAtPhotoM = 0.1;
    const auto isInRoom = [&](const Vector3d& place) {
        return (m_info.ceilingM <= 0 || (place.z() >= 0 && place.z() <= m_info.ceilingM)) &&
               m_sight->isInOutline(place.head<2>());
    };
    const bool isWithin = isInRoom(pInRoom);
    if (isWithin && !m_sight->isInObstacle(pInRoom.head<2>())) {
        return false;
    }
    const std::vector<std::size_t> near = photosNear(pInRoom, {.most = 4}).photos;
    return std::none_of(near.begin(), near.end(), [&](std::size_t photo) {
        const Vector3d& at = m_info.photos[photo].roomFromPhoto.translation;
        return (isWithin || !isInRoom(at)) &&
               ((at - pInRoom).norm() < kAtPhotoM ||
                m_sight->look(photo, m_info.photos[photo], pInRoom) == Look::Clear);
    });
}

std::size_t Dataset::nearestPhoto(const Vector3d& pInRoom, std::optional<std::size_t> without) const {
    return photosNear(pInRoom, {.without = without}).photos.front();
}

namespace {

struct Near {
    double distance2 = 0;
    std::size_t photo = 0;

    bool operator>(const Near& other) const {
        return distance2 != other.distance2 ? distance2 > other.distance2 : photo > other.photo;
    }
};

} // namespace

NearPhotos Dataset::photosNear(const Vector3d& pInRoom, const PhotoQuery& query) const {
    const auto at = [&](std::size_t photo) -> const Vector3d& {
        return m_info.photos[photo].roomFromPhoto.translation;
    };
    const auto isUsable = [&](std::size_t photo) { return !query.isUsable || query.isUsable(photo); };
    std::vector<Near> all;
    for (std::size_t i = 0; i < m_info.photos.size(); ++i) {
        if (i != query.without && isUsable(i)) {
            all.push_back({(at(i) - pInRoom).squaredNorm(), i});
        }
    }
    if (all.empty() && query.without && isUsable(*query.without)) {
        all.push_back({0, *query.without}); // it is the only one
    }
    /// The nearest photos for which a condition holds, the nearest first.
    const auto nearest = [&](auto&& holds) {
        std::vector<Near> heap = all;
        std::make_heap(heap.begin(), heap.end(), std::greater<>());
        std::vector<std::size_t> found;
        for (int looks = 0; !heap.empty() && found.size() < query.most && looks < kMostLooks; ++looks) {
            if (holds(heap.front().photo)) {
                found.push_back(heap.front().photo);
            }
            std::pop_heap(heap.begin(), heap.end(), std::greater<>());
            heap.pop_back();
        }
        return found;
    };
    NearPhotos result;
    for (const std::size_t held : query.held) {
        if (held < m_info.photos.size() && held != query.without && isUsable(held) && sees(held, pInRoom)) {
            result.photos.push_back(held);
        }
    }
    const std::size_t kept = result.photos.size();
    const auto isKept = [&](std::size_t photo) {
        return std::find(result.photos.begin(), result.photos.begin() + static_cast<std::ptrdiff_t>(kept),
                         photo) != result.photos.begin() + static_cast<std::ptrdiff_t>(kept);
    };
    for (const std::size_t photo : nearest([&](std::size_t photo) {
             return kept == 0 ? sees(photo, pInRoom) : !isKept(photo) && seesFirmly(photo, pInRoom);
         })) {
        result.photos.push_back(photo);
    }
    if (result.photos.empty()) {
        return {nearest([](std::size_t) { return true; }), false};
    }
    // A later photo passes an earlier one when the camera is well beyond the border between the two.
    const auto passes = [&](std::size_t later, std::size_t earlier) {
        const double gain = (at(earlier) - pInRoom).squaredNorm() - (at(later) - pInRoom).squaredNorm();
        return gain > 2 * kHoldM * (at(earlier) - at(later)).norm();
    };
    for (std::size_t i = 1; kept > 0 && i < result.photos.size(); ++i) {
        for (std::size_t j = i; j > 0 && passes(result.photos[j], result.photos[j - 1]); --j) {
            std::swap(result.photos[j], result.photos[j - 1]);
        }
    }
    result.photos.resize(std::min(result.photos.size(), query.most));
    return result;
}

} // namespace spherewalk::render
