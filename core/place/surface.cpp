// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/place/surface.h"

#include "spherewalk/base/parallel.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace spherewalk::place {

namespace {

constexpr std::uint32_t kUnused = UINT32_MAX;
constexpr int kWeighedAGrain = 4096;

/// What photos say about a vertex.
struct Evidence {
    int photos = 0;
    float agreeing = 0;
    float contradicting = 0;
};

/// How far what a photo shows may lie from a vertex that it shows.
float toleranceM(const SeenDepth& photo, const Sight& sight, double withinM) {
    return std::max(static_cast<float>(withinM), 2 * photo.sigmaM(sight.rangeM));
}

void addEvidence(const SurfaceVertex& vertex, const SeenDepth& photo, double withinM, Evidence& evidence) {
    const Sight sight = photo.sight(vertex.pInRoom);
    if (!sight.isSure || sight.isOutside()) {
        return;
    }
    const float sigma = photo.sigmaM(sight.rangeM);
    const float weight = 1 / (sigma * sigma);
    if (sight.rangeM - sight.pointM > toleranceM(photo, sight, withinM)) {
        evidence.contradicting += weight;
    } else if (vertex.isShownBy(photo, sight, withinM)) {
        evidence.agreeing += weight;
        ++evidence.photos;
    }
}

/// Which vertices hang together.
class Parts {
  public:
    explicit Parts(const Surface& surface) : m_parents(surface.vertices.size()) {
        std::iota(m_parents.begin(), m_parents.end(), 0U);
        for (const auto& triangle : surface.triangles) {
            join(triangle[0], triangle[1]);
            join(triangle[0], triangle[2]);
        }
    }

    std::uint32_t partOf(std::uint32_t vertex) {
        while (m_parents[vertex] != vertex) {
            m_parents[vertex] = m_parents[m_parents[vertex]];
            vertex = m_parents[vertex];
        }
        return vertex;
    }

  private:
    void join(std::uint32_t a, std::uint32_t b) {
        const std::uint32_t first = partOf(a);
        const std::uint32_t second = partOf(b);
        m_parents[std::max(first, second)] = std::min(first, second);
    }

    std::vector<std::uint32_t> m_parents;
};

} // namespace

bool SurfaceVertex::isShownBy(const SeenDepth& photo, const Sight& sight, double withinM) const {
    constexpr double kLeastFacing = 0.15; // the sine of 9 degrees
    constexpr double kMostSigmas = 3;     // such rough depths are not fused either
    if (!sight.isSure || sight.isOutside() || photo.sigmaM(sight.rangeM) > kMostSigmas * withinM ||
        std::abs(sight.rangeM - sight.pointM) > toleranceM(photo, sight, withinM)) {
        return false;
    }
    const Eigen::Vector3d ray = photo.roomFromPhoto().translation - pInRoom;
    return normal.cast<double>().dot(ray) > kLeastFacing * ray.norm();
}

Eigen::Vector3d Surface::middle(const Triangle& triangle) const {
    return (vertices[triangle[0]].pInRoom + vertices[triangle[1]].pInRoom + vertices[triangle[2]].pInRoom) /
           3;
}

Eigen::Vector3d Surface::areaVector(const Triangle& triangle) const {
    const Eigen::Vector3d& a = vertices[triangle[0]].pInRoom;
    return (vertices[triangle[1]].pInRoom - a).cross(vertices[triangle[2]].pInRoom - a) / 2;
}

double Surface::areaM2() const {
    double area = 0;
    for (const auto& triangle : triangles) {
        area += areaVector(triangle).norm();
    }
    return area;
}

bool Surface::isFarAway() const {
    constexpr double kFloatsAreExactM = 1000;
    return std::any_of(vertices.begin(), vertices.end(), [](const SurfaceVertex& vertex) {
        return vertex.pInRoom.cwiseAbs().maxCoeff() > kFloatsAreExactM;
    });
}

void Surface::estimateNormals() {
    std::vector<Eigen::Vector3d> sums(vertices.size(), Eigen::Vector3d::Zero());
    for (const auto& triangle : triangles) {
        const Eigen::Vector3d area = areaVector(triangle);
        for (const std::uint32_t vertex : triangle) {
            sums[vertex] += area;
        }
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const bool isKnown = sums[i].squaredNorm() > 0;
        vertices[i].normal = isKnown ? Eigen::Vector3f(sums[i].normalized().cast<float>())
                                     : Eigen::Vector3f(Eigen::Vector3f::UnitZ());
    }
}

void Surface::weigh(std::span<const SeenDepth> photos, double withinM, int threads,
                    const std::stop_token& stop) {
    parallelFor(static_cast<int>(vertices.size()), kWeighedAGrain, threads, [&](int begin, int end) {
        throwIfStopped(stop);
        for (int i = begin; i < end; ++i) {
            SurfaceVertex& vertex = vertices[static_cast<std::size_t>(i)];
            Evidence evidence;
            for (const SeenDepth& photo : photos) {
                addEvidence(vertex, photo, withinM, evidence);
            }
            vertex.photos = static_cast<std::uint8_t>(std::min(evidence.photos, 255));
            const float all = evidence.agreeing + evidence.contradicting;
            vertex.confidence = all > 0 ? evidence.agreeing / all : 0;
        }
    });
}

void Surface::keepTriangles(const std::function<bool(std::size_t)>& keeps) {
    std::vector<Triangle> kept;
    std::vector<std::uint32_t> numbers(vertices.size(), kUnused);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (keeps(i)) {
            kept.push_back(triangles[i]);
            for (const std::uint32_t vertex : triangles[i]) {
                numbers[vertex] = 0;
            }
        }
    }
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (numbers[i] != kUnused) {
            vertices[count] = vertices[i];
            numbers[i] = count++;
        }
    }
    vertices.resize(count);
    for (auto& triangle : kept) {
        for (std::uint32_t& vertex : triangle) {
            vertex = numbers[vertex];
        }
    }
    triangles = std::move(kept);
}

void Surface::dropSmallParts(double leastAreaM2) {
    Parts parts(*this);
    std::vector<double> areas(vertices.size(), 0.0);
    for (const auto& triangle : triangles) {
        areas[parts.partOf(triangle[0])] += areaVector(triangle).norm();
    }
    keepTriangles([&](std::size_t i) { return areas[parts.partOf(triangles[i][0])] >= leastAreaM2; });
}

} // namespace spherewalk::place
