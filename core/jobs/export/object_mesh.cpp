// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/error.h"
#include "spherewalk/jobs/object_overlay.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace spherewalk::jobs {

namespace {

constexpr std::uint32_t kLeafTriangles = 4;

/// Where a ray enters and leaves a box; it misses the box where it would leave before it enters.
std::pair<float, float> crossing(const Eigen::Vector3f& least, const Eigen::Vector3f& greatest,
                                 const Eigen::Vector3f& origin, const Eigen::Vector3f& inverse) {
    const Eigen::Array3f a = (least - origin).array() * inverse.array();
    const Eigen::Array3f b = (greatest - origin).array() * inverse.array();
    return {a.min(b).maxCoeff(), a.max(b).minCoeff()};
}

/// A direction whose components have a reciprocal.
Eigen::Vector3f nowhereZero(const Eigen::Vector3f& direction) {
    constexpr float kLeast = 1e-20F;
    return direction.unaryExpr([](float x) { return std::abs(x) < kLeast ? std::copysign(kLeast, x) : x; });
}

} // namespace

ObjectMesh::ObjectMesh(std::vector<Eigen::Vector3f> vertices, std::vector<Triangle> triangles)
    : m_vertices(std::move(vertices)), m_triangles(std::move(triangles)) {
    const auto isThere = [this](std::uint32_t index) { return index < m_vertices.size(); };
    if (m_triangles.empty() ||
        !std::all_of(m_triangles.begin(), m_triangles.end(), [&](const Triangle& triangle) {
            return std::all_of(triangle.begin(), triangle.end(), isThere);
        })) {
        throw Error(ErrorKind::InvalidInput,
                    "A mesh has one triangle or more, between vertices that it has.");
    }
    fit();
    std::vector<Eigen::Vector3f> centres;
    centres.reserve(m_triangles.size());
    for (const Triangle& triangle : m_triangles) {
        centres.emplace_back((m_vertices[triangle[0]] + m_vertices[triangle[1]] + m_vertices[triangle[2]]) /
                             3);
    }
    m_nodes.reserve(m_triangles.size());
    build(0, static_cast<std::uint32_t>(m_triangles.size()), centres);
}

/// Brings the vertices of the triangles to the size of 1, above the origin. Other vertices count for nothing.
void ObjectMesh::fit() {
    Eigen::Vector3d least = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d greatest = -least;
    for (const Triangle& triangle : m_triangles) {
        for (const std::uint32_t index : triangle) {
            if (!m_vertices[index].allFinite()) {
                throw Error(ErrorKind::InvalidInput, "A vertex of a mesh has three finite coordinates.");
            }
            least = least.cwiseMin(m_vertices[index].cast<double>());
            greatest = greatest.cwiseMax(m_vertices[index].cast<double>());
        }
    }
    m_longestSide = (greatest - least).maxCoeff();
    if (!(m_longestSide > 0) || !std::isfinite(1 / m_longestSide)) {
        throw Error(ErrorKind::InvalidInput, "A mesh has an extent: not all of its points are the same.");
    }
    const Eigen::Vector3d foot(0.5 * (least.x() + greatest.x()), 0.5 * (least.y() + greatest.y()), least.z());
    for (Eigen::Vector3f& vertex : m_vertices) {
        vertex = ((vertex.cast<double>() - foot) / m_longestSide).cast<float>();
    }
    m_least = ((least - foot) / m_longestSide).cast<float>();
    m_greatest = ((greatest - foot) / m_longestSide).cast<float>();
}

/// Sorts triangles into a tree of boxes, whose depth is the logarithm of their number.
void ObjectMesh::build(std::uint32_t begin, std::uint32_t end, std::vector<Eigen::Vector3f>& centres) {
    const std::size_t own = m_nodes.size();
    Node node{m_vertices[m_triangles[begin][0]], m_vertices[m_triangles[begin][0]], begin, end - begin};
    for (std::uint32_t i = begin; i < end; ++i) {
        for (const std::uint32_t index : m_triangles[i]) {
            node.least = node.least.cwiseMin(m_vertices[index]);
            node.greatest = node.greatest.cwiseMax(m_vertices[index]);
        }
    }
    m_nodes.push_back(node);
    if (node.count <= kLeafTriangles) {
        return;
    }
    int axis = 0;
    (node.greatest - node.least).maxCoeff(&axis);
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::vector<std::uint32_t> order(end - begin);
    std::iota(order.begin(), order.end(), begin);
    std::nth_element(order.begin(), order.begin() + (middle - begin), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return centres[a][axis] < centres[b][axis]; });
    std::vector<Triangle> triangles;
    std::vector<Eigen::Vector3f> moved;
    for (const std::uint32_t i : order) {
        triangles.push_back(m_triangles[i]);
        moved.push_back(centres[i]);
    }
    std::copy(triangles.begin(), triangles.end(), m_triangles.begin() + begin);
    std::copy(moved.begin(), moved.end(), centres.begin() + begin);
    build(begin, middle, centres);
    m_nodes[own].begin = static_cast<std::uint32_t>(m_nodes.size());
    m_nodes[own].count = 0;
    build(middle, end, centres);
}

ObjectMesh ObjectMesh::cube() {
    std::vector<Eigen::Vector3f> corners;
    for (int i = 0; i < 8; ++i) {
        corners.emplace_back((i & 1) != 0 ? 1.F : 0.F, (i & 2) != 0 ? 1.F : 0.F, (i & 4) != 0 ? 1.F : 0.F);
    }
    std::vector<Triangle> triangles;
    constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces = {
        {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}};
    for (const auto& face : kFaces) {
        triangles.push_back({face[0], face[1], face[2]});
        triangles.push_back({face[0], face[2], face[3]});
    }
    return {std::move(corners), std::move(triangles)};
}

bool ObjectMesh::contains(const Eigen::Vector3d& point) const {
    return (point.array() >= m_least.cast<double>().array()).all() &&
           (point.array() <= m_greatest.cast<double>().array()).all();
}

bool ObjectMesh::meets(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, Hit& hit) const {
    // From a place beside the object on, single precision is enough, wherever the ray begins.
    const double lengthSquared = direction.squaredNorm();
    const Eigen::Vector3d middle = 0.5 * (m_least + m_greatest).cast<double>();
    const double skipped =
        std::max(0.0, (middle - origin).dot(direction) / lengthSquared - 2 / std::sqrt(lengthSquared));
    const Eigen::Vector3f from = (origin + skipped * direction).cast<float>();
    const Eigen::Vector3f along = nowhereZero(direction.cast<float>());
    const Eigen::Vector3f inverse = along.cwiseInverse();
    constexpr float kRim = 1e-6F; ///< Closes the cracks between triangles.
    float nearest = std::numeric_limits<float>::infinity();
    std::array<std::uint32_t, 64> waiting{};
    std::size_t count = 0;
    std::uint32_t next = 0;
    for (;;) {
        const Node& node = m_nodes[next];
        const auto [enters, leaves] = crossing(node.least, node.greatest, from, inverse);
        const bool isMet = leaves >= std::max(enters, 0.F) && enters < nearest;
        for (std::uint32_t i = node.begin; isMet && i < node.begin + node.count; ++i) {
            const Eigen::Vector3f& a = m_vertices[m_triangles[i][0]];
            const Eigen::Vector3f side = m_vertices[m_triangles[i][1]] - a;
            const Eigen::Vector3f other = m_vertices[m_triangles[i][2]] - a;
            const Eigen::Vector3f across = along.cross(other);
            const float volume = side.dot(across);
            const Eigen::Vector3f to = from - a;
            const Eigen::Vector3f turned = to.cross(side);
            const float u = to.dot(across) / volume;
            const float v = along.dot(turned) / volume;
            const float distance = other.dot(turned) / volume;
            // A triangle without area, or seen from its edge, gives no finite numbers.
            if (u >= -kRim && v >= -kRim && u + v <= 1 + kRim && distance > 0 && distance < nearest) {
                nearest = distance;
                hit.normal = side.cross(other).normalized();
            }
        }
        if (isMet && node.count == 0) {
            waiting[count++] = node.begin;
            ++next;
        } else if (count == 0) {
            break;
        } else {
            next = waiting[--count];
        }
    }
    if (!std::isfinite(nearest)) {
        return false;
    }
    hit.along = skipped + static_cast<double>(nearest);
    if (hit.normal.dot(along) > 0) {
        hit.normal = -hit.normal;
    }
    return true;
}

} // namespace spherewalk::jobs
